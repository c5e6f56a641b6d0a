"""Backlash with temperatures and the deviation of the centre distance."""

from __future__ import annotations

from dataclasses import replace
from math import cos, degrees, radians
from pathlib import Path

import pytest

from gearlash.case import Case, CaseError, loads
from gearlash.gears import CylindricalGear, CylindricalPair
from gearlash.gears.backlash import Growth, of_pair

TEXT = (Path(__file__).parents[1] / "cases" / "drawing.toml").read_text(encoding="utf-8")
WARM = {"mesh.temperature": "60 °C", "mesh.housing_material": "aluminium", "gear.temperature": "50 degC"}


def at_work(case: Case) -> float:
    """Backlash of the model, µm."""
    return 2e6 * case.family()[0].defaults["D"] * float(case.scales.length or 0.0)


def test_temperatures_and_centre_distance_act_on_the_stated_backlash():
    case = loads(TEXT, {**WARM, "mesh.centre_distance_deviation": "-20 um"})
    gears = [CylindricalGear(z, 3e-3, 0.2617993877991494) for z in (25, 57)]
    # teeth thinned to 80 µm of backlash, for reference
    thin = [replace(gear, thickness_allowance=-40e-6 / cos(radians(20))) for gear in gears]
    pair = CylindricalPair(thin[0], thin[1])
    assert of_pair(pair).normal == pytest.approx(80e-6, rel=1e-9)
    moved = replace(pair, stated_centre_distance=pair.centre_distance - 20e-6)
    steel, aluminium = 11.5e-6, 23e-6
    exact = of_pair(moved, Growth(40 * steel, 30 * steel, 40 * aluminium)).normal
    assert at_work(case) == pytest.approx(1e6 * exact, abs=0.05)  # that of the 80 µm themselves is left out
    found = {v.path: v for v in case.values()}
    assert found["mesh.backlash_at_work"].value == pytest.approx(at_work(case))
    assert found["mesh.backlash"].value == 80.0


def test_a_stated_backlash_means_the_same_wherever_it_is_typed():
    case = loads(TEXT, WARM)
    family = case.family()[0]
    assert family.defaults["D"] > 1.2
    assert case.resolve("backlash", "80 um") == ("D", pytest.approx(family.defaults["D"]))
    other = case.with_overrides({"backlash": "110 um"}).family()[0].defaults["D"]
    varied = case.varying("mesh.backlash")
    assert varied.resolve("backlash", "110 um") == ("mesh.backlash", pytest.approx(110e-6))
    assert varied.physical("mesh.backlash", 110e-6) == [("mesh.backlash", pytest.approx(110.0), "um")]
    assert varied.family()[0].system({"mesh.backlash": 110e-6}).clearances[0].gap_plus == pytest.approx(other)
    (shown,) = [v for path, v, _ in case.physical("D", other) if path == "mesh.backlash_at_work"]
    known = loads(TEXT.replace('backlash = "80 um"', f'backlash_at_work = "{float(shown)!r} um"'), WARM)
    assert at_work(known) == pytest.approx(at_work(case) + 30.0)


def test_temperatures_vary_and_apply_to_an_estimated_backlash():
    text = TEXT.replace('backlash = "80 um"\n', "")
    case = loads(text, WARM)
    cold = loads(text)
    assert at_work(case) > at_work(cold) + 20
    family, _ = case.varying("mesh.temperature").family()
    other = case.with_overrides({"mesh.temperature": "90 degC"})
    gap = family.system({"mesh.temperature": 90.0}).clearances[0].gap_plus
    assert gap == pytest.approx(other.family()[0].defaults["D"], rel=1e-9)


def test_where_no_play_is_left_or_no_teeth_are_known_it_is_told():
    with pytest.raises(CaseError, match="of 80 µm of backlash temperatures and centre distance take 106"):
        loads(TEXT, {"pinion.material": "POM", "mesh.temperature": "60 degC"})
    with pytest.raises(CaseError, match="teeth, module and helix angle beside it"):
        loads("""
            kind = "spur-1dof"
            pinion = {teeth = 20, base_radius = "40 mm", inertia = "0.01 kg m^2", temperature = "60 degC"}
            gear = {teeth = 30, base_radius = "60 mm", inertia = "0.05 kg m^2"}
            mesh = {mean_stiffness = "3e8 N/m", backlash = "80 um", damping_ratio = 0.05, ripple = 0.1}
            operation = {pinion_speed = "1000 rpm", torque = "100 N m"}
        """)
    with pytest.raises(CaseError, match="a temperature in °C with its unit"):
        loads(TEXT, {"mesh.temperature": "60 K"})


def test_contact_and_stiffness_are_those_of_the_centre_distance_at_work():
    moved = {"mesh.centre_distance_deviation": "300 um"}
    case, nominal = loads(TEXT, moved), loads(TEXT)
    pinion, gear = (CylindricalGear(z, 3e-3, radians(15)) for z in (25, 57))
    plain = CylindricalPair(pinion, gear, face_width=40e-3)
    pair = replace(plain, stated_centre_distance=plain.centre_distance + 300e-6)
    found = {v.path: v for v in case.values()}
    assert found["derived.working_pressure_angle"].value == pytest.approx(
        degrees(pair.working_pressure_angle)
    )
    assert found["derived.transverse_contact_ratio"].value == pytest.approx(pair.transverse_contact_ratio)
    assert found["derived.c_y"].value == pytest.approx(
        cos(pair.working_pressure_angle) * cos(pinion.base_helix_angle)
    )
    expected = (0.75 * pair.transverse_contact_ratio + 0.25) / (0.75 * plain.transverse_contact_ratio + 0.25)
    ratio = (case.scales.mean_stiffness or 0.0) / (nominal.scales.mean_stiffness or 1.0)
    assert ratio == pytest.approx(expected, rel=1e-9) != pytest.approx(1.0, rel=1e-3)
    # teeth are as they are made: their drawing, and what a change of the distance is measured from
    assert case.numbers.body.teeth.centre_distance == pytest.approx(plain.centre_distance)


def test_what_grows_all_alike_changes_no_contact_ratio():
    alike = {"mesh.temperature": "90 degC", "mesh.housing_material": "steel"}
    apart = {"mesh.temperature": "90 degC", "mesh.housing_material": "aluminium"}
    ratios = [
        {v.path: v.value for v in loads(TEXT, each).values()}["derived.transverse_contact_ratio"]
        for each in ({}, alike, apart)
    ]
    assert ratios[1] == pytest.approx(ratios[0], rel=1e-12)
    # 70 K of 11.5e-6 more than the gears: that many µm of distance
    grown = 70 * (23e-6 - 11.5e-6) / (1 + 70 * 11.5e-6)
    teeth = [CylindricalGear(z, 3e-3, radians(15)) for z in (25, 57)]
    pair = CylindricalPair(teeth[0], teeth[1])
    moved = replace(pair, stated_centre_distance=pair.centre_distance * (1 + grown))
    assert ratios[2] == pytest.approx(moved.transverse_contact_ratio, rel=1e-12)
