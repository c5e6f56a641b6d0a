"""Meshes of gear sectors and their stiffness: volume, rigid motions, a beam, and the order of corners."""

from __future__ import annotations

from math import pi, radians

import numpy as np
import pytest
from skfem import MeshHex

from gearlash.gears import CylindricalGear
from gearlash.gears.materials import named
from gearlash.gears.outline import outline
from gearlash.multibody.elastic import elastic_model
from gearlash.multibody.hexahedra import CORNERS, gear_sector, hexahedron_volumes
from gearlash.multibody.tooth_section import Fineness, tooth_section
from gearlash.system import GearlashError

STEEL = named("steel")
GEARS = [
    CylindricalGear(28, 4e-3, radians(18.0)),
    CylindricalGear(70, 4e-3, radians(-18.0)),
    CylindricalGear(12, 2e-3, 0.0, 0.4),
    CylindricalGear(17, 8e-3, radians(15.8), 0.145, stated_tip_diameter=159.66e-3),
    CylindricalGear(10, 3e-3),  # undercut
    CylindricalGear(200, 1e-3, radians(30.0), -0.3),
]


@pytest.mark.parametrize("gear", GEARS, ids=lambda gear: f"{gear.teeth} teeth")
def test_a_sector_has_the_volume_of_its_outline(gear: CylindricalGear):
    fineness, width, teeth = Fineness(fillet=4, axial=8), 5.0 * gear.normal_module, 5
    depth = min(4.0 * gear.normal_module, 0.4 * gear.root_diameter)
    sector = gear_sector(gear, width, tooth_section(gear, fineness, depth), fineness, teeth)
    x, y = outline(gear)
    area = 0.5 * abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))
    inside = pi * (0.5 * gear.root_diameter - depth) ** 2
    assert sector.volume == pytest.approx((area - inside) * width * teeth / gear.teeth, rel=3e-3)
    assert hexahedron_volumes(sector.points[sector.hexahedra]).min() > 0.0


def test_flanks_of_the_mesh_are_involutes_on_the_helix():
    gear, fineness = GEARS[0], Fineness(axial=4)
    sector = gear_sector(gear, 0.03, tooth_section(gear, fineness, 0.01), fineness, 3)
    for tooth, flank in enumerate(sector.flanks):
        x, y, z = sector.points[flank].transpose(2, 0, 1)
        radius, angle = np.hypot(x, y), np.arctan2(y, x)
        half = np.array([gear.transverse_thickness(2.0 * r) for r in radius.ravel()]).reshape(radius.shape)
        middle = 2.0 * pi * (tooth - 1) / gear.teeth
        lead = z * np.tan(gear.helix_angle) / (0.5 * gear.reference_diameter)
        assert angle == pytest.approx(middle + lead + 0.5 * half / radius, abs=1e-12)


def test_a_rigid_motion_needs_no_force():
    gear, fineness = GEARS[0], Fineness(flank=2, fillet=1, core=1, rim=1, axial=2)
    sector = gear_sector(gear, 0.02, tooth_section(gear, fineness, 8e-3), fineness, 3)
    model = elastic_model(sector.points, sector.hexahedra, STEEL)
    shifts = np.tile(np.eye(3), (len(model.nodes), 1))
    turns = np.concatenate([np.cross(np.eye(3), node).T for node in model.nodes])
    size = abs(model.stiffness).max()
    for motions in (shifts, turns / np.abs(turns).max()):
        assert np.abs(model.stiffness @ motions).max() < 1e-12 * size
    assert abs(model.stiffness - model.stiffness.T).max() < 1e-12 * size


def test_pure_bending_stores_the_energy_of_a_beam():
    """Its displacements are quadratic, so elements of that degree have them exactly: E I κ² L / 2."""
    length, side, curvature, poisson = 0.1, 0.01, 1e-3, STEEL.poisson_ratio
    place = {tuple(corner): k for k, corner in enumerate(CORNERS)}
    across = np.array([[0, 0], [1, 0], [0, 1], [1, 1]])
    points = np.concatenate(
        [np.column_stack([np.full(4, x), (across - 0.5) * side]) for x in (0.0, 0.03, length)]
    )
    cell = np.empty(8, dtype=np.int64)
    for x in range(2):
        for k, (y, z) in enumerate(across):
            cell[place[(x, y, z)]] = 4 * x + k
    model = elastic_model(points, np.stack([cell, cell + 4]), STEEL)
    x, y, z = model.nodes.T
    moved = (
        np.column_stack([x * z, -poisson * y * z, -0.5 * (x**2 + poisson * (z**2 - y**2))]).ravel()
        * curvature
    )
    stored = 0.5 * moved @ (model.stiffness @ moved)
    assert stored == pytest.approx(
        0.5 * STEEL.youngs_modulus * side**4 / 12.0 * curvature**2 * length, rel=1e-9
    )


def test_corners_in_another_order_are_turned_inside_out():
    """The order of other tools: the volume shows what the solution would hide."""
    around = np.array(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]
    )
    cube = around[None].astype(float)
    assert abs(hexahedron_volumes(cube)[0] - 1.0) > 0.1
    assert np.array_equal(MeshHex.elem.refdom.p.T, CORNERS)


def test_a_tooth_without_room_for_the_layers_is_refused():
    with pytest.raises(GearlashError, match="meet"):
        tooth_section(GEARS[0], Fineness(), 0.01, depth=2e-3)
    with pytest.raises(GearlashError, match="above the axis"):
        tooth_section(GEARS[0], Fineness(), 0.06)
