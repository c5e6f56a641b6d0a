"""Where an event engine breaks first: starts on a boundary, many events in a cell, gaps of no width, rest."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import Clearance, GearlashError, Status, System
from oracles.closed_forms import exact_linear, permanent_contact
from oracles.pairs import KINDS, Bodies, Mesh, helical, random_system, spur

STILL = replace(Mesh(), ripple=(), ripple_phase=(), error=(0.0,), load=0.0)


def _crossings(events) -> list[tuple[int, bool]]:
    return list(zip(events.boundary.tolist(), events.engaging.tolist(), strict=True))


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_start_on_a_boundary_goes_the_way_it_moves(pair, side):
    """X = ±D exactly: the region is the one it is about to enter, and the start itself is no event."""
    mesh = Mesh(gap_plus=0.5, gap_minus=0.5, load=0.0, error=(0.01,))
    system = spur(mesh) if pair == "spur" else helical(mesh, Bodies())
    props = flow.propagators(system)
    for velocity in (0.3, 1e-6, -1e-6, -0.3):
        start = np.zeros(system.size)
        start[-2:] = side * 0.5, side * velocity
        trace = flow.trace(props, start, 0.2)
        assert trace.status is Status.OK
        early = trace.at(1e-9).displacement[0]
        assert (side * early > 0.5) == (velocity > 0)
        assert not (trace.events.phase < 1e-9).any()


def test_start_beside_a_boundary_crosses_it_once():
    """Beyond rounding a side is a side; within rounding of the boundary the direction decides, because the
    crossing belongs to the span that ended there."""
    props = flow.propagators(spur(Mesh()))
    inside, outside = 1.0 - 1e-12, 1.0 + 1e-12
    assert _crossings(flow.trace(props, [inside, 0.1], 0.01).events) == [(1, True)]
    assert _crossings(flow.trace(props, [outside, 0.1], 0.01).events) == []
    assert _crossings(flow.trace(props, [outside, -0.1], 0.01).events) == [(1, False)]
    assert _crossings(flow.trace(props, [inside, -0.1], 0.01).events) == []
    for start in (np.nextafter(1.0, 0.0), 1.0, np.nextafter(1.0, 2.0)):
        for velocity in (0.1, -0.1):
            assert _crossings(flow.trace(props, [start, velocity], 0.01).events) == []


def test_a_span_includes_the_event_at_its_end():
    """Cut at an event, a motion has it once: in the span that ends there, whatever carries it."""
    props = flow.propagators(spur(replace(Mesh(), gap_plus=0.4, gap_minus=0.3)))
    rng = np.random.default_rng(7)
    cuts = 0
    for start in rng.normal(scale=0.5, size=(40, 2)):
        whole = flow.trace(props, start, 2.0)
        for i, phase in enumerate(whole.events.phase[:3]):
            first = flow.trace(props, start, phase)
            rest = flow.trace(props, first.end, 2.0 - phase, phase)
            assert len(first.events) == i + 1
            assert len(first.events) + len(rest.events) == len(whole.events)
            carried = flow.carry(props, start, phase)
            onward = flow.carry(props, carried.state, 2.0 - phase, phase)
            assert (carried.contacts + onward.contacts).sum() == len(whole.events)
            cuts += 1
    assert cuts > 50


def test_a_trace_answers_inside_its_span_only():
    trace = flow.trace(flow.propagators(spur(Mesh())), [1.1, 0.0], 1.0)
    with pytest.raises(GearlashError, match="0 to 1"):
        trace.at([0.5, 1.5])


def test_several_events_in_one_cell(oracle):
    """Both boundaries of a narrow gap within one cell, in order, and back again."""
    system = helical(replace(Mesh(), gap_plus=1e-7, gap_minus=1e-7), Bodies())
    start = np.zeros(10)
    start[8:] = 0.2, -0.5
    truth = oracle("helical").run(system, start, 3.0)
    props = flow.propagators(system)
    trace = flow.trace(props, start, 3.0)
    cell = np.floor(trace.events.phase * props.cells_per_cycle)
    assert np.bincount(cell.astype(int)).max() >= 2
    assert trace.status is Status.OK
    assert _crossings(trace.events) == truth.crossings
    assert np.abs(trace.events.phase - truth.phase).max() < 1e-13
    assert np.abs(trace.end - truth.state).max() < 1e-13


def test_a_graze_and_a_crossing_in_one_cell(oracle):
    """A touch of Σ1 of depth 1e-9 from the gap, with Σ2 within the same cell on either side of it."""
    from oracles.grazes import gap_acceleration

    mesh = replace(Mesh(load=-0.5), gap_plus=1e-4, gap_minus=1e-4)
    system, phase = helical(mesh, Bodies()), 0.31
    props = flow.propagators(system)
    for depth in (1e-9, -1e-9):
        touch = np.zeros(10)
        touch[8] = 1e-4 + depth
        assert gap_acceleration(system, touch, phase) < -0.1
        back = oracle("helical").run(system, touch, -0.015, phase)
        start, begin = back.state.astype(float), float(back.end)
        truth = oracle("helical").run(system, start, 0.03, begin)
        trace = flow.trace(props, start, 0.03, begin)
        cells = np.floor(trace.events.phase * props.cells_per_cycle)
        assert len(np.unique(cells)) == 1
        assert _crossings(trace.events) == truth.crossings
        assert len(trace.events) == (4 if depth > 0 else 2)
        assert np.abs(trace.events.phase - truth.phase).max() < 1e-11


@pytest.mark.parametrize("shift", [0.0, 0.3])
def test_gap_of_no_width(shift):
    """D⁺ = −D⁻: equal sides make it a linear system, known exactly; both boundaries are crossed together."""
    mesh = Mesh(
        gap_plus=shift, gap_minus=-shift, ripple=(), ripple_phase=(), error=(0.3,), error_phase=(1.0,)
    )
    system = helical(mesh, Bodies())
    (c,) = system.clearances
    matrix = system.matrix + np.outer(c.g, c.h + c.damping * (c.h @ system.matrix))
    forcing = np.array(system.forcing)
    forcing[:, 0] -= c.g * shift
    start = np.zeros(10)
    start[8:] = 0.2, -0.3
    trace = flow.trace(flow.propagators(system), start, 2.0, 0.1)
    assert trace.status is Status.OK
    assert np.abs(trace.end - exact_linear(matrix, forcing, mesh.omega, start, 2.0, 0.1)).max() < 1e-13
    assert len(trace.events) > 0
    assert np.array_equal(trace.events.phase[0::2], trace.events.phase[1::2])
    walk = _crossings(trace.events)
    assert all(
        walk[k][0] == -walk[k + 1][0] and not walk[k][1] and walk[k + 1][1] for k in range(0, len(walk), 2)
    )


def test_events_at_strobes_are_neither_lost_nor_doubled(oracle):
    """A contact exactly at the end of a stretch: march and trace count it once."""
    rng = np.random.default_rng(0)
    for index in range(48):
        kind = KINDS[index % 6]
        system, state = random_system(rng, "helical", kind)
        c, side = system.clearances[0], 1 if index % 2 else -1
        velocity = 0.4 * rng.normal()
        at = state.astype(np.longdouble)
        # A hair before the crossing, so that the oracle knows its region.
        at[-2] = np.longdouble(side * (c.gap_plus if side > 0 else c.gap_minus)) - np.sign(
            velocity
        ) * np.longdouble(1e-18)
        at[-1] = velocity
        start = oracle("helical").run(system, at, -1.0, 1.0).state.astype(float)
        truth = oracle("helical").run(system, start, 2.0)
        assert np.abs(truth.phase - 1.0).min() < 1e-12
        props = flow.propagators(system)
        assert len(flow.trace(props, start, 2.0).events) == len(truth.phase)
        assert flow.march(props, start, 2).contacts.sum() == len(truth.phase)


def test_rest_on_a_boundary_is_undecidable_and_says_so():
    """X ≡ D with no force at all: no region is the right one."""
    props = flow.propagators(spur(STILL))
    for place in (1.0, -1.0):
        trace = flow.trace(props, [place, 0.0], 3.0)
        assert trace.status is Status.UNCERTAIN
        assert trace.undecided > 0
        assert trace.end.tolist() == [place, 0.0]


def test_rest_in_the_gap_and_in_contact():
    for load, place in ((0.0, 0.5), (0.0, 0.0), (0.1, 1.1), (-0.1, -1.1)):
        trace = flow.trace(flow.propagators(spur(replace(STILL, load=load))), [place, 0.0], 3.0)
        assert trace.status is Status.OK
        assert len(trace.events) == 0
        assert np.abs(trace.end - [place, 0.0]).max() < 1e-14


def test_many_periods_in_permanent_contact_do_not_drift():
    system = helical(Mesh(load=3.0), Bodies())
    response = permanent_contact(system, 40)(0.0)
    start = np.zeros(10)
    start[8] = 4.0
    strobes = flow.march(flow.propagators(system), start, 4000)
    assert strobes.status is Status.OK
    assert np.abs(strobes.states[-1] - response).max() < 1e-13
    assert np.abs(strobes.states[-1] - strobes.states[-2]).max() < 1e-14


@pytest.mark.parametrize(("harmonics", "stiffness"), [(20, 1.0), (3, 100.0), (3, 2000.0)])
def test_many_harmonics_and_stiff_sides(oracle, harmonics, stiffness):
    del oracle
    from oracles.compare import distance
    from oracles.heyoka_oracle import Oracle

    rng = np.random.default_rng(harmonics)

    def series(mean, size):
        return np.concatenate([[mean], rng.normal(0.0, size, 2 * harmonics)])

    sides = Clearance(
        h=np.array([1.0, 0.0]),
        g=np.array([0.0, -1.0]),
        gap_plus=0.3,
        gap_minus=0.2,
        stiffness_plus=stiffness * series(1.0, 0.02),
        stiffness_minus=stiffness * series(0.5, 0.02),
        damping=0.05,
        offset=series(0.0, 0.002),
    )
    matrix = np.array([[0.0, 1.0], [-0.1, -0.02]])
    system = System(0.7, matrix, np.vstack([0 * series(0.0, 1.0), series(0.2, 0.05)]), (sides,))
    props, oracle = flow.propagators(system), Oracle([system], harmonics=harmonics)
    far = distance(system, flow.trace(props, [0.31, -0.4], 0.6), oracle.run(system, [0.31, -0.4], 0.6))
    assert far.event_time < 1.0
    far = distance(system, flow.trace(props, [0.31, -0.4], 2.0), oracle.run(system, [0.31, -0.4], 2.0))
    assert far.same_crossings
    assert far.same_extrema
    # with the stiff sides this motion multiplies an error of its start by 3e4: no method can do better
    jacobian = flow.variational(props, [0.31, -0.4], 2.0).jacobian
    assert jacobian is not None
    assert far.state < max(1e-13, 2.0**-53 * np.abs(jacobian).sum(axis=1).max())


def test_bad_input_is_named():
    props = flow.propagators(spur(Mesh()))
    with pytest.raises(GearlashError, match="shape"):
        flow.trace(props, [1.0, 0.0, 0.0], 1.0)
    for bad in (np.nan, np.inf):
        with pytest.raises(GearlashError, match="NaN or infinity"):
            flow.trace(props, [bad, 0.0], 1.0)
    with pytest.raises(GearlashError, match="cycles"):
        flow.trace(props, [1.0, 0.0], -1.0)


def test_divergence_is_a_status():
    """An unstable matrix: said at once, also where cells are proved clear; what was not reached is NaN."""
    unstable = replace(spur(Mesh()), matrix=np.array([[0.0, 1.0], [400.0, 0.0]]))
    props = flow.propagators(unstable)
    strobes = flow.march(props, [2.0, 0.0], 60)
    assert strobes.status is Status.DIVERGED
    assert np.isfinite(strobes.states[:3]).all()
    assert np.isnan(strobes.states[-50:]).all()
    assert flow.carry(props, [2.0, 0.0], 60.0).status is Status.DIVERGED
    assert flow.trace(props, [2.0, 0.0], 60.0).status is Status.DIVERGED


def test_zero_cycles_is_the_start():
    trace = flow.trace(flow.propagators(spur(Mesh())), [1.3, 0.2], 0.0, 0.4)
    assert trace.end.tolist() == [1.3, 0.2]
    assert len(trace.events) == 0
