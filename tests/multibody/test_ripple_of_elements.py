"""Teeth in finite elements: stiffness as calculated otherwise, and which harmonic of it is the greater."""

from __future__ import annotations

from math import cos

import pytest

from gearlash.gears.mesh_cycle import MeshCycle
from gearlash.gears.tooth_pair import calculated_mesh
from gearlash.multibody.compliance import SectorSettings, pair_compliances
from gearlash.multibody.contact import MeshContact
from gearlash.multibody.quasi_static import quasi_static
from gearlash.multibody.tooth_section import Fineness
from gearlash.multibody.topography import Relief, Topography
from multibody.meshes import helical

TORQUE = 77.0
COARSE = SectorSettings(Fineness(flank=4, fillet=1, core=1, rim=1, axial=8), teeth=3)


@pytest.fixture(scope="module")
def mesh() -> MeshContact:
    pair = helical()
    made = pair_compliances(pair, (pair.face_width, pair.face_width), settings=COARSE, keep=False)
    return MeshContact.of(pair, made, slices=21)


def test_unmodified_flanks_have_the_first_harmonic(mesh: MeshContact):
    """As lines of contact say; these coarse elements are some 20 % too stiff."""
    pair, found = mesh.flanks.pair, quasi_static(mesh, TORQUE, 16)
    force = TORQUE / mesh.flanks.base_radii[0] / cos(mesh.flanks.base_helix)
    assert found.force.mean() == pytest.approx(force, rel=1e-3)
    calculated = calculated_mesh(pair, 2, force / pair.face_width)
    assert found.mean_stiffness == pytest.approx(calculated.mean, rel=0.3)
    lines = MeshCycle.of_pair(pair).harmonics(2)
    assert abs(lines[1]) < abs(lines[0])
    assert found.ripple(2)[0] < 0.5 * found.ripple(1)[0] < 0.5 * abs(lines[0])


def test_relief_and_crowning_turn_it_round(mesh: MeshContact):
    """The contact is a short patch then, and the stiffness a fifth of that of the whole lines."""
    relief = Relief(69e-6, 69e-6, 7.6e-3, 7.6e-3, crowning=37e-6)
    found = quasi_static(mesh.with_(topography=Topography(relief=relief)), TORQUE, 16)
    assert found.ripple(2)[0] > 0.1
    assert found.ripple(2)[0] > 1.5 * found.ripple(1)[0]
    assert found.mean_stiffness < 0.3 * quasi_static(mesh, TORQUE, 8).mean_stiffness
