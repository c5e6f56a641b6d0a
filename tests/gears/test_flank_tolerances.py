"""Flank tolerances and the unloaded error: numbers of others, steps of √2, and what no signal can exceed.

z = 40, m_n = 3 mm, b = 30 mm, class 6: f_pT = 9.0, F_pT = 29, F_αT = 12 µm, as an open calculator of the
standard gives them, rounded. Class 5 of the edition of 1995 for the middle of its ranges: printed f_pt, F_p
and F_α.
"""

from __future__ import annotations

from dataclasses import fields
from math import cos, pi, radians, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.gears import CylindricalGear, CylindricalPair
from gearlash.gears.flank_tolerances import FlankTolerances, class_factor, flank_tolerances, rounded
from gearlash.gears.unloaded_error import tooth_to_tooth_limit, unloaded_error
from gearlash.system import GearlashError

UM = 1e-6
GEAR = CylindricalGear(40, 3e-3)
PAIR = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), None, 0.02)


def test_class_6_as_others_give_it():
    found = flank_tolerances(GEAR, 6, 0.03)
    assert rounded(found.single_pitch) / UM == pytest.approx(9.0)
    assert rounded(found.total_pitch) / UM == pytest.approx(29.0)
    assert rounded(found.profile) / UM == pytest.approx(12.0)
    assert found.runout == pytest.approx(0.9 * found.total_pitch, rel=1e-15)
    assert found.beyond == ()


def test_class_5_by_hand():
    # d = 120, m = 3, b = 30: √d = 10.954, √b = 5.477.
    found = flank_tolerances(GEAR, 5, 0.03)
    values = [
        value / UM for value in (found.profile_slope, found.profile_form, found.helix_slope, found.helix_form)
    ]
    assert values == pytest.approx([5.32, 6.65, 6.46474, 7.23156], abs=1e-4)
    assert found.helix == pytest.approx(sqrt(found.helix_slope**2 + found.helix_form**2), rel=1e-14)


@pytest.mark.parametrize("grade", range(1, 12))
def test_two_classes_are_a_factor_of_two(grade):
    coarse, fine = flank_tolerances(GEAR, grade, 0.03), flank_tolerances(GEAR, 5, 0.03)
    for field in fields(FlankTolerances)[:-1]:
        assert getattr(coarse, field.name) == pytest.approx(
            sqrt(2) ** (grade - 5) * getattr(fine, field.name), rel=1e-14
        )


def test_the_editions_of_1995_and_2013_are_near_each_other():
    # 1995, class 5, m = 3, d = 120: f_pt = 0.3 (m + 0.4 √d) + 4, F_p = 0.3 m + 1.25 √d + 7, F_α = 3.2 √m +
    # 0.22 √d + 0.7.
    found = flank_tolerances(GEAR, 5, 0.03)
    assert found.single_pitch / UM == pytest.approx(0.3 * (3 + 0.4 * sqrt(120)) + 4, rel=0.05)
    assert found.total_pitch / UM == pytest.approx(0.9 + 1.25 * sqrt(120) + 7, rel=0.1)
    assert found.profile / UM == pytest.approx(3.2 * sqrt(3) + 0.22 * sqrt(120) + 0.7, rel=0.05)


def test_tooth_to_tooth_limit_of_the_edition_of_1995():
    # f_i′ = K (9 + 0.3 m + 3.2 √m + 0.34 √d) for class 5 there.
    for ratio, factor in ((1.6, 0.7), (2.0, 0.6), (4.0, 0.4), (6.0, 0.4)):
        expected = factor * (9 + 0.9 + 3.2 * sqrt(3) + 0.34 * sqrt(120))
        assert tooth_to_tooth_limit(GEAR, 5, 0.03, ratio) / UM == pytest.approx(expected, rel=0.02)


def test_the_greatest_amplitude_is_that_of_a_square_wave():
    found = unloaded_error(PAIR, (6, 7))
    along = cos(radians(20))
    assert found.mesh.greatest == pytest.approx(2 / pi * sum(found.limits) * along, rel=1e-14)
    assert 0.0 == found.mesh.least < found.mesh.nominal < found.mesh.greatest
    assert found.limits[1] > found.limits[0]


@given(st.lists(st.floats(0.0, 1.0), min_size=8, max_size=64))
def test_no_signal_within_p_has_a_harmonic_above_2_p_over_pi(samples):
    # A staircase signal: its harmonics in closed form.
    values, count = np.array(samples), len(samples)
    edges = 2 * pi * np.arange(count + 1) / count
    for order in (1, 2, 3):
        steps = np.exp(-1j * order * edges)
        coefficient = abs(np.sum(values * np.diff(steps) / (-1j * order))) / pi
        assert coefficient <= 2 / pi * np.ptp(values) + 1e-12


def test_shafts_are_limited_by_their_total_pitch():
    found = unloaded_error(PAIR, (6, 6))
    total = flank_tolerances(PAIR.gear, 6, 0.02).total_pitch
    assert found.shafts[1].greatest == pytest.approx(2 / pi * total * cos(radians(20)))
    assert found.shafts[0].greatest < found.shafts[1].greatest


def test_more_teeth_in_contact_average_the_error():
    spur, helical = (
        CylindricalPair(CylindricalGear(25, 2e-3, beta), CylindricalGear(57, 2e-3, beta), None, 0.02)
        for beta in (0.0, radians(20))
    )
    assert unloaded_error(helical, (6, 6)).mesh.greatest < 0.9 * unloaded_error(spur, (6, 6)).mesh.greatest


def test_what_the_standard_does_not_cover_is_told():
    tiny = flank_tolerances(CylindricalGear(4, 0.3e-3), 12, 2e-3)
    assert len(tiny.beyond) == 5
    pair = CylindricalPair(CylindricalGear(25, 0.4e-3), CylindricalGear(57, 0.4e-3), None, 0.01)
    assert unloaded_error(pair, (6, 6)).beyond == ("m_n = 0.4 mm: the standard is for 0.5 to 70 mm",)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: class_factor(0), "1 to 11"),
        (lambda: class_factor(13), "1 to 11"),
        (lambda: flank_tolerances(GEAR, 6, 0.0), "face width"),
    ],
)
def test_what_is_no_class_is_refused(make, says):
    with pytest.raises(GearlashError, match=says):
        make()
