"""Branches of pairs drawn at random against shooting on another integrator, and what holds on any branch."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest

pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")

import gearlash as gl
from gearlash.branches.continuation import Branch, ContinuationSettings, SpecialKind
from oracles.random_branches import draw, followed
from oracles.special_points import again, point_again

SEEDS = {
    2: {SpecialKind.GRAZING, SpecialKind.DOUBLING, SpecialKind.FOLD},
    3: {SpecialKind.GRAZING, SpecialKind.DOUBLING},
    4: {SpecialKind.GRAZING, SpecialKind.FOLD},
    12: {SpecialKind.GRAZING, SpecialKind.DOUBLING},
    21: {SpecialKind.JOINS, SpecialKind.FOLD, SpecialKind.DOUBLING, SpecialKind.GRAZING},
    45: {SpecialKind.EXISTENCE, SpecialKind.DOUBLING},
    54: {SpecialKind.JOINS, SpecialKind.FOLD, SpecialKind.GRAZING},
    58: {SpecialKind.GRAZING},
}
"""Seeds whose branches have special points, and of which kinds; those with corners are 4, 12, 54, 58."""

CHANGES = {SpecialKind.FOLD: 1, SpecialKind.DOUBLING: 1}


@cache
def branch_of(seed: int) -> Branch:
    branch = followed(draw(seed))
    assert branch is not None
    return branch


@pytest.mark.parametrize("seed", SEEDS)
def test_special_points_are_those_of_the_oracle(seed):
    drawn, branch = draw(seed), branch_of(seed)
    assert {special.kind for special in branch.special} == SEEDS[seed]
    for special in branch.special:
        theirs = again(drawn.family, branch, special)
        assert theirs.found.defect < 1e-12  # near a touch a last digit of the parameter makes 1e-13
        assert theirs.value_apart < max(1e-12, special.error / (branch.upper - branch.lower))
        if special.kind is not SpecialKind.EXISTENCE:  # there the orbit is infinite
            assert theirs.state_apart < 1e-11


@pytest.mark.parametrize("seed", SEEDS)
def test_orbits_between_them_are_those_of_the_oracle(seed):
    drawn, branch = draw(seed), branch_of(seed)
    for index in np.linspace(2, len(branch.points) - 3, 3).astype(int):
        checked = point_again(drawn.family, branch, int(index))
        assert checked.contacts == ""
        assert checked.state_apart < 1e-10
        assert checked.multipliers_apart < 1e-7


@pytest.mark.parametrize("seed", SEEDS)
def test_stability_and_contacts_change_at_special_points_only(seed):
    branch = branch_of(seed)
    assert not branch.unexplained
    for left, right in pairwise(branch.points):
        between = [s for s in branch.special if left.arclength < s.arclength < right.arclength]
        most = sum(CHANGES.get(special.kind, 0) for special in between)
        if not any("corner" in special.note for special in between):
            assert abs(right.unstable - left.unstable) in {most, most % 2}
        if left.label != right.label:
            assert SpecialKind.GRAZING in {special.kind for special in between}


@pytest.mark.parametrize("seed", [12, 13])
def test_arclength_is_that_of_the_steps_wherever_their_periods_are_begun(seed):
    """Where the damping jumps, periods are begun away from contacts, at a phase that changes on the way."""
    arclengths = np.array([point.arclength for point in branch_of(seed).points])
    assert np.diff(arclengths).max() < 1.1 * ContinuationSettings().longest


@pytest.mark.parametrize("seed", [0, 31])
def test_the_ends_lie_on_the_limits_so_that_a_branch_goes_on_from_them(seed):
    drawn, branch = draw(seed), branch_of(seed)
    assert [branch.points[0].value, branch.points[-1].value] == [drawn.lower, drawn.upper]
    limits = {"lower": drawn.lower, "upper": drawn.upper, "values": branch.values}
    again = gl.continue_branch(drawn.family, drawn.name, branch.points[0], **limits)
    assert [s.value for s in again.special] == pytest.approx([s.value for s in branch.special], rel=1e-11)
