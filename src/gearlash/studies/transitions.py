"""What happens between two neighbouring points of a sweep: every change of the motion, located.

Points are compared as motions, not by their labels. The motion of a point is followed as far as the sweep
goes along with it (`Rail`): the touches, doublings and other special points that it meets are the changes.
Where the sweep has another motion than that, the orbit of one point is followed to the value of the other:
where it arrives at another orbit than the sweep's, the sweep changed to a coexisting one; where it ends, the
other orbit is followed back to there; and where that does not come so far either, the motion between is
looked for, until the interval is as small as `NARROW` asks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches.continuation import (
    ContinuationSettings,
    EndKind,
    EndOfBranch,
    Item,
    Node,
    SpecialPoint,
    walk,
)
from gearlash.branches.continuation.walk import STABLE
from gearlash.orbits import Orbit, Settings, Unresolved, attractor, orbit_at
from gearlash.results import Sweep
from gearlash.system import Family, GearlashError, Label, MotionKind, given, plain_values, short_name

from .model import Model, Source
from .rail import Rail
from .transition import (
    APERIODIC,
    JUMP,
    SAMPLED,
    UNDECIDED,
    UNPROVED,
    Sampled,
    Transition,
    kind_of,
    unlocated,
)
from .zone_end import BASIN

NARROW = 1e-6  # relative width at which halving ends
LONGER = 2  # times the period of the motions: orbits born at doublings are followed so far
DEEPEST = 14  # halvings of one interval
KEPT_MOTIONS = 4  # motions: those of an interval, and some behind
SAME_STATE = 1e-6  # of the size of a motion: within it two states are one
SLACK = 1e-9  # of the value: a change that was solved for lies within
SMALL = 1e-3  # what counts as the size of a small value
LOST = EndKind.SHORT, EndKind.UNBUILT, EndKind.FAR, EndKind.POINTS
AT_END = EndKind.FOLD, EndKind.TOUCH, EndKind.DOUBLING, EndKind.PERIOD, EndKind.UNSTABLE, EndKind.CORNER
"""Ends in the special point that was met last, if no orbit came after it."""
FAILURES = (GearlashError, np.linalg.LinAlgError)
"""What a member that cannot be built or solved raises."""
SHORT_SEARCH = Settings(budget=9_000, patience=600, exponent_periods=1_000)


@dataclass(frozen=True, eq=False)
class _MotionAt:
    """A motion at one parameter value: an orbit, or a label only."""

    value: float
    label: Label
    state: NDArray[np.float64]
    orbit: Orbit | None = None

    def is_at(self, other: _MotionAt) -> bool:
        """Whether two orbits at one value are the same, at whichever base period they begin."""
        one, two = self.orbit, other.orbit
        if one is None or two is None or one.shot.period != two.shot.period:
            return False
        course = one.trace.polynomials[:, 0]
        size = max(float(np.ptp(course, axis=0).max()), SMALL * max(1.0, float(np.abs(course).max())))
        return float(np.abs(two.strobes - one.state).max(axis=1).min()) <= SAME_STATE * size


@dataclass(frozen=True, eq=False)
class _Way:
    """An orbit followed: the changes on the way, in the order in which they were met, where it was last, why
    it was not followed on, and the point it ends at, if one was solved for."""

    changes: tuple[Transition, ...]
    last: _MotionAt
    end: EndOfBranch
    rising: bool
    point: SpecialPoint | None = None

    @property
    def arrived(self) -> bool:
        return self.end.kind is EndKind.ARRIVED


def transitions(
    model: Model,
    name: str,
    points: Sweep | Sequence[Sampled],
    *,
    values: Mapping[str, float | str] | None = None,
    rising: bool = True,
) -> tuple[Transition, ...]:
    """All changes of the motion along the points of a sweep, each solved for.

    Jumps between orbits of one label are among them. An interval with an end that is not periodic is told
    without a point.

    Parameters
    ----------
    model : Case or Family
    name : str
        The parameter that the points go along: a short name, or the physical one of a case.
    points : Sweep or sequence of Sampled
        A sweep, or points of one, ascending, with dimensionless values.
    values : mapping of str to float or str, optional
        Other parameters than ``name``; the model's own where nothing is given.
    rising : bool
        Whether an orbit is followed upwards first, as an up sweep comes along, or downwards.

    Returns
    -------
    tuple of Transition
        Ascending.

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> up = gl.sweep(case, gl.Axis.even("omega", 0.8, 0.825, 3), direction="up")
    >>> [(change.kind, round(change.value, 6)) for change in gl.transitions(case, "omega", up)]
    [('grazing', 0.820631)]
    """
    name, points = short_name(model, Source.of(model).family(), name), _ascending(points)
    found = dict(by_step(model, name, points, values=values, rising=given.truth("rising", rising)))
    return tuple(change for i in sorted(found) for change in found[i])


def by_step(
    model: Model,
    name: str,
    points: Sequence[Sampled],
    *,
    values: Mapping[str, float | str] | None = None,
    rising: bool = True,
    steps: ContinuationSettings = STABLE,
) -> Iterator[tuple[int, list[Transition]]]:
    """The same of one step after the other, as they are followed, with the number of its lower point.
    ``points`` ascend, and ``name`` is a short one. ``steps``: how an orbit is followed."""
    family = Source.of(model).family()
    members = family.complete(plain_values(model, family, values))
    last = points[-1 if rising else 0].value if points else 0.0
    finder = _Finder(family, members, name, rising, last, steps)
    order = range(len(points) - 1)
    for i in order if rising else reversed(order):
        yield i, finder.between(points[i], points[i + 1])


def _ascending(points: Sweep | Sequence[Sampled]) -> tuple[Sampled, ...]:
    """The points of a sweep. Raises `GearlashError` for other things, or where they do not ascend."""
    sampled = points.points if isinstance(points, Sweep) else points
    found = given.items("points", sampled, "a sweep, or the points of one, ascending")
    wrong = [point for point in found if not all(hasattr(point, name) for name in SAMPLED)]
    if wrong:
        raise GearlashError(f"points: expected the points of a sweep, not {given.kind_of(wrong[0])}")
    if not all(below.value < above.value for below, above in pairwise(found)):
        raise GearlashError("points: expected values that ascend, each once")
    return found


@dataclass(eq=False)
class _Finder:
    family: Family
    values: Mapping[str, float]
    name: str
    rising: bool
    last: float
    """The value of the last point that is come to."""
    steps: ContinuationSettings = STABLE
    rail: Rail | None = None
    """What is followed through the points; None where that has to be begun anew."""
    known: dict[float, _MotionAt | None] = field(default_factory=dict)
    """Motions of the last few points, by value."""

    def between(self, below: Sampled, above: Sampled) -> list[Transition]:
        """The changes in the order of the parameter."""
        if not (below.period and above.period):
            self.rail = None
            different = below.label != above.label
            return [self.interval(unlocated(below, above), below, above)] if different else []
        near, far = (below, above) if self.rising else (above, below)
        found = self.along(near, far)
        if found is None:
            found = self.compared(near, far)
        return found if self.rising else found[::-1]

    def along(self, near: Sampled, far: Sampled) -> list[Transition] | None:
        """The changes that the motion of ``near`` meets on its way to ``far``; None where it is not plainly
        that of ``far``."""
        if self.rail is None:
            start = self.motion(near)
            if start is None or start.orbit is None:
                return None
            items = self.followed_from(start, self.last, start.orbit.shot.period * LONGER)
            self.rail = Rail(items, 1.0 if self.rising else -1.0)
        try:
            reached = self.rail.reaches(far.value)
        except FAILURES:
            reached = False
        if not reached:
            return None
        changes, left = self.rail.take(), self.rail.left
        if left is None or left.label != far.label or not self.rail.meets(far.value, far.state):
            return None
        return [self.at_point(p.point, p.before, p.after, self.rising) for p in changes]

    def compared(self, near: Sampled, far: Sampled) -> list[Transition]:
        """The changes between the solved motions of two points; one of one branch is followed on."""
        rail, self.rail = self.rail, None
        one, two = self.motion(near), self.motion(far)
        if one is None or two is None:
            return [self.interval(JUMP if near.label != far.label else UNDECIDED, near, far)]
        there = self.way(one, two.value, self.longest(one, two))
        if there.arrived and there.last.is_at(two):
            self.rail = rail if rail is not None and rail.is_beyond(two.value) else None
            return list(there.changes)
        return list(self.apart(there, one, two, 0))

    def motion(self, point: Sampled) -> _MotionAt | None:
        """The orbit of a point of the sweep, solved for again, once."""
        if point.value not in self.known:
            while len(self.known) > KEPT_MOTIONS:
                del self.known[next(iter(self.known))]
            self.known[point.value] = self.solved(point)
        return self.known[point.value]

    def solved(self, point: Sampled) -> _MotionAt | None:
        try:
            props = flow.propagators(self.family.system(self.at(point.value)))
            orbit = orbit_at(props, point.state, max(1, point.period // props.system.cycles))
        except FAILURES:
            return None
        return None if orbit is None else _MotionAt(point.value, orbit.label, orbit.state, orbit)

    @staticmethod
    def longest(near: _MotionAt, far: _MotionAt) -> int:
        return LONGER * max(motion.orbit.shot.period for motion in (near, far) if motion.orbit)

    def followed(self, near: _MotionAt, far: _MotionAt, depth: int) -> Iterator[Transition]:
        """The changes in the order in which they are met from ``near``."""
        there = self.way(near, far.value, self.longest(near, far))
        if there.arrived and there.last.is_at(far):
            yield from there.changes
        else:
            yield from self.apart(there, near, far, depth)

    def apart(self, there: _Way, near: _MotionAt, far: _MotionAt, depth: int) -> Iterator[Transition]:
        """The same where the way from ``near`` does not lead to ``far``."""
        longest = self.longest(near, far)
        back = self.way(far, near.value if there.arrived else there.last.value, longest)
        if there.arrived and not back.arrived:  # only the other orbit ends on the way
            yield from reversed(list(self.end(back, near)))
        else:
            yield from there.changes
            if there.arrived:
                yield self.interval(BASIN, near, far, there.last.label)
                return
            if not back.arrived:
                yield from self.unknown(there, back, depth)
            elif not back.last.is_at(there.last):
                yield from self.end(there, back.last)
        yield from back.changes[::-1]

    def unknown(self, there: _Way, back: _Way, depth: int) -> Iterator[Transition]:
        """Between the ends of two orbits, neither of which goes as far as the other."""
        near, far = there.last, back.last
        wide = abs(far.value - near.value) > NARROW * max(abs(near.value), abs(far.value))
        middle = self.middle(there, far) if wide and depth < DEEPEST else None
        if middle is None:
            lost = there.end.kind in LOST or back.end.kind in LOST
            if near.label == far.label and lost and there.point is None:
                yield self.interval(UNDECIDED, near, far)
            else:
                yield from self.end(there, far)
        elif middle.orbit is None:
            yield from self.end(there, middle)
            yield from reversed(list(self.end(back, middle)))
        else:
            yield from self.followed(near, middle, depth + 1)
            yield from self.followed(middle, far, depth + 1)

    def middle(self, there: _Way, far: _MotionAt) -> _MotionAt | None:
        """The motion half way from the end of an orbit to ``far``, reached from that orbit."""
        value = 0.5 * (there.last.value + far.value)
        try:
            found = attractor(self.family.system(self.at(value)), there.last.state, SHORT_SEARCH)
        except FAILURES:
            return None
        if isinstance(found, Unresolved):  # too slow to be proved anything: the change is near
            return None
        return _MotionAt(value, found.label, found.final_state, found if isinstance(found, Orbit) else None)

    def followed_from(self, start: _MotionAt, to: float, longest: int) -> Iterator[Item]:
        assert start.orbit is not None
        yield from walk(
            self.family,
            self.at(start.value),
            self.name,
            start.orbit,
            to,
            longest=longest,
            settings=self.steps,
        )

    def way(self, start: _MotionAt, to: float, longest: int) -> _Way:
        """An orbit followed to a value, through doublings up to a period of ``longest`` base periods."""
        last, rising = start, to > start.value
        changes, met = list[Transition](), list[SpecialPoint]()
        try:
            for item in self.followed_from(start, to, longest):
                if isinstance(item, SpecialPoint):
                    met.append(item)
                elif isinstance(item, Node):
                    changes += self.changes(met, item.label, rising)
                    last, met = _MotionAt(item.value, item.label, item.orbit.state, item.orbit), []
                else:
                    point = met.pop() if met and item.kind in AT_END else None
                    label = point.label_before if point else last.label
                    changes += self.changes(met, label, rising)
                    return _Way(tuple(changes), last, item, rising, point)
        except FAILURES as error:
            return _Way(tuple(changes), last, EndOfBranch(EndKind.SHORT, last.value, str(error)), rising)
        raise AssertionError("what is followed has an end")

    def changes(self, met: Sequence[SpecialPoint], label: Label, rising: bool) -> Iterator[Transition]:
        """Points passed one after the other; ``label``: of the motion behind the last."""
        behind = [*(point.label_before for point in met[1:]), label]
        for point, after in zip(met, behind, strict=False):
            yield self.at_point(point, point.label_before, after, rising)

    def at_point(self, point: SpecialPoint, before: Label, after: Label | None, rising: bool) -> Transition:
        """A change that was solved for, with the labels in the order in which it was come to."""
        below, above = (before, after) if rising else (after, before)
        slack = SLACK * max(abs(point.value), SMALL)
        return Transition(
            self.name, kind_of(point), point.value - slack, point.value + slack, below, above, point
        )

    def end(self, way: _Way, beyond: _MotionAt) -> Iterator[Transition]:
        """Where an orbit ends, and what motion there is beyond. A touch after which the orbit is not stable
        is told as the touch of this orbit, and then the jump from it."""
        point = way.point
        end = beyond.value if beyond.value != way.last.value else way.end.value
        jump = (
            JUMP
            if beyond.orbit is not None
            else APERIODIC
            if beyond.label == MotionKind.APERIODIC
            else UNPROVED
        )
        if point is None:
            yield self.joining(jump, (way.last.value, way.last.label), (end, beyond.label))
        elif point.is_grazing:
            yield self.at_point(point, point.label_before, point.label_after, way.rising)
            yield self.joining(jump, (point.value, point.label_after), (end, beyond.label))
        else:
            yield self.at_point(point, point.label_before, beyond.label, way.rising)

    def joining(
        self,
        kind: str,
        one: tuple[float, Label | None],
        two: tuple[float, Label | None],
    ) -> Transition:
        """A change between two values with their labels."""
        (lower, below), (upper, above) = sorted((one, two), key=lambda end: end[0])
        return Transition(self.name, kind, lower, upper, below, above, None)

    def interval(
        self, kind: str, one: _MotionAt | Sampled, two: _MotionAt | Sampled, label: Label | None = None
    ) -> Transition:
        """A change of which only the interval is known; ``label`` is that of the first motion, where it has
        changed since."""
        first = one.value, one.label if label is None else label
        return self.joining(kind, first, (two.value, two.label))

    def at(self, value: float) -> dict[str, float]:
        return {**self.values, self.name: value}
