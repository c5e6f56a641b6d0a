"""The flow against what is known exactly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import root_scalar

from gearlash import flow
from gearlash.system import Status
from oracles.closed_forms import (
    contact_system,
    exact_linear,
    floquet_multipliers,
    grazing_parameter,
    permanent_contact,
    spur_grazing_load,
)
from oracles.impacts import exact_impacts
from oracles.pairs import KINDS, Bodies, Mesh, helical, random_mesh, spur


@pytest.mark.parametrize("kind", KINDS)
def test_impacts_of_one_degree_of_freedom(kind):
    """Constant stiffness on either side, every crossing to 40 digits."""
    rng = np.random.default_rng(100 + KINDS.index(kind))
    mesh = replace(random_mesh(rng, kind), ripple=(), ripple_phase=())
    system, state = spur(mesh), np.array([mesh.gap_plus + rng.uniform(-1.0, 0.5), 0.3 * rng.normal()])
    cycles = 1 if kind == "slow" else 2
    exact, crossings = exact_impacts(system, state, cycles, 0.25)
    trace = flow.trace(flow.propagators(system), state, cycles, 0.25)
    found = list(zip(trace.events.boundary.tolist(), trace.events.engaging.tolist(), strict=True))
    assert found == [(c[1], c[2]) for c in crossings]
    assert np.abs(trace.end - [float(x) for x in exact]).max() < 1e-13
    for phase, velocity, truth in zip(trace.events.phase, trace.events.velocity, crossings, strict=True):
        late = abs(phase - float(truth[0])) * 2 * np.pi / mesh.omega
        assert late < 1e-12 + 8 * np.finfo(float).eps / abs(float(truth[3]))
        assert abs(velocity - float(truth[3])) < 1e-13


def test_no_contact_at_all():
    """Free in the gap with damping, and with none (a parabola with harmonics)."""
    for damping in (0.1, 0.0):
        mesh = Mesh(
            gap_plus=1e3, gap_minus=1e3, damping=damping, load=0.3, error=(0.2, 0.1), error_phase=(1.0, 2.0)
        )
        state = np.array([0.1, -0.2])
        exact, crossings = exact_impacts(spur(replace(mesh, ripple=(), ripple_phase=())), state, 2)
        trace = flow.trace(flow.propagators(spur(mesh)), state, 2.0)
        assert crossings == []
        assert len(trace.events) == 0
        assert np.abs(trace.end - [float(x) for x in exact]).max() < 1e-13 * max(1.0, np.abs(trace.end).max())


def test_constant_stiffness_in_one_region():
    """Ten states inside S1, matrix exponential and harmonics in 40 digits."""
    mesh = Mesh(ripple=(), ripple_phase=(), load=2.0, error=(0.2, 0.05), error_phase=(0.3, 1.0))
    system = helical(mesh, Bodies())
    a0, coupling, forcing = contact_system(system)
    rng = np.random.default_rng(0)
    start = permanent_contact(system, 4)(0.5) + rng.normal(0.0, 0.05, 10)
    exact = exact_linear(a0 + coupling, forcing, mesh.omega, start, 3.2, 0.25)
    trace = flow.trace(flow.propagators(system), start, 3.2, 0.25)
    assert len(trace.events) == 0
    assert np.abs(trace.end - exact).max() < 1e-13


@pytest.mark.parametrize("omega", [0.05, 0.3, 1.047, 1.7])
def test_permanent_contact_with_ripple(omega):
    """The periodic response from Hill's infinite determinant, truncated, is a fixed point of the flow."""
    mesh = Mesh(
        omega=omega, load=5.0, ripple=(0.4, 0.2), ripple_phase=(0.3, 1.0), error=(0.3,), error_phase=(0.7,)
    )
    system = helical(mesh, Bodies())
    response = permanent_contact(system, 90 if omega < 0.1 else 45)
    trace = flow.trace(flow.propagators(system), response(0.0), 1.0)
    assert len(trace.events) == 0
    assert np.abs(trace.end - response(0.0)).max() < 1e-12
    samples = trace.samples(9)
    assert np.abs(samples.state - response(2 * np.pi * samples.phase)).max() < 1e-12


@pytest.mark.parametrize("omega", [0.78, 1.047])
def test_multipliers_in_permanent_contact(omega):
    """Eigenvalues of the monodromy against Hill's spectrum."""
    system = helical(Mesh(omega=omega, load=5.0), Bodies())
    start = permanent_contact(system, 30)(0.0)
    carried = flow.variational(flow.propagators(system), start, 1.0)
    assert carried.jacobian is not None
    found = np.linalg.eigvals(carried.jacobian)
    for multiplier in floquet_multipliers(system, 20):
        assert np.abs(found - multiplier).min() < 1e-11


def _lowest(system, start) -> float:
    """Depth of the deepest minimum of X over one cycle, measured from D⁺."""
    extrema = flow.trace(flow.propagators(system), start, 1.0).extrema
    return float(extrema.displacement.min()) - system.clearances[0].gap_plus


def test_grazing_load_of_the_steady_response():
    """min X = D⁺: from the extrema of the trace, against the closed form and against harmonic balance."""
    for ripple in ((), (0.3,)):
        mesh = Mesh(omega=0.7, error=(0.2,), ripple=ripple, ripple_phase=(0.4,) * len(ripple))

        def at(load, mesh=mesh):
            return spur(replace(mesh, load=load))

        guess = spur_grazing_load(0.7, 0.2, 0.14)
        truth = guess if not ripple else grazing_parameter(at, 0.2 * guess, 5 * guess, 20)

        def depth(load, at=at):
            return _lowest(at(load), permanent_contact(at(load), 20)(0.0))

        found = root_scalar(depth, bracket=(truth * (1 - 1e-6), truth * 1.5), xtol=1e-15).root
        assert abs(found - truth) < 1e-12


def test_touching_within_rounding_is_never_guessed():
    """At the grazing load of the closed form a depth of 1e-16 is nobody's to decide: the status says so."""
    mesh = Mesh(ripple=(), ripple_phase=(), omega=0.7, error=(0.2,), damping=0.14)
    seen = {}
    for push in (0.0, 1e-12, -1e-12):
        system = spur(replace(mesh, load=spur_grazing_load(0.7, 0.2, 0.14) + push))
        start = permanent_contact(system, 3)(0.0)
        trace = flow.trace(flow.propagators(system), start, 1.0)
        seen[push] = trace.status, len(trace.events)
        assert np.abs(trace.end - start).max() < 1e-14
    assert seen == {0.0: (Status.UNCERTAIN, 0), 1e-12: (Status.OK, 0), -1e-12: (Status.OK, 2)}
