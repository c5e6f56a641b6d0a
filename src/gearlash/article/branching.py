"""The two scans as branches: every periodic attractor of the sweeps followed to all that belongs to it.

Each attractor of a sweep is looked for on the branches that are known; where it lies on none, the branch
through it is followed between the limits of the scan, stable or not. At doublings where an attractor may be
born, and no followed branch begins there yet, the branch is switched to. Attractors of one period are one
task: which of them begins a branch does not depend on the number of workers."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash import (
    Branch,
    ContinuationSettings,
    SpecialKind,
    SpecialPoint,
    continue_branch,
    flow,
    orbits,
    switch_branch,
)
from gearlash.case import Case
from gearlash.results import Direction, Point
from gearlash.studies.transition import Transition
from gearlash.system import Family, GearlashError, Signature, Status

from .reproduction import Explained, Scan
from .rows import Found, Row
from .stretches import special_points, stretches, together

Array = NDArray[np.float64]
Doubling = tuple[Branch, SpecialPoint]
STEPS = ContinuationSettings(most_points=600, certify=False)
MOST_BRANCHES = 12  # of one period and parameter
MATCHED = 1e-9  # relative distance of a change along a sweep and the special point that it is
SWITCHED = 24  # period up to which every doubling is switched at
JOINED = 1e-8  # likewise, of a doubling and the end of the branch that begins there
SAME_STATE = 1e-6  # relative to the largest state: two orbits that are one
BESIDE_CHORD = (
    0.2  # of the distance of two neighbouring orbits: how far beside their chord the branch may run
)


@dataclass(frozen=True, eq=False)
class Followed:
    """Branches through attractors of one period; how many of these attractors lie on one of them, and what
    was not followed."""

    branches: tuple[Branch, ...]
    on_branches: int
    left: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Following:
    """The branches of one scan, while workers follow them."""

    case: Case
    name: str
    fixed: Mapping[str, float]
    limits: tuple[float, float]
    attractors: int
    tasks: tuple[Future[Followed], ...]

    @staticmethod
    def begun(
        case: Case, name: str, fixed: Mapping[str, float], done: Sequence[Row], executor: Executor
    ) -> Following:
        """Hands the attractors of these sweeps to the workers, long periods first."""
        by_period: dict[int, list[Point]] = defaultdict(list)
        for row in done:
            for point in row.sweep.points:
                if point.periodic:
                    by_period[point.period].append(point)
        values = done[0].sweep.axis.values
        limits = float(values.min()), float(values.max())
        tasks = tuple(
            executor.submit(follow_all, case.to_json(), name, dict(fixed), limits, tuple(by_period[period]))
            for period in sorted(by_period, reverse=True)
        )
        return Following(case, name, dict(fixed), limits, sum(map(len, by_period.values())), tasks)

    def scan(self, found: Sequence[Found], executor: Executor) -> Scan:
        """All branches, and which special point each of the changes ``found`` along the sweeps is."""
        parts = [task.result() for task in self.tasks]
        followed = [branch for part in parts for branch in part.branches]
        doublings = _to_switch(followed, found)
        tasks = [executor.submit(switch, self.case.to_json(), *each) for each in doublings]
        switched = [task.result() for task in tasks]
        born: list[Branch] = []
        for (_, special), part in zip(doublings, switched, strict=True):
            if not _begins_at(born, special):  # one branch may lead from one doubling to another
                born += part.branches
        both = [*((branch, False) for branch in followed), *((branch, True) for branch in born)]
        both.sort(key=lambda each: (each[0].points[0].period, float(each[0].parameter.min())))
        branches = tuple(branch for branch, _ in both)
        stable = stretches(branches)
        return Scan(
            parameter=self.name,
            fixed=self.fixed,
            lower=self.limits[0],
            upper=self.limits[1],
            branches=branches,
            switched=tuple(i for i, (_, new) in enumerate(both) if new),
            events=tuple(_explained(branches, *each) for each in found),
            stretches=stable,
            together=together(stable),
            attractors=self.attractors,
            on_branches=sum(part.on_branches for part in parts),
            left=tuple(text for part in (*parts, *switched) for text in part.left),
        )


def follow_all(
    case_json: str,
    name: str,
    fixed: Mapping[str, float],
    limits: tuple[float, float],
    points: tuple[Point, ...],
) -> Followed:
    """The branches through attractors of one period (a task for a worker)."""
    case = Case.from_json(case_json)
    family, _ = case.family()
    known = _Known(family, {**family.complete(), **fixed}, name)
    left: dict[str, None] = {}
    count = 0
    for point in _middle_first(points):
        if known.has(point):
            count += 1
            continue
        if len(known.branches) == MOST_BRANCHES:
            left[f"{point.label}: more than {MOST_BRANCHES} branches of this period"] = None
            continue
        try:
            branch = continue_branch(
                case, name, point, lower=limits[0], upper=limits[1], values=fixed, steps=STEPS
            )
        except GearlashError as error:
            left[f"{point.label} from {name} = {point.value:.6g}: {error}"] = None
            continue
        known.add(branch)
        count += known.has(point)
    return Followed(tuple(known.branches), count, tuple(left))


def _middle_first(points: Sequence[Point]) -> list[Point]:
    """Of each label first what lies in the middle of where it was seen: far from what ends it."""
    middle = {
        label: float(np.median([point.value for point in points if point.label == label]))
        for label in {point.label for point in points}
    }
    return sorted(points, key=lambda point: abs(point.value - middle[point.label]))


def switch(case_json: str, branch: Branch, special: SpecialPoint) -> Followed:
    """The branches that begin at a doubling (a task for a worker)."""
    place = f"doubling of {special.label_before} at {branch.name} = {special.value:.9g}"
    try:
        found = switch_branch(Case.from_json(case_json), branch, special, steps=STEPS)
    except GearlashError as error:
        return Followed((), 0, (f"{place}: {error}",))
    return Followed(found, 0, () if found else (f"{place}: no orbit of twice the period was found there",))


@dataclass(frozen=True, eq=False)
class _Chain:
    """A branch as a chain of chords between neighbouring orbits: base periods (m, P, n) and values (m,)."""

    strobes: Array
    values: Array
    width: float

    @staticmethod
    def of(branch: Branch) -> _Chain:
        along = [*branch.points, *(special.point for special in branch.special)]
        along.sort(key=lambda point: point.arclength)
        width = branch.upper - branch.lower
        return _Chain(np.array([p.strobes for p in along]), np.array([p.value for p in along]), width)

    def near(self, point: Point) -> Iterator[Array]:
        """States (n,) on chords beside which the point lies."""
        size = float(np.abs(point.state).max())
        chord = self._together(np.diff(self.strobes, axis=0), np.diff(self.values), size)
        away = self._together(point.state - self.strobes[:-1], point.value - self.values[:-1], size)
        length = (chord**2).sum(axis=2)
        part = np.clip((chord * away).sum(axis=2) / np.maximum(length, 1e-300), 0.0, 1.0)
        beside = np.linalg.norm(away - part[:, :, None] * chord, axis=2)
        close = beside <= BESIDE_CHORD * np.sqrt(length) + SAME_STATE
        for i, k in np.argwhere(close):
            yield self.strobes[i, k] + part[i, k] * (self.strobes[i + 1, k] - self.strobes[i, k])

    def _together(self, strobes: Array, values: Array, size: float) -> Array:
        """(m, P, n + 1): states over their size, the parameter over its width."""
        wide = np.broadcast_to((values / self.width)[:, None, None], (*strobes.shape[:2], 1))
        return np.concatenate([strobes / size, wide], axis=2)


class _Known:
    """Branches of one period, and whether an attractor of a sweep lies on one of them."""

    def __init__(self, family: Family, values: Mapping[str, float], name: str) -> None:
        self.family, self.values, self.name = family, values, name
        self.branches: list[Branch] = []
        self.chains: list[_Chain] = []
        self.seen: dict[float, list[Array]] = defaultdict(list)  # by value: base periods of orbits

    def add(self, branch: Branch) -> None:
        self.branches.append(branch)
        self.chains.append(_Chain.of(branch))

    def has(self, point: Point) -> bool:
        if any(_nearest(strobes, point.state) <= SAME_STATE for strobes in self.seen[point.value]):
            return True
        return any(self.leads_to(point, state) for chain in self.chains for state in chain.near(point))

    def leads_to(self, point: Point, state: Array) -> bool:
        """Whether the orbit near this state is that of the point."""
        props = flow.propagators(self.family.system({**self.values, self.name: point.value}))
        orbit = orbits.orbit_at(props, state, point.period // props.system.cycles)
        if orbit is None or _nearest(orbit.strobes, point.state) > SAME_STATE:
            return False
        self.seen[point.value].append(orbit.strobes)
        return True


def _nearest(strobes: Array, state: Array) -> float:
    """How near one of the base periods is to a state, relative to the largest."""
    return float(np.abs(strobes - state).max(axis=1).min() / np.abs(state).max())


def _to_switch(branches: Sequence[Branch], found: Sequence[Found]) -> list[Doubling]:
    """Doublings that a stable orbit comes to, and at which none of the branches begins: those of short
    periods, and those nearest to a change along the sweeps that no branch has yet."""
    open_ones = [
        (branch, special)
        for branch in branches
        for special in special_points(branch)
        if special.kind is SpecialKind.DOUBLING
        and min(special.unstable_before, special.unstable_after) == 0
        and not _begins_at(branches, special)
    ]
    asked = [each for change, _ in found for each in _asked(branches, open_ones, change)]
    return [each for each in open_ones if 2 * each[1].point.period <= SWITCHED or each in asked]


def _begins_at(branches: Sequence[Branch], doubling: SpecialPoint) -> bool:
    """Whether one of the branches is that of the orbits of twice the period."""
    return any(
        joins.point.period == 2 * doubling.point.period
        and abs(joins.value - doubling.value) <= JOINED * abs(doubling.value)
        for branch in branches
        for joins in branch.of_kind(SpecialKind.JOINS)
    )


def _asked(branches: Sequence[Branch], open_ones: Sequence[Doubling], change: Transition) -> list[Doubling]:
    """The doubling nearest to a change that none of the branches has, of half of a period seen there."""
    if _explained(branches, change, ()).special is not None:
        return []
    periods = {
        label.period for label in (change.label_below, change.label_above) if isinstance(label, Signature)
    }
    near = [each for each in open_ones if 2 * each[1].point.period in periods]
    return sorted(near, key=lambda each: abs(each[1].value - change.value))[:1]


def _explained(
    branches: Sequence[Branch], transition: Transition, directions: Sequence[Direction]
) -> Explained:
    """The special point that a change along the sweeps is: of the same kind, and nearest to it."""
    assert transition.point is not None  # as of `rows.distinct`
    near = [
        (abs(special.value - transition.value), number, special)
        for number, branch in enumerate(branches)
        for special in special_points(branch)
        if special.kind == transition.kind and special.status is Status.OK
    ]
    apart, number, special = min(near, key=lambda each: each[:2], default=(float("inf"), -1, None))
    if apart > MATCHED * abs(transition.value):
        number, special = -1, None
    return Explained(
        value=transition.value,
        kind=transition.kind,
        before=transition.label_below,
        after=transition.label_above,
        directions=tuple(map(str, directions)),
        branch=number,
        special=special,
        swept=transition.point,
    )
