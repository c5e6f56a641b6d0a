"""One degree of freedom with constant stiffness on either side: every crossing in closed form (mpmath).

Contact rules `always` and `in-contact`; under both, contact begins and ends at X = ±D.

Inside a region the solution is exponentials and harmonics; only its roots are searched. The grid brackets
roots of X ∓ D and of X′; between two neighbours with X′ of one sign X is monotone, so no pair of roots hides.
"""

from __future__ import annotations

from itertools import pairwise

import mpmath as mp
import numpy as np

from gearlash.system import ContactRule, System


class _Region:
    """One degree of freedom, X″ + ζX′ + k(X − c) = f(θ) with constants k, c: exact state from any start."""

    def __init__(self, omega, damping, stiffness, centre, forcing):
        self.omega, self.matrix = omega, mp.matrix([[0, 1], [-stiffness, -damping]])
        self.damping, self.stiffness = damping, stiffness
        self.forcing = [mp.mpf(f) for f in forcing]
        self.forcing[0] += stiffness * centre
        discriminant = mp.sqrt(damping**2 / 4 - stiffness)
        self.roots = (-damping / 2 + discriminant, -damping / 2 - discriminant)

    def steady(self, t):
        """A particular solution (X, X′); without stiffness the mean force drives a drift."""
        x, v = mp.mpf(0), mp.mpf(0)
        mean = self.forcing[0]
        if self.stiffness != 0:
            x = mean / self.stiffness
        elif self.damping != 0:
            x, v = mean / self.damping * t, mean / self.damping
        else:
            x, v = mean * t**2 / 2, mean * t
        for n in range(1, (len(self.forcing) - 1) // 2 + 1):
            w = n * self.omega
            amplitude = self.forcing[2 * n - 1] - mp.j * self.forcing[2 * n]
            amplitude /= self.stiffness - w**2 + mp.j * self.damping * w
            turn = amplitude * mp.expj(w * t)
            x, v = x + turn.real, v + (1j * w * turn).real
        return x, v

    def state(self, t, t0, start):
        """(X, X′) at t of the solution that is ``start`` at t0."""
        x0, v0 = self.steady(t0)
        x, v = start[0] - x0, start[1] - v0
        a, b = self.roots
        if mp.almosteq(a, b):
            decay = mp.exp(a * (t - t0))
            free = (decay * (x + (v - a * x) * (t - t0)), decay * (v + a * (v - a * x) * (t - t0)))
        else:
            p, q = (v - b * x) / (a - b), (a * x - v) / (a - b)
            ea, eb = mp.exp(a * (t - t0)), mp.exp(b * (t - t0))
            free = (p * ea + q * eb, a * p * ea + b * q * eb)
        xs, vs = self.steady(t)
        return mp.re(free[0]) + xs, mp.re(free[1]) + vs


def exact_impacts(system: System, state, cycles: int, phase: float = 0.0, digits: int = 40, grid: int = 200):
    """(state, crossings) after ``cycles`` mesh cycles; crossings are (phase, boundary, engaging, X′)."""
    (c,) = system.clearances
    if len(c.stiffness_plus) > 1 and np.any(c.stiffness_plus[1:]):
        raise ValueError("exact_impacts needs constant stiffness")
    if c.contact is ContactRule.NO_TENSION:
        raise ValueError("under no-tension contact ends before X = ±D")
    always = c.contact is ContactRule.ALWAYS
    damping: dict[int, float] = {1: c.dampings[0], 0: c.damping if always else 0.0, -1: c.dampings[1]}
    with mp.workdps(digits):
        omega = mp.mpf(system.omega)
        regions = {
            side: _Region(omega, mp.mpf(damping[side]), mp.mpf(k), mp.mpf(centre), system.forcing[1])
            for side, k, centre in (
                (1, float(c.stiffness_plus[0]), c.gap_plus),
                (0, 0.0, 0.0),
                (-1, float(c.stiffness_minus[0]), -c.gap_minus),
            )
        }
        t0, start = 2 * mp.pi * mp.mpf(phase) / omega, (mp.mpf(state[0]), mp.mpf(state[1]))
        end = t0 + 2 * mp.pi * cycles / omega
        side = int(start[0] > c.gap_plus) - int(start[0] < -c.gap_minus)
        crossings = []
        while True:
            event = _next_crossing(regions[side], t0, start, end, side, c, 2 * mp.pi / omega / grid)
            if event is None:
                return regions[side].state(end, t0, start), crossings
            t0, start, boundary, outward = event
            crossings.append((t0 * omega / (2 * mp.pi), boundary, outward, start[1]))
            side = boundary if outward else 0


def _next_crossing(region, t0, start, end, side, clearance, step):
    """First t > t0 where the solution leaves its region: (t, state, boundary, engaging), or None."""
    bounds = {1: [(1, clearance.gap_plus)], -1: [(-1, -clearance.gap_minus)]}.get(
        side, [(1, clearance.gap_plus), (-1, -clearance.gap_minus)]
    )
    left, count = t0, 0
    while left < end:
        count += 1
        right = min(t0 + count * step, end)
        stops = _monotone_pieces(region, t0, start, left, right)
        for a, b in pairwise(stops):
            x = region.state(b, t0, start)[0]
            for boundary, level in bounds:
                beyond = boundary * (x - level) > 0
                if beyond == (side == 0):
                    t = _root(lambda s, c=level: region.state(s, t0, start)[0] - c, a, b)
                    here = region.state(t, t0, start)
                    return t, (mp.mpf(level), here[1]), boundary, bool(side == 0)
        left = right
    return None


def _monotone_pieces(region, t0, start, left, right):
    velocities = region.state(left, t0, start)[1], region.state(right, t0, start)[1]
    if velocities[0] * velocities[1] < 0:
        return [left, _root(lambda s: region.state(s, t0, start)[1], left, right), right]
    return [left, right]


def _root(function, a, b):
    """Bisection to a narrow bracket, then secant steps that stay in it."""
    fa = function(a)
    for _ in range(30):
        middle = (a + b) / 2
        fm = function(middle)
        if (fm > 0) == (fa > 0) and fa != 0:
            a, fa = middle, fm
        else:
            b = middle
    return mp.findroot(function, (a, b), solver="anderson", verify=False)
