"""What comes out of a slow mesh cycle, against the drawing and against what is estimated from it."""

from __future__ import annotations

from dataclasses import replace
from math import cos

import numpy as np
import pytest

from gearlash.gears import backlash
from gearlash.gears.mesh_cycle import MeshCycle
from gearlash.multibody.quasi_static import quasi_static
from gearlash.multibody.topography import Relief, Topography
from gearlash.system import GearlashError
from multibody.meshes import contact, helical, plain
from multibody.standin import Standin


@pytest.mark.parametrize(("name", "torque"), [("helical", 77.0), ("helical", 900.0), ("spur", 20.0)])
def test_mean_force_contact_ratio_and_backlash(name: str, torque: float):
    mesh = plain(name)
    pair = mesh.flanks.pair
    found = quasi_static(mesh, torque, 32)
    force = torque / mesh.flanks.base_radii[0] / cos(mesh.flanks.base_helix)
    assert found.force.mean() == pytest.approx(force, rel=1e-3)
    assert found.backlash == pytest.approx(backlash.of_pair(pair).normal, abs=1e-12)
    assert found.loads.sum(axis=(1, 2)) == pytest.approx(found.force)
    # corners come in before and go out after the path of contact, the further the greater the load
    assert 0.0 < found.transverse_contact_ratio - pair.transverse_contact_ratio < 0.2
    assert abs(found.total_contact_ratio - pair.total_contact_ratio) < 0.2


def test_light_load_meets_the_path_of_contact():
    mesh = plain("spur")
    light, heavy = (quasi_static(mesh, torque, 64) for torque in (0.01, 50.0))
    ratio = mesh.flanks.pair.transverse_contact_ratio
    assert light.transverse_contact_ratio == pytest.approx(ratio, abs=0.02)
    assert heavy.transverse_contact_ratio > ratio + 0.1


@pytest.mark.parametrize("width", [0.02, 0.065])
def test_evenly_soft_contact_has_the_ripple_of_its_lines(width: float):
    """Places alike that do not know of each other, hardly loaded: stiffness is the length of the lines."""
    pair = helical(width)
    rolls, axial = np.linspace(0.0, 0.1, 4), np.linspace(-0.5 * width, 0.5 * width, 25)
    own = np.zeros((4, 25, 4, 25))
    area = np.full(25, width / 24)
    area[[0, -1]] *= 0.5
    for k in range(25):
        own[:, k, :, k] = 1e-10 / area[k] * width
    soft = Standin(rolls, axial, own.reshape(1, 100, 100), 1e-3)
    mesh = contact(pair, slices=24, compliances=(soft, soft))
    found = quasi_static(mesh, 0.05, 64)
    lines = MeshCycle.of_pair(pair).harmonics(2)
    even = (
        2.0
        * np.sinc(np.arange(1, 3) * pair.overlap_ratio)
        * np.sinc(np.arange(1, 3) * pair.transverse_contact_ratio)
    )
    assert np.sign(even[0]) == np.sign(lines[0])
    assert found.ripple(1)[0] == pytest.approx(abs(even[0]), abs=0.01)
    assert found.ripple(2)[0] == pytest.approx(abs(even[1]), abs=0.01)


def test_more_slices_change_little():
    """What motions feel. The greatest line load is none of it: it lies on the last slice of the face, and
    grows as slices get narrower."""
    coarse, fine = (quasi_static(contact(helical(), slices=n), 77.0, 16) for n in (21, 41))
    assert coarse.mean_stiffness == pytest.approx(fine.mean_stiffness, rel=5e-3)
    assert coarse.deflection.mean() == pytest.approx(fine.deflection.mean(), rel=0.01)
    assert np.allclose(coarse.deflection, fine.deflection, rtol=0.04)
    _, _, last = np.unravel_index(fine.loads.argmax(), fine.loads.shape)
    assert last in (0, 40)


def test_more_phases_of_the_compliance_change_little():
    coarse, fine = (quasi_static(contact(helical(), phases=n), 77.0, 16) for n in (16, 64))
    assert np.allclose(coarse.stiffness, fine.stiffness, rtol=0.01)


def test_an_error_is_found_again():
    """All of it at light load, as all contacts have it at a time."""
    mesh = plain("helical").with_(topography=Topography(error=((4e-6, 0.3, 1), (1e-6, -1.0, 2))))
    found = quasi_static(mesh, 77.0, 32)
    perfect = quasi_static(plain("helical"), 77.0, 32)
    put = found.transmission_error - perfect.transmission_error
    assert found.error_harmonic(1, put) == pytest.approx((4e-6, 0.3), rel=1e-3)
    assert found.error_harmonic(2, put) == pytest.approx((1e-6, -1.0), rel=1e-3)
    assert np.allclose(found.deflection, perfect.deflection, rtol=1e-3)


def test_relief_takes_load_from_the_tips():
    mesh = plain("spur")
    relieved = mesh.with_(
        topography=Topography(
            relief=Relief(pinion_tip=20e-6, gear_tip=20e-6, pinion_length=2e-3, gear_length=2e-3)
        )
    )
    one, other = quasi_static(mesh, 20.0, 32), quasi_static(relieved, 20.0, 32)
    tips = one.rolls > mesh.flanks.tip_rolls[0] - 0.5e-3
    assert other.loads[tips].sum() < 0.2 * one.loads[tips].sum()
    assert other.transverse_contact_ratio < one.transverse_contact_ratio


def test_no_torque_is_refused():
    with pytest.raises(GearlashError, match="above 0"):
        quasi_static(plain("spur"), 0.0)
    with pytest.raises(GearlashError, match="in each other"):
        quasi_static(plain("spur"), 1e6)


def test_wider_axes_have_shorter_contact_and_more_backlash():
    mesh, wide = plain("spur"), np.zeros(12)
    wide[6] = 200e-6
    there = replace(mesh.flanks.pair, stated_centre_distance=mesh.flanks.pair.centre_distance + 200e-6)
    found, before = (quasi_static(mesh, 0.01, 200, displaced=q) for q in (wide, None))
    assert found.backlash == pytest.approx(backlash.of_pair(there).normal, abs=1e-12)
    assert before.transverse_contact_ratio - found.transverse_contact_ratio == pytest.approx(
        mesh.flanks.pair.transverse_contact_ratio - there.transverse_contact_ratio, abs=0.015
    )


def test_tilted_axes_carry_at_one_end():
    mesh, tilted = plain("spur"), np.zeros(12)
    tilted[9] = 3e-4  # the gear about the line of centres
    found, straight = (quasi_static(mesh, 20.0, 16, displaced=q) for q in (tilted, None))
    across = found.loads.sum(axis=(0, 1))
    assert max(across[0], across[-1]) > 3.0 * min(across[0], across[-1])
    assert found.mean_stiffness < straight.mean_stiffness
    assert found.force.mean() == pytest.approx(straight.force.mean(), rel=1e-3)
