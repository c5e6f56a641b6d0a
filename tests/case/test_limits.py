"""Values with their limits: how they are written, what they mean, what is refused."""

import json
from pathlib import Path

import pytest

import gearlash as gl
from gearlash.case import loads
from gearlash.case.kinds import kind_named
from gearlash.case.limits import ends_of
from gearlash.case.stated import ValueRefusedError, read_stated

PLACES = kind_named("helical-pair").places
BACKLASH, SPAN, TORQUE = PLACES["mesh.backlash"], PLACES["pinion.span"], PLACES["operation.torque"]
DRIVE = Path(__file__).parents[1] / "cases" / "drive.toml"


def stated(raw: object, path: str = "mesh.backlash") -> tuple[float | str, float | None, float | None]:
    found = read_stated(raw, PLACES[path])
    return found.value, found.least, found.greatest


@pytest.mark.parametrize(
    "raw",
    [
        "60 to 140 um", "60:140um", "60um:0.14mm", "0.06:0.14 mm", "0.06-0.14 mm", "0,06-0,14 mm",
        "0,06–0,14 mm", "60 bis 140 µm", "60…140 µm", "60..140 um", "0.06 mm - 0.14 mm", "60 um to 140",
        "between 60 and 140 um", "(60 to 140) um", ["60 um", "140 um"], ["60", "140 um"],
        "100 ± 40 um", "100 um +/- 40", "(100 ± 40) um", "0.1 mm +0.04/-0.04", "0.1 mm ± 40 %",
        "0,1 mm +40 µm −40 µm", {"range": ["60 um", "140 um"]}, {"value": "60 to 140 um"},
        {"value": "0.1 mm", "range": "60 to 140 um"},
    ],
)  # fmt: skip
def test_one_play_between_60_and_140_um_however_it_is_written(raw: object):
    assert stated(raw) == pytest.approx((100e-6, 60e-6, 140e-6), rel=1e-12)


@pytest.mark.parametrize(
    ("raw", "path", "value", "least", "greatest"),
    [
        ("32.83 -0.05/-0.08 mm", "pinion.span", 32.765e-3, 32.75e-3, 32.78e-3),
        ("32,83 mm −50/−80 µm", "pinion.span", 32.765e-3, 32.75e-3, 32.78e-3),
        ("25 0/-0.05 mm", "pinion.bore", 24.975e-3, 24.95e-3, 25e-3),
        ("0.1 mm +0.04/-0.02", "mesh.backlash", 100e-6, 80e-6, 140e-6),
        ("100 um +40/-20", "mesh.backlash", 100e-6, 80e-6, 140e-6),
        ({"value": "80 um", "range": ["60 um", "140 um"]}, "mesh.backlash", 80e-6, 60e-6, 140e-6),
        ("150 N·m ± 10 %", "operation.torque", 150.0, 135.0, 165.0),
        ("-250 to -50 N·m", "operation.torque", -150.0, -250.0, -50.0),
        ("-70--30um", "pinion.thickness_allowance", -50e-6, -70e-6, -30e-6),
        ("±20 um", "mesh.centre_distance_deviation", 0.0, -20e-6, 20e-6),
        ("0.02:0.05", "mesh.damping_ratio", 0.035, 0.02, 0.05),
        ([0.02, 0.05], "mesh.damping_ratio", 0.035, 0.02, 0.05),
        ("0.05 ± 10 %", "mesh.damping_ratio", 0.05, 0.045, 0.055),
        ("5 % ± 1 %", "mesh.damping_ratio", 0.05, 0.04, 0.06),
        ("3e8-4e8 N/m", "mesh.mean_stiffness", 3.5e8, 3e8, 4e8),
        ("3.2·10^8 N/m ± 5 %", "mesh.mean_stiffness", 3.2e8, 3.04e8, 3.36e8),
        ("30 to 50 kW", "operation.power", 40e3, 30e3, 50e3),
        ("60 ± 10 °C", "pinion.temperature", 60.0, 50.0, 70.0),
        ("1 1/4 to 1 1/2 in", "pinion.bore", 1.375 * 25.4e-3, 1.25 * 25.4e-3, 1.5 * 25.4e-3),
    ],
)
def test_sizes_with_deviations_and_limits_of_other_quantities(
    raw: object, path: str, value: float, least: float, greatest: float
):
    assert stated(raw, path) == pytest.approx((value, least, greatest), rel=1e-12)


@pytest.mark.parametrize(
    "text", ["100 um", "1-1/2 in", "1e-4 m", "23e-6 K-1", "150 N-m", "-70 -30 um", "60 to um", "60:80:100 um"]
)
def test_texts_without_two_limits(text: str):
    """What reads as one value is one, wherever it has a hyphen."""
    path = "pinion.thermal_expansion" if "K" in text else "operation.torque" if "N" in text else "pinion.bore"
    try:
        assert read_stated(text, PLACES[path]).least is None
    except ValueRefusedError:
        assert ends_of(text) is None


def test_that_a_value_is_the_middle_of_its_limits_is_told():
    assert read_stated("60 to 140 um", BACKLASH).reason == "the middle of its limits"
    assert read_stated("100 um +40/-20", BACKLASH).reason == ""
    outside = read_stated("32.83 -0.05/-0.08 mm", SPAN)
    assert outside.reason == "the middle of its limits, as 32.83 mm does not lie between them"
    own = {"range": ["60 um", "140 um"], "provenance": "inferred", "reason": "sheet 12"}
    assert read_stated(own, BACKLASH).reason == "sheet 12; the middle of its limits"
    assert read_stated(own, BACKLASH).provenance == "inferred"


@pytest.mark.parametrize(
    ("raw", "path", "expected", "nearest"),
    [
        ("140 to 60 um", "mesh.backlash", "the smaller one first", "60 um to 140 um"),
        ("60 to 60 um", "mesh.backlash", "two different limits", None),
        (["60 um", "70 um", "80 um"], "mesh.backlash", "or two limits", None),
        ("60/140 um", "mesh.backlash", "two limits stand without a stroke", "60 um to 140 um"),
        ("-50/-80 um", "pinion.thickness_allowance", "without a stroke", "-80 um to -50 um"),
        ("60 to 140", "mesh.backlash", "each a length with its unit, such as", "60 um to 140 um"),
        ("0.06:0.14", "mesh.backlash", "'0.06' is none", "0.06 mm to 0.14 mm"),
        ("60 um to 140 N", "mesh.backlash", "that is a force", None),
        ("100 um ± 20 N", "mesh.backlash", "no part of a size in another unit", None),
        ("-10 to 140 um", "mesh.backlash", "from 0 um", None),
        ("30 to 50 kW", "operation.torque", "that is a power, which stands at operation.power", None),
        (
            {"value": "150 um", "range": ["60 um", "140 um"]},
            "mesh.backlash",
            "a value within its range",
            None,
        ),
        ({"value": "60 to 80 um", "range": ["60 um", "140 um"]}, "mesh.backlash", "a length with", None),
        ({"range": "60 um"}, "mesh.backlash", "a range of two limits", None),
        ({"value": "steel", "range": ["a", "b"]}, "pinion.material", "names have no limits", None),
        ("25 to 27", "pinion.teeth", "any value between", None),
        ("3 ± 0.1 mm", "mesh.normal_module", "told by tooth thickness", "3 mm"),
        ("15 to 16 deg", "mesh.helix_angle", "told by tooth thickness", None),
        ("128 ± 0.02 mm", "mesh.centre_distance", "mesh.centre_distance_deviation", "128 mm"),
        ("1500 to 4500 rpm", "operation.pinion_speed", "operation.least_speed", None),
        ("1500:4500rpm", "operation.gear_speed", "operation.least_speed", None),
        ("0.5 to 1.4", "dimensionless.omega", "--over", None),
        (["40 um", "60 um"], "model.reference_length", "all lengths are told in it", None),
    ],
)
def test_limits_that_cannot_be(raw: object, path: str, expected: str, nearest: str | None):
    with pytest.raises(ValueRefusedError) as refused:
        read_stated(raw, PLACES[path])
    assert expected in refused.value.expected
    assert refused.value.nearest == nearest
    if nearest is not None:
        read_stated(nearest, PLACES[path])


def test_what_is_nearest_to_a_wrong_name_in_a_table():
    with pytest.raises(ValueRefusedError) as refused:
        read_stated({"value": "80 um", "rang": ["60 um", "140 um"]}, BACKLASH)
    assert refused.value.nearest == "range"


def test_limits_of_a_case():
    """They change no number of the model; values have them, in another process too, and the hash does."""
    plain, limited = (gl.load_case(DRIVE, {"backlash": text}) for text in ("100 um", "60 to 140 um"))
    assert limited.family()[0].defaults == plain.family()[0].defaults
    value = next(v for v in limited.values() if v.path == "mesh.backlash")
    assert (value.value, value.least, value.greatest) == (100.0, 60.0, 140.0)
    assert value.limited
    assert not value.estimated
    again = gl.Case.from_json(limited.to_json())
    assert again.values() == limited.values()
    assert again.hash == limited.hash != plain.hash
    assert "least" not in json.loads(plain.to_json())["entries"][0]
    assert (
        limited.with_overrides({"backlash": "80 um"}).hash == plain.with_overrides({"backlash": "80 um"}).hash
    )


@pytest.mark.parametrize("raw", ["6 to 10 um", ["6 um", "10 um"], {"value": "8 um", "range": "6 to 10 um"}])
def test_a_short_name_means_the_quantity_that_has_the_unit_of_its_limits(raw: object):
    case = gl.load_case(DRIVE, {"error": raw})
    assert next((v.value, v.least, v.greatest) for v in case.values() if v.path == "mesh.error") == (8, 6, 10)


def test_a_value_to_vary_or_to_begin_at_is_one():
    with pytest.raises(gl.CaseError, match="here stands one value"):
        gl.load_case(DRIVE).resolve("torque", "50 to 250 N·m")


def test_a_parameter_of_a_system_of_its_own_has_no_limits():
    text = DRIVE.with_name("soft-stop.toml").read_text()
    assert "zeta = 0.01" in text
    with pytest.raises(gl.CaseError, match="limits are looked at of gear pairs alone"):
        loads(text.replace("zeta = 0.01", 'zeta = "0.005 to 0.02"'))


def test_the_schema_of_a_file_has_limits_where_they_may_stand():
    parts = kind_named("helical-pair").schema({})
    mesh, pinion = (parts[f"helical-pair_{table}"]["properties"] for table in ("mesh", "pinion"))
    *plain, limits, table = mesh["backlash"]["anyOf"]
    assert (limits["type"], limits["minItems"], limits["maxItems"]) == ("array", 2, 2)
    assert limits["items"] == {"anyOf": plain}
    assert limits in table["properties"]["range"]["anyOf"]
    assert table["anyOf"] == [{"required": ["value"]}, {"required": ["range"]}]
    for one in (pinion["teeth"], pinion["material"], mesh["normal_module"], mesh["centre_distance"]):
        *_, table = one["anyOf"]
        assert all(part.get("type") != "array" for part in one["anyOf"])
        assert "range" not in table["properties"]
        assert table["required"] == ["value"]
