"""What everybody writes: fixed-step Runge–Kutta of order four, jitted, that looks at the region in each stage
and never at the instant of a crossing. All numbers of the pair are constants of the compiled code, and
stiffness and forcing are tabulated once for all half steps."""

from __future__ import annotations

from collections.abc import Callable

import numba
import numpy as np

from .plain import Array, Pair, series

STEPS = 256  # a base period
HOW = f"{STEPS} steps a period, numba, the region read from X in every stage, crossings not located"


class RungeKutta:
    """One trajectory."""

    crossings = None

    def __init__(self, pair: Pair):
        self.pair, self.march = pair, _compiled(pair)

    def carry(self, z: Array, periods: int) -> Array:
        """The state (n,) after that many base periods from phase zero."""
        state = np.array(z)
        self.march(state, periods)
        return state


def _compiled(pair: Pair) -> Callable:
    """The march of this pair: numba takes what a function encloses as constants."""
    numbers, n, edge = pair.numbers, pair.system.size, pair.edge
    own, last, g, damping = numbers.own, numbers.last, numbers.g, numbers.damping
    half = np.arange(2 * STEPS + 1) * np.pi / STEPS  # of the base period
    eta = np.array([series(numbers.stiffness, phase) for phase in half])
    push = np.array([series(numbers.forcing, phase) for phase in half])
    h = pair.system.period / STEPS

    @numba.njit(error_model="numpy", fastmath=True)
    def rates(at, z, out):
        x, v = z[n - 2], z[n - 1]
        beyond = x - edge if x > edge else x + edge if x < -edge else 0.0
        force = eta[at] * beyond + damping * v
        acceleration = push[at] + g[n // 2 - 1] * force + last[n - 2] * x + last[n - 1] * v
        for i in range(n // 2 - 1):
            out[2 * i] = z[2 * i + 1]
            out[2 * i + 1] = own[i, 0] * z[2 * i] + own[i, 1] * z[2 * i + 1] + g[i] * force
            acceleration += last[2 * i] * z[2 * i] + last[2 * i + 1] * z[2 * i + 1]
        out[n - 2] = v
        out[n - 1] = acceleration

    @numba.njit(error_model="numpy", fastmath=True, nogil=True)
    def march(z, periods):
        k1, k2, k3, k4, there = np.empty(n), np.empty(n), np.empty(n), np.empty(n), np.empty(n)
        for step in range(STEPS * periods):
            at = 2 * (step % STEPS)
            rates(at, z, k1)
            for i in range(n):
                there[i] = z[i] + 0.5 * h * k1[i]
            rates(at + 1, there, k2)
            for i in range(n):
                there[i] = z[i] + 0.5 * h * k2[i]
            rates(at + 1, there, k3)
            for i in range(n):
                there[i] = z[i] + h * k3[i]
            rates(at + 2, there, k4)
            for i in range(n):
                z[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i])

    return march
