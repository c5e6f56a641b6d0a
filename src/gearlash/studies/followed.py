"""Every motion that was found, followed once along its whole branch.

Points of sweeps are where branches begin. From each branch others are reached: where it doubles or breaks its
symmetry, and from just beyond the ends of its stable arcs, where motion goes on as something else."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches.continuation import Branch, SpecialKind, SpecialPoint
from gearlash.jobs import Chain, Execution, run
from gearlash.jobs.chains import Work as Doing
from gearlash.orbits import orbit_at
from gearlash.results import Point
from gearlash.system import Family, GearlashError, MotionKind

from .arcs import Arc, arcs_of
from .follow_tasks import (
    SAME,
    Follow,
    Look,
    Question,
    Seed,
    Switch,
    Traced,
    cuts_of,
    distance,
    follow_branch,
    look,
    switch_branch,
)
from .work import Changes, Work
from .zone_end import ZoneEnd

Array = NDArray[np.float64]

BEYOND = (1e-4, 1e-3)  # of the value: how far beyond the end of a stable arc is looked what motion goes on as
BETWEEN = 0.25  # of the distance of two neighbours of a branch: how far beside their chord it may lie
MEET = 1e-6  # of the axis: where two branches end so near to each other, they meet
NARROW = 2e-3  # of the axis: from arcs that are no wider no further branches are looked for
NARROWEST = 1e-4  # of the axis: beyond the ends of narrower arcs nothing is looked for
MOST_SWITCHED = 12  # branches to which is switched
ROUNDS = 40  # of following
PASSES = 3  # of looking beyond ends
LONGEST_PERIOD = 64
SWITCHED = (SpecialKind.DOUBLING, SpecialKind.JOINS, SpecialKind.BRANCH_POINT, SpecialKind.SYMMETRIC)
BEYOND_END = "beyond an end"
STOPPED = "stopped"
LEFT_OUT = "not followed along its branch, as the work that was allowed for is spent"


@dataclass(eq=False)
class Followed:
    """``branches`` and all their ``arcs``; ``ways``: how the motion of an arc was found, by its identity;
    ``unfollowed``: points that are periodic, but whose branch could not be followed, and why; ``beyond``:
    what motion goes on as beyond the end of an arc, by its number and whether it is the upper end;
    ``reason``: why something is missing, and then ``not_followed``: how many periodic points lie on no branch
    that was followed; ``longest``: mesh cycles of an orbit to which is switched; ``work``: how much there may
    be, ``changes``: where motions matter most, which are followed first where work is limited."""

    question: Question
    execution: Execution
    branches: list[Branch] = field(default_factory=list)
    arcs: list[Arc] = field(default_factory=list)
    ways: dict[int, set[str]] = field(default_factory=dict)
    unfollowed: list[tuple[Point, str]] = field(default_factory=list)
    beyond: dict[tuple[int, bool], Point] = field(default_factory=dict)
    reason: str = ""
    longest: int = LONGEST_PERIOD
    switched_to: int = 0
    not_followed: int = 0
    work: Work = field(default_factory=Work)
    changes: Changes = field(default_factory=lambda: Changes(()))

    @property
    def wide(self) -> list[Arc]:
        """Stable arcs from which further branches are looked for."""
        return [arc for arc in self.stable if arc.width > NARROW * self.question.width]

    @property
    def stable(self) -> list[Arc]:
        return [arc for arc in self.arcs if arc.stable]

    def add(self, points: Iterable[tuple[str, Point]]) -> None:
        """Follows the branches of all periodic points that lie on none yet."""
        family = self.question.source.family()
        open_ = [(way, point) for way, point in points if point.periodic]
        for _ in range(ROUNDS):
            open_ = [(way, point) for way, point in open_ if not self._known(family, point, way)]
            if not open_ or self.reason:
                self.not_followed += len(open_)
                return
            chosen: dict[int, tuple[str, Point]] = {}
            longest = self.longest_first([point for _, point in open_])
            for way, point in sorted(open_, key=lambda one: one[1].minimum - one[1].maximum):
                if point.period <= longest:
                    chosen.setdefault(
                        point.period, (way, point)
                    )  # steps are in units of the first one's size
            first = self.first_of(list(chosen.values()))
            if not first:
                self.leave_out(open_)
                return
            seeds = [Seed(p.value, p.state, len(p.strobes), way) for way, p in first]
            for (way, point), failure in zip(first, self.followed(seeds), strict=True):
                if failure == STOPPED:
                    continue
                if failure or not self._known(family, point, way):
                    self.unfollowed.append((point, failure or "its branch does not lead back to it"))
            lost = {id(point) for point, _ in self.unfollowed}
            open_ = [(way, point) for way, point in open_ if id(point) not in lost]
        self.unfollowed += [(point, f"{ROUNDS} rounds of following were not enough") for _, point in open_]

    def longest_first(self, points: Sequence[Point]) -> float:
        """The longest period to follow next: where work is limited, that of motions without impacts as long
        as one of them lies on no branch. Bands depend on them, and long motions take much work."""
        return max((p.period for p in points if self.work.limited and p.impact_free), default=inf)

    def first_of(self, wanted: list[tuple[str, Point]]) -> list[tuple[str, Point]]:
        """Those to follow next: all, or where work is limited those that matter most and are short."""
        if self.work.limited:
            wanted.sort(key=lambda one: self.changes.order(one[1]))
        return self.work.afforded(wanted, lambda one: len(one[1].strobes))

    def leave_out(self, points: Sequence[tuple[str, Point]]) -> None:
        """Motions that are not followed, as the work is spent: they were seen where they were found."""
        self.work.left_out += len(points)
        self.unfollowed += [(point, LEFT_OUT) for _, point in points]

    def _known(self, family: Family, point: Point, way: str) -> bool:
        arc = self.arc_of(family, point)
        if arc is not None:
            self.ways.setdefault(id(arc), set()).add(way)
        return arc is not None

    def followed(self, seeds: Sequence[Seed]) -> list[str]:
        """Follows the branches of seeds; why it could not, of each, or empty."""
        tasks = [self.follow(seed) for seed in seeds]
        chains = [Chain(i, (task,), (1,)) for i, task in enumerate(tasks)]
        done, failures = self.done(follow_branch, chains), []
        for i in range(len(seeds)):
            found = done.get(i, STOPPED)
            failures.append(found if isinstance(found, str) else "")
            if not isinstance(found, str):
                self.take(found)
        return failures

    def follow(self, seed: Seed) -> Follow:
        """The task that follows a seed: to where branches were cut that may be its own."""
        cuts = [cut for branch in self.branches for cut in cuts_of(branch)]
        near = MEET * self.question.width
        cuts = [cut for cut in cuts if len(cut.strobes) == seed.periods]
        above = [cut for cut in cuts if cut.up and cut.value < seed.value - near]
        below = [cut for cut in cuts if not cut.up and cut.value > seed.value + near]
        return Follow(
            self.question,
            seed,
            self.work.orbits_each_way(seed.periods),
            max(above, key=lambda cut: cut.value, default=None),
            min(below, key=lambda cut: cut.value, default=None),
        )

    def take(self, traced: Traced) -> None:
        """Keeps a branch that is not known; of one that is known in part, as that was cut, the rest."""
        branch = traced.branch
        self.work.followed(branch, traced.orbits)
        arcs = arcs_of(branch, len(self.branches))
        twice = [(arc, old) for arc in arcs if arc.stable for old in self.stable if self._same(arc, old)]
        if twice:
            known = {id(arc) for arc, _ in twice}
            arcs = tuple(arc for arc in arcs if id(arc) not in known)
            cut = any(next(cuts_of(self.branches[old.branch]), None) is not None for _, old in twice)
            if not cut or not any(arc.stable for arc in arcs):
                return
        self.branches.append(branch)
        self.arcs.extend(arcs)

    def _same(self, arc: Arc, other: Arc) -> bool:
        """Whether two arcs are the same, of one branch that was followed from two of its orbits."""
        near = MEET * self.question.width
        if arc.label != other.label or not _meet(arc.lower.value, other.lower.value, near):
            return False
        if not _meet(arc.upper.value, other.upper.value, near):
            return False
        middle = 0.5 * (arc.lower.value + arc.upper.value)
        (one, apart), (two, away) = arc.strobes(middle), other.strobes(middle)
        size = max(float(np.abs(one).max()), 1e-3)
        return distance(one, two[0]) <= max(BETWEEN * (apart + away), SAME * size)

    def arc_of(self, family: Family, point: Point) -> Arc | None:
        """The stable arc that a periodic point of a sweep lies on."""
        near = SAME * self.question.width
        for arc in self.arcs:
            if not arc.stable or arc.label != point.label:
                continue
            if not arc.lower.value - near <= point.value <= arc.upper.value + near:
                continue
            strobes, apart = arc.strobes(point.value)
            size = max(float(np.abs(strobes).max()), 1e-3)
            away = distance(strobes, point.state)
            if away <= max(SAME * size, BETWEEN * apart) or self._leads_to(family, strobes, point, size):
                return arc
        return None

    def _leads_to(self, family: Family, strobes: Array, point: Point, size: float) -> bool:
        try:
            props = flow.propagators(family.system(self.question.values(family, point.value)))
            found = orbit_at(props, strobes[0], len(strobes))
        except (GearlashError, np.linalg.LinAlgError):
            return False
        return found is not None and distance(found.strobes, point.state) <= SAME * size

    def switch(self) -> None:
        """Branches that meet those known where a stable arc ends, until there are no more."""
        tried: set[int] = set()
        for _ in range(ROUNDS):
            specials = {
                id(end.point): (arc, end.point)
                for arc in self.wide
                for end in (arc.lower, arc.upper)
                if isinstance(end.point, SpecialPoint)
                and end.point.kind in SWITCHED and id(end.point) not in tried and not self._met(end.point)
            }  # fmt: skip
            tried |= set(specials)
            if not specials or self.reason:
                return
            wanted = [
                (arc, special)
                for arc, special in specials.values()
                if special.kind is not SpecialKind.DOUBLING or 2 * special.point.period <= self.longest
            ]
            if self.work.limited:
                wanted.sort(key=lambda one: (not self.changes.hold(one[1].value), one[1].point.period))
            chosen = self.work.afforded(wanted, lambda one: 2 * one[1].point.period)
            self.work.left_out += len(wanted) - len(chosen)
            chains = [
                Chain(i, (Switch(self.question, self.branches[arc.branch], special),), (1,))
                for i, (arc, special) in enumerate(chosen)
            ]
            self.work.looked(len(chains))
            done = self.done(switch_branch, chains)
            seeds = [seed for name in sorted(done, key=str) for seed in done[name]]
            self.followed(seeds[: MOST_SWITCHED - self.switched_to])
            self.switched_to += len(seeds)
            if self.switched_to >= MOST_SWITCHED:
                return

    def _met(self, special: SpecialPoint) -> bool:
        """Whether the other branch at a doubling is known, as it ends there."""
        near = MEET * self.question.width
        wanted = {SpecialKind.DOUBLING: SpecialKind.JOINS, SpecialKind.JOINS: SpecialKind.DOUBLING}
        kind = wanted.get(special.kind)
        return any(
            other.kind is kind and _meet(other.value, special.value, near)
            for branch in self.branches
            for other in branch.special
        )

    def look_beyond(self) -> list[tuple[str, Point]]:
        """What motion goes on as just beyond the ends of stable arcs where no other stable arc begins; where
        that is not settled so near to them, farther beyond."""
        ends = {
            (i, up): end
            for i, arc in enumerate(self.arcs)
            for end, up in ((arc.lower, False), (arc.upper, True))
            if arc.stable
            and arc.width > NARROWEST * self.question.width
            and (i, up) not in self.beyond
            and self._open(arc, end, up)
        }
        if self.work.limited and not self.work.left:
            self.work.left_out += len(ends)
            return []
        found: dict[tuple[int, bool], Point] = {}
        for far in BEYOND:
            left = {name: end for name, end in ends.items() if name not in found or not _settled(found[name])}
            tasks = [
                Chain(name, (task,), (1,))
                for name, end in left.items()
                if (task := self._look(name, end, far))
            ]
            self.work.looked(len(tasks))
            found.update(
                (name, point) for name, point in self.done(look, tasks).items() if isinstance(name, tuple)
            )
        self.beyond.update(found)
        return [(BEYOND_END, point) for point in found.values()]

    def _look(self, name: tuple[int, bool], end: ZoneEnd, far: float) -> Look | None:
        value = end.value + (1.0 if name[1] else -1.0) * far * max(abs(end.value), 1e-3)
        if not self.question.lower <= value <= self.question.upper or not isinstance(end.point, SpecialPoint):
            return None
        return Look(self.question, value, end.point.point.state)

    def _open(self, arc: Arc, end: ZoneEnd, up: bool) -> bool:
        """Whether a branch was solved for where an arc ends, and no other stable arc goes on from there."""
        if not isinstance(end.point, SpecialPoint) or end.outside is not None:
            return False
        return next(self.onward(arc, end, up), None) is None

    def onward(self, arc: Arc, end: ZoneEnd, up: bool) -> Iterator[Arc]:
        """Stable arcs that begin where another one ends."""
        near = MEET * self.question.width
        for other in self.stable:
            beside = other.lower if up else other.upper
            if other is not arc and beside.bounded and _meet(beside.value, end.value, near):
                yield other

    def done(self, work: Doing, chains: Sequence[Chain]) -> Mapping[Hashable, Any]:
        """What each task returned."""
        if not chains or self.reason:
            return {}
        outcome = run(work, chains, self.execution)
        self.reason = outcome.reason
        return {name: found[0] for name, found in outcome.results.items() if found}


def _settled(point: Point) -> bool:
    return point.periodic or point.label is MotionKind.APERIODIC


def _meet(one: float, other: float, near: float) -> bool:
    return abs(one - other) <= near
