"""Gaps between flanks against distances of surfaces in space, of tooth thicknesses and rotations alone."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, cos, pi, sin, tan

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from gearlash.gears import CylindricalGear, CylindricalPair, backlash
from gearlash.multibody._tables import CORNER_REACH
from gearlash.multibody.contact import MeshContact
from gearlash.multibody.flanks import Flanks
from gearlash.multibody.topography import Relief, Topography
from gearlash.system import GearlashError
from multibody.meshes import PAIRS, jolted, plain, pose, spur

Reals = NDArray[np.float64]


class Body:
    """One gear in space: a helical tooth is a section that turns by tan β z/r."""

    def __init__(self, gear: CylindricalGear, hand: float, centre: Reals, tooth: float, q: Reals):
        self.gear, self.tooth = gear, tooth
        self.lead = hand * tan(abs(gear.helix_angle)) / (0.5 * gear.reference_diameter)
        self.centre = centre + q[:3]
        self.turn = Rotation.from_euler("XYZ", q[3:])

    def point(self, diameter: float, z: float) -> Reals:
        angle = self.tooth + self.gear.transverse_thickness(diameter) / diameter + self.lead * z
        at = np.array([0.5 * diameter * cos(angle), 0.5 * diameter * sin(angle), z])
        return self.centre + self.turn.apply(at)


def distance(pair: CylindricalPair, q: Reals, plane: float) -> float:
    """Least distance of both gears' flanks at contacts in a plane of constant z, over all pairs of teeth."""
    pinion, gear = pair.gears
    hand = 1.0 if pinion.helix_angle >= 0.0 else -1.0
    found = []
    near = round(-q[5] * pinion.teeth / (2.0 * pi))
    for j in range(near - 3, near + 4):
        one = Body(pinion, hand, np.zeros(3), 2.0 * pi * j / pinion.teeth, q[:6])
        tooth = pi - pi / gear.teeth - 2.0 * pi * j / gear.teeth
        two = Body(gear, -hand, np.array([pair.centre_distance, 0.0, 0.0]), tooth, q[6:12])

        def apart(x: Reals, one: Body = one, two: Body = two) -> Reals:
            first = one.point(x[0], x[2])
            return np.append(1e3 * (first - two.point(x[1], x[3])), 1e6 * (first[2] - plane))

        low = [max(g.base_diameter * 1.0001, g.root_form_diameter) for g in pair.gears]
        high = [g.tip_diameter for g in pair.gears]
        start = [*(0.5 * (a + b) for a, b in zip(low, high, strict=True)), plane, plane]
        bounds = ([*low, plane - 1e-3, plane - 1e-3], [*high, plane + 1e-3, plane + 1e-3])
        solved = least_squares(
            apart, start, bounds=bounds, x_scale=[1e-3] * 4, xtol=1e-15, ftol=1e-15, gtol=1e-15
        )
        inside = all(a + 1e-5 < d < b - 1e-5 for a, d, b in zip(low, solved.x[:2], high, strict=True))
        if inside:
            found.append(float(np.linalg.norm(apart(solved.x)[:3])) * 1e-3)
    return min(found)


@pytest.mark.parametrize("name", ["helical", "spur"])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_gaps_are_distances_of_the_surfaces(name: str, seed: int):
    """Within 10 nm, displaced and tilted more than bearings let them, in planes all over the face."""
    mesh = plain(name)
    rng = np.random.default_rng(seed)
    q = pose(mesh, rng.uniform(-1.0, 1.0), -0.2 * mesh.flanks.play)
    q += rng.normal(size=12) * np.tile([2e-5, 2e-5, 2e-5, 1e-4, 1e-4, 0.0], 2)
    for z in np.array([-0.45, 0.1, 0.4]) * mesh.flanks.pair.face_width:
        one = replace(mesh, tables=mesh.tables._replace(slices=np.array([z])))
        gap = one.details(q, np.zeros(12)).nearest[0]
        assert gap > 5e-6
        assert gap == pytest.approx(distance(mesh.flanks.pair, q, float(z)), abs=1e-8)


@pytest.mark.parametrize("name", ["helical", "spur"])
@pytest.mark.parametrize("wider", [-20e-6, 0.0, 150e-6])
def test_backlash_is_that_of_the_drawing(name: str, wider: float):
    mesh = plain(name)
    q = np.zeros(12)
    q[6] = wider
    moved = replace(mesh.flanks.pair, stated_centre_distance=mesh.flanks.pair.centre_distance + wider)
    assert sum(mesh.details(q, np.zeros(12)).nearest) == pytest.approx(
        backlash.of_pair(moved).normal, abs=1e-12
    )


@pytest.mark.parametrize("name", ["helical", "spur"])
def test_action_is_conjugate(name: str):
    """Perfect flanks leave the same gap at every phase, at other centre distances too."""
    mesh = plain(name)
    for wider in (0.0, 100e-6):
        gaps = []
        for turn in np.linspace(0.0, mesh.flanks.phase_pitch, 15):
            q = pose(mesh, float(turn), 10e-6)
            q[6] += wider
            gaps.append(mesh.details(q, np.zeros(12)).nearest[0])
        assert np.ptp(gaps) < 1e-13


@pytest.mark.parametrize("which", [0, 1])
@pytest.mark.parametrize("name", ["helical", "spur"])
def test_a_corner_is_as_far_from_the_mate_as_its_own_point(name: str, which: int):
    """Rolled on beyond the end of the flank: the distance in the transverse section from the corner to points
    of the mate's involute."""
    flanks = Flanks(PAIRS[name]())
    own, mate = flanks.pair.gears[which], flanks.pair.gears[1 - which]
    angle, a = flanks.pair.working_pressure_angle, flanks.pair.centre_distance
    base, other = flanks.base_radii[which], flanks.base_radii[1 - which]
    roll, e = flanks.tip_rolls[which], 0.8e-3
    corner_angle = atan2(roll, base) - angle + e / base
    corner = 0.5 * own.tip_form_diameter * np.array([cos(corner_angle), sin(corner_angle)])
    rolls = np.linspace(
        mate.roll_length(mate.root_form_diameter), mate.roll_length(mate.tip_diameter), 200_001
    )
    begins = (flanks.pair.tangent_length - roll - e) / other - angle  # unrolled from the base circle
    unrolled = begins + rolls * 0.0
    tangent = unrolled - rolls / other
    involute = np.array(
        [
            a - other * np.cos(tangent) + rolls * np.sin(tangent),
            -other * np.sin(tangent) - rolls * np.cos(tangent),
        ]
    )
    apart = np.hypot(*(involute - corner[:, None])).min()
    assert float(flanks.corner(which, e)) == pytest.approx(apart, abs=2e-10)
    first, second, far = flanks.corner_coefficients(which)
    follow = np.linspace(0.1, 1.0, 10) * far
    assert np.allclose(follow**2 * (first + follow * second), flanks.corner(which, follow), rtol=0.01)
    assert float(flanks.corner(which, far)) == pytest.approx(CORNER_REACH, rel=0.15)


def test_modifications_open_the_gaps_where_they_are():
    mesh = plain("spur")
    pair = mesh.flanks.pair
    relief = Relief(crowning=8e-6, slope=3e-6)
    changed = mesh.with_(topography=Topography(relief=relief))
    q = jolted(mesh, 0.0, 0.0, 0)
    for k, z in enumerate(mesh.tables.slices):
        one, other = (
            replace(
                m, tables=m.tables._replace(slices=np.array([z]), relief=m.tables.relief[:, k : k + 1].copy())
            )
            for m in (mesh, changed)
        )
        part = 2.0 * z / pair.face_width
        opened = other.details(q, np.zeros(12)).nearest[0] - one.details(q, np.zeros(12)).nearest[0]
        assert opened == pytest.approx(8e-6 * part**2 + 3e-6 * part, abs=1e-15)
    assert Relief(gear_tip=10e-6, gear_length=2e-3, exponent=2.0).of_roll(1, -1e-3) == pytest.approx(2.5e-6)
    assert Relief(gear_tip=10e-6).of_roll(0, 0.0) == 0.0


def test_what_does_not_mesh_is_refused():
    pair = spur()
    with pytest.raises(GearlashError, match="face width 0"):
        Flanks(replace(pair, face_width=0.0))
    with pytest.raises(GearlashError, match="hand over"):
        Flanks(replace(pair, stated_centre_distance=pair.centre_distance + 2.2e-3))
    with pytest.raises(GearlashError, match="below the involute"):
        Flanks(CylindricalPair(CylindricalGear(12, 2e-3), CylindricalGear(60, 2e-3), face_width=0.02))


def test_a_left_handed_pinion_pushes_the_other_way():
    right = plain("helical")
    gears = [replace(g, helix_angle=-g.helix_angle) for g in right.flanks.pair.gears]
    left = Flanks(replace(right.flanks.pair, pinion=gears[0], gear=gears[1]))
    assert left.base_helix == -right.flanks.base_helix
    assert [g.helix_angle > 0.0 for g in left.hands] == [False, True]
    assert isinstance(right, MeshContact)
