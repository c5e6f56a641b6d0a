"""Touches from the gap under `no-tension`, where the stroboscopic map has a corner."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from branches.followed import PLAIN
from gearlash.branches.continuation import (
    Branch,
    EndKind,
    SpecialKind,
    SpecialPoint,
    continue_orbit,
    switched,
)
from gearlash.branches.continuation.between import zero
from gearlash.orbits import orbit_at
from gearlash.system import ContactRule, Family
from oracles.random_branches import draw, followed
from orbits.contacts import one_dof_under
from orbits.members import built, orbit


@cache
def drawn(seed: int) -> tuple[Family, dict[str, float]]:
    """A strongly damped pair that meets both sides."""
    rng = np.random.default_rng(seed)
    values = {"load": rng.uniform(0.02, 0.1), "mesh_damping": rng.uniform(0.1, 0.9)}
    values |= {"error": rng.uniform(0.1, 0.6), "ripple": rng.uniform(0.0, 0.3), "D": rng.uniform(0.1, 0.5)}
    return one_dof_under(ContactRule.NO_TENSION, **values), {"omega": float(rng.uniform(0.5, 1.4))}


@pytest.mark.parametrize(("seed", "lower", "turns"), [(4, 0.43, True), (5, 0.53, False), (10, 0.43, True)])
def test_a_corner_is_passed_or_turns_the_branch_back(seed, lower, turns):
    """Where the branch turns back two orbits lie above the touch, one with the contact and one without, that
    do not exist below; else one on each side."""
    family, values = drawn(seed)
    branch = continue_orbit(family, values, "omega", orbit(family, **values), lower, 1.45, PLAIN)
    (touch,) = (special for special in corners(branch) if special.label_before != special.label_after)
    assert ("turns back" in touch.note) == turns
    assert touch.extremum is not None
    assert abs(touch.extremum.distance) < 1e-10
    assert not branch.unexplained
    away = 1e-5
    below, above = branch.at(touch.value - away), branch.at(touch.value + away)
    assert len(above) - len(below) == (2 if turns else 0)


def corners(branch: Branch) -> list[SpecialPoint]:
    return [special for special in branch.of_kind(SpecialKind.GRAZING) if "corner" in special.note]


@cache
def wide(seed: int) -> Branch:
    family, values = drawn(seed)
    return continue_orbit(family, values, "omega", orbit(family, **values), 0.4, 1.45, PLAIN)


@pytest.mark.parametrize("seed", [6, 8])
def test_no_corner_is_too_sharp(seed):
    """All of these touch with two extrema half an orbit apart, or turn back in a corner, or come back to a
    boundary that they have not left."""
    branch = wide(seed)
    assert EndKind.SHORT not in [end.kind for end in branch.ends]
    assert not branch.unexplained
    for touch in corners(branch):
        assert touch.extremum is not None
        assert abs(touch.extremum.distance) < 1e-10
        assert touch.error < 1e-10


def test_a_return_to_contact_through_the_gap_is_a_corner_too():
    """The sides are apart already, so that no impact comes or goes."""
    back = [touch for touch in corners(wide(8)) if touch.label_before == touch.label_after]
    assert len(back) == 2
    family, values = drawn(8)
    for touch in back:
        assert "return to contact on the drive side" in touch.note
        for move in (-1e-6, 1e-6):
            props = built(family, **{**values, "omega": touch.value + move})
            beside = orbit_at(props, touch.point.state, touch.point.period)
            assert beside is not None
            assert beside.label == touch.label_before


def test_where_two_extrema_touch_at_once_the_orbit_has_half_the_period():
    """The 2-2-1 ends in a 1-1-0 that touches; on both sides of that there is a single orbit, with the contact
    and without it. From the branch of those the 2-2-1 is found again."""
    family, values = drawn(9)
    (touch,) = corners(wide(9))
    assert "half its period" in touch.note
    assert wide(9).ends[0].kind is EndKind.CORNER
    singles = switched(family, wide(9), touch)
    assert sorted(single.orbit.label for single in singles) == ["1-1-0", "1-1-1"]
    single = next(single for single in singles if single.orbit.stable)
    at = {**values, "omega": single.value}
    branch = continue_orbit(family, at, "omega", single.orbit, 0.831, 0.9, PLAIN)
    (born,) = corners(branch)
    assert born.value == pytest.approx(touch.value, abs=1e-11)
    assert "twice the period" in born.note
    (doubled,) = switched(family, branch, born)
    assert doubled.orbit.label == "2-2-1"
    assert doubled.value > born.value
    assert doubled.orbit.stable


def test_a_second_touch_of_the_same_extremum_is_a_corner_of_its_own():
    """The extremum touches, moves away, and comes back where the orbit meets that of half its period: there
    the branch ends, and does not run back along itself, begun a base period later."""
    drawn_ = draw(58)
    branch = followed(drawn_)
    assert branch is not None
    end, passed = corners(branch)
    assert end.extremum is not None
    assert passed.extremum is not None
    assert end.extremum.number == passed.extremum.number
    assert [each.kind for each in branch.ends] == [EndKind.CORNER, EndKind.UPPER]
    assert "half its period" in end.note
    apart = end.point.strobes - np.roll(end.point.strobes, 1, axis=0)
    assert np.abs(apart).max() < 1e-8
    (single,) = {found.orbit.shot.period for found in switched(drawn_.family, branch, end)}
    assert single == 1


@pytest.mark.parametrize("jump", [0.3, 1e-6, 0.999])
def test_a_function_that_jumps_over_zero_has_its_zero_there(jump: float):
    """Not at the end at which it is smaller."""
    found = zero(lambda place: -5.0 if place < jump else 1.0, (0.0, -5.0), (1.0, 1.0))
    assert found is not None
    assert found[0] == pytest.approx(jump, abs=1e-12)
