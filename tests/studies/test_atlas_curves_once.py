"""Curves of an atlas that are one, or one in part, are drawn once."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import gearlash as gl
from gearlash.studies.atlas.drawn import Drawn

LOWER, UPPER = (0.6, 0.13), (0.8, 1.1)
STEPS = gl.ContinuationSettings(longest=0.05, first=0.01, certify=False)


@cache
def curve() -> gl.Curve:
    case = gl.load_case("kahraman-singh")
    branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5}, steps=STEPS)
    fold = branch.of_kind("fold")[-1]
    return gl.continue_curve(case, ("omega", "D"), fold, lower=LOWER, upper=UPPER, steps=STEPS)


def drawn() -> Drawn:
    family, _ = gl.load_case("kahraman-singh").family()
    return Drawn(family, ("omega", "D"), np.array(LOWER), np.subtract(UPPER, LOWER), 1)


def part(first: float, last: float, turned: bool = False) -> gl.Curve:
    """Of the points, between two shares of their number."""
    count = len(curve().points)
    points = curve().points[int(first * count) : int(np.ceil(last * count))]
    ends = [gl.EndOfCurve(gl.CurveEndKind.POINTS, points[i].values) for i in (0, -1)]
    ends = [curve().ends[0] if first == 0.0 else ends[0], curve().ends[1] if last == 1.0 else ends[1]]
    low, high = points[0].arclength, points[-1].arclength
    special = tuple(each for each in curve().special if low <= each.arclength <= high)
    if not turned:
        return replace(curve(), points=points, special=special, ends=tuple(ends))
    back = tuple(replace(point, arclength=-point.arclength) for point in reversed(points))
    special = tuple(replace(s, point=replace(s.point, arclength=-s.arclength)) for s in reversed(special))
    return replace(curve(), points=back, special=special, ends=tuple(reversed(ends)))


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_two_that_are_one_in_part_are_joined(turned: bool, order: tuple[int, int]):
    parts = part(0.0, 0.6), part(0.3, 1.0, turned)
    atlas = drawn()
    assert [atlas.add(parts[i], "of a branch") for i in order] == [0, 0]
    (line,) = atlas.lines
    ends = sorted(end.values for end in line.curve.ends)
    assert ends == sorted(end.values for end in curve().ends)
    assert {end.kind for end in line.curve.ends} == {end.kind for end in curve().ends}
    assert len(line.curve.special) == len(curve().special) == 1
    along = [point.arclength for point in line.curve.points]
    assert (np.diff(along) > 0.0).all()
    assert sorted(point.values for point in line.curve.points) == sorted(p.values for p in curve().points)


def test_one_that_lies_on_another_one_is_that_one():
    for pair in ((part(0.0, 1.0), part(0.2, 0.7)), (part(0.2, 0.7, True), part(0.0, 1.0))):
        atlas = drawn()
        assert [atlas.add(each, "of a branch") for each in pair] == [0, 0]
        assert len(atlas.lines[0].curve.points) == len(curve().points)


def test_two_that_touch_in_one_orbit_alone_stay_two():
    count = len(curve().points)
    middle = (count // 2) / count
    atlas = drawn()
    assert [atlas.add(each, "of a branch") for each in (part(0.0, middle), part(middle, 1.0))] == [0, 1]


def test_beside_a_point_where_two_things_happen_a_step_is_between_two_points_of_the_curve():
    atlas = drawn()
    atlas.add(curve(), "of a branch")
    (line,), (special,) = atlas.lines, curve().special
    at = [node.values for node in line.nodes].index(special.values)
    for step in (at - 1, at):
        before, after = line.around(step)
        assert before.arclength <= special.arclength <= after.arclength
        assert before in line.curve.points
        assert after in line.curve.points
        assert {str(before.signature), str(after.signature)} == {"1-1-0", "1-1-1"}
