"""Many impacts, no damping, no bound: what a motion of several clearances may be driven to."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import Clearance, ContactRule, Status, System
from oracles.matches import kinds, match
from oracles.members import RULES, random_member
from oracles.oscillators import oscillator, side_by_side
from oracles.pairs import helical_bodies, random_bodies, random_mesh


def _bounces(gap: float, speed: float, stiffness: float, until: float):
    """Events (time, boundary, engaging) of a free mass between two equal springs, started in the middle."""
    across, inside = 2 * gap / speed, np.pi / np.sqrt(stiffness)
    count = int(until / (across + inside)) + 1
    engage = gap / speed + (across + inside) * np.arange(count)
    times = np.column_stack([engage, engage + inside]).ravel()
    boundary = np.repeat(np.where(np.arange(count) % 2 == 0, 1, -1), 2)
    engaging = np.tile([True, False], count)
    kept = times < until
    return times[kept], boundary[kept], engaging[kept]


@pytest.mark.parametrize("rule", RULES)
def test_thousands_of_impacts_in_a_cycle(rule):
    """Two free masses between springs at ω = 0.02: about 2,400 and 1,300 events in one mesh cycle, all times
    in closed form."""
    parts = ((0.05, 1.0, 400.0), (0.12, 0.8, 300.0))
    system = side_by_side(
        *(oscillator(omega=0.02, gap=(d, d), stiffness=(k, k), rule=rule) for d, _, k in parts)
    )
    start = np.array([0.0, parts[0][1], 0.0, parts[1][1]])
    props = flow.propagators(system)
    trace = flow.trace(props, start, 1.0)
    assert trace.status is Status.OK
    clearance = np.array([kind[0] for kind in kinds(trace.events)])
    counts = []
    for j, (gap, speed, stiffness) in enumerate(parts):
        times, boundary, engaging = _bounces(gap, speed, stiffness, system.period)
        mine = clearance == j
        assert trace.events.boundary[mine].tolist() == boundary.tolist()
        assert trace.events.engaging[mine].tolist() == engaging.tolist()
        assert np.abs(trace.events.phase[mine] * system.period - times).max() < 1e-10
        assert np.abs(np.abs(trace.events.state[mine, 2 * j]) - gap).max() < 1e-14
        counts.append(
            [int(np.sum((boundary == s) & (engaging == e))) for e in (True, False) for s in (1, -1)]
        )
    assert sum(map(sum, counts)) > 3000
    carried = flow.carry(props, start, 1.0)
    assert carried.contacts.reshape(-1, 4).tolist() == counts
    assert np.abs(carried.state - trace.end).max() < 1e-10


@pytest.mark.parametrize("rule", RULES)
def test_chatter(rule):
    """A slow load throws a damped mass from one stiff stop to the other: bounces that die out, again and
    again, until they are gone."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle

    system = oscillator(
        omega=0.05,
        gap=(0.1, 0.2),
        stiffness=(400.0, 150.0),
        damping=0.3 if rule is ContactRule.ALWAYS else 3.0,
        rule=rule,
        force=(0.05, 0.4, 0.1),
    )
    walk = region_oracle.run(system, [0.0, 0.3], 1.0, 0.2)
    trace = flow.trace(flow.propagators(system), [0.0, 0.3], 1.0, 0.2)
    assert len(walk.events) > 20
    assert trace.status is Status.OK
    far = match(system, trace, walk)
    assert far.holds(1e-12), far.told


def test_contact_lost_and_found_within_the_overlap():
    """Under no-tension a fast retreat ends the force long before the gap, and it comes back there: events in
    the middle of the overlap, counted as contacts; leaving the overlap without force is none."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle

    rng, again, quiet = np.random.default_rng(1), 0, 0
    for _ in range(60):
        system, state = random_member(rng, int(rng.choice([2, 4, 6])), 2, (ContactRule.NO_TENSION,))
        strong = tuple(replace(c, damping=c.damping + 0.5, damping_minus=1.0) for c in system.clearances)
        system = replace(system, clearances=strong)
        walk = region_oracle.run(system, state, 1.0, 0.3)
        found = flow.trace(flow.propagators(system), state, 1.0, 0.3)
        far = match(system, found, walk)
        assert found.status is Status.OK
        assert far.holds(), far.told
        again += sum(e.early and e.engaging for e in walk.events)
        quiet += sum(e.early and not e.engaging for e in walk.events)
    assert again > 3
    assert quiet > 30


def _geared_bodies(rng, kind: str) -> tuple[System, np.ndarray, np.ndarray]:
    """Undamped pair with clearance in a bearing of the gear besides: (system, symplectic form, start)."""
    mesh, bodies = replace(random_mesh(rng, kind), damping=0.0), replace(random_bodies(rng), xi=(0.0,) * 4)
    system = helical_bodies(mesh, bodies)
    h, g = np.zeros(10), np.zeros(10)
    h[4], g[5] = 1.0, -1.0 / bodies.mass[1]
    bearing = Clearance(
        h=h,
        g=g,
        gap_plus=0.05,
        gap_minus=0.03,
        stiffness_plus=np.array([4.0, 0.3, 0.1]),
        stiffness_minus=np.array([3.0]),
        name="bearing",
    )
    form = np.kron(np.diag(bodies.masses), [[0.0, 1.0], [-1.0, 0.0]])
    start = rng.normal(0.0, 0.2, 10)
    start[8] = (mesh.gap_plus + rng.uniform(-0.2, 0.3)) / bodies.c_t
    return replace(system, clearances=(*system.clearances, bearing)), form, start


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("kind", ["plain", "negative-load", "unequal", "one-sided", "tiny-gap"])
def test_symplectic_with_two_clearances(kind, rule):
    """Without damping the monodromy keeps the form through the events of both; errors in times would show."""
    rng, met = np.random.default_rng([2, len(kind)]), np.zeros(2)
    for _ in range(5):
        system, form, start = _geared_bodies(rng, kind)
        system = replace(system, clearances=tuple(replace(c, contact=rule) for c in system.clearances))
        carried = flow.variational(flow.propagators(system), start, 1.0, 0.1)
        assert carried.jacobian is not None
        met += carried.contacts.reshape(-1, 4).sum(axis=1)
        scale = np.abs(carried.jacobian).max() ** 2 * np.abs(form).max()
        apart = carried.jacobian.T @ form @ carried.jacobian - form
        assert np.abs(apart).max() < 1e-13 * max(1.0, scale)
    assert met.min() > 3


@pytest.mark.parametrize("rule", RULES)
def test_volume_with_several_clearances(rule):
    """det = exp ∫ trace: damping counts while in contact only, the saltation I ± ζ g hᵀ has determinant 1."""
    rng = np.random.default_rng([4, RULES.index(rule)])
    for _ in range(8):
        parts = [
            oscillator(
                omega=0.9,
                gap=tuple(rng.uniform(0.05, 0.3, 2)),
                stiffness=([2.0, 0.5, 0.2], [1.0, 0.1, 0.3]),
                damping=0.2,
                rule=rule,
                force=(0.1, *rng.uniform(-0.5, 0.5, 2)),
            )
            for _ in range(2)
        ]
        start = rng.normal(0.0, 0.4, 4)
        props = flow.propagators(side_by_side(*parts))
        carried, trace = flow.variational(props, start, 2.0), flow.trace(props, start, 2.0)
        assert carried.jacobian is not None
        expected = sum(_dissipated(part, trace, j, start[2 * j]) for j, part in enumerate(parts))
        sign, logarithm = np.linalg.slogdet(carried.jacobian)
        assert sign == 1.0
        assert abs(logarithm - expected) < 1e-10


def _dissipated(part: System, trace, clearance: int, place: float) -> float:
    """∫ trace of one oscillator: −ζ times how long its damping acts, from the events alone."""
    (c,) = part.clearances
    whole = trace.cycles * part.period
    if c.contact is ContactRule.ALWAYS:
        return -c.damping * whole
    mine = np.array([kind[0] == clearance for kind in kinds(trace.events)], dtype=bool)
    times = (trace.events.phase[mine] - trace.phase) * part.period
    into = trace.events.engaging[mine]
    acting = float(np.sum(np.where(into, -times, times)))
    inside = place > c.gap_plus or place < -c.gap_minus
    ends_inside = bool(into[-1]) if mine.any() else inside
    return -c.damping * (acting + (whole if ends_inside else 0.0))


@pytest.mark.parametrize("rule", RULES)
def test_overflow_in_the_middle_is_a_status(rule):
    """One of two oscillators runs away: said at once, never a hang; what was not reached is NaN."""
    calm = oscillator(rule=rule, stiffness=(2.0, 1.0), damping=0.2, force=(0.0, 0.4, 0.1))
    wild = oscillator(rule=rule, stiffness=(2.0, 1.0), damping=0.2, ground=(-400.0, 0.0))
    system = side_by_side(calm, wild)
    props = flow.propagators(system)
    start = np.array([0.1, 0.2, 0.3, 0.0])
    strobes = flow.march(props, start, 60)
    assert strobes.status is Status.DIVERGED
    assert np.isfinite(strobes.states[:2]).all()
    assert np.isnan(strobes.states[-50:]).all()
    assert flow.carry(props, start, 60.0).status is Status.DIVERGED
    assert flow.variational(props, start, 60.0).status is Status.DIVERGED
    assert flow.trace(props, start, 60.0).status is Status.DIVERGED
