"""Branches that are hard to follow: no damping, closed loops, two gaps, twin touches, chaos near a touch."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from branches.followed import PLAIN, bundled, linear
from branches.parts import parts
from branches.shaken import shaken
from gearlash.branches.continuation import Branch, EndKind, SpecialKind, continue_orbit
from gearlash.orbits import orbit_at
from orbits.contacts import two_gaps
from orbits.members import built, one_dof, orbit


@cache
def undamped(ripple: float, lower: float, upper: float) -> Branch:
    family, values = one_dof(error=0.02, mesh_damping=0.0, ripple=ripple), {"omega": 1.4}
    start = orbit_at(built(family, **values), np.array([1.1, 0.0]), 1)
    assert start is not None
    return continue_orbit(family, values, "omega", start, lower, upper, PLAIN)


def test_without_damping_nothing_is_made_of_rounding():
    """All multipliers lie on the unit circle: no torus, and it is said what is not decided. The response is
    E ω²/(ω² - 1), which touches at ω² = 5/4, with the extremum exactly at phase zero."""
    branch = undamped(0.0, 1.1, 1.6)
    (touch,) = branch.special
    assert touch.value == pytest.approx(np.sqrt(1.25), rel=1e-12)
    assert [point.unstable for point in branch.points] == [0] * len(branch.points)
    (said,) = branch.unexplained
    assert "not decided" in said


def test_without_damping_a_parametric_resonance_is_bounded_by_its_doublings():
    branch = undamped(0.2, 1.2, 2.4)
    low, high = branch.special
    assert low.kind is high.kind is SpecialKind.DOUBLING
    assert low.value + high.value == pytest.approx(4.0, abs=0.01)
    inside = [point.unstable for point in branch.points if low.value < point.value < high.value]
    assert inside == [1] * len(inside)
    for point in branch.points:
        assert abs(np.prod(point.multipliers) - 1.0) < 1e-12


@pytest.mark.parametrize(("omega", "touches", "doublings"), [(0.576, 2, 0), (0.622, 0, 2)])
def test_what_lies_on_a_closed_loop_is_told_once(omega, touches, doublings):
    """6-7-0 and 9-9-0 of the article's pair: orbits on islands of their own."""
    start = orbit(bundled(), omega=omega)
    branch = continue_orbit(bundled(), {"omega": omega}, "omega", start, 0.5, 1.4, PLAIN)
    assert [end.kind for end in branch.ends] == [EndKind.CLOSED, EndKind.CLOSED]
    kinds = [special.kind for special in branch.special]
    assert kinds.count(SpecialKind.FOLD) == 2
    assert kinds.count(SpecialKind.GRAZING) == touches
    assert kinds.count(SpecialKind.DOUBLING) == doublings
    assert len({special.value for special in branch.special}) == len(branch.special)
    first, last = branch.points[0], branch.points[-1]
    assert last.value == pytest.approx(first.value, rel=1e-12)
    away = min(np.abs(strobe - first.state).max() for strobe in last.strobes)
    assert away < 1e-9


def test_two_gaps_touch_one_after_the_other():
    family = two_gaps()
    branch = continue_orbit(family, {}, "omega", orbit(family), 0.75, 1.1, PLAIN)
    assert [special.label_before for special in branch.special] == ["1-1-0/1-1", "1-2-0/1-1", "1-1-0/1-1"]
    assert [special.label_after for special in branch.special] == ["1-2-0/1-1", "1-1-0/1-1", "1-0-0/1-1"]
    assert not branch.unexplained


def test_a_symmetric_orbit_touches_both_sides_at_once():
    """Without load, an orbit that is its own image under X → -X half a period later: every touch is a pair at
    one value, and between breakings of the symmetry folds are folds."""
    family, values = one_dof(load=0.0, error=10.0, D=0.3, mesh_damping=0.02), {"omega": 0.3}
    start = orbit_at(built(family, **values), orbit(family, **values).state, 1)
    assert start is not None
    branch = continue_orbit(family, values, "omega", start, 0.25, 0.34, PLAIN)
    touches = branch.of_kind(SpecialKind.GRAZING)
    assert len(touches) == 4
    for one, other in zip(touches[::2], touches[1::2], strict=True):
        assert one.value == pytest.approx(other.value, rel=1e-12)
        assert one.extremum is not None
        assert other.extremum is not None
        assert one.extremum.boundary == -other.extremum.boundary
        assert {one.label_before, one.label_after} == {"1-1-1", "1-2-2"}
    assert not branch.unexplained


@pytest.mark.parametrize(("damping", "breaking"), [(0.05, 0.417700388163), (0.02, 0.428346205581)])
def test_a_step_over_the_breaking_of_a_symmetry_stays_on_its_branch(damping, breaking):
    """Where a wide step is cut beside a point at which two branches meet, the other one is near, too."""
    family, values = one_dof(load=0.0, error=3.0, mesh_damping=damping), {"omega": 0.6}
    branch = continue_orbit(family, values, "omega", orbit(family, **values), 0.3, 0.8, PLAIN)
    (met,) = branch.special
    assert met.kind is SpecialKind.BRANCH_POINT
    assert met.value == pytest.approx(breaking, abs=1e-11)
    assert met.error < 1e-12
    assert not branch.unexplained
    for point in branch.points:
        sides = {1: 0.0, -1: 0.0}
        for extremum in point.extrema:
            side = extremum.boundary
            sides[side] = max(sides[side], side * extremum.distance)
        assert sides[1] == pytest.approx(sides[-1], abs=1e-10)


def test_a_doubling_right_behind_a_touch():
    """A stiff stop with little damping: chaos begins 1e-4 behind the touch, the orbit itself goes on."""
    family, values = shaken(), {"omega": 0.79, "a": 0.7 / 1.26}
    branch = continue_orbit(family, values, "omega", orbit(family, **values), 0.75, 0.805, PLAIN)
    touch, doubling = branch.special
    assert touch.value == pytest.approx(0.80192811, abs=1e-8)
    assert doubling.kind is SpecialKind.DOUBLING
    assert 0.0 < doubling.value - touch.value < 2e-4
    assert branch.points[-1].unstable == 1


def test_a_branch_does_not_turn_round_where_its_states_do():
    """The contact begins just where periods are begun: within a step states turn by more than a right angle,
    the parameter goes on."""
    family, values = shaken(), {"omega": 0.5, "a": 0.7 / 1.26}
    branch = continue_orbit(family, values, "omega", orbit(family, **values), 0.5, 1.0, PLAIN)
    assert [end.kind for end in branch.ends] == [EndKind.LOWER, EndKind.UPPER]
    kinds = [special.kind for special in branch.special]
    assert kinds == [SpecialKind.GRAZING, SpecialKind.DOUBLING, SpecialKind.DOUBLING]
    assert not branch.unexplained


def test_a_branch_restarts_at_its_own_ends():
    family = one_dof(error=0.05)
    lower, upper = 0.1 + 1.0 / 3.0, np.pi / 2.0
    branch = continue_orbit(family, {"omega": 1.45}, "omega", orbit(family, omega=1.45), lower, upper, PLAIN)
    for point, limit in zip((branch.points[0], branch.points[-1]), (lower, upper), strict=True):
        assert point.value == limit
    assert all(left.arclength < right.arclength for left, right in pairwise(branch.points))


def test_three_extrema_touch_within_a_millionth():
    """One after the other, each for itself, in the order of their heights."""
    family = parts(3)
    branch = continue_orbit(family, {}, "gap", orbit(family), 0.9, 1.2, PLAIN)
    touches = sorted(branch.special, key=lambda special: -special.value)
    assert [special.kind for special in touches] == [SpecialKind.GRAZING] * 3
    labels = [branch.special[0].label_before, *(special.label_after for special in branch.special)]
    assert sorted(label.drive for label in labels) == [0, 1, 2, 3]
    assert len({touch.extremum.number for touch in touches if touch.extremum is not None}) == 3
    values = [touch.value for touch in touches]
    assert 1e-9 < values[0] - values[2] < 1e-6
    t = np.linspace(0.0, 6.0 * np.pi / 1.4, 200_001)
    response = [(1.0 / complex(1.0 - w * w, 0.2 * w), w, size) for w, size in ((1.4, 1.0), (1.4 / 3, 1e-7))]
    x = sum(size * (z * np.exp(1j * w * t)).real for z, w, size in response)
    assert values[0] == pytest.approx(float(np.max(x)), abs=2e-9)
    assert not branch.unexplained


@pytest.mark.parametrize("height", [1e-9, -1e-9])
def test_a_touch_of_the_back_side_within_rounding_of_a_fold(height):
    """The impacting branch does not depend on the gap as long as it meets one side: so a gap is chosen in
    which its fold passes the back side at a given height. Each is told once; only which comes first depends
    on the height."""
    fold = min(linear().of_kind(SpecialKind.FOLD), key=lambda special: special.value)
    nearest = min(each.distance for each in fold.point.extrema if each.boundary < 0)
    family = one_dof(error=0.05)
    values = {"omega": 1.45, "D": 1.0 + 0.5 * (height - nearest)}
    branch = continue_orbit(family, values, "omega", orbit(family, **values), 0.6, 1.6, PLAIN)
    there = [special for special in branch.special if abs(special.value - fold.value) < 1e-6]
    assert sorted(special.kind for special in there) == sorted([SpecialKind.FOLD, SpecialKind.GRAZING])
    assert len(branch.of_kind(SpecialKind.FOLD)) == 2
    for special in there:
        assert special.value == pytest.approx(fold.value, rel=1e-6)
    counts = [there[0].unstable_before, there[-1].unstable_after]
    assert sorted(counts) == [0, 1]
    assert not branch.unexplained
