"""Curves as they are asked for: names and units of a case, files, starts that do not fit."""

from __future__ import annotations

import json
from functools import cache, partial

import pytest

import gearlash as gl

WIDE = gl.ContinuationSettings(longest=0.2, first=0.01, certify=False)


@cache
def branch() -> gl.Branch:
    case = gl.load_case("kahraman-singh")
    return gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5}, steps=WIDE)


@cache
def curve() -> gl.Curve:
    fold = branch().of_kind("fold")[-1]
    case = gl.load_case("kahraman-singh")
    return gl.continue_curve(case, ("omega", "D"), fold, lower=(0.6, 0.13), upper=(0.8, 1.1), steps=WIDE)


def test_a_curve_in_physical_names_is_the_same_curve():
    case = gl.load_case("article")
    window = gl.continue_branch(case, "omega", lower=1.0, upper=1.12, steps=WIDE)
    touch = window.of_kind("grazing")[0]
    plain = gl.continue_curve(
        case, ("omega", "load"), touch, lower=(1.05, 0.08), upper=(1.15, 0.1), steps=WIDE
    )
    speed, torque = (case.physical(name, 1.0)[0] for name in ("omega", "load"))
    factors = float(speed[1]), float(torque[1])
    lower, upper = (
        (f"{omega * factors[0]!r} {speed[2]}", f"{load * factors[1]!r} {torque[2]}")
        for omega, load in ((1.05, 0.08), (1.15, 0.1))
    )
    names = speed[0].rpartition(".")[2], torque[0].rpartition(".")[2]
    physical = gl.continue_curve(case, names, touch, lower=lower, upper=upper, branch=window, steps=WIDE)
    assert physical.names == plain.names == ("omega", "load")
    ends = [sorted(end.values for end in each.ends) for each in (physical, plain)]
    assert ends[0][0] == pytest.approx(ends[1][0], rel=1e-9)
    assert ends[0][1] == pytest.approx(ends[1][1], rel=1e-9)


def test_a_curve_comes_back_from_its_file_and_goes_on(tmp_path):
    case = gl.load_case("kahraman-singh")
    again = gl.load_curve(gl.save_curve(curve(), tmp_path / "curve.json", case))
    assert [point.values for point in again.points] == [point.values for point in curve().points]
    assert [str(special.kind) for special in again.special] == ["grazing with a multiplier 1"]
    restarted = gl.continue_curve(
        case, ("omega", "D"), again.special[0], lower=(0.6, 0.13), upper=(0.8, 1.1), kind="fold", steps=WIDE
    )
    ends = [sorted(end.values for end in each.ends) for each in (restarted, again)]
    assert ends[0][0] == pytest.approx(ends[1][0], abs=1e-9)
    assert ends[0][1] == pytest.approx(ends[1][1], abs=1e-9)


def test_a_special_point_of_a_branch_file_begins_a_curve(tmp_path):
    case = gl.load_case("kahraman-singh")
    stored = gl.load_branch(gl.save_branch(branch(), tmp_path / "branch.json", case))
    fold = stored.of_kind("fold")[-1]
    found = gl.continue_curve(
        case, ("load", "D"), fold, lower=(0.09, 0.9), upper=(0.11, 1.1), branch=stored, steps=WIDE
    )
    assert found.kind is gl.SpecialKind.FOLD
    assert found.values["omega"] == fold.value


@pytest.mark.parametrize("broken", ["", "[]", '{"format": "gearlash-branch"}'])
def test_what_is_no_file_of_a_curve_is_refused(tmp_path, broken):
    path = tmp_path / "curve.json"
    path.write_text(broken)
    with pytest.raises(gl.GearlashError, match="not a file of a curve"):
        gl.load_curve(path)


def test_a_file_of_a_later_version_and_one_with_parts_missing_are_refused(tmp_path):
    path = gl.save_curve(curve(), tmp_path / "curve.json", gl.load_case("kahraman-singh"))
    content = json.loads(path.read_text())
    path.write_text(json.dumps({**content, "version": 2}))
    with pytest.raises(gl.GearlashError, match="version 2"):
        gl.load_curve(path)
    del content["curve"]["points"]
    path.write_text(json.dumps(content))
    with pytest.raises(gl.GearlashError, match="not a whole curve"):
        gl.load_curve(path)


def test_what_does_not_fit_is_refused_in_words():
    case, fold = gl.load_case("kahraman-singh"), branch().of_kind("fold")[-1]
    follow = partial(gl.continue_curve, lower=(0.6, 0.13), upper=(0.8, 1.1))
    with pytest.raises(gl.GearlashError, match="one parameter"):
        follow(case, ("omega", "omega"), fold)
    with pytest.raises(gl.GearlashError, match="the special point is a fold"):
        follow(case, ("omega", "D"), fold, kind="grazing")
    with pytest.raises(gl.GearlashError, match="no curve of this kind is followed: branch point"):
        follow(case, ("omega", "D"), curve().special[0], kind="branch point")
    touch = next(each for each in branch().special if each.kind is gl.SpecialKind.GRAZING)
    with pytest.raises(gl.GearlashError, match="the special point is a grazing"):
        follow(case, ("omega", "D"), touch, kind="fold", lower=(0.4, 0.13), upper=(1.6, 1.1))
    with pytest.raises(gl.GearlashError, match="two names"):
        follow(case, ("omega",), fold)  # pyright: ignore[reportArgumentType]
    with pytest.raises(gl.GearlashError, match="no periodic motion at"):
        follow(case, ("omega", "D"), fold, values={"load": 0.12})
    with pytest.raises(gl.GearlashError, match="outside the interval"):
        gl.continue_curve(case, ("omega", "D"), fold, lower=(0.75, 0.1), upper=(0.8, 1.1))


def test_a_curve_stops_where_it_is_told_to():
    case, fold = gl.load_case("kahraman-singh"), branch().of_kind("fold")[-1]
    heard: list[int] = []

    class Enough:
        def is_set(self) -> bool:
            return len(heard) >= 3

        def set(self) -> None:
            raise AssertionError

    execution = gl.Execution(progress=lambda each: heard.append(each.done), cancel=Enough())
    found = gl.continue_curve(
        case, ("omega", "D"), fold, lower=(0.6, 0.13), upper=(0.8, 1.1), execution=execution
    )
    assert gl.CurveEndKind.CANCELLED in {end.kind for end in found.ends}
    assert len(found.points) <= 6
