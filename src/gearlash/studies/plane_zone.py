"""A zone in a plane of two parameters as data: the curves that bound it, and margins to them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import SpecialKind, SpecialPoint
from gearlash.branches.curves import CodimTwoPoint, Curve, CurvePoint
from gearlash.system import Record, Signature, given

from .zone_end import Quiet


@dataclass(frozen=True, eq=False, repr=False)
class BoundaryPart(Record):
    """A piece of a curve that bounds the zone.

    Attributes
    ----------
    kind : SpecialKind
        What happens where it is crossed.
    event : str
        The same in words.
    points : tuple of CurvePoint
        The orbits that were solved for on it, from end to end.
    ends : tuple of CodimTwoPoint or None
        Where another curve takes over; None at the rectangle, and where it closes.
    curve : Curve
        The whole curve that it is of.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> limits = {"lower": (0.78, 0.9), "upper": (0.85, 1.1)}
    >>> zone = gl.plane_zone(case, ("omega", "D"), **limits, values={"omega": 0.8}, lines=0)
    >>> [str(part.kind) for part in zone.parts]
    ['grazing']
    """

    _printed: ClassVar = ("kind", "event", "points")

    kind: SpecialKind
    event: str
    points: tuple[CurvePoint, ...]
    ends: tuple[CodimTwoPoint | None, CodimTwoPoint | None]
    curve: Curve

    @property
    def values(self) -> NDArray[np.float64]:
        """Values of the two parameters, of shape (m, 2)."""
        return np.array([point.values for point in self.points])


@dataclass(frozen=True, repr=False)
class AxisMargin(Record):
    """How far the operating point lies from where the zone ends along one parameter.

    Attributes
    ----------
    name : str
        Short name of the parameter.
    upward : bool
    distance : float
        Dimensionless; to the limit of the rectangle where nothing happens before.
    percent : float
        The same, of the value; infinite where that is zero.
    value : float
        Of the parameter where the zone ends.
    event : str
        What happens there.
    bounded : bool
        Whether something does: False where only the rectangle ends, or the search was stopped, so that the
        margin is at least this.
    physical : tuple of (str, float, str)
        Name, distance and unit, for every physical way to name the parameter.
    point : SpecialPoint or None
        What was solved for.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.AxisMargin("omega", True, 0.1, 10.0, 1.1, "fold", True).percent
    10.0
    """

    _printed: ClassVar = ("name", "upward", "distance", "percent", "value", "event", "bounded")

    name: str
    upward: bool
    distance: float
    percent: float
    value: float
    event: str
    bounded: bool
    physical: tuple[tuple[str, float, str], ...] = ()
    point: SpecialPoint | None = None


@dataclass(frozen=True, repr=False)
class ToleranceMargin(Record):
    """By what number all tolerances together can be multiplied before the boundary is touched.

    Attributes
    ----------
    norm : str
        ``box``: both parameters anywhere within ± their tolerance, the largest of |Δp|/tolerance counts.
        ``ellipse``: the root of the sum of the squares of Δp/tolerance counts.
    multiple : float
        The smallest one at which the box or ellipse around the operating point touches the boundary. Below 1
        the tolerances do not fit into the zone.
    values : tuple of float
        Of the two parameters where it does, solved for on the curve.
    event : str
    bounded : bool
        False where the rectangle is met before any boundary: then the multiple is at least this.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.ToleranceMargin("box", 2.5, (0.9, 1.0), "fold", True).multiple
    2.5
    """

    norm: str
    multiple: float
    values: tuple[float, float]
    event: str
    bounded: bool


@dataclass(frozen=True, eq=False, repr=False)
class PlaneZone(Record):
    """The part of a plane around an operating point in which its quiet orbit exists and is stable.

    Where it was followed to (``lines``), the orbit was solved for, with its multipliers and its extrema, from
    each place to the next; on the curves of the boundary every point was. What lies between the lines follows
    by continuity, unless a boundary was missed that meets none of them: ``complete`` says whether all that
    were met fit together. Other motions may coexist: nothing is said of them.

    Attributes
    ----------
    names : tuple of str
        Short names of the two parameters.
    at : tuple of float
        The operating point.
    lower, upper : tuple of float
        The rectangle.
    quiet : Quiet
    label : Signature
        Of the orbit at the operating point.
    values : mapping of str to float
        All parameters there.
    parts : tuple of BoundaryPart
        Curves that bound the zone, those of holes included, and folds at which it lies over itself.
    outline : ndarray of shape (m, 2)
        The zone's border, counter-clockwise, rectangle included; empty where it could not be closed.
    holes : tuple of ndarray
        Borders of holes, clockwise.
    margins : tuple of AxisMargin
        Of the first parameter downwards and upwards, then of the second.
    tolerance_margins : tuple of ToleranceMargin
        Where tolerances were stated: box, then ellipse.
    tolerances : tuple of float
        Dimensionless; empty where none were stated.
    lines : int
        Lines along which the orbit was followed from the operating point: it, and others from those.
    followed : ndarray of shape (k, 2)
        All places at which it was solved for on them.
    complete : bool
    notes : tuple of str
        What is missing, and why; and where the zone lies over itself.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> limits = {"lower": (0.78, 0.9), "upper": (0.85, 1.1)}
    >>> zone = gl.plane_zone(case, ("omega", "D"), **limits, values={"omega": 0.8}, lines=0)
    >>> zone.complete, zone.contains(0.79, 1.05), round(zone.margins[1].value, 4)
    (True, True, 0.8206)
    """

    _printed: ClassVar = ("names", "at", "quiet", "label", "parts", "complete", "notes")

    names: tuple[str, str]
    at: tuple[float, float]
    lower: tuple[float, float]
    upper: tuple[float, float]
    quiet: Quiet
    label: Signature
    values: Mapping[str, float]
    parts: tuple[BoundaryPart, ...]
    outline: NDArray[np.float64]
    holes: tuple[NDArray[np.float64], ...]
    margins: tuple[AxisMargin, ...]
    tolerance_margins: tuple[ToleranceMargin, ...]
    tolerances: tuple[float, ...]
    lines: int
    followed: NDArray[np.float64]
    complete: bool
    notes: tuple[str, ...]

    @property
    def special(self) -> tuple[CodimTwoPoint, ...]:
        """Points at which one curve of the boundary takes over from another."""
        found: list[CodimTwoPoint] = []
        unit = np.subtract(self.upper, self.lower)
        for end in (end for part in self.parts for end in part.ends):
            if end is not None and all(
                np.abs((np.subtract(end.values, known.values)) / unit).max() > 1e-6 for known in found
            ):
                found.append(end)
        return tuple(found)

    def contains(self, first: float, second: float) -> bool:
        """Whether a place lies within the border.

        Between two computed points of a curve the border is a spline: so near to it that says nothing.

        Parameters
        ----------
        first, second : float
            Of the two parameters, dimensionless.

        Returns
        -------
        bool
        """
        place = np.array([given.number("first", first), given.number("second", second)])
        return encloses(self.outline, place) and not any(encloses(hole, place) for hole in self.holes)


def encloses(polygon: NDArray[np.float64], place: NDArray[np.float64]) -> bool:
    """Whether a place (2,) lies inside a polygon (m, 2)."""
    if len(polygon) < 3:
        return False
    one, two = polygon, np.roll(polygon, -1, axis=0)
    between = (one[:, 1] > place[1]) != (two[:, 1] > place[1])
    one, two = one[between], two[between]
    cuts = one[:, 0] + (place[1] - one[:, 1]) * (two[:, 0] - one[:, 0]) / (two[:, 1] - one[:, 1])
    return bool((cuts > place[0]).sum() % 2)
