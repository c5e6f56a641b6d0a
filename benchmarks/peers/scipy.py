"""scipy: solve_ivp, DOP853, stopped at every crossing and started anew, with a jitted right-hand side.

Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, 1993, doi:10.1007/978-3-540-78862-1.
"""

from __future__ import annotations

from dataclasses import dataclass

import numba
import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from .plain import Array, Pair, rates, rates_at, series

RTOL, ATOL = 1e-12, 1e-13
MULTIPLIERS = f"variational equations, DOP853, rtol {RTOL:g}, restarted at crossings, eigenvalues by numpy"
HOW = f"DOP853, rtol {RTOL:g}, atol {ATOL:g}, terminal events, jitted right-hand side"


@dataclass(frozen=True)
class _Exit:
    """An event as solve_ivp wants it: X reaches ``edge`` in one direction, and the integration ends."""

    edge: float
    direction: int
    terminal: bool = True

    def __call__(self, t: float, z: Array) -> float:
        return z[-2] - self.edge


class Scipy:
    """One trajectory; ``crossings`` of the last one: (τ, boundary, outward)."""

    def __init__(self, pair: Pair):
        self.pair, self.crossings = pair, []

    def carry(self, z: Array, periods: int) -> Array:
        """The state (n,) after that many base periods from phase zero."""
        state, t, end = np.array(z), 0.0, periods * self.pair.system.period
        region, self.crossings = self.pair.region(state), []
        while True:
            found = solve_ivp(
                self._rates(region),
                (t, end),
                state,
                "DOP853",
                events=self._exits(region),
                rtol=RTOL,
                atol=ATOL,
            )
            t, state = float(found.t[-1]), found.y[:, -1]
            if found.status != 1:
                return state
            boundary = region or (1 if len(found.t_events[0]) else -1)
            region = 0 if region else boundary
            self.crossings.append((t, boundary, region != 0))

    def _rates(self, region: int):
        numbers, s, w = self.pair.numbers, float(abs(region)), region * self.pair.edge

        def rhs(t, z):
            out = np.empty_like(z)
            rates_at(numbers, t, z, s, w, out)
            return out

        return rhs

    def _exits(self, region: int):
        """The boundaries of a region, each with the direction in which it is left: where the motion came in,
        the same boundary is not met again at once."""
        if region:
            return [self._exit(region, -region)]
        return [self._exit(1, 1), self._exit(-1, -1)]

    def _exit(self, boundary: int, direction: int) -> _Exit:
        return _Exit(boundary * self.pair.edge, direction)


class Monodromy(Scipy):
    """Multipliers from the variational equations: tangents, one after the other, and then the state. The
    field is continuous under the rule 'always', so tangents go through crossings unchanged."""

    def multipliers(self, z: Array, period: int) -> NDArray[np.complex128]:
        """All multipliers (n,) of the orbit through ``z``."""
        n = len(z)
        end = self.carry(np.concatenate([np.eye(n).ravel(), z]), period)
        return np.linalg.eigvals(end[: n * n].reshape(n, n)).astype(np.complex128)

    def _rates(self, region: int):
        numbers, s, w = self.pair.numbers, float(abs(region)), region * self.pair.edge

        def rhs(t, z):
            out = np.empty_like(z)
            _variational(numbers, t, z, s, w, out)
            return out

        return rhs


@numba.njit(error_model="numpy", fastmath=True)
def _variational(p, t, z, s, w, out):
    n = len(p.last)
    stiffness = series(p.stiffness, p.rate * t)
    for k in range(n):
        rates(p, stiffness, 0.0, z[k * n : (k + 1) * n], s, 0.0, out[k * n : (k + 1) * n])
    rates(p, stiffness, series(p.forcing, p.rate * t), z[n * n :], s, w, out[n * n :])
