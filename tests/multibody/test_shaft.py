"""A pinion in one piece with its shaft: free modes against rods and beams, and what bearings feel of them."""

from __future__ import annotations

from dataclasses import replace
from math import pi, sqrt

import numpy as np
import pytest

from gearlash.gears.materials import named
from gearlash.multibody import Bearings, Machine, Modes, RigidBody
from gearlash.multibody.interface import seat_interface
from gearlash.multibody.reduced import FlexibleBody, flexible_shaft
from gearlash.system import GearlashError

STEEL = named("steel")
PINION = (0.118, 0.07, 0.059, 0.15)
"""Pitch diameter, face width, shaft, its length: about the pinion of the article."""


def lowest(body: FlexibleBody, waves: int, quarter: bool) -> float:
    return float(body.frequency[(body.waves == waves) & (body.quarter == quarter)][0])


def test_a_slender_shaft_bends_stretches_and_twists_as_a_rod():
    thick, length = 0.02, 0.3
    rod = flexible_shaft(thick, length, 0.5 * thick, length, greatest_waves=1, interface_modes=6, size=0.01)
    modulus, density = STEEL.youngs_modulus, STEEL.density
    shear = 0.5 * modulus / (1.0 + STEEL.poisson_ratio)
    assert lowest(rod, 0, True) == pytest.approx(pi / length * sqrt(shear / density), rel=2e-3)
    assert lowest(rod, 0, False) == pytest.approx(
        pi / length * sqrt(modulus / density), rel=5e-3
    )  # its ends do not become thinner
    beam = 4.730041**2 / length**2 * sqrt(modulus * (thick / 4.0) ** 2 / density)
    assert 0.97 * beam < lowest(rod, 1, False) < beam  # it is no slender beam of Euler and Bernoulli


def test_free_modes_are_converged_in_elements_and_in_modes_with_the_ends_held():
    found = [
        flexible_shaft(*PINION, greatest_waves=2, interface_modes=modes, size=size).first(5)
        for modes, size in ((12, None), (24, None), (12, 0.01))
    ]
    for other in found[1:]:
        assert other.waves.tolist() == found[0].waves.tolist() == [1, 1, 1, 1, 0]
        assert other.frequency == pytest.approx(found[0].frequency, rel=0.01)


def test_bearings_feel_the_mean_of_both_seats_and_the_line_through_them():
    ends = seat_interface(0.03, 0.15)
    moved, tilt = 2e-6, 3e-5
    rigid = [moved, tilt, moved, tilt]
    assert ends.together(1) @ rigid == pytest.approx([moved, tilt])
    bent = [0.5 * 0.15 * tilt, tilt, 0.5 * 0.15 * tilt, -tilt]  # both seats at rest, each tilted
    assert ends.together(1) @ bent == pytest.approx([0.0, 0.0], abs=1e-20)
    assert ends.together(0) @ [1.0, 2.0, 3.0, 4.0] == pytest.approx([2.0, 3.0])


def test_modes_of_the_pinion_hang_in_the_bearings_of_the_pinion():
    disc = RigidBody.solid_disc(6.0, 0.06, 0.07)
    bearings = Bearings.from_ratio((8e8, 7e8, 6e8, 1e6, 1e6), disc, 0.04)
    hub = ((0.5, 0.0, 0.0, 0.0, -2.0, 0.0),)
    machine = Machine(
        (disc, disc), (bearings, bearings), (28, 28), 100.0, modes=Modes((9e4,), 0.005, hub, (0,))
    )
    matrix = machine.stiffness()
    assert matrix[0, 12] == pytest.approx(0.5 * 8e8)
    assert matrix[4, 12] == pytest.approx(-2.0 * 1e6)
    assert matrix[12, 12] == pytest.approx(81e8 + 0.25 * 8e8 + 4.0 * 1e6)
    assert not matrix[6:12, 12].any()
    other = replace(machine, modes=replace(machine.modes, bodies=(1,))).stiffness()
    assert np.array_equal(other[6:12, 12], matrix[:6, 12])


def test_a_shaft_that_is_no_shaft_is_refused():
    with pytest.raises(GearlashError, match="thinner and no shorter"):
        flexible_shaft(0.1, 0.05, 0.12, 0.1)
    with pytest.raises(GearlashError, match="thinner and no shorter"):
        flexible_shaft(0.1, 0.05, 0.05, 0.04)
