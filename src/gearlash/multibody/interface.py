"""Where a gear body is held: its hub, or the seats of two bearings; and Craig and Bampton's motions of it.

R. R. Craig, M. C. C. Bampton, Coupling of substructures for dynamic analyses, AIAA J. 6 (1968) 1313-1319,
https://doi.org/10.2514/3.4741
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.linalg import eigsh, splu

from gearlash.system import GearlashError

from .revolution import WaveModel

Reals = NDArray[np.float64]
Unknowns = NDArray[np.bool_]
CLOSE = 1e-9


@dataclass(frozen=True)
class Interface:
    """Rigid parts of a body of revolution.

    Parameters
    ----------
    told : str
        What it is, for messages.
    heights : tuple of float
        z of each part, m.
    held : callable
        Unknowns of each part in a `WaveModel`, shape (3k,) each.
    """

    told: str
    heights: tuple[float, ...]
    held: Callable[[WaveModel], tuple[Unknowns, ...]]

    def together(self, waves: int) -> Reals:
        """Motion of the whole that bearings feel, from that of the parts.

        Parameters
        ----------
        waves : int
            n.

        Returns
        -------
        ndarray, shape (2, 2·parts)
            From amounts of the rigid motions of each part (`WaveModel.rigid`): along and about the axis for
            n = 0, the means of the parts; across it and its tilt for n = 1, the line through the parts.
        """
        count = len(self.heights)
        if waves == 0 or count == 1:
            return np.tile(np.eye(2), (1, count)) / count
        low, high = self.heights
        across = np.zeros((2, 4))  # displacement at z is x + z·tilt
        across[0] = 0.5, 0.5 * low, 0.5, 0.5 * high
        across[1] = np.array([-1.0, -low, 1.0, high]) / (high - low)
        return across


def hub_interface(radius: float) -> Interface:
    """All up to a radius: the hub.

    Parameters
    ----------
    radius : float
        m. A hub of no radius is the axis, and so much beside it turns with it that it can hold a turn.

    Returns
    -------
    Interface
    """

    def held(model: WaveModel) -> tuple[Unknowns, ...]:
        of_node = model.nodes[:, 0]
        found = np.repeat(of_node <= radius * (1.0 + CLOSE) + 1e-12, 3)
        if model.waves == 0 and found.any():
            core = max(radius, of_node[of_node > 1e-12].min())
            found[1::3] |= of_node <= core * (1.0 + CLOSE)
        return (found,)

    return Interface(f"a hub of {radius * 1e3:.4g} mm radius", (0.0,), held)


def seat_interface(radius: float, length: float) -> Interface:
    """Both end faces of a shaft.

    Parameters
    ----------
    radius, length : float
        Of the shaft, m.

    Returns
    -------
    Interface
    """
    ends = -0.5 * length, 0.5 * length

    def held(model: WaveModel) -> tuple[Unknowns, ...]:
        r, z = model.nodes.T
        inside = r <= radius * (1.0 + CLOSE)
        return tuple(np.repeat(inside & (np.abs(z - end) < CLOSE * length), 3) for end in ends)

    return Interface("a shaft with its ends", ends, held)


def craig_bampton(model: WaveModel, interface: Interface, interface_modes: int) -> tuple[Reals, Reals]:
    """Motions that Craig and Bampton's body can make in n waves.

    Parameters
    ----------
    model : WaveModel
    interface : Interface
    interface_modes : int
        At least 1.

    Returns
    -------
    (ndarray, ndarray)
        Columns of motions, shape (3k, of_parts + interface_modes): how the body follows rigid motions of the
        parts that it is held by, then its lowest modes with all of them held. And what the first ones are for
        the bearings, shape (2, of_parts): `Interface.together`; of no columns where n has no rigid motion.

    Raises
    ------
    GearlashError
        If no node lies on a part, or nothing else is left.
    """
    parts = interface.held(model)
    held = np.any(parts, axis=0)
    free = np.flatnonzero(~held)
    if not all(part.any() for part in parts):
        raise GearlashError(f"{interface.told} lies inside the bore")
    if interface_modes >= len(free) - 1:
        raise GearlashError(f"{interface_modes} modes with {interface.told} held: too few elements for them")
    stiffness, mass = model.stiffness[free][:, free], model.mass[free][:, free]
    start = np.sin(np.arange(len(free)) + 1.0)  # anything that no mode is orthogonal to
    _, shapes = eigsh(stiffness, k=interface_modes, M=mass, sigma=0.0, v0=start)
    followed = _followed(model, parts, free)
    motions = np.zeros((len(held), followed.shape[1] + interface_modes))
    motions[:, : followed.shape[1]] = followed
    motions[free, followed.shape[1] :] = shapes
    return motions, interface.together(model.waves)[:, : followed.shape[1]]


def _followed(model: WaveModel, parts: tuple[Unknowns, ...], free: NDArray[np.int64]) -> Reals:
    """How the body follows its parts when they move slowly. One part alone takes it along as a rigid body."""
    if len(parts) == 1 or not model.rigid.shape[1]:
        return model.rigid
    moved = np.hstack([np.where(part[:, None], model.rigid, 0.0) for part in parts])
    factors = splu(model.stiffness[free][:, free].tocsc())
    moved[free] = factors.solve(-(model.stiffness[free] @ moved))
    return moved
