"""What is measured along a sweep: forces of mesh and bearings, transmission error, impacts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from gearlash import flow
from gearlash.case import Case
from gearlash.flow import Propagators, Trace
from gearlash.gears import helical, spur
from gearlash.jobs import Chain, Execution, Part, handing_on, run, stopping
from gearlash.orbits.results import SAMPLE
from gearlash.orbits.signals import Signals, signals
from gearlash.results import Point, Sweep, same_motion
from gearlash.system import Family, GearlashError
from gearlash.system.readout import Readout

from .model import Source
from .point import TRACEABLE

POINTS_OF_A_TASK = 16


def readouts_of(case: Case, values: Mapping[str, float]) -> tuple[Readout, ...]:
    """What is read of a gear pair with these values, every parameter by short name: bearing forces, where it
    has bearings, and last the transmission error."""
    numbers = case.numbers
    if numbers.pair is None:
        return spur.readouts(values, numbers.excitation)
    return helical.readouts(numbers.pair, numbers.parameters, values, numbers.excitation)


def trace_of(family: Family, values: Mapping[str, float], point: Point, reuse: Propagators | None) -> Trace:
    """One period of the orbit of a point, or the stretch of another motion that a point was made from."""
    props = flow.propagators(family.system(values), reuse)
    cycles = point.period if point.periodic else SAMPLE * props.system.cycles
    return flow.trace(props, point.state, float(cycles))


def traceable(point: Point) -> bool:
    """Whether there is a motion to measure."""
    state = np.asarray(point.state)
    return point.status in TRACEABLE and len(state) > 0 and bool(np.isfinite(state).all())


@dataclass(frozen=True)
class _Task:
    source: Source
    fixed: tuple[tuple[str, float], ...]
    name: str
    points: tuple[Point, ...]


def measured(
    case: Case, sweeps: Sequence[Sweep], execution: Execution
) -> tuple[tuple[tuple[Signals | None, ...], ...], bool]:
    """Signals of every point of sweeps over one axis, None where there is no motion or it was not reached;
    and whether all were. A motion that two directions found is measured once."""
    first, ways = sweeps[0], [list(sweep.points) for sweep in sweeps]
    source, fixed = Source.of(case), tuple(first.fixed.items())
    chosen: dict[tuple[int, int], Point] = {}
    alike: dict[tuple[int, int], tuple[int, int]] = {}
    for j, points in enumerate(zip(*ways, strict=True)):
        for i, point in enumerate(points):
            if not traceable(point):
                continue
            known = next((k for k in range(i) if (k, j) in chosen and _same(points[k], point)), None)
            if known is None:
                chosen[i, j] = point
            else:
                alike[i, j] = (known, j)
    places = list(chosen)
    parts = [places[k : k + POINTS_OF_A_TASK] for k in range(0, len(places), POINTS_OF_A_TASK)]
    chains = [
        Chain(k, (_Task(source, fixed, first.axis.name, tuple(chosen[p] for p in part)),), (len(part),))
        for k, part in enumerate(parts)
    ]
    outcome = run(_measure, chains, execution) if chains else None
    results = {} if outcome is None else outcome.results
    got: dict[tuple[int, int], Signals | None] = {}
    for k, part in enumerate(parts):
        got.update(zip(part, results.get(k, ()), strict=False))
    got |= {place: got.get(origin) for place, origin in alike.items()}
    table = tuple(tuple(got.get((i, j)) for j in range(len(points))) for i, points in enumerate(ways))
    return table, outcome is None or outcome.complete


def _same(one: Point, other: Point) -> bool:
    return one.periodic and same_motion(one, other)


def _measure(task: _Task, _carry: object) -> Part:
    """The signals of some points (the work of a worker)."""
    family, case, found = task.source.family(), _case(task.source.case_json or ""), []
    reuse: Propagators | None = None
    with handing_on(lambda: Part(tuple(found))):
        for point in task.points:
            if stopping():
                break
            values = family.complete({**dict(task.fixed), task.name: point.value})
            try:
                trace = trace_of(family, values, point, reuse)
                reuse = trace.propagators
                found.append(signals(trace, readouts_of(case, values)))
            except (GearlashError, np.linalg.LinAlgError):
                found.append(None)
    return Part(tuple(found))


@lru_cache(maxsize=8)
def _case(text: str) -> Case:
    return Case.from_json(text)
