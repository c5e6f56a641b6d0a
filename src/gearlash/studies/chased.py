"""Aperiodic motion beyond the end of a stable arc, and periodic motion there whose branch is not followed as
the work is spent, followed both ways: does it live beside stable arcs?

So a motion that coexists with a quiet one is found however coarse the axis is."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from gearlash.jobs import Chain, Part
from gearlash.results import Point
from gearlash.system import MotionKind

from .follow_tasks import Question
from .followed import BEYOND_END, LEFT_OUT, Followed
from .point import evaluate
from .seen import HALVED_TO, KnownArcs, Stretch, halved
from .zone import ZoneMotion
from .zone_end import RANGE, Interval, ZoneEnd

FIRST = (
    1e-3  # of the value: how far back it is looked for first; nearer to the end what decays does so slowly
)


@dataclass(frozen=True, eq=False)
class Chase:
    """A task: aperiodic motion found at ``point``, followed from ``value`` upwards (+1) or downwards (-1),
    through windows of periodic motion, until it becomes one of the ``known`` stable motions."""

    question: Question
    point: Point
    value: float
    sign: int
    known: KnownArcs


def chase(task: Chase, carry: object) -> Part:
    """The points to which the motion went on, in this order, and the next one at which it was lost, None
    where the range ends first."""
    q, other, state = task.question, None, task.point.state
    points: list[Point] = []
    family, step = q.source.family(), FIRST * max(abs(task.value), 1e-3)
    value: float | None = task.value + task.sign * step
    while value is not None and q.lower <= value <= q.upper:
        point = evaluate(family, q.values(family, value), q.name, state, None, q.settings, None)[0]
        if point.computed and not task.known.hold(point):
            points.append(point)
            state = point.state
        else:
            other = point
        step *= 2.0 if other is None else 1.0
        value = _next(q, task.sign * step, points[-1] if points else None, other)
    return Part(((tuple(points), other),))


def _next(question: Question, step: float, last: Point | None, other: Point | None) -> float | None:
    """In growing steps until the motion is lost; then by halves."""
    if last is None:
        return None
    if other is None:
        ends = question.lower, question.upper
        return None if last.value in ends else min(max(last.value + step, ends[0]), ends[1])
    narrow = abs(other.value - last.value) <= HALVED_TO * max(abs(other.value), 1e-3)
    return None if narrow else 0.5 * (last.value + other.value)


def chased(followed: Followed, seen: Iterable[Stretch]) -> list[ZoneMotion]:
    """Aperiodic motions that were found beyond the ends of stable arcs and live beside other stable arcs, or
    beside the same one, and that no sweep saw just there."""
    seen, known, ends, chains = list(seen), KnownArcs.of(followed), {}, []
    left_out = {id(point) for point, why in followed.unfollowed if why == LEFT_OUT}
    arcs = [arc for arc in followed.stable if not followed.work.limited or arc.label.impacts == 0]
    for (i, up), point in followed.beyond.items():
        arc = followed.arcs[i]
        end = arc.upper if up else arc.lower
        for sign in (-1, 1):
            near = end.value + sign * FIRST * max(abs(end.value), 1e-3)
            beside = any(each.contains(near) for each in arcs)
            if not (point.label is MotionKind.APERIODIC or id(point) in left_out) or not beside:
                continue
            if not any(s.lower <= near <= s.upper for s in seen):
                ends[i, up, sign] = end
                task = Chase(followed.question, point, end.value, sign, known)
                chains.append(Chain((i, up, sign), (task,), (1,)))
    done = followed.done(chase, chains)
    found = [(ends[name], *parts) for name, parts in done.items() if isinstance(name, tuple)]
    return [_motion(end, points, other) for end, points, other in found if points]


def _motion(end: ZoneEnd, points: Sequence[Point], other: Point | None) -> ZoneMotion:
    """From the end of the arc to where the motion was lost, with the label of all points on the way, or
    aperiodic. Whether it is quiet, a zone says that is asked for one kind of quiet."""
    last, labels = points[-1], {point.label for point in points}
    label = last.label if len(labels) == 1 and last.label else MotionKind.APERIODIC
    if other is None:
        lost = ZoneEnd(last.value, RANGE, inside=label, direction=BEYOND_END)
    else:
        lost = replace(halved(other, last, BEYOND_END), inside=label)
    here = replace(end, inside=label, outside=end.inside)
    low, high = sorted((here, lost), key=lambda one: one.value)
    seen = low.value + low.uncertainty, high.value - high.uncertainty
    return ZoneMotion(label, (BEYOND_END,), *seen, False, Interval(low, high))
