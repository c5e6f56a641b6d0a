"""From dimensionless numbers to physical ones and back."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import NDArray

from gearlash.system import GearlashError, Record, given

from .lengths import Lengths

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Values: TypeAlias = NDArray[np.float64]


@dataclass(frozen=True, repr=False)
class Scales(Lengths, Record):
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
        """Pinion speed.

        Parameters
        ----------
        omega : array_like
            Dimensionless mesh frequency.

        Returns
        -------
        ndarray
            rad/s.
        """
        return given.reals("omega", omega) * self._speed_unit

    def omega_from_pinion_speed(self, speed: ArrayLike) -> Values:
        """Dimensionless mesh frequency of a pinion speed.

        Parameters
        ----------
        speed : array_like
            rad/s.

        Returns
        -------
        ndarray
            Dimensionless.
        """
        return given.reals("speed", speed) / self._speed_unit

    def pinion_rpm(self, omega: ArrayLike) -> Values:
        """Pinion speed in revolutions a minute.

        Parameters
        ----------
        omega : array_like
            Dimensionless mesh frequency.

        Returns
        -------
        ndarray
            rpm.
        """
        return self.pinion_speed(omega) * (30.0 / pi)

    def omega_from_rpm(self, rpm: ArrayLike) -> Values:
        """Dimensionless mesh frequency of a pinion speed in revolutions a minute.

        Parameters
        ----------
        rpm : array_like
            rpm.

        Returns
        -------
        ndarray
            Dimensionless.
        """
        return self.omega_from_pinion_speed(given.reals("rpm", rpm) / (30.0 / pi))

    def mesh_hz(self, omega: ArrayLike) -> Values:
        """Mesh frequency in cycles a second.

        Parameters
        ----------
        omega : array_like
            Dimensionless mesh frequency.

        Returns
        -------
        ndarray
            Hz.
        """
        return given.reals("omega", omega) * (self._known("omega_n") / (2.0 * pi))

    def omega_from_hz(self, hz: ArrayLike) -> Values:
        """Dimensionless mesh frequency of one in cycles a second.

        Parameters
        ----------
        hz : array_like
            Hz.

        Returns
        -------
        ndarray
            Dimensionless.
        """
        return given.reals("hz", hz) / (self._known("omega_n") / (2.0 * pi))

    def time_s(self, tau: ArrayLike) -> Values:
        """Time in seconds.

        Parameters
        ----------
        tau : array_like
            Dimensionless time.

        Returns
        -------
        ndarray
            s.
        """
        return given.reals("tau", tau) / self._known("omega_n")

    def tau_from_s(self, seconds: ArrayLike) -> Values:
        """Dimensionless time.

        Parameters
        ----------
        seconds : array_like
            s.

        Returns
        -------
        ndarray
            Dimensionless.
        """
        return given.reals("seconds", seconds) * self._known("omega_n")

    def velocity(self, velocity: ArrayLike) -> Values:
        """Velocity.

        Parameters
        ----------
        velocity : array_like
            X′, Y′ or Z′, dimensionless.

        Returns
        -------
        ndarray
            m/s.
        """
        return given.reals("velocity", velocity) * (self._known("length") * self._known("omega_n"))

    def acceleration(self, acceleration: ArrayLike) -> Values:
        """Acceleration.

        Parameters
        ----------
        acceleration : array_like
            X″, Y″ or Z″, dimensionless.

        Returns
        -------
        ndarray
            m/s².
        """
        return given.reals("acceleration", acceleration) * (
            self._known("length") * self._known("omega_n") ** 2
        )

    def force_N(self, contact_force: ArrayLike) -> Values:
        """Normal contact force F_n = k_m D_c Φ.

        Parameters
        ----------
        contact_force : array_like
            Φ, dimensionless.

        Returns
        -------
        ndarray
            N, positive in compression of the drive side.
        """
        return given.reals("contact_force", contact_force) * self._force_unit

    def contact_force_from_N(self, newtons: ArrayLike) -> Values:
        """Dimensionless contact force.

        Parameters
        ----------
        newtons : array_like
            Normal contact force F_n, N.

        Returns
        -------
        ndarray
            Φ.
        """
        return given.reals("newtons", newtons) / self._force_unit

    def torque(self, load: ArrayLike) -> Values:
        """Pinion torque T_p = W R_p of a load f_m = c_t W/(k_m D_c).

        Parameters
        ----------
        load : array_like
            f_m, dimensionless.

        Returns
        -------
        ndarray
            N·m.
        """
        return given.reals("load", load) * self._torque_unit

    def load_from_torque(self, torque: ArrayLike) -> Values:
        """Load f_m of a pinion torque.

        Parameters
        ----------
        torque : array_like
            N·m.

        Returns
        -------
        ndarray
            Dimensionless.
        """
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
