"""A touch of a periodic orbit and a boundary, as it is kept."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash.orbits.grazing import GRAZING_KINDS, GrazingConditions, Surface, conditions_at
from gearlash.system import Label, Record, Status, System

from .continuation.extrema import Extremum

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class GrazingPoint(Record):
    """A touch of a periodic orbit and a boundary, solved for.

    Parameters
    ----------
    name : str
        Short name of the parameter.
    value : float
        Of it, dimensionless.
    error : float
        Estimate of its error.
    values : mapping of str to float
        All parameters there.
    boundary : {1, -1}
        Σ1 or Σ2.
    phase : float
        Of the touch, in mesh cycles from ``state_zero``.
    a0 : float
        X'' there, per unit of τ squared; Φ'' of the surface "force".
    period : int
        Of the orbit, in mesh cycles.
    state : ndarray of shape (n,)
        At the touch.
    state_zero : ndarray of shape (n,)
        The orbit at phase zero: a start for either side.
    multipliers : ndarray of shape (n,)
        Of the one-sided orbit, complex, by modulus, descending.
    exponent : float
        The largest of them, per unit of τ.
    label_below, label_above : Signature or MotionKind
        Of the same orbit just below and above ``value``; `MotionKind.NONE` where it was not found: beyond a
        touch it may end within less than can be told apart.
    residual : float
        Of all equations.
    status : Status
        `not-converged` and `not-admissible` say that it is no result.
    clearance : int
        Index of the gap.
    clearance_name : str
        Its name.
    surface : {"gap", "force"}
        What is touched: X = ±D, or Φ = 0 with the rule `no-tension`.
    stable_below, stable_above : bool, optional
        Whether the orbit is stable there; None where it was not found.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.attractor(family.system({"omega": 0.8}), family.start())
    >>> nearest = gl.grazing_checks(orbit)[0]
    >>> point = gl.locate_grazing(family, "omega", orbit, nearest, values={"omega": 0.8})
    >>> round(point.value, 6), str(point.label_below), str(point.label_above)
    (0.820631, '1-0-0', '1-1-0')
    """

    _printed: ClassVar = (
        "name",
        "value",
        "error",
        "status",
        "kind",
        "label_below",
        "label_above",
        "a0",
        "residual",
    )

    name: str
    value: float
    error: float
    values: Mapping[str, float]
    boundary: int
    phase: float
    a0: float
    period: int
    state: Array
    state_zero: Array
    multipliers: NDArray[np.complex128]
    exponent: float
    label_below: Label
    label_above: Label
    residual: float
    status: Status
    clearance: int = 0
    clearance_name: str = "mesh"
    surface: Surface = "gap"
    stable_below: bool | None = None
    stable_above: bool | None = None

    @property
    def kind(self) -> str:
        """Loss of contact or engagement, drive or back side."""
        return GRAZING_KINDS[(self.surface, self.boundary, 1 if self.a0 > 0 else -1)]

    @property
    def touch(self) -> Extremum:
        """What touches, as an extremum of a branch has it."""
        return Extremum(0, self.clearance, self.surface, self.boundary, self.phase, 0.0, self.a0)

    @property
    def touch_kind(self) -> str:
        """Loss of contact or engagement, drive or back side."""
        return self.kind

    def conditions(self, system: System) -> GrazingConditions:
        """The four conditions, read anew from the state at the touch.

        Parameters
        ----------
        system : System
            The member of the family at ``values``.

        Returns
        -------
        GrazingConditions
            Of the surface "force" the velocity is the residual of all equations.
        """
        return conditions_at(
            system, self.phase, self.state, self.a0,
            clearance=self.clearance, boundary=self.boundary, surface=self.surface, force_rate=self.residual,
        )  # fmt: skip

    @property
    def to_doubling(self) -> float:
        """Least |λ + 1|."""
        return distance_to_unit(self.multipliers)[0]

    @property
    def to_fold(self) -> float:
        """Least |λ - 1|."""
        return distance_to_unit(self.multipliers)[1]


def distance_to_unit(multipliers: NDArray[np.complex128]) -> tuple[float, float]:
    """(least |λ + 1|, least |λ - 1|) over all multipliers: 0 at a doubling, and at a fold."""
    return float(np.abs(multipliers + 1.0).min()), float(np.abs(multipliers - 1.0).min())
