"""Bands in which motion is not quiet: what lies between the zones that were found."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
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
    """The bands between zones in which every motion found is quiet, in ascending order."""
    loud = _loud(found)
    return tuple(
        Band(low, high, every, _labels(found, loud, low, high))
        for low, high in _between(found)
        for every, low, high in _cut(found, low, high)
    )


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
            lower = one.lower if one.lower.value > band.lower.value else band.lower
            upper = one.upper if one.upper.value < band.upper.value else band.upper
            yield Interval(lower, upper)


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
        motion.stable
        for zone in found.wider
        for motion in zone.motions
        if motion.branch is None and motion.stable is not None and not found.quiet.holds_label(motion.label)
    ]
    return [*arcs, *beside]


def _label_of(one: Interval) -> Label | None:
    """Of the motion that lives there."""
    return one.label if isinstance(one, Arc) else one.lower.inside


def _overlap(one: Interval, low: ZoneEnd, high: ZoneEnd) -> bool:
    """Whether both have more than an end in common."""
    first, last = max(one.lower.value, low.value), min(one.upper.value, high.value)
    return last - first > MEETING * max(abs(first), abs(last))


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
    """A gap in parts in which some motion is quiet, or none."""
    some = [zone for zone in found.wider if zone.upper.value > low.value and zone.lower.value < high.value]
    parts, at = [], low
    for zone in sorted(some, key=lambda one: one.lower.value):
        begin = zone.lower if zone.lower.value > at.value else at
        end = zone.upper if zone.upper.value < high.value else high
        if begin.value > at.value:
            parts.append((True, at, begin))
        if end.value > begin.value:
            parts.append((False, begin, end))
            at = end
    if at.value < high.value:
        parts.append((True, at, high))
    return parts


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
        labels = {end.outside for end in (low, high) if end.outside is not None}
    return tuple(sorted(labels, key=lambda label: (len(label_text(label)), label_text(label))))


def loud_label(found: Zones, point: Point) -> Label | None:
    """Of a motion that a sweep saw and that is not quiet; None of what is quiet, or settled to nothing."""
    known = isinstance(point.label, Signature) or point.label is MotionKind.APERIODIC
    return point.label if known and not found.quiet.holds(point) else None


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
