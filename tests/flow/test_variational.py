"""The derivative of the flow with respect to its start."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash import flow
from oracles.pairs import (
    KINDS,
    Bodies,
    Mesh,
    gap_coordinates,
    helical,
    helical_bodies,
    random_bodies,
    random_mesh,
    random_system,
    spur,
)


def _derivative(system, state, cycles, phase=0.0):
    """(state, Jacobian, contacts) after some cycles."""
    carried = flow.variational(flow.propagators(system), state, cycles, phase)
    assert carried.jacobian is not None
    return carried.state, carried.jacobian, carried.contacts


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_against_heyokas_variational_equations(oracle, pair, kind):
    rng = np.random.default_rng([5, KINDS.index(kind)])
    cycles = 0.5 if kind == "slow" else 2.0
    for _ in range(5):
        system, state = random_system(rng, pair, kind)
        truth = oracle(pair, variational=True).run(system, state, cycles, 0.3)
        end, jacobian, _ = _derivative(system, state, cycles, 0.3)
        assert np.abs(jacobian - truth.jacobian).max() < 1e-12 * max(1.0, np.abs(truth.jacobian).max())
        assert np.abs(end - truth.state).max() < 1e-13 * max(1.0, np.abs(truth.state).max())


@pytest.mark.parametrize("kind", KINDS)
def test_liouville(kind):
    """det = exp ∫ trace: no region and no event changes the trace, because h·g = 0."""
    rng = np.random.default_rng([6, KINDS.index(kind)])
    for pair in ("spur", "helical"):
        for _ in range(5):
            system, state = random_system(rng, pair, kind)
            # Strong damping shrinks the volume below what a determinant of rounded entries can show.
            rate = _trace(system)
            cycles = min(1.0, 8.0 / max(1e-3, -rate * 2 * np.pi / system.omega))
            _, jacobian, _ = _derivative(system, state, cycles, 0.2)
            expected = rate * cycles * 2 * np.pi / system.omega
            sign, logarithm = np.linalg.slogdet(jacobian)
            assert sign == 1.0
            assert abs(logarithm - expected) < 1e-10


def _trace(system) -> float:
    c = system.clearances[0]
    return float(np.trace(system.matrix) + c.damping * (c.h @ system.matrix @ c.g))


@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_taylor_remainder_is_quadratic(pair):
    """‖φ(z + εv) − φ(z) − ε J v‖ falls by 100 when ε falls by 10, through several contacts."""
    mesh = Mesh(gap_minus=0.1, gap_plus=0.3, load=0.05)
    system = spur(mesh) if pair == "spur" else helical(mesh, Bodies())
    rng = np.random.default_rng(4)
    state = np.zeros(system.size)
    state[-2:] = 0.5, -0.2
    props, direction = flow.propagators(system), rng.normal(size=system.size)
    end, jacobian, contacts = _derivative(system, state, 2.0)
    assert contacts.sum() >= 3
    remainder = []
    for epsilon in (1e-4, 1e-5, 1e-6):
        moved = flow.carry(props, state + epsilon * direction, 2.0)
        assert (moved.contacts == contacts).all()
        remainder.append(np.linalg.norm(moved.state - end - epsilon * jacobian @ direction))
    assert remainder[0] > 1e-10, "the remainder must stand clear of rounding"
    assert 50 < remainder[0] / remainder[1] < 200
    assert 50 < remainder[1] / remainder[2] < 200


def _undamped(rng, kind) -> tuple[Mesh, Bodies]:
    return replace(random_mesh(rng, kind), damping=0.0), replace(random_bodies(rng), xi=(0.0,) * 4)


@pytest.mark.parametrize(
    "kind", ["plain", "negative-load", "unequal", "one-sided", "tiny-gap", "large-ripple"]
)
def test_symplectic_without_damping(kind):
    """In (Y, Z, U) with the masses as metric, through contacts too: errors in event times would show."""
    rng = np.random.default_rng([9, KINDS.index(kind)])
    contacts = 0
    for _ in range(6):
        mesh, bodies = _undamped(rng, kind)
        system = helical_bodies(mesh, bodies)
        form = np.kron(np.diag(bodies.masses), [[0.0, 1.0], [-1.0, 0.0]])
        start = rng.normal(0.0, 0.2, 10)
        start[8] = (mesh.gap_plus + rng.uniform(-0.2, 0.3)) / bodies.c_t
        _, jacobian, met = _derivative(system, start, 1.0, 0.1)
        contacts += int(met.sum())
        scale = np.abs(jacobian).max() ** 2 * np.abs(form).max()
        assert np.abs(jacobian.T @ form @ jacobian - form).max() < 1e-13 * max(1.0, scale)
    assert contacts > 5


def test_symplectic_in_gap_coordinates():
    """The same form carried over to (…, X, X′); X + E is linear in the bodies' coordinates."""
    rng = np.random.default_rng(10)
    mesh, bodies = _undamped(rng, "unequal")
    back = np.linalg.inv(gap_coordinates(bodies))
    form = back.T @ np.kron(np.diag(bodies.masses), [[0.0, 1.0], [-1.0, 0.0]]) @ back
    start = np.zeros(10)
    start[8:] = mesh.gap_plus + 0.05, -0.4
    _, jacobian, contacts = _derivative(helical(mesh, bodies), start, 2.0)
    assert contacts.sum() > 1
    size = np.abs(jacobian).max() ** 2
    assert np.abs(jacobian.T @ form @ jacobian - form).max() < 1e-12 * size
