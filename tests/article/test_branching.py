"""A scan as branches: what its sweeps located are special points, and its attractors lie on the branches."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from gearlash.article.branching import Followed, Following, follow_all, switch
from gearlash.article.reproduction import Scan, Stretch
from gearlash.article.rows import Row, distinct, rows
from gearlash.article.stretches import special_points, stretches, together
from gearlash.branches.continuation import Branch, SpecialKind
from gearlash.case import load
from gearlash.jobs import Inline
from gearlash.results import Axis, Point
from gearlash.studies import point

AT = {"omega": 0.78}
CASE = load("article")


@cache
def swept() -> tuple[Row, ...]:
    return rows(CASE, Axis.even("D", 0.40, 0.50, 11), AT, Inline())


@cache
def scan() -> Scan:
    return Following.begun(CASE, "D", AT, swept(), Inline()).scan(distinct(swept()), Inline())


def attractor(value: float) -> Point:
    return point(CASE, {**AT, "D": value}, name="D")


@cache
def island() -> Branch:
    """A closed loop of 3-3-2 between two folds."""
    (branch,) = follow_all(CASE.to_json(), "D", AT, (0.14, 0.19), (attractor(0.165),)).branches
    return branch


def test_every_change_along_the_sweeps_is_a_special_point():
    events = scan().events
    assert {(e.kind, str(e.before), str(e.after)) for e in events} == {
        ("fold", "6-6-2", "3-3-1"),
        ("grazing", "3-3-1", "3-3-0"),
        ("doubling", "6-6-2", "3-3-1"),
        ("fold", "3-3-1", "3-3-0"),
    }
    for event in events:
        assert event.special is not None
        assert event.special in scan().branches[event.branch].special
        assert event.apart <= 1e-9 * event.value
        assert event.special.kind == event.kind


def test_every_periodic_attractor_lies_on_a_branch():
    found = [p for row in swept() for p in row.sweep.points if p.periodic]
    assert scan().attractors == scan().on_branches == len(found) == 33
    assert scan().left == ()


def test_an_attractor_of_another_branch_is_not_taken_for_one():
    """3-3-1 and 3-3-0 at one value of D lie on one branch, on either side of two folds."""
    limits, near = (0.40, 0.50), [attractor(0.47)]
    astray = replace(near[0], state=near[0].state + 0.05)
    followed = follow_all(CASE.to_json(), "D", AT, limits, (near[0], astray))
    assert followed.on_branches == 1
    assert len(followed.left) == 1


def test_a_change_that_is_no_special_point_has_none():
    (change, directions), *_ = distinct(swept())
    assert change.point is not None
    moved = replace(change, point=replace(change.point, value=change.value + 1e-6))
    following = Following.begun(CASE, "D", AT, swept(), Inline())
    (event,) = following.scan([(moved, directions)], Inline()).events
    assert (event.special, event.branch) == (None, -1)
    assert event.apart != event.apart


def test_stretches_end_where_stability_or_contacts_change():
    by_label = {(str(s.label), round(s.lower, 6), round(s.upper, 6)) for s in scan().stretches}
    assert by_label == {
        ("6-6-2", 0.4, 0.452159),
        ("3-3-1", 0.415063, 0.415487),
        ("3-3-0", 0.415487, 0.5),
        ("3-3-1", 0.452159, 0.485411),
    }
    ends = [(str(s.lower_end.kind), str(s.upper_end.kind)) for s in scan().stretches]
    assert ends == [
        ("lower limit of the parameter", "joins the orbit of half its period"),
        ("fold", "grazing"),
        ("grazing", "upper limit of the parameter"),
        ("doubling", "fold"),
    ]
    for stretch in scan().stretches:
        assert (stretch.lower, stretch.upper) == (stretch.lower_end.value, stretch.upper_end.value)
        inside = [p for p in scan().branches[stretch.branch].points if p.label == stretch.label and p.stable]
        assert any(stretch.lower < p.value < stretch.upper for p in inside)


def test_what_is_stable_side_by_side():
    labels = [[str(scan().stretches[i].label) for i in each.stretches] for each in scan().together]
    assert labels == [["6-6-2", "3-3-1"], ["6-6-2", "3-3-0"], ["3-3-0", "3-3-1"]]
    bounds = [round(v, 6) for each in scan().together for v in (each.lower, each.upper)]
    assert bounds == [0.415063, 0.415487, 0.415487, 0.452159, 0.452159, 0.485411]


def test_a_closed_loop_is_counted_once_round():
    assert island().ends[0].kind.name == "CLOSED"
    kinds = [special.kind for special in special_points(island())]
    assert kinds.count(SpecialKind.FOLD) == 2
    (stretch,) = stretches([island()])
    assert str(stretch.label) == "3-3-2"
    assert (round(stretch.lower, 6), round(stretch.upper, 6)) == (0.144104, 0.186753)


def test_a_branch_is_begun_in_the_middle_of_what_was_seen():
    """At D = 0.145, beside its fold, 3-3-2 is hard to tell from three times a motion of period one."""
    seen = tuple(attractor(value) for value in (0.145, 0.165, 0.18))
    followed = follow_all(CASE.to_json(), "D", AT, (0.14, 0.19), seen)
    assert [branch.values["D"] for branch in followed.branches] == [0.165]
    assert followed.on_branches == 3


@pytest.mark.parametrize("spans", [[(0.0, 1.0)], [(0.0, 1.0), (1.0, 2.0)], []])
def test_nothing_is_side_by_side_where_one_ends_as_the_next_begins(spans: list[tuple[float, float]]):
    whole = scan().stretches[0]
    made: list[Stretch] = [replace(whole, lower=low, upper=high) for low, high in spans]
    assert together(made) == ()


def test_the_branch_born_at_a_doubling_is_switched_to():
    (three,) = (b for b in scan().branches if b.points[0].period == 3)
    (doubling,) = three.of_kind("doubling")
    found = switch(CASE.to_json(), three, doubling)
    assert isinstance(found, Followed)
    (six,) = found.branches
    assert six.points[0].period == 6
    assert abs(six.of_kind(SpecialKind.JOINS)[0].value - doubling.value) <= 1e-9
    assert scan().switched == ()  # the sweep's 6-6-2 lies on it
