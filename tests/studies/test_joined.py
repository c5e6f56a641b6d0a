"""No line goes through a jump between two motions; one motion, however steep, stays joined."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from gearlash.results.steps import Rows, apart
from gearlash.studies.joined import apart_at, apart_in
from gearlash.studies.transitions import transitions

BOTH = "up", "down"


def broken(sweeps, flags):
    """Steps from one value to the next, both periodic, by direction."""
    return {
        str(sweep.direction): [
            (round(below.value, 6), round(above.value, 6))
            for below, above, gap in zip(sweep.points, sweep.points[1:], steps, strict=False)
            if gap and below.periodic and above.periodic
        ]
        for sweep, steps in zip(sweeps, flags, strict=True)
    }


@pytest.fixture(scope="module")
def classical():
    """Over the first jump of the classical resonance: a touch at 0.8206 and then a fold of the motion that
    comes up; the one that comes down ends at another fold below it."""
    case = gl.load_case("kahraman-singh")
    return case, gl.sweeps(case, gl.Axis.even("omega", 0.6, 0.9, 31), BOTH)


def test_every_fold_that_was_solved_for_breaks_the_line_of_its_own_way(classical):
    case, sweeps = classical
    found = broken(sweeps, apart_in(case, sweeps))
    for sweep in sweeps:
        rising = str(sweep.direction) == "up"
        ends = [c.value for c in transitions(case, "omega", sweep, rising=rising) if c.kind != "grazing"]
        assert ends
        steps = found[str(sweep.direction)]
        assert len(steps) == len(ends)
        assert all(low <= end <= high for (low, high), end in zip(steps, ends, strict=True))
    assert found["up"] != found["down"]


def test_changes_that_are_known_tell_the_same(classical):
    case, sweeps = classical
    known = [
        apart_at(sweep, transitions(case, "omega", sweep, rising=str(sweep.direction) == "up"))
        for sweep in sweeps
    ]
    for one, other in zip(known, apart_in(case, sweeps), strict=True):
        assert one.tolist() == other.tolist()


def test_a_fold_narrower_than_the_axis_breaks_both_ways():
    """Both ways coincide at every point of so coarse an axis, and jump between two of them."""
    case = gl.load_case("kahraman-singh")
    sweeps = gl.sweeps(case, gl.Axis.even("omega", 0.6, 0.9, 2), BOTH)
    assert not gl.coexisting(sweeps).any()
    assert broken(sweeps, apart_in(case, sweeps)) == {"up": [(0.6, 0.9)], "down": [(0.6, 0.9)]}


def test_a_steep_flank_of_one_motion_stays_joined():
    """Linear motion has no second one; ten values over its resonance climb and fall steeply."""
    case = gl.load_case("kahraman-singh", {"D": 0.0})
    sweeps = gl.sweeps(case, gl.Axis.even("omega", 0.8, 1.2, 10), BOTH)
    steps = Rows.of_sweeps(sweeps).steps()
    assert np.nanmax(steps) > 0.3
    assert not np.concatenate(apart_in(case, sweeps)).any()


def test_the_points_alone_break_the_way_that_changed_over(classical):
    case, sweeps = classical
    told, known = apart(Rows.of_sweeps(sweeps)), apart_in(case, sweeps)
    for one, other in zip(told, known, strict=True):
        assert not (other & ~one).any()
    dataset = gl.sweep_dataset(case, sweeps)
    assert apart(Rows.of_dataset(dataset, "omega")).tolist() == told.tolist()


def test_members_from_a_drawing_are_not_followed(monkeypatch: pytest.MonkeyPatch):
    """Of every torque another pair is estimated: the points alone tell, and speeds are followed as ever."""

    def followed(*_: object, **__: object) -> None:
        raise AssertionError("followed")

    case = gl.load_case(Path(__file__).parents[1] / "cases" / "drawing.toml")
    ways = gl.sweeps(case, gl.Axis.even("torque", "100 N m", "150 N m", 9), ("up", "down"))
    monkeypatch.setattr("gearlash.studies.joined.by_step", followed)
    assert np.array(apart_in(case, ways)).tolist() == apart(Rows.of_sweeps(ways)).tolist()
    assert [case.content.rebuilt(name) for name in ("omega", "load", "mesh.mean_stiffness")] == [
        False,
        True,
        True,
    ]
    assert not gl.load_case("article").content.rebuilt("load")
