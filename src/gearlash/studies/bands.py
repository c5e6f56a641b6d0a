"""Bands in which motion is not quiet: what lies between the zones that were found."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.system import Label, Signature, label_text

from .zone import Zone, Zones
from .zone_end import RANGE, SEEN, ZoneEnd


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
        Of the motions that are not quiet, as sweeps and ends show them; none where nothing was seen.
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
    return tuple(
        Band(low, high, every, _labels(found, low, high))
        for low, high in _between(found)
        for every, low, high in _cut(found, low, high)
    )


def back_bands(found: Zones, boundary: float) -> tuple[Band, ...]:
    """Bands in which a motion that was found meets the back side, whose boundary lies at this X.

    ``found`` are zones free of impacts there. What has no period is in none of them, whatever it meets: such
    motion counts at the values of the axis at which it was seen to reach the boundary, and the band ends
    there.
    """
    met = []
    for band in bands(found):
        points = [
            point
            for sweep in found.sweeps
            for point in sweep.points
            if band.contains(point.value) and not found.quiet.holds(point) and point.minimum <= boundary
        ]
        periodic = all(isinstance(label, Signature) for label in band.labels)
        if periodic and band.labels:
            met.append(band)
        elif points:
            low, high = (pick(point.value for point in points) for pick in (min, max))
            labels = tuple(dict.fromkeys(point.label for point in points if point.label is not None))
            met.append(Band(ZoneEnd(low, SEEN), ZoneEnd(high, SEEN), band.every, labels))
    return tuple(met)


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


def _labels(found: Zones, low: ZoneEnd, high: ZoneEnd) -> tuple[Label, ...]:
    labels: dict[Label, None] = {}
    for sweep in found.sweeps:
        for point in sweep.points:
            inside = low.value <= point.value <= high.value
            if inside and point.label is not None and not found.quiet.holds(point):
                labels[point.label] = None
    if not labels:  # narrower than a step of the axis
        labels = {end.outside: None for end in (low, high) if end.outside is not None}
    return tuple(sorted(labels, key=lambda label: (len(label_text(label)), label_text(label))))


def zone_with(found: Zones, value: float) -> Zone | None:
    """The zone that holds a value: in which every motion found is quiet, else in which some is."""
    own = found.at(value)
    return own or next((zone for zone in found.wider if zone.contains(value)), None)
