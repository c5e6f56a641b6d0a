"""Periodic orbits that touch a boundary, solved for by shooting in 80 bit.

Around the touch the side is held as it was before (`region_oracle`), so that the motion is smooth there: no
touch is missed or doubled by rounding, whichever way the orbit lies. Unknowns are the state at a section half
a period before the touch and the parameter; equations are the return to it and the height of the extremum.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from gearlash.system import System

from . import region_oracle
from .clearances import Real, Side, angle, gap, gap_velocity, series_value, sides
from .motion import Walk
from .shooting import Found, refined

WINDOW = 2e-3  # mesh cycles on either side of the touch
BESIDE = Real(1e-5)  # mesh cycles, of differences in time
STEP = 1e-7  # of the parameter, over its scale


@dataclass(frozen=True)
class TouchAt:
    """What touches: δ of one side or, ``early``, what presses there (P), at a phase; ``from_contact``: it is
    a minimum, and the contact goes on through it. ``begins``: a minimum at which contact begins, under
    `no-tension`, where a little higher it begins before the boundary is reached, and a little lower behind
    it."""

    clearance: int
    boundary: int
    early: bool
    from_contact: bool
    phase: float
    begins: bool = False

    def side(self, system: System) -> Side:
        return next(s for s in sides(system) if s.clearance == self.clearance and s.sign == self.boundary)

    @property
    def held(self) -> tuple[int, int, bool]:
        return self.clearance, self.boundary, self.from_contact


def touching(
    build: Callable[[float], System],
    cycles: float,
    touch: TouchAt,
    state,
    value: float,
    scale: float = 1.0,
    window: float = WINDOW,
) -> Found:
    """The orbit of ``cycles`` mesh cycles near ``state`` (at phase zero) and ``value`` that touches."""
    ahead = touch.phase - 0.5 * cycles
    z = region_oracle.run(build(value), state, ahead).state
    shift = _whole_periods(ahead, build(value).cycles)
    phase, begin = touch.phase - shift, ahead - shift
    p, best = float(value), None
    for _ in range(12):
        pass_ = _Passage(build(p), touch, begin, cycles, phase, window).taken(z)
        defect = np.append(pass_.image - z, pass_.height)
        found = Found(z, p, pass_.monodromy, float(np.abs(defect).max()))
        if best is not None and found.defect > 0.3 * best.defect and best.defect < 1e-12:
            break
        best, phase = found, pass_.phase
        there = float(p + STEP * scale)
        other = _Passage(build(there), touch, begin, cycles, phase, window).taken(z)
        by_value = np.append(other.image - pass_.image, other.height - pass_.height)
        matrix = np.vstack([pass_.monodromy - np.eye(len(z)), pass_.slope])
        change = refined(np.column_stack([matrix, by_value / (Real(there) - Real(p))]), defect)
        z, p = z - change[:-1], float(p - change[-1])
    assert best is not None
    at_zero = region_oracle.run(build(best.value), best.state, -ahead % cycles, begin).state
    return Found(at_zero, best.value, best.monodromy, best.defect)


def _whole_periods(begin: float, cycles: int) -> float:
    """How far a phase may be moved so that it lies in the first base period."""
    return float(np.floor(begin / cycles) * cycles)


@dataclass(frozen=True)
class _Passage:
    """One return, from ``begin``, with the side held around ``near``."""

    system: System
    touch: TouchAt
    begin: float
    cycles: float
    near: float
    window: float

    def taken(self, state: np.ndarray) -> _Taken:
        system, held, start = self.system, self.touch.held, self.near - self.window
        first = region_oracle.run(system, state, Real(start) - self.begin, self.begin, variational=True)
        phase, there = self._extremum(first.state, start)
        through = there
        if not self.touch.begins:
            through = region_oracle.run(
                system, first.state, 2 * self.window, start, variational=True, held=held
            )
        rest = Real(self.begin) + Real(self.cycles) - through.end
        last = region_oracle.run(system, through.state, rest, through.end, variational=True)
        assert first.jacobian is not None
        assert there.jacobian is not None
        assert through.jacobian is not None
        assert last.jacobian is not None
        slope = self._gradient(phase) @ there.jacobian @ first.jacobian
        monodromy = last.jacobian @ through.jacobian @ first.jacobian
        return _Taken(last.state, monodromy, self._height(there.state, phase), slope, float(phase))

    def _extremum(self, state: np.ndarray, start: float) -> tuple[Real, Walk]:
        """Where the height is stationary, by parabolas through three points."""
        phase = Real(self.near)
        for _ in range(6):
            low, mid, high = (
                self._height(self._held(state, start, phase + d).state, phase + d)
                for d in (-BESIDE, Real(0), BESIDE)
            )
            step = BESIDE * (high - low) / (2 * (high + low - 2 * mid))
            phase = phase - step
            if abs(phase - self.near) > 0.9 * self.window:
                raise RuntimeError(f"no extremum within {self.window:g} of phase {self.near:.6g}")
            if abs(step) < 1e-10:
                break
        return phase, self._held(state, start, phase, variational=True)

    def _held(self, state, start: float, phase, variational: bool = False) -> Walk:
        return region_oracle.run(
            self.system, state, phase - Real(start), start, variational, held=self.touch.held
        )

    def _height(self, state: np.ndarray, phase) -> Real:
        """δ, or P."""
        system, side = self.system, self.touch.side(self.system)
        c = system.clearances[side.clearance]
        delta = side.sign * gap(system, c, state, phase) - Real(side.edge)
        if not self.touch.early:
            return delta
        rate = side.sign * gap_velocity(system, c, state, phase)
        return series_value(side.stiffness, angle(system, phase)) * delta + Real(side.damping) * rate

    def _gradient(self, phase) -> np.ndarray:
        """Of the height by the state."""
        side = self.touch.side(self.system)
        h = self.system.clearances[side.clearance].h.astype(Real)
        if not self.touch.early:
            return side.sign * h
        eta = series_value(side.stiffness, angle(self.system, phase))
        return side.sign * (eta * h + Real(side.damping) * h @ self.system.matrix.astype(Real))


@dataclass(frozen=True)
class _Taken:
    image: np.ndarray
    monodromy: np.ndarray
    height: Real
    slope: np.ndarray
    phase: float
