"""Several clearances and all contact rules: counts, touches, multipliers, exponents."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import flow
from gearlash.branches import locate_grazing
from gearlash.flow.events import contact_force
from gearlash.orbits import Orbit, Signature, grazing_checks, lyapunov, sections, shoot
from gearlash.results import sweep_dataset
from gearlash.studies import Axis, Quiet, point, sweep
from gearlash.studies.transition import GRAZING
from gearlash.studies.transitions import transitions
from gearlash.system import ContactRule, GearlashError
from oracles import closed_forms
from orbits.contacts import one_dof_under, two_gaps
from orbits.members import built, orbit

RULES = list(ContactRule)
OMEGAS = (0.3, 0.5, 0.9, 1.0, 1.5)


def counted(found: Orbit) -> list[list[int]]:
    """How often each gap is entered on either side, from dense samples of the trace's states alone."""
    trace, system = found.trace, found.propagators.system
    state = trace.samples(40_001 * found.period).state
    out = []
    for c in system.clearances:
        x = state @ c.h - c.offset[0]
        rising = (x[:-1] <= c.gap_plus) & (x[1:] > c.gap_plus) if c.stops(1) else np.zeros(1)
        falling = (x[:-1] >= -c.gap_minus) & (x[1:] < -c.gap_minus) if c.stops(-1) else np.zeros(1)
        out.append([int(rising.sum()), int(falling.sum())])
    return out


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("omega", OMEGAS)
def test_the_signature_counts_every_gap(rule, omega):
    found = orbit(two_gaps(rule), omega=omega)
    assert [list(pair) for pair in found.signature.counts] == counted(found)
    assert found.label == found.signature
    assert Signature.parse(str(found.label)) == found.signature
    assert found.signature.impacts > 0
    assert found.signature.back == 0, "the stop has one side only"


def test_gaps_are_told_apart_in_sections_and_checks():
    found = orbit(two_gaps(), omega=0.5)
    for gap in (0, 1):
        shown, counts = sections(found, gap), found.signature.counts[gap]
        assert (len(shown.drive.entering), len(shown.back.entering)) == counts
        c = found.propagators.system.clearances[gap]
        assert shown.drive.displacement == pytest.approx(np.full(len(shown.drive), c.gap_plus), abs=1e-13)
        checks = grazing_checks(found, clearance=gap)
        assert {(check.clearance, check.name) for check in checks} == {(gap, c.name)}
        assert {check.boundary for check in checks} == ({1} if gap == 0 else {1, -1})
    assert len(grazing_checks(found)) == sum(len(grazing_checks(found, clearance=j)) for j in (0, 1))


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize(("gap", "ends"), [(0, (0.9, 1.0)), (1, (0.52, 0.6))])
def test_a_touch_in_either_gap_is_solved_for(rule, gap, ends):
    """Where it is found, an extremum of that gap, sampled densely, reaches the boundary; labels differ."""
    family = two_gaps(rule)
    found = sweep(family, Axis.even("omega", ends[0], ends[1], 5), direction="up")
    changes = transitions(family, "omega", found.points)
    grazes = [t.point for t in changes if t.point is not None and t.point.is_grazing]
    at = next(point for point in grazes if point.touch.clearance == gap)
    assert at.status.ok
    assert family.system(at.values).clearances[gap].name == ("stop", "link")[gap]
    side, surface = at.touch.boundary, at.touch.surface
    below, above = at.label_below, at.label_above
    assert isinstance(below, Signature)
    assert isinstance(above, Signature)
    assert below.one_impact_from(above) == (gap, side)
    system = family.system(at.values)
    c = system.clearances[gap]
    moved = flow.trace(built(family, **at.values), at.point.state, float(at.period))
    samples = moved.samples(200_001)
    x, speed = samples.state @ c.h, samples.state @ (c.h @ system.matrix)
    edge = c.gap_plus if side > 0 else -c.gap_minus
    height = x - edge
    if surface == "force":
        height = contact_force(system, samples.phase, x, speed, np.full(len(x), 0 if side > 0 else 2), gap)
    turning = np.flatnonzero((height[1:-1] - height[:-2]) * (height[2:] - height[1:-1]) <= 0.0) + 1
    assert np.abs(height[turning]).min() <= 1e-8


def test_changes_along_a_sweep_name_the_gap():
    family = two_gaps()
    found = sweep(family, Axis.even("omega", 0.9, 1.0, 6), direction="up")
    assert [p.certificate for p in found.points] == ["certified"] * 6
    changes = transitions(family, "omega", found.points)
    assert [(c.kind, c.label_below, c.label_above) for c in changes] == [(GRAZING, "1-1-0/1-1", "1-0-0/1-1")]
    assert changes[0].point is not None
    assert changes[0].point.touch.clearance == 0
    data = sweep_dataset(family, [found])
    assert data["other_impacts"].values.tolist() == [[2] * 6]
    assert data["certificate"].values.tolist() == [["certified"] * 6]


def test_quiet_asks_all_gaps():
    found = point(two_gaps(), {"omega": 1.0})
    assert found.label == "1-0-0/1-1"
    assert found.others == ((1, 1),)
    assert not found.impact_free
    assert not found.drive_side_only
    for quiet in Quiet:
        assert not quiet.holds(found)
        assert not quiet.holds_signature(Signature.parse("1-0-0/1-1"))
        assert quiet.holds_signature(Signature.parse("1-0-0/0-0"))


@pytest.mark.parametrize("text", ["1-0-0/1-1", "3-2-0/4-0/0-1", "12-12-3"])
def test_labels_are_read_back(text):
    assert str(Signature.parse(text)) == text


@pytest.mark.parametrize("text", ["1-0-0/", "1-0/1", "/1-1", "1-1-0/1-1-1", "1-1-0//1-1", "1-1-0/a-1", "²-1"])
def test_other_texts_are_not(text):
    with pytest.raises(GearlashError, match="for example 6-6-1"):
        Signature.parse(text)


def test_one_impact_apart():
    one = Signature(2, 1, 0, ((3, 1),))
    assert one.one_impact_from(Signature(2, 1, 0, ((3, 2),))) == (1, -1)
    assert one.one_impact_from(Signature(2, 0, 0, ((3, 1),))) == (0, 1)
    assert one.one_impact_from(one) is None
    assert one.one_impact_from(Signature(2, 0, 0, ((3, 2),))) is None
    assert one.one_impact_from(Signature(2, 1, 0, ((3, 3),))) is None
    assert one.one_impact_from(Signature(4, 1, 0, ((3, 2),))) is None
    assert one.one_impact_from(Signature(2, 1, 0)) is None
    assert one.twice == Signature(4, 2, 0, ((6, 2),))


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("omega", [0.5, 1.5])
def test_multipliers_are_those_of_finite_differences(rule, omega):
    found = orbit(two_gaps(rule), omega=omega)
    n, cycles, step = len(found.state), float(found.period), 1e-6
    matrix = np.empty((n, n))
    for i in range(n):
        up, down = (
            flow.carry(found.propagators, found.state + s * step * np.eye(n)[i], cycles).state
            for s in (1, -1)
        )
        matrix[:, i] = (up - down) / (2 * step)
    assert np.abs(matrix - found.shot.monodromy).max() <= 1e-6 * (1.0 + np.abs(matrix).max())
    moduli = np.sort(np.abs(np.linalg.eigvals(matrix)))
    assert np.sort(np.abs(found.multipliers)) == pytest.approx(moduli, abs=1e-6)


@pytest.mark.parametrize("rule", RULES)
def test_exponents_sum_to_the_mean_trace(rule):
    """Saltation changes no volume: only the time spent in contact counts, here read from dense samples."""
    found = orbit(two_gaps(rule), omega=0.5)
    system = found.propagators.system
    samples = found.trace.samples(200_001)
    mean = float(np.trace(system.matrix))
    for j, c in enumerate(system.clearances):
        inside = found.trace.at(samples.phase, j).region != 1
        share = 1.0 if rule is ContactRule.ALWAYS else float(inside[:-1].mean())
        mean += share * c.damping * float(c.h @ system.matrix @ c.g)
    assert np.sum(found.exponents) == pytest.approx(mean, abs=2e-5)
    averaged = lyapunov(found.propagators, found.state, 200)
    assert abs(averaged.trace_defect) <= 1e-10
    assert averaged.values.sum() == pytest.approx(mean, abs=2e-5)


@pytest.mark.parametrize("omega", [0.4, 0.7, 1.3])
def test_without_tension_contact_is_lost_where_the_force_ends(omega):
    """Φ = f_m + A √(1 + ζ²ω²) cos in permanent contact: it touches zero before X reaches D."""
    damping = 0.1  # ζ = 2 ξ_m
    gap = closed_forms.spur_grazing_load(omega, 0.1, damping)
    exact = {
        ContactRule.ALWAYS: gap,
        ContactRule.IN_CONTACT: gap,
        ContactRule.NO_TENSION: gap * np.sqrt(1.0 + (damping * omega) ** 2),
    }
    for rule, load in exact.items():
        family, values = one_dof_under(rule), {"omega": omega, "load": 1.05 * load}
        start = orbit(family, **values)
        check = next(c for c in grazing_checks(start) if c.boundary == 1 and c.a0 > 0.0)
        at = locate_grazing(family, "load", start, check, values=family.complete(values))
        assert at.status.ok
        assert at.value == pytest.approx(load, rel=1e-12)
        assert at.surface == ("force" if rule is ContactRule.NO_TENSION else "gap")
        assert (at.label_below, at.label_above) == ("1-1-0", "1-0-0")


@pytest.mark.parametrize("omega", [0.7, 1.3])
def test_a_force_touch_is_solved_for_from_the_separated_side_too(omega):
    damping = 0.1
    exact = closed_forms.spur_grazing_load(omega, 0.1, damping) * np.sqrt(1.0 + (damping * omega) ** 2)
    family, values = one_dof_under(ContactRule.NO_TENSION), {"omega": omega, "load": 0.9995 * exact}
    quiet = orbit(family, omega=omega, load=1.05 * exact)
    props = built(family, **values)
    shot = shoot(props, quiet.state, 1)
    start = Orbit(props, shot, 0, shot.status, "")
    assert start.label == "1-1-0"
    check = next(c for c in grazing_checks(start) if c.surface == "force" and c.distance < 0.0)
    at = locate_grazing(family, "load", start, check, values=family.complete(values))
    assert at.status.ok
    assert at.value == pytest.approx(exact, rel=1e-12)
