"""The mesh under a static torque, all else held: stiffness and transmission error over a mesh cycle."""

from __future__ import annotations

from math import cos, pi

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from gearlash.multibody.contact import MeshContact

Array = NDArray[np.float64]
STEP = 1e-8
"""Of the approach, m, for the slope of the force."""


def loaded_mesh(contact: MeshContact, torque: float, phases: int) -> tuple[Array, Array]:
    """Stiffness dF/dδ in N/m and approach in m over a mesh cycle, both normal to the flanks.

    Parameters
    ----------
    contact : MeshContact
    torque : float
        On the pinion, N·m; above 0.
    phases : int
        k/phases of a mesh cycle each.

    Returns
    -------
    stiffness, approach : ndarray, shape (phases,)
    """
    pair = contact.flanks.pair
    oblique = cos(pair.pinion.base_helix_angle)
    radii = [0.5 * gear.base_diameter for gear in pair.gears]
    wanted = torque / (radii[0] * oblique)
    still = np.zeros(12)

    def force(turn: float, approach: float) -> float:
        q = np.zeros(12)
        q[5] = turn
        q[11] = approach / (radii[1] * oblique) - turn * radii[0] / radii[1]
        return contact.details(q, still).normal[0]

    stiffness, approaches = np.empty(phases), np.empty(phases)
    touching = 0.0
    for k in range(phases):
        turn = 2.0 * pi * k / phases / pair.pinion.teeth
        high = max(touching, 1e-6)
        while force(turn, high) < wanted:
            high *= 1.5
        at = brentq(lambda x, turn=turn: force(turn, x) - wanted, 0.0, high, xtol=1e-13)
        assert isinstance(at, float)
        stiffness[k] = (force(turn, at + STEP) - force(turn, at - STEP)) / (2.0 * STEP)
        approaches[k] = at
        touching = at
    return stiffness, approaches
