"""Estimates for a drawing: each in its range, from what it should come, and narrower the more is stated."""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, radians, sqrt

import pytest

from gearlash.gears import CylindricalGear, CylindricalPair, backlash, equivalent_mass, materials
from gearlash.gears.bearings import bearing_span, shaft_stiffness
from gearlash.gears.estimates import Drawing, estimates, natural_frequency
from gearlash.gears.gear_body import GearBody
from gearlash.gears.mesh_stiffness import SOLID

PAIR = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), None, 0.02)
HELICAL = CylindricalPair(
    CylindricalGear(25, 2e-3, radians(15), 0.3), CylindricalGear(57, 2e-3, radians(15), 0.1), None, 0.025
)
POM = materials.named("POM")


@pytest.mark.parametrize(
    "drawing",
    [
        Drawing(PAIR),
        Drawing(HELICAL, torque=150.0),
        Drawing(PAIR, (POM, POM), torque=2.0),
        Drawing(PAIR, grades=(6, 7), fits=("26cd", "27c")),
        Drawing(CylindricalPair(CylindricalGear(12, 1e-3), CylindricalGear(30, 1e-3), None, 8e-3)),
    ],
)
def test_every_estimate_lies_in_its_range_and_tells_its_source(drawing):
    found = estimates(drawing)
    assert len(found) == 6 + 8 + 8 + 4 + 4 + 2
    for name, one in found.items():
        assert one.least <= one.value <= one.greatest, name
        assert one.source, name


def test_what_is_stated_narrows_the_range():
    def width(drawing: Drawing, name: str) -> float:
        one = estimates(drawing)[name]
        return one.greatest - one.least

    assert width(Drawing(PAIR, rims=(SOLID, SOLID)), "mean_stiffness") < width(
        Drawing(PAIR), "mean_stiffness"
    )
    assert width(Drawing(PAIR, grades=(6, 6)), "error") < width(Drawing(PAIR), "error")
    assert width(Drawing(PAIR, fits=("25cd", "25cd")), "backlash") < width(Drawing(PAIR), "backlash")
    body = GearBody(0.05, 0.02, 0.02)
    assert width(Drawing(PAIR, bodies=(body, None)), "pinion_mass") < width(Drawing(PAIR), "pinion_mass")


def test_stated_allowances_are_the_backlash():
    thin = replace(
        PAIR,
        pinion=replace(PAIR.pinion, thickness_allowance=-40e-6),
        gear=replace(PAIR.gear, thickness_allowance=-45e-6),
        stated_centre_distance=82e-3,
    )
    found = estimates(Drawing(thin))["backlash"]
    assert found.value == backlash.of_pair(thin).normal == pytest.approx(85e-6 * cos(radians(20)))
    assert "stated tooth thickness" in found.source


def test_light_loads_make_the_mesh_softer():
    light, full = (estimates(Drawing(PAIR, torque=t))["mean_stiffness"].value for t in (1.0, 150.0))
    # 1 N·m is 2 N/mm: (0.02)^(1/4) of 100 N/mm.
    assert light / full == pytest.approx(0.02**0.25, rel=1e-12)


def test_the_natural_frequency_is_that_of_the_torsional_model():
    found = estimates(Drawing(PAIR))
    radii = PAIR.pinion.base_diameter / 2, PAIR.gear.base_diameter / 2
    mass = equivalent_mass(radii, (found["pinion_inertia"].value, found["gear_inertia"].value))
    expected = sqrt(found["mean_stiffness"].value / mass) / (2 * pi)
    frequency = natural_frequency(found, PAIR)
    assert frequency.value == pytest.approx(expected, rel=1e-12)
    assert frequency.least < expected < frequency.greatest


@pytest.mark.parametrize(
    ("d", "width"), [(10, 9), (20, 14), (30, 16), (50, 20), (80, 26), (100, 34), (200, 58)]
)
def test_bearings_are_as_wide_as_series_62_of_iso_15(d: int, width: int):
    """6200, 6204 … 6240; beyond the teeth a span has one width and both walls."""
    both = [bearing_span(face, 0.2, 1e-3 * d) for face in (0.02, 0.1)]
    assert both[1] - both[0] == pytest.approx(0.08)
    assert both[0] - 0.02 - 2.0 * (8e-3 + 4e-3) == pytest.approx(1e-3 * width, rel=1.0 / 7.0)


def test_a_thin_shaft_that_bends_is_in_the_range_of_its_bearings():
    """A beam on two supports has 48 E I/L³ at its middle: the same without a body that is stiff."""
    inertia = pi * 0.012**4 / 64.0
    assert shaft_stiffness(0.012, 0.05) == pytest.approx(48.0 * 206e9 * inertia / 0.1**3)
    thick, thin = (estimates(Drawing(PAIR, torque=50.0, shafts=(d, 0.03))) for d in (0.03, 0.006))
    path = "pinion_bearing_y"
    assert thick[path].least == pytest.approx(0.25 * thick[path].value)
    assert thin[path].least < 0.2 * thin[path].value
    assert "which bends between bearings" in thin[path].source
    assert "which bends" not in thick[path].source + thin["pinion_bearing_z"].source
    stated = Drawing(PAIR, torque=50.0, shafts=(0.006, 0.03), stated_bending=(True, False))
    assert estimates(stated)[path].least == pytest.approx(0.25 * thin[path].value)
