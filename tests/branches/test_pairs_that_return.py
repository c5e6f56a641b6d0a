"""A pair of multipliers leaves the circle, becomes real, and one of the two comes back, all in one step."""

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
