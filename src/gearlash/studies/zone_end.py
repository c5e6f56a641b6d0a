"""Ends of stable zones as data: what happens there, intervals between two of them, and margins to them."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.branches.continuation import SpecialPoint
from gearlash.results import Point
from gearlash.system import Label, Named, Record, Signature

RANGE, UNKNOWN = "end of the range", "not computed beyond"
"""Kinds of ends that are no change of any motion."""
BASIN = "change of basin"
"""The quiet motion goes on, but the cold start does not lead to it any more. Other kinds are those of
`transitions`.
"""


SEEN = "seen on the grid only"
"""Motion that has no branch, or whose branch could not be followed, was seen at the value of the axis beside
this end: the end lies between it and the next value, as closely as halving told."""


class Quiet(Named):
    """What makes a motion count as quiet: no impact at all, or none on the back side.

    Only proved periodic motions count."""

    IMPACT_FREE = "impact-free"
    DRIVE_SIDE_ONLY = "drive-side-only"

    def holds(self, point: Point) -> bool:
        """Whether a motion of a study is quiet.

        Parameters
        ----------
        point : Point

        Returns
        -------
        bool
        """
        return point.impact_free if self is Quiet.IMPACT_FREE else point.drive_side_only

    def holds_signature(self, signature: Signature) -> bool:
        """Whether a periodic motion is quiet, by what it meets.

        Parameters
        ----------
        signature : Signature

        Returns
        -------
        bool
        """
        return signature.impacts == 0 if self is Quiet.IMPACT_FREE else signature.back_impacts == 0

    def holds_label(self, label: Label) -> bool:
        """Whether a motion is quiet, by its label; what has no period never counts as quiet.

        Parameters
        ----------
        label : Signature or MotionKind

        Returns
        -------
        bool
        """
        return isinstance(label, Signature) and self.holds_signature(label)


@dataclass(frozen=True, eq=False, repr=False)
class ZoneEnd(Record):
    """One end of an interval of quiet motion, and what happens there.

    Parameters
    ----------
    value : float
        Of the parameter, dimensionless.
    kind : str
        Grazing, fold, doubling, Neimark-Sacker or another kind of special point of a branch; that other
        motion was seen on the grid only; the end of the range, or that nothing was computed beyond.
    uncertainty : float
        The end lies within ± this of ``value``.
    inside, outside : Signature or MotionKind, optional
        Labels of the motion on both sides.
    direction : str
        How the motion that changes here was found: by which sweeps, or by what led to its branch.
    point : SpecialPoint, optional
        What was solved for, where it was: of a branch that was followed the first.
    reason : str
        Why there is no label outside, where there is none.

    Examples
    --------
    >>> import gearlash as gl
    >>> print(gl.ZoneEnd(0.5, "end of the range"))
    not bounded within the range
    """

    value: float
    kind: str
    uncertainty: float = 0.0
    inside: Label | None = None
    outside: Label | None = None
    direction: str = ""
    point: SpecialPoint | None = None
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
        what = self.kind
        if self.point is not None and self.point.is_grazing:
            what = f"grazing, {self.point.note}"
        return f"{what}; {self.inside} inside, {self.beyond} outside ({self.direction})"


@dataclass(frozen=True, eq=False, repr=False)
class Interval(Record):
    """An interval of a parameter between two ends.

    Parameters
    ----------
    lower, upper : ZoneEnd

    Examples
    --------
    >>> import gearlash as gl
    >>> lower, upper = gl.ZoneEnd(0.5, "grazing"), gl.ZoneEnd(0.75, "fold")
    >>> gl.Interval(lower, upper).width
    0.25
    """

    lower: ZoneEnd
    upper: ZoneEnd

    @property
    def width(self) -> float:
        """From end to end."""
        return self.upper.value - self.lower.value

    def contains(self, value: float) -> bool:
        """Whether a value lies between the ends, or at one of them.

        Parameters
        ----------
        value : float
            Dimensionless.

        Returns
        -------
        bool
        """
        return self.lower.value <= value <= self.upper.value


@dataclass(frozen=True, eq=False, repr=False)
class Margin(Record):
    """How far a value lies from an end of its zone.

    Parameters
    ----------
    distance : float
        Of the value from the end, less the end's uncertainty; dimensionless.
    percent : float
        The same, of the value; infinite where that is zero.
    end : ZoneEnd
        With the event there.

    Examples
    --------
    >>> import gearlash as gl
    >>> found = gl.zones(gl.load_case("kahraman-singh"), gl.Axis.even("omega", 0.5, 0.9, 3))
    >>> below, above = found.zones[0].margins(0.6)
    >>> below, round(above.distance, 4), round(above.percent, 1), above.end.kind
    (None, 0.108, 18.0, 'fold')
    """

    distance: float
    percent: float
    end: ZoneEnd
