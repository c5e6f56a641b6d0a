"""Where the energy of a motion goes: what drives put in, what dampers take, what bodies and springs hold."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicHermiteSpline

from .bodies import Machine
from .dynamics import Contact, Trajectory

Array = NDArray[np.float64]
PARTS = 4
"""Of the time from one kept state to the next, at whose ends powers are taken. What the contact takes jumps
where one more slice begins to carry, so that the states alone are too few."""


@dataclass(frozen=True)
class EnergyBalance:
    """Work over a motion, J.

    Attributes
    ----------
    input : float
        Of drive, load and governor.
    driven : float
        Of a stiffness or an error that follows the time; 0 for real flanks, whose error turns with them.
    bearings, contact : float
        What the dampers of bearings and modes take, and what the contact takes.
    change : float
        Growth of the kinetic and elastic energy.
    """

    input: float
    driven: float
    bearings: float
    contact: float
    change: float

    @property
    def residual(self) -> float:
        """What is missing, over what dampers take or, where it is larger, the work that is put in."""
        missing = self.input + self.driven - self.bearings - self.contact - self.change
        return abs(missing) / max(self.bearings + self.contact, abs(self.input))


def energy_balance(machine: Machine, motion: Trajectory, contact: Contact | None = None) -> EnergyBalance:
    """Work of every part over a motion.

    Parameters
    ----------
    machine : Machine
    motion : Trajectory
        Kept at every step or nearly so: powers are integrated between the states that were kept.
    contact : Contact, optional
        Of the teeth in this motion: powers are taken at three places more between two states, with the cubic
        that has their coordinates and rates. Without it they are taken at the states alone.

    Returns
    -------
    EnergyBalance

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.multibody import Bearings, LineContact, Machine, RigidBody, energy_balance, simulate
    >>> disc = RigidBody.solid_disc(6.0, 0.06, 0.07)
    >>> bearings = Bearings.from_ratio((8e8, 8e8, 6.8e8, 1e6, 1e6), disc, 0.04)
    >>> machine = Machine((disc, disc), (bearings, bearings), (28, 28), 100.0)
    >>> apart = LineContact(np.zeros(12), stiffness=(1e8,), error=(0.0,), gap=1.0, damping=0.0, rate=1.0)
    >>> falling = simulate(machine, apart, np.zeros(12), np.zeros(12), step=1e-5, steps=100)
    >>> energy_balance(machine, falling).residual < 1e-10
    True
    """
    if contact is not None:
        motion = _with_places_between(motion, contact)
    load = motion.v @ machine.constant_load()
    direction, aim = machine.governor()
    along = motion.v @ direction
    t = motion.t
    bearings = np.einsum("ti,ij,tj->t", motion.v, machine.damping(), motion.v)
    ends = [machine.energy(motion.q[i], motion.v[i]) + float(motion.recorded[i, 2]) for i in (0, -1)]
    return EnergyBalance(
        input=float(np.trapezoid(load + along * (aim - along), t)),
        driven=float(np.trapezoid(motion.recorded[:, 4], t)),
        bearings=float(np.trapezoid(bearings, t)),
        contact=float(np.trapezoid(motion.recorded[:, 3], t)),
        change=ends[1] - ends[0],
    )


def _with_places_between(motion: Trajectory, contact: Contact) -> Trajectory:
    """The same motion, with the states of Hermite's cubics between those that were kept."""
    curve = CubicHermiteSpline(motion.t, motion.q, motion.v)
    ends = np.linspace(motion.t[:-1], motion.t[1:], PARTS, endpoint=False, axis=1).ravel()
    t = np.append(ends, motion.t[-1])
    q, v = curve(t), curve(t, 1)
    recorded = np.empty((len(t), motion.recorded.shape[1]))
    for i, (at, place, rate) in enumerate(zip(t, q, v, strict=True)):
        recorded[i] = motion.recorded[i // PARTS] if i % PARTS == 0 else contact.record(at, place, rate)
    return Trajectory(t, q, v, recorded)
