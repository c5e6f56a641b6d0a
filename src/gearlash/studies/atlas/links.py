"""What a curve between two pixels says of their motions: which of them turn into each other there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from gearlash.branches.continuation import Extremum, SpecialKind, SpecialPoint
from gearlash.branches.curves import Curve, CurvePoint
from gearlash.system import Signature


@dataclass(frozen=True)
class Link:
    """One motion turns into the other; ``other`` is None where it only ends, so that whatever attracts there
    takes over, and a period where what begins has that period and any contacts."""

    one: Signature
    other: Signature | int | None


def links_of_step(curve: Curve, points: Sequence[CurvePoint]) -> Iterator[Link]:
    """Of a curve between some of its points, as far as it bounds motions that attract."""
    if not any(point.unstable == 0 and point.admissible for point in points):
        return
    for point in points:
        touch = point.touches[0] if point.touches else None
        yield from links(curve.kind, point.signature, touch)


def links_of_special(special: SpecialPoint, last: bool) -> Iterator[Link]:
    """Of a special point that was met on the way from one pixel to the other; ``last``: the motion ends
    there."""
    if special.kind is SpecialKind.GRAZING:
        yield Link(special.label_before, special.label_after)
    elif special.kind is SpecialKind.JOINS:
        half = _half(special.label_before)
        yield from links(SpecialKind.DOUBLING, half, None)
    else:
        yield from links(special.kind, special.label_before, None)
    if last:
        yield Link(special.label_before, None)


def links(kind: SpecialKind, label: Signature, touch: Extremum | None) -> Iterator[Link]:
    """Of a kind of point, at the orbit with a label; an extremum that touches is not counted in it."""
    if kind is SpecialKind.GRAZING and touch is not None:
        yield Link(label, _more(label, touch))
    elif kind is SpecialKind.DOUBLING:
        # what is born of a linear motion appears at the amplitude that grazes
        yield Link(label, label.twice if label.impacts else 2 * label.period)
    elif kind is not SpecialKind.GRAZING:
        yield Link(label, None)


def connected(one: Signature, other: Signature, found: Iterable[Link]) -> bool:
    """Whether links lead from one motion to the other, or to where one of the two ends."""
    pairs, reached = [*found], {one}
    backward = {other}
    for group in (reached, backward):
        grown = True
        while grown:
            grown = False
            for link in pairs:
                grown |= _grow(group, link, one, other)
    return other in reached or None in reached or None in backward


def _grow(group: set, link: Link, one: Signature, other: Signature) -> bool:
    ends = {link.one}
    if isinstance(link.other, int):
        ends |= {label for label in (one, other) if label.period == link.other}
    else:
        ends.add(link.other)  # pyright: ignore[reportArgumentType]
    if not (ends - {None}) & group or ends <= group:
        return False
    group |= ends
    return True


def _more(label: Signature, touch: Extremum) -> Signature:
    counts = list(label.counts)
    drive, back = counts[touch.clearance]
    counts[touch.clearance] = (drive + (touch.boundary > 0), back + (touch.boundary < 0))
    return Signature(label.period, *counts[0], others=tuple(counts[1:]))


def _half(label: Signature) -> Signature:
    counts = [(drive // 2, back // 2) for drive, back in label.counts]
    return Signature(label.period // 2, *counts[0], others=tuple(counts[1:]))
