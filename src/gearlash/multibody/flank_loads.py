"""Forces normal to a flank, on lines across its elements, as forces on nodes.

A place on the flank is a roll length and a height z. Its unit force acts on the line of that roll length,
spread along z as a hat over the neighbouring heights: so forces at any heights, shared linearly between two
places, add up to what acts along the line. Lengths in m.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from math import cos, hypot, sin

import numpy as np
import scipy.sparse as sparse
from numpy.typing import NDArray

from gearlash.gears import CylindricalGear

from .elastic import ElasticModel

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]

LINES = 2
"""Of places for each row and each column of elements: its edge and its middle."""
_CORNERS = np.array([[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]])


@dataclass(frozen=True)
class FlankLoads:
    """Unit forces at all places of a flank.

    Parameters
    ----------
    roll : ndarray, shape (nr,)
        Roll lengths of the lines, rising, m.
    forces : scipy.sparse.csc_array, shape (dof, nr·nz)
        On the unknowns of the model, into the tooth; place = row of `roll` times nz + row of heights.
    """

    roll: Reals
    forces: sparse.csc_array


def flank_loads(gear: CylindricalGear, model: ElasticModel, flank: Integers) -> FlankLoads:
    """Unit forces on the lines of a flank.

    Parameters
    ----------
    gear : CylindricalGear
        With its own hand.
    model : ElasticModel
    flank : ndarray of int, shape (rows + 1, columns + 1)
        Corners of its elements: from the start of the involute to the tip, and along z.

    Returns
    -------
    FlankLoads
    """
    rows, columns = flank.shape[0] - 1, flank.shape[1] - 1
    lines = [(row, -1.0 + 2.0 * part / LINES) for row in range(rows) for part in range(LINES)]
    lines.append((rows - 1, 1.0))
    heights = LINES * columns + 1
    share = np.full(heights, 0.5)
    share[[0, -1]] = 1.0
    roll, entries = np.empty(len(lines)), []
    for line, (row, across) in enumerate(lines):
        below, above = model.nodes[flank[row, 0]], model.nodes[flank[row + 1, 0]]
        at = 0.5 * (1.0 - across) * below + 0.5 * (1.0 + across) * above
        roll[line] = gear.roll_length(2.0 * hypot(at[0], at[1]))
        nodes = _faces(model, flank, row)
        for part, end in product(range(LINES), (0, 1)):  # end: where the hat of the place has its top
            height = LINES * np.arange(columns) + part + end
            push = _hat(gear, model.nodes[nodes[:4]], across, part, end) * share[height][:, None]
            place = np.broadcast_to(line * heights + height[:, None], push.shape)
            entries.append((push.ravel(), (3 * nodes[..., None] + np.arange(3)).ravel(), place.ravel()))
    push, unknown, place = (np.concatenate(part) for part in zip(*entries, strict=True))
    shape = 3 * len(model.nodes), len(lines) * heights
    return FlankLoads(roll, sparse.coo_array((push, (unknown, place)), shape=shape).tocsc())


def _faces(model: ElasticModel, flank: Integers, row: int) -> Integers:
    """The eight nodes of the faces in a row, shape (8, columns): corners, then middles as in `_shapes`."""
    low, high = flank[row], flank[row + 1]
    corners = np.stack([low[:-1], high[:-1], low[1:], high[1:]])
    return np.concatenate([corners, model.between(corners[[0, 2, 0, 1]], corners[[1, 3, 2, 3]])])


def _hat(gear: CylindricalGear, corners: Reals, across: float, part: int, end: int) -> Reals:
    """Unit forces on a part of the line of each element, least at one end of it and most at the other.

    On its nodes, shape (8, columns, 3); the corners have shape (4, columns, 3).
    """
    samples, weights = np.polynomial.legendre.leggauss(3)
    total = np.zeros((8, *corners.shape[1:]))
    for sample, weight in zip(samples, weights, strict=True):
        hat = 1.0 + sample if end else 1.0 - sample
        along = -1.0 + (2.0 * part + 1.0 + sample) / LINES
        linear = 0.25 * (1.0 + _CORNERS * np.array([across, along])).prod(axis=1)
        points = np.einsum("c,cni->ni", linear, corners)
        total -= 0.5 * weight * hat * _shapes(across, along)[:, None, None] * outward(gear, points)
    return total


def _shapes(s: float, t: float) -> Reals:
    """Of a quadratic face with eight nodes, at −1 ≤ s, t ≤ 1."""
    i, j = _CORNERS.T
    corner = 0.25 * (1.0 + s * i) * (1.0 + t * j) * (s * i + t * j - 1.0)
    along_s = [0.5 * (1.0 - s * s) * (1.0 + t * end) for end in (-1.0, 1.0)]
    along_t = [0.5 * (1.0 - t * t) * (1.0 + s * end) for end in (-1.0, 1.0)]
    return np.concatenate([corner, along_s, along_t])


def outward(gear: CylindricalGear, points: Reals) -> Reals:
    """Normals of the flank on the side of larger angles, out of the tooth.

    Parameters
    ----------
    gear : CylindricalGear
        With its own hand.
    points : ndarray, shape (n, 3)
        On the flank, m.

    Returns
    -------
    ndarray, shape (n, 3)
        Of length 1.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.multibody.flank_loads import outward
    >>> gear = CylindricalGear(30, 4e-3)
    >>> (outward(gear, np.array([[0.06, 0.0, 0.0]])).round(3) + 0.0).tolist()  # sin and cos of 20°
    [[0.342, 0.94, 0.0]]
    """
    radius = np.hypot(points[:, 0], points[:, 1])
    radial = points[:, :2] / radius[:, None]
    around = np.column_stack([-radial[:, 1], radial[:, 0]])
    pressure = np.array([gear.pressure_angle_at(2.0 * r) for r in radius])[:, None]
    across = cos(gear.base_helix_angle) * (np.cos(pressure) * around + np.sin(pressure) * radial)
    along = -sin(gear.base_helix_angle) * np.sign(gear.helix_angle)
    return np.column_stack([across, np.full(len(points), along)])
