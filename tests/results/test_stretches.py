"""Where orbits of a branch are stable, and where several stable ones lie at one value."""

from __future__ import annotations

from functools import cache

import gearlash as gl
from gearlash.results.between_points import Here, Passing, between
from gearlash.results.stretches import Stretch, beside_each_other, stretches


@cache
def branch() -> gl.Branch:
    case = gl.load_case("kahraman-singh")
    return gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})


def test_stretches_end_at_special_points_and_hold_every_orbit():
    found = stretches(branch())
    special = {each.value for each in branch().special}
    ends = {end for each in found for end in (each.low, each.high)}
    assert ends == special | {0.7, 1.6}
    assert [(str(each.label), each.stable, each.rising) for each in found] == [
        ("1-0-0", True, True),
        ("1-1-0", True, True),
        ("1-1-0", False, False),
        ("1-1-0", True, True),
        ("1-0-0", True, True),
    ]
    for point in branch().points:
        mine = [each for each in found if each.low <= point.value <= each.high]
        assert any((each.label, each.stable) == (point.label, point.stable) for each in mine)


def test_stable_orbits_beside_each_other_are_there_at_every_value():
    for each in beside_each_other(stretches(branch()), 0.9):
        middle = 0.5 * (each.low + each.high)
        stable = [str(left.label) for left, _ in branch().at(middle) if left.stable]
        assert sorted(stable) == sorted(map(str, each.labels))


def test_stretches_that_only_meet_do_not_overlap():
    one, two = gl.Signature(1, 0), gl.Signature(2, 1)
    rows = [Stretch(0.0, 0.5 + 1e-13, one, True, True), Stretch(0.5, 1.0, two, True, True)]
    assert beside_each_other(rows, 1.0) == ()
    rows.append(Stretch(0.2, 0.6, two, False, True))
    assert beside_each_other(rows, 1.0) == (), "unstable ones do not count"
    (found,) = beside_each_other([*rows, Stretch(0.7, 2.0, one, True, False)], 2.0)
    assert (found.low, found.high, found.labels) == (0.7, 1.0, (two, one))


def test_between_two_special_points_without_an_orbit_what_they_change_tells():
    """A fold and a grazing and a fold, all found between the same two orbits."""
    one, two = Here("1-0-1", 1), Here("1-0-2", 1)
    nodes = [
        one,
        Passing("fold", one, Here("1-0-1", 0)),
        Passing("grazing", one, two),
        Passing("fold", Here("1-0-1", 0), two),
        two,
    ]
    assert between(nodes) == [one, Here("1-0-1", 0), Here("1-0-2", 0), two]
    assert between(nodes[1:]) == between(nodes)[1:]
