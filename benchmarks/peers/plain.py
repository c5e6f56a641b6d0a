"""A gear pair as the peers need it: the same equations written out by hand, without this package's engine.

Bearings are pairs (position, velocity), the last pair is (X, X'):

    y_i' = v_i,   v_i' = k_i y_i + d_i v_i + g_i Φ,   X″ = Σ (a_i y_i + b_i v_i) + f(t) + g Φ
    Φ = η(t) (s X - w) + ζ X',   (s, w) = (1, D) | (0, 0) | (1, -D) in the three regions
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numba
import numpy as np
from numpy.typing import NDArray

from gearlash.system import ContactRule, GearlashError, System

Array = NDArray[np.float64]


class Numbers(NamedTuple):
    """What the right-hand side reads."""

    rate: float  # of the phase, per τ
    own: Array  # (n/2, 2): what each velocity's equation takes of its own pair
    last: Array  # (n,): what X″ takes of the whole state
    g: Array  # (n/2,)
    stiffness: Array
    forcing: Array
    damping: float


@dataclass(frozen=True, eq=False)
class Pair:
    """A system of this shape. Raises `GearlashError` for another."""

    system: System
    numbers: Numbers

    @staticmethod
    def of(system: System) -> Pair:
        (c,) = system.clearances
        n, m = system.size, system.matrix
        unit = np.zeros(n)
        unit[-2] = 1.0
        expected = np.zeros_like(m)
        for i in range(0, n, 2):
            expected[i, i + 1] = 1.0
            expected[i + 1, i : i + 2] = m[i + 1, i : i + 2]
        expected[-1] = m[-1]
        fits = (
            np.array_equal(c.h, unit)
            and np.array_equal(m, expected)
            and not system.forcing[:-1].any()
            and not c.offset.any()
            and not c.g[::2].any()
            and c.gap_plus == c.gap_minus
            and np.array_equal(c.stiffness_plus, c.stiffness_minus)
            and c.contact is ContactRule.ALWAYS
        )
        if not fits:
            raise GearlashError("the peers of the benchmark are written for gear pairs of the rule 'always'")
        own = np.array([m[i + 1, i : i + 2] for i in range(0, n, 2)])
        numbers = Numbers(
            system.omega / system.cycles, own, m[-1].copy(), c.g[1::2].copy(),
            c.stiffness_plus.copy(), system.forcing[-1].copy(), c.damping,
        )  # fmt: skip
        return Pair(system, numbers)

    @property
    def edge(self) -> float:
        return self.system.clearances[0].gap_plus

    def region(self, z: Array) -> int:
        """+1, 0, -1: contact on the drive side, none, contact on the back side."""
        return int(z[-2] > self.edge) - int(z[-2] < -self.edge)


@numba.njit(error_model="numpy", fastmath=True)
def series(c, phase):
    """A Fourier series at a phase in rad."""
    value = c[0]
    for k in range(1, (len(c) + 1) // 2):
        if c[2 * k - 1] != 0.0:
            value += c[2 * k - 1] * np.cos(k * phase)
        if c[2 * k] != 0.0:
            value += c[2 * k] * np.sin(k * phase)
    return value


@numba.njit(error_model="numpy", fastmath=True)
def rates(p, stiffness, forcing, z, s, w, out):
    """The right-hand side in the region (s, w) into ``out`` (n,), for given η and f."""
    n = len(out)
    x, v = z[n - 2], z[n - 1]
    force = stiffness * (s * x - w) + p.damping * v
    last = forcing + p.g[n // 2 - 1] * force + p.last[n - 2] * x + p.last[n - 1] * v
    for i in range(n // 2 - 1):
        y, rate = z[2 * i], z[2 * i + 1]
        out[2 * i] = rate
        out[2 * i + 1] = p.own[i, 0] * y + p.own[i, 1] * rate + p.g[i] * force
        last += p.last[2 * i] * y + p.last[2 * i + 1] * rate
    out[n - 2] = v
    out[n - 1] = last


@numba.njit(error_model="numpy", fastmath=True)
def rates_at(p, t, z, s, w, out):
    """`rates` at a time."""
    rates(p, series(p.stiffness, p.rate * t), series(p.forcing, p.rate * t), z, s, w, out)
