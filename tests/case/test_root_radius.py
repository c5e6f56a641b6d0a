"""A root radius of a drawing that its rack has no room for is refused, with the largest that fits."""

from __future__ import annotations

import re
from math import cos, pi, radians, sin, tan

import pytest

from gearlash.case import Case, CaseError, loads

TEXT = """
kind = "spur-1dof"
[pinion]
teeth = 25
{pinion}
[gear]
teeth = 57
[mesh]
module = "3 mm"
pressure_angle = "{angle} deg"
face_width = "30 mm"
[operation]
pinion_speed = "1450 rpm"
torque = "100 N m"
"""


def case(angle: float, pinion: str) -> Case:
    return loads(TEXT.format(angle=angle, pinion=pinion))


def full(angle: float, dedendum: float) -> float:
    """ρ that touches both flanks and the tip of a rack: half its space at the tip, π/4 − h tan α, is that
    half-width of the rounding, ρ (1 − sin α)/cos α."""
    alpha = radians(angle)
    return (pi / 4 - dedendum * tan(alpha)) * cos(alpha) / (1 - sin(alpha))


@pytest.mark.parametrize(("angle", "dedendum"), [(20.0, 1.25), (25.0, 1.25), (20.0, 1.4), (14.5, 1.157)])
def test_the_full_radius_fits_and_more_is_refused_with_it(angle: float, dedendum: float):
    most = full(angle, dedendum)
    pinion = f"dedendum = {dedendum}\nroot_radius = "
    assert case(angle, f"{pinion}{most:.3g}").numbers.body.teeth.pinion.rack.root_radius <= most * (1 + 1e-12)
    below = case(angle, f"{pinion}{0.9 * most!r}")
    assert below.numbers.body.teeth.pinion.rack.root_radius == 0.9 * most
    with pytest.raises(CaseError) as refused:
        case(angle, f"{pinion}{1.05 * most!r}")
    (problem,) = refused.value.problems
    assert problem.path == "pinion.root_radius"
    told = re.search(r"up to ([\d.]+)", problem.expected)
    assert told is not None
    assert float(told[1]) == pytest.approx(most, abs=1e-4)
    case(angle, f"{pinion}{told[1]}")


def test_a_stated_root_diameter_tells_how_much_room_there_is():
    """d_f = 68 mm of z = 25, m = 3 mm, x = 0: h_fP = (75 − 68)/6."""
    most = full(20.0, 7 / 6)
    root = 'profile_shift = 0\nthickness_allowance = "0 um"\nroot_diameter = "68 mm"\nroot_radius = '
    found = case(20.0, f"{root}{most - 0.001!r}").numbers.body.teeth.pinion.rack
    assert (found.dedendum, found.root_radius) == pytest.approx((7 / 6, most - 0.001), rel=1e-9)
    with pytest.raises(CaseError, match=r"pinion\.root_radius"):
        case(20.0, f"{root}{1.01 * most!r}")


def test_a_radius_that_only_the_rack_has_is_as_large_as_there_is_room():
    rack = case(25.0, "").numbers.body.teeth.pinion.rack
    assert rack.root_radius == pytest.approx(full(25.0, 1.25), rel=1e-12)
