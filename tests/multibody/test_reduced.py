"""Modes of free gear bodies: against closed forms of rods, plates and rigid bodies."""

from __future__ import annotations

from math import cos, radians, sin, sqrt

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import iv, ivp, jn_zeros, jv, jvp

from gearlash.gears import CylindricalGear
from gearlash.gears.gear_body import GearBody
from gearlash.gears.materials import named
from gearlash.multibody.reduced import FlexibleBody, flexible_body
from gearlash.multibody.revolution import meridian, wave_model
from gearlash.system import GearlashError

STEEL = named("steel")
WEBBED = GearBody(0.28, 0.06, 0.05, rim_inner_diameter=0.25, web_width=0.015, hub_diameter=0.08)


def of_waves(body: FlexibleBody, waves: int) -> np.ndarray:
    return body.frequency[(body.waves == waves) & ~body.quarter]


def kirchhoff(n: int, poisson: float, low: float, high: float) -> float:
    """λ² of a thin free disc, ω = λ²/R² √(D/ρh): A. W. Leissa, Vibration of Plates, NASA SP-160, 2.1.3."""
    soft = 1.0 - poisson

    def condition(x: float) -> float:
        j, dj, i, di = jv(n, x), x * jvp(n, x), iv(n, x), x * ivp(n, x)
        moments = x * x * j + soft * (dj - n * n * j), x * x * i - soft * (di - n * n * i)
        shears = x * x * dj + soft * n * n * (dj - j), x * x * di - soft * n * n * (di - i)
        return moments[0] * shears[1] - moments[1] * shears[0]

    root = float(brentq(condition, low, high))  # pyright: ignore[reportArgumentType]
    return root**2


@pytest.mark.parametrize(
    ("waves", "leissa", "low", "high"), [(2, 5.358, 2.0, 2.6), (0, 9.003, 2.7, 3.3), (3, 12.44, 3.2, 3.8)]
)
def test_a_thin_disc_moves_as_a_plate(waves: int, leissa: float, low: float, high: float):
    radius, thick = 0.15, 1.5e-3
    disc = flexible_body(GearBody(2 * radius, thick), greatest_waves=3, interface_modes=3, size=radius / 12)
    bending = STEEL.youngs_modulus * thick**2 / (12.0 * STEEL.density * (1.0 - STEEL.poisson_ratio**2))
    plate = kirchhoff(waves, STEEL.poisson_ratio, low, high)
    assert plate == pytest.approx(leissa, rel=1e-3)
    of_disc = of_waves(disc, waves)[0] / (sqrt(bending) / radius**2)
    assert of_disc == pytest.approx(plate, rel=2e-3)


def test_a_disc_twists_as_the_wave_equation_says():
    """V = J_1(kr), free where J_2(kR) = 0: exact in three dimensions."""
    disc = flexible_body(GearBody(0.3, 0.02), greatest_waves=0, interface_modes=8, size=0.01)
    twisting = disc.frequency[disc.quarter]
    shear_speed = sqrt(0.5 * STEEL.youngs_modulus / (1.0 + STEEL.poisson_ratio) / STEEL.density)
    assert twisting[0] == pytest.approx(jn_zeros(2, 1)[0] * shear_speed / 0.15, rel=1e-3)


@pytest.mark.parametrize("waves", [0, 1])
def test_a_rigid_motion_has_no_strain_and_the_mass_of_the_rings(waves: int):
    model = wave_model(meridian(WEBBED, 0.01), STEEL, waves)
    stored = model.rigid.T @ (model.stiffness @ model.rigid)
    assert np.abs(stored).max() < 1e-12 * abs(model.stiffness).max()
    mass = model.rigid.T @ (model.mass @ model.rigid)
    body = flexible_body(WEBBED, greatest_waves=0, interface_modes=1, size=0.01)
    second = body.axial_inertia if waves == 0 else body.transverse_inertia
    assert np.diag(mass) == pytest.approx([body.mass, second], rel=1e-9)
    assert abs(mass[0, 1]) < 1e-12 * body.mass


def test_the_modes_of_the_free_body_are_converged():
    coarse, fine = (
        flexible_body(WEBBED, greatest_waves=2, interface_modes=count, size=size)
        for count, size in ((6, 0.012), (12, 0.006))
    )
    assert fine.first(8).frequency == pytest.approx(coarse.first(8).frequency, rel=0.01)


def test_the_hub_moves_in_modes_of_no_wave_or_one_alone():
    body = flexible_body(WEBBED, greatest_waves=2, interface_modes=4, size=0.012)
    along_x, along_y = (body.hub[(body.waves == 1) & (body.quarter == turned)] for turned in (False, True))
    assert np.abs(along_x[:, [0, 4]]).min(axis=1).max() > 0.0
    assert not along_x[:, [1, 2, 3, 5]].any()
    assert along_y[:, 1] == pytest.approx(along_x[:, 0])
    assert along_y[:, 3] == pytest.approx(-along_x[:, 4])
    assert not body.hub[body.waves == 2].any()


def test_displacement_at_a_flank_is_that_of_the_body_along_the_normal():
    gear = CylindricalGear(70, 4e-3, radians(18.0))
    body = flexible_body(GearBody(0.2944, 0.065), greatest_waves=3, interface_modes=2, size=0.02)
    pressure, heights = radians(21.0), np.array([-0.02, 0.0, 0.015])
    shapes = body.at_flanks(gear, pressure, heights)
    angle = 0.7
    tilt = gear.base_helix_angle
    for side, sign in ((0, 1.0), (1, -1.0)):
        normal = [cos(tilt) * sin(pressure), sign * cos(tilt) * cos(pressure), -sign * sin(tilt)]
        for mode, n in enumerate(body.waves):
            c, s = cos(n * angle), sin(n * angle)
            waves = (s, -c, s) if body.quarter[mode] else (c, s, c)
            for slice_, height in enumerate(sign * heights):
                moved = [np.interp(height, body.heights, body.rim[mode, :, k]) * waves[k] for k in range(3)]
                expected = float(np.dot(moved, normal))
                a, b = shapes[side, mode, slice_]
                assert a * c + b * s == pytest.approx(expected, abs=1e-12)


def test_a_hub_inside_the_bore_is_refused():
    with pytest.raises(GearlashError, match="inside the bore"):
        flexible_body(WEBBED, hub_radius=0.01, greatest_waves=0, interface_modes=1, size=0.02)
