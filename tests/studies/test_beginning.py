"""A start that was found at other parameters is not taken for an orbit of these."""

from __future__ import annotations

import pytest

import gearlash as gl

CASE = gl.load_case("kahraman-singh")


def found() -> gl.Point:
    return gl.point(CASE, {"omega": 1.5}, name="omega")


def followed(**values: float) -> gl.Branch:
    return gl.continue_branch(CASE, "load", found(), lower=0.1, upper=2.0, values=values)


def test_a_point_of_one_parameter_is_none_of_another():
    with pytest.raises(gl.GearlashError, match=r"no periodic motion at omega = .*give as values"):
        followed()
    with pytest.raises(gl.GearlashError, match="no periodic motion at"):
        gl.first_grazing(CASE, "load", found(), "down")


def test_an_orbit_found_at_other_values_is_told_from_one_outside_the_limits():
    orbit = gl.attractor(CASE.family()[0].system({"omega": 1.5}), found().state)
    assert isinstance(orbit, gl.Orbit)
    with pytest.raises(gl.GearlashError, match="no periodic motion at"):
        gl.continue_branch(CASE, "omega", orbit, lower=1.2, upper=1.6)
    branch = gl.continue_branch(CASE, "omega", orbit, lower=1.45, upper=1.55, values={"omega": 1.5})
    assert branch.points


def test_a_point_of_a_branch_in_one_parameter_is_none_of_another():
    """It does not say of which parameter it is; a special point does."""
    branch = gl.continue_branch(CASE, "omega", found(), lower=1.3, upper=1.6)
    with pytest.raises(gl.GearlashError, match="no periodic motion at"):
        gl.continue_branch(CASE, "error", branch.points[0], lower=0.0, upper=3.0)
    start = branch.special[0]
    again = gl.continue_branch(CASE, "error", start, lower=0.0, upper=start.values["error"] * 1.1)
    assert again.values == start.values


def test_a_point_that_does_not_say_its_value_is_refused_with_the_way_to_make_it():
    nameless = gl.point(CASE, {"omega": 1.5})
    with pytest.raises(
        gl.GearlashError, match=r"make it with gearlash\.point\(model, values, name='omega'\)"
    ):
        gl.continue_branch(CASE, "omega", nameless, lower=1.2, upper=1.6)
