"""Random members of the whole class against 80-bit truth: rules mixed, 1 to 3 clearances, 1 to 12 states."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import Status
from oracles.matches import match
from oracles.members import RULES, random_member

pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
from oracles import region_oracle

SETS = 20


def _agrees(system, state, cycles, phase, variational=False) -> int:
    """Trace, carry and derivative are those of the truth; returns the number of its events."""
    count = len(system.clearances)
    truth = region_oracle.run(system, state, cycles, phase, variational)
    props = flow.propagators(system)
    trace = flow.trace(props, state, cycles, phase)
    far = match(system, trace, truth)
    assert trace.status is Status.OK
    assert far.holds(), far.told
    carried = flow.carry(props, state, cycles, phase, jacobian=variational)
    assert carried.status is Status.OK
    assert carried.contacts.reshape(-1, 4).tolist() == truth.contacts(count)
    size = max(1.0, float(np.linalg.norm(truth.state)))
    assert np.abs(carried.state - truth.state).max() < 1e-13 * size
    if variational:
        assert truth.jacobian is not None
        assert carried.jacobian is not None
        apart = np.abs(carried.jacobian - truth.jacobian).max()
        assert apart < 1e-12 * max(1.0, np.abs(truth.jacobian).max())
    return len(truth.events)


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("count", [1, 2, 3])
def test_one_rule(rule, count):
    """States, every event with its time, counts per clearance and side; starts at any phase and region."""
    rng, events = np.random.default_rng([count, RULES.index(rule)]), 0
    for _ in range(SETS):
        system, state = random_member(rng, int(rng.choice([2, 4, 5, 8, 11])), count, (rule,))
        events += _agrees(system, state, 2.0, float(rng.uniform(0.0, 2.0)))
    assert events > 3 * SETS


@pytest.mark.parametrize("size", range(1, 13))
def test_rules_mixed(size):
    """Every number of states; a single state feels no force, and its events are still told."""
    rng, events = np.random.default_rng(size), 0
    for _ in range(SETS // 2):
        system, state = random_member(rng, size, int(rng.integers(1, 4)))
        events += _agrees(system, state, 1.3, float(rng.uniform(0.0, 2.0)))
    assert events > SETS // 2


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("count", [1, 2, 3])
def test_derivative(rule, count):
    """Saltation at every jump of the field: variational equations in 80 bits, I ± ζ g hᵀ between them."""
    rng, events = np.random.default_rng([7, count, RULES.index(rule)]), 0
    for _ in range(6):
        system, state = random_member(rng, int(rng.choice([2, 4, 6])), count, (rule,))
        events += _agrees(system, state, 1.5, float(rng.uniform(0.0, 2.0)), variational=True)
    assert events > 5


def test_strobes():
    """What marches counts the same contacts, stretch by stretch."""
    rng, contacts = np.random.default_rng(8), 0
    for _ in range(12):
        system, state = random_member(rng, int(rng.choice([3, 4, 6])), 2)
        strobes = flow.march(flow.propagators(system), state, 3)
        for k in range(3):
            truth = region_oracle.run(system, strobes.states[k], system.cycles)
            assert strobes.contacts[k].reshape(-1, 4).tolist() == truth.contacts(2)
            size = max(1.0, float(np.linalg.norm(truth.state)))
            assert np.abs(strobes.states[k + 1] - truth.state).max() < 1e-13 * size
            contacts += len(truth.events)
    assert contacts > 30
