"""Whatever a drawing says: every quantity that is computed from it is finite and sane, and nothing is
refused.

Module 0.5 to 20 mm, 12 to 200 teeth, helix 0 to 35°, ratios 1 to 8, steel, iron and plastics, profile shifts
as drawings have them, grades 3 to 11.
"""

from __future__ import annotations

from math import isfinite, radians

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from gearlash.gears import (
    CylindricalGear,
    CylindricalPair,
    backlash,
    gear_fits,
    inspection,
    materials,
)
from gearlash.gears import mesh_stiffness as ms
from gearlash.gears.estimates import Drawing, estimates
from gearlash.gears.flank_tolerances import class_factor
from gearlash.gears.gear_body import GearBody, mean_tooth_diameter
from gearlash.gears.mesh_cycle import MeshCycle, ripple_ranges
from gearlash.gears.tooth_pair import calculated_mesh
from gearlash.gears.unloaded_error import unloaded_error


@st.composite
def drawings(draw) -> CylindricalPair:
    """Pinion and gear; some pinions are undercut."""
    pinion = draw(st.integers(12, 60))
    gear = min(200, round(pinion * draw(st.floats(1.0, 8.0))))
    module = draw(st.sampled_from([0.5, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0])) * 1e-3
    beta = radians(draw(st.floats(0.0, 35.0)))
    first, second = draw(st.floats(0.0, 0.6)), draw(st.floats(-0.2, 0.3))
    width = module * draw(st.floats(6.0, 20.0))
    allowance = -0.02 * module
    gears = (
        CylindricalGear(pinion, module, beta, first, thickness_allowance=allowance),
        CylindricalGear(gear, module, beta, second, thickness_allowance=allowance),
    )
    return CylindricalPair(gears[0], gears[1], None, width)


@given(drawings())
def test_geometry_and_its_measures(pair):
    assert 0.8 < pair.transverse_contact_ratio < 2.2
    assert radians(15) < pair.working_pressure_angle < radians(35)
    for gear in pair.gears:
        k = inspection.span_teeth(gear)
        assert gear.base_diameter < inspection.span_contact_diameter(gear, k) < 1.1 * gear.tip_diameter
        over = inspection.dimension_over_balls(gear, 1.75 * gear.normal_module)
        assert gear.root_diameter < over < gear.tip_diameter + 2.5 * gear.normal_module
        assert gear.root_diameter < gear.root_form_diameter < gear.tip_diameter
        assert gear.tip_thickness() > -0.3 * gear.normal_module
    play = backlash.of_pair(pair)
    assert 0.02 < play.normal / pair.pinion.normal_module < 0.05
    assert isfinite(backlash.recommended_minimum(pair))
    assert all(
        gear_fits.thickness_allowances("26cd", gear.reference_diameter)[1] < 0.0 for gear in pair.gears
    )


@given(drawings(), st.sampled_from(list(materials.MATERIALS)), st.sampled_from(list(materials.MATERIALS)))
def test_stiffness_with_a_range(pair, first, second):
    bodies = materials.named(first), materials.named(second)
    found = ms.method_b(pair, bodies)
    least, greatest = found.normal_range(pair.face_width)
    assert 0.0 < least < found.along_normal(pair.face_width) < greatest
    modulus = 2.0 / (1 / bodies[0].youngs_modulus + 1 / bodies[1].youngs_modulus)
    assert 0.03 < found.mean / modulus < 0.16  # 20 N/(mm µm) over 206 GPa is 0.097
    weight = GearBody(mean_tooth_diameter(pair.pinion), pair.face_width).mass(bodies[0].density)
    assert 0.0 < weight < 1e4


@given(drawings(), st.integers(3, 11))
def test_excitations(pair, grade):
    least, greatest = ripple_ranges(pair, 8)
    assert np.all(np.abs(least) <= 2.0)
    assert np.all(least <= greatest)
    cycle = MeshCycle.of_pair(pair)
    assert np.all(cycle.stiffness(np.linspace(0, 1, 50)) >= 0.0)
    error = unloaded_error(pair, (grade, grade)).mesh
    assert 0.0 < error.nominal < error.greatest
    assert 4e-6 < error.greatest / class_factor(grade) < 60e-6


@settings(max_examples=20)
@given(drawings())
def test_calculated_teeth(pair):
    found = calculated_mesh(pair, 3, 100.0 * pair.pinion.normal_module / 1e-3 * 1e3)
    iso = ms.method_b(pair, rims=(ms.SOLID, ms.SOLID))
    assert 0.8 < found.mean * 0.8 / iso.along_normal(pair.face_width) < 1.35
    assert np.all(np.abs(found.harmonics) <= 2.0)


@settings(max_examples=20)
@given(drawings(), st.sampled_from(list(materials.MATERIALS)), st.floats(0.1, 100.0))
def test_estimates_are_ordered(pair, material, load):
    torque = load * 1e3 * pair.face_width * pair.pinion.reference_diameter / 2  # F_t/b in N/mm
    stuff = materials.named(material)
    for name, one in estimates(Drawing(pair, (stuff, stuff), torque=torque), 4).items():
        assert one.least <= one.value <= one.greatest, name
        assert isfinite(one.least), name
        assert isfinite(one.greatest), name
