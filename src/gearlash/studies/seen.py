"""Motion that has no branch: aperiodic, unresolved, or periodic with a branch that could not be followed.

It was seen at values of the axis. Where the periodic motion beside it in the same sweep ends in a point that
was solved for, it begins there; elsewhere the interval between the two values is halved."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from gearlash.jobs import Chain, Part
from gearlash.results import Direction, Point, Sweep
from gearlash.system import Label, MotionKind, Signature, Status

from .arcs import Arc
from .follow_tasks import Question
from .followed import MEET, Followed
from .row import Neighbour, continued, neighbour_after
from .zone_end import RANGE, SEEN, UNKNOWN, ZoneEnd

HALVED_TO = 1e-4  # of the value: no label is sharp there, and each costs much
MOST_HALVINGS = 40


@dataclass(frozen=True, eq=False)
class Stretch:
    """Neighbouring points of a sweep, from index ``first`` to ``last``, that lie on no branch."""

    sweep: Sweep
    first: int
    last: int

    @property
    def points(self) -> tuple[Point, ...]:
        return self.sweep.points[self.first : self.last + 1]

    @cached_property
    def label(self) -> Label | None:
        """Of most of its points."""
        labels = [point.label for point in self.points]
        return max(labels, key=labels.count)

    @property
    def missing(self) -> bool:
        """Whether nothing was computed there."""
        return self.points[0].status in (Status.FAILED, Status.NOT_COMPUTED)

    @property
    def stopped(self) -> bool:
        return self.points[0].status is Status.NOT_COMPUTED

    @property
    def lower(self) -> float:
        return self.points[0].value

    @property
    def upper(self) -> float:
        return self.points[-1].value

    def beside(self, side: int) -> tuple[Point | None, Point]:
        """The neighbour outside of it, below (-1) or above (+1), and its own point there."""
        at = self.first - 1 if side < 0 else self.last + 1
        inside = 0 <= at < len(self.sweep.points)
        return self.sweep.points[at] if inside else None, self.points[0 if side < 0 else -1]


def stretches(sweeps: Iterable[Sweep], followed: Followed) -> list[Stretch]:
    """Of every sweep."""
    lost = {id(point) for point, _ in followed.unfollowed}
    found = []
    for sweep in sweeps:
        kinds = [_kind(point, lost) for point in sweep.points]
        for kind, group in groupby(range(len(kinds)), key=kinds.__getitem__):
            if kind:
                members = list(group)
                found.append(Stretch(sweep, members[0], members[-1]))
    return found


def _kind(point: Point, lost: set[int]) -> str:
    if point.periodic and id(point) not in lost:
        return ""
    return str(point.status) if point.status in (Status.FAILED, Status.NOT_COMPUTED) else "seen"


@dataclass(frozen=True)
class KnownArcs:
    """Labels of stable arcs, and where these lie. Periodic motion that is on none of them, as in a window
    within chaos, is not told from aperiodic motion."""

    arcs: tuple[tuple[Signature, float, float], ...]

    @staticmethod
    def of(followed: Followed) -> KnownArcs:
        return KnownArcs(tuple((arc.label, arc.lower.value, arc.upper.value) for arc in followed.stable))

    def hold(self, point: Point) -> bool:
        """Whether a motion is one of theirs, as far as its label tells."""
        return point.periodic and any(
            label == point.label and low <= point.value <= high for label, low, high in self.arcs
        )


@dataclass(frozen=True, eq=False)
class Halve:
    """A task: between a ``periodic`` point of a sweep and its neighbour, which is none; ``way``: what the
    sweep is called."""

    question: Question
    direction: Direction
    way: str
    start: NDArray[np.float64] | None
    periodic: Point
    other: Point
    known: KnownArcs


def halve(task: Halve, carry: object) -> Part:
    """The nearest two values, by the way of the sweep, one with a motion on an arc, one without."""
    q = task.question
    family, periodic, other = q.source.family(), task.periodic, task.other
    for _ in range(MOST_HALVINGS):
        if abs(periodic.value - other.value) <= HALVED_TO * max(abs(periodic.value), 1e-3):
            break
        neighbour = Neighbour(task.start, None)
        if task.direction is not Direction.COLD:
            first = min if task.direction is Direction.UP else max
            neighbour = neighbour_after(neighbour, first(periodic, other, key=lambda point: point.value))
        middle = 0.5 * (periodic.value + other.value)
        point = continued(family, q.values(family, middle), q.name, neighbour, q.settings)
        periodic, other = (point, other) if task.known.hold(point) else (periodic, point)
    return Part(((periodic, other),))


@dataclass(eq=False)
class Onsets:
    """Where stretches begin and end; each is looked for once, where it is asked for. ``start``: of sweeps but
    for those whose own is in ``starts``, by their identity."""

    followed: Followed
    start: NDArray[np.float64] | None
    starts: Mapping[int, NDArray[np.float64]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.known: dict[tuple[int, float, int], ZoneEnd] = {}

    def cell(self, stretch: Stretch, side: int) -> tuple[float, float]:
        """The two values between which a stretch ends, the lower first."""
        outside, own = stretch.beside(side)
        if outside is None or not outside.computed:
            return own.value, own.value
        return min(own.value, outside.value), max(own.value, outside.value)

    def of(self, wanted: Sequence[tuple[Stretch, int]]) -> list[ZoneEnd]:
        """The ends of stretches on one side of each; what must be halved is halved together."""
        tasks = {}
        for stretch, side in wanted:
            key = _key(stretch, side)
            if key in self.known:
                continue
            end = self.solved(stretch, side)
            if end is not None:
                self.known[key] = end
                continue
            outside, own = stretch.beside(side)
            assert outside is not None
            sweep, known = stretch.sweep, KnownArcs.of(self.followed)
            start = self.starts.get(id(sweep), self.start)
            tasks[key] = Halve(self.followed.question, sweep.direction, sweep.way, start, outside, own, known)
        done = self.followed.done(halve, [Chain(key, (task,), (1,)) for key, task in tasks.items()])
        for key, task in tasks.items():
            periodic, other = done.get(key, (task.periodic, task.other))
            self.known[key] = halved(periodic, other, task.way)
        return [self.known[_key(stretch, side)] for stretch, side in wanted]

    def solved(self, stretch: Stretch, side: int) -> ZoneEnd | None:
        """Where the range ends first, or the motion beside it in its sweep; None where it must be halved."""
        outside, own = stretch.beside(side)
        way, label = stretch.sweep.way, stretch.label
        if stretch.missing:
            value = own.value if outside is None or not stretch.stopped else outside.value
            kind = RANGE if outside is None else UNKNOWN
            return ZoneEnd(value, kind, inside=label, direction=way, reason=own.message or "stopped early")
        if outside is None:
            return ZoneEnd(own.value, RANGE, inside=label, direction=way)
        if not outside.periodic:
            return ZoneEnd(own.value, UNKNOWN, inside=label, direction=way, reason=outside.message)
        arc = self.followed.arc_of(self.followed.question.source.family(), outside)
        end = None if arc is None else self.stable_until(arc, -side)
        low, high = self.cell(stretch, side)
        if end is None or not low <= end.value <= high or end.point is None:
            return None
        return replace(end, inside=label, outside=end.inside)

    def stable_until(self, arc: Arc, sign: int) -> ZoneEnd | None:
        """The end of an arc, upwards or downwards, or of what goes on stably from it; None where it is not
        known what motion goes on as."""
        followed, up, passed = self.followed, sign > 0, {id(arc)}
        while True:
            end = arc.upper if up else arc.lower
            after = next((o for o in followed.onward(arc, end, up) if id(o) not in passed), None)
            beyond = followed.beyond.get((followed.arcs.index(arc), up)) if after is None else None
            if beyond is not None and beyond.periodic:
                after = followed.arc_of(followed.question.source.family(), beyond)
            elif after is None and not _aperiodic(beyond) and self.elsewhere(end, sign):
                return None
            if after is None or id(after) in passed or not end.bounded:
                return end
            arc = after
            passed.add(id(arc))

    def elsewhere(self, end: ZoneEnd, sign: int) -> bool:
        """Whether another motion is stable just beyond an end, to which this one may lead."""
        value = end.value + 2.0 * sign * MEET * self.followed.question.width
        return end.bounded and any(arc.contains(value) for arc in self.followed.stable)


def _key(stretch: Stretch, side: int) -> tuple[int, float, int]:
    """Of an end of a stretch: its sweep, the value it was seen at, the side."""
    return id(stretch.sweep), stretch.beside(side)[1].value, side


def _aperiodic(point: Point | None) -> bool:
    return point is not None and point.label is MotionKind.APERIODIC


def halved(periodic: Point, other: Point, direction: str) -> ZoneEnd:
    """The end of motion without a branch, between the two points that are left; ``other`` is of it."""
    middle, half = 0.5 * (periodic.value + other.value), 0.5 * abs(periodic.value - other.value)
    reason = str(other.status) if other.label is None else ""
    return ZoneEnd(
        middle,
        SEEN,
        half,
        inside=other.label,
        outside=periodic.label,
        direction=direction,
        reason=reason,
    )
