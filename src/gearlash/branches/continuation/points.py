"""What is met along a branch: its orbits, the special ones among them, and why it ends."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.orbits import Certificate, Signature
from gearlash.orbits.floquet import rate
from gearlash.orbits.grazing import GRAZING_KINDS, GrazingConditions, Surface, conditions_at
from gearlash.system import GearlashError, Record, Status, System
from gearlash.system.status import Named

from .extrema import Extremum
from .testfunctions import outside

Array = NDArray[np.float64]


class SpecialKind(Named):
    """What happens at a special point of a branch."""

    FOLD = "fold"
    """The branch turns round in the parameter; a multiplier is 1."""
    DOUBLING = "doubling"
    """A multiplier is -1: an orbit of twice the period is born or ends."""
    TORUS = "Neimark-Sacker"
    """A pair of multipliers crosses the unit circle."""
    KREIN = "Krein collision"
    """Without damping: two pairs of multipliers meet on the unit circle, and leave it or come to it."""
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
        """Multipliers outside the unit circle, beyond rounding."""
        return len(outside(self.multipliers))

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
        Contacts of the orbits just beside it, in the order of the branch.
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
    name : str
        Short name of the parameter.
    values : mapping of str to float
        All parameters of the orbit there.

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
    name: str
    values: Mapping[str, float]

    @property
    def arclength(self) -> float:
        """Of the point itself."""
        return self.point.arclength

    @property
    def is_grazing(self) -> bool:
        """Whether an extremum touches a boundary there."""
        return self.kind is SpecialKind.GRAZING

    @property
    def period(self) -> int:
        """Of the orbit, in mesh cycles."""
        return self.point.period

    @property
    def multipliers(self) -> NDArray[np.complex128]:
        """Of the orbit, by modulus, descending."""
        return self.point.multipliers

    @property
    def residual(self) -> float:
        """Of the orbit."""
        return self.point.residual

    @property
    def label_below(self) -> Signature:
        """Of the orbit just below the value."""
        return self.label_before if self.point.turn >= 0.0 else self.label_after

    @property
    def label_above(self) -> Signature:
        """Of the orbit just above the value."""
        return self.label_after if self.point.turn >= 0.0 else self.label_before

    @property
    def touch(self) -> Extremum:
        """The extremum that touches; raises `GearlashError` where none does."""
        if self.extremum is None:
            raise GearlashError(f"at a {self.kind} no extremum touches a boundary")
        return self.extremum

    @property
    def touch_kind(self) -> str:
        """Loss of contact or engagement, drive or back side, of a graze."""
        return grazing_kind(self.touch)

    @property
    def to_doubling(self) -> float:
        """Least |λ + 1|."""
        return float(np.abs(self.multipliers + 1.0).min())

    @property
    def to_fold(self) -> float:
        """Least |λ - 1|."""
        return float(np.abs(self.multipliers - 1.0).min())

    def exponent(self, system: System) -> float:
        """The largest exponent of the orbit.

        Parameters
        ----------
        system : System
            The member of the family at `values`.

        Returns
        -------
        float
            Per unit of τ.
        """
        return rate(complex(self.multipliers[0]), self.period / system.cycles * system.period)

    def state_at_touch(self, system: System) -> Array:
        """The state of a graze at its touch.

        Parameters
        ----------
        system : System
            The member of the family at `values`.

        Returns
        -------
        ndarray of shape (n,)
        """
        phase = self.touch.phase % self.period
        return flow.carry(flow.propagators(system), self.point.state, phase).state

    def conditions(self, system: System) -> GrazingConditions:
        """The four conditions of a graze, read anew from the state at the touch.

        Parameters
        ----------
        system : System
            The member of the family at `values`.

        Returns
        -------
        GrazingConditions
            Of the surface "force" the velocity is the residual of the orbit.
        """
        touch = self.touch
        surface: Surface = "gap" if touch.surface == "gap" else "force"
        return conditions_at(
            system, touch.phase, self.state_at_touch(system), touch.a0,
            clearance=touch.clearance, boundary=touch.boundary, surface=surface, force_rate=self.residual,
        )  # fmt: skip


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
