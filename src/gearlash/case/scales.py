"""From dimensionless numbers to physical ones and back."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from gearlash.system import GearlashError, Record, given

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Values: TypeAlias = NDArray[np.float64]


@dataclass(frozen=True, repr=False)
class Scales(Record):
    """The units of a case. Every conversion takes a number or an array and returns an array of its shape.

    A case given in dimensionless numbers only has no units: `physical` is False, and every conversion raises
    `GearlashError`. A pair given by its equivalent mass has no radius and so no torque.

    Attributes
    ----------
    omega_n : float or None
        √(k_m/m_e), rad/s: the unit of frequencies; 1/ω_n is that of time.
    mean_stiffness : float or None
        k_m, N/m.
    equivalent_mass : float or None
        m_e, kg.
    length : float or None
        D_c, m: the unit of lengths.
    c_t : float
        Factor of rotation along the line of action.
    radii : (float, float) or None
        R_p and R_g, m.
    teeth : (int, int or None) or None
        Of pinion and gear.
    back_gap : float
        D⁻/D, the gap of the back side over that of the drive side.

    Examples
    --------
    >>> import gearlash as gl
    >>> scales = gl.load_case("article").scales
    >>> scales.pinion_rpm([0.5, 1.0]).round(1).tolist()
    [1910.0, 3820.0]
    >>> float(scales.force_N(0.1)), float(scales.backlash_um(1.0))
    (1600.0, 100.0)
    """

    omega_n: float | None = None
    mean_stiffness: float | None = None
    equivalent_mass: float | None = None
    length: float | None = None
    c_t: float = 1.0
    radii: tuple[float, float] | None = None
    teeth: tuple[int, int | None] | None = None
    back_gap: float = 1.0

    @property
    def physical(self) -> bool:
        """Does this case know physical units?"""
        return self.omega_n is not None

    def pinion_speed(self, omega: ArrayLike) -> Values:
        """Pinion speed in rad/s of a dimensionless mesh frequency."""
        return given.reals("omega", omega) * self._speed_unit

    def omega_from_pinion_speed(self, speed: ArrayLike) -> Values:
        """Dimensionless mesh frequency of a pinion speed in rad/s."""
        return given.reals("speed", speed) / self._speed_unit

    def pinion_rpm(self, omega: ArrayLike) -> Values:
        """Pinion speed in rpm of a dimensionless mesh frequency."""
        return self.pinion_speed(omega) * (30.0 / pi)

    def omega_from_rpm(self, rpm: ArrayLike) -> Values:
        """Dimensionless mesh frequency of a pinion speed in rpm."""
        return self.omega_from_pinion_speed(given.reals("rpm", rpm) / (30.0 / pi))

    def mesh_hz(self, omega: ArrayLike) -> Values:
        """Mesh frequency in Hz (cycles per second) of a dimensionless one."""
        return given.reals("omega", omega) * (self._known("omega_n") / (2.0 * pi))

    def omega_from_hz(self, hz: ArrayLike) -> Values:
        """Dimensionless mesh frequency of one in Hz."""
        return given.reals("hz", hz) / (self._known("omega_n") / (2.0 * pi))

    def time_s(self, tau: ArrayLike) -> Values:
        """Time in s of a dimensionless one."""
        return given.reals("tau", tau) / self._known("omega_n")

    def tau_from_s(self, seconds: ArrayLike) -> Values:
        """Dimensionless time of a time in s."""
        return given.reals("seconds", seconds) * self._known("omega_n")

    def length_m(self, displacement: ArrayLike) -> Values:
        """Any displacement or error amplitude in m."""
        return given.reals("displacement", displacement) * self._known("length")

    def displacement_from_m(self, metres: ArrayLike) -> Values:
        """Dimensionless displacement of a length in m."""
        return given.reals("metres", metres) / self._known("length")

    def length_um(self, displacement: ArrayLike) -> Values:
        """Any displacement or error amplitude in µm."""
        return self.length_m(displacement) * 1e6

    def displacement_from_um(self, micrometres: ArrayLike) -> Values:
        """Dimensionless displacement of a length in µm."""
        return self.displacement_from_m(given.reals("micrometres", micrometres) / 1e6)

    def backlash_m(self, half_backlash: ArrayLike) -> Values:
        """Whole backlash b in m of D: both sides of the gap, D + D⁻."""
        return self.length_m(half_backlash) * (1.0 + self.back_gap)

    def half_backlash_from_m(self, backlash: ArrayLike) -> Values:
        """D of a whole backlash b in m."""
        return self.displacement_from_m(given.reals("backlash", backlash) / (1.0 + self.back_gap))

    def backlash_um(self, half_backlash: ArrayLike) -> Values:
        """Whole backlash b in µm of D."""
        return self.backlash_m(half_backlash) * 1e6

    def half_backlash_from_um(self, backlash: ArrayLike) -> Values:
        """D of a whole backlash b in µm."""
        return self.half_backlash_from_m(given.reals("backlash", backlash) / 1e6)

    def velocity(self, velocity: ArrayLike) -> Values:
        """Velocity in m/s of X′, Y′ or Z′."""
        return given.reals("velocity", velocity) * (self._known("length") * self._known("omega_n"))

    def acceleration(self, acceleration: ArrayLike) -> Values:
        """Acceleration in m/s² of X″, Y″ or Z″."""
        return given.reals("acceleration", acceleration) * (
            self._known("length") * self._known("omega_n") ** 2
        )

    def force_N(self, contact_force: ArrayLike) -> Values:
        """Normal contact force F_n = k_m D_c Φ in N, positive in compression of the drive side."""
        return given.reals("contact_force", contact_force) * self._force_unit

    def contact_force_from_N(self, newtons: ArrayLike) -> Values:
        """Φ of a normal contact force in N."""
        return given.reals("newtons", newtons) / self._force_unit

    def torque(self, load: ArrayLike) -> Values:
        """Pinion torque T_p = W R_p in N·m of f_m = c_t W/(k_m D_c)."""
        return given.reals("load", load) * self._torque_unit

    def load_from_torque(self, torque: ArrayLike) -> Values:
        """f_m of a pinion torque in N·m."""
        return given.reals("torque", torque) / self._torque_unit

    @property
    def _speed_unit(self) -> float:
        omega_n, teeth = self._known("omega_n"), self.teeth
        if teeth is None:
            raise GearlashError("no shaft speed: this case does not state the teeth of the pinion")
        return omega_n / teeth[0]

    @property
    def _force_unit(self) -> float:
        return self._known("mean_stiffness") * self._known("length")

    @property
    def _torque_unit(self) -> float:
        unit = self._force_unit / self.c_t
        if self.radii is None:
            raise GearlashError("no torque: this case states an equivalent mass, but no radius")
        return unit * self.radii[0]

    def _known(self, name: str) -> float:
        value = getattr(self, name)
        if value is None:
            raise GearlashError(f"no physical {name}: this case is given in dimensionless numbers only")
        return value
