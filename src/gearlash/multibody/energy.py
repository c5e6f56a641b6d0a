"""Where the energy of a motion goes: what drives put in, what dampers take, what bodies and springs hold."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .bodies import Machine
from .dynamics import Trajectory

Array = NDArray[np.float64]


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


def energy_balance(machine: Machine, motion: Trajectory) -> EnergyBalance:
    """Work of every part over a motion.

    Parameters
    ----------
    machine : Machine
    motion : Trajectory
        Kept at every step or nearly so: powers are integrated between the states that were kept.

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
