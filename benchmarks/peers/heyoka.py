"""heyoka: Taylor's method of order 19, compiled for one system, its crossings as terminal events.

Biscani, Izzo, MNRAS 504 (2021) 2614, doi:10.1093/mnras/stab1032.

Used as one who knows it would: every number that never changes is a constant of the compiled code, only the
region is a parameter, which the callback of an event writes through a view taken once; no compact mode, fast
math on (its error stays at rounding). The same in 80-bit arithmetic with tolerance 1e-20 is the reference.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import heyoka as hy
import numpy as np

from gearlash.system import System

from .plain import Array, Pair

Real = np.longdouble
TAU = 2 * Real("3.14159265358979323846264338327950288")
TOLERANCE, FINEST = 1e-15, 1e-20
HOW = f"tol {TOLERANCE:g}, terminal events, fast math, no compact mode"
SWITCH, EDGE, DURATION, GAP, FORCING = 0, 1, 2, 3, 4  # places among the runtime parameters


class Model:
    """Equations of a pair in heyoka's expressions, and the runtime parameters that go with them.

    ``free``: duration of the period, gap and forcing are parameters too, and time counts base periods, so
    that one compilation serves a whole plane of (ω, D)."""

    def __init__(self, pair: Pair, free: bool = False):
        self.free, self.size = free, pair.system.size
        n, p = self.size, pair.numbers
        z = hy.make_vars(*[f"z{i}" for i in range(n)])
        phase = (2 * np.pi if free else p.rate) * hy.time
        self.stiffness = _nonzero(p.stiffness)
        self.forced = _nonzero(p.forcing)
        places = {k: hy.par[FORCING + i] if free else float(p.forcing[k]) for i, k in enumerate(self.forced)}
        forcing = _series({k: places[k] for k in self.forced}, phase)
        eta = _series({k: float(p.stiffness[k]) for k in self.stiffness}, phase)
        self.gap, self.velocity = z[n - 2], z[n - 1]
        force = eta * (hy.par[SWITCH] * self.gap - hy.par[EDGE]) + p.damping * self.velocity
        rates = []
        for i in range(n // 2):
            terms = [c * z[2 * i + k] for k, c in enumerate(p.own[i].tolist()) if c]
            if 2 * i + 2 == n:
                terms = [c * z[j] for j, c in enumerate(p.last.tolist()) if c] + [forcing]
            rates += [z[2 * i + 1], hy.sum([*terms, float(p.g[i]) * force])]
        scale = hy.par[DURATION] if free else 1.0
        self.equations: Any = [(var, scale * rate) for var, rate in zip(z, rates, strict=True)]
        edge = pair.edge
        self.above = self.gap - (hy.par[GAP] if free else edge)
        self.below = self.gap + (hy.par[GAP] if free else edge)

    def parameters(self, pair: Pair, z: Array) -> list[float]:
        """Values of the runtime parameters at a start."""
        region = pair.region(z)
        switches = [float(abs(region)), region * pair.edge]
        if not self.free:
            return switches
        return [*switches, pair.system.period, pair.edge, *pair.numbers.forcing[self.forced]]


class Heyoka:
    """One trajectory. With ``record`` ``crossings`` of the last one are kept: (τ, boundary, outward).
    ``real``: float, or 80-bit `numpy.longdouble` with tolerance 1e-20."""

    def __init__(self, pair: Pair, *, real: type = float, record: bool = False):
        self.pair, self.real, self.crossings = pair, real, []
        self.model = model = Model(pair)
        box: list[Any] = []
        kept = self.crossings if record else None
        events = [
            hy.t_event(model.above, callback=_single(box, 1, pair.edge, kept), fp_type=real),
            hy.t_event(model.below, callback=_single(box, -1, pair.edge, kept), fp_type=real),
        ]
        self.integrator: Any = hy.taylor_adaptive(
            model.equations,
            np.zeros(model.size, dtype=real),
            fp_type=real,
            tol=real(TOLERANCE if real is float else FINEST),
            pars=np.zeros(2, dtype=real),
            t_events=events,
            compact_mode=real is not float,
            fast_math=real is float,
        )
        box.append(self.integrator.pars)

    def carry(self, z: Array, periods: int) -> Array:
        """The state (n,) after that many base periods from phase zero."""
        ta, system = self.integrator, self.pair.system
        self.crossings.clear()
        ta.time = self.real(0.0)
        ta.state[:] = z
        ta.pars[:] = self.model.parameters(self.pair, z)
        ta.reset_cooldowns()
        ta.propagate_until(self.real(duration(system) * periods), max_steps=100_000_000)
        return ta.state.copy()


class HeyokaBatch:
    """As many trajectories side by side as the batch has lanes."""

    def __init__(self, pair: Pair, lanes: int):
        self.pair, self.lanes = pair, lanes
        self.model = model = Model(pair)
        box: list[Any] = []
        events = [
            hy.t_event_batch(model.above, callback=_lane(box, 1, pair.edge)),
            hy.t_event_batch(model.below, callback=_lane(box, -1, pair.edge)),
        ]
        self.integrator: Any = hy.taylor_adaptive_batch(
            model.equations,
            np.zeros((model.size, lanes)),
            tol=TOLERANCE,
            pars=np.zeros((2, lanes)),
            t_events=events,
            fast_math=True,
        )
        box.append(self.integrator.pars)

    def carry(self, states: Array, periods: int) -> Array:
        """The states (lanes, n) after that many base periods from phase zero."""
        ta = self.integrator
        ta.set_time(0.0)
        ta.state[:] = states.T
        for lane, z in enumerate(states):
            ta.pars[:, lane] = self.model.parameters(self.pair, z)
        ta.reset_cooldowns()
        ta.propagate_until(float(duration(self.pair.system)) * periods)
        return ta.state.T.copy()

    def carry_all(self, states: Array, periods: int) -> Array:
        """The same of any multiple of that many states."""
        blocks = range(0, len(states), self.lanes)
        return np.concatenate([self.carry(states[at : at + self.lanes], periods) for at in blocks])


def duration(system: System) -> np.longdouble:
    """Of a base period, in 80-bit arithmetic."""
    return TAU * system.cycles / Real(system.omega)


def lanes() -> tuple[int, ...]:
    """Widths of the batch worth trying: what heyoka recommends for this processor, and half of that."""
    width = hy.recommended_simd_size()
    return max(1, width // 2), width


def _single(box: list, boundary: int, edge: float, kept: list | None) -> Callable:
    """Callback of a terminal event: writes the region into the parameters. A function, not an object, as
    heyoka copies its callbacks."""
    level = boundary * edge

    def switch(ta, sign):
        outward, pars = sign == boundary, box[0]
        pars[SWITCH] = 1.0 if outward else 0.0
        pars[EDGE] = level if outward else 0.0
        return True

    if kept is None:
        return switch

    def switch_and_keep(ta, sign):
        kept.append((ta.time, boundary, sign == boundary))
        return switch(ta, sign)

    return switch_and_keep


def _lane(box: list, boundary: int, edge: float) -> Callable:
    level = boundary * edge

    def switch(ta, sign, lane):
        outward, pars = sign == boundary, box[0]
        pars[SWITCH, lane] = 1.0 if outward else 0.0
        pars[EDGE, lane] = level if outward else 0.0
        return True

    return switch


def _nonzero(series: Array) -> list[int]:
    return [0, *(int(k) for k in np.flatnonzero(series) if k)]


def _series(coefficients: dict[int, Any], phase: Any) -> Any:
    """Sum of a Fourier array's terms: its places are mean, cos, sin, cos 2, sin 2 …"""
    terms = []
    for place, value in coefficients.items():
        order = float((place + 1) // 2)
        wave = hy.cos(order * phase) if place % 2 else hy.sin(order * phase)
        terms.append(value * wave if place else hy.expression(value) if isinstance(value, float) else value)
    return hy.sum(terms)
