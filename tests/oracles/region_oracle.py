"""The whole class in 80-bit arithmetic: several clearances, every contact rule, one region after another.

heyoka integrates inside a region and knows of no events. Its Taylor polynomials give those of δ (overlap)
and, under `no-tension`, of P = η δ + ζ δ′ (what presses); `polynomials` finds all sign changes of them. Zeros
of several surfaces closer than 1e-17 of a cycle are one instant. A zero that was just crossed is divided out
of its polynomial, so the next one can be arbitrarily near. The same forwards and backwards, since no rule has
a memory: a side is in contact where δ > 0, under `no-tension` where P > 0 besides. Without damping P has the
sign of η, which then stands for it.

heyoka: Biscani, Izzo, MNRAS 504 (2021) 2614, doi:10.1093/mnras/stab1032.
"""

from __future__ import annotations

from functools import cache
from typing import Any, SupportsFloat

import heyoka as hy
import numpy as np

from gearlash.system import System

from .clearances import TAU, Real
from .heyoka_oracle import Slots
from .motion import Event, Motion, Walk

__all__ = ["Event", "RegionOracle", "Walk", "oracle", "run"]


@cache
def oracle(size: int, clearances: int, harmonics: int, variational: bool = False) -> RegionOracle:
    """Compiled once for every system of this shape."""
    return RegionOracle(size, clearances, harmonics, variational)


def run(
    system: System,
    state,
    cycles: SupportsFloat,
    phase: SupportsFloat = 0.0,
    variational: bool = False,
    held: tuple[int, int, bool] | None = None,
) -> Walk:
    """Integrate ``cycles`` mesh cycles (negative: backwards) from ``phase``. ``held``: (clearance, boundary,
    in contact or not) of one side that stays as it is: the one-sided, smooth system of a touch."""
    widths = [system.forcing.shape[1]]
    for c in system.clearances:
        widths += [len(c.stiffness_plus), len(c.stiffness_minus), len(c.offset)]
    harmonics = max(3, (max(widths) - 1) // 2)
    return oracle(system.size, len(system.clearances), harmonics, variational).run(
        system, state, cycles, phase, held
    )


class RegionOracle:
    """Integrator for every system of ``size`` states, that many clearances and harmonics."""

    def __init__(self, size: int, clearances: int, harmonics: int, variational: bool):
        self.size, self.count, self.harmonics = size, clearances, harmonics
        self._variational = variational
        self._slots = Slots()
        self._compile()

    def _compile(self) -> None:
        n, width, slots = self.size, 2 * self.harmonics + 1, self._slots
        z = np.atleast_1d(np.array(hy.make_vars(*[f"z{i}" for i in range(n)]), dtype=object))
        scale, turn = slots.block("scale").item(), slots.block("turn").item()
        rate = slots.block("rate").item()
        matrix, forcing = slots.block("matrix", (n, n)), slots.block("forcing", (n, width))
        cos = [hy.cos(float(k) * turn * hy.time) for k in range(1, self.harmonics + 1)]
        sin = [hy.sin(float(k) * turn * hy.time) for k in range(1, self.harmonics + 1)]

        def fourier(c):
            terms = [c[2 * k + 1] * cos[k] + c[2 * k + 2] * sin[k] for k in range(self.harmonics)]
            return hy.sum([c[0], *terms])

        def slope(c):
            terms = [
                float(k + 1) * (c[2 * k + 2] * cos[k] - c[2 * k + 1] * sin[k]) for k in range(self.harmonics)
            ]
            return rate * hy.sum(terms)

        linear = [hy.sum([*(matrix[i] * z), fourier(forcing[i])]) for i in range(n)]
        rates = list(linear)
        for j in range(self.count):
            h, g = slots.block(f"h{j}", (n,)), slots.block(f"g{j}", (n,))
            eta, offset = slots.block(f"eta{j}", (width,)), slots.block(f"offset{j}", (width,))
            edge, damping = slots.block(f"edge{j}").item(), slots.block(f"damping{j}").item()
            x = hy.sum(list(h * z)) - fourier(offset)
            velocity = hy.sum([h[i] * linear[i] for i in range(n)]) - slope(offset)
            force = fourier(eta) * (x - edge) + damping * velocity
            rates = [rates[i] + g[i] * force for i in range(n)]
        equations: Any = [(z[i], scale * rates[i]) for i in range(n)]
        if self._variational:
            equations = hy.var_ode_sys(equations, hy.var_args.vars, order=1)
        self._integrator = hy.taylor_adaptive(
            equations,
            np.zeros(n + n * n * self._variational, dtype=Real),
            fp_type=Real,
            tol=Real(1e-20),
            pars=np.zeros(slots.size, dtype=Real),
            compact_mode=True,
        )

    def _load(self, system: System) -> None:
        pars, write = self._integrator.pars, self._slots.write
        write(pars, "scale", TAU / Real(system.omega))  # dτ/ds
        write(pars, "rate", Real(system.omega) / system.cycles)  # of the phase of the series, per τ
        write(pars, "turn", TAU / system.cycles)  # the same per s
        write(pars, "matrix", system.matrix)
        write(pars, "forcing", system.forcing)
        for j, c in enumerate(system.clearances):
            write(pars, f"h{j}", c.h)
            write(pars, f"g{j}", c.g)
            write(pars, f"offset{j}", c.offset)

    def run(self, system: System, state, cycles, phase, held) -> Walk:
        """See `run`."""
        self._load(system)
        integrator, n = self._integrator, self.size
        integrator.time = Real(phase)
        integrator.state[:n] = np.asarray(state, dtype=Real)
        integrator.state[n:] = np.eye(n).ravel()[: integrator.state.size - n]
        motion = Motion(system, integrator, self._slots, forward=cycles >= 0)
        motion.begin(held)
        end = Real(phase) + Real(cycles)
        while motion.now != end:
            motion.advance(end)
        jacobian = integrator.state[n:].reshape(n, n).copy() if self._variational else None
        return Walk(integrator.state[:n].copy(), jacobian, motion.now, motion.events, motion.largest)
