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
from .row import Neighbour, Segment, work

POINT_TASKS = 5_000  # points up to which each is a task of its own in one process, to show progress
POINTS_OF_A_TASK = 8  # some ten milliseconds of work, for less than one of communication


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
    """One attractor for each value of a parameter.

    Parameters
    ----------
    model : Case or Family
    axis : Axis
        The parameter and its values. A case takes every name and unit of its file:
        ``Axis.even("pinion_speed", "1000 rpm", "6000 rpm", 501)``.
    values : mapping of str to float or str, optional
        Other parameters than that of the axis, over those of the model. A case takes every name and unit of
        its file: ``{"backlash": "90 um"}``.
    direction : Direction or {"cold", "up", "down"}
        Cold: every point from the same start. Up and down: the first point from there, every other from the
        attractor of the point before it, in ascending or descending order.
    start : array_like of shape (n,), optional
        State at phase zero; the model's cold start without.
    settings : Settings, optional
        How every attractor is looked for.
    execution : Execution, optional
        Who does the work, who is told and who may stop it: results are the same bytes. A study that is
        stopped, by Ctrl-C or otherwise, returns what it has by then, marked as incomplete.

    Returns
    -------
    Sweep
        Points in the order of the axis, which is told by short name in dimensionless values. A point that
        fails has a status and a message that say so.

    Raises
    ------
    GearlashError
        For names, values and starts that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> found = gl.sweep(case, gl.Axis.even("omega", 0.7, 0.9, 3), direction="up")
    >>> [str(point.label) for point in found.points]
    ['1-0-0', '1-0-0', '1-1-0']
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
    """Sweeps in several directions at once.

    What one direction does not find another may: where they differ, attractors coexist (`coexisting`).

    Parameters
    ----------
    model : Case or Family
    axis : Axis
        The parameter and its values, as for `sweep`.
    directions : sequence of Direction or str
        Out of ``"cold"``, ``"up"`` and ``"down"``, each once.
    values : mapping of str to float or str, optional
        Other parameters than that of the axis, over those of the model. A case takes every name and unit of
        its file: ``{"backlash": "90 um"}``.
    start : array_like of shape (n,), optional
        State at phase zero of cold points, and of the first point of the others; the cold start without.
    settings : Settings, optional
        How every attractor is looked for.
    execution : Execution, optional
        Who does the work, who is told and who may stop it: results are the same bytes. A study that is
        stopped, by Ctrl-C or otherwise, returns what it has by then, marked as incomplete.

    Returns
    -------
    tuple of Sweep
        In the order of the directions.

    Raises
    ------
    GearlashError
        For names, values and starts that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> up, down = gl.sweeps(case, gl.Axis.even("omega", 0.7, 0.9, 3), ["up", "down"])
    >>> [str(a.label) for a in up.points], [str(b.label) for b in down.points]
    (['1-0-0', '1-0-0', '1-1-0'], ['1-0-0', '1-1-0', '1-1-0'])
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
        return 1 if alone and points <= POINT_TASKS else POINTS_OF_A_TASK
    return execution.chunk


def _chains(way: Direction, axis: Axis, size: int, form: Segment, begin: np.ndarray | None) -> list[Chain]:
    """Cold: a chain for every chunk. Followed: one, whose tasks hand the attractor on."""
    values = axis.values[::-1] if way is Direction.DOWN else axis.values
    parts = [tuple(map(float, values[i : i + size])) for i in range(0, len(values), size)]
    tasks = [replace(form, follow=way is not Direction.COLD, values=part) for part in parts]
    sizes = [len(part) for part in parts]
    first = Neighbour(begin, None)
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
