"""Structured hexahedra of a sector of a gear: some teeth on a piece of rim, twisted along the helix.

The section of one tooth is repeated about the axis and carried along z by the screw of the helix. A positive
helix angle is a right-hand helix: the teeth turn about +z as z grows. Lengths in m, angles in rad.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import pi, tan

import numpy as np
from numpy.typing import NDArray

from gearlash.gears import CylindricalGear

from .tooth_section import Fineness, ToothSection

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]

CORNERS = np.array(
    [[1, 1, 1], [1, 1, 0], [1, 0, 1], [0, 1, 1], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]], dtype=np.int64
)
"""Where scikit-fem has the eight corners of its cube. In another order a hexahedron is folded: the system is
still solved, and the teeth come out several times too soft."""


@dataclass(frozen=True)
class GearSector:
    """A piece of a gear in hexahedra.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
        Corners, m: x, y, z, with the z axis the gear's. The middle of the middle tooth is on the x axis at
        z = 0.
    hexahedra : ndarray, shape (m, 8)
        Rows of `points`, in the order of `CORNERS`.
    flanks : ndarray, shape (teeth, nr, nz)
        Of each tooth, the points of the flank on the side of larger angles: from the start of the involute to
        the tip, and along z.
    in_layer : ndarray of bool, shape (m,)
        Hexahedra below the flank of the middle tooth that is on the side of larger angles.
    held : ndarray of bool, shape (n,)
        Points of the inner face and of the two cuts through the rim.
    """

    points: Reals
    hexahedra: Integers
    flanks: Integers
    in_layer: NDArray[np.bool_]
    held: NDArray[np.bool_]

    @cached_property
    def volume(self) -> float:
        """Of all hexahedra, m³; each counted with the sign of its orientation."""
        return float(hexahedron_volumes(self.points[self.hexahedra]).sum())


def gear_sector(
    gear: CylindricalGear, face_width: float, section: ToothSection, fineness: Fineness, teeth: int = 5
) -> GearSector:
    """Hexahedra of a sector.

    Parameters
    ----------
    gear : CylindricalGear
    face_width : float
        b, m; above 0.
    section : ToothSection
        Of one tooth.
    fineness : Fineness
        Its number of layers along the face.
    teeth : int
        Odd, at most all of the gear's.

    Returns
    -------
    GearSector

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.multibody.hexahedra import gear_sector
    >>> from gearlash.multibody.tooth_section import Fineness, tooth_section
    >>> gear, fineness = CylindricalGear(30, 4e-3), Fineness(axial=3)
    >>> sector = gear_sector(gear, 0.02, tooth_section(gear, fineness, 12e-3), fineness, teeth=3)
    >>> sector.flanks.shape
    (3, 7, 4)
    """
    plane = _Plane.of(section, gear.teeth, teeth)
    heights = np.linspace(-0.5 * face_width, 0.5 * face_width, fineness.axial + 1)
    turn = plane.polar[None, :, 1] + heights[:, None] * tan(gear.helix_angle) / (
        0.5 * gear.reference_diameter
    )
    radius = np.broadcast_to(plane.polar[:, 0], turn.shape)
    across = np.broadcast_to(heights[:, None], turn.shape)
    points = np.stack([radius * np.cos(turn), radius * np.sin(turn), across], axis=-1).reshape(-1, 3)
    above = len(plane.polar) * np.arange(fineness.axial + 1)
    hexahedra = _stacked(plane.quads, above)
    flanks = plane.flanks[:, :, None] + above
    layer = np.tile(plane.in_layer, fineness.axial)
    return GearSector(points, hexahedra, flanks, layer, np.tile(plane.held, fineness.axial + 1))


@dataclass(frozen=True)
class _Plane:
    """The sector in one transverse plane.

    Corners of `quads`: below left, below right, above left, above right.
    """

    polar: Reals
    quads: Integers
    flanks: Integers
    in_layer: NDArray[np.bool_]
    held: NDArray[np.bool_]

    @staticmethod
    def of(section: ToothSection, all_teeth: int, teeth: int) -> _Plane:
        """The section, repeated."""
        rim, tooth, shoulder = section.rim, section.tooth, section.shoulder
        rows, columns = rim.shape[0], (rim.shape[1] - 1) * teeth + 1
        middles = (np.arange(teeth) - teeth // 2) * 2.0 * pi / all_teeth
        polar = np.empty((rows, columns, 2))
        for k, middle in enumerate(middles):
            first = k * (rim.shape[1] - 1)
            polar[:, first : first + rim.shape[1]] = rim + np.array([0.0, middle])
        numbers = np.arange(rows * columns).reshape(rows, columns)
        blocks, quads, layers, flanks = [polar.reshape(-1, 2)], [_quads(numbers)], [], []
        layers.append(np.zeros(len(quads[0]), dtype=bool))
        count = rows * columns
        for k, middle in enumerate(middles):
            first = k * (rim.shape[1] - 1) + shoulder
            foot = numbers[-1, first : first + tooth.shape[1]]
            rest = count + np.arange((tooth.shape[0] - 1) * tooth.shape[1]).reshape(-1, tooth.shape[1])
            count += rest.size
            blocks.append((tooth[1:] + np.array([0.0, middle])).reshape(-1, 2))
            own = np.vstack([foot, rest])
            quads.append(_quads(own))
            below_flank = np.zeros((tooth.shape[0] - 1, tooth.shape[1] - 1), dtype=bool)
            below_flank[:, -section.layer :] = k == teeth // 2
            layers.append(below_flank.ravel())
            flanks.append(own[section.involute :, -1])
        held = np.zeros(count, dtype=bool)
        held[numbers[0]] = True
        if teeth < all_teeth:
            held[numbers[:, [0, -1]]] = True
        return _Plane(
            np.concatenate(blocks), np.concatenate(quads), np.array(flanks), np.concatenate(layers), held
        )


def _quads(numbers: Integers) -> Integers:
    """Of a grid of nodes, rows outward and columns towards larger angles."""
    corners = numbers[:-1, :-1], numbers[:-1, 1:], numbers[1:, :-1], numbers[1:, 1:]
    return np.stack([corner.ravel() for corner in corners], axis=1)


def _stacked(quads: Integers, above: Integers) -> Integers:
    """Hexahedra between planes; local directions outward, towards larger angles, along z."""
    planes = [quads[None] + start[:, None, None] for start in (above[:-1], above[1:])]
    corners = [planes[up][:, :, 2 * out + right] for out, right, up in CORNERS]
    return np.stack(corners, axis=-1).reshape(-1, 8)


def hexahedron_volumes(corners: Reals) -> Reals:
    """Volumes of trilinear hexahedra.

    Parameters
    ----------
    corners : ndarray, shape (m, 8, 3)
        m, in the order of `CORNERS`.

    Returns
    -------
    ndarray, shape (m,)
        m³; below 0 where a hexahedron is turned inside out.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.multibody.hexahedra import CORNERS, hexahedron_volumes
    >>> hexahedron_volumes(CORNERS[None].astype(float)).round(12).tolist()
    [1.0]
    """
    place = 0.5 / np.sqrt(3.0)
    total = np.zeros(len(corners))
    signs = 2.0 * CORNERS - 1.0
    for sample in signs * place:
        factors = 0.5 + signs * sample
        slopes = [signs[:, k] * np.prod(np.delete(factors, k, axis=1), axis=1) for k in range(3)]
        jacobian = np.stack([np.einsum("c,mcj->mj", slope, corners) for slope in slopes], axis=1)
        total += np.linalg.det(jacobian) / 8.0
    return total
