"""The article's stable zones, as each way of looking shows them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite

from gearlash.system import Label


@dataclass(frozen=True)
class Coexisting:
    """Another attractor within a zone.

    Attributes
    ----------
    label : label
    interval : (float, float)
        Of the parameter, in which it was seen.
    start : str
        The sweeps it was seen in.
    largest_exponent : float
    note : str
    """

    label: Label
    interval: tuple[float, float]
    start: str
    largest_exponent: float
    note: str = ""


@dataclass(frozen=True)
class End:
    """One end of a zone.

    Attributes
    ----------
    value : float
    how : str
        What ends the zone there.
    next_label : label
        Of the motion beyond it.
    uncertainty : float
    """

    value: float
    how: str
    next_label: str
    uncertainty: float


@dataclass(frozen=True)
class Reading:
    """A stable zone as one way of looking shows it. Its ends are NaN where there is none.

    Attributes
    ----------
    way, name : str
        ``cold``, ``up``, ``down`` or one of the simple starts; ``some`` or ``every``: at least one, or every
        one, of the attractors that the first three find. ``name`` says it in words.
    lower, upper : End
    labels : tuple of label
        Of the motions in it.
    margin : float
        Least distance of X to the boundary in the middle of the zone.
    coexisting : tuple of Coexisting
    deviations : (float, float)
        Of the two ends, relative to the article's.
    verdict : str
    """

    way: str
    name: str
    lower: End
    upper: End
    labels: tuple[Label, ...]
    margin: float
    coexisting: tuple[Coexisting, ...]
    deviations: tuple[float, float]
    verdict: str

    @property
    def found(self) -> bool:
        return isfinite(self.lower.value) and isfinite(self.upper.value)

    @property
    def deviation(self) -> float:
        """The larger one."""
        return max(self.deviations, key=abs)


@dataclass(frozen=True)
class ReportedZone:
    """A stable zone of the article, and its readings.

    Attributes
    ----------
    name, parameter : str
    fixed : mapping of str to float
    kind : str
        ``impact-free`` or ``drive side only``.
    reported : (float, float)
        The article's interval.
    readings : tuple of Reading
    nearest : str
        The way whose ends lie nearest to the article's; empty where no reading has a zone.
    verdict, note : str
        Of that reading.
    """

    name: str
    parameter: str
    fixed: Mapping[str, float]
    kind: str
    reported: tuple[float, float]
    readings: tuple[Reading, ...]
    nearest: str
    verdict: str
    note: str

    def reading(self, way: str) -> Reading:
        """That of one way."""
        return next(reading for reading in self.readings if reading.way == way)
