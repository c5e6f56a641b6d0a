"""Several clearances that do things at one instant, or nearly; and what must not matter among them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import ContactRule, Status
from oracles.impacts import exact_impacts
from oracles.matches import kinds, match
from oracles.members import RULES, random_member
from oracles.oscillators import oscillator, side_by_side

CLOSE = 1e-12


def _busy(rule, **changes):
    """An oscillator that meets both sides, with a start: under no-tension it also re-engages in overlap."""
    values = {
        "omega": 0.8,
        "gap": (0.2, 0.15),
        "stiffness": ([3.0, 0.9, 0.2], [2.0, 0.3, -0.4]),
        "damping": 0.3,
        "force": (0.05, 0.7, 0.2),
    }
    return oscillator(rule=rule, **{**values, **changes}), np.array([0.1, 0.4])


def _run(system, start, cycles=3.0, phase=0.1):
    props = flow.propagators(system)
    trace = flow.trace(props, start, cycles, phase)
    carried = flow.variational(props, start, cycles, phase)
    assert trace.status is carried.status is Status.OK
    assert carried.jacobian is not None
    assert np.abs(carried.state - trace.end).max() < CLOSE
    assert carried.contacts.sum() == len(trace.events)
    return trace, carried.jacobian


def _events_of(trace, clearance):
    mine = trace.events.clearance == clearance
    return [
        trace.events.phase[mine],
        trace.events.boundary[mine].tolist(),
        trace.events.engaging[mine].tolist(),
    ]


def _same(one, other, boundary=1):
    assert len(one[0]) == len(other[0]) > 0
    assert np.abs(one[0] - other[0]).max() < 1e-12
    assert one[1] == [boundary * b for b in other[1]]
    assert one[2] == other[2]


@pytest.mark.parametrize("rule", RULES)
def test_equal_twins(rule):
    """Two equal oscillators in equal states: every instant has two events, and neither disturbs the other."""
    single, start = _busy(rule)
    alone, derivative = _run(single, start)
    for copies in (2, 3):
        trace, joint = _run(side_by_side(*[single] * copies), np.tile(start, copies))
        assert len(trace.events) == copies * len(alone.events)
        for j in range(copies):
            _same(_events_of(trace, j), _events_of(alone, 0))
            assert np.abs(trace.end[2 * j : 2 * j + 2] - alone.end).max() < CLOSE
        blocks = np.kron(np.eye(copies), derivative)
        assert np.abs(joint - blocks).max() < CLOSE * np.abs(blocks).max()


@pytest.mark.parametrize("rule", RULES)
def test_mirrored_twins(rule):
    """One hits + where the other hits −, at the same instant."""
    single, start = _busy(rule)
    (c,) = single.clearances
    mirror = replace(
        c, gap_plus=c.gap_minus, gap_minus=c.gap_plus,
        stiffness_plus=c.stiffness_minus, stiffness_minus=c.stiffness_plus,
    )  # fmt: skip
    other = replace(single, forcing=-single.forcing, clearances=(mirror,))
    trace, _ = _run(side_by_side(single, other), np.concatenate([start, -start]))
    _same(_events_of(trace, 0), _events_of(trace, 1), boundary=-1)
    assert np.abs(trace.end[:2] + trace.end[2:]).max() < CLOSE


@pytest.mark.parametrize("apart", [1e-6, 1e-9, 1e-12, 1e-14])
@pytest.mark.parametrize("rule", RULES)
def test_nearly_equal_twins(rule, apart):
    """Two gaps that differ by less and less: each clearance has the events that it has alone."""
    single, start = _busy(rule)
    other, _ = _busy(rule, gap=(0.2 + apart, 0.15 - apart))
    trace, _ = _run(side_by_side(single, other), np.tile(start, 2))
    for j, system in enumerate((single, other)):
        alone, _ = _run(system, start)
        _same(_events_of(trace, j), _events_of(alone, 0))
        assert np.abs(trace.end[2 * j : 2 * j + 2] - alone.end).max() < CLOSE


@pytest.mark.parametrize("rule", RULES)
def test_a_clearance_in_two_halves(rule):
    """Two clearances on one gap with half the force each are one clearance: all events coincide, coupled."""
    rng = np.random.default_rng([1, RULES.index(rule)])
    events = 0
    for size in (2, 4, 7):
        whole, start = random_member(rng, size, 1, (rule,))
        (c,) = whole.clearances
        parts = (replace(c, g=0.25 * c.g), replace(c, g=0.75 * c.g, name="rest"))
        one, derivative = _run(whole, start, 2.0)
        trace, joint = _run(replace(whole, clearances=parts), start, 2.0)
        assert len(trace.events) == 2 * len(one.events)
        events += len(trace.events)
        assert np.abs(trace.end - one.end).max() < CLOSE * max(1.0, np.abs(one.end).max())
        apart = np.abs(joint - derivative).max()
        assert apart < CLOSE * max(1.0, np.abs(derivative).max())
    assert events > 6


def test_order_of_clearances_does_not_matter():
    """The same system with its clearances listed in another order, rules mixed."""
    rng, events = np.random.default_rng(2), 0
    for _ in range(8):
        system, start = random_member(rng, 6, 3)
        order = rng.permutation(3)
        other = replace(system, clearances=tuple(system.clearances[j] for j in order))
        (one, a), (two, b) = _run(system, start, 1.5), _run(other, start, 1.5)
        assert [(order[j], *rest) for j, *rest in kinds(two.events)] == [tuple(k) for k in kinds(one.events)]
        assert np.abs(one.events.phase - two.events.phase).max(initial=0.0) < CLOSE
        assert np.abs(one.end - two.end).max() < CLOSE
        assert np.abs(a - b).max() < CLOSE * max(1.0, np.abs(a).max())
        events += len(one.events)
    assert events > 30


@pytest.mark.parametrize("rule", RULES)
def test_a_clearance_without_effect_is_watched(rule):
    """g = 0: it has events, and the motion is what it is without it."""
    single, start = _busy(ContactRule.IN_CONTACT)
    (c,) = single.clearances
    idle = replace(c, g=np.zeros(2), gap_plus=0.05, gap_minus=0.07, contact=rule, name="idle")
    trace, _ = _run(replace(single, clearances=(idle, c)), start)
    alone, _ = _run(single, start)
    _same(_events_of(trace, 1), _events_of(alone, 0))
    assert len(_events_of(trace, 0)[0]) > 0
    assert np.abs(trace.end - alone.end).max() < CLOSE


@pytest.mark.parametrize("rule", [ContactRule.ALWAYS, ContactRule.IN_CONTACT])
def test_side_by_side_in_closed_form(rule):
    """Two uncoupled oscillators of constant stiffness, every crossing of either to 40 digits."""
    parts = [
        oscillator(gap=(0.2, 0.1), stiffness=(2.0, 1.0), damping=0.2, rule=rule, force=(0.05, 0.6, 0.1)),
        oscillator(gap=(0.0, 0.3), stiffness=(5.0, 0.7), damping=0.1, rule=rule, force=(-0.1, 0.2, 0.5)),
    ]
    starts = np.array([[0.1, 0.3], [-0.2, 0.5]])
    trace, _ = _run(side_by_side(*parts), starts.ravel(), 2.0, 0.0)
    for j, system in enumerate(parts):
        exact, crossings = exact_impacts(system, starts[j], 2)
        phase, boundary, engaging = _events_of(trace, j)
        assert list(zip(boundary, engaging, strict=True)) == [(c[1], c[2]) for c in crossings]
        assert len(crossings) > 3
        assert np.abs(phase - [float(c[0]) for c in crossings]).max() < 1e-13
        assert np.abs(trace.end[2 * j : 2 * j + 2] - [float(x) for x in exact]).max() < 1e-13


def test_three_clearances_meet_at_one_instant():
    """Different rules, sides and speeds, all on their boundary at phase 0.3 exactly; truth in 80 bits."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle

    rng, met = np.random.default_rng(3), 0
    for _ in range(10):
        systems = [_busy(rule, gap=tuple(rng.uniform(0.1, 0.4, 2)))[0] for rule in RULES]
        system = side_by_side(*systems)
        there = np.zeros(6)
        for j, c in enumerate(system.clearances):
            side = rng.choice([-1, 1])
            there[2 * j] = c.gap_plus if side > 0 else -c.gap_minus
            there[2 * j + 1] = rng.choice([-1, 1]) * rng.uniform(0.2, 1.0)  # into contact, or out of it
        back = region_oracle.run(system, there.astype(np.longdouble), -0.05, 0.3)
        start, begin = back.state.astype(float), float(back.end)
        truth = region_oracle.run(system, start, 0.2, begin)
        near = [e for e in truth.events if abs(e.phase - 0.3) < 1e-14]
        trace = flow.trace(flow.propagators(system), start, 0.2, begin)
        assert trace.status is Status.OK
        far = match(system, trace, truth)
        assert far.holds(), far.told
        met += len(near) >= 2
    assert met > 5
