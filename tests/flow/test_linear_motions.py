"""Motions that stay in one region for ever, against the same equations integrated by scipy, and against the
march."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gearlash import flow
from gearlash.orbits import orbit_at
from gearlash.orbits.contact_force import force_extrema
from gearlash.system import Clearance, ContactRule, GearlashError, System, derivative, evaluate
from oracles.members import random_member

SIDES = {flow.PLUS: 1, flow.MINUS: -1}


def beyond(
    system: System, side: int, time: np.ndarray, z: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """X - edge, X' and the force of the side, from states (n, m)."""
    (clearance,) = system.clearances
    rate = system.omega / system.cycles
    theta, plus = rate * time, side == flow.PLUS
    edge = clearance.gap_plus if plus else -clearance.gap_minus
    x = clearance.h @ z - evaluate(clearance.offset, theta) - edge
    forcing = np.array([evaluate(row, theta) for row in system.forcing])
    slope = clearance.h @ (system.matrix @ z + forcing) - rate * evaluate(derivative(clearance.offset), theta)
    stiffness = evaluate(clearance.stiffness_plus if plus else clearance.stiffness_minus, theta)
    return x, slope, stiffness * x + clearance.dampings[0 if plus else 1] * slope


def integrated(system: System, side: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The map of the return, and X - edge and the force on the motion that closes, by scipy alone."""
    n, (clearance,) = system.size, system.clearances

    def field(time: float, flat: np.ndarray) -> np.ndarray:
        z = flat.reshape(n, -1)
        theta = np.full(z.shape[1], system.omega / system.cycles * time)
        forcing = np.array([evaluate(row, theta) for row in system.forcing])
        force = beyond(system, side, np.full(z.shape[1], time), z)[2]
        return (system.matrix @ z + forcing + np.outer(clearance.g, force)).ravel()

    def carried(starts: np.ndarray, times: np.ndarray) -> np.ndarray:
        found = solve_ivp(
            field, (0.0, system.period), starts.ravel(), "DOP853", times, rtol=1e-12, atol=1e-13
        )
        return found.y.reshape(*starts.shape, -1)

    ends = carried(np.hstack([np.zeros((n, 1)), np.eye(n)]), np.array([system.period]))[..., -1]
    turned = ends[:, 1:] - ends[:, :1]
    start = np.linalg.solve(np.eye(n) - turned, ends[:, 0])
    times = np.linspace(0.0, system.period, 40_001)
    x, _, force = beyond(system, side, times, carried(start[:, None], times)[:, 0])
    return turned, x, force


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("rule", ContactRule)
@pytest.mark.parametrize("size", [2, 5, 8])
def test_it_is_what_the_equations_of_its_region_have(size: int, rule: ContactRule, side: int):
    system, _ = random_member(np.random.default_rng(size), size, 1, (rule,))
    found = flow.linear_motion(system, side)
    assert found is not None
    turned, x, force = integrated(system, side)
    assert np.abs(found.map - turned).max() <= 1e-9 * max(1.0, np.abs(turned).max())
    assert found.stable == (np.abs(np.linalg.eigvals(turned)).max() < 1.0)
    for sign in (1, -1):
        for series, other in ((found.beyond, x), (found.force, force)):
            assert found.least(series, sign) == pytest.approx(
                (sign * other).min(), abs=2e-7 * np.abs(other).max()
            )


def closed(system: System, side: int) -> System:
    """The same with a gap of no width where this side begins."""
    (clearance,) = system.clearances
    plus = side == flow.PLUS
    gap = clearance.gap_plus if plus else -clearance.gap_minus
    stiffness = clearance.stiffness_plus if plus else clearance.stiffness_minus
    made = Clearance(
        h=clearance.h, g=clearance.g, gap_plus=gap, gap_minus=-gap, stiffness_plus=stiffness,
        stiffness_minus=stiffness, damping=clearance.dampings[0 if plus else 1], offset=clearance.offset,
    )  # fmt: skip
    return replace(system, clearances=(made,))


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("seed", range(4))
def test_it_is_the_orbit_that_the_march_has_without_a_gap(seed: int, side: int):
    system, _ = random_member(np.random.default_rng(seed), 4, 1, (ContactRule.ALWAYS,))
    found, other = flow.linear_motion(system, side), closed(system, side)
    orbit = orbit_at(other, np.zeros(4), 1)
    assert found is not None
    assert orbit is not None
    edge = other.clearances[0].gap_plus
    lowest = orbit.extrema.displacement.min() - edge
    assert found.least(found.beyond, 1) == pytest.approx(lowest, rel=1e-11, abs=1e-13)
    forces = force_extrema(orbit.trace, 0).force
    assert found.least(found.force, 1) == pytest.approx(forces.min(), rel=1e-9, abs=1e-12)


def test_several_clearances_are_refused():
    system, _ = random_member(np.random.default_rng(0), 4, 2)
    with pytest.raises(GearlashError, match="2 clearances: expected one"):
        flow.linear_motion(system, flow.PLUS)


def test_a_body_that_nothing_holds_has_no_such_motion():
    """Its return adds what the force has pushed it: free, under a constant force."""
    clearance = Clearance(h=np.array([1.0, 0.0]), g=np.array([0.0, -1.0]), gap_plus=1.0, gap_minus=1.0,
                          stiffness_plus=np.array([1.0]), stiffness_minus=np.array([1.0]), damping=0.0,
                          offset=np.zeros(1))  # fmt: skip
    system = System(1.0, np.array([[0.0, 1.0], [0.0, 0.0]]), np.array([[0.0], [0.1]]), (clearance,), 1)
    assert flow.linear_motion(system, flow.FREE) is None
