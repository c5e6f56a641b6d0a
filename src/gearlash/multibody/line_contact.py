"""Contact along one fixed line with a given stiffness: what a lumped model has instead of flanks.

It is there to hold the bodies and the integrator against a lumped model, and for nothing else: δ = d·q − e
is the approach along the line, d its direction among the coordinates; stiffness and error follow the time.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gearlash.system import ContactRule

Array = NDArray[np.float64]


@dataclass(frozen=True)
class LineContact:
    """Teeth as one spring with a gap along a line.

    Parameters
    ----------
    direction : ndarray, shape (size,)
        d: how each coordinate of the bodies enters the approach.
    stiffness, error : tuple of float
        Mean, cos θ, sin θ, cos 2θ, sin 2θ, … of k in N/m and of e in m.
    gap : float
        m, on either side.
    damping : float
        N·s/m.
    rate : float
        dθ/dt, rad/s.
    contact : ContactRule
        When the damping acts.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.multibody import LineContact
    >>> line = LineContact(np.eye(12)[1], stiffness=(1e8,), error=(0.0,), gap=1e-5, damping=0.0, rate=1.0)
    >>> q = np.zeros(12)
    >>> q[1] = 3e-5
    >>> round(float(line.forces(0.0, q, np.zeros(12))[1]))
    -2000
    """

    direction: Array
    stiffness: tuple[float, ...]
    error: tuple[float, ...]
    gap: float
    damping: float
    rate: float
    contact: ContactRule = ContactRule.ALWAYS

    def forces(self, t: float, q: Array, v: Array) -> Array:
        """Generalised forces on the bodies.

        Parameters
        ----------
        t : float
            s.
        q, v : ndarray, shape (size,)

        Returns
        -------
        ndarray, shape (size,)
        """
        return -self._force(t, q, v)[0] * self.direction

    def record(self, t: float, q: Array, v: Array) -> Array:
        """What is kept of a state, in the order of `RECORDED`; a force that pulls counts as negative.

        Parameters
        ----------
        t : float
            s.
        q, v : ndarray, shape (size,)

        Returns
        -------
        ndarray, shape (5,)
        """
        force, spring, rate, stiffness, stiffness_rate, error_rate = self._force(t, q, v)
        over = spring / stiffness
        drive, back = (force, 0.0) if spring >= 0.0 else (0.0, -force)
        driven = 0.5 * stiffness_rate * over**2 - force * error_rate
        return np.array([drive, back, 0.5 * spring * over, (force - spring) * rate, driven])

    def _force(self, t: float, q: Array, v: Array) -> tuple[float, float, float, float, float, float]:
        k, k_rate = self._at(self.stiffness, t)
        e, e_rate = self._at(self.error, t)
        approach, rate = float(self.direction @ q) - e, float(self.direction @ v) - e_rate
        spring = k * (max(approach - self.gap, 0.0) + min(approach + self.gap, 0.0))
        if self.contact is ContactRule.ALWAYS:
            return spring + self.damping * rate, spring, rate, k, k_rate, e_rate
        force = spring + (self.damping * rate if spring else 0.0)
        if self.contact is ContactRule.NO_TENSION and force * spring < 0.0:
            force = 0.0
        return force, spring, rate, k, k_rate, e_rate

    def _at(self, series: tuple[float, ...], t: float) -> tuple[float, float]:
        """A Fourier series over θ and its rate."""
        if len(series) == 1:
            return series[0], 0.0
        angles = self._orders[: len(series) // 2] * (self.rate * t)
        cosines, sines = np.cos(angles), np.sin(angles)
        a, b = np.array(series[1::2]), np.array(series[2::2])
        rates = self._orders[: len(series) // 2] * self.rate
        return series[0] + float(a @ cosines + b @ sines), float(rates @ (b * cosines - a * sines))

    @cached_property
    def _orders(self) -> Array:
        return np.arange(1.0, 1.0 + max(len(self.stiffness), len(self.error)) // 2)
