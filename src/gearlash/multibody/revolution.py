"""A body of revolution in finite elements: its section in quadrilaterals, waves around in closed form.

For n waves around the axis the displacement is

    u_r = U(r, z) cos nφ,   u_φ = V(r, z) sin nφ,   u_z = W(r, z) cos nφ,

or the same turned by a quarter of a wave; this is three-dimensional elasticity, discretised in r and z alone.
Lengths in m, masses in kg.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from math import pi
from typing import Any

import numpy as np
import scipy.sparse as sparse
from numpy.typing import NDArray

from gearlash.gears.gear_body import GearBody
from gearlash.gears.materials import Material
from gearlash.system import GearlashError

from .elastic import assembled, lame
from .extra import require_extra

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Meridian:
    """The section of a body of revolution.

    Parameters
    ----------
    points : ndarray, shape (n, 2)
        Corners, r and z, m.
    quadrilaterals : ndarray, shape (m, 4)
        Around each.
    """

    points: Reals
    quadrilaterals: Integers


@dataclass(frozen=True)
class WaveModel:
    """A body that moves in n waves around its axis.

    Parameters
    ----------
    waves : int
        n.
    nodes : ndarray, shape (k, 2)
        r and z, m.
    stiffness, mass : scipy.sparse.csc_array, shape (3k, 3k)
        N/m and kg; rows 3i, 3i + 1, 3i + 2 are U, V, W of node i.
    rigid : ndarray, shape (3k, rigid)
        The motions of a rigid body among them: along the axis and about it for n = 0, across it and a tilt
        for n = 1, none beyond; of 1 m and 1 rad.
    """

    waves: int
    nodes: Reals
    stiffness: sparse.csc_array
    mass: sparse.csc_array
    rigid: Reals


def meridian(body: GearBody, size: float) -> Meridian:
    """Rectangles over the section of rim, web and hub.

    Parameters
    ----------
    body : GearBody
    size : float
        Of an element at most, m; above 0.

    Returns
    -------
    Meridian

    Raises
    ------
    GearlashError
        For a body without width or height, or a size that is not above 0.

    Examples
    --------
    >>> from gearlash.gears.gear_body import GearBody
    >>> from gearlash.multibody.revolution import meridian
    >>> len(meridian(GearBody(0.28, 0.06, bore=0.05), 0.02).quadrilaterals)
    18
    """
    rings = [ring for ring in body.rings if ring.outer_diameter > ring.inner_diameter]
    if not rings or not size > 0.0 or not all(ring.width > 0.0 for ring in rings):
        raise GearlashError("a body of revolution has width and height, its elements a size above 0")
    radii = _divided(
        sorted({0.5 * d for ring in rings for d in (ring.inner_diameter, ring.outer_diameter)}), size
    )
    heights = _divided(sorted({s * 0.5 * ring.width for ring in rings for s in (-1.0, 1.0)}), size)
    middle_r, middle_z = 0.5 * (radii[1:] + radii[:-1]), 0.5 * (heights[1:] + heights[:-1])
    inside = np.zeros((len(middle_r), len(middle_z)), dtype=bool)
    for ring in rings:
        of_ring = (middle_r > 0.5 * ring.inner_diameter) & (middle_r < 0.5 * ring.outer_diameter)
        inside |= of_ring[:, None] & (np.abs(middle_z) < 0.5 * ring.width)
    numbers = np.arange(len(radii) * len(heights)).reshape(len(radii), len(heights))
    corners = numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:]
    quads = np.stack([corner[inside] for corner in corners], axis=1)
    used, renumbered = np.unique(quads, return_inverse=True)
    points = np.stack(np.meshgrid(radii, heights, indexing="ij"), axis=-1).reshape(-1, 2)
    return Meridian(points[used], renumbered.reshape(quads.shape))


def _divided(places: list[float], size: float) -> Reals:
    """Places with others between them, so that no step is longer than the size."""
    parts = [
        np.linspace(low, high, int(np.ceil((high - low) / size - 1e-9)) + 1)[:-1]
        for low, high in pairwise(places)
    ]
    return np.append(np.concatenate(parts), places[-1])


def wave_model(section: Meridian, material: Material, waves: int) -> WaveModel:
    """Stiffness and mass of a body of revolution in n waves.

    Parameters
    ----------
    section : Meridian
    material : Material
    waves : int
        n, from 0.

    Returns
    -------
    WaveModel

    Examples
    --------
    >>> from gearlash.gears import materials
    >>> from gearlash.gears.gear_body import GearBody
    >>> from gearlash.multibody.revolution import meridian, wave_model
    >>> section = meridian(GearBody(0.28, 0.06, bore=0.05), 0.03)
    >>> model = wave_model(section, materials.named("steel"), 0)
    >>> along = model.rigid[:, 0]
    >>> round(float(along @ (model.mass @ along)), 2)  # kg
    28.01
    """
    require_extra()
    import skfem

    mesh = skfem.MeshQuad(
        np.ascontiguousarray(section.points.T), np.ascontiguousarray(section.quadrilaterals.T)
    )
    basis = skfem.Basis(mesh, skfem.ElementQuad2(), intorder=6)
    elements = np.asarray(basis.element_dofs, dtype=np.int64).T
    nodes = np.asarray(basis.doflocs).T.copy()
    around = 2.0 * pi if waves == 0 else pi
    weight = around * np.asarray(basis.dx) * np.asarray(basis.global_coordinates())[0]
    stiffness = _stiffness(basis, material, waves, weight)
    shapes = np.stack([np.broadcast_to(shape[0], weight.shape) for shape in basis.basis])
    each = material.density * np.einsum("ieq,jeq,eq->eij", shapes, shapes, weight)
    mass = np.einsum("eij,ab->eiajb", each, np.eye(3)).reshape(stiffness.shape)
    return WaveModel(
        waves, nodes, assembled(elements, stiffness), assembled(elements, mass), rigid_motions(nodes, waves)
    )


def _stiffness(basis: Any, material: Material, waves: int, weight: Reals) -> Reals:
    """Of every element: ∫ Bᵀ D B, strains rr, φφ, zz, φz, rz, rφ."""
    bulk, shear = lame(material)
    law = np.diag([2.0 * shear] * 3 + [shear] * 3)
    law[:3, :3] += bulk
    radius = np.asarray(basis.global_coordinates())[0]
    strains = []
    for shape in basis.basis:
        value = np.broadcast_to(shape[0], radius.shape) / radius
        by_r, by_z = shape[0].grad
        strain = np.zeros((3, 6, *radius.shape))  # of U, V, W
        strain[0, 0], strain[0, 1], strain[0, 4], strain[0, 5] = by_r, value, by_z, -waves * value
        strain[1, 1], strain[1, 3], strain[1, 5] = waves * value, by_z, by_r - value
        strain[2, 2], strain[2, 3], strain[2, 4] = by_z, -waves * value, by_r
        strains.append(strain)
    rows = np.concatenate(strains).transpose(2, 0, 1, 3)  # element, unknown, strain, sample
    stress = np.einsum("euvq,vw,eq->euwq", rows, law, weight)
    count, unknowns = rows.shape[:2]
    return stress.reshape(count, unknowns, -1) @ rows.reshape(count, unknowns, -1).transpose(0, 2, 1)


def rigid_motions(nodes: Reals, waves: int) -> Reals:
    """Motions of a rigid body in n waves at given places.

    Parameters
    ----------
    nodes : ndarray, shape (k, 2)
        r and z, m.
    waves : int
        n.

    Returns
    -------
    ndarray, shape (3k, rigid)
        As `WaveModel.rigid`: a displacement along z and a turn about it (as V = r); a displacement along x
        and a tilt about y; their twins are along y and about −x.
    """
    radius, height = nodes.T
    none, one = np.zeros(len(nodes)), np.ones(len(nodes))
    if waves == 0:
        motions = [[none, none, one], [none, radius, none]]
    elif waves == 1:
        motions = [[one, -one, none], [height, -height, -radius]]
    else:
        return np.zeros((3 * len(nodes), 0))
    return np.stack([np.stack(motion, axis=1).ravel() for motion in motions], axis=1)
