"""Masses and inertias against closed forms of ISO 6336-1, sums of parts, and teeth that are integrated."""

from __future__ import annotations

from math import cos, pi, radians

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.gears import CylindricalGear, CylindricalPair, equivalent_mass, materials, solid_disc
from gearlash.gears.gear_body import GearBody, Ring, mean_tooth_diameter
from gearlash.system import GearlashError

STEEL = materials.named("steel").density


def test_a_full_ring_is_a_disc():
    ring = Ring(0.0, 0.2, 0.03)
    assert ring.mass(STEEL) == pytest.approx(STEEL * pi * 0.01 * 0.03, rel=1e-15)
    assert ring.inertia(STEEL) == pytest.approx(solid_disc(ring.mass(STEEL), 0.1), rel=1e-15)


@given(st.floats(0.0, 0.05), st.floats(0.05, 0.1), st.floats(0.1, 0.3), st.floats(0.3, 0.5))
def test_a_body_whose_web_is_as_wide_as_its_face_is_solid(bore, hub, rim, outer):
    solid = GearBody(outer, 0.04, bore)
    parts = GearBody(outer, 0.04, bore, rim_inner_diameter=rim, hub_diameter=hub)
    assert parts.mass(STEEL) == pytest.approx(solid.mass(STEEL), rel=1e-12)
    assert parts.inertia(STEEL) == pytest.approx(solid.inertia(STEEL), rel=1e-12)


def test_reduced_mass_of_iso_6336_1():
    # m_red = π/8 (d_m1/d_b1)² d_m1² / (1/((1 − q1⁴) ρ1) + 1/((1 − q2⁴) ρ2 u²)), for d_m2 = u d_m1; per face
    # width.
    pinion, gear = (CylindricalGear(z, 4e-3, radians(15)) for z in (20, 60))
    pair = CylindricalPair(pinion, gear)
    outer = 0.08, 0.24
    bores = 0.4 * outer[0], 0.6 * outer[1]
    inertias = [GearBody(d, 1.0, bore).inertia(STEEL) for d, bore in zip(outer, bores, strict=True)]
    radii = pinion.base_diameter / 2, gear.base_diameter / 2
    hollow = [1 - q**4 for q in (0.4, 0.6)]
    weight = 1 / (1 / (hollow[0] * STEEL) + 1 / (hollow[1] * STEEL * pair.ratio**2))
    expected = pi / 8 * (outer[0] / pinion.base_diameter) ** 2 * outer[0] ** 2 * weight
    assert equivalent_mass(radii, (inertias[0], inertias[1])) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("gear", [CylindricalGear(20, 3e-3), CylindricalGear(60, 4e-3, radians(20), 0.3)])
def test_teeth_that_are_integrated_weigh_what_their_mean_diameter_says(gear):
    # Transverse section from the root up: thickness of the teeth at a radius, straight on below the form
    # circle.
    foot, tip = gear.root_diameter / 2, gear.tip_diameter / 2
    radii = np.linspace(foot, tip, 2001)
    usable = np.maximum(2 * radii, gear.root_form_diameter)
    thickness = np.array([gear.transverse_thickness(d) for d in usable]) * radii * 2 / usable
    area = pi * foot**2 + gear.teeth * np.trapezoid(thickness, radii)
    polar = pi / 2 * foot**4 + gear.teeth * np.trapezoid(thickness * radii**2, radii)
    ring = Ring(0.0, mean_tooth_diameter(gear), 1.0)
    assert ring.mass(1.0) == pytest.approx(area, rel=0.02)
    assert ring.inertia(1.0) == pytest.approx(polar, rel=0.04)


@pytest.mark.parametrize("ring", [(0.2, 0.1, 0.01), (-0.1, 0.1, 0.01), (0.0, 0.1, -0.01)])
def test_a_ring_turned_inside_out_is_refused(ring):
    with pytest.raises(GearlashError, match="inner diameter"):
        Ring(*ring)


@pytest.mark.parametrize(  # ISO 6336-2, elasticity factors as printed, √(N/mm²)
    ("pair", "printed"),
    [
        (("steel", "steel"), 189.8),
        (("steel", "cast-steel"), 188.9),
        (("steel", "nodular-cast-iron"), 181.4),
        (("steel", "tin-bronze"), 155.0),
        (("steel", "grey-cast-iron"), 162.0),
        (("nodular-cast-iron", "nodular-cast-iron"), 173.9),
        (("grey-cast-iron", "grey-cast-iron"), 143.7),
    ],
)
def test_elasticity_factors_as_printed(pair, printed):
    factor = materials.elasticity_factor(*(materials.named(name) for name in pair)) / 1e3
    assert factor == pytest.approx(printed, abs=0.06)


def test_every_material_lies_in_its_own_range_and_tells_its_source():
    for one in materials.MATERIALS.values():
        assert one.youngs_range[0] <= one.youngs_modulus <= one.youngs_range[1]
        assert one.expansion_range[0] <= one.expansion <= one.expansion_range[1]
        assert 0.2 < one.poisson_ratio < 0.5
        assert one.source


def test_an_unknown_material_names_the_known_ones():
    with pytest.raises(GearlashError, match="POM"):
        materials.named("unobtainium")


def test_a_helical_gear_has_the_mass_of_its_transverse_section():
    helical, spur = CylindricalGear(40, 2e-3, radians(30)), CylindricalGear(40, 2e-3 / cos(radians(30)))
    assert helical.reference_diameter == pytest.approx(spur.reference_diameter)
    assert abs(mean_tooth_diameter(helical) - mean_tooth_diameter(spur)) < 0.25 * 2e-3
