"""Span measurement and dimension over balls: examples of others, and each turned back.

FVA STplus 11.0F for the pair kst-E and a helical pair 25/40 teeth, both as transcribed in the tests of the
open project gearcore; the 25/40 numbers are that project's own regression values of DIN 21773.
"""

from __future__ import annotations

from dataclasses import replace
from math import acos, atan, cos, hypot, pi, radians, sin, sqrt, tan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.gears import CylindricalGear, inspection
from gearlash.system import GearlashError

MM = 1e-3
KST_E = [(51, (1.719 - pi / 2) / (2 * tan(radians(20)))), (52, (1.800 - pi / 2) / (2 * tan(radians(20))))]
HELICAL = [CylindricalGear(z, 2 * MM, radians(20)) for z in (25, 40)]
gears = st.builds(
    CylindricalGear,
    teeth=st.integers(12, 200),
    normal_module=st.floats(5e-4, 2e-2),
    helix_angle=st.floats(radians(-35), radians(35)),
    profile_shift=st.floats(-0.1, 0.6),
    thickness_allowance=st.floats(-1e-5, 0.0),
)


@pytest.mark.parametrize(
    ("teeth_shift", "span", "over", "span_at", "ball_at"),
    [
        (KST_E[0], 17.090, 53.846, 50.788, 50.779),
        (KST_E[1], 17.180, 55.064, 51.728, 52.146),
    ],
)
def test_stplus_pair_kst_e(teeth_shift, span, over, span_at, ball_at):
    one = CylindricalGear(teeth_shift[0], 1 * MM, profile_shift=teeth_shift[1])
    assert inspection.span_measurement(one, 6) / MM == pytest.approx(span, abs=1e-3)
    assert inspection.dimension_over_balls(one, 1.75 * MM) / MM == pytest.approx(over, abs=2e-3)
    # STplus gives the places of contact for the upper allowances of the span, −278 and −207 µm.
    allowance = {51: -0.278, 52: -0.207}[one.teeth] * MM
    worn = replace(one, thickness_allowance=allowance / cos(radians(20)))
    assert inspection.span_contact_diameter(worn, 6) / MM == pytest.approx(span_at, abs=2e-3)
    assert inspection.ball_contact_diameter(worn, 1.75 * MM) / MM == pytest.approx(ball_at, abs=2e-3)


def test_helical_pair_by_din_21773():
    first, second = HELICAL
    assert inspection.span_teeth(first) in (2, 3, 4)  # k_min to k_max of that report
    assert inspection.span_measurement(first, 3) / MM == pytest.approx(15.5967, abs=5e-5)
    assert inspection.span_measurement(second, 5) / MM == pytest.approx(27.9068, abs=5e-5)
    assert inspection.dimension_over_balls(first, 3.5 * MM) / MM == pytest.approx(58.0771, abs=5e-5)
    assert inspection.dimension_over_balls(second, 3.5 * MM) / MM == pytest.approx(90.1508, abs=5e-5)
    assert inspection.dimension_over_pins(first, 3.5 * MM) / MM == pytest.approx(58.1850, abs=5e-5)
    assert inspection.dimension_over_pins(second, 3.5 * MM) == inspection.dimension_over_balls(
        second, 3.5 * MM
    )


@given(gears)
def test_a_span_is_turned_back_into_its_shift(gear):
    k = inspection.span_teeth(gear)
    back = inspection.with_span(gear, inspection.span_measurement(gear, k), k)
    assert back.profile_shift == pytest.approx(gear.generating_profile_shift, abs=1e-10)
    assert back.thickness_allowance == 0.0


@given(gears, st.booleans())
def test_a_dimension_over_balls_is_turned_back_into_its_shift(gear, pins):
    ball = 1.75 * gear.normal_module
    measure = inspection.dimension_over_pins if pins else inspection.dimension_over_balls
    back = inspection.with_dimension_over_balls(gear, measure(gear, ball), ball, pins)
    assert back.profile_shift == pytest.approx(gear.generating_profile_shift, abs=1e-9)


@given(gears)
def test_the_ideal_ball_touches_where_it_should(gear):
    at = gear.reference_diameter + 2 * gear.profile_shift * gear.normal_module
    if at <= gear.base_diameter * 1.001:
        return
    ball = inspection.ideal_ball_diameter(gear)
    assert inspection.ball_contact_diameter(gear, ball) == pytest.approx(at, rel=1e-9)


@given(gears)
def test_one_more_tooth_is_one_more_normal_base_pitch(gear):
    k = inspection.span_teeth(gear)
    step = inspection.span_measurement(gear, k + 1) - inspection.span_measurement(gear, k)
    assert step == pytest.approx(gear.transverse_base_pitch * cos(gear.base_helix_angle), rel=1e-11)


@given(gears)
def test_an_allowance_shortens_the_span_by_its_part_along_the_normal(gear):
    k = inspection.span_teeth(gear)
    shorter = inspection.span_measurement(gear, k) - inspection.span_measurement(gear.nominal(), k)
    assert shorter == pytest.approx(gear.thickness_allowance * cos(radians(20)), abs=1e-15)


def test_a_ball_lies_where_drawing_its_circle_puts_it():
    # Spur: the ball is tangent to an involute, so the tangent from its centre to the base circle passes its
    # contact.
    gear, ball = CylindricalGear(20, 3 * MM, profile_shift=0.3), 5.25 * MM
    centre = inspection.ball_centre_diameter(gear, ball) / 2
    base = gear.base_diameter / 2
    roll = sqrt(centre**2 - base**2) - ball / 2  # along the normal, from the base circle to the contact
    contact = hypot(base, roll)
    half_space = pi / 20 - gear.transverse_thickness(2 * contact) / (2 * contact)
    # Seen from the middle of the space the contact lies at this angle.
    assert acos(base / centre) - atan(roll / base) == pytest.approx(half_space, rel=1e-12)
    assert inspection.ball_contact_diameter(gear, ball) == pytest.approx(2 * contact, rel=1e-13)


def test_a_span_is_the_length_of_the_common_base_tangent():
    # The involute unrolls: over k teeth the tangent is k − 1 base pitches and one base tooth thickness.
    gear = CylindricalGear(24, 3 * MM, profile_shift=0.4)
    base = gear.transverse_thickness(gear.base_diameter)
    assert inspection.span_measurement(gear, 4) == pytest.approx(
        3 * gear.transverse_base_pitch + base, rel=1e-14
    )


def test_a_narrow_helical_gear_needs_this_face_width():
    first = HELICAL[0]
    assert inspection.span_face_width(first, 3) == pytest.approx(
        15.5967 * MM * sin(first.base_helix_angle), rel=1e-5
    )


def test_what_cannot_be_measured_is_refused_in_a_sentence():
    gear = CylindricalGear(20, 3 * MM)
    with pytest.raises(GearlashError, match="falls through"):
        inspection.dimension_over_balls(gear, 3 * MM)
    with pytest.raises(GearlashError, match="base circle"):
        inspection.with_dimension_over_balls(gear, 60 * MM, 5 * MM)
