"""The oracles against each other: what judges the flow must itself be right."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from oracles.closed_forms import (
    contact_system,
    exact_linear,
    floquet_multipliers,
    grazing_parameter,
    permanent_contact,
    spur_grazing_load,
    spur_grazing_omegas,
)
from oracles.impacts import exact_impacts
from oracles.pairs import KINDS, Bodies, Mesh, helical, random_bodies, random_mesh, random_system, spur


@pytest.mark.parametrize("kind", ["plain", "negative-load", "unequal", "tiny-gap"])
def test_heyoka_against_closed_form_impacts(oracle, kind):
    """Constant stiffness: exponentials and harmonics in 40 digits."""
    rng = np.random.default_rng(KINDS.index(kind))
    mesh = replace(random_mesh(rng, kind), ripple=(), ripple_phase=())
    system, state = spur(mesh), [mesh.gap_plus + rng.uniform(-1.0, 0.5), 0.3 * rng.normal()]
    truth = oracle("spur").run(system, state, 2.0, 0.25)
    exact, crossings = exact_impacts(system, state, 2, 0.25)
    assert truth.crossings == [(c[1], c[2]) for c in crossings]
    assert len(crossings) > 1
    assert max(abs(float(exact[i]) - float(truth.state[i])) for i in (0, 1)) < 5e-16
    assert max(abs(float(c[0]) - float(p)) for c, p in zip(crossings, truth.phase, strict=True)) < 5e-16


def test_heyoka_against_scipy(oracle):
    """Another implementation of the field, regions by comparison, another method."""
    system, state = random_system(np.random.default_rng(1), "helical", "unequal")
    c = system.clearances[0]
    from oracles.heyoka_oracle import fourier

    def field(theta, z):
        x, drift = c.h @ z, system.matrix @ z + fourier(system.forcing, theta)
        force = fourier(c.stiffness_plus, theta) * max(x - c.gap_plus, 0.0) + c.damping * (c.h @ drift)
        force += fourier(c.stiffness_minus, theta) * min(x + c.gap_minus, 0.0)
        return ((drift + c.g * force) / system.omega).astype(float)

    span = (0.0, 2 * np.pi)
    other = solve_ivp(field, span, state, method="DOP853", rtol=1e-10, atol=1e-12, max_step=0.05)
    truth = oracle("helical").run(system, state, 1.0)
    assert len(truth.phase) > 1
    assert np.abs(other.y[:, -1] - truth.state).max() < 1e-8


def test_heyoka_backwards_returns_to_the_start(oracle):
    rng = np.random.default_rng(8)
    for kind in ("plain", "unequal", "large-ripple"):
        system, state = random_system(rng, "helical", kind)
        there = oracle("helical").run(system, state, 0.7, 0.1)
        back = oracle("helical").run(system, there.state, -0.7, there.end)
        assert np.abs(back.state - state).max() < 1e-14
        assert back.crossings == there.crossings[::-1]


def test_harmonic_balance_against_heyoka_and_liouville(oracle):
    rng = np.random.default_rng(2)
    mesh = replace(random_mesh(rng, "plain"), load=3.0)  # loaded so that contact is never lost
    system = helical(mesh, random_bodies(rng))
    start = permanent_contact(system, 30)(0.0)
    truth = oracle("helical").run(system, start, 1.0)
    assert len(truth.phase) == 0
    assert np.abs(truth.state - start).max() < 1e-13
    trace = np.trace(contact_system(system)[0])
    multipliers = floquet_multipliers(system, 20)
    assert abs(np.prod(multipliers) / np.exp(2 * np.pi / system.omega * trace) - 1) < 1e-9


def test_matrix_exponential_against_harmonic_balance():
    mesh = Mesh(ripple=(), ripple_phase=(), load=2.0)
    system = helical(mesh, Bodies())
    a0, coupling, forcing = contact_system(system)
    start = permanent_contact(system, 3)(0.6 * np.pi)
    end = exact_linear(a0 + coupling, forcing, mesh.omega, start, 2.4, 0.3)
    assert np.abs(end - permanent_contact(system, 3)(5.4 * np.pi)).max() < 1e-14


def test_grazing_search_against_the_closed_form():
    mesh = Mesh(ripple=(), ripple_phase=(), omega=0.7, error=(0.2,), damping=0.14)
    load = spur_grazing_load(0.7, 0.2, 0.14)
    assert (
        abs(grazing_parameter(lambda f: spur(replace(mesh, load=f)), 0.5 * load, 2 * load, 3) - load) < 1e-13
    )
    assert np.abs(spur_grazing_omegas(load, 0.2, 0.14) - 0.7).min() < 1e-14
