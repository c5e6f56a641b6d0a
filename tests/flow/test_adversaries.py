"""Where an engine of several clearances and rules breaks first: on boundaries, at cell edges, at gaps of no
width, at every speed. Each with a closed form or with truth in 80 bits."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import ContactRule, Status, System
from oracles.closed_forms import exact_linear
from oracles.matches import kinds, match
from oracles.members import RULES, random_member
from oracles.oscillators import oscillator, side_by_side
from oracles.pairs import KINDS, random_system


@pytest.fixture
def truth():
    """``truth(system, state, cycles, phase)`` in 80-bit arithmetic, or a skip."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle

    return region_oracle.run


def _agrees(system: System, state, cycles: float, phase: float, walk, state_bar=1e-13):
    """Trace and carry against the truth; returns the trace."""
    props = flow.propagators(system)
    trace = flow.trace(props, state, cycles, phase)
    far = match(system, trace, walk)
    assert trace.status is Status.OK
    assert far.holds(state_bar), far.told
    carried = flow.carry(props, state, cycles, phase)
    assert carried.status is Status.OK
    assert carried.contacts.reshape(-1, 4).tolist() == walk.contacts(len(system.clearances))
    size = max(1.0, float(np.linalg.norm(walk.state)))
    assert np.abs(carried.state - walk.state).max() < state_bar * size
    return trace


def _in_one_cell(trace) -> int:
    """The most events that one cell of the grid holds."""
    cells = np.floor(trace.events.phase * trace.propagators.cells_per_cycle).astype(int)
    return int(np.bincount(cells - cells.min()).max())


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("width", [1e-3, 1e-7, 1e-9])
def test_two_and_more_events_in_one_cell(truth, rule, width):
    """A narrow gap crossed both ways, with a second clearance in its middle: four events and more."""
    wide = oscillator(
        omega=0.9, gap=(width, width), stiffness=(2.0, 3.0), damping=0.1, rule=rule, force=(0.1, 0.5, 0.2)
    )
    (c,) = wide.clearances
    inner = replace(c, gap_plus=width / 2, gap_minus=width / 3, g=0.3 * c.g, name="inner")
    system = replace(wide, clearances=(c, inner))
    walk = truth(system, [0.2, -0.5], 3.0, 0.0)
    trace = _agrees(system, [0.2, -0.5], 3.0, 0.0, walk)
    assert _in_one_cell(trace) >= (4 if width < 1e-4 else 2)


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize(
    "gap", [(1e-9, 1e-9), (0.0, 0.3), (0.3, 0.0), (0.0, 0.0), (0.2, -0.2), (1e-9, 0.0)], ids=str
)
def test_gaps_of_hardly_any_width(truth, rule, gap):
    """1e-9, zero on one side, zero on both, no width away from zero; unequal sides under every rule."""
    rng = np.random.default_rng([1, RULES.index(rule)])
    for size in (2, 4, 7):
        system, state = random_member(rng, size, 1, (rule,))
        (c,) = system.clearances
        stiff = [s if s.any() else np.array([1.5, 0.2, 0.1]) for s in (c.stiffness_plus, c.stiffness_minus)]
        narrow = replace(
            c, gap_plus=gap[0], gap_minus=gap[1], stiffness_plus=stiff[0], stiffness_minus=stiff[1]
        )
        system = replace(system, clearances=(narrow,))
        walk = truth(system, state, 2.0, 0.2)
        _agrees(system, state, 2.0, 0.2, walk)


def test_no_gap_at_all_is_linear():
    """In contact on one side or the other with equal sides: damped everywhere, so known exactly."""
    system = oscillator(
        omega=0.9,
        gap=(0.1, -0.1),
        stiffness=(2.0, 2.0),
        damping=0.2,
        rule=ContactRule.IN_CONTACT,
        force=(0.1, 0.5, 0.2),
    )
    matrix, forcing = np.array([[0.0, 1.0], [-2.0, -0.2]]), np.array(system.forcing)
    forcing[1, 0] += 2.0 * 0.1
    trace = flow.trace(flow.propagators(system), [0.3, -0.4], 3.0, 0.1)
    assert trace.status is Status.OK
    assert len(trace.events) > 4
    assert np.abs(trace.events.phase[0::2] - trace.events.phase[1::2]).max() < 1e-15
    assert np.abs(trace.end - exact_linear(matrix, forcing, 0.9, [0.3, -0.4], 3.0, 0.1)).max() < 1e-13


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("side", [1, -1])
def test_start_on_the_boundaries_of_both(truth, rule, side):
    """Both clearances at ±D exactly, each moving in or out: no event at the start, the right region after."""
    one = oscillator(omega=0.7, gap=(0.5, 0.25), stiffness=(2.0, 1.0), damping=0.2, rule=rule, force=(0.01,))
    system = side_by_side(one, one)
    place = 0.5 if side > 0 else -0.25
    for velocities in ((0.3, 0.2), (0.3, -0.2), (-0.3, 0.2), (-1e-6, 1e-6)):
        start = np.array([place, side * velocities[0], place, side * velocities[1]])
        walk = truth(system, start, 0.4, 0.0)
        trace = _agrees(system, start, 0.4, 0.0, walk)
        first = [[kind[2] for kind in kinds(trace.events) if kind[0] == j][:1] for j in (0, 1)]
        for velocity, engaging in zip(velocities, first, strict=True):
            assert not engaging or engaging[0] == (velocity < 0)


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("load", [0.4, -0.4])
def test_start_at_an_extremum_on_the_boundary(truth, rule, load):
    """X = D and X′ = 0: the acceleration decides, or the status says that rounding does. The motion is the
    same either way; for small times X − D = load τ²/2."""
    system = oscillator(
        omega=0.7, gap=(0.5, 0.25), stiffness=(2.0, 1.0), damping=0.2, rule=rule, force=(load,)
    )
    walk = truth(system, [0.5, 0.0], 0.5, 0.0)
    trace = flow.trace(flow.propagators(system), [0.5, 0.0], 0.5)
    far = match(system, trace, walk)
    assert trace.status in (Status.OK, Status.UNCERTAIN)
    assert far.holds(), far.told
    early = flow.trace(flow.propagators(system), [0.5, 0.0], 1e-4)
    tau = 1e-4 * system.period
    assert len(early.events) == 0
    assert abs((early.end[0] - 0.5) / (load * tau**2 / 2) - 1) < 1e-3


@pytest.mark.parametrize("growing", [True, False])
def test_start_where_nothing_presses_any_more(truth, growing):
    """Under no-tension at η δ + ζ δ′ = 0 exactly: pressing or not, it is what it is about to be."""
    load = 2.0 if growing else -2.0
    system = oscillator(
        gap=(0.5, 0.5),
        stiffness=(1.0, 1.0),
        damping=0.5,
        rule=ContactRule.NO_TENSION,
        force=(load,),
    )
    start = np.array([0.75, -0.5])  # δ = 1/4, δ′ = −1/2: P = 0, P′ = −1/2 + load/2
    walk = truth(system, start, 0.1, 0.0)
    trace = _agrees(system, start, 0.1, 0.0, walk)
    assert len(trace.events) == 0
    tau = 1e-3 * system.period
    small = flow.trace(flow.propagators(system), start, 1e-3)
    free = np.array([0.75 - 0.5 * tau + load * tau**2 / 2, -0.5 + load * tau])
    assert (abs(small.end[1] - free[1]) > 1e-6) == growing  # the force acts, or does not


@pytest.mark.parametrize("rule", RULES)
def test_events_at_cell_edges(rule):
    """Uniform motion in the gap, so that the crossing lies on an edge but for rounding: once, wherever."""
    plain = oscillator(gap=(0.5, 0.5), stiffness=(2.0, 1.0), damping=0.0, rule=rule)
    if rule is not ContactRule.ALWAYS:  # which would brake in the gap
        plain = replace(plain, clearances=(replace(plain.clearances[0], damping=0.2),))
    system = side_by_side(plain, plain)
    props = flow.propagators(system)
    period, cells = system.period, round(props.cells_per_cycle)
    for cell in range(1, cells):
        for velocity in (0.3, -0.7):
            there = np.sign(velocity) * 0.5 - velocity * period * cell / cells
            start = np.array([there, velocity, there, velocity])
            if abs(there) > 0.5:
                continue
            after = (cell + 0.5) / cells
            trace, carried = flow.trace(props, start, after), flow.carry(props, start, after)
            assert trace.status is carried.status is Status.OK
            assert len(trace.events) == 2
            assert np.abs(trace.events.phase - cell / cells).max() < 1e-14
            assert carried.contacts.sum() == 2
            parts = [flow.carry(props, start, cell / cells)]
            parts.append(flow.carry(props, parts[0].state, after - cell / cells, cell / cells))
            assert sum(int(part.contacts.sum()) for part in parts) == 2


@pytest.mark.parametrize("rule", RULES)
def test_a_touch_from_the_gap_within_rounding(rule):
    """X = −0.3 cos θ under a harmonic force alone touches D = 0.3 at θ = π: undecided there alone."""
    for push, sure in ((0.0, None), (1e-12, 0), (-1e-12, 2)):
        system = oscillator(
            gap=(0.3 + push, 0.5), stiffness=(2.0, 1.0), damping=0.2, rule=rule, force=(0.0, 0.3, 0.0)
        )
        if rule is ContactRule.ALWAYS:
            system = replace(system, clearances=(replace(system.clearances[0], damping=0.0),))
        second = oscillator(gap=(0.9, 0.9), rule=rule)
        both = side_by_side(system, second)
        for case, start in ((system, [-0.3, 0.0]), (both, [-0.3, 0.0, 0.1, 0.0])):
            trace = flow.trace(flow.propagators(case), start, 1.0)
            assert np.abs(trace.end[:2] - [-0.3, 0.0]).max() < 1e-13 + 10 * abs(push)
            assert len(trace.events) == (sure or 0) or sure is None
            assert trace.status is (Status.UNCERTAIN if sure is None else Status.OK)


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("kind", KINDS)
def test_gear_pairs_under_every_rule(truth, rule, kind):
    """Load reversal, unequal and one-sided sides, tiny gaps, ripple beyond the mean, slow, overdamped."""
    rng = np.random.default_rng([3, KINDS.index(kind)])
    for pair in ("spur", "helical"):
        system, state = random_system(rng, pair, kind)
        system = replace(system, clearances=(replace(system.clearances[0], contact=rule),))
        cycles, phase = 0.4 if kind == "slow" else 2.0, float(rng.uniform(0.0, 1.0))
        walk = truth(system, state, cycles, phase)
        _agrees(system, state, cycles, phase, walk)


@pytest.mark.slow
@pytest.mark.parametrize("omega", [0.02, 0.05, 0.2, 3.0, 15.0, 50.0])
def test_every_speed(truth, omega):
    """Up to 15 units of τ: a twentieth of a cycle at 0.02, forty cycles at 50."""
    rng, events, span = np.random.default_rng(int(100 * omega)), 0, 15.0 if omega < 10.0 else 5.0
    for _ in range(6 if omega < 10.0 else 3):
        system, state = random_member(rng, int(rng.choice([2, 4, 6])), 2)
        system = replace(system, omega=omega)
        cycles, phase = span * omega / (2 * np.pi), float(rng.uniform(0.0, 1.0))
        walk = truth(system, state, cycles, phase)
        _agrees(system, state, cycles, phase, walk)
        events += len(walk.events)
    assert events > 5


@pytest.mark.parametrize("rule", RULES)
def test_ripple_that_nearly_cancels_the_stiffness(truth, rule):
    """η between 1e-6 and 2: hardly anything holds at its least."""
    ripple = np.array([1.0, 1.0 - 1e-6, 0.0])
    for load in (0.05, 0.4):
        system = oscillator(
            omega=0.6,
            gap=(0.2, 0.2),
            stiffness=(ripple, 2 * ripple),
            damping=0.15,
            rule=rule,
            force=(load, 0.3, 0.2),
        )
        walk = truth(system, [0.1, 0.6], 3.0, 0.2)
        _agrees(system, [0.1, 0.6], 3.0, 0.2, walk)
        assert len(walk.events) > 2
