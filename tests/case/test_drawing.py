"""Cases from drawings: what is missing is estimated, marked and ranged; what is stated is kept."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from gearlash.case import Case, CaseError, load, loads
from gearlash.gears import CylindricalGear, CylindricalPair, inspection
from gearlash.system import UnknownNameError

TEXT = (Path(__file__).parents[1] / "cases" / "drawing.toml").read_text(encoding="utf-8")


def values(case: Case) -> dict[str, Any]:
    return {v.path: v for v in case.values()}


def test_a_drawing_is_a_case_and_its_estimates_are_marked_with_range_and_source():
    found = values(loads(TEXT))
    for path in ("mesh.mean_stiffness", "mesh.ripple", "mesh.error", "mesh.damping_ratio", "pinion.mass",
                 "pinion.inertia", "gear.bearing_stiffness_z", "bearings.damping_ratio"):  # fmt: skip
        value = found[path]
        assert value.provenance == "assumed"
        assert value.least < value.value < value.greatest, path
        assert value.reason
        assert value.text == ""
    assert found["mesh.backlash"].provenance == "given"
    assert found["mesh.mean_stiffness"].value == pytest.approx(8.1356e8, rel=1e-4)


def test_what_is_stated_is_not_estimated():
    case = loads(TEXT, {"mesh.mean_stiffness": "4e8 N/m", "pinion.mass": "2.6 kg", "ripple": 0.12})
    found = values(case)
    assert found["mesh.mean_stiffness"].value == 4e8
    assert found["pinion.mass"].least is None
    assert found["pinion.inertia"].least is not None  # of the drawn body, whatever it weighs
    assert found["mesh.ripple_2"].least is not None  # one harmonic that is set leaves the others
    stated = values(loads(TEXT.replace("[mesh]", "[mesh]\nripple = 0.12")))
    assert "mesh.ripple_2" not in stated  # one that a file states has no others
    assert found["gear.inertia"].least is not None


@pytest.mark.parametrize("name", ["mesh.error", "error"])
def test_a_stated_amplitude_of_the_error_leaves_its_phase_unknown(name: str):
    shown = {"mesh.error": "21.9 um", "error": 0.5}[name]
    case = loads(TEXT, {name: shown})
    phase = values(case)["mesh.error_phase"]
    assert (phase.value, phase.least, phase.greatest) == pytest.approx((90.0, -180.0, 180.0))
    assert phase.provenance == "assumed"
    assert values(case)["mesh.error"].least is None
    known = values(loads(TEXT, {name: shown, "mesh.error_phase": "30 deg"}))["mesh.error_phase"]
    assert (known.value, known.provenance) == (pytest.approx(30.0), "given")


def test_contact_ratios_are_those_of_the_shifted_teeth():
    case = loads(TEXT, {"pinion.profile_shift": 0.4, "gear.profile_shift": 0.3})
    teeth, found = case.numbers.body.teeth, values(case)
    for what in ("transverse_contact_ratio", "overlap_ratio", "total_contact_ratio"):
        assert found[f"derived.{what}"].value == pytest.approx(getattr(teeth, what), rel=1e-12), what
    plain = values(loads(TEXT))["derived.transverse_contact_ratio"].value
    assert found["derived.transverse_contact_ratio"].value < 0.97 * plain


def test_a_mean_stiffness_is_compared_where_it_is_stated_and_with_its_materials():
    plastic = {"gear.material": "POM"}
    estimated = loads(TEXT, plastic)
    assert not [note for note in estimated.notes() if note.path == "mesh.mean_stiffness"]
    own = values(estimated)["mesh.mean_stiffness"].value
    same = loads(TEXT, {**plastic, "mesh.mean_stiffness": f"{own} N/m"})
    assert not [note for note in same.notes() if note.path == "mesh.mean_stiffness"]
    (note,) = [
        note
        for note in loads(TEXT, {**plastic, "mesh.mean_stiffness": "8e8 N/m"}).notes()
        if note.path == "mesh.mean_stiffness"
    ]
    assert "of steel and POM" in note.text
    assert "softer" in note.text


@pytest.mark.parametrize(
    ("stated", "path", "limit"),
    [
        ({"pinion.bore": "60 mm"}, "pinion.bore", "root diameter"),
        ({"gear.bore": "400 mm"}, "gear.bore", "root diameter"),
        ({"gear.rim_diameter": "400 mm"}, "gear.rim_diameter", "root diameter"),
        ({"gear.rim_diameter": "120 mm", "gear.bore": "130 mm"}, "gear.bore", "of its rim, 120 mm"),
    ],
)
def test_a_body_that_leaves_no_gear_is_told_by_its_own_word(stated: dict[str, str], path: str, limit: str):
    small = {"pinion.bore": "60 mm"}
    teeth = {"pinion.teeth": 16, "gear.teeth": 57} if stated == small else {}
    with pytest.raises(CaseError) as refused:
        loads(TEXT, {**teeth, **stated})
    (problem,) = refused.value.problems
    assert problem.path == path
    assert limit in problem.expected


def test_estimates_follow_an_override_and_the_unit_of_length_does_not():
    text = TEXT.replace('backlash = "80 um"\n', "")
    case = loads(text)
    play = values(case)["mesh.backlash"]
    assert play.least < play.value < play.greatest
    assert case.family()[0].defaults["D"] == pytest.approx(1.0)
    fitted = case.with_overrides({"pinion.fit": "27b", "gear.fit": "27b"})
    assert fitted.scales.length == case.scales.length
    assert fitted.family()[0].defaults["D"] > 1.5
    wide = case.with_overrides({"pinion.face_width": "60 mm", "gear.face_width": "60 mm"})
    assert values(wide)["mesh.mean_stiffness"].value > 1.3 * values(case)["mesh.mean_stiffness"].value


def test_a_case_travels_with_its_drawing():
    case = loads(TEXT)
    again = Case.from_json(case.to_json())
    assert again == case
    assert again.family()[0].defaults == case.family()[0].defaults


def test_speed_torque_and_power_of_either_side_are_one():
    base = loads(TEXT).family()[0].defaults
    ratio = 57 / 25
    by_gear = TEXT.replace('pinion_speed = "4200 rpm"', f'gear_speed = "{4200 / ratio!r} rpm"').replace(
        'torque = "150 N m"', f'gear_torque = "{150 * ratio!r} N m"'
    )
    assert loads(by_gear).family()[0].defaults["omega"] == pytest.approx(base["omega"], rel=1e-12)
    assert loads(by_gear).family()[0].defaults["load"] == pytest.approx(base["load"], rel=1e-12)
    power = 150 * 4200 * 3.141592653589793 / 30
    by_power = TEXT.replace('torque = "150 N m"', f'power = "{power!r} W"')
    assert loads(by_power).family()[0].defaults["load"] == pytest.approx(base["load"], rel=1e-12)
    with pytest.raises(CaseError, match="one of two that name the same quantity"):
        loads(TEXT.replace("[operation]", '[operation]\npower = "20 kW"'))
    replaced = loads(by_power, {"torque": "100 N m"})
    assert replaced.scales.torque(replaced.family()[0].defaults["load"]) == pytest.approx(100)


def test_a_circumferential_backlash_is_turned_into_the_normal_one():
    text = TEXT.replace('backlash = "80 um"', 'backlash_circumferential = "80 um"')
    play = values(loads(text))["mesh.backlash"]
    assert play.provenance == "inferred"
    assert play.value == pytest.approx(80 * 0.9076734, rel=1e-6)  # cos α_n cos β: no profile shift


def test_profile_shift_by_span_balls_or_centre_distance():
    gears = [CylindricalGear(z, 3e-3, profile_shift=x) for z, x in ((25, 0.3), (57, 0.1))]
    pair = CylindricalPair(gears[0], gears[1])
    span = inspection.span_measurement(gears[0], 4)
    balls = inspection.dimension_over_balls(gears[1], 5e-3)
    text = (
        TEXT.replace('helix_angle = "15 deg"', f'centre_distance = "{pair.centre_distance * 1e3!r} mm"')
        .replace('"helical-pair"', '"spur-1dof"')
        .replace("quality = 7", f'span = "{span * 1e3!r} mm"\nspan_teeth = 4')
    )
    found = values(loads(text))
    assert found["pinion.profile_shift"].value == pytest.approx(0.3, abs=1e-9)
    assert found["gear.profile_shift"].value == pytest.approx(0.1, abs=1e-9)
    measured = text.replace("bore", f'over_balls = "{balls * 1e3!r} mm"\nball_diameter = "5 mm"\nbore')
    assert values(loads(measured))["gear.profile_shift"].value == pytest.approx(0.1, abs=1e-9)


def test_a_measure_beside_a_stated_shift_is_the_allowance():
    gear = CylindricalGear(25, 3e-3, profile_shift=0.2, thickness_allowance=-70e-6)
    span = inspection.span_measurement(gear, 4)
    text = (
        TEXT.replace('helix_angle = "15 deg"\n', "")
        .replace('"helical-pair"', '"spur-1dof"')
        .replace('backlash = "80 um"\n', "")
        .replace("quality = 7", f'profile_shift = 0.2\nspan = "{span * 1e3!r} mm"\nspan_teeth = 4')
    )
    found = values(loads(text))
    assert found["pinion.thickness_allowance"].value == pytest.approx(-70, abs=1e-6)
    assert "stated tooth thickness" in found["mesh.backlash"].reason


@pytest.mark.parametrize("name", ["module", "normal_module"])
@pytest.mark.parametrize("kind", ["helical-pair", "spur-1dof"])
def test_both_names_of_the_module_are_understood(kind, name):
    text = TEXT.replace('"helical-pair"', f'"{kind}"').replace("normal_module", name)
    text = text if kind == "helical-pair" else text.replace('helix_angle = "15 deg"\n', "")
    assert loads(text).numbers.body.geometry.normal_module == 3e-3


@pytest.mark.parametrize(
    ("old", "new", "path", "word"),
    [
        ('material = "steel"', 'material = "stel"', "pinion.material", "steel"),
        ("quality = 7", "quality = 17", "pinion.quality", "from 1 to 12"),
        ('bore = "50 mm"', 'bore = "500 mm"', "gear.bore", "root diameter"),
        (
            'backlash = "80 um"',
            'backlash = "80 um"\ncentre_distance = "100 mm"',
            "mesh.centre_distance",
            "base circles",
        ),
        ('backlash = "80 um"', 'shift_sum = 2\ncentre_distance = "130 mm"', "mesh.shift_sum", "one of two"),
    ],
)
def test_what_no_drawing_can_say_is_told(old, new, path, word):
    assert old in TEXT
    with pytest.raises(CaseError) as told:
        loads(TEXT.replace(old, new))
    (problem,) = told.value.problems
    assert problem.path == path
    assert word in f"{problem.expected} {problem.nearest}"


def test_files_without_words_of_a_drawing_mean_what_they_meant():
    case = load(Path(__file__).parents[1] / "cases" / "drive.toml")
    assert not [v.path for v in case.values() if v.least is not None]
    assert case.numbers.body.teeth is None


def test_a_range_of_speed_has_two_ends_in_order_and_does_not_vary():
    ends = {"least_speed": "2000 rpm", "greatest_speed": "5000 rpm"}
    case = loads(TEXT, ends)
    assert values(case)["operation.greatest_speed"].value == pytest.approx(5000)
    assert case.family()[0].defaults == loads(TEXT).family()[0].defaults
    with pytest.raises(UnknownNameError):
        case.varying("least_speed")
    with pytest.raises(CaseError, match=r"operation\.greatest_speed beside it"):
        loads(TEXT, {"least_speed": "2000 rpm"})
    with pytest.raises(CaseError, match=r"more than operation\.least_speed = 6000 rpm"):
        loads(TEXT, {**ends, "least_speed": "6000 rpm"})


def test_what_does_not_follow_from_an_assumption_is_not_said_to_rest_on_it():
    """Neither pressure angle nor profile shifts are stated: circles that need neither carry no mark."""
    case = loads(
        'kind = "spur-1dof"\n[pinion]\nteeth = 21\nface_width = "80 mm"\n'
        '[gear]\nteeth = 94\nface_width = "80 mm"\n'
        '[mesh]\nnormal_module = "8 mm"\ncentre_distance = "461 mm"\n'
        '[operation]\npinion_speed = "1480 rpm"\ntorque = "1800 N m"\n'
    )
    rests = {value.path: value.rests_on for value in case.values() if value.provenance == "derived"}
    free = (
        "centre_distance", "transverse_module", "reference_diameter_pinion", "working_diameter_gear",
        "tangential_force", "working_tangential_force", "line_load", "pitch_line_speed",
    )  # fmt: skip
    assert [leaf for leaf in free if rests[f"derived.{leaf}"]] == []
    for leaf in ("base_diameter_gear", "radial_force", "normal_force", "working_pressure_angle"):
        assert "mesh.pressure_angle" in rests[f"derived.{leaf}"]
    turned = case.with_overrides({"mesh.pressure_angle": "22.5 deg"})
    values, other = ({v.path: v.value for v in each.values()} for each in (case, turned))
    assert all(
        values[f"derived.{leaf}"] == pytest.approx(other[f"derived.{leaf}"], rel=1e-12) for leaf in free
    )
    assert values["derived.base_diameter_gear"] != other["derived.base_diameter_gear"]
