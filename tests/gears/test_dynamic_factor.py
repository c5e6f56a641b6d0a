"""K_v of ISO 6336-1 Method B: an example of others, and its ranges by hand."""

from __future__ import annotations

from math import pi, radians

import pytest

from gearlash.gears import CylindricalGear, CylindricalPair, equivalent_mass, materials
from gearlash.gears.basic_rack import ISO53_D
from gearlash.gears.dynamic_factor import EffectiveErrors, SpeedRange, dynamic_factor
from gearlash.gears.gear_body import GearBody, mean_tooth_diameter
from gearlash.gears.mesh_stiffness import MeshStiffness, method_b
from gearlash.system import GearlashError

SPUR = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), None, 0.02)
MESH = MeshStiffness(14e9, 20e9, 0.0, 0.9, 1.1)
ERRORS = EffectiveErrors(5e-6, 4e-6)


def factor(n: float, line_load: float = 280e3, relief: float = 0.0):
    """At N = n: B_p = 0.25, B_f = 0.2 for 280 N/mm."""
    speed = n * (20e9 / 8.0) ** 0.5 / 25
    return dynamic_factor(SPUR, MESH, 8.0, speed, line_load, ERRORS, relief)


def test_example_1_of_iso_tr_6336_30():
    # K_v = 1.003 there; class 5, C_a = 70 µm, 9 kN m at 360 rpm, case-hardened; bores do not matter to three
    # digits.
    pinion = CylindricalGear(17, 8e-3, radians(15.8), 0.145, ISO53_D, 159.66e-3)
    wheel = CylindricalGear(103, 8e-3, radians(15.8), 0.0, ISO53_D, 872.35e-3)
    pair = CylindricalPair(pinion, wheel, 0.5, 0.1)
    density = materials.named("steel").density
    inertias = [GearBody(mean_tooth_diameter(one), 0.1).inertia(density) for one in pair.gears]
    mass = (
        equivalent_mass((pinion.base_diameter / 2, wheel.base_diameter / 2), (inertias[0], inertias[1])) / 0.1
    )
    line_load = 2 * 9e3 / pinion.reference_diameter / 0.1
    assert line_load * 0.1 == pytest.approx(127352.0, rel=1e-5)
    errors = EffectiveErrors.of_grades(pair, (5, 5))
    found = dynamic_factor(pair, method_b(pair), mass, 360 * pi / 30, line_load, errors, 70e-6)
    assert round(found.value, 3) == 1.003
    assert found.range is SpeedRange.SUBCRITICAL


def test_the_ranges_by_hand():
    # ε_γ = 1.67: C_v1 = 0.32, C_v2 = 0.34, C_v3 = 0.23, C_v4 = 0.90, C_v5 = C_v6 = 0.47, C_v7 = 0.769.
    assert factor(0.5).value == pytest.approx(1 + 0.5 * (0.32 * 0.25 + 0.34 * 0.2 + 0.23), rel=1e-12)
    assert factor(1.0).value == pytest.approx(1 + 0.32 * 0.25 + 0.34 * 0.2 + 0.90, rel=1e-12)
    assert factor(2.0).value == pytest.approx(0.47 * 0.45 + 0.769, abs=5e-3)
    ranges = [factor(n).range for n in (0.84, 0.86, 1.16, 1.5)]
    assert ranges == list(SpeedRange)
    middle = (factor(1.15).value + factor(1.5).value) / 2
    assert factor(1.325).value == pytest.approx(middle, rel=1e-12)


def test_tip_relief_that_fits_the_load_calms():
    assert factor(1.0, relief=20e-6).value == pytest.approx(1 + 0.32 * 0.25 + 0.34 * 0.2, rel=1e-12)
    assert factor(1.0, relief=40e-6).value == pytest.approx(factor(1.0).value, rel=1e-12)


def test_small_loads_meet_the_resonance_earlier():
    assert factor(0.6, 25e3).range is SpeedRange.SUBCRITICAL
    assert factor(0.7, 25e3).range is SpeedRange.RESONANCE


def test_factors_of_a_large_contact_ratio_are_continuous_and_smaller():
    def at(width: float) -> float:
        first, second = (CylindricalGear(z, 2e-3, radians(20)) for z in (25, 57))
        pair = CylindricalPair(first, second, None, width)
        speed = (20e9 / 8.0) ** 0.5 / 25
        return dynamic_factor(pair, MESH, 8.0, speed, 280e3, ERRORS).value

    assert at(0.04) < at(0.02) < factor(1.0).value


def test_no_load_has_no_dynamic_factor():
    with pytest.raises(GearlashError, match="under load"):
        factor(0.5, 0.0)
