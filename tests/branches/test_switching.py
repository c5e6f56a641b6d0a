"""From one branch to another."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from branches.followed import PLAIN, bundled, parametric, six
from gearlash.branches.continuation import (
    Branch,
    EndKind,
    SpecialKind,
    SpecialPoint,
    continue_orbit,
    switched,
)
from gearlash.orbits import orbit_at
from gearlash.system import Family, GearlashError
from orbits.members import built, one_dof, orbit


def followed(family: Family, branch: Branch, special: SpecialPoint, lower: float, upper: float) -> Branch:
    (start,) = switched(family, branch, special)
    values = {**branch.values, branch.name: start.value}
    return continue_orbit(family, values, branch.name, start.orbit, lower, upper, PLAIN)


def test_six_to_twelve():
    """The doubled orbit comes back to the doubling it was born in, and touches the back side just before:
    the article's 12-12-3 loses an impact within 1e-5 of the doubling of its 6-6-1."""
    doubling = six().special[0]
    twelve = followed(bundled(), six(), doubling, 0.345, 0.36)
    touch, join = twelve.special
    assert join.kind is SpecialKind.JOINS
    assert join.value == pytest.approx(doubling.value, rel=1e-11)
    assert (touch.label_before, touch.label_after) == ("12-12-3", "12-12-2")
    assert 0.0 < doubling.value - touch.value < 2e-5
    assert twelve.points[0].period == 12


@cache
def three() -> Branch:
    return followed(bundled(), six(), six().special[-1], 0.4, 0.5)


def test_six_to_three():
    """The orbit that the 6-6-2 joins doubles there; its two folds bound what coexists: 3-3-1 up to 0.4854,
    3-3-0 from 0.4155."""
    join = six().special[-1]
    doubling, high, low, touch = three().special
    assert doubling.kind is SpecialKind.DOUBLING
    assert doubling.value == pytest.approx(join.value, rel=1e-12)
    assert (high.kind, low.kind, touch.kind) == (SpecialKind.FOLD, SpecialKind.FOLD, SpecialKind.GRAZING)
    assert high.value == pytest.approx(0.4854, abs=5e-5)
    assert touch.value == pytest.approx(0.4155, abs=5e-5)
    assert (touch.label_before, touch.label_after) == ("3-3-1", "3-3-0")


def test_two_orbits_coexist_between_the_ends():
    """By marching from both: each is stable and stays."""
    pair = [left for left, _ in three().at(0.47) if left.stable]
    assert sorted(point.label for point in pair) == ["3-3-0", "3-3-1"]
    props = built(bundled(), omega=0.78, D=0.47)
    for point in pair:
        here = orbit_at(props, point.state, 3)
        assert here is not None
        assert here.stable
        assert here.label == point.label


def test_a_doubling_of_a_linear_motion_begins_where_it_touches():
    """Below that amplitude every one exists at the one value: the branch begins there, at the same value."""
    family, branch = one_dof(error=0.0005, ripple=0.3), parametric()
    doubling = branch.of_kind(SpecialKind.DOUBLING)[0]
    other = followed(family, branch, doubling, 1.7, 2.0)
    assert [end.kind for end in other.ends].count(EndKind.LINEAR) == 1
    (touch,) = other.of_kind(SpecialKind.GRAZING)
    assert touch.value == pytest.approx(doubling.value, rel=1e-11)
    assert {touch.label_before, touch.label_after} == {"2-0-0", "2-1-0"}
    assert np.abs(touch.point.multipliers - 1.0).min() < 1e-6


def test_no_branch_begins_at_a_touch_that_is_smooth():
    with pytest.raises(GearlashError, match="no other branch"):
        switched(bundled(), six(), six().special[1])


def test_a_symmetric_orbit_breaks_into_a_mirrored_pair():
    """Without load, X → -X half a period later leaves the system as it is: both orbits of the pair are each
    other's image, and each comes back to the symmetric one where it was born."""
    family, values = one_dof(load=0.0, error=1.0, D=0.2, mesh_damping=0.02), {"omega": 1.15}
    branch = continue_orbit(family, values, "omega", orbit(family, **values), 0.44, 1.2, PLAIN)
    (point,) = branch.special
    assert point.kind is SpecialKind.BRANCH_POINT
    pair = switched(family, branch, point)
    assert len(pair) == 2
    born = []
    for one in pair:
        other = {**values, "omega": one.value}
        broken = continue_orbit(family, other, "omega", one.orbit, 0.46, 0.6, PLAIN)
        (join,) = broken.of_kind(SpecialKind.SYMMETRIC)
        assert abs(join.value - point.value) <= join.error + point.error
        born.append(broken)
    props, away = built(family, omega=0.465), []
    for left, _ in born[0].at(0.465):
        found = orbit_at(props, left.state, 1)
        assert found is not None
        half = found.trace.at([0.5]).state[0]
        image = orbit_at(props, -half, 1)
        assert image is not None
        assert np.abs(image.state + half).max() < 1e-9
        away.append(np.abs(half + found.state).max())
    assert max(away) > 1e-2  # it is not symmetric itself
