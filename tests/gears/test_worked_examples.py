"""Worked examples that others print, each with its source; every number to the digits that are printed.

- KHK: Gear Technical Reference of Kohara Gear Industry Co., calculation of gear dimensions: profile shifted
  helical gears in the normal system, and span measurement of spur and helical gears. Its steps go on from
  rounded numbers: two values (y = 0.09744, d_f1 = 34.657) are one off in the last digit, so one is allowed.
- MESYS: gear measurement by MESYS AG for Ondrives Ltd., www.mesys.ch/calc/ondrives.fcgi, the values of its
  page (DIN 867 with 1.25, 0.20, 1.00; DIN 3967, DIN 3960).
- Norton: R. L. Norton, Machine Design, an Integrated Approach, example 12-1 (19 and 37 teeth, 6 per inch).
- Shifts: Gear Generating Profile Shift Calculations, Scribd document 376176518, by ISO 21771:2007, equations
  (62) and (63).
- Maatar and Velex, J. Mech. Des. 118 (1996) 586: lengths of contact lines.
"""

from __future__ import annotations

from dataclasses import replace
from math import cos, degrees, pi, radians

import numpy as np
import pytest

from gearlash.gears import CylindricalGear, CylindricalPair, backlash, inspection
from gearlash.gears.basic_rack import BasicRack
from gearlash.gears.cylindrical_pair import shift_sum, tip_shortening
from gearlash.gears.flank_modification import PairModification
from gearlash.gears.loaded_mesh import contact_lines
from gearlash.gears.materials import named
from gearlash.gears.pair_shape import PairShape

MM = 1e-3


def gear(z: int, m: float, beta: float = 0.0, x: float = 0.0, **more) -> CylindricalGear:
    """In mm and degrees."""
    return CylindricalGear(z, m * MM, radians(beta), x, **more)


def test_profile_shifted_helical_pair_of_khk():
    pair = CylindricalPair(gear(12, 3, 30, 0.09809), gear(60, 3, 30), 125 * MM)
    first, second = pair.gears
    assert round(degrees(first.transverse_pressure_angle), 5) == 22.79588
    assert round(degrees(pair.working_pressure_angle), 4) == 23.1126
    assert round(shift_sum(pair), 5) == 0.09809
    moved = (pair.centre_distance - pair.reference_centre_distance) / first.normal_module
    assert moved == pytest.approx(0.09744, abs=1e-5)
    printed = {
        "reference_diameter": (41.569, 207.846),
        "base_diameter": (38.322, 191.611),
        "root_diameter": (34.657, 200.346),
    }
    for name, values in printed.items():
        assert [getattr(one, name) / MM for one in pair.gears] == pytest.approx(values, abs=1e-3), name
    assert [round(d / MM, 3) for d in pair.working_diameters] == [41.667, 208.333]
    tips = [one.tip_diameter + 2 * tip_shortening(pair) for one in pair.gears]
    assert [d / MM for d in tips] == pytest.approx([48.153, 213.842], abs=1e-3)
    assert [(tip - one.root_diameter) / 2 / MM for tip, one in zip(tips, (first, second), strict=True)] == (
        pytest.approx([6.748, 6.748], abs=1e-3)
    )


def test_span_measurements_of_khk():
    spur, helical = gear(24, 3, 0, 0.4), gear(24, 3, 25, 0.4)
    assert inspection.span_teeth(spur) == 4
    assert round(inspection.span_measurement(spur, 4) / MM, 4) == 32.8266
    assert inspection.span_teeth(helical) == 5
    assert round(inspection.span_measurement(helical, 5) / MM, 4) == 42.0085


@pytest.mark.parametrize(
    ("allowance", "root", "form", "thickness", "tip", "shift", "radial", "over", "contact"),
    [
        (-0.06, 27.3352, 28.3762, 1.5108, 0.6734, -0.0824, 16.0821, 32.1641, 29.8612),
        (-0.03, 27.4176, 28.4047, 1.5408, 0.7054, -0.0412, 16.1190, 32.2380, 29.9256),
    ],
)
def test_a_gear_of_mesys(allowance, root, form, thickness, tip, shift, radial, over, contact):
    rack = BasicRack(dedendum=1.25, root_radius=0.2)
    one = gear(30, 1, rack=rack, thickness_allowance=allowance * MM)
    ball = 1.7 * MM
    found = (
        one.root_diameter / MM, one.root_form_diameter / MM, one.normal_thickness() / MM,
        one.tip_thickness() / MM, one.generating_profile_shift,
        inspection.dimension_over_balls(one, ball) / 2 / MM, inspection.dimension_over_pins(one, ball) / MM,
        inspection.ball_contact_diameter(one, ball) / MM,
    )  # fmt: skip
    printed = root, form, thickness, tip, shift, radial, over, contact
    assert found == pytest.approx(printed, abs=0.6e-4)
    assert (round(one.base_diameter / MM, 4), round(one.undercut_limit, 4)) == (28.1908, -0.6363)


def test_path_of_contact_and_a_larger_centre_distance_of_norton():
    inch = 25.4 * MM
    pair = CylindricalPair(gear(19, 25.4 / 6), gear(37, 25.4 / 6))
    start, end = pair.path_of_contact
    assert round((end - start) / inch, 3) == 0.798
    assert round(pair.transverse_contact_ratio, 2) == 1.62
    assert round(pair.pinion.transverse_base_pitch / inch, 3) == 0.492
    further = replace(pair, stated_centre_distance=1.02 * pair.centre_distance)
    assert round(degrees(further.working_pressure_angle), 2) == 22.89


def test_generating_profile_shifts_by_iso_21771():
    total, play = 0.651877131252, 0.03 * MM
    thinner = -play / 2 / cos(radians(20))
    pair = CylindricalPair(
        gear(31, 3.5, 21, 0.291, thickness_allowance=thinner),
        gear(30, 3.5, 21, total - 0.291, thickness_allowance=thinner),
        116.5 * MM,
    )
    assert degrees(pair.pinion.transverse_pressure_angle) == pytest.approx(21.2990642859, abs=1e-10)
    assert pair.reference_centre_distance / MM == pytest.approx(114.3447280708, abs=1e-10)
    assert degrees(pair.working_pressure_angle) == pytest.approx(23.8707609654, abs=1e-10)
    assert shift_sum(pair) == pytest.approx(total, abs=1e-10)
    assert sum(one.generating_profile_shift for one in pair.gears) == pytest.approx(0.639346541, abs=1e-9)
    assert backlash.of_pair(pair).normal == pytest.approx(play, rel=1e-6)


@pytest.mark.parametrize(("beta", "width"), [(10.0, 15.0), (15.0, 40.0), (25.0, 22.0), (32.0, 9.0)])
def test_contact_lines_of_equal_stiffness_have_the_ratio_of_maatar_and_velex(beta, width):
    pair = CylindricalPair(gear(25, 3, beta), gear(57, 3, beta), face_width=width * MM)
    steel = named("steel"), named("steel")
    lines = contact_lines(pair, PairModification(), 1e5, steel, PairShape.CONSTANT)
    first, second = np.real(lines.under(1.0).stiffness_harmonics(2))
    ratio = cos(pi * pair.transverse_contact_ratio) * cos(pi * pair.overlap_ratio)
    assert second == pytest.approx(ratio * first, abs=1e-3)
