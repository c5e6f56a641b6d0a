"""What happens between two neighbouring points of a sweep: every change of the motion, located.

Points are compared as motions, not by their labels. Where one step along the branch leads from one
to the next, nothing changes between them. Elsewhere the orbit of one is followed to the value of the other
(`branches.follow`): the touches, doublings and folds on the way are the changes, each solved for. Where it
arrives at another orbit than the sweep's, the sweep changed to a coexisting one; where it ends, the other
orbit is followed back to there; and where that does not come so far either, the motion between is looked
for, until the interval is as small as `NARROW` asks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches import (
    GrazingPoint,
    Node,
    Outcome,
    PathEnd,
    SolvedPoint,
    follow,
    joins,
)
from gearlash.orbits import Orbit, Settings, Unresolved, attractor, orbit_at
from gearlash.results import Sweep
from gearlash.system import Family, GearlashError, Label, MotionKind, given, plain_values, short_name

from .model import Model, Source
from .smooth import plainly_one
from .transition import (
    APERIODIC,
    GRAZING,
    JUMP,
    SAMPLED,
    UNDECIDED,
    UNPROVED,
    Sampled,
    Transition,
    kind_of,
    kind_of_end,
    unlocated,
)
from .zone import BASIN

NARROW = 1e-6  # relative width at which halving ends
DEEPEST = 14  # halvings of one interval
KEPT_MOTIONS = 4  # motions: those of an interval, and two behind
SAME_STATE = 1e-6  # of an orbit's ranges: within it two states are one
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

    @staticmethod
    def of(node: Node) -> _MotionAt:
        return _MotionAt(node.value, node.label, node.state, node.orbit)

    @cached_property
    def node(self) -> Node | None:
        return None if self.orbit is None else Node(self.value, self.orbit)

    def is_at(self, other: _MotionAt) -> bool:
        """Whether two orbits at one value are the same, at whichever base period they begin."""
        one, two = self.orbit, other.orbit
        if one is None or two is None or one.shot.period != two.shot.period:
            return False
        node = Node(self.value, one)
        return min(node.apart(state) for state in two.strobes) <= SAME_STATE


@dataclass(frozen=True, eq=False)
class _Way:
    """An orbit followed: the changes on the way, in the order in which they were met, where it was last, and,
    if it did not arrive, the point it ends at (None: not solved for) and the nearest value beyond its end."""

    changes: tuple[Transition, ...]
    last: _MotionAt
    outcome: Outcome
    beyond: float
    point: SolvedPoint | None = None

    @property
    def arrived(self) -> bool:
        return self.outcome is Outcome.ARRIVED


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
    family = Source.of(model).family()
    name = short_name(model, family, name)
    members = family.complete(plain_values(model, family, values))
    finder = _Finder(family, members, name, given.truth("rising", rising))
    points = _ascending(points)
    found: dict[int, list[Transition]] = {}
    order = range(len(points) - 1)
    for i in order if finder.rising else reversed(order):
        if plainly_one(points, i):
            finder.passed(points[i] if finder.rising else points[i + 1])
        else:
            found[i] = finder.between(points[i], points[i + 1])
    return tuple(change for i in sorted(found) for change in found[i])


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


@dataclass(frozen=True, eq=False)
class _Finder:
    family: Family
    values: Mapping[str, float]
    name: str
    rising: bool
    trail: list[Sampled] = field(default_factory=list)
    """Points of the sweep on one branch with the one where the next interval begins, the last first."""
    known: dict[float, _MotionAt | None] = field(default_factory=dict)
    """Motions of the last few points, by value."""

    def between(self, below: Sampled, above: Sampled) -> list[Transition]:
        """The changes in the order of the parameter."""
        found = self.compared(below, above)
        near = below if self.rising else above
        if found or not (below.period and above.period):
            self.trail.clear()
        else:
            self.passed(near)
        return found

    def passed(self, point: Sampled) -> None:
        """The next interval begins on one branch with a point."""
        self.trail[:] = [point, *self.trail[:1]]

    def compared(self, below: Sampled, above: Sampled) -> list[Transition]:
        if not (below.period and above.period):
            different = below.label != above.label
            return [self.interval(unlocated(below, above), below, above)] if different else []
        near, far = (self.motion(p) for p in ((below, above) if self.rising else (above, below)))
        if near is None or far is None:
            return [self.interval(JUMP if below.label != above.label else UNDECIDED, below, above)]
        if near.label == far.label and self.goes_on(near, far):
            return []
        found = list(self.followed(near, far, 0))
        return found if self.rising else found[::-1]

    def goes_on(self, near: _MotionAt, far: _MotionAt) -> bool:
        """Whether one step along the branch of the points before leads from one to the other: then it need
        not be followed."""
        behind = [motion.node if (motion := self.motion(point)) else None for point in self.trail]
        earlier = tuple(node for node in behind if node is not None)
        if len(earlier) < len(behind) or near.node is None or far.node is None:
            return False
        return joins(self.family, self.values, self.name, near.node, earlier, far.node)

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

    def followed(self, near: _MotionAt, far: _MotionAt, depth: int) -> Iterator[Transition]:
        """The changes in the order in which they are met from ``near``."""
        longest = 2 * max(motion.orbit.shot.period for motion in (near, far) if motion.orbit)
        there = self.way(near, far.value, longest)
        if there.arrived and there.last.is_at(far):
            yield from there.changes
            return
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
            lost = {there.outcome, back.outcome} & {Outcome.LOST, Outcome.UNBUILT}
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
        value = 0.5 * (there.beyond + far.value)
        try:
            found = attractor(self.family.system(self.at(value)), there.last.state, SHORT_SEARCH)
        except FAILURES:
            return None
        if isinstance(found, Unresolved):  # too slow to be proved anything: the change is near
            return None
        return _MotionAt(value, found.label, found.final_state, found if isinstance(found, Orbit) else None)

    def way(self, start: _MotionAt, to: float, longest: int) -> _Way:
        """An orbit followed to a value, through doublings up to a period of ``longest`` base periods."""
        assert start.orbit is not None
        if start.value == to:
            return _Way((), start, Outcome.ARRIVED, to)
        changes: list[Transition] = []
        point = None
        for step in follow(
            self.family, self.name, start.orbit, to, values=self.at(start.value), longest=longest
        ):
            if isinstance(step, PathEnd):
                return _Way(tuple(changes), _MotionAt.of(step.last), step.outcome, step.beyond, point)
            if step.after is None:
                point = step.point
            else:
                changes.append(self.change(step.point, step.before, step.after))
        raise AssertionError("what is followed ends with a PathEnd")

    def change(self, point: SolvedPoint, before: Node, after: Node) -> Transition:
        """A point that the orbit passes."""
        below, above = sorted((before, after), key=lambda node: node.value)
        lower, upper = min(below.value, point.value), max(above.value, point.value)
        return Transition(self.name, kind_of(point), lower, upper, below.label, above.label, point)

    def end(self, way: _Way, beyond: _MotionAt) -> Iterator[Transition]:
        """Where an orbit ends, and what motion there is beyond. A touch after which the orbit is not stable
        is told as the touch of this orbit, and then the jump from it."""
        last, point = (way.last.value, way.last.label), way.point
        end = beyond.value if beyond.value != way.last.value else way.beyond
        jump = (
            JUMP
            if beyond.orbit is not None
            else APERIODIC
            if beyond.label == MotionKind.APERIODIC
            else UNPROVED
        )
        if isinstance(point, GrazingPoint):
            label = point.label_above if end > last[0] else point.label_below
            if label is not MotionKind.NONE:
                yield self.joining(GRAZING, last, (point.value, label), point)
                yield self.joining(jump, (point.value, label), (end, beyond.label))
                return
        kind = kind_of_end(point, way.outcome) or jump
        yield self.joining(kind, last, (end, beyond.label), point)

    def joining(
        self,
        kind: str,
        one: tuple[float, Label | None],
        two: tuple[float, Label | None],
        point: SolvedPoint | None = None,
    ) -> Transition:
        """A change between two values with their labels."""
        (lower, below), (upper, above) = sorted((one, two), key=lambda end: end[0])
        return Transition(self.name, kind, lower, upper, below, above, point)

    def interval(
        self, kind: str, one: _MotionAt | Sampled, two: _MotionAt | Sampled, label: Label | None = None
    ) -> Transition:
        """A change of which only the interval is known; ``label`` is that of the first motion, where it has
        changed since."""
        first = one.value, one.label if label is None else label
        return self.joining(kind, first, (two.value, two.label))

    def at(self, value: float) -> dict[str, float]:
        return {**self.values, self.name: value}
