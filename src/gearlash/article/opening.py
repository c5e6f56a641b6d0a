"""What a doubled orbit touches first: how far a period doubling and a grazing lie apart, and why.

At a doubling the doubled orbit opens from the single one like a square root: at the distance s of the
parameter its motion differs by an amplitude a, with s = c a² + e a⁴ + …. An extremum at a clearance h from a
boundary then comes nearer by b a + q a² + …, so that to leading order it touches at a = h/b, that is at
s = c (h/b)²: small amplitudes reach far, and a doubling whose orbit passes a boundary closely has a grazing
right beside it. Both would fall into one point only where h = 0 as well, which takes a second parameter.

Doubling and grazing are special points of the branches of a scan. In between, the doubled orbit is followed
once more from its touch back to the doubling, in short steps, and c, e, b and q are read there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash import (
    Branch,
    BranchPoint,
    ContinuationSettings,
    EndKind,
    SpecialKind,
    SpecialPoint,
    continue_branch,
)
from gearlash.case import Case
from gearlash.results import Direction
from gearlash.system import GearlashError, Signature

from .reproduction import Coincidence, Explained, Opening, Scan

Array = NDArray[np.float64]
Beside = tuple[Coincidence, tuple[Direction, ...]]
BORN = 1e-8  # relative distance of a doubling and the place where the doubled orbits join it
FARTHEST = 0.02  # of the parameter: a touch beyond is not beside the doubling
STEPS = 60  # orbits between the touch and the doubling
BEYOND = 4  # orbits that are followed the other way
SMALL = 0.5  # of the amplitude that touches: up to there the coefficients are read
SMALLEST = 4  # amplitudes from which the power of the opening is read
SHOWN = 6  # amplitudes that are kept, evenly among those that were followed


@dataclass(frozen=True, eq=False)
class Pair:
    """A doubling that the sweeps met and, next to it on the branch that begins there, a grazing."""

    event: Explained
    doubling: SpecialPoint
    doubled: Branch
    joins: SpecialPoint
    grazing: SpecialPoint


def coincidences(case: Case, scan: Scan, executor: Executor) -> list[Beside]:
    """What lies between every doubling of a scan that has a grazing beside it and that grazing, with the
    directions in which the doubling was met."""
    found = list(pairs(scan))
    tasks = [executor.submit(between, case.to_json(), each) for each in found]
    return [
        (both, tuple(map(Direction, pair.event.directions)))
        for pair, task in zip(found, tasks, strict=True)
        if (both := task.result()) is not None
    ]


def pairs(scan: Scan) -> Iterator[Pair]:
    """Doublings along the sweeps whose doubled orbit meets a boundary before anything else happens to it,
    within 2 % of the parameter."""
    for event in scan.events:
        doubling = event.special
        if doubling is None or doubling.kind is not SpecialKind.DOUBLING:
            continue
        for branch in scan.branches:
            for joins, beside in _first_after_birth(branch, doubling):
                near = abs(beside.value - doubling.value) <= FARTHEST * abs(doubling.value)
                if beside.kind is SpecialKind.GRAZING and near:
                    yield Pair(event, doubling, branch, joins, beside)


def _first_after_birth(branch: Branch, doubling: SpecialPoint) -> Iterator[tuple[SpecialPoint, SpecialPoint]]:
    """Where a branch begins at a doubling: that point, and the special point next to it."""
    if len(branch.special) < 2:
        return
    for joins, beside in (branch.special[:2], branch.special[:-3:-1]):
        apart = abs(joins.value - doubling.value)
        twice = joins.kind is SpecialKind.JOINS and joins.point.period == 2 * doubling.point.period
        if twice and apart <= BORN * abs(doubling.value):
            yield joins, beside


def between(case_json: str, pair: Pair) -> Coincidence | None:
    """The doubled orbits between the two, and what they say (a task for a worker); None where they cannot be
    followed."""
    case, length = Case.from_json(case_json), abs(pair.grazing.arclength - pair.joins.arclength)
    step = min(1.0, length / STEPS)
    steps = ContinuationSettings(
        first=step, longest=step, shortest=1e-6 * step, most_points=2 * STEPS, certify=False
    )
    branch = pair.doubled
    try:
        again = continue_branch(
            case,
            branch.name,
            pair.grazing,
            lower=branch.lower,
            upper=branch.upper,
            values=branch.values,
            steps=steps,
        )
    except GearlashError:
        return None
    orbits = _towards_the_doubling(again)
    return None if orbits is None else _coincidence(pair, orbits, _touching(again, pair.grazing))


def _towards_the_doubling(again: Branch) -> list[BranchPoint] | None:
    """Orbits from the doubling, left out, to the touch."""
    ahead, behind = again.ends[1].kind is EndKind.JOINED, again.ends[0].kind is EndKind.JOINED
    if ahead == behind:
        return None
    chosen = [p for p in again.points if (p.arclength > 0.0) is ahead and p.arclength != 0.0]
    return sorted(chosen, key=lambda point: -abs(point.arclength))


def _touching(again: Branch, grazing: SpecialPoint) -> int:
    """The number of the extremum that touches, in the branch that was begun there."""
    assert grazing.extremum is not None
    start = min(again.points, key=lambda point: abs(point.arclength))
    alike = [each for each in start.extrema if each.group == grazing.extremum.group]
    return min(alike, key=lambda each: abs(each.distance)).number


def _coincidence(pair: Pair, orbits: Sequence[BranchPoint], number: int) -> Coincidence:
    doubling, grazing = pair.doubling, pair.grazing
    opening = [
        Opening(amplitude(point), abs(point.value - doubling.value), abs(extremum.distance))
        for point in orbits
        for extremum in point.extrema
        if extremum.number == number
    ]
    touch = amplitude(grazing.point)
    small = [each for each in opening if each.amplitude <= SMALL * touch]
    clearance = _clearance(pair)
    law = _Law.read(small, clearance)
    stable_side, far_side = _labels(pair)
    return Coincidence(
        doubling=doubling,
        grazing=grazing,
        single=doubling.label_before,
        doubled=stable_side,
        beyond=far_side,
        apart=abs(grazing.value - doubling.value),
        clearance=clearance,
        predicted=law.leading(clearance),
        power=_power(opening[:SMALLEST]),
        opening=tuple(opening[:: max(1, len(opening) // SHOWN)]),
        opens=law.c,
        approaches=law.b,
        corrected=law.corrected(clearance),
        amplitude=touch,
    )


def amplitude(point: BranchPoint) -> float:
    """Half of how far an orbit lies, at phase zero, from itself half of its period later: at most."""
    later = np.roll(point.strobes, -(len(point.strobes) // 2), axis=0)
    return 0.5 * float(np.linalg.norm(later - point.strobes, axis=1).max())


def _clearance(pair: Pair) -> float:
    """Of the extremum that touches, in the doubling itself."""
    assert pair.grazing.extremum is not None
    number = pair.grazing.extremum.number
    return next(abs(each.distance) for each in pair.joins.point.extrema if each.number == number)


def _labels(pair: Pair) -> tuple[Signature, Signature]:
    """Of the doubled orbit between the two, and beyond the grazing."""
    one, two = pair.grazing.label_before, pair.grazing.label_after
    after = pair.grazing.arclength > pair.joins.arclength
    return (one, two) if after else (two, one)


@dataclass(frozen=True)
class _Law:
    """s = c a² + e a⁴ and clearance = h - b a - q a²."""

    c: float
    e: float
    b: float
    q: float

    @staticmethod
    def read(small: Sequence[Opening], clearance: float) -> _Law:
        if len(small) < SMALLEST:
            return _Law(*[float("nan")] * 4)
        a, s, d = np.array([(each.amplitude, each.distance, each.clearance) for each in small]).T
        e, c = np.polyfit(a**2, s / a**2, 1)
        q, b = np.polyfit(a, (clearance - d) / a, 1)
        return _Law(float(c), float(e), float(b), float(q))

    def leading(self, clearance: float) -> float:
        """Distance of the touch by the square root alone."""
        return self.c * (clearance / self.b) ** 2

    def corrected(self, clearance: float) -> float:
        """The same with the next terms."""
        roots = np.roots([self.q, self.b, -clearance]) if np.isfinite([self.q, self.b]).all() else []
        a = min((root.real for root in roots if root.imag == 0.0 and root.real > 0.0), default=float("nan"))
        return self.c * a**2 + self.e * a**4


def _power(smallest: Sequence[Opening]) -> float:
    """Of the opening: amplitude ∼ distance^power."""
    if len(smallest) < SMALLEST:
        return float("nan")
    a, s = np.array([(each.amplitude, each.distance) for each in smallest]).T
    return float(np.polyfit(np.log(s), np.log(a), 1)[0])
