"""Adversarial starts: motions known to come within d of a boundary, built backwards from the extremum.

The extremum is put first: X at a depth d beyond or short of the boundary, X′ = 0, |X″| ≥ 1e-2. heyoka
integrates backwards from there to a start. So the truth about a depth of 1e-10 does not rest on any method
having found it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import cycle
from typing import Any

import numpy as np

from gearlash.system import System

from .heyoka_oracle import Oracle, Run, angle, fourier, gap, gap_velocity, region_of
from .pairs import KINDS, random_state, random_system


@dataclass(frozen=True)
class Graze:
    """A start from which X comes to an extremum at ``depth`` beyond (+) or short of (−) a boundary."""

    system: System
    start: np.ndarray
    phase: float  # of the start
    span: float  # cycles from the start to a little after the graze
    boundary: int
    from_contact: (
        bool  # minimum seen from inside contact (release), else maximum seen from the gap (engagement)
    )
    depth: float
    curvature: float
    extremum_phase: float
    truth: Run  # forward, over exactly [phase, phase + span]


def random_graze(
    rng: np.random.Generator, oracle: Oracle, system: System, depths: tuple[float, float] = (1e-10, 1e-3)
) -> Graze | None:
    """One graze, or None where the draw allows none (curvature of the wrong sign, useless start)."""
    state = random_state(rng, system)
    clearance = system.clearances[0]
    boundary = int(rng.choice([1, -1]))
    from_contact = bool(rng.integers(2))
    depth = float(rng.choice([-1, 1])) * 10 ** rng.uniform(*np.log10(depths))
    phase = float(rng.uniform(0, 1))
    level = clearance.gap_plus if boundary > 0 else -clearance.gap_minus
    outward = -boundary if from_contact else boundary
    state = _place(system, state, phase, level + outward * depth)
    curvature = gap_acceleration(system, state, phase)
    if curvature * outward > -1e-2:
        return None
    back = oracle.run(system, state, -_backward_cycles(rng, system), phase)
    start, start_phase = back.state.astype(float), float(back.end)
    if _boundary_distance(system, start, start_phase) < 1e-6 or np.abs(start).max() > 100.0:
        return None
    span = 1.5 * (phase - start_phase)
    truth = oracle.run(system, start, span, start_phase)
    return Graze(
        system, start, start_phase, span, boundary, from_contact, depth, float(curvature), phase, truth
    )


def grazes(
    seed: int, count: int, pair: str, oracle: Oracle, depths: tuple[float, float] = (1e-10, 1e-3)
) -> Iterator[Graze]:
    """``count`` grazes with depths of either sign in that range, through all kinds of parameters."""
    rng = np.random.default_rng(seed)
    made = 0
    for kind in cycle(KINDS):
        system, _ = random_system(rng, pair, kind)
        for _ in range(40):
            graze = random_graze(rng, oracle, system, depths)
            if graze is not None:
                made += 1
                yield graze
            if made == count:
                return


def gap_acceleration(system: System, state, phase) -> Any:
    """X″ for systems whose gap velocity is a state (no offset): row h·M of the field."""
    clearance, side = system.clearances[0], region_of(system, state, phase)
    row = clearance.h @ system.matrix
    rate = system.matrix @ state + fourier(system.forcing, angle(system, phase))
    force = clearance.damping * gap_velocity(system, state, phase)
    if side > 0:
        force += fourier(clearance.stiffness_plus, angle(system, phase)) * (
            gap(system, state, phase) - clearance.gap_plus
        )
    if side < 0:
        force += fourier(clearance.stiffness_minus, angle(system, phase)) * (
            gap(system, state, phase) + clearance.gap_minus
        )
    return row @ (rate + clearance.g * force)


def _place(system: System, state: np.ndarray, phase: float, displacement: float) -> np.ndarray:
    """The state with X = displacement and X′ = 0 (the last two states are X and X′)."""
    state = np.array(state)
    state[-2:] = displacement, 0.0
    if gap(system, state, phase) != displacement or gap_velocity(system, state, phase) != 0:
        raise ValueError("grazes are built for systems whose last states are X and X′")
    return state


def _backward_cycles(rng: np.random.Generator, system: System) -> float:
    """At most half a cycle and 3 units of τ: damping makes the backward flow grow."""
    return min(float(rng.uniform(0.02, 0.5)), float(rng.uniform(0.1, 3.0)) * system.omega / (2 * np.pi))


def _boundary_distance(system: System, state, phase: float) -> float:
    x, clearance = gap(system, state, phase), system.clearances[0]
    return float(min(abs(x - clearance.gap_plus), abs(x + clearance.gap_minus)))
