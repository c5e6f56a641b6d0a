"""Changes that undo each other, or hide each other, within one long step of a branch."""

from pathlib import Path

import pytest

import gearlash as gl

DRIVE = Path(__file__).parents[1] / "cases" / "drive.toml"


@pytest.fixture(scope="module")
def start():
    """A case, and a stable orbit just above the value at which its pair leaves the circle."""
    case = gl.load_case(DRIVE)
    whole = gl.continue_branch(case, "error", lower=0.19, upper=0.7944)
    return case, min(whole.points, key=lambda point: abs(point.value - 0.793))


@pytest.mark.parametrize("length", [0.05, 0.3, 1.0])
@pytest.mark.parametrize("lower", [0.78, 0.76, 0.74])
def test_on_long_steps_a_torus_beside_a_doubling_is_found_too(start, lower, length):
    """The pair leaves the circle, becomes real, and one of the two comes back through -1."""
    case, point = start
    assert point.stable
    steps = gl.ContinuationSettings(first=length, longest=length, angle=1.0, certify=False)
    branch = gl.continue_branch(case, "error", point, lower=lower, upper=point.value, steps=steps)
    doubling, torus = branch.special
    assert (str(doubling.kind), str(torus.kind)) == ("doubling", "Neimark-Sacker")
    assert doubling.value == pytest.approx(0.7845549158, abs=1e-9)
    assert torus.value == pytest.approx(0.7914874012, abs=1e-9)
    counts = [(each.unstable_before, each.unstable_after) for each in branch.special]
    assert counts == [(1, 2), (2, 0)]


@pytest.mark.parametrize("begun", [0.1025, 0.1085, 0.1175, 0.1265, 0.143])
def test_a_multiplier_that_passes_minus_one_and_returns_is_noticed_from_any_start(begun):
    """It goes to -1.012 only, within 0.0056 of a range of 0.9."""
    case = gl.load_case("article")
    steps = gl.ContinuationSettings(certify=False)
    values = {"omega": 0.78, "D": begun}
    branch = gl.continue_branch(case, "D", values=values, lower=0.1, upper=1.0, steps=steps)
    assert str(branch.points[0].label) == "1-1-1"
    found = sorted(special.value for special in branch.of_kind("doubling"))
    assert found == pytest.approx([0.132366620194, 0.137973018607], abs=1e-10)
