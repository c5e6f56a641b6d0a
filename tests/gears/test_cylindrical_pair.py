"""Geometry of cylindrical gears and pairs against examples of others and against itself turned round.

Where the numbers are from:
- ISO/TR 6336-30:2022, Annex A, example 1: printed to the digits given here.
- "decimal": the formulas of DIN ISO 21771 in 45-digit decimal arithmetic, by the authors of the open project
gearcore
  (tests of its pair and generation modules), which shares no code with this one.
- FVA STplus 11.0F, output for the pair kst-E, as transcribed in the same project.
- D. Bolsover, Utilities for Alibre: profile shifted external spur gears (the example of the KHK technical
reference).
"""

from __future__ import annotations

from dataclasses import replace
from math import cos, degrees, isclose, pi, radians

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.gears import CylindricalGear, CylindricalPair, ToothGeometry
from gearlash.gears.basic_rack import ISO53_A, ISO53_D, BasicRack
from gearlash.gears.cylindrical_pair import shift_sum, tip_shortening
from gearlash.gears.involute import inv, inverse_involute
from gearlash.system import GearlashError

MM = 1e-3


def gear(z: int, m: float, beta: float, x: float = 0.0, tip: float | None = None, **more) -> CylindricalGear:
    """In mm and degrees."""
    return CylindricalGear(z, m * MM, radians(beta), x, stated_tip_diameter=tip and tip * MM, **more)


ISO_PAIR = CylindricalPair(
    gear(17, 8, 15.8, 0.145, 159.66, rack=ISO53_D),
    gear(103, 8, 15.8, 0.0, 872.35, rack=ISO53_D),
    0.5,
    0.1,
)
SPUR = CylindricalPair(gear(12, 2, 0, 0.3, 28), gear(40, 2, 0, -0.1, 83.2), face_width=0.02)
WIDE_ANGLE = BasicRack(pressure_angle=radians(22.5))
HELICAL = CylindricalPair(
    gear(25, 3, -30, 0.3, 94.4, rack=WIDE_ANGLE),
    gear(40, 3, -30, -0.1, 144, rack=WIDE_ANGLE),
    face_width=0.03,
)
DECIMAL = [  # pair; α_wt in degrees, a_w, Σx, d_w1; d_Nf1, d_Nf2, path of contact; ε_α, ε_β; in mm
    (
        ISO_PAIR,
        (21.066099804698517, 500.0, 0.1452220936512015, 141.66666666666666),
        (132.920685546483, 845.2252368254899, 37.84464046282067),
        (1.549090096889056, 1.0833686805697453),
    ),
    (
        SPUR,
        (21.13868827687391, 52.38927831334764, 0.2, 24.179666913852756),
        (22.653576724323237, 78.1051679820969, 7.229131220081783),
        (1.224391830355867, 0.0),
    ),
    (
        HELICAL,
        (26.182356800441667, 113.17655661808965, 0.2, 87.0588897062228),
        (83.12303952174517, 133.50574122587557, 12.300881944540036),
        (1.2529391073475025, 1.5915494309189533),
    ),
]


@pytest.mark.parametrize(("pair", "working", "contact", "ratios"), DECIMAL)
def test_pairs_against_decimal_arithmetic(pair, working, contact, ratios):
    found = (
        degrees(pair.working_pressure_angle),
        pair.centre_distance / MM,
        shift_sum(pair),
        pair.working_diameters[0] / MM,
    )
    assert found == pytest.approx(working, rel=2e-12)
    whole = replace(pair, pinion=_without_root(pair.pinion), gear=_without_root(pair.gear))
    start, end = whole.path_of_contact
    assert [d / MM for d in whole.active_root_diameters] == pytest.approx(contact[:2], rel=2e-12)
    assert (end - start) / MM == pytest.approx(contact[2], rel=2e-12)
    assert (whole.transverse_contact_ratio, whole.overlap_ratio) == pytest.approx(ratios, rel=2e-12)


def _without_root(one: CylindricalGear) -> CylindricalGear:
    """With an involute down to the base circle nearly, as if no tool rounded the root."""
    return replace(one, rack=replace(one.rack, dedendum=1.0, root_radius=0.0))


def test_the_root_of_the_tool_does_not_shorten_the_path_of_the_iso_example():
    assert ISO_PAIR.transverse_contact_ratio == pytest.approx(1.549090096889056, rel=1e-12)
    assert ISO_PAIR.interference == (False, False)


def test_iso_example_1_prints_these_diameters():
    pinion = replace(ISO_PAIR.pinion, stated_tip_diameter=None)
    assert round(pinion.reference_diameter / MM, 2) == 141.34
    assert round(pinion.tip_diameter / MM, 2) == 159.66
    assert round(replace(ISO_PAIR.gear, stated_tip_diameter=None).tip_diameter / MM, 2) == 872.35
    assert round(ISO_PAIR.pinion.virtual_teeth, 3) == 18.905
    assert round(ISO_PAIR.gear.virtual_teeth, 3) == 114.543


@pytest.mark.parametrize(  # pinion, h_FfP in mm, d_fE, x_Emin, d_Ff, s_an
    ("one", "straight", "root", "least", "form", "tip"),
    [
        (
            gear(17, 8, 0, 0.3, 158, rack=ISO53_D, thickness_allowance=-80e-6),
            *(9.147102847176086, 118.18020180644363, 0.14907673915266745),
            *(127.95923396532015, 3.3475971493447774),
        ),
        (
            gear(17, 8, 15.8, 0.11779, 159.66, rack=ISO53_D),
            *(9.147102847176086, 120.82475306644808, 0.03764821105895895),
            *(132.24824127231219, 4.8871635806267),
        ),
    ],
)
def test_generated_roots_against_decimal_arithmetic(one, straight, root, least, form, tip):
    assert one.rack.straight_dedendum * one.normal_module / MM == pytest.approx(straight, rel=1e-12)
    assert one.root_diameter / MM == pytest.approx(root, rel=1e-12)
    assert one.undercut_limit == pytest.approx(least, rel=1e-12)
    assert one.root_form_diameter / MM == pytest.approx(form, rel=1e-12)
    assert one.tip_thickness() / MM == pytest.approx(tip, rel=1e-12)


def test_stplus_pair_kst_e():
    # x of STplus is not printed; from the tooth thicknesses 1.719 and 1.800 it prints.
    shifts = [(s - pi / 2) / (2 * 0.36397023) for s in (1.719, 1.800)]
    pair = CylindricalPair(gear(51, 1, 0, shifts[0], 52.894), gear(52, 1, 0, shifts[1], 53.788), 0.052)
    # STplus calculates in single precision.
    assert degrees(pair.working_pressure_angle) == pytest.approx(21.46251, abs=1.5e-5)
    assert [round(d / MM, 3) for d in pair.working_diameters] == [51.495, 52.505]
    assert [round(g.base_diameter / MM, 3) for g in pair.gears] == [47.924, 48.864]
    start, end = pair.path_of_contact
    assert (end - start) / MM == pytest.approx(3.406, abs=1.5e-3)
    assert pair.transverse_contact_ratio == pytest.approx(1.154, abs=5e-4)
    assert [d / MM for d in pair.active_root_diameters] == pytest.approx([50.391, 51.315], abs=1.5e-3)


def test_profile_shifted_spur_pair_of_the_khk_reference():
    pair = CylindricalPair(gear(12, 3, 0, 0.6), gear(24, 3, 0, 0.36), 56.5 * MM)
    assert shift_sum(pair) == pytest.approx(0.96, abs=5e-4)
    assert degrees(pair.working_pressure_angle) == pytest.approx(26.0888, abs=5e-4)
    assert [round(d / MM, 3) for d in pair.working_diameters] == [37.667, 75.333]
    shorter = tip_shortening(pair)
    tips = [g.tip_diameter + 2 * shorter for g in pair.gears]
    assert [d / MM for d in tips] == pytest.approx([44.840, 79.400], abs=5e-3)
    trimmed = replace(
        pair,
        pinion=replace(pair.pinion, stated_tip_diameter=tips[0]),
        gear=replace(pair.gear, stated_tip_diameter=tips[1]),
    )
    assert trimmed.transverse_contact_ratio == pytest.approx(1.202, abs=1e-3)
    assert [c / MM for c in trimmed.tip_clearances] == pytest.approx([0.75, 0.75], abs=1e-12)  # 0.25 m


@given(st.floats(1e-12, 50.0))
def test_involute_function_and_its_inverse_are_inverse(value):
    angle = inverse_involute(value)
    with mpmath.workdps(40):
        exact = mpmath.tan(angle) - mpmath.mpf(angle)
        slope = float(mpmath.tan(angle) ** 2)
    assert abs(float(exact) - value) <= 4e-16 * (value + slope + angle)
    assert isclose(inv(angle), float(exact), rel_tol=1e-11)


def test_the_involute_function_continues_over_the_end_of_its_series():
    below, above = inv(0.02), inv(0.02 + 1e-12)
    assert above - below == pytest.approx(1e-12 * 0.02**2, abs=2e-17)


def test_no_angle_has_a_negative_involute_function():
    with pytest.raises(GearlashError, match="0 or more"):
        inverse_involute(-1e-9)


@given(
    teeth=st.tuples(st.integers(17, 200), st.integers(17, 200)),
    module=st.floats(5e-4, 2e-2),
    beta=st.floats(-35.0, 35.0),
)
def test_without_shift_it_is_the_geometry_the_models_rest_on(teeth, module, beta):
    plain = ToothGeometry(teeth, module, radians(20.0), radians(beta))
    sharp = BasicRack(dedendum=1.0, root_radius=0.0)
    first, second = (CylindricalGear(z, module, radians(beta), rack=sharp) for z in teeth)
    pair = CylindricalPair(first, second, face_width=0.03)
    assert pair.centre_distance == pytest.approx(plain.centre_distance, rel=1e-13)
    assert pair.overlap_ratio == plain.overlap_ratio(0.03)
    assert first.base_helix_angle == pytest.approx(abs(plain.base_helix_angle), abs=1e-15)
    if pair.interference == (False, False):
        assert pair.transverse_contact_ratio == pytest.approx(plain.transverse_contact_ratio, rel=1e-11)
    else:
        assert pair.transverse_contact_ratio < plain.transverse_contact_ratio


def test_seventeen_teeth_are_the_least_without_undercut():
    # 2 h*/sin² 20° = 17.1 for a straight dedendum of one module.
    sharp = replace(ISO53_A, dedendum=1.0, root_radius=0.0)
    assert [CylindricalGear(z, 1e-3, rack=sharp).undercut for z in (17, 18)] == [True, False]
    assert CylindricalGear(12, 1e-3, profile_shift=0.3, rack=sharp).undercut is False


def test_an_undercut_gear_meshes_from_where_its_fillet_ends():
    few = CylindricalPair(CylindricalGear(10, 2e-3), CylindricalGear(60, 2e-3))
    assert few.pinion.undercut
    assert few.interference == (True, False)
    assert few.pinion.root_form_diameter > few.pinion.base_diameter
    assert few.path_of_contact[0] == few.pinion.roll_length(few.pinion.root_form_diameter)


@pytest.mark.parametrize(("teeth", "beta"), [(8, 0.0), (12, 0.0), (12, 20.0)])
def test_the_start_of_the_involute_of_an_undercut_gear(teeth, beta):
    one = CylindricalGear(teeth, 2e-3, radians(beta))
    fillet = one.root_fillet
    radius, angle = fillet.at(fillet.end)
    assert float(angle) == pytest.approx(float(fillet.involute_angle(radius)), abs=1e-12)
    assert radius > fillet.base_radius
    # Where undercut just ends it is the closed form of ISO 21771; of a helical gear the virtual one is near
    # it.
    edge = replace(one, profile_shift=one.undercut_limit + 1e-9)
    assert not edge.undercut
    assert replace(edge, profile_shift=one.undercut_limit - 1e-9).root_form_diameter == pytest.approx(
        edge.root_form_diameter, rel=1e-6 if beta == 0.0 else 1e-3
    )


@pytest.mark.parametrize("beta", [0.0, 25.0])
def test_the_fillet_ends_at_the_form_diameter_and_starts_at_the_root(beta):
    one = CylindricalGear(40, 3e-3, radians(beta), 0.1)
    fillet = one.root_fillet
    low, high = (2 * (float(fillet.at(lean)[0]) - fillet.pitch_radius) for lean in (0.0, fillet.end))
    assert one.reference_diameter + low == pytest.approx(one.root_diameter, rel=1e-12)
    assert one.reference_diameter + high == pytest.approx(
        one.root_form_diameter, rel=1e-12 if beta == 0.0 else 1e-3
    )
    assert float(fillet.at(fillet.end)[1]) == pytest.approx(
        float(fillet.involute_angle(fillet.involute_radius))
    )


def test_tooth_thickness_and_space_fill_the_pitch_where_backlash_is_none():
    pair = replace(HELICAL, pinion=HELICAL.pinion.nominal(), gear=HELICAL.gear.nominal())
    first, second = (
        one.transverse_thickness(working)
        for one, working in zip(pair.gears, pair.working_diameters, strict=True)
    )
    assert first + second == pytest.approx(pi * pair.working_diameters[0] / 25, rel=1e-13)


def test_the_hand_of_the_helix_changes_nothing_but_its_own_sign():
    left = HELICAL.pinion.mirrored()
    assert left.helix_angle == -HELICAL.pinion.helix_angle
    assert (left.tip_diameter, left.base_helix_angle) == (
        HELICAL.pinion.tip_diameter,
        HELICAL.pinion.base_helix_angle,
    )
    assert left.helix_angle_at(left.reference_diameter) == pytest.approx(left.helix_angle)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: gear(3, 1, 0), "4 or more"),
        (lambda: gear(20, -1, 0), "above 0"),
        (lambda: gear(20, 1, 90), "below π/2"),
        (lambda: gear(20, 1, 0, -3.0), "no flank"),
        (lambda: CylindricalPair(gear(20, 1, 0), gear(20, 2, 0)), "normal module"),
        (lambda: CylindricalPair(gear(20, 1, 0), gear(20, 1, 10)), "helix angle"),
        (lambda: CylindricalPair(gear(20, 1, 0), gear(20, 1, 0), 18e-3), "base circles"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(make, says):
    with pytest.raises(GearlashError, match=says):
        make()


def test_gears_too_far_apart_do_not_touch():
    apart = CylindricalPair(gear(20, 1, 0), gear(20, 1, 0), 22.5 * MM)
    assert apart.transverse_contact_ratio == 0.0
    assert cos(apart.working_pressure_angle) < 1.0
