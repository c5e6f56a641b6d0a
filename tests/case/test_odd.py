"""Values that do not fit to each other, or to usual gears, are told."""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest

import gearlash as gl

DRAWING = Path(__file__).resolve().parents[1] / "cases" / "drawing.toml"


@pytest.mark.parametrize(
    ("values", "path", "said"),
    [
        ({"backlash": "5 mm"}, "mesh.backlash", "usual fits"),
        ({"pinion.face_width": "900 mm"}, "pinion.face_width", "times the reference diameter"),
        ({"least_speed": "5000 rpm", "greatest_speed": "6000 rpm"}, "operation.least_speed", "outside"),
        ({"least_speed": "1000 rpm", "greatest_speed": "4000 rpm"}, "operation.greatest_speed", "outside"),
        (
            {"pinion.thickness_allowance": "-200 um", "gear.thickness_allowance": "-200 um"},
            "mesh.backlash", "leave 375.9 µm",
        ),
    ],
)  # fmt: skip
def test_it_is_told(values: dict[str, str], path: str, said: str):
    before = {note.path for note in gl.load_case(DRAWING).notes()}
    assert path not in before
    told = [note.text for note in gl.load_case(DRAWING, values).notes() if note.path == path]
    assert len(told) == 1
    assert said in told[0]


THIN = {"pinion.shaft_diameter": "20 mm", "pinion.bearing_span": "300 mm"}


@pytest.mark.parametrize(
    ("values", "told"),
    [
        (THIN, True),
        ({**THIN, "pinion.shaft_stiffness_y": "4e6 N/m"}, False),
        ({**THIN, "pinion.bearing_stiffness_y": "4e6 N/m"}, False),
        ({**THIN, "pinion.bearing_span": "80 mm"}, False),
        ({"pinion.shaft_diameter": "20 mm"}, False),
    ],
)
def test_a_thin_shaft_that_is_not_part_of_its_bearings_is_told(values: dict[str, str], told: bool):
    """By hand: 48 E I over the cube of the 260 mm that are beside the 40 mm of face, E = 206 GPa."""
    texts = [
        note.text for note in gl.load_case(DRAWING, values).notes() if note.path == "pinion.bearing_span"
    ]
    assert len(texts) == told
    bends = 48.0 * 206e9 * pi * 0.02**4 / 64.0 / 0.26**3
    assert all(
        f"bends with {bends:.3g} N/m" in text and "state pinion.shaft_stiffness_y" in text for text in texts
    )


THOUSANDS = (
    ({"pinion.density": "7.850 kg/m^3"}, "7850"),
    ({"gear.youngs_modulus": "206.000 MPa"}, "206000"),
    ({"operation.pinion_speed": "1.475 rpm"}, "1475"),
    ({"operation.torque": "1.525 N m"}, "1525"),
    ({"operation.torque": "-1.500 N m"}, "-1500"),
    ({"mesh.mean_stiffness": "800.000 N/mm"}, "800000"),
    ({"pinion.bearing_stiffness_y": "300.000 N/mm"}, "300000"),
    ({"pinion.density": "7.850 g/cm^3"}, ""),
    ({"pinion.youngs_modulus": "206.000 GPa"}, ""),
    ({"operation.torque": "150.000 N m"}, ""),
    ({"mesh.mean_stiffness": "820.000 N/um"}, ""),
    ({"mesh.backlash": "80.000 um"}, ""),
    ({"pinion.face_width": "40.000 mm"}, ""),
    ({"gear.tip_relief": "20.000 um"}, ""),
    ({"pinion.mass": "1.475 kg"}, ""),
    ({"mesh.helix_angle": "15.000 deg"}, ""),
)


@pytest.mark.parametrize(("values", "thousands"), THOUSANDS)
def test_thousands_with_a_point_are_told_where_they_would_be_usual(values: dict[str, str], thousands: str):
    notes = [n.text for n in gl.load_case(DRAWING, values).notes() if n.path in values]
    told = [text for text in notes if "is read with a decimal point" in text]
    assert len(told) == bool(thousands)
    if told:
        assert told[0].endswith(f"without one, {thousands}")


def test_thousands_of_a_speed_are_told_of_a_pair_without_a_drawing():
    notes = gl.load_case("article", {"pinion_speed": "3.600 rpm"}).notes()
    assert any(n.path == "operation.pinion_speed" and "3600" in n.text for n in notes)


@pytest.mark.parametrize(
    ("leaf", "text", "told"),
    [
        ("youngs_modulus", "206 MPa", "0.206 GPa; materials of the list have 0.9 to 212 GPa"),
        ("youngs_modulus", "2060 GPa", "2060 GPa; materials"),
        ("density", "7.83 kg/m^3", "7.83 kg/m³; materials of the list have 1140 to 8800 kg/m³"),
        ("density", "78300 kg/m^3", "7.83e+04 kg/m³; materials"),
        ("youngs_modulus", "195 GPa", ""),
        ("density", "7.9 g/cm^3", ""),
    ],
)
def test_values_of_no_listed_material_are_told(leaf: str, text: str, told: str):
    path = f"gear.{leaf}"
    notes = [n.text for n in gl.load_case(DRAWING, {path: text}).notes() if n.path == path]
    assert [each.startswith(told) for each in notes] == [True] * bool(told)


@pytest.mark.parametrize(
    ("values", "told"),
    [
        ({"pinion.shaft_diameter": "300 mm"}, "not below the root diameter of the pinion"),
        ({"pinion.shaft_diameter": "1 um"}, "of shear"),
        ({"gear.bore": "4 mm"}, "of shear"),
        ({"gear.bore": "4 mm", "gear.shaft_diameter": "45 mm"}, ""),
        ({"pinion.shaft_diameter": "25 mm"}, ""),
    ],
)
def test_shafts_that_no_such_gear_has_are_told(values: dict[str, str], told: str):
    notes = [
        n.text for n in gl.load_case(DRAWING, values).notes() if n.path.endswith(("shaft_diameter", "bore"))
    ]
    assert [told in text for text in notes] == [True] * bool(told)


@pytest.mark.parametrize(
    ("text", "hand"), [("L15°", "left"), ("15° (RH)", "right"), ("15 LH", "left"), ("15 deg", "")]
)
def test_the_hand_that_stands_beside_an_angle_is_told(text: str, hand: str):
    found = gl.load_case(DRAWING, {"helix_angle": text}).notes()
    told = [n.text for n in found if n.path == "mesh.helix_angle" and "hand helix" in n.text]
    assert [f"a {hand}-hand helix of the pinion" in each for each in told] == [True] * bool(hand)


def test_a_name_in_other_letters_is_no_other_name():
    path = "gear.material"
    for name, own, told in (
        ("pom", {}, ""),
        ("Brass", {}, ""),
        ("Delrin", {}, "1410 kg/m³; youngs_modulus, poisson_ratio and density may be stated beside it"),
        (
            "Delrin",
            {"gear.youngs_modulus": "3 GPa"},
            "for POM: ν 0.35, 1410 kg/m³; poisson_ratio and density may",
        ),
    ):
        notes = [n.text for n in gl.load_case(DRAWING, {path: name, **own}).notes() if n.path == path]
        assert [told in text for text in notes] == [True] * bool(told), name


def test_a_rotor_without_its_mass_is_told():
    """Of a pair on bearings only, and not where the mass is stated or the rotor is lighter than the gear."""
    rotor, told = (
        {"pinion.added_inertia": "0.8 kg*m^2"},
        "the mass on its bearings is that of the pinion alone",
    )
    light, massive = {"pinion.added_inertia": "1e-5 kg*m^2"}, rotor | {"pinion.mass": "60 kg"}
    beside = rotor | {"pinion.added_mass": "55 kg"}
    for values, expected in ((rotor, True), (light, False), (massive, False), (beside, False)):
        notes = [n.text for n in gl.load_case(DRAWING, values).notes() if n.path == "pinion.added_inertia"]
        assert [told in text for text in notes] == [True] * expected


def test_teeth_that_leave_the_stated_play_are_not():
    thin = {f"{gear}.thickness_allowance": "-42.6 um" for gear in ("pinion", "gear")}
    case = gl.load_case(DRAWING, thin)
    assert not any(note.path == "mesh.backlash" for note in case.notes())


def test_a_range_where_one_value_is_wanted():
    case = gl.load_case(DRAWING)
    for text in ("60um..140um", "60:140um", "60 to 140 um", "100±40 um"):
        with pytest.raises(gl.CaseError, match="with --limits"):
            case.resolve("backlash", text)
