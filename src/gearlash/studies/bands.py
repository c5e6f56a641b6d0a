"""Bands in which motion is not quiet: between the zones that were found, as far as such motion was."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from math import inf

from gearlash.results import Point
from gearlash.system import Label, MotionKind, Signature, label_text

from .arcs import Arc, arcs_of
from .intervals import union
from .zone import MEETING, Zone, Zones
from .zone_end import RANGE, SEEN, Interval, ZoneEnd


@dataclass(frozen=True, eq=False)
class Band:
    """An interval of a parameter in which a motion was found that is not quiet.

    Parameters
    ----------
    lower, upper : ZoneEnd
        As those of zones.
    every : bool
        Whether no motion that was found in it is quiet; otherwise a quiet one was found beside it.
    labels : tuple of Signature or MotionKind
        Of the motions found in it that are not quiet: seen by a sweep, or followed into it.
    """

    lower: ZoneEnd
    upper: ZoneEnd
    every: bool
    labels: tuple[Label, ...]

    def contains(self, value: float) -> bool:
        """Whether a value lies in it, or at one of its ends."""
        return self.lower.value <= value <= self.upper.value


def bands(found: Zones) -> tuple[Band, ...]:
    """Between zones in which every motion found is quiet: where motion was found that is not, in ascending
    order."""
    loud = _loud(found)
    return tuple(
        Band(low, high, every, _labels(found, loud, low, high))
        for part in _gaps(found, loud)
        if part.loud
        for every, low, high in _cut(found, part.lower, part.upper)
    )


def not_told(found: Zones) -> tuple[Interval, ...]:
    """What is neither such a zone nor such a band: no motion was followed through it, or something settled to
    nothing, and no sweep shows motion in it that is not quiet."""
    return tuple(Interval(one.lower, one.upper) for one in _gaps(found, _loud(found)) if not one.loud)


def back_bands(found: Zones, boundary: float) -> tuple[Band, ...]:
    """Bands in which a motion that was found meets the back side, whose boundary lies at this X.

    ``found`` are zones free of impacts there. What has no period is in none of them, whatever it meets: such
    motion counts at the values of the axis at which it was seen to reach the boundary, and the band ends
    there. So does periodic motion whose branch was not followed.
    """
    loud = _loud(found)
    return tuple(
        Band(one.lower, one.upper, band.every, _labels(found, loud, one.lower, one.upper, boundary))
        for band in bands(found)
        for one in union([_followed_in(band, loud), _seen_in(found, band, loud, boundary)])
    )


def _followed_in(band: Band, loud: Sequence[Interval]) -> Iterator[Interval]:
    """The parts of a band in which periodic motion lives that was followed."""
    for one in loud:
        if isinstance(_label_of(one), Signature) and _overlap(one, band.lower, band.upper):
            yield Interval(*_inside(one, band.lower, band.upper))


def _seen_in(found: Zones, band: Band, loud: Sequence[Interval], boundary: float) -> Iterator[Interval]:
    """The values of the axis in a band, neighbour by neighbour, at which a sweep saw motion that reaches the
    boundary and was not followed."""
    periodic = [one for one in loud if isinstance(_label_of(one), Signature)]
    for sweep in found.sweeps:

        def reaches(point: Point) -> bool:
            known = any(_label_of(one) == point.label and one.contains(point.value) for one in periodic)
            reached = not found.quiet.holds(point) and point.minimum <= boundary
            return band.contains(point.value) and reached and not known

        for there, group in groupby(sweep.points, reaches):
            if there:
                values = [point.value for point in group]
                low, high = (ZoneEnd(value, SEEN, direction=sweep.way) for value in (values[0], values[-1]))
                yield Interval(low, high)


def _loud(found: Zones) -> list[Interval]:
    """Where motions that were found and are not quiet live, under one label each: stable arcs of branches,
    and motions beside quiet ones that have none."""
    arcs = [
        arc
        for number, branch in enumerate(found.branches)
        for arc in arcs_of(branch, number)
        if arc.stable and not found.quiet.holds_signature(arc.label)
    ]
    beside = [
        Interval(*(replace(end, inside=motion.label) for end in (motion.stable.lower, motion.stable.upper)))
        for zone in found.wider
        for motion in zone.motions
        if motion.branch is None and motion.stable is not None and _known_loud(found, motion.label)
    ]
    return [*arcs, *beside]


def _label_of(one: Interval) -> Label | None:
    """Of the motion that lives there."""
    return one.label if isinstance(one, Arc) else one.lower.inside


def _overlap(one: Interval, low: ZoneEnd, high: ZoneEnd) -> bool:
    """Whether both have more than an end in common."""
    first, last = max(one.lower.value, low.value), min(one.upper.value, high.value)
    return last - first > MEETING * max(abs(first), abs(last))


@dataclass(frozen=True, eq=False)
class _Part(Interval):
    """Of a gap between zones: whether motion was found in it that is not quiet."""

    loud: bool


def _gaps(found: Zones, loud: Sequence[Interval]) -> list[_Part]:
    """What zones leave of the axis, in parts. Where no value of the axis lies between a part with such motion
    and what is beside it, nothing was looked at, and it counts with that part."""
    parts = []
    for low, high in _between(found):
        near = MEETING * max(abs(low.value), abs(high.value))
        rows = _clipped(loud, low, high), _seen_loud(found, low, high), _at_ends(found, low, high)
        known: list[Interval] = []
        at = low
        for one in union(rows, near):
            last = known[-1] if known else None
            if _looked_at(found, at, one.lower, last is None):
                known.append(one)
            else:
                known[-1:] = [Interval(low if last is None else last.lower, one.upper)]
            at = known[-1].upper
        if known and not _looked_at(found, at, high, False, True):
            known[-1] = Interval(known[-1].lower, high)
        at = low
        for one in known:
            if one.lower.value - at.value > near:
                parts.append(_Part(at, one.lower, False))
            parts.append(_Part(one.lower, one.upper, True))
            at = one.upper
        if high.value - at.value > near:
            parts.append(_Part(at, high, False))
    return parts


def _looked_at(found: Zones, low: ZoneEnd, high: ZoneEnd, first: bool = False, last: bool = False) -> bool:
    """Whether a value of the axis lies between two ends; at the ``first`` or ``last`` one of a gap, too."""
    values = found.axis.values
    above = values >= low.value if first else values > low.value
    below = values <= high.value if last else values < high.value
    return bool((above & below).any())


def _clipped(intervals: Sequence[Interval], low: ZoneEnd, high: ZoneEnd) -> Iterator[Interval]:
    """The parts of intervals between two ends."""
    for one in intervals:
        if _overlap(one, low, high):
            yield Interval(*_inside(one, low, high))


def _seen_loud(found: Zones, low: ZoneEnd, high: ZoneEnd) -> Iterator[Interval]:
    """Between two ends, neighbouring values of the axis at which a sweep saw motion that is not quiet."""
    return _runs(found, low, high, lambda point: loud_label(found, point) is not None)


def _runs(found: Zones, low: ZoneEnd, high: ZoneEnd, holds: Callable[[Point], bool]) -> Iterator[Interval]:
    """Between two ends, neighbouring values of the axis at which something holds in a sweep."""
    for sweep in found.sweeps:

        def there(point: Point) -> bool:
            return low.value <= point.value <= high.value and holds(point)

        for yes, group in groupby(sweep.points, there):
            if yes:
                values = sorted(point.value for point in group)
                ends = (ZoneEnd(value, SEEN, direction=sweep.way) for value in (values[0], values[-1]))
                yield Interval(*ends)


def _at_ends(found: Zones, low: ZoneEnd, high: ZoneEnd) -> Iterator[Interval]:
    """Ends of zones at which motion goes on as one that is not quiet."""
    for end in (low, high):
        if end.outside is not None and _known_loud(found, end.outside):
            yield Interval(end, end)


def _between(found: Zones) -> list[tuple[ZoneEnd, ZoneEnd]]:
    """The complement of the zones within the axis."""
    first, last = float(found.axis.values[0]), float(found.axis.values[-1])
    at, gaps = ZoneEnd(first, RANGE), []
    for zone in sorted(found.zones, key=lambda one: one.lower.value):
        if zone.lower.value > at.value:
            gaps.append((at, zone.lower))
        at = zone.upper
    if at.value < last:
        gaps.append((at, ZoneEnd(last, RANGE)))
    return gaps


def _cut(found: Zones, low: ZoneEnd, high: ZoneEnd) -> list[tuple[bool, ZoneEnd, ZoneEnd]]:
    """A band in parts in which some motion is quiet, followed there or seen by a sweep, or none."""
    followed = [Interval(*_inside(one, low, high)) for one in found.wider if _shares(one, low, high)]
    seen = list(_runs(found, low, high, found.quiet.holds))
    parts, at = [], low
    for one in union([followed, seen]):
        if one.lower.value > at.value:
            parts.append((True, at, one.lower))
        parts.append((False, one.lower, one.upper))
        at = one.upper
    if at.value < high.value or not parts:
        parts.append((True, at, high))
    return parts


def _shares(one: Interval, low: ZoneEnd, high: ZoneEnd) -> bool:
    """Whether an interval has more than an end in common with another, or holds all of one without width."""
    if low.value == high.value:
        return one.contains(low.value)
    return one.upper.value > low.value and one.lower.value < high.value


def _inside(one: Interval, low: ZoneEnd, high: ZoneEnd) -> tuple[ZoneEnd, ZoneEnd]:
    """The ends of an interval between two ends."""
    lower = one.lower if one.lower.value > low.value else low
    return lower, one.upper if one.upper.value < high.value else high


def _labels(
    found: Zones, loud: Sequence[Interval], low: ZoneEnd, high: ZoneEnd, least: float = inf
) -> tuple[Label, ...]:
    """Of motions that live in a band, whether sweeps saw them in it or they were followed into it. Where a
    displacement of ``least`` or less is asked for, those without a period count where they were seen with it.
    What settled to nothing is no motion."""
    inside = [label for one in loud if _overlap(one, low, high) and (label := _label_of(one))]
    labels = {label for label in inside if least == inf or isinstance(label, Signature)}
    labels |= {
        label
        for sweep in found.sweeps
        for point in sweep.points
        if low.value <= point.value <= high.value
        and (label := loud_label(found, point)) is not None
        and not point.minimum > least
    }
    if not labels:  # narrower than a step of the axis
        ends = (end.outside for end in (low, high))
        labels = {label for label in ends if label is not None and _known_loud(found, label)}
    return tuple(sorted(labels, key=lambda label: (len(label_text(label)), label_text(label))))


def loud_label(found: Zones, point: Point) -> Label | None:
    """Of a motion that a sweep saw and that is not quiet; None of what is quiet, or settled to nothing."""
    label = point.label
    return label if label is not None and _is_motion(label) and not found.quiet.holds(point) else None


def _is_motion(label: Label) -> bool:
    """What settled to nothing is none."""
    return isinstance(label, Signature) or label is MotionKind.APERIODIC


def _known_loud(found: Zones, label: Label) -> bool:
    """Whether it is of a motion that is not quiet."""
    return _is_motion(label) and not found.quiet.holds_label(label)


def living_at(found: Zones, value: float) -> tuple[Label, ...]:
    """Labels of the motions that are not quiet and were found at a value: followed there, or seen there by a
    sweep."""
    labels = [label for one in _loud(found) if one.contains(value) and (label := _label_of(one))]
    for sweep in found.sweeps:
        at = [point for point in sweep.points if point.value == value]
        labels += [label for point in at if (label := loud_label(found, point)) is not None]
    return tuple(dict.fromkeys(labels))


def zone_with(found: Zones, value: float) -> Zone | None:
    """The zone that holds a value: in which every motion found is quiet, else in which some is."""
    own = found.at(value)
    return own or next((zone for zone in found.wider if zone.contains(value)), None)
