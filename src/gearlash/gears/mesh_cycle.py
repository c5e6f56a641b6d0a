"""Stiffness of a mesh over its cycle: sliced contact lines, load shares, and every harmonic in closed form.

A gear is cut into slices across its face. Each slice meshes like a spur gear, later the further it lies along
the face: ε_β cycles from end to end. So the stiffness of a pair of teeth is that of a spur pair along its
path (`PairShape`), averaged over a window of ε_β cycles, and that of the mesh is the sum over all pairs:

    K(ψ) = ∫₀¹ k((ψ − y ε_β)/ε_α − ½) dy,   η(ψ) = Σ_i K(ψ − i) / mean.

A product of transforms gives the harmonics about the middle of a pair's path, η = 1 + Σ c_n cos(2πn(ψ −
ε_γ/2)),

    c_n = 2 sinc(n ε_β) S(π n ε_α) / S(0),   sinc(x) = sin(πx)/(πx).

For equal stiffness per length, S(w) = sin w / w, this is the length of the contact lines (Maatar and Velex
1996), and c_2/c_1 = cos(π ε_α) cos(π ε_β). No errors, modifications or misalignment: every slice touches as
soon as it may.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, pi

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import GearlashError

from .cylindrical_pair import CylindricalPair
from .pair_shape import PairShape

Reals = NDArray[np.float64]


@dataclass(frozen=True)
class MeshCycle:
    """One cycle of a mesh of unmodified flanks.

    Parameters
    ----------
    transverse_contact_ratio : float
        ε_α; above 0.
    overlap_ratio : float
        ε_β; at least 0.
    shape : PairShape
        Stiffness of a pair along its path.

    Raises
    ------
    GearlashError
        Where no pair of teeth touches.

    References
    ----------
    M. Maatar, P. Velex, An analytical expression for the time-varying contact length in perfect cylindrical
    gears, J. Mech. Des. 118 (1996) 586.

    Examples
    --------
    >>> from gearlash.gears.mesh_cycle import MeshCycle
    >>> spur = MeshCycle(1.6, 0.0)
    >>> spur.harmonics(3).round(3).tolist()
    [-0.287, -0.06, 0.058]
    >>> bool(abs(MeshCycle(1.6, 1.0).harmonics(3)).max() < 1e-15)  # a whole overlap: no ripple
    True
    """

    transverse_contact_ratio: float
    overlap_ratio: float = 0.0
    shape: PairShape = PairShape.PARABOLA

    def __post_init__(self) -> None:
        """Without contact there is no cycle."""
        if not self.transverse_contact_ratio > 0.0 or not self.overlap_ratio >= 0.0:
            raise GearlashError(
                f"ε_α = {self.transverse_contact_ratio:g}, ε_β = {self.overlap_ratio:g}: "
                "teeth that mesh have ε_α above 0 and ε_β from 0"
            )

    @classmethod
    def of_pair(cls, pair: CylindricalPair, shape: PairShape = PairShape.PARABOLA) -> MeshCycle:
        """The cycle of a pair, from its contact ratios."""
        return cls(pair.transverse_contact_ratio, pair.overlap_ratio, shape)

    @property
    def total_contact_ratio(self) -> float:
        """ε_γ: how many cycles a pair of teeth is in contact."""
        return self.transverse_contact_ratio + self.overlap_ratio

    @property
    def mean(self) -> float:
        """Mean stiffness of the mesh over the greatest one of a spur pair, ε_α S(0).

        For the parabola 0.85 ε_α, where ISO 6336-1 has 0.75 ε_α + 0.25.
        """
        ratio = self.transverse_contact_ratio
        return ratio * float(self.shape.transform(0.0, ratio))

    def pair_stiffness(self, phase: ArrayLike) -> Reals:
        """Stiffness of one pair of teeth.

        Parameters
        ----------
        phase : array_like
            Cycles since its first contact, ψ.

        Returns
        -------
        ndarray
            K, over the greatest stiffness of a spur pair of the same width; 0 before 0 and after ε_γ. Exact:
            the slices are integrated.
        """
        ratio, overlap = self.transverse_contact_ratio, self.overlap_ratio
        psi = np.asarray(phase, dtype=float)
        front = psi / ratio - 0.5
        if overlap < 1e-9:  # one slice
            return self.shape.at(front, ratio)
        back = (psi - overlap) / ratio - 0.5
        whole = self.shape.integral(front, ratio) - self.shape.integral(back, ratio)
        return whole * ratio / overlap

    def stiffness(self, phase: ArrayLike) -> Reals:
        """Stiffness of the mesh over its mean.

        Parameters
        ----------
        phase : array_like
            Cycles, ψ; a pair comes into contact at every whole number.

        Returns
        -------
        ndarray
            η, mean 1.

        Examples
        --------
        >>> from gearlash.gears.mesh_cycle import MeshCycle
        >>> MeshCycle(1.6).stiffness([0.3, 0.8]).round(3).tolist()  # two pairs, one pair
        [1.212, 0.735]
        """
        return self._pairs(phase).sum(axis=0) / self.mean

    def load_shares(self, phase: ArrayLike) -> Reals:
        """Which part of the load each pair in contact carries, all deflected alike.

        Parameters
        ----------
        phase : array_like, shape (n,)
            Cycles, ψ.

        Returns
        -------
        ndarray, shape (pairs, n)
            The latest pair first; the sum is 1 (0 where none touches).
        """
        pairs = self._pairs(phase)
        whole = pairs.sum(axis=0)
        return np.divide(pairs, whole, out=np.zeros_like(pairs), where=whole > 0.0)

    def _pairs(self, phase: ArrayLike) -> Reals:
        """Stiffness of each pair that may touch, shape (pairs, n)."""
        psi = np.mod(np.asarray(phase, dtype=float), 1.0)
        return np.stack([self.pair_stiffness(psi + i) for i in range(ceil(self.total_contact_ratio) + 1)])

    def harmonics(self, count: int) -> Reals:
        """Harmonics of the stiffness over its mean.

        Parameters
        ----------
        count : int
            How many, from 1.

        Returns
        -------
        ndarray, shape (count,)
            c_1, c_2 …, with sign: η = 1 + Σ c_n cos(2πn(ψ − ε_γ/2)), the phase counted from the middle of a
            pair's path. |c_n| ≤ 2.
        """
        ratio, orders = self.transverse_contact_ratio, np.arange(1, count + 1)
        spur = self.shape.transform(pi * orders * ratio, ratio) / self.shape.transform(0.0, ratio)
        return 2.0 * np.sinc(orders * self.overlap_ratio) * spur

    def left_out(self, count: int) -> float:
        """Root mean square of what the first harmonics leave out of η.

        Parameters
        ----------
        count : int
            How many are kept, from 0.

        Returns
        -------
        float
            Over the mean stiffness; of η at 2048 phases of a cycle. Steps of a spur mesh make it fall as
            1/√count only.

        Examples
        --------
        >>> from gearlash.gears.mesh_cycle import MeshCycle
        >>> [round(MeshCycle(1.6).left_out(n), 3) for n in (0, 1, 8, 24)]
        [0.223, 0.093, 0.045, 0.026]
        """
        phase = (np.arange(2048) + 0.5) / 2048
        angle = 2.0 * pi * (phase - 0.5 * self.total_contact_ratio)
        orders = np.arange(1, count + 1)
        kept = 1.0 + self.harmonics(count) @ np.cos(np.outer(orders, angle)) if count else 1.0
        return float(np.sqrt(np.mean(np.square(self.stiffness(phase) - kept))))


def ripple_ranges(pair: CylindricalPair, count: int) -> Reals:
    """Least and greatest harmonics that the published shapes give for a pair.

    Parameters
    ----------
    pair : CylindricalPair
    count : int
        How many harmonics, from 1.

    Returns
    -------
    ndarray, shape (2, count)
        Signed c_n, as of `MeshCycle.harmonics`.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.mesh_cycle import ripple_ranges
    >>> spur = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), face_width=0.02)
    >>> ripple_ranges(spur, 2).round(2).tolist()
    [[-0.31, -0.18], [-0.25, -0.11]]
    """
    each = np.array([MeshCycle.of_pair(pair, shape).harmonics(count) for shape in PairShape])
    return np.array([each.min(axis=0), each.max(axis=0)])
