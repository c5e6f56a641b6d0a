"""Linear elasticity on hexahedra with 20 nodes (serendipity), by scikit-fem.

The displacement is quadratic, the shape of an element trilinear. Lengths in m, moduli in Pa, stiffness in
N/m.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import scipy.sparse as sparse
from numpy.typing import NDArray

from gearlash.gears.materials import Material

from .extra import require_extra

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class ElasticModel:
    """A body in hexahedra of one material.

    Parameters
    ----------
    nodes : ndarray, shape (n, 3)
        Corners and middles of edges, m; the corners first, in the order of the mesh's points.
    elements : ndarray, shape (m, 20)
        Nodes of each hexahedron.
    edges : ndarray, shape (e, 2)
        The corners between which node ``corners + row`` lies.
    stiffness : scipy.sparse.csc_array, shape (3n, 3n)
        N/m; rows 3i, 3i + 1, 3i + 2 are x, y, z of node i.
    """

    nodes: Reals
    elements: Integers
    edges: Integers
    stiffness: sparse.csc_array

    def between(self, first: Integers, second: Integers) -> Integers:
        """Nodes in the middle of edges.

        Parameters
        ----------
        first, second : ndarray of int
            Corners at the ends of each edge, in any order.

        Returns
        -------
        ndarray of int
            Of their shape.
        """
        keys, order = self._edges_in_order
        asked = np.minimum(first, second) * len(self.nodes) + np.maximum(first, second)
        return len(self.nodes) - len(self.edges) + order[np.searchsorted(keys, asked)]

    @cached_property
    def _edges_in_order(self) -> tuple[Integers, Integers]:
        """A number for each edge from its two corners, rising, and the rows of the edges."""
        keys = self.edges.min(axis=1) * len(self.nodes) + self.edges.max(axis=1)
        order = np.argsort(keys)
        return keys[order], order


def elastic_model(points: Reals, hexahedra: Integers, material: Material) -> ElasticModel:
    """Stiffness of a body.

    Parameters
    ----------
    points : ndarray, shape (n, 3)
        m.
    hexahedra : ndarray, shape (m, 8)
        In the order of `hexahedra.CORNERS`.
    material : Material

    Returns
    -------
    ElasticModel

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.gears import materials
    >>> from gearlash.multibody.elastic import elastic_model
    >>> from gearlash.multibody.hexahedra import CORNERS
    >>> cube = elastic_model(CORNERS.astype(float), np.arange(8)[None], materials.named("steel"))
    >>> cube.stiffness.shape
    (60, 60)
    """
    require_extra()
    import skfem

    mesh = skfem.MeshHex(np.ascontiguousarray(points.T), np.ascontiguousarray(hexahedra.T))
    basis = skfem.Basis(mesh, skfem.ElementHexS2(), intorder=4)
    elements = np.asarray(basis.element_dofs, dtype=np.int64).T
    return ElasticModel(
        basis.doflocs.T.copy(),
        elements,
        np.asarray(mesh.edges, dtype=np.int64).T,
        assembled(elements, _of_each(basis, material)),
    )


def lame(material: Material) -> tuple[float, float]:
    """λ and μ, Pa.

    Parameters
    ----------
    material : Material

    Returns
    -------
    (float, float)
    """
    modulus, poisson = material.youngs_modulus, material.poisson_ratio
    shear = 0.5 * modulus / (1.0 + poisson)
    return 2.0 * shear * poisson / (1.0 - 2.0 * poisson), shear


def _of_each(basis: Any, material: Material) -> Reals:
    """Stiffness of every element, shape (m, 60, 60).

    ∫ λ ∂_a N_i ∂_b N_j + μ (∂_b N_i ∂_a N_j + δ_ab ∇N_i·∇N_j).
    """
    bulk, shear = lame(material)
    slopes = np.stack([shape[0].grad for shape in basis.basis])  # node, direction, element, sample
    nodes, _, count, samples = slopes.shape
    rows = slopes.transpose(2, 0, 1, 3).reshape(count, 3 * nodes, samples)
    both = (rows * basis.dx[:, None, :]) @ rows.transpose(0, 2, 1)
    both = both.reshape(count, nodes, 3, nodes, 3)
    each = bulk * both + shear * both.transpose(0, 1, 4, 3, 2)
    laplace = shear * np.einsum("eiaja->eij", both)
    for direction in range(3):
        each[:, :, direction, :, direction] += laplace
    return each.reshape(count, 3 * nodes, 3 * nodes)


def assembled(elements: Integers, matrices: Reals) -> sparse.csc_array:
    """The sum of the matrices of elements.

    Parameters
    ----------
    elements : ndarray, shape (m, k)
        Nodes of each element.
    matrices : ndarray, shape (m, 3k, 3k)

    Returns
    -------
    scipy.sparse.csc_array, shape (3n, 3n)
    """
    rows = (3 * elements[:, :, None] + np.arange(3)).reshape(len(elements), -1)
    size, width = 3 * (int(elements.max()) + 1), rows.shape[1]
    at = np.repeat(rows, width, axis=1).ravel(), np.tile(rows, (1, width)).ravel()
    return sparse.coo_array((matrices.ravel(), at), shape=(size, size)).tocsc()
