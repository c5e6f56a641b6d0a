"""Where impact-free motion exists in spite of tolerances."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite, nan
from typing import TypeAlias

from gearlash.system import Record

from .axis import Axis

LIMITS_OF_CASE = "limits of the case file"
"""The reason of inputs whose limits the case states; of estimates it is that of the estimate."""
Band: TypeAlias = tuple[float, float]
"""Both ends of an interval, in the unit of its axis."""

CONFIDENCE = 0.05  # chance that a bound is wrong


@dataclass(frozen=True)
class ToleranceInput:
    """A value of a case that may lie anywhere between two limits, each as likely as any other.

    Attributes
    ----------
    path : str
        Where it stands in a case file.
    unit : str
    lower, upper : float
        In ``unit``.
    nominal : float
        Of the case as it is; NaN where it has this quantity in no form.
    reason : str
        Where the limits are from.
    curve : str
        Path of the first of the harmonics that are estimated together, as one curve: they vary independently,
        and share one influence. Empty for what is no part of one.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.ToleranceInput("mesh.backlash", "um", 60.0, 120.0, 80.0).text(75.5)
    '75.5 um'
    """

    path: str
    unit: str
    lower: float
    upper: float
    nominal: float
    reason: str = ""
    curve: str = ""

    @property
    def of_case(self) -> bool:
        """Does the case state its limits?"""
        return self.reason == LIMITS_OF_CASE

    def text(self, value: float) -> str:
        """A value of it as a case file would state it.

        Parameters
        ----------
        value : float
            In ``unit``.

        Returns
        -------
        str
        """
        return f"{value!r} {self.unit}".strip()


@dataclass(frozen=True)
class ToleranceMember:
    """One combination of inputs.

    Attributes
    ----------
    inputs : tuple of float
        In the order and the units of the inputs.
    bands : tuple of (float, float)
        Where the motion of teeth that never part exists and is stable.
    margin : float
        Its least compression at the nominal value of the axis, over the unit of length of this member;
        NaN where that motion was not solved for.
    length : float or None
        The unit of length, m.
    unsolved : int
        Values of the axis at which the motion was not solved for: they count as not free of impacts.
    static : float
        The compression under the mean torque alone, in the same unit as the margin.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.ToleranceMember((80.0,), ((3000.0, 3872.0),), 0.11, 4e-5, 0).compression
    4.4e-06
    """

    inputs: tuple[float, ...]
    bands: tuple[Band, ...]
    margin: float
    length: float | None
    unsolved: int
    static: float = nan

    @property
    def compression(self) -> float:
        """The margin in m; as it is where there is no unit of length."""
        return self.margin * (self.length or 1.0)

    @property
    def share(self) -> float:
        """The margin over the static compression: 1 where nothing moves, 0 where teeth just part, and where
        no torque presses them."""
        return 0.0 if self.static == 0.0 else self.margin / self.static


@dataclass(frozen=True)
class Influence:
    """How much of the spread of the margin over the static compression an input makes (Sobol indices).

    Attributes
    ----------
    path : str
        Of the input; of a curve that of its first harmonic, for all of them together.
    first, first_error : float
        By itself, and the standard error of that.
    total, total_error : float
        With all that it makes together with others.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.Influence("operation.torque", 0.81, 0.09, 0.82, 0.05).total
    0.82
    """

    path: str
    first: float
    first_error: float
    total: float
    total_error: float


@dataclass(frozen=True)
class Profile:
    """A probability between the solved ends of bands: it is the same all along each piece.

    Attributes
    ----------
    edges : tuple of float, of length n + 1
        In the unit of the axis, ascending.
    probability, error : tuple of float, of length n
        Between two edges: the share of the samples, and its standard error.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> speeds = gl.Axis.even("omega", 0.5, 0.9, 2)
    >>> profile = gl.tolerance(case, speeds, {"load": (0.1, 0.3)}, samples=4, replicates=2).profile
    >>> profile.probability[0], profile.probability[-1]
    (1.0, 0.625)
    """

    edges: tuple[float, ...]
    probability: tuple[float, ...]
    error: tuple[float, ...]


@dataclass(frozen=True, repr=False)
class Tolerance(Record):
    """Where impact-free motion exists in spite of tolerances, as `tolerance` returns it.

    It is the motion of teeth that never part, on the side of the load. Nothing is said about other motions at
    the same values, nor which starts lead to this one.

    Attributes
    ----------
    axis : Axis
        As it was asked for.
    inputs : tuple of ToleranceInput
    nominal : ToleranceMember
        The case as it is.
    always, never : tuple of (float, float)
        Where every combination that was tried has the motion, and where none has it.
    probability, probability_error : tuple of float
        At each value of the axis the share of the samples that have it, and its standard error.
    here, here_error : float
        The same at the present value of the axis; NaN where that lies outside of it.
    present : float
        That value, in the unit of the axis.
    worst : ToleranceMember
        The combination with the least margin over the static compression at the present value, of all that
        were tried.
    samples, replicates, corners : int
        Points of each of the sets of samples, how many sets, and corners of the limits, as they were planned.
    tried : int
        Combinations of which bands are known: the case as it is where it lies within the limits, corners,
        samples, and the worst one of the search.
    influences : tuple of Influence
        Of the margin over the static compression at the present value, the largest total first.
    no_influences : str
        Why there are none; empty where there are some.
    unsolved : int
        Motions that were not solved for, of all.
    profile : Profile or None
        The same between the solved ends of the bands of all samples, on which the axis has no say; None where
        the work was stopped before.
    complete : bool
        Whether nothing stopped the work.
    message : str

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> speeds = gl.Axis.even("omega", 0.5, 0.9, 5)
    >>> found = gl.tolerance(case, speeds, {"load": (0.1, 0.3)}, samples=4, replicates=2)
    >>> [(round(low, 2), round(high, 2)) for low, high in found.always], found.probability[-1]
    ([(0.5, 0.82)], 0.625)
    """

    axis: Axis
    inputs: tuple[ToleranceInput, ...]
    nominal: ToleranceMember
    always: tuple[Band, ...]
    never: tuple[Band, ...]
    probability: tuple[float, ...]
    probability_error: tuple[float, ...]
    here: float
    here_error: float
    present: float
    worst: ToleranceMember
    samples: int
    replicates: int
    corners: int
    tried: int
    influences: tuple[Influence, ...]
    unsolved: int
    complete: bool = True
    message: str = ""
    profile: Profile | None = None
    no_influences: str = ""

    @property
    def drawn(self) -> int:
        """Samples of the whole sets that were done; of work that was stopped no fewer than this."""
        planned = self.samples * self.replicates
        if self.complete:
            return planned
        return max(0, min(planned, (self.tried - self.corners - 1) // self.samples * self.samples))

    def sharing(self, path: str) -> str:
        """What an influence is of: a path, or that of the first harmonic of a curve and the last one.

        Parameters
        ----------
        path : str
            As an influence has it.

        Returns
        -------
        str
        """
        last = [one.path for one in self.inputs if path in (one.path, one.curve)][-1]
        return path if last == path else f"{path} to {last.rpartition('.')[2]}"

    @property
    def settings_of_worst(self) -> Mapping[str, str]:
        """The worst combination as overrides of the case."""
        values = zip(self.inputs, self.worst.inputs, strict=True)
        return {one.path: one.text(value) for one, value in values if isfinite(value)}


def least_chance(count: int) -> float:
    """What a probability is at least where all of ``count`` samples agree, at 95 %."""
    return CONFIDENCE ** (1.0 / count) if count else 0.0
