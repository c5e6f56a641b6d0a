"""What a near-touch of depth d does to a motion, to leading order, and the same from 80-bit integration.

An excursion δ = d − |a| τ²/2 of duration 2 τ0 = 2 √(2d/|a|) adds I = ∫δ = (4/3) √(2/|a|) d^{3/2} to what the
force would have been. With s = ±1 at ±D, η, ζ of the side and A the Jacobian of the region grazed from:

* a touch of δ, rules ``always`` (χ = 0) and ``in-contact`` (χ = 1):  w = s I (η g + χ ζ A g);
* a touch of P under ``no-tension`` (contact is lost, or found, in the overlap):  w = s I g;
* a touch of δ from the gap under ``no-tension``: the force is there while δ grows and gone while it falls, so
  its damping is not balanced:  w = s (ζ d g + (I/2) (η g + ζ A g + ζ² (h·A g) g)). It is linear in d.

w is the difference of the states, the true one minus that of the smooth one-sided system, at the extremum.
Rules ``always`` and ``in-contact``: Fredriksson, Nordmark, Proc. R. Soc. A 453 (1997) 1261; Bernardo, Budd,
Champneys, Physica D 160 (2001) 222, doi:10.1016/S0167-2789(01)00349-9.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearlash.system import ContactRule, System

from . import region_oracle
from .clearances import TAU, Real, Side, angle, series_value, sides
from .members import random_member, random_start
from .touches import place_early_touch, place_touch, surface_height

NEAR = Real(2e-4)  # τ, for the second difference that gives a0


@dataclass(frozen=True)
class Excursion:
    """A touch of known depth, and what it must do."""

    system: System
    side: Side
    early: bool  # P touches, else δ
    from_contact: bool
    depth: float
    at: float  # phase of the extremum
    a0: float
    begin: float  # phase of ``start``
    start: np.ndarray  # on the way to the touch, 80 bits
    end: float
    predicted: np.ndarray  # true minus held state at ``end``, by the law

    def measured(self) -> np.ndarray:
        """The same from two integrations in 80 bits."""
        span, held = self.end - self.begin, (self.side.clearance, self.side.sign, self.from_contact)
        real, smooth = (
            region_oracle.run(self.system, self.start, span, self.begin, held=h) for h in (None, held)
        )
        return real.state - smooth.state


def excursion(
    rng: np.random.Generator, size: int, rule: ContactRule, early: bool, from_contact: bool, depth: float
) -> Excursion:
    """A random one of depth ``depth`` beyond the surface, with 1/20 < |a0| and nothing else on the way."""
    while True:
        system, _ = random_member(rng, size, 1, (rule,))
        for side in sides(system):
            if side.damping > 0.05:
                found = _excursion(rng, system, side, early, from_contact, depth)
                if found is not None:
                    return found


def _excursion(rng, system: System, side: Side, early: bool, from_contact: bool, depth: float):
    phase, height = float(rng.uniform(0, 1)), -depth if from_contact else depth
    state = random_start(rng, system, phase).astype(Real)
    if early:
        state = place_early_touch(rng, system, side, state, phase, height, [])
    else:
        state = place_touch(system, side, state, phase, height, [])
    if state is None or np.abs(state).max() > 2.0:
        return None
    a0 = _curvature(system, side, early, from_contact, state, phase)
    if (a0 > 0) != from_contact or abs(a0) < 0.05:
        return None
    away = 0.02 * system.omega / (2 * np.pi) * 20  # 0.4 τ on either side
    held = (side.clearance, side.sign, from_contact)
    back = region_oracle.run(system, state, -away, phase, held=held)
    onward = region_oracle.run(system, state, away, phase, variational=True, held=held)
    real = region_oracle.run(system, back.state, 2 * away, back.end)
    if back.events or onward.events or len(real.events) != 2 or onward.jacobian is None:
        return None
    kick = onward.jacobian @ _kick(system, side, early, from_contact, depth, phase, abs(a0))
    return Excursion(
        system, side, early, from_contact, depth, phase, float(a0), float(back.end), back.state,
        float(onward.end), kick,
    )  # fmt: skip


def _curvature(system: System, side: Side, early: bool, from_contact: bool, state, phase: float):
    """a0 = d²/dτ² of the surface in the smooth system, by a second difference."""
    cycles, held = NEAR * Real(system.omega) / TAU, (side.clearance, side.sign, from_contact)
    heights = [surface_height(system, side, early, state, phase)]
    for way in (1, -1):
        there = region_oracle.run(system, state, way * cycles, phase, held=held)
        heights.append(surface_height(system, side, early, there.state, there.end))
    return (heights[1] + heights[2] - 2 * heights[0]) / NEAR**2


def _kick(system: System, side: Side, early: bool, from_contact: bool, depth: float, phase: float, a):
    """w at the extremum."""
    c, d = system.clearances[side.clearance], Real(depth)
    h, g, matrix = c.h.astype(Real), c.g.astype(Real), system.matrix.astype(Real)
    eta, zeta = series_value(side.stiffness, angle(system, phase)), Real(side.damping)
    always = c.contact is ContactRule.ALWAYS
    whole = Real(4) / 3 * np.sqrt(2 / a) * d ** Real(1.5)
    field = matrix + (zeta if always or from_contact else 0) * np.outer(g, h @ matrix)
    field = field + (eta if from_contact else 0) * np.outer(g, h)
    if early:
        return side.sign * whole * g
    if always:
        return side.sign * whole * eta * g
    both = eta * g + zeta * (field @ g)
    if c.contact is ContactRule.NO_TENSION:
        return side.sign * (zeta * d * g + whole / 2 * (both + zeta**2 * (h @ field @ g) * g))
    return side.sign * whole * both
