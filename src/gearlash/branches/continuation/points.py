"""What a branch is told by: its points, the special ones among them, and why it ends."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from math import nan
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash.orbits import Certificate, Signature
from gearlash.orbits.grazing import GRAZING_KINDS, Surface
from gearlash.system import Record, Status, given
from gearlash.system.status import Named

from .derivative import DerivativeKind
from .extrema import Extremum

Array = NDArray[np.float64]


class SpecialKind(Named):
    """What happens at a special point of a branch."""

    FOLD = "fold"
    """The branch turns round in the parameter; a multiplier is 1."""
    DOUBLING = "doubling"
    """A multiplier is -1: an orbit of twice the period is born or ends."""
    TORUS = "Neimark-Sacker"
    """A pair of multipliers crosses the unit circle."""
    BRANCH_POINT = "branch point"
    """A multiplier is 1, and the branch goes on: another branch crosses it."""
    JOINS = "joins the orbit of half its period"
    """The orbit was born at the doubling of another one and comes back to it."""
    SYMMETRIC = "joins a symmetric orbit"
    """The orbit was born at the symmetry breaking of another one and comes back to it."""
    EXISTENCE = "end of existence"
    """A multiplier is 1 for motions of every size: the branch grows without bound towards this value."""
    GRAZING = "grazing"
    """An extremum touches a boundary: a contact is born or ends."""


class EndKind(Named):
    """Why a branch is not followed farther."""

    LOWER = "lower limit of the parameter"
    UPPER = "upper limit of the parameter"
    CLOSED = "closed loop: the branch comes back to where it began"
    JOINED = "joins the orbit of half its period"
    CORNER = "touch from the gap under no-tension, where the map has a corner"
    LINEAR = "touch of a linear motion, which has every lower amplitude at this value"
    SHORT = "no step is short enough"
    FAR = "the motion grows without bound"
    UNBUILT = "beyond it no system can be built"
    POINTS = "as many points as were allowed"
    CANCELLED = "cancelled"
    ARRIVED = "arrived"
    FOLD = "the orbit ends in a fold"
    TOUCH = "beyond the touch the orbit is not stable, or not found"
    DOUBLING = "beyond the doubling no stable orbit was found"
    PERIOD = "beyond the doubling the period is longer than was to be followed"
    UNSTABLE = "the orbit loses its stability"


@dataclass(frozen=True, eq=False, repr=False)
class BranchPoint(Record):
    """One orbit of a branch, stable or not.

    Attributes
    ----------
    value : float
        Of the parameter.
    arclength : float
        From the first orbit, in scaled unknowns; negative towards the first end.
    state : ndarray of shape (n,)
        At phase zero: with `value` and `period` it restarts the branch here.
    strobes : ndarray of shape (P, n)
        States at phase zero of every base period.
    turn : float
        How fast the parameter changes along the branch, scaled: from -1 to 1, zero at a fold.
    signature : Signature
    multipliers : ndarray of complex, of shape (n,)
        All Floquet multipliers, by modulus, descending.
    extrema : tuple of Extremum
        With their distances from their boundaries; each has a number of its own along the branch.
    born, died : tuple of int
        Numbers of extrema that are not in the point before, or no longer.
    residual, error : float
        Of the orbit, as of `Shot`.
    certificate : Certificate
    status : Status

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> branch = gl.continue_branch(family, "omega", lower=1.4, upper=1.6, values={"omega": 1.5})
    >>> point = branch.points[0]
    >>> print(point.label, point.stable)
    1-1-0 True
    """

    _printed: ClassVar = ("value", "label", "stable", "unstable", "arclength", "status")

    value: float
    arclength: float
    state: Array
    strobes: Array
    turn: float
    signature: Signature
    multipliers: NDArray[np.complex128]
    extrema: tuple[Extremum, ...]
    born: tuple[int, ...]
    died: tuple[int, ...]
    residual: float
    error: float
    certificate: Certificate
    status: Status

    @property
    def label(self) -> Signature:
        """The signature."""
        return self.signature

    @property
    def period(self) -> int:
        """In mesh cycles."""
        return self.signature.period

    @property
    def unstable(self) -> int:
        """Multipliers outside the unit circle."""
        return int((np.abs(self.multipliers) > 1.0).sum())

    @property
    def stable(self) -> bool:
        """Whether no multiplier lies outside the unit circle."""
        return self.unstable == 0


@dataclass(frozen=True, eq=False, repr=False)
class SpecialPoint(Record):
    """Where something happens to a branch, solved for.

    Attributes
    ----------
    kind : SpecialKind
    value, error : float
        Of the parameter, and an estimate of its error.
    interval : tuple of float
        Values of the two orbits between which it was found.
    arclengths : tuple of float
        Of the same two.
    point : BranchPoint
        The orbit there: all that a restart needs. At a branch point it is the nearest that is known well, at
        an end of existence the last one that was followed, each at a value of its own.
    label_before, label_after : Signature
        Contacts of the two orbits.
    unstable_before, unstable_after : int
        Their multipliers outside the unit circle.
    extremum : Extremum or None
        Of a graze the one that touches; its distance is zero within rounding.
    linear : bool
        Whether the orbit meets no boundary, so that its system is linear there: a doubling or torus is then
        degenerate, and what is born in it appears at the amplitude that grazes.
    note : str
        The kind in words, of a graze with its boundary.
    status : Status

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("article").family()
    >>> branch = gl.continue_branch(family, "omega", lower=1.0, upper=1.12)
    >>> for special in branch.special:
    ...     print(f"{special.value:.6f} {special.kind}: {special.label_before} to {special.label_after}")
    1.112000 grazing: 1-0-0 to 1-1-0
    """

    _printed: ClassVar = ("kind", "value", "error", "label_before", "label_after", "note", "status")

    kind: SpecialKind
    value: float
    error: float
    interval: tuple[float, float]
    arclengths: tuple[float, float]
    point: BranchPoint
    label_before: Signature
    label_after: Signature
    unstable_before: int
    unstable_after: int
    extremum: Extremum | None
    linear: bool
    note: str
    status: Status

    @property
    def arclength(self) -> float:
        """Of the point itself."""
        return self.point.arclength


def grazing_kind(extremum: Extremum) -> str:
    """Loss of contact or engagement, drive or back side."""
    surface: Surface = "gap" if extremum.surface == "gap" else "force"
    return GRAZING_KINDS[(surface, extremum.boundary, 1 if extremum.a0 > 0.0 else -1)]


@dataclass(frozen=True, repr=False)
class EndOfBranch(Record):
    """Why a branch is not followed farther.

    Attributes
    ----------
    kind : EndKind
    value : float
        Of the parameter.
    note : str
        The evidence in words, where there is more to tell.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> branch = gl.continue_branch(family, "omega", lower=1.4, upper=1.6, values={"omega": 1.5})
    >>> [end.value for end in branch.ends]
    [1.4, 1.6]
    """

    kind: EndKind
    value: float
    note: str = ""


@dataclass(frozen=True, eq=False, repr=False)
class Branch(Record):
    """Periodic orbits along one parameter, stable or not.

    Attributes
    ----------
    name : str
        Of the parameter, short.
    values : mapping of str to float
        All parameters, dimensionless; that of `name` is where the branch was begun.
    lower, upper : float
        Limits of the parameter.
    points : tuple of BranchPoint
        In the order of their arclength.
    special : tuple of SpecialPoint
        In the same order.
    ends : tuple of EndOfBranch
        The first and the last.
    scale : ndarray
        Of the unknowns (states, then the parameter), in which arclength is measured.
    unexplained : tuple of str
        Steps on which something changed that no special point was found for, in words.
    derivative : DerivativeKind or None
        How the derivatives along the parameter were had; None where a file of before does not say.
    derivative_error : float
        Estimate of their error, relative; 0 where they are exact, NaN where it is not known. It makes
        Newton's method slower, and no orbit less exact.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("article").family()
    >>> branch = gl.continue_branch(family, "omega", lower=1.0, upper=1.12)
    >>> [round(special.value, 6) for special in branch.of_kind("grazing")]
    [1.112]
    """

    _printed: ClassVar = ("name", "lower", "upper", "points", "special", "ends")

    name: str
    values: Mapping[str, float]
    lower: float
    upper: float
    points: tuple[BranchPoint, ...]
    special: tuple[SpecialPoint, ...]
    ends: tuple[EndOfBranch, ...]
    scale: Array
    unexplained: tuple[str, ...] = ()
    derivative: DerivativeKind | None = None
    derivative_error: float = nan

    @property
    def parameter(self) -> Array:
        """Values of the parameter, of shape (m,)."""
        return np.array([point.value for point in self.points])

    def of_kind(self, kind: SpecialKind | str) -> tuple[SpecialPoint, ...]:
        """The special points of one kind.

        Parameters
        ----------
        kind : SpecialKind or str

        Returns
        -------
        tuple of SpecialPoint
        """
        return tuple(special for special in self.special if special.kind is SpecialKind(kind))

    def at(self, value: float) -> tuple[tuple[BranchPoint, BranchPoint], ...]:
        """Where the branch passes a value.

        Parameters
        ----------
        value : float
            Of the parameter.

        Returns
        -------
        tuple of pairs of BranchPoint
            Neighbours with the value between theirs, one pair for every passage.
        """
        value, pairs = given.number("value", value), pairwise(self.points)
        return tuple(p for p in pairs if min(p[0].value, p[1].value) <= value <= max(p[0].value, p[1].value))
