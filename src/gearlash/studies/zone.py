"""Stable zones as data: intervals of a parameter, their ends, and who lives in them."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import inf
from typing import ClassVar

from gearlash.branches.continuation import Branch
from gearlash.results import Axis, Sweep
from gearlash.system import Label, MotionKind, Record

from .zone_end import Interval, Margin, Quiet

MEETING = 1e-7  # of the value: intervals that overlap by no more only meet


@dataclass(frozen=True, repr=False)
class ZoneMotion(Record):
    """A motion that was found in a zone.

    Parameters
    ----------
    label : Signature or MotionKind
    directions : tuple of str
        How it was found: sweeps that saw it, or what led to its branch.
    lower, upper : float
        Of the interval in which it is stable, with this label; of a motion without a branch the first and
        the last value of the axis at which it was seen.
    quiet : bool
    stable : Interval, optional
        The interval in which it is stable, with what happens at its ends; None where it has no branch.
    exists : Interval, optional
        The interval in which its whole branch exists, stable or not, under whatever label.
    branch : int, optional
        Its branch among `Zones.branches`.
    assured : tuple of float, optional
        Of quiet motions in zones of every attractor: between these values a stable orbit exists at every
        value, provided that between neighbouring orbits the monodromy strays from the straight line by no
        more than twice as much as it was found to in the middle. None where that was not shown.

    Examples
    --------
    >>> import gearlash as gl
    >>> axis = gl.Axis.even("omega", 0.5, 0.6, 3)
    >>> (zone,) = gl.zones(gl.load_case("kahraman-singh"), axis).zones
    >>> zone.motions[0].directions, zone.motions[0].quiet
    (('cold', 'up', 'down'), True)
    """

    label: Label
    directions: tuple[str, ...]
    lower: float
    upper: float
    quiet: bool
    stable: Interval | None = None
    exists: Interval | None = None
    branch: int | None = None
    assured: tuple[float, float] | None = None

    def beside(self, other: ZoneMotion) -> bool:
        """Whether another motion was found at one of the values of this one; they do not only meet.

        Parameters
        ----------
        other : ZoneMotion

        Returns
        -------
        bool
        """
        low, high = max(self.lower, other.lower), min(self.upper, other.upper)
        if self.branch is None or other.branch is None:
            return low <= high
        return high - low > MEETING * max(abs(low), abs(high))


@dataclass(frozen=True, repr=False)
class Physical(Record):
    """An interval in a physical unit.

    Parameters
    ----------
    name : str
        Of the physical quantity.
    lower, upper : float
    unit : str

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.Physical("pinion_speed", 1000.0, 1500.0, "rpm").unit
    'rpm'
    """

    name: str
    lower: float
    upper: float
    unit: str


@dataclass(frozen=True, eq=False, repr=False)
class Zone(Interval):
    """An interval of a parameter in which motion is quiet.

    Parameters
    ----------
    lower, upper : ZoneEnd
    name : str
        Short name of the parameter.
    quiet : Quiet
        What counts as quiet.
    every : bool
        Whether every attractor that was found is quiet, or at every value at least one of them.
    motions : tuple of ZoneMotion
        All that were seen in it; where two were seen at one value, attractors coexist.
    physical : tuple of Physical
        The interval in physical units.
    unique : bool
        Whether a contraction test proves, at every value of the axis inside and at both ends, that all
        motions come together, so that no other motion exists there. False proves nothing.

    Examples
    --------
    >>> import gearlash as gl
    >>> axis = gl.Axis.even("omega", 0.5, 0.6, 3)
    >>> (zone,) = gl.zones(gl.load_case("kahraman-singh"), axis).zones
    >>> zone.lower.value, zone.upper.value, str(zone.motions[0].label)
    (0.5, 0.6, '1-0-0')
    """

    _printed: ClassVar = ("name", "quiet", "every", "lower", "upper")

    name: str
    quiet: Quiet
    every: bool
    motions: tuple[ZoneMotion, ...] = ()
    physical: tuple[Physical, ...] = ()
    unique: bool = False

    @property
    def coexisting(self) -> tuple[ZoneMotion, ...]:
        """Motions that were seen beside another one at the same value; what is unresolved may be on its
        way to any of them."""
        known = [one for one in self.motions if one.label is not MotionKind.UNRESOLVED]
        return tuple(one for one in known if any(one is not two and one.beside(two) for two in known))

    def margins(self, value: float) -> tuple[Margin | None, Margin | None]:
        """How far a value lies from the ends at which something happens, downwards and upwards.

        Parameters
        ----------
        value : float
            Dimensionless.

        Returns
        -------
        tuple of Margin or None
            None where the range ends first, and outside the zone.
        """
        found: list[Margin | None] = []
        for end, sign in ((self.lower, -1.0), (self.upper, 1.0)):
            apart = sign * (end.value - value) - end.uncertainty
            inside = self.contains(value) and apart >= 0.0
            share = 100.0 * apart / abs(value) if value else inf
            found.append(Margin(apart, share, end) if end.bounded and inside else None)
        return found[0], found[1]

    def margin(self, value: float) -> float:
        """Distance of a value to the nearer end at which something happens, less its uncertainty.

        Parameters
        ----------
        value : float
            Dimensionless.

        Returns
        -------
        float
            Infinite where neither end is bounded within the range, negative outside.
        """
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
    """What was found along an axis: intervals of quiet motion, and how closely was looked.

    Parameters
    ----------
    quiet : Quiet
        What counts as quiet.
    axis : Axis
    zones : tuple of Zone
        Where every attractor found by the sweeps is quiet.
    wider : tuple of Zone
        Where at least one of them is, as far as that reaches beyond the zones of the first kind.
    sweeps : tuple of Sweep
        What they were found from.
    complete : bool
        False where something was not computed.
    message : str
        Why it was not.
    resolution : float
        Step of the axis. Motions that live between two of its values only may have been missed, where no
        branch of another one leads to them.
    step : float
        Widest step between neighbouring orbits of the branches inside the zones.
    branches : tuple of Branch
        Of all motions that were found, each followed once.
    starts : int
        Starts from which motions were looked for.
    not_followed : int
        Periodic motions of these starts whose branches were not followed, as the work was stopped. Where it
        was stopped, no zones are told in which every attractor found is quiet.
    left_out : int
        Motions that were not followed, and ends of motions beyond which was not looked, as the work that was
        allowed for was spent. Such a motion counts at the values of the axis at which sweeps saw it.

    Examples
    --------
    >>> import gearlash as gl
    >>> found = gl.zones(gl.load_case("kahraman-singh"), gl.Axis.even("omega", 0.5, 0.6, 3))
    >>> found.complete, round(found.resolution, 3), found.nearest(0.7)
    (True, 0.05, 0.6)
    """

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
    branches: tuple[Branch, ...] = ()
    starts: int = 0
    not_followed: int = 0
    left_out: int = 0

    def at(self, value: float) -> Zone | None:
        """The zone that holds a value, in which every attractor found is quiet.

        Parameters
        ----------
        value : float
            Dimensionless.

        Returns
        -------
        Zone or None
        """
        return next((zone for zone in self.zones if zone.contains(value)), None)

    def nearest(self, value: float) -> float | None:
        """The nearest value at which every attractor found is quiet.

        Parameters
        ----------
        value : float
            Dimensionless.

        Returns
        -------
        float or None
        """
        held = [min(max(value, zone.lower.value), zone.upper.value) for zone in self.zones]
        return min(held, key=lambda v: abs(v - value), default=None)
