"""The flow against an independent high-order integrator in 80-bit arithmetic."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import Status
from oracles.compare import distance
from oracles.pairs import KINDS, random_system

SETS = 26  # of every kind: 208 parameter sets of either pair


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_random_pairs(oracle, pair, kind):
    """States, every crossing with direction and time, every extremum; starts at any phase and region."""
    rng = np.random.default_rng([KINDS.index(kind), len(pair)])
    cycles = 0.5 if kind == "slow" else 2.0  # half a slow cycle is already up to 160 units of τ
    crossings = 0
    for _ in range(SETS):
        system, state = random_system(rng, pair, kind)
        phase = float(rng.uniform(0.0, 1.0))
        truth = oracle(pair).run(system, state, cycles, phase)
        props = flow.propagators(system)
        trace = flow.trace(props, state, cycles, phase)
        far = distance(system, trace, truth)
        assert trace.status is Status.OK
        assert far.same_crossings
        assert far.same_extrema
        assert far.state < 1e-13
        assert far.event_time < 1.0
        assert far.on_boundary < 1e-14
        carried = flow.carry(props, state, cycles, phase)  # proves cells clear where a trace expands them
        assert carried.contacts.tolist() == truth.contacts
        assert np.abs(carried.state - trace.end).max() < 1e-13 * max(1.0, np.abs(trace.end).max())
        assert far.extremum_phase < 1e-11
        assert far.extremum_displacement < 1e-13
        crossings += len(truth.phase)
    assert crossings > SETS, "the draw must contain contacts"


@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_march_and_carry_agree_with_heyoka(oracle, pair):
    """Strobes (σ_t), counts of contacts per stretch, and a carry between two odd phases."""
    rng = np.random.default_rng(11)
    for kind in ("plain", "negative-load", "unequal", "one-sided", "tiny-gap", "large-ripple"):
        system, state = random_system(rng, pair, kind)
        props = flow.propagators(system)
        strobes = flow.march(props, state, 3)
        here = state
        for k in range(3):
            truth = oracle(pair).run(system, here, 1.0)
            here = truth.state
            assert np.abs(strobes.states[k + 1] - here).max() < 1e-12 * max(1.0, np.abs(here).max())
            assert strobes.contacts[k].tolist() == truth.contacts
        truth = oracle(pair).run(system, state, 1.3, 0.45)
        carried = flow.carry(props, state, 1.3, 0.45)
        assert np.abs(carried.state - truth.state).max() < 1e-13 * max(1.0, np.abs(truth.state).max())
        assert carried.contacts.tolist() == truth.contacts


@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_stable_orbits_after_many_cycles(oracle, pair):
    """An orbit that the march has settled on is where heyoka, started from there, settles too."""
    rng, kinds, compared = np.random.default_rng(12), ("plain", "unequal", "negative-load", "large-ripple"), 0
    for index in range(24):
        system, start = random_system(rng, pair, kinds[index % 4])
        props = flow.propagators(system)
        strobes = flow.march(props, start, 1500)
        if strobes.status is Status.DIVERGED:  # parametric resonance under a ripple of 0.9
            continue
        orbit = strobes.states[-1]
        # 24 cycles are a multiple of the periods 1, 2, 3, 4, 6, 8 and 12.
        return_map = flow.variational(props, orbit, 24.0)
        assert return_map.jacobian is not None
        attracts = np.abs(np.linalg.eigvals(return_map.jacobian)).max() < 0.95**24
        speeds = np.abs(flow.trace(props, orbit, 24.0).events.velocity)
        if np.abs(return_map.state - orbit).max() > 1e-12 or not attracts or speeds.min(initial=1.0) < 1e-3:
            continue
        compared += 1
        truth = oracle(pair).run(system, orbit, 72.0)
        assert np.abs(orbit - truth.state).max() < 1e-11 * max(1.0, float(np.linalg.norm(orbit)))
    assert compared > 8


@pytest.mark.parametrize("size", [2, 3, 5, 8])
def test_dense_systems(oracle, size):
    """Nothing of a gear: dense matrices, forced gap velocity, offset, base period of one to three cycles."""
    del oracle  # only for its skip where heyoka has no wheel
    from oracles.dense import random_dense
    from oracles.heyoka_oracle import Oracle

    rng = np.random.default_rng(size)
    draws = [random_dense(rng, size) for _ in range(25)]
    heyoka = Oracle([system for system, _ in draws])
    for system, state in draws:
        phase = float(rng.uniform(0.0, 1.0))
        truth = heyoka.run(system, state, 2.5, phase)
        trace = flow.trace(flow.propagators(system), state, 2.5, phase)
        far = distance(system, trace, truth)
        assert trace.status is Status.OK
        assert far.same_crossings
        assert far.same_extrema
        assert far.state < 1e-13
        assert far.event_time < 1.0
        assert far.on_boundary < 1e-14


def test_samples_between_events(oracle):
    """The polynomial pieces hold the motion everywhere, not at their ends only."""
    rng = np.random.default_rng(3)
    system, state = random_system(rng, "helical", "unequal")
    samples = flow.trace(flow.propagators(system), state, 1.0).samples(23)
    for phase, found, force in zip(samples.phase[1:], samples.state[1:], samples.force[1:], strict=True):
        truth = oracle("helical").run(system, state, phase)
        assert np.abs(found - truth.state).max() < 1e-13
        assert abs(force - _force(system, truth.state, phase)) < 1e-12


def _force(system, state, phase) -> float:
    from oracles.heyoka_oracle import angle, fourier, gap, gap_velocity

    c, x, at = system.clearances[0], gap(system, state, phase), angle(system, phase)
    elastic = fourier(c.stiffness_plus, at) * max(x - c.gap_plus, 0.0)
    elastic += fourier(c.stiffness_minus, at) * min(x + c.gap_minus, 0.0)
    return float(elastic + c.damping * gap_velocity(system, state, phase))
