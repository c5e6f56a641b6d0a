"""Teeth that cannot run are refused with a value that can; unusual ones are told, and run."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from gearlash.case import Case, CaseError, loads

TEXT = (Path(__file__).parents[1] / "cases" / "drawing.toml").read_text(encoding="utf-8")
SPUR = TEXT.replace('kind = "helical-pair"', 'kind = "spur-1dof"').replace('helix_angle = "15 deg"\n', "")
SPUR = SPUR.replace("normal_module", "module")


def refused(text: str, stated: dict[str, object]) -> list[str]:
    with pytest.raises(CaseError) as told:
        loads(text, stated)
    return [str(problem) for problem in told.value.problems]


def notes(stated: dict[str, object], text: str = TEXT) -> dict[str, str]:
    return {note.path: note.text for note in loads(text, stated).notes()}


def ratio(case: Case) -> float:
    return next(float(v.value) for v in case.values() if v.path == "derived.transverse_contact_ratio")


def test_without_backlash_the_unit_of_length_is_a_hundredth_of_the_module():
    case = loads(TEXT.replace('backlash = "80 um"', 'backlash = "0 um"'))
    assert case.scales.length_um(1.0) == pytest.approx(30.0)
    assert case.entries["model.reference_length"].reason.startswith("a hundredth of the module")


def test_tips_too_short_to_mesh_are_told_how_long_they_must_be():
    (told,) = refused(SPUR, {"pinion.tip_diameter": "76 mm", "gear.tip_diameter": "172 mm"})
    sizes = [float(text) for text in re.findall(r"([\d.]+) mm of the", told)]
    assert "1 is the least" in told
    case = loads(
        SPUR, {"pinion.tip_diameter": f"{sizes[0] + 0.01} mm", "gear.tip_diameter": f"{sizes[1]} mm"}
    )
    assert ratio(case) == pytest.approx(1.0, abs=0.003)


def test_axes_too_far_apart_are_told_how_near_they_must_be():
    standard: dict[str, object] = {"pinion.profile_shift": 0, "gear.profile_shift": 0}
    (told,) = refused(SPUR, {**standard, "mesh.centre_distance": "126 mm"})
    most = re.search(r"up to ([\d.]+) mm", told)
    assert most is not None
    case = loads(SPUR, {**standard, "mesh.centre_distance": f"{most[1]} mm"})
    assert 1.0 <= ratio(case) < 1.01


def test_an_undercut_pinion_that_does_not_mesh_is_told_its_profile_shift():
    (told,) = refused(SPUR, {"pinion.teeth": 8})
    assert told.startswith("pinion.teeth = '8'")
    least = re.search(r"profile shift of ([\d.]+)", told)
    assert least is not None
    assert "from 18 teeth on" in told
    assert ratio(loads(SPUR, {"pinion.teeth": 8, "pinion.profile_shift": float(least[1])})) > 1.0


def test_a_pointed_tooth_is_told_where_it_ends():
    (told,) = refused(TEXT, {"pinion.profile_shift": 2.9})
    most = re.search(r"up to ([\d.]+) mm the tip keeps", told)
    assert most is not None
    assert "no point" in told
    shortened = {"pinion.profile_shift": 0.9, "pinion.tip_diameter": f"{most[1]} mm"}
    assert any("no point" in each or "clearance" in each for each in refused(TEXT, shortened))


def test_stated_tips_in_the_root_of_the_mate_are_refused_and_others_told():
    (told,) = refused(TEXT, {"pinion.tip_diameter": "86 mm"})
    assert "reaches the root of the gear" in told
    far = notes({"pinion.profile_shift": 1.0, "gear.profile_shift": 1.0})
    assert "shortened as usual" in far["gear.tip_diameter"]


@pytest.mark.parametrize(
    ("stated", "word"),
    [
        ({"pinion.tip_diameter": "60 mm"}, "83.646 mm is usual"),
        ({"pinion.root_diameter": "90 mm"}, "70.146 mm is usual"),
        ({"pinion.root_diameter": "30 mm"}, "70.146 mm is usual"),
        ({"mesh.pressure_angle": "44 deg"}, "up to 32.1 deg"),
        ({"pinion.span": "20 mm", "pinion.span_teeth": 4}, "32.157 mm over 4 teeth without profile shift"),
        (
            {"pinion.profile_shift": 0.4, "pinion.span": "20 mm", "pinion.span_teeth": 4},
            "over 4 teeth with the stated profile shift 0.4",
        ),
        ({"pinion.over_balls": "50 mm"}, "without profile shift"),
        ({"mesh.centre_distance": "126 mm", "pinion.profile_shift": 0, "gear.profile_shift": 0},
         "they need 127.339 mm and more"),
        ({"mesh.backlash": "300 um", "pinion.material": "POM", "gear.material": "POM",
          "mesh.temperature": "80 degC"}, "more than 433.6 µm"),
    ],
)  # fmt: skip
def test_values_that_no_pair_has_are_refused_with_one_that_it_may_have(stated, word):
    text = TEXT
    if "centre" in str(stated):
        text = text.replace('backlash = "80 um"\n', "")
    told = refused(text, stated)
    assert len(told) == 1
    assert word in told[0]


@pytest.mark.parametrize("angle", [14.5, 25, 30])
def test_other_pressure_angles_have_a_rack_that_fits(angle):
    assert ratio(loads(TEXT, {"mesh.pressure_angle": f"{angle} deg"})) > 1.1


def test_what_is_unusual_is_told():
    assert notes({}) == {}
    assert "is undercut" in notes({"pinion.teeth": 12})["pinion.profile_shift"]
    assert "from 16 teeth on" in notes({"pinion.teeth": 12})["pinion.profile_shift"]
    assert "m_n; usual is 0.2 m_n" in notes({"pinion.profile_shift": 1.3})["pinion.tip_diameter"]
    overlap = notes({"mesh.helix_angle": "60 deg"})
    assert "only the overlap" in overlap["derived.transverse_contact_ratio"]


def test_plastics_are_told_what_the_estimates_leave_out():
    plastic = {"pinion.material": "POM", "gear.material": "PA66", "mesh.backlash": "1000 um"}
    found = notes({**plastic, "mesh.temperature": "60 degC", "operation.torque": "60 N m"})
    assert "POM at 60 °C is softer" in found["pinion.temperature"]
    assert "0.9 to 3.4 GPa" in found["gear.temperature"]
    assert "touch well before and behind the path of contact" in found["operation.torque"]
    assert "operation.torque" not in notes({**plastic, "operation.torque": "5 N m"})
