"""The outline of a gear: true involutes, and two of them in mesh that touch and never cut into each other."""

from __future__ import annotations

from math import pi, radians

import numpy as np
import pytest

from gearlash.gears import CylindricalGear, CylindricalPair, backlash
from gearlash.gears.involute import inv
from gearlash.gears.outline import half_tooth, outline

PAIRS = [
    CylindricalPair(CylindricalGear(25, 3e-3, radians(15)), CylindricalGear(57, 3e-3, radians(15))),
    CylindricalPair(CylindricalGear(12, 2e-3), CylindricalGear(90, 2e-3)),
    CylindricalPair(CylindricalGear(17, 8e-3, radians(30), 0.4), CylindricalGear(18, 8e-3, radians(30), 0.2)),
]


@pytest.mark.parametrize("gear", [gear for pair in PAIRS for gear in pair.gears])
def test_flanks_are_involutes_between_root_and_tip(gear: CylindricalGear):
    radius, angle = half_tooth(gear)
    assert radius[-1] == pytest.approx(0.5 * gear.tip_diameter)
    assert radius[0] == pytest.approx(0.5 * gear.root_diameter, rel=1e-6)
    assert np.all(np.diff(radius) > 0.0)
    flank = radius > 0.5 * max(gear.root_form_diameter, gear.base_diameter)
    turned = angle[flank] + [inv(gear.pressure_angle_at(2.0 * float(r))) for r in radius[flank]]
    assert np.ptp(turned) < 1e-12
    assert np.all(angle <= pi / gear.teeth)
    x, y = outline(gear, 0.3)
    assert np.hypot(x, y).max() == pytest.approx(0.5 * gear.tip_diameter)


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("turned", [0.0, 0.2, 0.45, 0.8])
def test_teeth_in_mesh_touch_and_do_not_cut(pair: CylindricalPair, turned: float):
    """Points of the pinion lie inside the gear by rounding at most, however far both are turned."""
    assert backlash.of_pair(pair).normal == pytest.approx(0.0, abs=1e-12)
    first, second = pair.gears
    halves = [
        gear.transverse_thickness(working) / working
        for gear, working in zip(pair.gears, pair.working_diameters, strict=True)
    ]
    step = 2.0 * pi * turned
    x, y = outline(first, pi / 2 + halves[0] - step / first.teeth)
    away = pair.centre_distance - y  # seen from the gear's axis, downwards
    radius, angle = np.hypot(x, away), np.arctan2(x, away)
    pitch = 2.0 * pi / second.teeth
    beside = np.abs((angle - halves[1] - step / second.teeth + 0.5 * pitch) % pitch - 0.5 * pitch)
    radii, flank = half_tooth(second)
    inside = (radius > radii[0]) & (radius < radii[-1])
    depth = (np.interp(radius, radii, flank) - beside)[inside] * radius[inside]
    assert depth.max() < 2e-3 * first.normal_module  # chords of drawn points
    assert depth.max() > -0.05 * first.normal_module  # and somewhere they touch
