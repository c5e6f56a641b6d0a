"""Impact-free motion over the ranges of estimates: ends within a range, the worst combination."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from gearlash.case import loads
from gearlash.studies.impact_free import closed_margin
from gearlash.studies.ranges import AcrossRanges, across_ranges, varied
from gearlash.studies.speeds_across import speeds_across
from gearlash.studies.tolerances.inputs import ranged_inputs
from gearlash.studies.worst_of_ranges import margin_of, values_of

CASES = Path(__file__).resolve().parents[1] / "cases"
KNOWN = {
    "mean_stiffness": "8e8 N/m",
    "pinion.mass": "1.2 kg",
    "pinion.inertia": "1e-3 kg*m^2",
    "gear.mass": "7 kg",
    "gear.inertia": "0.029 kg*m^2",
    "bearings.damping_ratio": 0.02,
    "mesh.damping_ratio": 0.05,
    **{f"{gear}.bearing_stiffness_{axis}": "3e8 N/m" for gear in ("pinion", "gear") for axis in "yz"},
}


def pair(speed: str, torque: str) -> gl.Case:
    """Of which harmonics of the stiffness and the error are estimates."""
    return gl.load_case(CASES / "drawing.toml", {**KNOWN, "pinion_speed": speed, "torque": torque})


@pytest.fixture(scope="module")
def light() -> tuple[gl.Case, AcrossRanges]:
    """So little torque that the largest error opens the mesh."""
    case = pair("4200 rpm", "40 N m")
    found = across_ranges(case)
    assert found is not None
    return case, found


def test_the_value_at_which_contact_ends_is_solved_for(light: tuple[gl.Case, AcrossRanges]):
    case, found = light
    (error,) = (one for one in found.varied if one.input.path == "mesh.error")
    ((low, high),) = error.broken
    assert error.input.lower < low < high == error.input.upper
    assert error.input.nominal < low
    assert not found.holds
    for side, sign in ((-1.0, 1), (1.0, -1)):
        member = case.with_overrides({"error": f"{low * (1.0 + side * 1e-9)!r} um"})
        assert np.sign(closed_margin(member.family()[0].system(), 1)) == sign


def test_margins_of_a_range_are_those_of_a_grid_over_it(light: tuple[gl.Case, AcrossRanges]):
    case, found = light
    for one in found.varied[::4]:
        at = np.linspace(one.input.lower, one.input.upper, 7)
        rows = [margin_of(case, {one.input.path: one.input.text(float(x))}) for x in at]
        assert min(rows) >= one.margin - 0.02
        broken = [any(low <= x <= high for low, high in one.broken) for x in at]
        assert broken == [not row > 0.0 for row in rows]


def test_together_is_at_least_as_bad_as_each_alone(light: tuple[gl.Case, AcrossRanges]):
    case, found = light
    assert found.together is not None
    assert found.together.margin <= min(one.margin for one in found.varied)
    assert margin_of(case, found.together.values) == found.together.margin


def test_a_resonance_that_other_values_would_leave_is_combined_with_them():
    """A bearing alone leaves half of the compression; the worst values of all others, each by itself, miss
    that resonance. With a few of them beside the bearing teeth part, and a run says so as well."""
    case = gl.load_case(CASES / "fast.toml")
    found = across_ranges(case)
    assert found is not None
    assert found.broken == ()
    assert found.together is not None
    assert not found.holds
    assert found.together.margin <= 0.0
    assert len(found.together.values) <= 6
    for one in found.inputs:
        text = found.together.values.get(one.path)
        assert text is None or one.lower <= float(text.partition(" ")[0]) <= one.upper
    family = case.with_overrides(found.together.values).family()[0]
    orbit = gl.attractor(family.system(), family.start())
    assert isinstance(orbit.label, gl.Signature)
    assert orbit.label.impacts > 0


@pytest.fixture(scope="module")
def firm() -> AcrossRanges:
    """Much torque, and a range of speed below every resonance."""
    stated = {"operation.least_speed": "900 rpm", "operation.greatest_speed": "1100 rpm"}
    found = across_ranges(pair("1000 rpm", "600 N m").with_overrides(stated))
    assert found is not None
    return found


@pytest.mark.slow
def test_what_takes_nothing_leaves_the_verdict(firm: AcrossRanges):
    found = firm
    assert found.holds
    assert found.broken == ()
    assert found.together is not None
    assert 0.0 < found.together.margin < found.margin


def test_a_resonance_within_a_range_is_found_between_its_ends():
    """The stiffness of a bearing whose mode meets the mesh within the range, at neither of its ends."""
    known = {name: value for name, value in KNOWN.items() if name != "pinion.bearing_stiffness_y"}
    case = gl.load_case(CASES / "drawing.toml", {**known, "error": "15 um", "torque": "60 N m"})
    (one,) = (one for one in ranged_inputs(case) if one.path == "pinion.bearing_stiffness_y")
    found = varied(case, one)
    assert len(found.broken) == 1
    ((low, high),) = found.broken
    assert one.lower < low < found.worst < high < one.upper


def test_one_harmonic_of_the_stiffness_keeps_the_others():
    case = pair("4200 rpm", "150 N m")
    inputs = ranged_inputs(case)
    own = {one.path: one.text(one.nominal) for one in inputs if one.path == "mesh.ripple_3"}
    assert margin_of(case, own) == pytest.approx(margin_of(case, {}), rel=1e-12)


def test_values_of_a_range_go_from_end_to_end():
    for one in ranged_inputs(gl.load_case(CASES / "drawing.toml")):
        values = values_of(one)
        assert (values[0], values[-1]) == (one.lower, one.upper)
        assert all(np.diff(values) > 0.0)


def test_without_estimates_nothing_is_varied():
    assert across_ranges(gl.load_case("article")) is None


LIMITED = """
kind = "spur-1dof"
[dimensionless]
omega = 0.6
D = "0.8 to 1.2"
load = "0.05:0.3"
error = {value = 0.1, range = [0.08, 0.12]}
mesh_damping = 0.05
"""


def test_stated_limits_are_ranges_as_those_of_estimates_are():
    """A linear mesh under error and load is pressed together by f - ω² E / |1 - ω² + 2iξω| at least."""
    case = loads(LIMITED)
    found = across_ranges(case)
    assert found is not None
    assert [one.of_case for one in found.inputs] == [True] * 3
    amplitude = 0.6**2 / abs(1.0 - 0.6**2 + 2j * 0.05 * 0.6)
    assert found.margin == pytest.approx(1.0 - 0.1 * amplitude / 0.175, rel=1e-9)
    by = {one.input.path.rpartition(".")[2]: one for one in found.varied}
    assert (by["D"].margin, by["D"].broken) == (pytest.approx(found.margin, rel=1e-12), ())
    assert by["error"].worst == 0.12
    assert by["error"].margin == pytest.approx(1.0 - 0.12 * amplitude / 0.175, rel=1e-9)
    ((low, high),) = by["load"].broken
    assert (low, high) == (0.05, pytest.approx(0.1 * amplitude, rel=1e-9))
    assert found.together is not None
    assert not found.together.margin > 0.0
    assert across_ranges(case.with_overrides({"D": 1, "load": 0.2, "error": 0.1})) is None


def test_speeds_at_which_contact_ends_are_those_of_a_search_from_the_present_speed():
    """With an error at the end of its range: the first ends around the present speed are the same."""
    case = pair("4200 rpm", "150 N m")
    here = case.family()[0].defaults["omega"]
    inputs = ranged_inputs(case)
    (error,) = (one for one in inputs if one.path == "mesh.error")
    values = {error.path: error.text(error.upper)}
    found = speeds_across(case, values, (0.6 * here, 1.4 * here))
    other = gl.impact_free_speeds(case.with_overrides(values))
    assert other is not None
    assert found.parting
    ends = [end for band in found.parting for end in band]
    for end in (other.lower, other.upper):
        if end is not None and 0.6 * here < end < 1.4 * here:
            assert min(abs(one - end) for one in ends) < 1e-9
    assert any(low <= here <= high for low, high in found.parting) == (not other.here)


@pytest.mark.slow
def test_a_range_of_speed_is_looked_at_with_every_estimate_at_both_ends(firm: AcrossRanges):
    assert firm.speeds[0].values == {}
    for one in firm.varied:
        at = [s.values[one.input.path] for s in firm.speeds if list(s.values) == [one.input.path]]
        assert {one.input.text(one.input.lower), one.input.text(one.input.upper)} <= set(at)
    assert firm.parting == ()
    assert min(s.least for s in firm.speeds) > 0.0
