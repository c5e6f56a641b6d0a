"""What judges the flow for several clearances and all contact rules must itself be right."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gearlash.system import ContactRule
from oracles.clearances import gap, gap_velocity, series_value
from oracles.members import RULES, random_member
from oracles.pairs import KINDS, random_system
from oracles.polynomials import sign_changes

pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
from oracles import region_oracle


def test_sign_changes_of_known_polynomials():
    """Roots put in by hand: simple, near to each other, double (no sign change), triple, outside."""
    for roots, expected in (
        ([0.2, 0.7], [0.2, 0.7]),
        ([0.5, 0.5 + 1e-9], [0.5, 0.5 + 1e-9]),
        ([0.3, 0.3, 0.8], [0.8]),
        ([-0.1, 1.1, 2.0], []),
        (list(np.linspace(0.05, 0.95, 10)), list(np.linspace(0.05, 0.95, 10))),
    ):
        p = np.ones(1, dtype=np.longdouble)
        for root in roots:
            p = np.convolve(p, np.array([-root, 1], dtype=np.longdouble))
        found = sign_changes(p)
        assert len(found) == len(expected)
        assert np.abs(np.array(found) - expected).max(initial=0.0) < 1e-9


@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_against_heyokas_own_events(oracle, pair):
    """Rule ``always``: the other oracle leaves events and the region switch to heyoka."""
    rng = np.random.default_rng(5)
    for kind in KINDS:
        system, state = random_system(rng, pair, kind)
        cycles = 0.5 if kind == "slow" else 2.0
        theirs = oracle(pair, variational=True).run(system, state, cycles, 0.3)
        ours = region_oracle.run(system, state, cycles, 0.3, variational=True)
        stops = [system.clearances[0].stops(b) for b in theirs.boundary]
        assert [(e.boundary, e.engaging) for e in ours.events] == [
            crossing for crossing, stop in zip(theirs.crossings, stops, strict=True) if stop
        ]
        phases = [e.phase for e in ours.events] - theirs.phase[stops]
        assert np.abs(phases).max(initial=0.0) < 1e-16
        assert np.abs(ours.state - theirs.state).max() < 1e-16 * max(1.0, np.abs(theirs.state).max())
        jacobian = np.abs(theirs.jacobian).max()
        assert np.abs(ours.jacobian - theirs.jacobian).max() < 1e-15 * max(1.0, jacobian)


def _busy(rng, size, count, rule, harmonics=3):
    """The first random member with three events or more in a cycle, its start, and that cycle."""
    while True:
        system, state = random_member(rng, size, count, (rule,), harmonics)
        state = state.astype(np.longdouble)
        truth = region_oracle.run(system, state, 1.0, 0.2, variational=True)
        if len(truth.events) > 2:
            return system, state, truth


def _by_comparison(system, phase, z):
    """The field, its contacts decided anew at every call from the state alone."""
    at = 2 * np.pi * phase / system.cycles
    rate = system.matrix @ z + [float(series_value(row, at)) for row in system.forcing]
    for c in system.clearances:
        x, v = float(gap(system, c, z, phase)), float(gap_velocity(system, c, z, phase))
        plus, minus = c.dampings
        force = c.damping * v if c.contact is ContactRule.ALWAYS else 0.0
        shared = c.damping_minus is None or c.contact is ContactRule.ALWAYS
        for over, eta, other, damping, sign in (
            (x - c.gap_plus, c.stiffness_plus, c.stiffness_minus, plus, 1.0),
            (-x - c.gap_minus, c.stiffness_minus, c.stiffness_plus, minus, -1.0),
        ):
            inherited = shared and other.any()  # a side without stiffness acts by a damping of its own
            if over > 0 and (eta.any() or not inherited):
                push = float(series_value(eta, at)) * over
                if c.contact is not ContactRule.ALWAYS:
                    push += damping * sign * v
                force += sign * (max(0.0, push) if c.contact is ContactRule.NO_TENSION else push)
        rate = rate + c.g * force
    return rate * 2 * np.pi / system.omega


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("count", [1, 2])
def test_against_scipy(rule, count):
    """Contacts by comparison, no events; another method, which stumbles over each jump."""
    rng = np.random.default_rng([count, RULES.index(rule)])
    for size in (3, 4):
        system, state, truth = _busy(rng, size, count, rule, harmonics=2)
        other = solve_ivp(
            lambda s, z, system=system: _by_comparison(system, s, z),
            (0.2, 1.2),
            state.astype(float),
            method="DOP853",
            rtol=1e-9,
            atol=1e-10,
            max_step=0.02,
        )
        assert np.abs(other.y[:, -1] - truth.state).max() < 1e-7


@pytest.mark.parametrize("rule", RULES)
def test_derivative_by_differences(rule):
    """The saltation I ± ζ g hᵀ at jumps, the identity elsewhere: differences know of neither."""
    rng = np.random.default_rng([3, RULES.index(rule)])
    for size, count in ((2, 1), (5, 2), (6, 3)):
        system, state, truth = _busy(rng, size, count, rule)
        assert truth.jacobian is not None
        for i in range(size):
            step = np.longdouble(1e-7) * np.eye(size, dtype=np.longdouble)[i]
            ends = [region_oracle.run(system, state + k * step, 1.0, 0.2).state for k in (1, -1)]
            column = (ends[0] - ends[1]) / np.longdouble(2e-7)
            assert np.abs(column - truth.jacobian[:, i]).max() < 1e-10 * max(
                1.0, np.abs(truth.jacobian).max()
            )


def test_backwards_is_the_way_back():
    """Overlap without force, re-engagement and release met from the other side."""
    rng, early = np.random.default_rng(4), 0
    for _ in range(20):
        system, state = random_member(rng, int(rng.integers(2, 7)), int(rng.integers(1, 3)))
        there = region_oracle.run(system, state, 0.6, 0.1)
        back = region_oracle.run(system, there.state, -0.6, there.end)
        assert np.abs(back.state - state).max() < 1e-11
        order = [(e.clearance, e.boundary, e.engaging) for e in there.events]
        assert order == [(e.clearance, e.boundary, e.engaging) for e in back.events[::-1]]
        early += sum(e.early for e in there.events)
    assert early > 5


def test_a_twin_is_two_events_at_one_phase():
    """Two equal clearances on one gap: everything happens twice, and the force is that of the sum."""
    rng = np.random.default_rng(6)
    for rule in RULES:
        system, state = random_member(rng, 4, 1, (rule,), turned=False)
        (one,) = system.clearances
        half = replace(one, g=0.5 * one.g)
        twins = replace(system, clearances=(half, replace(half, name="twin")))
        single, double = (region_oracle.run(s, state, 1.5) for s in (system, twins))
        assert len(double.events) == 2 * len(single.events) > 0
        assert np.abs(double.state - single.state).max() < 1e-16
        phases = [e.phase for e in double.events]
        assert phases[0::2] == phases[1::2]
