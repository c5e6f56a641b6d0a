"""A branch of orbits of the article's pair: gearlash, and an arclength loop on heyoka's variational flow."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np

from gearlash import flow
from gearlash.branches.continuation import Branch, ContinuationSettings, continue_orbit
from gearlash.branches.continuation.equations import Equations, Evaluated, Line
from gearlash.branches.continuation.extrema import Extrema
from gearlash.orbits import Orbit, attractor, orbit_at
from gearlash.system import Family, GearlashError

from .peers import MISSING, installed
from .peers.plain import Pair
from .results import OWN, Row
from .timing import Runner, in_turns
from .works import family

TASK = "a branch"
POINTS = 300
HOW = "multipliers, extrema, certificates, labels, and special points solved for"
COMPARED = 5  # orbits of the peer that are held against those of gearlash
BESIDE = 1e-7
SAMPLED = 20  # orbits of which the parts are timed
SYSTEM, PROPAGATORS = "building a system, ms", "building its propagators, ms"


@dataclass(frozen=True)
class Asked:
    """A branch: from an orbit at ``values`` upwards in ``name``; ``longest`` and ``length``: of the steps of
    gearlash and of the peer, with which both come to some `POINTS` points."""

    work: str
    values: dict[str, float]
    name: str
    period: int
    upper: float
    longest: float
    length: float


ASKED = (
    Asked("article, P = 1, from ω = 1", {"omega": 1.0, "D": 1.0}, "omega", 1, 1.4, 0.008, 4e-3),
    Asked("article, P = 6, from D = 0.36", {"omega": 0.78, "D": 0.36}, "D", 6, 0.45, 0.0035, 1e-3),
)


def branch_rows(repeats: int, quick: bool) -> tuple[list[Row], dict[str, float]]:
    """Rows of both branches, and what a point of the first one takes by its parts."""
    rows, facts = [], {}
    for asked in ASKED:
        pairs = family("article")
        found = attractor(pairs.system(asked.values), pairs.start(asked.values))
        if not isinstance(found, Orbit) or found.period != asked.period:
            raise GearlashError(f"the benchmark expects an orbit of period {asked.period} at {asked.values}")
        upper = asked.values[asked.name] + 0.02 if quick else asked.upper
        rows += _rows(asked, pairs, found, upper, repeats)
        facts = facts or parts(asked, pairs, _own(asked, pairs, found, upper))
    return rows, facts


def _own(asked: Asked, pairs: Family, orbit: Orbit, upper: float) -> Branch:
    settings = ContinuationSettings(first=asked.longest, longest=asked.longest)
    return continue_orbit(pairs, asked.values, asked.name, orbit, asked.values[asked.name], upper, settings)


def _rows(asked: Asked, pairs: Family, orbit: Orbit, upper: float, repeats: int) -> list[Row]:
    runs: dict[str, tuple[str, Callable[[], Any], int]] = {}
    mine = _own(asked, pairs, orbit, upper)
    runs[OWN] = (HOW, lambda: _own(asked, pairs, orbit, upper), len(mine.points))
    error = None
    if installed("heyoka") != MISSING:
        from .peers import heyoka_branch

        peer = heyoka_branch.Branch(Pair.of(pairs.system(asked.values)), asked.name, asked.period)
        start = asked.values[asked.name]
        theirs = peer.follow(orbit.state, start, asked.length, POINTS, upper)
        run = lambda: peer.follow(orbit.state, start, asked.length, POINTS, upper)  # noqa: E731
        runs["heyoka"] = (heyoka_branch.BRANCH, run, len(theirs))
        error = max(_apart(asked, pairs, point) for point in theirs[:: max(1, len(theirs) // COMPARED)])
    times = in_turns([Runner(name, run, points) for name, (_, run, points) in runs.items()], repeats)
    rows = []
    for name, (how, _, _) in runs.items():
        own = name == OWN
        ratio, least = (
            (None, None) if own else (times[name].over(times[OWN]), times[name].least_over(times[OWN]))
        )
        rows.append(
            Row(TASK, asked.work, name, "point", times[name].median, times[name].best, ratio, least,
                None if own else error, None, how)
        )  # fmt: skip
    if "heyoka" not in runs:
        rows.append(Row(TASK, asked.work, "heyoka", "point", note=MISSING))
    return rows


def _apart(asked: Asked, pairs: Family, point: Any) -> float:
    """How far an orbit of the peer is from that of gearlash at the same value."""
    beside = point.state * (1.0 + BESIDE)  # so that Newton's method has something to do
    found = orbit_at(pairs.system({**asked.values, asked.name: point.value}), beside, asked.period)
    return np.inf if found is None else float(np.abs(found.state - point.state).max())


class _Ready(NamedTuple):
    """One point of a branch, ready for its parts to be timed."""

    equations: Equations
    here: Evaluated
    orbit: Orbit

    def again(self) -> Orbit:
        """The orbit, with nothing of it known yet."""
        found = orbit_at(self.here.props, self.orbit.state, self.equations.period, iterations=1)
        assert found is not None
        return found


TASKS: dict[str, Callable[[_Ready], object]] = {
    "one evaluation of the equations, ms": lambda r: r.equations.evaluate(r.here.u, r.here.props),
    "orbit with trace and extrema, ms": lambda r: Extrema.of(r.again()),
    "derivative along the parameter, ms": lambda r: r.equations.slope(r.here, r.orbit.trace),
    "certificate, ms": lambda r: replace(r.orbit).certificate,
}


def parts(asked: Asked, pairs: Family, branch: Branch) -> dict[str, float]:
    """What one point takes by its parts, each timed alone, in ms; medians over some of the points."""
    line = Line(pairs, branch.values, branch.name, branch.lower, branch.upper)
    chosen = branch.points[:: max(1, len(branch.points) // SAMPLED)]
    spent: dict[str, list[float]] = {name: [] for name in (SYSTEM, PROPAGATORS, *TASKS)}
    for point in chosen:
        system, spent_on = _timed(lambda p=point: line.build(p.value))
        spent[SYSTEM].append(spent_on)
        props, spent_on = _timed(lambda s=system: flow.propagators(s))
        spent[PROPAGATORS].append(spent_on)
        orbit = orbit_at(props, point.state, asked.period, iterations=1)
        assert orbit is not None
        equations = Equations.of(line, orbit)
        here = equations.evaluate(equations.unknowns(orbit, point.value), props)
        assert here is not None
        ready = _Ready(equations, here, orbit)
        for name, task in TASKS.items():
            spent[name].append(_timed(lambda t=task, r=ready: t(r))[1])
    return {name: 1e3 * float(np.median(each)) for name, each in spent.items()}


def _timed(task: Callable[[], Any]) -> tuple[Any, float]:
    began = perf_counter()
    found = task()
    return found, perf_counter() - began
