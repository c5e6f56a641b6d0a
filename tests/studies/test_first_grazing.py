"""The first grazing on the way of a motion, against the point solved for directly, and its arguments."""

from __future__ import annotations

from typing import Any

import pytest

import gearlash as gl

CASE = gl.load_case("article")


@pytest.mark.parametrize(("direction", "value"), [("down", 0.9724999996), ("up", 1.1120000016)])
def test_both_ends_of_the_impact_free_motion(direction: Any, value: float):
    start = gl.point(CASE, {"omega": 1.0}, name="omega")
    told: list[tuple[int, int]] = []
    path, touch = gl.first_grazing(
        CASE, "omega", start, direction, tell=lambda done, total: told.append((done, total))
    )
    assert touch is not None
    assert touch.value == pytest.approx(value, abs=1e-9)
    assert path.reached == touch.value
    assert path.decided
    assert told
    assert all(0 <= done <= total for done, total in told)


def test_a_family_and_other_parameters_are_taken():
    family = CASE.family()[0]
    fixed = {"omega": 0.78}
    start = gl.point(family, {**fixed, "D": 0.387}, name="D")
    path, touch = gl.first_grazing(family, "D", start, "down", values=fixed)
    assert touch is not None
    assert touch.values["omega"] == 0.78
    assert path.reached < 0.387


def test_what_does_not_fit_is_refused_in_words():
    start = gl.point(CASE, {"omega": 1.0}, name="omega")
    wrong: list[tuple[tuple[Any, ...], str]] = [
        (("omga", start, "up"), "omga"),
        (("omega", 1.0, "up"), "point"),
        (("omega", start, "sideways"), "direction"),
        (("omega", start, "cold"), "down or up"),
    ]
    for arguments, said in wrong:
        with pytest.raises(gl.GearlashError, match=said):
            gl.first_grazing(CASE, *arguments)
    with pytest.raises(gl.GearlashError, match="name='omega'"):
        gl.first_grazing(CASE, "omega", gl.point(CASE, {"omega": 1.0}), "up")
    chaos = gl.point(CASE, {"omega": 0.78, "D": 0.25}, name="omega")
    assert not chaos.periodic
    with pytest.raises(gl.GearlashError, match="periodic"):
        gl.first_grazing(CASE, "omega", chaos, "up")
