"""CVODE of SUNDIALS by scikit-sundae: a compiled variable-order Adams method with rootfinding; the jitted
right-hand side is called through Python.

Hindmarsh et al., ACM TOMS 31 (2005) 363, doi:10.1145/1089014.1089020.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import sksundae.cvode

from .plain import Array, Pair, rates_at

TOLERANCE = 1e-13
HOW = f"Adams, rtol = atol = {TOLERANCE:g}, rootfinding, jitted right-hand side called through Python"


class Cvode:
    """One trajectory; ``crossings`` of the last one: (τ, boundary, outward)."""

    def __init__(self, pair: Pair):
        self.pair, self.crossings, self.region = pair, [], 0

        def rhs(t, z, out):
            rates_at(pair.numbers, t, z, float(abs(self.region)), self.region * pair.edge, out)

        def gaps(t, z, out):
            out[0], out[1] = z[-2] - pair.edge, z[-2] + pair.edge

        self.solver: Any = sksundae.cvode.CVODE(
            rhs, method="Adams", rtol=TOLERANCE, atol=TOLERANCE, eventsfn=gaps, num_events=2,
            max_num_steps=1_000_000,
        )  # fmt: skip

    def carry(self, z: Array, periods: int) -> Array:
        """The state (n,) after that many base periods from phase zero."""
        state, t, end = np.array(z), 0.0, periods * self.pair.system.period
        self.region, self.crossings = self.pair.region(state), []
        while t < end:
            found = self.solver.solve([t, end], state)
            t, state = float(found.t[-1]), np.array(found.y[-1])
            if found.i_events is None or not len(found.i_events):
                break
            self._cross(t, found.i_events[-1])
        return state

    def _cross(self, t: float, signs) -> None:
        boundary = 1 if signs[0] else -1
        outward = int(signs[0] or signs[1]) == boundary
        region = boundary if outward else 0
        if region != self.region:  # a root that is reported again after the restart changes nothing
            self.region = region
            self.crossings.append((t, boundary, outward))
