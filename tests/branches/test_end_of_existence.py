"""Where a branch runs to infinity, against closed forms."""

from __future__ import annotations

import numpy as np
import pytest

from branches.followed import PLAIN
from branches.softening import coupled, softening
from gearlash.branches.continuation import Branch, EndKind, SpecialKind, continue_orbit, switched
from gearlash.branches.continuation.equations import Line
from gearlash.branches.continuation.infinity import at_infinity
from gearlash.orbits import orbit_at
from gearlash.system import ContactRule
from orbits.members import built, one_dof, orbit


def tilted(tilt: float, lower: float, upper: float, **start: float) -> Branch:
    values = {"tilt": tilt, **start}
    return continue_orbit(coupled(), values, "mu", orbit(coupled(), **values), lower, upper, PLAIN)


@pytest.mark.parametrize(("rule", "side"), [(ContactRule.ALWAYS, 1), (ContactRule.NO_TENSION, -1)])
def test_a_motion_in_contact_runs_to_infinity_where_its_multiplier_is_one(rule, side):
    """Its mean is (load + D)/(1 - κ), on either side of the gap."""
    family = softening(rule, side)
    branch = continue_orbit(family, {}, "kappa", orbit(family), 0.7, 1.2, PLAIN)
    (end,) = branch.special
    assert end.kind is SpecialKind.EXISTENCE
    assert abs(end.value - 1.0) < 1e-13
    assert end.error < 1e-13
    assert end.interval == (branch.points[-1].value, end.value)
    assert branch.ends[1].kind is EndKind.FAR
    assert "not orthogonal" in end.note
    means = [abs(point.state[0]) * (1.0 - point.value) for point in branch.points[::10]]
    assert means == pytest.approx([1.3] * len(means), rel=0.2)
    assert not branch.unexplained


def test_from_its_last_orbit_alone_the_end_is_found_again():
    family = softening()
    branch = continue_orbit(family, {}, "kappa", orbit(family), 0.7, 1.2, PLAIN)
    (end,) = branch.special
    again = orbit_at(built(family, kappa=end.point.value), end.point.state, 1)
    assert again is not None
    found = at_infinity(Line(family, family.complete({}), "kappa", 0.7, 1.2), again, end.point.value)
    assert found is not None
    assert found.value == pytest.approx(end.value, abs=1e-14)
    assert not found.orthogonal


@pytest.mark.parametrize("gap", [0.1, 1e4])
def test_the_end_does_not_depend_on_the_gap(gap):
    family = softening()
    values = {"D": gap, "load": 0.3 * gap, "error": 0.4 * gap}
    start = orbit_at(built(family, **values), np.array([1.3 * gap / 0.2, 0.0]), 1)
    assert start is not None
    branch = continue_orbit(family, values, "kappa", start, 0.7, 1.2, PLAIN)
    assert [special.kind for special in branch.special] == [SpecialKind.EXISTENCE]
    assert branch.special[0].value == pytest.approx(1.0, abs=1e-13)


def test_unless_the_forcing_is_orthogonal_to_the_adjoint_null_vector():
    """Then the branch goes on, orbits of every size exist at the one value, and where they touch another
    branch begins: on one side, as on the other they lie the deeper in contact the larger they are."""
    branch = tilted(0.0, -0.8, 0.2)
    (point,) = branch.special
    assert point.kind is SpecialKind.BRANCH_POINT
    assert point.linear
    assert abs(point.value + 0.1) < 1e-12
    assert "the forcing is orthogonal" in point.note
    (other,) = switched(coupled(), branch, point)
    assert abs(other.value + 0.1) < 1e-3
    assert other.orbit.label == "1-1-0"


@pytest.mark.parametrize(("tilt", "touches"), [(0.01, 0), (-0.01, 4)])
def test_near_an_orthogonal_forcing_the_branch_runs_away_on_either_side(tilt, touches):
    """Deeper into contact with no touch, or through the whole gap and far beyond its back side: there the
    motion is in contact again, and its multiplier is 1 at the same value."""
    branch = tilted(tilt, -0.8, 0.2)
    assert len(branch.of_kind(SpecialKind.GRAZING)) == touches
    (end,) = branch.of_kind(SpecialKind.EXISTENCE)
    assert abs(end.value + 0.1) < 1e-13
    assert branch.points[-1].label == "1-0-0"
    assert np.sign(branch.points[-1].state[2]) == np.sign(tilt)
    assert not branch.unexplained


def test_from_beyond_the_value_it_runs_to_the_other_side():
    """For tilt > 0 and μ above the value the motion would lie behind the back side."""
    family, values = coupled(), {"tilt": 0.05, "mu": 0.0}
    left = orbit_at(built(family, **values), np.array([-1.5, 0.0, -3.0]), 1)
    assert left is not None
    branch = continue_orbit(family, values, "mu", left, -0.5, 0.3, PLAIN)
    ends = branch.of_kind(SpecialKind.EXISTENCE)
    assert [abs(end.value + 0.1) < 1e-13 for end in ends] == [True] * len(ends)
    assert EndKind.FAR in [end.kind for end in branch.ends]


def test_linear_resonance_is_no_end_where_the_motion_touches_before():
    """With a strong ripple the multiplier of the motion in contact is 1 at ω near 1.02, but the teeth part
    before: the branch that is followed has no such point."""
    family = one_dof(error=0.05, ripple=0.95)
    branch = continue_orbit(family, {"omega": 1.2}, "omega", orbit(family, omega=1.2), 1.0, 1.3, PLAIN)
    assert [special.kind for special in branch.special] == [SpecialKind.GRAZING]
    assert branch.special[0].value > 1.05
    assert [end.kind for end in branch.ends] == [EndKind.LOWER, EndKind.UPPER]
