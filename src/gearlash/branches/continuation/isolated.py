"""Whether an orbit is the only one near by at its value of the parameter: only then it lies on one branch."""

from __future__ import annotations

import numpy as np

from gearlash import flow
from gearlash.orbits import Orbit

from .equations import Array

AT_ONE = 1e-9  # of the monodromy less one: what is no motion in a direction
ASIDE = 1e-3  # of the scale: how far beside the orbit another one is tried
CLOSED = 1e-10  # of the scale: what such an orbit misses when it closes; beside a fold it is ASIDE squared


def isolated(orbit: Orbit, size: Array) -> bool:
    """Whether no orbit lies beside it where a multiplier is 1. ``size`` (n,): scale of the states."""
    moved = (orbit.shot.monodromy - np.eye(len(size))) * size / size[:, None]
    null = np.linalg.svd(moved)[2][-1]
    if float(np.linalg.norm(moved @ null)) > AT_ONE:
        return True
    for sign in (1.0, -1.0):
        beside = orbit.state + sign * ASIDE * size * null
        lap = flow.lap(orbit.propagators, beside, 1, float(orbit.shot.period))
        if float(np.abs((lap.end - beside) / size).max()) <= CLOSED:
            return False
    return True
