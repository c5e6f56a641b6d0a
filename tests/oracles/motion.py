"""One motion through the regions of a system: the flags of all sides, what can change them, the events.

See `region_oracle`, which starts it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from gearlash.system import ContactRule, System

from .clearances import (
    TAU,
    Real,
    Side,
    angle,
    gap,
    gap_acceleration,
    gap_velocity,
    series_taylor,
    series_value,
    sides,
)
from .heyoka_oracle import Slots
from .polynomials import sign_changes, value

SAME = 1e-17  # of a mesh cycle: one instant
START = 4e-16  # X − D of a start that counts as on the boundary, over its size


@dataclass(frozen=True)
class Event:
    """One side that comes into contact or leaves it. ``slope`` is the rate per τ of the surface crossed (δ or
    P), ``velocity`` is X′; the state is that before any other event of the same instant."""

    phase: np.longdouble
    clearance: int
    boundary: int
    engaging: bool
    velocity: np.longdouble
    slope: np.longdouble
    early: bool  # the surface crossed is P
    state: np.ndarray


@dataclass(frozen=True)
class Walk:
    """A motion: where it ends, the derivative with respect to its start (or None), and every event."""

    state: np.ndarray
    jacobian: np.ndarray | None
    end: np.longdouble
    events: list[Event]
    largest: float  # ‖z‖ met on the way

    def contacts(self, clearances: int) -> list[list[int]]:
        """(J, 4): engagements at + and −, releases at + and −."""
        counts = [[0, 0, 0, 0] for _ in range(clearances)]
        for e in self.events:
            counts[e.clearance][(0 if e.engaging else 2) + (e.boundary < 0)] += 1
        return counts


@dataclass
class _Flags:
    """Per side: is there overlap, and does it press?"""

    beyond: list[bool]
    pressing: list[bool]


@dataclass
class _Surface:
    """What can change sign on a side: ``early`` for P, else δ, as a polynomial of u in [0, 1]."""

    side: int
    early: bool
    polynomial: np.ndarray
    crossed: bool = False
    zeros: list = field(default_factory=list)

    def find(self, positive: bool) -> None:
        """All zeros ahead. The sign at 0 is known from what happened before, not from rounding."""
        p, size = self.polynomial, float(np.abs(self.polynomial).max())
        if self.crossed:
            p = p[1:] if abs(p[1]) > 1e-17 * size else p[2:]  # a double zero: started at an extremum
        self.zeros = sign_changes(p)
        if (p[0] > 0) == positive:
            return
        if self.crossed or abs(p[0]) > 1e-16 * max(size, 1e-3):
            raise RuntimeError(f"a crossing was missed: side {self.side}, {p[:3]}, positive {positive}")
        self.zeros.insert(0, Real(0))  # passed within rounding of the end of the last step


class Motion:
    """One run: the flags of all sides, and the events so far."""

    def __init__(self, system: System, integrator, slots: Slots, forward: bool):
        self.system, self.integrator, self.slots = system, integrator, slots
        self.forward, self.events, self.largest = forward, [], 0.0
        self.held: int | None = None
        self.holding = False
        self.sides = sides(system)
        self.flags = _Flags([False] * len(self.sides), [False] * len(self.sides))
        self.crossed: set[tuple[int, bool]] = set()
        self.orders = max([1, *((w - 1) // 2 for w in self._widths())])

    def _widths(self):
        yield self.system.forcing.shape[1]
        for c in self.system.clearances:
            yield from (len(c.stiffness_plus), len(c.stiffness_minus), len(c.offset))

    @property
    def now(self):
        return Real(self.integrator.time)

    @property
    def state(self) -> np.ndarray:
        return self.integrator.state[: self.system.size]

    def touches(self, k: int) -> bool:
        """Is side k in contact?"""
        pressing = self.flags.pressing[k] or not self.sides[k].releases_early
        return self.flags.beyond[k] and pressing

    def overlap(self, side: Side) -> tuple[Any, Any]:
        """(δ, δ′) now."""
        c = self.system.clearances[side.clearance]
        x = side.sign * gap(self.system, c, self.state, self.now) - Real(side.edge)
        return x, side.sign * gap_velocity(self.system, c, self.state, self.now)

    def force(self, k: int) -> Any:
        """η δ + ζ δ′ of side k now, whether it acts or not."""
        side, (delta, rate) = self.sides[k], self.overlap(self.sides[k])
        eta = series_value(side.stiffness, angle(self.system, self.now))
        return eta * delta + Real(side.damping) * rate

    def presses(self, k: int, damped: bool) -> bool:
        """Whether side k presses: as ``damped`` says, or without damping as η says."""
        side = self.sides[k]
        if side.damping != 0.0:
            return damped
        return bool(series_value(side.stiffness, angle(self.system, self.now)) > 0)

    def begin(self, held: tuple[int, int, bool] | None) -> None:
        """Flags from the state. On a boundary it goes the way it moves, or will move."""
        on = []
        for k, side in enumerate(self.sides):
            if held is not None and held[:2] == (side.clearance, side.sign):
                self.held, self.holding = k, held[2]
        for k, side in enumerate(self.sides):
            delta, rate = self.overlap(side)
            self.flags.beyond[k] = bool(delta > 0)
            if abs(delta) <= START * max(abs(side.edge), float(np.abs(self.state).max())):
                on.append(k)
                self.flags.beyond[k] = bool(rate > 0) == self.forward
                self.crossed.add((k, False))
            self.flags.pressing[k] = self.presses(k, bool(self.force(k) > 0))
        for k in on:
            side, (_, rate) = self.sides[k], self.overlap(self.sides[k])
            if abs(rate) <= START * max(1.0, float(np.abs(self.state).max())):
                self.flags.beyond[k] = bool(side.sign * self.acceleration(side.clearance) > 0)
                self.flags.pressing[k] = self.presses(k, self.flags.beyond[k] and self.forward)
                if side.damping != 0.0:
                    self.crossed.add((k, True))
        if self.held is not None:
            self.flags.beyond[self.held] = self.flags.pressing[self.held] = self.holding
        for k, side in enumerate(self.sides):
            asked = side.releases_early and side.damping != 0.0
            if asked and self.flags.beyond[k] and k not in on and k != self.held:
                self._begin_on_press(k)
        self._switch()

    def _begin_on_press(self, k: int) -> None:
        """A start at P = 0 goes the way P goes."""
        side, (delta, rate) = self.sides[k], self.overlap(self.sides[k])
        at, turn = angle(self.system, self.now), Real(self.system.omega) / self.system.cycles
        eta, slope = series_taylor(side.stiffness, at, turn, 1)
        if abs(self.force(k)) > START * max(1.0, abs(eta * delta)):
            return
        bend = side.sign * self.acceleration(side.clearance)
        growth = slope * delta + eta * rate + Real(side.damping) * bend
        self.flags.pressing[k] = bool(growth > 0) == self.forward
        self.crossed.add((k, True))

    def acceleration(self, clearance: int) -> Any:
        """X″ of a clearance now, with the contacts that the flags say."""
        forces = [Real(0)] * len(self.system.clearances)
        for j, c in enumerate(self.system.clearances):
            if c.contact is ContactRule.ALWAYS:
                forces[j] = c.damping * gap_velocity(self.system, c, self.state, self.now)
        for k, side in enumerate(self.sides):
            if self.touches(k):
                forces[side.clearance] = side.sign * self.force(k)
        target = self.system.clearances[clearance]
        return gap_acceleration(self.system, target, self.state, self.now, forces)

    def _switch(self) -> None:
        """Tell the integrator which sides are in contact."""
        pars, write = self.integrator.pars, self.slots.write
        for j, c in enumerate(self.system.clearances):
            active = [s for k, s in enumerate(self.sides) if s.clearance == j and self.touches(k)]
            if len(active) > 1:
                raise RuntimeError("in contact on both sides at once")
            always = c.damping if c.contact is ContactRule.ALWAYS else 0.0
            write(pars, f"eta{j}", active[0].stiffness if active else 0.0 * c.stiffness_plus)
            write(pars, f"edge{j}", active[0].sign * active[0].edge if active else 0.0)
            write(pars, f"damping{j}", active[0].damping if active else always)

    def advance(self, end) -> None:
        """One Taylor step, or as far as the first event in it."""
        start = self.now
        limit = min(abs(end - start), Real(1.5) * self.system.cycles / (TAU * self.orders))
        before = self.integrator.state.copy()
        self.largest = max(self.largest, float(np.linalg.norm(self.state)))
        self.integrator.step(max_delta_t=limit if self.forward else -limit, write_tc=True)
        if abs(end - start) <= limit and abs(self.now - end) < 1e-18 * max(1, abs(end)):
            self.integrator.time = end
        step = self.now - start
        if not np.isfinite(self.integrator.state).all() or step == 0:
            raise RuntimeError(f"no step from phase {start}")
        surfaces = self._surfaces(start, step)
        self.crossed.clear()
        first = min((s.zeros[0] for s in surfaces if s.zeros), default=None)
        if first is None:
            return
        now = [s for s in surfaces if s.zeros and (s.zeros[0] - first) * abs(step) <= SAME]
        coefficients = self.integrator.tc * step ** np.arange(self.integrator.tc.shape[1])
        self.integrator.state[:] = value(list(coefficients.T), first) if first > 0 else before
        self.integrator.time = start + first * step
        self._cross(now, first, step)

    def _surfaces(self, start, step) -> list[_Surface]:
        """Everything that can change sign in the step just made, with its zeros."""
        system, order = self.system, self.integrator.tc.shape[1] - 1
        powers = step ** np.arange(order + 1)
        z = self.integrator.tc[: system.size] * powers
        at, turn = angle(system, start), angle(system, step)
        out = []
        for j, c in enumerate(system.clearances):
            x = c.h.astype(Real) @ z - series_taylor(c.offset, at, turn, order)
            for k, side in enumerate(self.sides):
                if side.clearance != j or k == self.held:
                    continue
                delta = side.sign * x
                delta[0] -= Real(side.edge)
                out.append(_Surface(k, False, delta, (k, False) in self.crossed))
                if side.releases_early and self.flags.beyond[k]:
                    eta = series_taylor(side.stiffness, at, turn, order)
                    press = self._press(side, eta, delta, step) if side.damping != 0.0 else eta
                    out.append(_Surface(k, True, press, (k, True) in self.crossed))
        for s in out:
            flags = self.flags.pressing if s.early else self.flags.beyond
            s.find(flags[s.side])
        return out

    def _press(self, side: Side, eta, delta, step) -> np.ndarray:
        """P = η δ + ζ δ′ as a polynomial of u."""
        order = len(delta) - 1
        rate = np.append(delta[1:] * np.arange(1, order + 1), Real(0))
        factor = Real(side.damping) * Real(self.system.omega) / (TAU * step)
        return np.convolve(eta, delta)[: order + 1] + factor * rate

    def _cross(self, surfaces: list[_Surface], at, step) -> None:
        """Apply all crossings of one instant; those that change a contact are events."""
        here, before = self.state.copy(), [self.touches(k) for k in range(len(self.sides))]
        slopes = {}
        for s in surfaces:
            flags = self.flags.pressing if s.early else self.flags.beyond
            flags[s.side] = not flags[s.side]
            self.crossed.add((s.side, s.early))
            slope = value(list(s.polynomial[1:] * np.arange(1, len(s.polynomial))), at) / step
            slopes[s.side] = slope * Real(self.system.omega) / TAU
            if s.early and self.sides[s.side].damping == 0.0:
                slopes[s.side] *= self.overlap(self.sides[s.side])[0]
            if not s.early:  # P = ζ δ′ on this boundary
                self.flags.pressing[s.side] = self.presses(s.side, flags[s.side] == self.forward)
        changed = [k for k in slopes if self.touches(k) != before[k]]
        for k in sorted(changed, key=lambda k: (self.touches(k) == self.forward, k)):
            side, engaging = self.sides[k], self.touches(k) == self.forward
            velocity = side.sign * self.overlap(side)[1]
            early = any(s.side == k and s.early for s in surfaces)
            self.events.append(
                Event(self.now, side.clearance, side.sign, engaging, velocity, slopes[k], early, here)
            )
            if not early:
                self._saltation(side, into=self.touches(k))
        self._switch()

    def _saltation(self, side: Side, into: bool) -> None:
        """Where the field jumps by ζ δ′ at δ = 0: I ± ζ g hᵀ, as h·g = 0."""
        n, c = self.system.size, self.system.clearances[side.clearance]
        if side.rule is ContactRule.ALWAYS or self.integrator.state.size == n:
            return
        tangents = self.integrator.state[n:].reshape(n, n).copy()
        jump = (1 if into else -1) * Real(side.damping) * np.outer(c.g.astype(Real), c.h.astype(Real))
        self.integrator.state[n:] = (tangents + jump @ tangents).ravel()
