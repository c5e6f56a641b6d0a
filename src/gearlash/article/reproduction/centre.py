"""The point of two parameters from which an event's doubling and grazings leave."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from gearlash.system import Label, Record


@dataclass(frozen=True)
class CentreLine:
    """A curve that leaves the point.

    Attributes
    ----------
    kind : str
        ``doubling`` or ``grazing``.
    labels : tuple of label
        Of what doubles; of what grazes, and of the motion with the impact that is born there.
    values : tuple of (float, float)
        Of the two parameters, of all orbits that were solved for on it, in order, from the point to where the
        second parameter is that of the case.
    crosses : float
        The first parameter there; NaN where the curve does not come to it.
    """

    kind: str
    labels: tuple[Label, ...]
    values: tuple[tuple[float, float], ...]
    crosses: float


@dataclass(frozen=True)
class CentrePlace:
    """The point in a plane of two parameters.

    Attributes
    ----------
    parameters : tuple of str
    values, errors : tuple of float
        Of the two, and an estimate of their errors.
    present : float
        The second parameter as it is in the case.
    limits : tuple of (float, float)
        Within which the point was looked for.
    multiplier, distance, residual : float
        |λ + 1|, the distance of the touching extremum from its boundary, and what is left of all equations.
    exponent : float
        Largest, per unit of τ.
    """

    parameters: tuple[str, str]
    values: tuple[float, float]
    errors: tuple[float, float]
    present: float
    limits: tuple[tuple[float, float], tuple[float, float]]
    multiplier: float
    distance: float
    residual: float
    exponent: float


@dataclass(frozen=True, eq=False, repr=False)
class Centre(Record):
    """The orbit that grazes with a multiplier -1, which takes two parameters, and the curves that leave it.

    Attributes
    ----------
    claim : str
        Id of the claim whose event lies beside it.
    fixed : mapping of str to float
        The parameter that is not varied.
    labels : tuple of label
        Of the orbit, and with the impact that is born there.
    boundary : int
        That it touches: +1 (Σ1), -1 (Σ2).
    places : tuple of CentrePlace
        In every plane in which it was met.
    sought : tuple of str
        Second parameters of all planes in which it was looked for.
    lines : tuple of CentreLine
        In the plane of the first place.
    """

    _printed: ClassVar = ("claim", "labels", "places", "sought")

    claim: str
    fixed: Mapping[str, float]
    labels: tuple[Label, Label]
    boundary: int
    places: tuple[CentrePlace, ...]
    sought: tuple[str, ...]
    lines: tuple[CentreLine, ...]
