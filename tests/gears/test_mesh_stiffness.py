"""Mesh stiffness by ISO 6336-1 Method B against an example of others, the standard's rules of thumb and its
limits.

Example 1 of ISO/TR 6336-30 as calculated by KISSsoft: G. F. Scheel Rebouças, Drivetrain (open project),
example_01 of its class ISO_6336: c′ = 12.3620, c′_th = 17.8436, c_γα = 17.4553, c_γβ = 14.8370 N/(mm µm), and
12.3705, 17.8558, 17.4648, 14.8451 by its own formulas.
"""

from __future__ import annotations

from dataclasses import replace
from math import cos, degrees, inf, isclose, radians

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.gears import CylindricalGear, CylindricalPair, materials
from gearlash.gears import mesh_stiffness as ms
from gearlash.gears.basic_rack import ISO53_C, ISO53_D, BasicRack
from gearlash.gears.mesh_stiffness import SOLID, Rim, method_b

STEEL = materials.named("steel")
BOTH_SOLID = (SOLID, SOLID)


def pair(
    teeth=(30, 60), module=3e-3, beta=0.0, shifts=(0.0, 0.0), rack=ISO53_C, width=0.03
) -> CylindricalPair:
    first, second = (CylindricalGear(teeth[i], module, radians(beta), shifts[i], rack) for i in (0, 1))
    return CylindricalPair(first, second, None, width)


def test_example_1_of_iso_tr_6336_30_as_others_calculate_it():
    pinion = CylindricalGear(17, 8e-3, radians(15.8), 0.145, ISO53_D, 159.66e-3)
    wheel = CylindricalGear(103, 8e-3, radians(15.8), 0.0, ISO53_D, 872.35e-3)
    example = CylindricalPair(pinion, wheel, 0.5, 0.1)
    found = method_b(example, rims=BOTH_SOLID)
    values = [v / 1e9 for v in (ms.theoretical_stiffness(example), found.single, found.mean, found.face_load)]
    assert values == pytest.approx([17.85584, 12.37047, 17.46485, 14.84512], abs=6e-3)
    assert values == pytest.approx([17.8436, 12.3620, 17.4553, 14.8370], rel=8e-4)  # KISSsoft


def test_a_plain_steel_pair_is_near_the_rules_of_method_c():
    # ISO 6336-1, Method C: c′ ≈ 14, c_γ ≈ 20 N/(mm µm) for solid steel pairs of standard rack.
    found = method_b(pair(), rims=BOTH_SOLID)
    assert found.single / 1e9 == pytest.approx(14.0, rel=0.1)
    assert found.mean / 1e9 == pytest.approx(20.0, rel=0.1)
    assert found.least < 14.0 / (found.single / 1e9) < found.greatest


@given(st.tuples(st.integers(20, 150), st.integers(20, 150)), st.floats(0, 30))
def test_without_shift_and_rim_it_is_the_formula_worked_by_hand(teeth, beta):
    low, high = sorted(teeth)
    sharp = BasicRack(dedendum=1.25, root_radius=0.0)
    found = method_b(pair((low, high), beta=beta, rack=sharp), rims=BOTH_SOLID)
    virtual = [z / (cos(found.base_helix_angle) ** 2 * cos(radians(beta))) for z in (low, high)]
    compliance = 0.04723 + 0.15551 / virtual[0] + 0.25791 / virtual[1]
    by_hand = 0.8 * 0.975 * cos(radians(beta)) / compliance  # C_M, C_B of h_fP = 1.25 m_n
    assert found.single / 1e9 == pytest.approx(by_hand, rel=1e-12)


def test_the_mean_along_the_normal_is_per_cos_squared_of_the_base_helix():
    found = method_b(pair(beta=20), rims=BOTH_SOLID)
    assert found.along_normal(0.03) == pytest.approx(0.03 * found.mean / cos(found.base_helix_angle) ** 2)
    low, high = found.normal_range(0.03)
    assert low < found.along_normal(0.03) < high


def test_cast_iron_makes_it_softer_as_the_standard_prints():
    # ISO 6336-1: 0.74 for steel on cast iron, 0.59 for cast iron on cast iron (E = 122 GPa between its two
    # values).
    iron = replace(materials.named("grey-cast-iron"), youngs_modulus=122e9)
    steel = method_b(pair()).single
    assert method_b(pair(), (STEEL, iron)).single / steel == pytest.approx(0.74, abs=5e-3)
    assert method_b(pair(), (iron, iron)).single / steel == pytest.approx(0.59, abs=5e-3)


@pytest.mark.parametrize(  # values read off the formula by hand; limits of the standard
    ("rim", "expected"),
    [
        (Rim(inf, 1.0), 1.0),
        (Rim(3e-3, 30e-3), 1.0),
        (Rim(3e-3, 6e-3), 1 - 1.6094379 / (5 * 1.2214028)),
        (Rim(0.0, 0.0), 1 - 1.6094379 / (5 * 1.2214028)),  # not below s_R = m_n and b_s = 0.2 b
        (Rim(15e-3, 12e-3), 1 - 0.9162907 / (5 * 2.7182818)),
        (Rim(15e-3, 90e-3), 1 + 0.1823216 / (5 * 2.7182818)),  # not above b_s = 1.2 b
    ],
)
def test_rims_make_teeth_softer(rim, expected):
    assert rim.factor(30e-3, 3e-3) == pytest.approx(expected, rel=1e-7)
    solid = method_b(pair(), rims=BOTH_SOLID).single
    assert method_b(pair(), rims=(SOLID, rim)).single / solid == pytest.approx(0.5 * (1 + expected), rel=1e-7)


def test_a_case_without_rim_data_gets_a_value_and_a_wider_range():
    solid, unknown = method_b(pair(), rims=BOTH_SOLID), method_b(pair())
    assert unknown.mean == solid.mean
    assert unknown.least < 0.8 * solid.least
    assert isclose(unknown.greatest, solid.greatest)
    thin = method_b(pair(), rims=(Rim(0.0, 0.0), Rim(0.0, 0.0)))
    assert unknown.least * unknown.mean <= thin.mean


def test_small_loads_make_it_softer_by_the_fourth_root():
    full = method_b(pair(), line_load=100e3).single
    assert method_b(pair(), line_load=6.25e3).single / full == pytest.approx(0.5, rel=1e-12)
    assert method_b(pair(), line_load=1e6).single == full
    assert method_b(pair(), line_load=0.0).single == 0.0


def test_the_tool_counts():
    plain = method_b(pair(rack=ISO53_C)).single
    assert method_b(pair(rack=ISO53_D)).single / plain == pytest.approx(0.9 / 0.975, rel=1e-12)
    steep = BasicRack(pressure_angle=radians(25), root_radius=0.25)
    ratio = method_b(pair(rack=steep)).single / ms.theoretical_stiffness(pair(rack=steep))
    assert ratio == pytest.approx(0.8 * 0.975 * (1 + 0.02 * (degrees(steep.pressure_angle) - 20)), rel=1e-12)


def test_which_gear_is_named_first_does_not_matter():
    one = method_b(pair((25, 57), beta=15, shifts=(0.3, 0.1)))
    other = method_b(pair((57, 25), beta=15, shifts=(0.1, 0.3)))
    assert (one.single, one.mean) == pytest.approx((other.single, other.mean), rel=1e-12)


def test_what_the_standard_does_not_cover_is_told_and_widens_the_range():
    inside = method_b(pair(shifts=(0.3, 0.1)))
    assert inside.beyond == ()
    turned = method_b(pair(shifts=(0.0, 0.3)))
    assert "x_1 ≥ x_2" in turned.beyond[0]
    assert turned.least < inside.least
    pom = materials.named("POM")
    plastic = method_b(pair(), (pom, pom), line_load=2e6)
    assert len(plastic.beyond) == 2
    assert plastic.single / 1e9 == pytest.approx(14 * 2.9 / 206, rel=0.1)
    low = method_b(pair(shifts=(-0.4, -0.4)))
    assert "−0.5 to 2" in low.beyond[0]
    assert "45°" in method_b(pair(beta=46)).beyond[-1]


def test_a_small_contact_ratio_lowers_the_least():
    short = replace(pair(), stated_centre_distance=pair().centre_distance + 2.4e-3)
    assert short.transverse_contact_ratio < 1.2
    assert method_b(short).least == pytest.approx(0.9 * method_b(pair()).least, rel=1e-12)


def test_a_rim_without_a_face_width_counts_as_unknown():
    thin = Rim(3e-3, 6e-3)
    assert method_b(pair(width=0.0), rims=(thin, thin)).single == method_b(pair(width=0.0)).single
