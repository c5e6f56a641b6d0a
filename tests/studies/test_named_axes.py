"""Axes and parameters by any name and unit of a case: the same bytes as with dimensionless numbers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from gearlash.results import Direction

CASES = Path(__file__).resolve().parents[1] / "cases"
CASE = gl.load_case("article")


def in_omega(*speeds: str) -> list[float]:
    return [CASE.resolve("pinion_speed", speed)[1] for speed in speeds]


def states(sweep: gl.Sweep) -> list[bytes]:
    return [point.state.tobytes() for point in sweep.points]


def test_a_sweep_over_speeds_is_that_over_omega():
    low, high = in_omega("3600 rpm", "4000 rpm")
    plain = gl.sweep(CASE, gl.Axis.even("omega", low, high, 3))
    for axis in (
        gl.Axis.even("pinion_speed", "3600 rpm", "4000 rpm", 3),
        gl.Axis.even("pinion_speed", 3600, "4000 rpm", 3),
        gl.Axis("pinion_speed", np.array([3600, 3800, 4000]), "rpm"),
    ):
        named = gl.sweep(CASE, axis)
        assert named.axis.name == "omega"
        assert np.array_equal(named.axis.values, plain.axis.values)
        assert states(named) == states(plain)


def test_uneven_values_are_each_converted():
    named = gl.sweep(CASE, gl.Axis("operation.mesh_frequency", np.array([1680.0, 1700.0, 1860.0]), "Hz"))
    expected = [CASE.resolve("mesh_frequency", f"{value!r} Hz")[1] for value in (1680.0, 1700.0, 1860.0)]
    assert named.axis.values.tolist() == expected


def test_maps_zones_points_and_searches_take_names_and_units():
    fixed = {"backlash": "90 um"}
    plain = {"D": CASE.resolve("backlash", "90 um")[1]}
    speeds = gl.Axis.even("pinion_speed", "3900 rpm", "4000 rpm", 2)
    assert gl.point(CASE, {"pinion_speed": "4000 rpm", **fixed}).state.tobytes() == (
        gl.point(CASE, {"omega": in_omega("4000 rpm")[0], **plain}).state.tobytes()
    )
    assert dict(gl.sweep(CASE, speeds, values=fixed, direction=Direction.UP).fixed) == plain
    plane = gl.map_plane(CASE, speeds, gl.Axis.even("mesh.backlash", "80 um", "90 um", 2))
    assert (plane.x.name, plane.y.name) == ("omega", "D")
    assert gl.zones(CASE, speeds, values=fixed).axis.name == "omega"
    found = gl.impact_free_speeds(CASE, {"pinion_speed": "4000 rpm", **fixed})
    assert found is not None
    assert found.here
    path, _ = gl.first_grazing(CASE, "omega", gl.point(CASE, fixed, name="omega"), "down", values=fixed)
    assert path.decided
    start = gl.point(CASE, {"pinion_speed": "4000 rpm", **fixed}, name="pinion_speed")
    assert start.value == in_omega("4000 rpm")[0]
    assert gl.first_grazing(CASE, "pinion_speed", start, "down", values=fixed)[0].decided


@pytest.mark.parametrize(
    ("axis", "fixed", "said"),
    [
        (gl.Axis.even("pinion_sped", "1000 rpm", "2000 rpm", 2), {}, "pinion_speed"),
        (gl.Axis.even("pinion_speed", "1 um", "2 um", 2), {}, "rpm"),
        (gl.Axis.even("pinion_speed", 1000, 2000, 2), {}, "unit"),
        (gl.Axis.even("omega", 1.0, 1.1, 2), {"pinion_speed": "4000 rpm"}, "axis"),
        (gl.Axis.even("D", 1.0, 1.1, 2), {"pinion_speed": "4000 rpm", "omega": 1.0}, "same quantity"),
    ],
)
def test_what_does_not_fit_is_refused_in_words(axis: gl.Axis, fixed: dict[str, Any], said: str):
    with pytest.raises(gl.GearlashError, match=said):
        gl.sweep(CASE, axis, values=fixed)


def test_values_may_be_texts_with_one_unit():
    axis = gl.Axis("pinion_speed", ["3600 rpm", "3800", "4200 rpm"])
    assert (axis.values.tolist(), axis.unit) == ([3600.0, 3800.0, 4200.0], "rpm")
    for values, unit, said in (
        (["3600 rpm", "440 rad/s"], "", "rpm and rad/s: expected one unit"),
        (["3600 rpm", "70 rps"], "", "rpm and rps: expected one unit"),
        (["3600 rpm"], "Hz", "Hz and rpm: expected one unit"),
        (["slow", "3600 rpm"], "", "number with its unit"),
        (["3600 rpm", 3700], "", "numbers of shape"),
        (["3800 rpm", "3600 rpm"], "", "ascend"),
    ):
        with pytest.raises(gl.GearlashError, match=said):
            gl.Axis("pinion_speed", values, unit)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize(
    ("values", "unit", "kept"),
    [
        (["150 N·m", "160 Nm", "170 N m"], "", "N*m"),
        (["150 Nm", "160"], "N m", "N m"),
        (["80 µm", "90 um"], "", "um"),
        (["900 rpm", "950 rev/min"], "", "rpm"),
    ],
)
def test_one_unit_may_be_spelt_in_two_ways(values: list[str], unit: str, kept: str):
    axis = gl.Axis("torque", values, unit)
    assert axis.values.tolist() == [float(value.split()[0]) for value in values]
    assert axis.unit == kept
    assert gl.Axis.even("torque", values[0], values[1], 2).values.tolist() == axis.values[:2].tolist()


def test_a_family_has_no_units():
    with pytest.raises(gl.UnknownNameError, match=r"case\.resolve"):
        CASE.family()[0].system({"pinion_speed": 4000.0})
    with pytest.raises(gl.GearlashError, match="no units"):
        gl.sweep(CASE.family()[0], gl.Axis.even("omega", "1000 rpm", "2000 rpm", 2))
    with pytest.raises(gl.GearlashError, match="one unit for both"):
        gl.Axis.even("pinion_speed", "10 Hz", "2000 rpm", 2)
    with pytest.raises(gl.GearlashError, match="number with its unit"):
        gl.Axis.even("pinion_speed", "slow", "2000 rpm", 2)


@pytest.mark.parametrize(
    ("name", "text", "short"),
    [
        ("power", "40 kW", "load"),
        ("gear_torque", "300 N m", "load"),
        ("gear_speed", "1500 rpm", "omega"),
        ("backlash_circumferential", "90 um", "D"),
    ],
)
def test_other_words_of_a_parameter_vary_as_they_replace_it(name: str, text: str, short: str):
    """What a study goes over is what an override of the same name would set."""
    case = gl.load_case(CASES / "drawing.toml")
    parameter, value = case.resolve(name, text)
    replaced = case.with_overrides({name: text}).family()[0].defaults
    assert parameter == short
    own = case.with_overrides({name: text})
    units = own.scales.load_from_torque(1.0) / case.scales.load_from_torque(1.0) if short == "load" else 1.0
    times = own.scales.omega_from_rpm(1.0) / case.scales.omega_from_rpm(1.0) if short == "omega" else 1.0
    assert value == pytest.approx(replaced[short] / (float(units) * float(times)), rel=1e-12)


def test_a_power_is_a_torque_at_the_speed_of_the_case():
    case = gl.load_case(CASES / "drive.toml")
    torque = 40e3 / (2.0 * np.pi * 4200.0 / 60.0)
    assert case.resolve("power", "40 kW")[1] == pytest.approx(
        case.resolve("torque", f"{torque} N m")[1], rel=1e-12
    )
    swept = gl.sweep(case, gl.Axis.even("power", "40 kW", "60 kW", 2))
    plain = gl.sweep(case, gl.Axis.even("torque", f"{torque!r} N m", f"{1.5 * torque!r} N m", 2))
    assert swept.axis.values == pytest.approx(plain.axis.values, rel=1e-12)


def test_what_the_case_has_no_value_of_is_told_so():
    with pytest.raises(gl.CaseError, match=r"state mesh\.temperature in its file"):
        gl.load_case(CASES / "drive.toml").resolve("mesh.temperature", "60 degC")
