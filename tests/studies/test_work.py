"""Limited work: what matters most is followed first, what is left out is counted, and enough of it changes
nothing."""

from __future__ import annotations

from itertools import pairwise

import pytest

import gearlash as gl
from gearlash.results import Axis
from gearlash.studies.work import Changes, Work
from gearlash.studies.zone_end import Quiet
from gearlash.studies.zones import zones_of_kinds

AXIS = Axis.even("omega", 0.5, 0.9, 9)


def found(work: int | None):
    case = gl.load_case("kahraman-singh")
    ways = gl.sweeps(case, AXIS, ("up", "down"))
    return zones_of_kinds(case, AXIS, [Quiet.IMPACT_FREE], known=ways, work=work)[0], ways


def ends(zones: gl.Zones):
    return [(zone.lower.value, zone.upper.value, zone.upper.kind) for zone in zones.zones]


@pytest.fixture(scope="module")
def unlimited():
    return found(None)[0]


def test_enough_work_changes_nothing(unlimited):
    enough = found(1_000_000)[0]
    assert unlimited.left_out == enough.left_out == 0
    assert ends(enough) == ends(unlimited)


def test_where_a_branch_was_cut_short_nothing_is_told(unlimited):
    little = found(550)[0]
    assert little.left_out > 0
    for low, high, kind in ends(little):
        assert kind != "fold" or (low, high, kind) in ends(unlimited)


def test_what_was_cut_is_not_followed_twice(monkeypatch: pytest.MonkeyPatch):
    """Beyond the end of a branch that was cut short another one goes on, and stops where they meet: with
    the zone that one branch makes. Here each may have eleven orbits a way."""
    monkeypatch.setattr("gearlash.studies.work.FEWEST", 5)
    monkeypatch.setattr("gearlash.studies.work.BRANCH", 28)
    case, axis = gl.load_case("kahraman-singh"), Axis.even("omega", 0.1, 0.7, 13)
    ways = gl.sweeps(case, axis, ("up",))
    whole, cut = (
        zones_of_kinds(case, axis, [Quiet.IMPACT_FREE], known=ways, work=work)[0] for work in (None, 3_000)
    )
    assert len(whole.branches) < len(cut.branches)
    assert cut.left_out == 0
    assert [(z.lower.value, z.upper.value) for z in cut.zones] == [
        (z.lower.value, z.upper.value) for z in whole.zones
    ]
    quiet = [branch for branch in cut.branches if str(branch.points[0].signature) == "1-0-0"]
    reaches = sorted((min(branch.parameter), max(branch.parameter)) for branch in quiet)
    assert all(one[1] == pytest.approx(next_[0], rel=1e-12) for one, next_ in pairwise(reaches))


def test_without_work_all_that_was_seen_is_left_out():
    none, ways = found(0)
    periodic = sum(point.periodic for way in ways for point in way.points)
    assert (none.left_out, none.branches, none.zones) == (periodic, (), ())


def test_changes_are_the_cells_beside_them():
    ways = gl.sweeps(gl.load_case("kahraman-singh"), AXIS, ("up",))
    rows = [point.impact_free for point in ways[0].points]
    last = max(i for i, quiet in enumerate(rows) if quiet)
    changes = Changes.of(ways, AXIS)
    assert changes.hold(float(AXIS.values[last]))
    assert not changes.hold(float(AXIS.values[0]))
    quiet, hitting = ways[0].points[0], ways[0].points[-1]
    assert Changes(()).order(quiet) < Changes(()).order(hitting)


def test_short_motions_are_afforded_where_long_ones_are_not():
    work = Work(2_000)
    assert work.afforded([64, 1, 2], int) == [1, 2]
    work.looked(25)
    assert work.left == 0
    assert work.afforded([1], int) == []
    assert Work().afforded([64, 1], int) == [64, 1]
