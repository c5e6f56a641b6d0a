"""Stable zones as data: intervals of a parameter, their ends, and who lives in them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from math import inf
from typing import ClassVar

from gearlash.branches import BifurcationPoint, GrazingPoint
from gearlash.results import Axis, Point, Sweep
from gearlash.system import Label, MotionKind, Named, Record, Signature

RANGE, UNKNOWN = "end of the range", "not computed beyond"
"""Kinds of ends that are no change of any motion."""
BASIN = "change of basin"
"""The quiet motion goes on, but the cold start does not lead to it any more. Other kinds are those of
`transitions`.
"""


class Quiet(Named):
    """What makes a motion count: no impact at all, or none on the back side. Only proved periodic motions
    count.
    """

    IMPACT_FREE = "impact-free"
    DRIVE_SIDE_ONLY = "drive-side-only"

    def holds(self, point: Point) -> bool:
        """Does it hold for this motion?"""
        return point.impact_free if self is Quiet.IMPACT_FREE else point.drive_side_only

    def holds_signature(self, signature: Signature) -> bool:
        """The same of a periodic motion by what it meets."""
        return signature.impacts == 0 if self is Quiet.IMPACT_FREE else signature.back_impacts == 0


@dataclass(frozen=True, eq=False, repr=False)
class End(Record):
    """One end of an interval: dimensionless value, known within ± ``uncertainty``, and what happens there.

    ``kind`` is grazing, fold, jump, onset of aperiodic motion, no periodic motion proved beyond (see
    `transitions`), change of basin, the end of the range, or that nothing was computed beyond.
    ``inside`` and ``outside`` are the labels; ``reason`` says why there is none outside, where there is none;
    ``direction`` is the sweep whose attractor changes, ``point`` what was solved for, where it was.
    """

    value: float
    kind: str
    uncertainty: float = 0.0
    inside: Label | None = None
    outside: Label | None = None
    direction: str = ""
    point: GrazingPoint | BifurcationPoint | None = None
    reason: str = ""

    @property
    def bounded(self) -> bool:
        """Does something happen here, or did only the range end?"""
        return self.kind not in (RANGE, UNKNOWN)

    @property
    def beyond(self) -> str:
        """The label outside as text, or why there is none."""
        return self.reason if self.outside is None else str(self.outside)

    def __str__(self) -> str:
        if self.kind == RANGE:
            return "not bounded within the range"
        if self.kind == UNKNOWN:
            return f"{self.kind}: {self.reason}"
        what = f"grazing, {self.point.kind}" if isinstance(self.point, GrazingPoint) else self.kind
        return f"{what}; {self.inside} inside, {self.beyond} outside ({self.direction})"


@dataclass(frozen=True, repr=False)
class ZoneMotion(Record):
    """A motion seen from ``lower`` to ``upper`` (values of the axis) by sweeps of these ``directions``."""

    label: Label
    directions: tuple[str, ...]
    lower: float
    upper: float
    quiet: bool


@dataclass(frozen=True, repr=False)
class Physical(Record):
    """An interval in a physical unit."""

    name: str
    lower: float
    upper: float
    unit: str


@dataclass(frozen=True, eq=False, repr=False)
class Interval(Record):
    """Between two ends."""

    lower: End
    upper: End

    @property
    def width(self) -> float:
        return self.upper.value - self.lower.value

    def contains(self, value: float) -> bool:
        return self.lower.value <= value <= self.upper.value


@dataclass(frozen=True, eq=False, repr=False)
class Zone(Interval):
    """An interval of ``name`` in which motion is quiet: for every attractor that was found (``every``), or
    at every value for at least one of them.

    ``motions`` are all motions that were seen in it; where two were seen at one value, attractors coexist.
    """

    _printed: ClassVar = ("name", "quiet", "every", "lower", "upper")

    name: str
    quiet: Quiet
    every: bool
    motions: tuple[ZoneMotion, ...] = ()
    physical: tuple[Physical, ...] = ()

    @property
    def coexisting(self) -> tuple[ZoneMotion, ...]:
        """Motions that were seen beside another one at the same value; what is unresolved may be on its
        way to any of them."""
        known = [one for one in self.motions if one.label is not MotionKind.UNRESOLVED]
        return tuple(
            one
            for one in known
            if any(one is not two and one.lower <= two.upper and two.lower <= one.upper for two in known)
        )

    def margin(self, value: float) -> float:
        """Distance of a value inside to the nearer end at which something happens, less its uncertainty;
        infinite where neither end is bounded within the range, negative outside."""
        below = value - self.lower.value - self.lower.uncertainty if self.lower.bounded else inf
        above = self.upper.value - self.upper.uncertainty - value if self.upper.bounded else inf
        if not self.contains(value):
            return -max(self.lower.value - value, value - self.upper.value)
        return min(below, above)

    def __str__(self) -> str:
        who = "every attractor found" if self.every else "at least one attractor found"
        shown = f"{self.quiet} for {who}: {self.name} from {self.lower.value:.6g} ({self.lower})"
        shown += f" to {self.upper.value:.6g} ({self.upper})"
        for p in self.physical:
            shown += f"; {p.name} {p.lower:.6g} to {p.upper:.6g} {p.unit}"
        return shown


@dataclass(frozen=True, eq=False, repr=False)
class Zones(Record):
    """``zones``: where every attractor found by the sweeps is quiet. ``wider``: intervals where at least
    one of them is, as far as they reach beyond a zone of the first kind. A zone narrower than ``resolution``
    (the step of the axis) may have been missed, and so may other motions that live between two values of
    the axis only; inside the zones quiet motion was followed in steps of ``step`` at the most, and an
    interruption narrower than that may have been missed. ``complete`` is False where something was not
    computed, ``message`` says why."""

    _printed: ClassVar = ("quiet", "axis", "zones", "wider", "complete", "message")

    quiet: Quiet
    axis: Axis
    zones: tuple[Zone, ...]
    wider: tuple[Zone, ...]
    sweeps: tuple[Sweep, ...]
    complete: bool = True
    message: str = ""
    resolution: float = field(default=0.0)
    step: float = field(default=0.0)

    def at(self, value: float) -> Zone | None:
        """The zone (for every attractor) that holds a value."""
        return next((zone for zone in self.zones if zone.contains(value)), None)

    def nearest(self, value: float) -> float | None:
        """The value nearest to this one at which every attractor found is quiet."""
        held = [min(max(value, zone.lower.value), zone.upper.value) for zone in self.zones]
        return min(held, key=lambda v: abs(v - value), default=None)


def intersection(rows: Sequence[Iterable[Interval]]) -> list[Interval]:
    """Where all rows have an interval."""
    found = list(rows[0])
    for row in rows[1:]:
        row, pairs = list(row), []
        for a in found:
            for b in row:
                lower = a.lower if a.lower.value >= b.lower.value else b.lower
                upper = a.upper if a.upper.value <= b.upper.value else b.upper
                pairs.append(Interval(lower, upper))
        found = [pair for pair in pairs if pair.width > 0.0]
    return sorted(found, key=lambda interval: interval.lower.value)


def union(rows: Sequence[Iterable[Interval]]) -> list[Interval]:
    """Where some row has an interval; what overlaps or touches is one."""
    found: list[Interval] = []
    for interval in sorted((i for row in rows for i in row), key=lambda i: i.lower.value):
        if found and interval.lower.value <= found[-1].upper.value:
            upper = max(found[-1].upper, interval.upper, key=lambda end: end.value)
            found[-1] = Interval(found[-1].lower, upper)
        else:
            found.append(interval)
    return found
