"""What a clearance is to the oracles: its gap, its velocity and its sides, in 80-bit arithmetic.

Time is counted in mesh cycles s, as in `heyoka_oracle`; a prime is d/dτ.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from gearlash.system import Clearance, ContactRule, System

Real = np.longdouble
TAU = 2 * Real("3.14159265358979323846264338327950288")
CUBED_I = np.array([1, 1j, -1, -1j], dtype=np.clongdouble)


def angle(system: System, phase) -> Any:
    """The phase of the series at mesh phase ``phase`` (cycles), in rad."""
    return TAU * Real(phase) / system.cycles


def series_taylor(coefficients, at, rate, order: int) -> np.ndarray:
    """Taylor coefficients (order + 1) in u of a Fourier array at the angle ``at`` + ``rate`` u, in rad."""
    c = np.asarray(coefficients, dtype=Real)
    out = np.zeros(order + 1, dtype=Real)
    out[0] = c[0]
    power = np.arange(order + 1)
    scale = Real(rate) ** power / np.cumprod(np.concatenate([[1], power[1:]]).astype(Real))
    for k in range(1, (len(c) + 1) // 2):
        if c[2 * k - 1] == 0 and c[2 * k] == 0:
            continue
        rotor = (c[2 * k - 1] - 1j * c[2 * k]) * (np.cos(k * at) + 1j * np.sin(k * at))
        out += (rotor * CUBED_I[power % 4]).real * Real(k) ** power * scale
    return out


def series_value(coefficients, at) -> Any:
    """Value of a Fourier array at an angle."""
    return series_taylor(coefficients, at, 0, 0)[0]


def gap(system: System, clearance: Clearance, state, phase) -> Any:
    """X = h·z − e(θ)."""
    read = clearance.h.astype(Real) @ np.asarray(state, dtype=Real)
    return read - series_value(clearance.offset, angle(system, phase))


def gap_velocity(system: System, clearance: Clearance, state, phase) -> Any:
    """X′ = h·(M z + b) − e′: no contact force acts on it, as all h·g = 0."""
    rate, at = Real(system.omega) / system.cycles, angle(system, phase)
    h = clearance.h.astype(Real)
    drift = h @ (system.matrix.astype(Real) @ np.asarray(state, dtype=Real))
    drift += series_value(h @ system.forcing.astype(Real), at)
    return drift - series_taylor(clearance.offset, at, rate, 1)[1]


def gap_acceleration(system: System, clearance: Clearance, state, phase, forces) -> Any:
    """X″ under the contact forces Φ_j of all clearances, ``forces`` (J,)."""
    rate, at = Real(system.omega) / system.cycles, angle(system, phase)
    h, matrix = clearance.h.astype(Real), system.matrix.astype(Real)
    forcing = system.forcing.astype(Real)
    field = matrix @ np.asarray(state, dtype=Real) + [series_value(row, at) for row in forcing]
    for other, force in zip(system.clearances, forces, strict=True):
        field = field + other.g * Real(force)
    push = series_taylor(h @ forcing, at, rate, 1)[1]
    return h @ matrix @ field + push - 2 * series_taylor(clearance.offset, at, rate, 2)[2]


@dataclass(frozen=True)
class Side:
    """One side with something to hit: δ = sign·X − edge > 0 is overlap, Φ = sign·(η δ + ζ δ′) there."""

    clearance: int
    sign: int  # +1 or −1
    edge: float
    stiffness: np.ndarray
    damping: float
    rule: ContactRule

    @property
    def releases_early(self) -> bool:
        """Can contact end while there is still overlap?"""
        return self.rule is ContactRule.NO_TENSION


def sides(system: System) -> list[Side]:
    """All sides of a system that act: by stiffness, or by a damping that is not shared with a side that has
    stiffness."""
    found = []
    for j, c in enumerate(system.clearances):
        shared = c.damping_minus is None
        minus = c.dampings[1]
        one_stiff = c.stiffness_plus.any() != c.stiffness_minus.any()
        stated = (0.0, 0.0) if shared and one_stiff else (c.damping, minus)
        for sign, edge, series, damping, own in (
            (1, c.gap_plus, c.stiffness_plus, c.damping, stated[0]),
            (-1, c.gap_minus, c.stiffness_minus, minus, stated[1]),
        ):
            if series.any() or (c.contact != ContactRule.ALWAYS and own != 0.0):
                found.append(Side(j, sign, float(edge), series, damping, c.contact))
    return found


def contact_forces(system: System, state, phase) -> list:
    """Φ_j of every clearance, its contacts told from the state alone."""
    at, forces = angle(system, phase), []
    for c in system.clearances:
        always = c.contact is ContactRule.ALWAYS
        forces.append(Real(c.damping) * gap_velocity(system, c, state, phase) if always else Real(0))
    for side in sides(system):
        c = system.clearances[side.clearance]
        delta = side.sign * gap(system, c, state, phase) - Real(side.edge)
        if delta > 0:
            push = series_value(side.stiffness, at) * delta
            if side.rule is not ContactRule.ALWAYS:
                push += Real(side.damping) * side.sign * gap_velocity(system, c, state, phase)
            none = side.rule is ContactRule.NO_TENSION and push < 0
            forces[side.clearance] += Real(0) if none else side.sign * push
    return forces
