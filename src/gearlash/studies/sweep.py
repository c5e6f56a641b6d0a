"""Sweeps: one attractor per value of a parameter, cold or following the attractor up or down."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from gearlash._kernel import compile_all, load_all
from gearlash.jobs import Cancel, Chain, Inline, Outcome, ProgressCallback, open_executor, run
from gearlash.orbits import Settings
from gearlash.results import NOT_COMPUTED, Axis, Direction, Sweep, blank
from gearlash.system import GearlashError, UnknownNameError

from .model import Model, Source, check_travels, prepare
from .row import Segment, Trail, work

CHUNK = 8  # points a task: some ten milliseconds of work for a fraction of one of talk


def sweep(
    model: Model,
    axis: Axis,
    *,
    fixed: Mapping[str, float] | None = None,
    direction: Direction | str = Direction.COLD,
    initial: ArrayLike | None = None,
    settings: Settings | None = None,
    executor: Executor | None = None,
    chunk: int | None = None,
    progress: ProgressCallback | None = None,
    cancel: Cancel | None = None,
) -> Sweep:
    """One attractor per value of ``axis``; ``fixed`` are other parameters, by short name, over those of the
    case.

    ``cold``: every point from the family's cold start, or from ``initial`` (n,). ``up``, ``down``: the first
    point so, every other from the attractor of the point before it, which is followed. Any ``executor`` gives
    the same bytes, and so does any ``chunk`` (points a task). A point that fails is flagged with its reason.
    A cancel or Ctrl-C returns what was computed, marked incomplete. Raises `GearlashError` for names, values
    and starts that do not fit.
    """
    return sweeps(
        model,
        axis,
        (direction,),
        fixed=fixed,
        initial=initial,
        settings=settings,
        executor=executor,
        chunk=chunk,
        progress=progress,
        cancel=cancel,
    )[0]


def sweeps(
    model: Model,
    axis: Axis,
    directions: Sequence[Direction | str] = tuple(Direction),
    *,
    fixed: Mapping[str, float] | None = None,
    initial: ArrayLike | None = None,
    settings: Settings | None = None,
    executor: Executor | None = None,
    chunk: int | None = None,
    progress: ProgressCallback | None = None,
    cancel: Cancel | None = None,
) -> tuple[Sweep, ...]:
    """Sweeps in several directions at once, in that order; see `sweep`. What one start does not find another
    may: where they differ, attractors coexist (`coexisting`).
    """
    source = Source.of(model)
    fixed = _checked(source, axis, fixed, initial)
    check_travels(source, executor)
    ways = [_direction(d) for d in directions]
    size = _chunk(chunk, executor)
    form = Segment(source, tuple(fixed.items()), axis.name, settings or Settings(), False, ())
    begin = None if initial is None else np.array(initial, dtype=np.float64)
    chains = [chain for way in ways for chain in _chains(way, axis, size, form, begin)]
    outcome = run(work, chains, executor, progress=progress, cancel=cancel)
    return tuple(_gathered(way, axis, fixed, outcome) for way in ways)


def open_workers(model: Model, workers: int | None = None) -> Executor:
    """An executor whose processes know the model before their first task; see `jobs.open_executor`. Kernels
    that must be compiled are so before, by this process, which says it."""
    if workers is None or workers > 1:
        compile_all(load_all())
    return open_executor(workers, prepare, (Source.of(model),))


def _checked(
    source: Source, axis: Axis, fixed: Mapping[str, float] | None, initial: ArrayLike | None
) -> dict[str, float]:
    family, fixed = source.family(), dict(fixed or {})
    names = family.defaults
    if axis.name not in names:
        raise UnknownNameError("parameter", axis.name, names)
    if axis.name in fixed:
        raise GearlashError(f"{axis.name} is the axis of the sweep and cannot be fixed as well")
    family.complete(fixed)
    if initial is not None:
        start, n = np.asarray(initial, dtype=np.float64), len(family.states)
        if start.shape != (n,) or not np.isfinite(start).all():
            raise GearlashError(f"initial state: expected {n} finite numbers ({', '.join(family.states)})")
    return {name: float(value) for name, value in fixed.items()}


def _direction(text: Direction | str) -> Direction:
    if text not in tuple(Direction):
        raise UnknownNameError("direction", str(text), [str(d) for d in Direction])
    return Direction(text)


def _chunk(chunk: int | None, executor: Executor | None) -> int:
    if chunk is None:
        return 1 if executor is None or isinstance(executor, Inline) else CHUNK
    if chunk < 1:
        raise GearlashError(f"chunk = {chunk}: expected 1 or more points a task")
    return chunk


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


def _gathered(way: Direction, axis: Axis, fixed: dict[str, float], outcome: Outcome) -> Sweep:
    """The points of one direction in the order of the axis, blanks where there are none."""
    found = {}
    for name, points in outcome.results.items():
        if name == way or (isinstance(name, tuple) and name[0] == way):
            found |= {point.value: point for point in points}
    reason = outcome.reason or "stopped"
    points = tuple(
        found[value] if value in found else blank(value, NOT_COMPUTED, reason)
        for value in map(float, axis.values)
    )
    complete = len(found) == len(axis)
    return Sweep(axis, way, points, complete, "" if complete else reason, fixed)
