"""Backlash: its five ways of saying, tolerances, temperature; against examples of others and the teeth
themselves.

FVA STplus 11.0F for the pair kst-E, as transcribed in the tests of the open project gearcore: span allowances
of −278 and −207 µm give j_n = 0.485 mm and j_wt = 0.521 mm; A_a = ±15 µm (js7) changes them by 11 and 12 µm.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import cos, isclose, nextafter, pi, radians, sin, tan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.gears import CylindricalGear, CylindricalPair, backlash, gear_fits
from gearlash.gears.backlash import Backlash, Growth
from gearlash.gears.cylindrical_pair import shift_sum
from gearlash.system import GearlashError

MM, UM = 1e-3, 1e-6
SHIFT = (1.719 - pi / 2) / (2 * tan(radians(20)))


def kst_e() -> CylindricalPair:
    """x_2 follows from the centre distance, as in STplus."""
    loose = CylindricalPair(
        CylindricalGear(51, MM, profile_shift=SHIFT), CylindricalGear(52, MM), 52.0 * MM, 20 * MM
    )
    pair = replace(loose, gear=replace(loose.gear, profile_shift=shift_sum(loose) - SHIFT))
    along = cos(radians(20))
    return replace(
        pair,
        pinion=replace(pair.pinion, thickness_allowance=-278 * UM / along),
        gear=replace(pair.gear, thickness_allowance=-207 * UM / along),
    )


def test_stplus_pair_kst_e():
    play = backlash.of_pair(kst_e())
    assert play.normal / MM == pytest.approx(0.485, abs=5e-4)
    assert play.circumferential / MM == pytest.approx(0.521, abs=5e-4)
    deviation = gear_fits.centre_distance_deviation(7, 52 * MM)
    assert deviation / UM == pytest.approx(15.0, abs=0.5)
    wider = replace(kst_e(), stated_centre_distance=52 * MM + 15 * UM)
    wide = backlash.of_pair(wider)
    assert (wide.circumferential - play.circumferential) / MM == pytest.approx(0.012, abs=5e-4)
    assert (wide.normal - play.normal) / MM == pytest.approx(0.011, abs=5e-4)


def pair_of(teeth: tuple[int, int], module: float, beta: float, shifts: tuple[float, float]):
    """Without backlash, beta in degrees."""
    first, second = (CylindricalGear(teeth[i], module, radians(beta), shifts[i]) for i in (0, 1))
    return CylindricalPair(first, second, face_width=0.02)


pairs = st.builds(
    pair_of,
    teeth=st.tuples(st.integers(17, 150), st.integers(17, 150)),
    module=st.floats(5e-4, 2e-2),
    beta=st.floats(-35, 35),
    shifts=st.tuples(st.floats(0.0, 0.5), st.floats(0.0, 0.5)),
)


@given(pairs)
def test_without_allowances_the_tight_distance_has_no_backlash(pair):
    assert abs(backlash.of_pair(pair).normal) < 1e-12 * pair.centre_distance


@given(pairs, st.floats(1e-5, 3e-4))
def test_each_way_of_saying_leads_back_to_the_normal_one(pair, normal):
    play = Backlash.from_normal(pair, normal)
    ways = [
        Backlash.from_circumferential(pair, play.circumferential),
        Backlash.from_reference_arc(pair, play.reference_arc),
        Backlash.from_radial(pair, play.radial),
        *(Backlash.from_angle(pair, play.angles[i], i) for i in (0, 1)),
    ]
    assert all(isclose(way.normal, normal, rel_tol=1e-12) for way in ways)
    assert play.angles[0] / play.angles[1] == pytest.approx(pair.ratio, rel=1e-12)
    on_base = play.angles[0] * pair.pinion.base_diameter / 2
    assert on_base == pytest.approx(play.transverse, rel=1e-12)


@given(pairs, st.floats(1e-6, 1e-4))
def test_small_deviations_follow_the_first_order_of_iso_21771(pair, small):
    # j_n = −(E_sn1 + E_sn2) cos α_n + 2 A_a sin α_wt cos β_b, for deviations small against the module.
    deviation = small * pair.pinion.normal_module
    play = backlash.of_pair(
        replace(
            pair,
            pinion=replace(pair.pinion, thickness_allowance=-deviation),
            gear=replace(pair.gear, thickness_allowance=-2 * deviation),
            stated_centre_distance=pair.centre_distance + deviation,
        )
    )
    thickness = 3 * cos(pair.pinion.rack.pressure_angle)
    distance = 2 * sin(pair.working_pressure_angle) * cos(pair.pinion.base_helix_angle)
    assert play.normal == pytest.approx((thickness + distance) * deviation, rel=1e-3, abs=1e-12)


def test_the_arc_on_the_working_circle_is_what_tooth_and_space_leave():
    pair = replace(kst_e(), stated_centre_distance=52.1 * MM)
    first, second = pair.working_diameters
    tooth = pair.pinion.transverse_thickness(first)
    space = pi * second / 52 - pair.gear.transverse_thickness(second)
    assert backlash.of_pair(pair).circumferential == pytest.approx(space - tooth, rel=1e-11)


def test_a_drive_of_one_material_grows_like_its_drawing():
    even = backlash.of_pair(kst_e(), Growth(1e-3, 1e-3, 1e-3))
    assert even.normal == pytest.approx(1.001 * backlash.of_pair(kst_e()).normal, rel=1e-9)


def test_hot_plastic_gears_in_a_cold_housing_lose_backlash():
    growth = Growth.thermal((110e-6, 110e-6, 11.5e-6), (60.0, 60.0, 20.0))
    hot, cold = backlash.of_pair(kst_e(), growth), backlash.of_pair(kst_e())
    # First order: the gears' own centre distance grows by 110e-6·60·a, the housing by 11.5e-6·20·a.
    missing = (110e-6 * 60 - 11.5e-6 * 20) * 52 * MM * 2 * tan(radians(21.4625))
    assert cold.circumferential - hot.circumferential == pytest.approx(missing, rel=0.03)


def test_growth_of_one_gear_alone_is_that_of_its_radius():
    slight = 1e-7
    change = backlash.of_pair(kst_e(), Growth(pinion=slight)).normal - backlash.of_pair(kst_e()).normal
    pair = kst_e()
    radius = pair.working_diameters[0] / 2
    tooth = pair.pinion.transverse_thickness(pair.working_diameters[0]) * cos(pair.working_pressure_angle)
    # The radius presses along 2 sin α_wt; the tooth grows; the space it meets stays that of the gear.
    expected = -slight * (2 * radius * sin(pair.working_pressure_angle) + tooth)
    assert change == pytest.approx(expected, rel=1e-5)


def test_base_circles_that_meet_are_refused():
    with pytest.raises(GearlashError, match="base circles"):
        backlash.of_pair(kst_e(), Growth(0.1, 0.1, 0.0))


def test_the_fit_of_the_standards_example_and_its_ends():
    def fit(designation: str, d: float) -> list[int]:
        return [round(a / UM) for a in gear_fits.thickness_allowances(designation, d * MM)]

    assert fit("27cd", 100) == [-70, -170]
    assert fit("cd 27", 100) == [-70, -170]
    assert fit("25cd", 40) == [-54, -84]
    assert (fit("21a", 10), fit("21a", 10.001)) == ([-100, -103], [-135, -140])
    assert fit("30h", 10000) == [0, -2400]


def test_series_of_the_fits_grow_with_diameter_and_fall_from_a_to_h():
    bounds = (5, 30, 100, 200, 400, 800, 1300, 2000, 3000, 5000, 8000)
    for series in gear_fits.ALLOWANCE_SERIES[:-1]:
        uppers = [gear_fits.thickness_allowances(f"21{series}", d * MM)[0] for d in bounds]
        assert all(late < early for early, late in pairwise(uppers))
    for d in bounds:
        row = [gear_fits.thickness_allowances(f"21{s}", d * MM)[0] for s in gear_fits.ALLOWANCE_SERIES]
        assert row == sorted(row)
        widths = [-1 * gear_fits.thickness_allowances(f"{n}h", d * MM)[1] for n in gear_fits.TOLERANCE_SERIES]
        assert widths == sorted(widths)


@pytest.mark.parametrize("wrong", ["20cd", "27i", "cd", "27", "31a", "27ac"])
def test_a_fit_that_is_none_is_refused(wrong):
    with pytest.raises(GearlashError, match="DIN 3967"):
        gear_fits.thickness_allowances(wrong, 0.1)


def test_a_wheel_larger_than_the_standard_is_refused():
    with pytest.raises(GearlashError, match="ends at 10 m"):
        gear_fits.thickness_allowances("27cd", 10.1)


@pytest.mark.parametrize(  # ISO 286-1, standard tolerances as printed, µm
    ("grade", "size", "printed"),
    [
        (7, 25, 21),
        (7, 100, 35),
        (7, 250, 46),
        (6, 60, 19),
        (8, 150, 63),
        (9, 40, 62),
        (7, 450, 63),
        (8, 700, 125),
    ],
)
def test_centre_distance_deviations_are_half_the_standard_tolerance(grade, size, printed):
    assert 2 * gear_fits.centre_distance_deviation(grade, size * MM) / UM == pytest.approx(printed, rel=0.03)


def test_a_distance_without_standard_tolerance_is_refused():
    with pytest.raises(GearlashError, match="3150 mm"):
        gear_fits.centre_distance_deviation(7, 4.0)


@pytest.mark.parametrize("limit", [3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500, 630, 1000, 3150])
def test_a_size_at_the_end_of_a_range_is_in_it_however_it_was_rounded(limit: int):
    """In the last digits of double precision; what is larger by as little as is measured lies in the next."""
    size = limit * MM
    own = gear_fits.centre_distance_deviation(7, size)
    for _ in range(4):
        size = nextafter(size, 10.0)
        assert gear_fits.centre_distance_deviation(7, size) == own
    if limit < 3150:
        assert gear_fits.centre_distance_deviation(7, (limit + 1e-5) * MM) > own


def test_a_computed_centre_distance_of_18_mm_has_the_tolerance_of_that_size():
    """IT7 of 10 to 18 mm: 16 (0.45 ∛√180 + 0.001 √180) µm, by hand."""
    pair = CylindricalPair(CylindricalGear(24, 0.5e-3), CylindricalGear(48, 0.5e-3), face_width=5e-3)
    mean = (10 * 18) ** 0.5
    hand = 0.5e-6 * 16 * (0.45 * mean ** (1 / 3) + 0.001 * mean)
    assert gear_fits.centre_distance_deviation(7, pair.centre_distance) == pytest.approx(hand, rel=1e-12)
    for limit in (10, 50, 125, 280, 560, 1000):
        size = limit * MM
        for near in (nextafter(size, 0.0), nextafter(nextafter(size, 10.0), 10.0)):
            assert gear_fits.thickness_allowances("25cd", near) == gear_fits.thickness_allowances(
                "25cd", size
            )
