"""Dimensions, forces, speed and stiffness that a case tells beside the numbers of its model.

- Shigley: R. G. Budynas, J. K. Nisbett, Shigley's Mechanical Engineering Design, example 13-7: a helical
  pinion of 18 teeth, P_n = 12 per inch, 20°, 30°, that transmits 1 hp at 1800 rpm.
- KHK: a profile shifted helical pair of 12 and 60 teeth, as in `tests/gears/test_worked_examples.py`.
- ISO/TR 6336-30, example 1: c_γα as KISSsoft has it, as in `tests/gears/test_mesh_stiffness.py`.
"""

from __future__ import annotations

from math import asin, cos, hypot, pi, radians, sin, sqrt, tan

import pytest

from gearlash.case import CaseError, load, loads

POUND = 4.4482216152605  # N
HORSEPOWER = 745.69987  # W


def told(text: str) -> dict[str, float]:
    """Derived values by name."""
    found = loads(text).values()
    return {v.path.removeprefix("derived."): float(v.value) for v in found if v.path.startswith("derived.")}


SHIGLEY = f"""
kind = "helical-pair"
[pinion]
teeth = 18
quality = 7
face_width = "25 mm"
[gear]
teeth = 36
face_width = "25 mm"
[mesh]
diametral_pitch = 12
pressure_angle = "20 deg"
helix_angle = "30 deg"
[operation]
pinion_speed = "1800 rpm"
power = "{HORSEPOWER} W"
"""
KHK = """
kind = "helical-pair"
[pinion]
teeth = 12
profile_shift = 0.09809
[gear]
teeth = 60
profile_shift = 0.0
[mesh]
normal_module = "3 mm"
pressure_angle = "20 deg"
helix_angle = "30 deg"
centre_distance = "125 mm"
tips = "shortened"
face_width = "30 mm"
backlash = "80 um"
[operation]
pinion_speed = "1500 rpm"
torque = "200 N m"
"""
ISO = """
kind = "helical-pair"
[pinion]
teeth = 17
profile_shift = 0.145
tip_diameter = "159.66 mm"
[gear]
teeth = 103
profile_shift = 0.0
tip_diameter = "872.35 mm"
[mesh]
normal_module = "8 mm"
pressure_angle = "20 deg"
helix_angle = "15.8 deg"
centre_distance = "500 mm"
face_width = "100 mm"
rack = "ISO53-D"
[operation]
pinion_speed = "360 rpm"
torque = "9000 N m"
"""


def test_forces_and_speed_of_shigley():
    found = told(SHIGLEY)
    assert found["pitch_line_speed"] / 0.3048 * 60 == pytest.approx(816, abs=0.5)  # ft/min
    forces = [found[f"{name}_force"] / POUND for name in ("tangential", "radial", "axial")]
    assert forces == pytest.approx([40.4, 17.0, 23.3], abs=0.06)  # lbf
    assert found["working_tangential_force"] == pytest.approx(found["tangential_force"], rel=1e-9)


def test_dimensions_of_khk():
    found = told(KHK)
    printed = {
        "reference_diameter": (41.569, 207.846),
        "base_diameter": (38.322, 191.611),
        "working_diameter": (41.667, 208.333),
        "tip_diameter": (48.153, 213.842),
        "root_diameter": (34.657, 200.346),
    }
    for name, pair in printed.items():
        own = [found[f"{name}_{gear}"] for gear in ("pinion", "gear")]
        assert own == pytest.approx(pair, abs=1e-3), name
    assert found["centre_distance"] == pytest.approx(125.0)
    assert found["working_pressure_angle"] == pytest.approx(23.1126, abs=1e-4)


def test_the_transverse_section_of_khk():
    """Closed forms; the path of contact from tips and base circles."""
    found, normal, helix = told(KHK), radians(20), radians(30)
    assert found["transverse_module"] == pytest.approx(3.0 / cos(helix), rel=1e-12)
    assert tan(radians(found["transverse_pressure_angle"])) == pytest.approx(
        tan(normal) / cos(helix), rel=1e-12
    )
    assert sin(radians(found["base_helix_angle"])) == pytest.approx(sin(helix) * cos(normal), rel=1e-12)
    assert found["base_pitch"] == pytest.approx(pi * found["base_diameter_pinion"] / 12, rel=1e-12)
    tips = [
        sqrt(found[f"tip_diameter_{gear}"] ** 2 - found[f"base_diameter_{gear}"] ** 2) / 2
        for gear in ("pinion", "gear")
    ]
    length = 125.0 * sin(radians(found["working_pressure_angle"]))
    ends = [max(length - tips[1 - k], 0.0) for k in (0, 1)]
    assert found["path_of_contact"] <= sum(tips) - length + 1e-9
    assert found["transverse_contact_ratio"] == pytest.approx(
        found["path_of_contact"] / found["base_pitch"], rel=1e-9
    )
    for gear, roll in zip(("pinion", "gear"), ends, strict=True):
        active = hypot(found[f"base_diameter_{gear}"], 2.0 * roll)
        assert found[f"active_root_diameter_{gear}"] >= active - 1e-9
        assert found[f"root_form_diameter_{gear}"] >= found[f"base_diameter_{gear}"]


def test_forces_of_a_shifted_pair_make_the_normal_one():
    found = told(KHK)
    parts = (found[name] for name in ("working_tangential_force", "radial_force", "axial_force"))
    assert hypot(*parts) == pytest.approx(found["normal_force"], rel=1e-12)
    ratio = found["working_tangential_force"] / found["tangential_force"]
    assert ratio == pytest.approx(41.569 / 41.667, rel=3e-5)
    assert found["line_load"] == pytest.approx(2e3 * 200 / 41.569 / 30, rel=1e-4)


def test_the_stiffness_per_width_is_that_of_the_standard():
    assert told(ISO)["stiffness_per_width"] == pytest.approx(17.4553, rel=8e-4)
    stated = ISO.replace("[mesh]\n", '[mesh]\nmean_stiffness = "1e9 N/m"\n')
    beta_b = asin(sin(radians(15.8)) * cos(radians(20)))
    assert told(stated)["stiffness_per_width"] == pytest.approx(10.0 * cos(beta_b) ** 2, rel=1e-4)


def test_the_play_of_a_drawing_is_told_in_the_ways_it_is_measured():
    found = told(KHK)
    base = asin(sin(radians(30)) * cos(radians(20)))
    arc = 80.0 / (cos(radians(23.1126)) * cos(base))
    assert found["backlash_circumferential"] == pytest.approx(arc, rel=1e-5)
    assert found["backlash_radial"] == pytest.approx(arc / 2 / tan(radians(23.1126)), rel=1e-5)
    angle = 2e-3 * arc / 208.333  # rad
    assert radians(found["backlash_angle_gear"] / 60) == pytest.approx(angle, rel=1e-5)


def test_a_ball_that_does_not_rest_on_both_flanks_has_no_dimension():
    found = told(KHK.replace("[gear]", 'ball_diameter = "12 mm"\n[gear]'))
    assert "over_balls_pinion" not in found
    assert found["over_balls_gear"] > found["tip_diameter_gear"]


def test_what_a_dimensionless_case_does_not_know_is_not_told():
    paths = {value.path for value in load("kahraman-singh").values()}
    assert not {path for path in paths if path.endswith(("_force", "_diameter_gear", "_per_width"))}


@pytest.mark.parametrize(
    "text", [KHK, KHK.replace("helical-pair", "spur-1dof").replace('helix_angle = "30 deg"', "")]
)
def test_what_turns_with_a_gear_counts_with_its_inertia(text: str):
    """The equivalent mass and the natural frequencies are those of the sum, stated in one number."""
    text = text.replace('centre_distance = "125 mm"\n', "")
    own = {v.path: float(v.value) for v in loads(text).values() if v.path.endswith(".inertia")}
    added = text.replace("[gear]", '[gear]\nadded_inertia = "0.02 kg m^2"')
    whole = text.replace("[gear]", f'[gear]\ninertia = "{own["gear.inertia"] + 0.02!r} kg m^2"')
    one, other, bare = told(added), told(whole), told(text)
    assert one["equivalent_mass"] == pytest.approx(other["equivalent_mass"], rel=1e-12)
    assert one["equivalent_mass"] > 1.001 * bare["equivalent_mass"]
    frequency = [found["natural_frequency_1_hz"] for found in (one, other)]
    assert frequency[0] == pytest.approx(frequency[1], rel=1e-12)
    reasons = {v.path: v.reason for v in loads(text).values()}
    assert "of the gear alone" in reasons["pinion.inertia"]


def test_what_bearings_carry_with_a_gear_counts_with_its_mass():
    """Frequencies of the sum; the inertia of the gear stays its own; without bearings it is refused."""
    mass = next(float(v.value) for v in loads(KHK).values() if v.path == "gear.mass")
    inertia = next(float(v.value) for v in loads(KHK).values() if v.path == "gear.inertia")
    added = told(KHK.replace("[gear]", '[gear]\nadded_mass = "2 kg"'))
    own = f'[gear]\nmass = "{mass + 2.0!r} kg"\ninertia = "{inertia!r} kg m^2"'
    whole, bare = told(KHK.replace("[gear]", own)), told(KHK)
    names = [name for name in bare if name.startswith("natural_frequency")]
    assert [added[name] for name in names] == pytest.approx([whole[name] for name in names], rel=1e-9)
    assert any(added[name] < 0.9 * bare[name] for name in names)
    assert added["equivalent_mass"] == bare["equivalent_mass"]
    spur = KHK.replace("helical-pair", "spur-1dof").replace('helix_angle = "30 deg"', "")
    with pytest.raises(CaseError, match=r"this kind of pair has no bearings"):
        loads(spur.replace("[gear]", '[gear]\nadded_mass = "2 kg"'))


def test_what_turns_with_a_gear_is_no_part_of_a_stated_equivalent_mass():
    text = """
kind = "spur-1dof"
[pinion]
teeth = 20
added_inertia = "0.001 kg m^2"
[mesh]
equivalent_mass = "0.23 kg"
mean_stiffness = "4e8 N/m"
damping_ratio = 0.05
backlash = "100 um"
[operation]
pinion_speed = "3600 rpm"
[dimensionless]
load = 0.1
"""
    with pytest.raises(CaseError, match=r"added_inertia = '0.001 kg m\^2': expected nothing here"):
        loads(text)
