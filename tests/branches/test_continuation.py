"""Branches of periodic orbits against closed forms, against the article, and against themselves."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from branches.followed import PLAIN, bundled, linear, parametric, random_pair, six, values_of, window
from gearlash.branches.continuation import ContinuationSettings, EndKind, SpecialKind, continue_orbit
from gearlash.orbits import orbit_at
from gearlash.system import ContactRule, GearlashError
from orbits.members import built, one_dof, orbit

ALL = [linear, parametric, six, window]


def touching_frequencies(load: float, error: float, damping: float) -> list[float]:
    """Where the response E ω²/√((1−ω²)² + ζ²ω²) of the closed pair is as large as the load: a polynomial."""
    zeta = 2.0 * damping
    roots = np.roots([load**2 - error**2, load**2 * (zeta**2 - 2.0), load**2])
    return sorted(np.sqrt(roots[roots > 0.0].real).tolist())


def test_touches_of_the_linear_response_in_closed_form():
    found = sorted(values_of(linear(), SpecialKind.GRAZING))
    assert found == pytest.approx(touching_frequencies(0.1, 0.05, 0.05), rel=1e-12)


def test_fold_of_the_impacting_branch():
    """Known from another program (30 digits), as the next one."""
    folds = values_of(linear(), SpecialKind.FOLD)
    assert min(folds) == pytest.approx(0.708031618721831, rel=1e-12)
    assert len(folds) == 2


def test_doubling_in_permanent_contact():
    low, high = sorted(parametric().of_kind(SpecialKind.DOUBLING), key=lambda special: special.value)
    assert low.value == pytest.approx(1.88314401708371501, rel=1e-12)
    assert low.linear
    assert high.linear
    assert (low.unstable_before, low.unstable_after) == (0, 1)
    assert (high.unstable_before, high.unstable_after) == (1, 0)


def test_events_of_the_article():
    """As the study of its scans found them: tests/recorded holds more of them."""
    doubling, touch, join = six().special
    assert (doubling.kind, touch.kind, join.kind) == (
        SpecialKind.DOUBLING,
        SpecialKind.GRAZING,
        SpecialKind.JOINS,
    )
    assert doubling.value == pytest.approx(0.35232, abs=5e-6)
    assert touch.value == pytest.approx(0.385502, abs=5e-7)
    assert (touch.label_before, touch.label_after) == ("6-6-1", "6-6-2")
    assert six().ends[1].kind is EndKind.JOINED
    low, high = values_of(window(), SpecialKind.GRAZING)
    assert (low, high) == pytest.approx((0.9725, 1.112), abs=1e-6)
    assert len(window().of_kind(SpecialKind.TORUS)) == 1


def test_a_joining_orbit_is_the_doubling_of_the_other():
    """The 3-orbit there has a multiplier -1."""
    join = six().special[-1]
    props = built(bundled(), omega=0.78, D=join.value)
    single = orbit_at(props, join.point.state, 3)
    assert single is not None
    assert np.abs(single.multipliers + 1.0).min() < 1e-9


@pytest.mark.parametrize("branch", ALL)
def test_every_point_is_an_orbit(branch):
    for point in branch().points:
        assert point.residual < 1e-11
        assert point.strobes.shape == (point.period, len(point.state))
    arclengths = [point.arclength for point in branch().points]
    assert arclengths == sorted(arclengths)


@pytest.mark.parametrize("branch", ALL)
def test_distances_tell_the_contacts(branch):
    """No inadmissible orbit: the contacts that are counted are those of the extrema beyond a boundary."""
    for point in branch().points:
        for boundary, count in ((1, point.signature.drive), (-1, point.signature.back)):
            mine = sorted((e for e in point.extrema if e.boundary == boundary), key=lambda e: e.phase)
            inside = [boundary * e.distance > 0.0 for e in mine]
            entered = sum(now and not before for before, now in pairwise([inside[-1], *inside]))
            assert entered == count


@pytest.mark.parametrize("branch", ALL)
def test_stability_changes_at_special_points_only_and_by_the_right_number(branch):
    found = branch()
    assert not found.unexplained
    changes = {
        SpecialKind.FOLD: 1,
        SpecialKind.DOUBLING: 1,
        SpecialKind.TORUS: 2,
        SpecialKind.GRAZING: 0,
        SpecialKind.JOINS: 0,
    }
    for left, right in pairwise(found.points):
        between = [s for s in found.special if left.arclength < s.arclength < right.arclength]
        most = sum(changes[special.kind] for special in between)
        assert abs(right.unstable - left.unstable) in ({most, 0} if len(between) > 1 else {most})
        grazes = sum(special.kind is SpecialKind.GRAZING for special in between)
        assert (left.label != right.label) == (grazes % 2 == 1)


@pytest.mark.parametrize("branch", ALL)
def test_a_special_point_is_what_it_says(branch):
    """From what it keeps alone."""
    for special in branch().special:
        multipliers = special.point.multipliers
        if special.kind is SpecialKind.GRAZING:
            assert special.extremum is not None
            assert abs(special.extremum.distance) < 1e-12
        elif special.kind is SpecialKind.DOUBLING:
            assert np.abs(multipliers + 1.0).min() < 1e-9
        elif special.kind is SpecialKind.TORUS:
            assert np.abs(np.abs(multipliers) - 1.0).min() < 1e-9
        elif special.kind is SpecialKind.FOLD:
            assert np.abs(multipliers - 1.0).min() < 1e-5
        low, high = sorted(special.arclengths)
        assert low < special.arclength < high
        assert special.error < 1e-11 * abs(special.value)


@pytest.mark.parametrize("branch", [linear, six])
def test_a_special_point_restarts_its_branch(branch):
    found = branch()
    family = one_dof(error=0.05) if branch is linear else bundled()
    for special in found.special[:2]:
        values = {**found.values, found.name: special.value}
        again = orbit_at(built(family, **values), special.point.state, special.point.period, iterations=1)
        assert again is not None
        assert again.residual < 1e-11
        assert np.abs(again.state - special.point.state).max() < 1e-10


def test_the_same_branch_from_its_other_end():
    """And with other lengths of steps."""
    family, branch = one_dof(error=0.05), linear()
    first = branch.points[0]
    values = {"omega": first.value}
    start = orbit_at(built(family, **values), first.state, 1)
    assert start is not None
    again = continue_orbit(family, values, "omega", start, 0.5, 1.6, replace(PLAIN, longest=0.03))
    assert [special.kind for special in again.special] == [special.kind for special in branch.special]
    for one, other in zip(again.special, branch.special, strict=True):
        assert one.value == pytest.approx(other.value, rel=1e-12)
        assert np.abs(one.point.state - other.point.state).max() < 1e-6


def test_round_a_fold_the_orbit_is_another_one_at_the_same_value():
    branch = linear()
    high, low = branch.of_kind(SpecialKind.FOLD)
    middle = 0.5 * (high.value + low.value)
    places = branch.at(middle)
    assert len(places) == 3
    states = [left.state for left, _ in places]
    assert all(np.abs(one - two).max() > 1e-2 for one, two in pairwise(states))
    assert [left.unstable for left, _ in places] == [0, 1, 0]


def test_orbits_on_one_boundary_do_not_depend_on_the_gap():
    """X - D and all multipliers stay, so every special point does."""
    family = one_dof(error=0.05, D=3.0)
    start = orbit(family, omega=1.45)
    wide = continue_orbit(family, {"omega": 1.45}, "omega", start, 0.5, 1.6, PLAIN)
    narrow = linear()
    assert all(point.signature.back == 0 for point in narrow.points)
    assert [s.value for s in wide.special] == pytest.approx([s.value for s in narrow.special], rel=1e-11)
    for one, other in zip(wide.special, narrow.special, strict=True):
        assert one.point.state[0] - 3.0 == pytest.approx(other.point.state[0] - 1.0, abs=1e-7)


def test_load_error_and_gap_scale_together():
    family = one_dof(error=0.05 * 7.0, load=0.7, D=7.0)
    scaled = continue_orbit(family, {"omega": 1.45}, "omega", orbit(family, omega=1.45), 0.5, 1.6, PLAIN)
    assert [s.value for s in scaled.special] == pytest.approx([s.value for s in linear().special], rel=1e-11)


@pytest.mark.parametrize(("seed", "rule"), list(zip([1, 5, 19], ContactRule, strict=True)))
def test_a_finer_continuation_finds_no_more(seed, rule):
    branch, fine = random_pair(seed, rule), random_pair(seed, rule, fine=True)
    assert len(fine.points) > 2 * len(branch.points)
    assert [s.kind for s in branch.special] == [s.kind for s in fine.special]
    assert [s.value for s in branch.special] == pytest.approx([s.value for s in fine.special], rel=1e-10)
    assert not branch.unexplained


def test_a_stable_orbit_ends_in_the_fold():
    """By brute force: just beyond it, the motion from the last orbit goes elsewhere."""
    family, fold = one_dof(error=0.05), min(linear().of_kind(SpecialKind.FOLD), key=lambda s: s.value)
    for sign, stays in ((1.0, True), (-1.0, False)):
        value = fold.value * (1.0 + sign * 1e-4)
        props = built(family, omega=value)
        near = orbit_at(props, fold.point.state, 1)
        assert (near is not None and np.abs(near.state - fold.point.state).max() < 0.1) == stays


def test_the_multipliers_on_an_unstable_piece_by_an_independent_integrator(truth):
    branch = linear()
    unstable = next(point for point in branch.points if point.unstable)
    system = one_dof(error=0.05).system({"omega": unstable.value})
    found = truth(system).run(system, unstable.state, 1.0)
    assert np.abs(np.array(found.state, dtype=float) - unstable.state).max() < 1e-11
    expected = np.linalg.eigvals(np.array(found.jacobian, dtype=float))
    assert np.sort(expected.real) == pytest.approx(np.sort(unstable.multipliers.real), abs=1e-9)


def test_steps_may_be_cancelled_and_are_told():
    family = one_dof(error=0.05)
    told: list[float] = []
    found = continue_orbit(
        family, {"omega": 1.45}, "omega", orbit(family, omega=1.45), 0.5, 1.6, PLAIN, told.append,
        lambda: len(told) >= 4,
    )  # fmt: skip
    assert found.ends[1].kind is EndKind.CANCELLED
    assert told[:3] == [point.value for point in found.points if point.arclength > 0.0][:3]


def test_what_does_not_fit_is_refused():
    family = one_dof(error=0.05)
    start = orbit(family, omega=1.45)
    with pytest.raises(GearlashError, match="outside the interval"):
        continue_orbit(family, {"omega": 1.45}, "omega", start, 0.5, 1.2, PLAIN)
    with pytest.raises(GearlashError, match="lengths of steps"):
        ContinuationSettings(first=0.1, longest=0.01)


@pytest.mark.parametrize("which", [0, 1])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_branch_begun_at_a_fold_goes_towards_the_greater_end(which: int, side: float):
    """From orbits a little before the fold and behind it, at which values rise in opposite directions."""
    whole, family = linear(), one_dof(error=0.05)
    fold = whole.of_kind(SpecialKind.FOLD)[which]
    at = fold.point.arclength + side * 2e-5
    beside = sorted(whole.points, key=lambda point: abs(point.arclength - fold.point.arclength))[:2]
    left, right = sorted(beside, key=lambda point: point.arclength)
    along = (right.state - left.state) / (right.arclength - left.arclength)
    inward = np.sign(0.5 * (left.value + right.value) - fold.value)
    values = {"omega": fold.value + inward * 1e-10}
    start = orbit_at(built(family, **values), fold.point.state + (at - fold.point.arclength) * along, 1)
    assert start is not None
    again = continue_orbit(family, values, "omega", start, 0.5, 1.6, PLAIN)
    assert [end.value for end in again.ends] == [0.5, 1.6]
    assert values_of(again, SpecialKind.FOLD) == pytest.approx(values_of(whole, SpecialKind.FOLD), rel=1e-11)
