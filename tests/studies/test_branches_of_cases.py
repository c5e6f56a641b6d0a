"""Branches of a case, as a user asks for them, and on disk."""

from __future__ import annotations

import json
import threading
from dataclasses import fields
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from gearlash.system import Record

COARSE = gl.ContinuationSettings(longest=0.1)


@cache
def window() -> gl.Branch:
    return gl.continue_branch(
        gl.load_case("article"), "pinion_speed", lower="3650 rpm", upper="4300 rpm",
        values={"pinion_speed": "4000 rpm"}, steps=COARSE,
    )  # fmt: skip


@cache
def six() -> gl.Branch:
    values = {"omega": 0.78, "D": 0.365}
    return gl.continue_branch(
        gl.load_case("article"), "D", lower=0.35, upper=0.37, values=values, steps=COARSE
    )


def same(one: Any, other: Any) -> bool:
    """Whether two records hold the same numbers, to the last digit."""
    if isinstance(one, Record):
        return type(one) is type(other) and all(
            same(getattr(one, field.name), getattr(other, field.name))
            for field in fields(one)  # type: ignore[arg-type]
        )
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and np.array_equal(one, other)
    if isinstance(one, tuple) and not hasattr(one, "_fields"):
        return len(one) == len(other) and all(map(same, one, other))
    return bool(one == other)


def test_physical_names_and_units():
    case = gl.load_case("article")
    branch = window()
    assert branch.name == "omega"
    assert branch.lower == case.resolve("pinion_speed", "3650 rpm")[1]
    touch = max(branch.of_kind("grazing"), key=lambda special: special.value)
    assert touch.value == pytest.approx(1.112, abs=1e-6)
    assert all(point.certificate.certified for point in branch.points)


def test_a_branch_goes_on_from_any_of_its_points():
    """From a special point, too: the same special points are found again."""
    branch = window()
    touch = branch.special[-1]
    for start in (branch.points[-1], touch, touch.point):
        again = gl.continue_branch(
            gl.load_case("article"), "omega", start, lower=branch.lower, upper=branch.upper, steps=COARSE
        )
        found = [special.value for special in again.special if abs(special.arclength) > 1e-6]
        expected = [s.value for s in branch.special if start is branch.points[-1] or s is not touch]
        assert found == pytest.approx(expected, rel=1e-12)


def test_a_point_of_a_study_is_a_start():
    case = gl.load_case("article")
    point = gl.point(case, {"omega": 1.05}, name="omega")
    branch = gl.continue_branch(case, "omega", point, lower=1.0, upper=1.12, steps=COARSE)
    assert branch.values["omega"] == 1.05
    assert [special.kind for special in branch.special] == [gl.SpecialKind.GRAZING]


def test_switched_by_the_case():
    case = gl.load_case("article")
    (twelve,) = gl.switch_branch(case, six(), six().of_kind("doubling")[0], steps=COARSE)
    assert {point.label for point in twelve.points} == {"12-12-3", "12-12-2"}


@pytest.mark.parametrize("branch", [window, six])
def test_a_branch_on_disk_is_the_same(branch, tmp_path: Path):
    path = gl.save_branch(branch(), tmp_path / "new" / "branch.json", gl.load_case("article"))
    again = gl.load_branch(path)
    assert same(again, branch())
    content = json.loads(path.read_text(encoding="utf-8"))
    assert (content["format"], content["version"]) == ("gearlash-branch", 1)
    assert content["provenance"]["case_hash"] == gl.load_case("article").hash


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda content: content.update(version=2), "version 2"),
        (lambda content: content.update(format="other"), "not a file of a branch"),
        (lambda content: content["branch"]["points"][0].pop("strobes"), "not a whole branch"),
        (lambda content: content["branch"]["points"][0].update(signature="x"), "not a whole branch"),
    ],
)
def test_other_files_are_refused(change, told, tmp_path: Path):
    path = gl.save_branch(six(), tmp_path / "branch.json", gl.load_case("article"))
    content = json.loads(path.read_text(encoding="utf-8"))
    change(content)
    path.write_text(json.dumps(content), encoding="utf-8")
    with pytest.raises(gl.GearlashError, match=told):
        gl.load_branch(path)
    path.write_bytes(b"\x89HDF")
    with pytest.raises(gl.GearlashError, match="not a file of a branch"):
        gl.load_branch(path)


def test_a_branch_tells_its_orbits_and_may_be_stopped():
    """Nobody knows how many there will be."""
    case, stop, heard = gl.load_case("article"), threading.Event(), list[gl.Progress]()

    def hear(progress: gl.Progress) -> None:
        heard.append(progress)
        if progress.done >= 5:
            stop.set()

    told = gl.Execution(progress=hear, cancel=stop)
    branch = gl.continue_branch(case, "omega", lower=0.9, upper=1.12, values={"omega": 1.0}, execution=told)
    assert [progress.done for progress in heard[:5]] == [1, 2, 3, 4, 5]
    assert np.isnan(heard[0].share)
    assert str(heard[1]).startswith("2 after ")
    assert {end.kind for end in branch.ends} == {gl.EndKind.CANCELLED}
    assert len(branch.points) == 1 + len(heard)


def test_limits_are_refused_in_the_unit_of_the_question():
    case = gl.load_case("article")
    here = {"pinion_speed": "4000 rpm"}
    with pytest.raises(gl.GearlashError, match="limits of pinion_speed: 4200 rpm is not below 3700 rpm"):
        gl.continue_branch(case, "pinion_speed", lower="4200 rpm", upper="3700 rpm", values=here)
    outside = "pinion_speed = 4000 rpm of the start lies outside the interval from 4100 rpm to 4200 rpm"
    with pytest.raises(gl.GearlashError, match=outside):
        gl.continue_branch(case, "pinion_speed", lower="4100 rpm", upper="4200 rpm", values=here)
    with pytest.raises(gl.GearlashError, match="lower limit of pinion_speed: "):
        gl.continue_branch(case, "pinion_speed", lower="-3 rpm", upper="4200 rpm", values=here)
    with pytest.raises(gl.GearlashError, match="lower limit of backlash: "):
        gl.continue_branch(case, "backlash", lower="3 rpm", upper="80 um")


def test_what_cannot_be_followed_is_refused_in_words():
    case = gl.load_case("article")
    with pytest.raises(gl.GearlashError, match="not below"):
        gl.continue_branch(case, "omega", lower=1.2, upper=1.0)
    with pytest.raises(gl.GearlashError, match="outside the interval"):
        gl.continue_branch(case, "omega", lower=1.2, upper=1.3, values={"omega": 1.0})
    with pytest.raises(gl.GearlashError, match="not periodic"):
        gl.continue_branch(case, "omega", gl.Point(1.0, gl.Status.OK, "chaos"), lower=0.9, upper=1.1)
    family, _ = case.family()
    with pytest.raises(gl.GearlashError, match="omega"):
        gl.continue_branch(family, "omega", lower=-1.0, upper=1.3)


def test_a_point_of_a_branch_begins_one_in_another_parameter():
    """A special point brings all parameters; another point has them given, the new one included."""
    case, branch = gl.load_case("article"), window()
    touch, point = branch.special[-1], branch.points[2]
    limits = {"lower": 0.08, "upper": 0.12, "steps": COARSE}
    again = gl.continue_branch(case, "load", touch, **limits)
    assert again.values == touch.values
    assert min(abs(each.value - touch.values["load"]) for each in again.of_kind("grazing")) < 1e-9
    values = {**branch.values, "omega": point.value}
    again = gl.continue_branch(case, "load", point, values=values, **limits)
    assert again.values == values
    begun = min(again.points, key=lambda each: abs(each.arclength))
    np.testing.assert_allclose(begun.state, point.state, atol=1e-12)
    with pytest.raises(gl.GearlashError, match="a branch in another parameter give all values, load and"):
        gl.continue_branch(case, "load", point, **limits)
    with pytest.raises(gl.GearlashError, match="no periodic motion at"):
        gl.continue_branch(case, "load", touch, values={"omega": 0.9}, **limits)


@pytest.mark.parametrize(
    ("case", "name", "values", "limits", "kind"),
    [
        ("kahraman-singh", "omega", {"omega": 1.5}, (0.6, 1.6), "fold"),
        ("article", "D", {"omega": 0.78, "D": 0.365}, (0.35, 0.37), "doubling"),
    ],
)
def test_a_branch_begun_at_a_special_point_tells_it_as_the_one_on_which_it_was_found(
    case, name, values, limits, kind
):
    """In the point itself a multiplier is on the unit circle within rounding, and neither way knows on
    which side of it it begins."""
    model = gl.load_case(case)
    ends = {"lower": limits[0], "upper": limits[1]}
    first = gl.continue_branch(model, name, values=values, **ends)
    for special in first.of_kind(kind):
        again = gl.continue_branch(model, name, special, **ends)
        assert not again.unexplained
        assert {str(point.certificate.verdict) for point in again.points} == {"certified"}
        same = min(again.of_kind(kind), key=lambda each: abs(each.value - special.value))
        assert same.value == pytest.approx(special.value, rel=1e-12)
        sides = [{s.unstable_before, s.unstable_after} for s in (special, same)]
        assert sides[0] == sides[1] == {0, 1}
