"""Sweeps: one attractor per value of a parameter, cold or following the attractor up or down."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from gearlash.jobs import Chain, Execution, Inline, Outcome, run
from gearlash.orbits import Settings
from gearlash.results import Axis, Direction, Point, Sweep, not_computed
from gearlash.system import given

from .arguments import checked_execution, checked_settings, checked_start, checked_values
from .model import Model, Source
from .named import plain_axis
from .row import Segment, Trail, work

SHOWN = 5_000  # points of which, done by one process, each is a task, so that progress shows it
CHUNK = 8  # points a task: some ten milliseconds of work for a fraction of one of talk


def sweep(
    model: Model,
    axis: Axis,
    *,
    values: Mapping[str, float | str] | None = None,
    direction: Direction | str = Direction.COLD,
    start: ArrayLike | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> Sweep:
    """One attractor per value of ``axis``; ``values`` are other parameters, by short name, over those of the
    case.

    ``cold``: every point from the family's cold start, or from ``start`` (n,). ``up``, ``down``: the first
    point so, every other from the attractor of the point before it, which is followed. Any ``execution``
    gives the same bytes. A point that fails is flagged with its reason.
    A cancel or Ctrl-C returns what was computed, marked incomplete. Raises `GearlashError` for names, values
    and starts that do not fit.
    """
    return sweeps(
        model,
        axis,
        (direction,),
        values=values,
        start=start,
        settings=settings,
        execution=execution,
    )[0]


def sweeps(
    model: Model,
    axis: Axis,
    directions: Sequence[Direction | str] = tuple(Direction),
    *,
    values: Mapping[str, float | str] | None = None,
    start: ArrayLike | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> tuple[Sweep, ...]:
    """Sweeps in several directions at once, in that order; see `sweep`. What one start does not find another
    may: where they differ, attractors coexist (`coexisting`).
    """
    source = Source.of(model)
    family = source.family()
    axis = plain_axis(model, family, axis)
    fixed, begin = checked_values(model, family, values, [axis]), checked_start(family, start)
    execution = checked_execution(source, execution)
    ways = _directions(directions)
    size = _chunk(execution, len(axis))
    form = Segment(source, tuple(fixed.items()), axis.name, checked_settings(settings), False, ())
    chains = [chain for way in ways for chain in _chains(way, axis, size, form, begin)]
    outcome = run(work, chains, execution)
    blanks: dict[float, Point] = {}
    return tuple(_gathered(way, axis, fixed, outcome, blanks) for way in ways)


def _directions(directions: Sequence[Direction | str]) -> list[Direction]:
    found = directions
    if not isinstance(found, str):
        found = given.items("directions", found, f"directions, out of {', '.join(Direction)}")
    ways = [given.choice(Direction, "direction", d) for d in ([found] if isinstance(found, str) else found)]
    given.unique("directions", tuple(map(str, ways)))
    return ways


def _chunk(execution: Execution, points: int) -> int:
    if execution.chunk is None:
        alone = execution.executor is None or isinstance(execution.executor, Inline)
        return 1 if alone and points <= SHOWN else CHUNK
    return execution.chunk


def _chains(way: Direction, axis: Axis, size: int, form: Segment, begin: np.ndarray | None) -> list[Chain]:
    """Cold: a chain for every chunk. Followed: one, whose tasks hand the attractor on."""
    values = axis.values[::-1] if way is Direction.DOWN else axis.values
    parts = [tuple(map(float, values[i : i + size])) for i in range(0, len(values), size)]
    tasks = [replace(form, follow=way is not Direction.COLD, values=part) for part in parts]
    sizes = [len(part) for part in parts]
    first = Trail(begin, None)
    if way is not Direction.COLD:
        return [Chain(way, tuple(tasks), tuple(sizes), first)]
    return [
        Chain((way, i), (task,), (n,), first) for i, (task, n) in enumerate(zip(tasks, sizes, strict=True))
    ]


def _gathered(
    way: Direction, axis: Axis, fixed: dict[str, float], outcome: Outcome, blanks: dict[float, Point]
) -> Sweep:
    """The points of one direction in the order of the axis, blanks where there are none: the same for all
    directions."""
    found: dict[float, Point] = {}
    for name, points in outcome.results.items():
        if name == way or (isinstance(name, tuple) and name[0] == way):
            found |= {point.value: point for point in points}
    reason = outcome.reason or "stopped"
    complete = len(found) == len(axis)
    values = axis.values.tolist()
    new = (value for value in values if value not in found and value not in blanks)
    blanks |= {point.value: point for point in not_computed(new, reason)}
    points = tuple(found[value] if value in found else blanks[value] for value in values)
    return Sweep(axis, way, points, complete, "" if complete else reason, fixed)
