"""One tooth on its solid body by plane finite elements: an oracle that knows the outline of the tooth only.

Bilinear quadrilaterals, plane strain. The body is a ring without other teeth, held at its bore; its twist
under the moment is known in closed form and taken off, since theories of the tooth leave it out. What the
body gives way besides is in.
"""

from __future__ import annotations

from itertools import pairwise
from math import cos, pi, sin

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

from gearlash.gears import CylindricalGear
from gearlash.gears.tooth_form import tooth_form
from gearlash.gears.tooth_pair import tooth_load

E, NU = 206e9, 0.3
BORE = 0.5  # of the root radius


def middle_deflection(gear: CylindricalGear, curvature: float, fineness: int = 1) -> float:
    """Deflection of the middle of a tooth along the load, per unit of load and width, m²/N.

    The load acts on the flank at a radius of curvature; what is read is the displacement of the point where
    its line crosses the middle of the tooth: without the flattening of the contact.
    """
    nodes, quads, flank, middle, held, root = _mesh(gear, fineness)
    load = tooth_load(tooth_form(gear), curvature)
    direction = np.array([-cos(load.angle), -sin(load.angle)])  # from the right flank into the tooth
    force = np.zeros(2 * len(nodes))
    radius = np.hypot(gear.root_fillet.base_radius, curvature)
    for node, share in _between(flank, np.hypot(*nodes[flank].T), radius):
        force[2 * node : 2 * node + 2] += share * direction
    moved = _solve(nodes, quads, force, held)
    height = gear.root_fillet.base_radius / cos(load.angle)
    at = sum(share * moved[node] for node, share in _between(middle, nodes[middle][:, 1], height))
    shear = E / (2 * (1 + NU))
    turned = gear.root_fillet.base_radius / (4 * pi * shear) * (1 / (BORE * root) ** 2 - 1 / root**2)
    return float(at @ direction) - turned * height * cos(load.angle)


def _between(ids: np.ndarray, places: np.ndarray, place: float) -> list[tuple[int, float]]:
    """The two nodes around a place, with their shares."""
    above = int(np.clip(np.searchsorted(places, place), 1, len(ids) - 1))
    part = (place - places[above - 1]) / (places[above] - places[above - 1])
    return [(int(ids[above - 1]), 1.0 - part), (int(ids[above]), part)]


def _mesh(gear: CylindricalGear, fineness: int):
    """Rows of equal radius through ring and tooth; the columns of the tooth go on into the ring."""
    fillet = gear.root_fillet
    fillet_radius, fillet_angle = fillet.at(np.linspace(0.0, fillet.end, 14 * fineness + 1))
    tip = fillet.pitch_radius + 0.5 * (gear.tip_diameter - gear.reference_diameter)
    above = np.linspace(fillet_radius[-1], tip, 22 * fineness + 1)[1:]
    radii = np.concatenate([fillet_radius, above])
    halves = np.concatenate([fillet_angle, fillet.involute_angle(above)])
    across = np.linspace(-1.0, 1.0, 20 * fineness + 1)
    root = float(radii[0])
    step = halves[0] * (across[1] - across[0])
    far = halves[0] + step * np.cumsum(1.25 ** np.arange(60))
    far = far[far < pi * 0.98]
    angles = np.concatenate([-far[::-1], halves[0] * across, far])  # the ring is open opposite the tooth
    depth = step * root * np.cumsum(1.18 ** np.arange(200))
    depth = depth[depth < 0.98 * (1.0 - BORE) * root]
    rings = np.concatenate([[BORE * root], root - depth[::-1], [root]])
    width, first = len(angles), len(far)
    ring = [(r * sin(t), r * cos(t)) for r in rings for t in angles]
    tooth = [
        (r * sin(x * h), r * cos(x * h)) for r, h in zip(radii[1:], halves[1:], strict=True) for x in across
    ]
    base = len(ring)
    columns = len(across)
    quads = [
        (i * width + j, i * width + j + 1, (i + 1) * width + j + 1, (i + 1) * width + j)
        for i in range(len(rings) - 1)
        for j in range(width - 1)
    ]
    rows = [np.arange(columns) + (len(rings) - 1) * width + first]
    rows += [base + i * columns + np.arange(columns) for i in range(len(radii) - 1)]
    quads += [
        (low[j], low[j + 1], high[j + 1], high[j]) for low, high in pairwise(rows) for j in range(columns - 1)
    ]
    flank = np.array([row[-1] for row in rows])
    centre = columns // 2
    inside = [i * width + first + centre for i in range(len(rings) - 1)]
    middle = np.array(inside + [row[centre] for row in rows])
    return np.array(ring + tooth), np.array(quads), flank, middle, np.arange(width), root


def _solve(nodes: np.ndarray, quads: np.ndarray, force: np.ndarray, held: np.ndarray) -> np.ndarray:
    """Displacements, shape (nodes, 2)."""
    factor = E / ((1 + NU) * (1 - 2 * NU))
    law = factor * np.array([[1 - NU, NU, 0], [NU, 1 - NU, 0], [0, 0, (1 - 2 * NU) / 2]])
    corners = nodes[quads]  # (elements, 4, 2)
    stiffness = np.zeros((len(quads), 8, 8))
    gauss = 1 / np.sqrt(3)
    for xi in (-gauss, gauss):
        for eta in (-gauss, gauss):
            d = 0.25 * np.array(
                [
                    [-(1 - eta), 1 - eta, 1 + eta, -(1 + eta)],
                    [-(1 - xi), -(1 + xi), 1 + xi, 1 - xi],
                ]
            )
            jacobian = np.einsum("ak,ekb->eab", d, corners)
            size = np.abs(np.linalg.det(jacobian))
            gradient = np.linalg.solve(jacobian, np.broadcast_to(d, (len(quads), 2, 4)))
            strain = np.zeros((len(quads), 3, 8))
            strain[:, 0, 0::2] = strain[:, 2, 1::2] = gradient[:, 0]
            strain[:, 1, 1::2] = strain[:, 2, 0::2] = gradient[:, 1]
            stiffness += np.einsum("eai,ab,ebj,e->eij", strain, law, strain, size)
    places = np.stack([2 * quads, 2 * quads + 1], axis=2).reshape(len(quads), 8)
    i, j = np.repeat(places, 8, axis=1).ravel(), np.tile(places, 8).ravel()
    count = 2 * len(nodes)
    whole = coo_matrix((stiffness.ravel(), (i, j)), shape=(count, count)).tocsc()
    free = np.setdiff1d(np.arange(count), np.concatenate([2 * held, 2 * held + 1]))
    moved = np.zeros(count)
    moved[free] = splu(whole[free][:, free]).solve(force[free])
    return moved.reshape(-1, 2)
