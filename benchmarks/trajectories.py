"""Time and error of a trajectory: one at a time by everybody, many at a time by those who can."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, Protocol

import numpy as np

from gearlash import flow

from .peers import MISSING, installed
from .peers.plain import Array
from .results import OWN, Row
from .timing import Runner, Times, in_turns
from .works import MANY_PERIODS, TOGETHER, Work

ONE, MANY = "one trajectory", "many trajectories"
PERIODS = 2_000  # of a timed call
OWN_PERIODS = 20_000  # for then it takes about as long as the others
QUIET = 20  # times as many where nothing is ever touched
SLOW_PERIODS = 10  # of those that call Python at every evaluation


class Solver(Protocol):
    """What a peer offers: the state after some periods; the crossings on the way, where it locates any."""

    crossings: Any

    def carry(self, z: Array, periods: int) -> Array: ...


class Own:
    """gearlash itself as a solver."""

    def __init__(self, work: Work):
        self.work = work
        self.crossings: list[tuple[float, int, bool]] = []

    def carry(self, z: Array, periods: int) -> Array:
        return flow.march(self.work.props, z, 1, periods).states[-1]

    def locate(self, z: Array) -> None:
        """Crossings of the first period."""
        events = flow.trace(self.work.props, z, float(self.work.system.cycles)).events
        tau = events.phase * 2 * np.pi / self.work.system.omega
        outward = events.engaging
        self.crossings = list(zip(tau.tolist(), events.boundary.tolist(), outward.tolist(), strict=True))


def trajectory_rows(work: Work, repeats: int, samples: int) -> tuple[list[Row], list[Row]]:
    """Rows of one trajectory and of many at one piece of work."""
    reference = _reference(work)
    one = _one(work, repeats, reference, work.states[-samples:])
    return one, _many(work, repeats, reference)


def _one(work: Work, repeats: int, reference: Solver | None, states: Array) -> list[Row]:
    solvers = {OWN: ("", OWN_PERIODS * (1 if work.crossings else QUIET), Own(work)), **dict(_peers(work))}
    runners = [
        Runner(name, _carrying(solver, states[-1], periods), periods)
        for name, (_, periods, solver) in solvers.items()
        if solver is not None
    ]
    times = in_turns(runners, repeats)
    truth = [] if reference is None else [_run(reference, z) for z in states]
    rows = []
    for name, (how, _, solver) in solvers.items():
        if solver is None:
            rows.append(Row(ONE, work.name, name, "period", note=MISSING))
            continue
        kept = _recording(work, name, solver)
        errors = _errors(kept, states, truth)
        rows.append(_row(ONE, work, name, times, how, *errors))
    return rows


def _many(work: Work, repeats: int, reference: Solver | None) -> list[Row]:
    """All march the same motions; heyoka so many of them at once as its batch has lanes."""
    states, again = work.scattered, 4 if work.crossings else 4 * QUIET

    def own(periods: int = MANY_PERIODS) -> Array:
        return flow.march_many(work.props, states, 1, periods).states[-1]

    def often() -> None:
        for _ in range(again):
            own()

    how = {OWN: "march_many"}
    runners, batches = [Runner(OWN, often, again * MANY_PERIODS * TOGETHER)], {}
    if installed("heyoka") != MISSING:
        from .peers.heyoka import HOW, HeyokaBatch, lanes

        for width in lanes():
            batch, name = HeyokaBatch(work.pair, width), f"heyoka, {width} lanes"
            batches[name], how[name] = batch, HOW
            runners.append(
                Runner(name, lambda b=batch: b.carry_all(states, MANY_PERIODS), MANY_PERIODS * TOGETHER)
            )
    times = in_turns(runners, repeats)
    truth = None if reference is None else np.array([reference.carry(z, 1) for z in states])
    rows = [_row(MANY, work, OWN, times, how[OWN], _worst(own(1), truth))]
    for name, batch in batches.items():
        rows.append(_row(MANY, work, name, times, how[name], _worst(batch.carry_all(states, 1), truth)))
    return rows if batches else [*rows, Row(MANY, work.name, "heyoka batch", "period", note=MISSING)]


def _peers(work: Work) -> Iterable[tuple[str, tuple[str, int, Solver | None]]]:
    """Name → how it is used, periods of a timed call, the solver (None: not installed)."""
    if installed("heyoka") == MISSING:
        yield "heyoka", ("", 0, None)
    else:
        from .peers import heyoka

        yield "heyoka", (heyoka.HOW, PERIODS, heyoka.Heyoka(work.pair))
    from .peers import rk4, scipy

    yield "RK4", (rk4.HOW, PERIODS, rk4.RungeKutta(work.pair))
    yield "scipy", (scipy.HOW, SLOW_PERIODS, scipy.Scipy(work.pair))
    if installed("scikit-sundae") == MISSING:
        yield "CVODE", ("", 0, None)
    else:
        from .peers import cvode

        yield "CVODE", (cvode.HOW, SLOW_PERIODS, cvode.Cvode(work.pair))


def _reference(work: Work) -> Solver | None:
    if installed("heyoka") == MISSING:
        return None
    from .peers.heyoka import Heyoka

    return Heyoka(work.pair, real=np.longdouble, record=True)


def _recording(work: Work, name: str, solver: Solver) -> Solver:
    """The solver with its crossings kept; heyoka is timed without."""
    if name != "heyoka":
        return solver
    from .peers.heyoka import Heyoka

    return Heyoka(work.pair, record=True)


def _carrying(solver: Solver, z: Array, periods: int) -> Callable[[], Array]:
    return lambda: solver.carry(z, periods)


def _run(solver: Solver, z: Array) -> tuple[Array, list | None]:
    """State after one period, and the crossings on the way (None: this solver locates none)."""
    end = solver.carry(z, 1)
    if isinstance(solver, Own):
        solver.locate(z)
    return end, None if solver.crossings is None else list(solver.crossings)


def _errors(solver: Solver, states: Array, truth: list) -> tuple[float | None, float | None, int]:
    """Largest error of the state and of a crossing time; periods whose crossings are not the same ones."""
    if not truth:
        return None, None, 0
    state, time, different = 0.0, None, 0
    for z, (end, crossings) in zip(states, truth, strict=True):
        found, met = _run(solver, z)
        state = max(state, _distance(found, end))
        if met is None:
            continue
        if [c[1:] for c in met] != [c[1:] for c in crossings]:
            different += 1
            continue
        late = [abs(float(a[0] - b[0])) for a, b in zip(met, crossings, strict=True)]
        time = max([*late, time or 0.0]) if late else time
    return state, time, different


def _worst(ends: Array, truth: Array | None) -> float | None:
    return None if truth is None else _distance(ends, truth)


def _distance(a: Array, b: Array) -> float:
    return float(np.abs(a - b).max())


def _row(
    task: str,
    work: Work,
    name: str,
    times: dict[str, Times],
    how: str,
    error: float | None = None,
    time_error: float | None = None,
    different: int = 0,
) -> Row:
    mine = times[name]
    ratio = None if name == OWN else mine.over(times[OWN])
    least = None if name == OWN else mine.least_over(times[OWN])
    odd = f"other crossings in {different} of the periods compared" if different else ""
    return Row(
        task, work.name, name, "period", mine.median, mine.best, ratio, least, error, time_error, how, odd
    )
