"""Bodies in space in the directions of the lumped model, with its line of action: the same physics."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import gearlash as gl
from gearlash.multibody import (
    Bearings,
    Machine,
    RigidBody,
    Solver,
    energy_balance,
    natural_frequencies,
    simulate,
)
from gearlash.system import ContactRule

from .lumped import C_Y, C_Z, HELD, MASSES, STIFFNESS, both

Array = NDArray[np.float64]
STEPS, FIXED, JUMPS = 1024, 1e-6, 2e-4
"""Steps a mesh cycle of classical Runge–Kutta, which has no tolerance, and bounds on every state over half
the backlash. Where damping ends at the edge of the gap the force jumps, and a fixed step meets the jump with
an error of first order."""
TOLERANCE, ADAPTED = 1e-10, 1e-8
"""Of the method of Dormand and Prince, whose longest step is 1/64 of a mesh cycle, and the bound there."""


@pytest.mark.parametrize(
    ("omega", "start", "rule"),
    [
        (omega, start, rule)
        for rule in ContactRule
        for omega, start in ((0.942, 1.1), (1.047, 1.1), (0.942, -1.05))
    ],
)
def test_motion_of_the_lumped_model_comes_out(omega: float, start: float, rule: ContactRule):
    """Impacts and the back side included, under all contact rules: two of them have a force that jumps."""
    off = _off(omega, start, rule, steps=64, solver=Solver.DOPRI5, tolerance=TOLERANCE)
    assert off < ADAPTED


@pytest.mark.parametrize(
    ("omega", "start", "rule", "bound"),
    [
        (0.942, 1.1, ContactRule.ALWAYS, FIXED),
        (1.047, 1.1, ContactRule.ALWAYS, FIXED),
        (0.942, -1.05, ContactRule.ALWAYS, FIXED),
        (0.942, 1.1, ContactRule.IN_CONTACT, JUMPS),
        (1.047, 1.1, ContactRule.NO_TENSION, JUMPS),
    ],
)
def test_motion_of_the_lumped_model_comes_out_with_a_fixed_step(
    omega: float, start: float, rule: ContactRule, bound: float
):
    assert _off(omega, start, rule, steps=STEPS, solver=Solver.RK44) < bound


def _off(omega: float, start: float, rule: ContactRule, *, steps: int, **how: Any) -> float:
    """How far the states after two mesh cycles, at most, are from those of the lumped model."""
    pair = both(omega, rule)
    state = np.zeros(10)
    state[8] = start
    q, v = pair.start(state)
    step = pair.period / steps
    motion = simulate(pair.machine, pair.contact, q, v, step=step, steps=2 * steps, every=steps, **how)
    lumped = gl.march(pair.system, state, 2)
    assert lumped.contacts.sum() > 0
    found = np.array([pair.lumped_state(*at) for at in zip(motion.q, motion.v, motion.t, strict=True)])
    others = np.delete(np.arange(12), HELD)
    assert np.all(motion.q[:, others] == 0.0)
    return float(np.abs(found[1:] - lumped.states[-2:]).max())


def test_natural_frequencies_are_those_of_matrices_by_hand():
    pair = both(1.0)
    r = pair.scales.radii
    assert r is not None
    masses = []
    for m, radius, width in zip(MASSES, r, (0.07, 0.065), strict=True):
        across = m * (3 * radius**2 + width**2) / 12
        masses += [m, m, m, across, across, m * radius**2 / 2]
    line = np.array([0, C_Y, C_Z, 0, 0, C_Y * r[0], 0, -C_Y, -C_Z, 0, 0, C_Y * r[1]])
    stiffness = np.diag([*STIFFNESS[0], 0.0, *STIFFNESS[1], 0.0]) + 3.2e8 * 1.23289493 * np.outer(line, line)
    roots = 1.0 / np.sqrt(masses)
    expected = np.sqrt(np.abs(np.linalg.eigvalsh(roots[:, None] * stiffness * roots)))
    q = np.zeros(12)
    q[5] = 2e-3  # pressed together
    found = natural_frequencies(pair.machine, pair.contact, q)
    np.testing.assert_allclose(found[1:], np.sort(expected)[1:], rtol=1e-6)


def test_damping_ratios_are_those_asked_for():
    """ξ_m of the mesh alone, ξ_b of each bearing direction alone, in both bodies."""
    pair = both(1.0)
    for i, body in enumerate(pair.machine.bodies):
        inertia = np.array([body.mass] * 3 + [body.transverse_inertia] * 2)
        k, c = (
            np.array(part) for part in (pair.machine.bearings[i].stiffness, pair.machine.bearings[i].damping)
        )
        np.testing.assert_allclose(c / (2 * np.sqrt(k * inertia)), 0.0378, rtol=1e-12)
    mass, omega_n = pair.scales.equivalent_mass, pair.scales.omega_n
    assert mass is not None
    assert omega_n is not None
    assert pair.contact.damping == pytest.approx(2 * 0.07 * mass * omega_n, rel=1e-12)


def test_all_solvers_agree():
    pair = both(0.942, ContactRule.NO_TENSION)
    state = np.zeros(10)
    state[8] = 1.1
    exact, *others = [
        simulate(pair.machine, pair.contact, *pair.start(state), step=pair.period / 512, steps=512, solver=s)
        for s in (Solver.DOPRI5, Solver.RK44, Solver.GENERALIZED_ALPHA)
    ]
    peak = exact.drive_force.max()
    assert np.any(exact.drive_force == 0.0)
    for other in others:
        assert other.drive_force.max() == pytest.approx(peak, rel=2e-3)
        assert np.abs(exact.drive_force - other.drive_force).max() < 0.02 * peak


@pytest.mark.parametrize("rule", list(ContactRule))
def test_no_energy_is_lost_or_made(rule: ContactRule):
    """Over a mesh cycle with impacts, while both shafts rotate and a governor holds their speed."""
    pair = both(0.942, rule)
    speed = 2 * np.pi / pair.period / 28
    machine = replace(pair.machine, speed=speed, governor_time=10 * pair.period)
    state = np.zeros(10)
    state[8] = 1.1
    q, v = pair.start(state)
    motion = simulate(machine, pair.contact, q, v + machine.rolling(), step=pair.period / 1024, steps=1024)
    balance = energy_balance(machine, motion)
    assert min(balance.bearings, balance.contact, abs(balance.driven)) > 1e-4
    assert balance.residual < 1e-4


def test_balance_with_places_between_the_states_closes_better():
    """The same motion with impacts, its powers at the states alone and between them, too."""
    pair = both(0.942)
    state = np.zeros(10)
    state[8] = 1.1
    motion = simulate(
        pair.machine,
        pair.contact,
        *pair.start(state),
        step=pair.period / 64,
        steps=128,
        solver=Solver.DOPRI5,
    )
    alone = energy_balance(pair.machine, motion).residual
    between = energy_balance(pair.machine, motion, pair.contact).residual
    assert between < 0.25 * alone


def test_governor_holds_the_mean_speed_and_leaves_the_mesh_alone():
    pair = both(1.0)
    held = replace(pair.machine, speed=100.0, governor_time=pair.period)
    direction, _ = held.governor()
    moved = np.linalg.solve(held.inertia(), direction)
    assert pair.contact.direction @ moved == pytest.approx(0.0, abs=1e-12 * np.abs(moved).max())
    apart = replace(pair.contact, gap=1.0, damping=0.0)
    motion = simulate(
        replace(held, torque=0.0), apart, np.zeros(12), 0.9 * held.rolling(), step=pair.period / 64, steps=64
    )
    assert motion.v[-1, 5] == pytest.approx(100.0 * (1 - 0.1 * np.exp(-1.0)), rel=1e-6)


@dataclass(frozen=True)
class _Wall:
    """A force on the pinion, along −y, that is there beyond y = 0."""

    force: float

    def forces(self, t: float, q: Array, v: Array) -> Array:
        return np.where(np.arange(len(q)) == 1, -self.force if q[1] > 0.0 else 0.0, 0.0)

    def record(self, t: float, q: Array, v: Array) -> Array:
        return np.zeros(5)


def test_step_that_ends_at_a_jump_is_taken_in_parts():
    """Without the force the step ends beyond y = 0 and with it before: Newton's iteration has no answer. A
    quarter of the step has one."""
    nothing = (0.0, 0.0, 0.0, 0.0, 0.0)
    free = Bearings(nothing, nothing)
    body = RigidBody(1.0, 1.0, 1.0)
    machine = Machine((body, body), (free, free), (28, 70), 0.0)
    wall, step, speed = _Wall(100.0), 1e-3, 1.0
    beyond = 0.02 * wall.force * step**2
    q, v = np.zeros(12), np.zeros(12)
    q[1], v[1] = beyond - 3 * step * speed, speed
    motion = simulate(machine, wall, q, v, step=step, steps=13, solver=Solver.GENERALIZED_ALPHA)
    assert motion.t == pytest.approx(step * np.arange(14), abs=1e-15)
    assert motion.q[:4, 1] == pytest.approx(q[1] + speed * motion.t[:4], abs=beyond)
    since = 10 * step + beyond / speed
    expected = speed * since - 0.5 * wall.force * since**2
    assert motion.q[-1, 1] == pytest.approx(expected, abs=0.15 * wall.force * step * since)
