"""How stiff one pair of teeth is along its path of contact, over its greatest stiffness.

Published approximations for unmodified flanks, in the place u from −½ (start of contact) to ½ (end). Each is
even in u and has its Fourier transform in closed form, S(w) = ∫ k(u) cos(2wu) du; the harmonics of the mesh
are made of it. What the approximations differ by is a measure of what is not known.
"""

from __future__ import annotations

from enum import StrEnum
from math import pi, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

Reals = NDArray[np.float64]


class PairShape(StrEnum):
    """Stiffness of a pair of teeth along its path of contact.

    ``CONSTANT``: equal stiffness per length of contact line. k = 1.

    ``PARABOLA``: spur teeth by Cai and Hayashi, k = 1 − 1.8 u²: 0.55 at both ends, 0.85 in the mean.

    ``COSINE``: spur teeth with Hertzian contact by Sánchez, Pleguezuelos and Pedrero, k = cos(b_0 ε_α u), b_0
    = (½ (1.11 + ε_α/2)² − 1.17)^(−½): about 0.55 at both ends for ε_α from 1.4 to 2. Given for 1 < ε_α; a
    smaller ratio counts as 1.

    References
    ----------
    Y. Cai, T. Hayashi, The linear approximated equation of vibration of a pair of spur gears (theory and
    experiment), J. Mech. Des. 116 (1994) 558.

    M. B. Sánchez, M. Pleguezuelos, J. I. Pedrero, Approximate equations for the meshing stiffness and the
    load sharing ratio of spur gears including hertzian effects, Mech. Mach. Theory 109 (2017) 231.

    Examples
    --------
    >>> from gearlash.gears.pair_shape import PairShape
    >>> [round(float(shape.at(0.5, 1.6)), 2) for shape in PairShape]
    [1.0, 0.55, 0.55]
    """

    CONSTANT = "constant"
    PARABOLA = "parabola"
    COSINE = "cosine"

    def at(self, place: ArrayLike, contact_ratio: float) -> Reals:
        """k(u), over the greatest stiffness; 0 outside −½ to ½.

        Parameters
        ----------
        place : array_like
            u.
        contact_ratio : float
            ε_α.

        Returns
        -------
        ndarray
            As many as places.
        """
        u = np.asarray(place, dtype=float)
        if self is PairShape.CONSTANT:
            value = np.ones_like(u)
        elif self is PairShape.PARABOLA:
            value = 1.0 - 1.8 * u**2
        else:
            value = np.cos(_width(contact_ratio) * u)
        return np.where(np.abs(u) <= 0.5, value, 0.0)

    def integral(self, place: ArrayLike, contact_ratio: float) -> Reals:
        """∫ k du from −½ to a place; constant outside."""
        u = np.clip(np.asarray(place, dtype=float), -0.5, 0.5)
        if self is PairShape.CONSTANT:
            return u + 0.5
        if self is PairShape.PARABOLA:
            return u - 0.6 * u**3 + 0.425
        width = _width(contact_ratio)
        return (np.sin(width * u) + np.sin(0.5 * width)) / width

    def transform(self, frequency: ArrayLike, contact_ratio: float) -> Reals:
        """S(w) = ∫ k(u) cos(2wu) du over the path; S(0) is the mean.

        Parameters
        ----------
        frequency : array_like
            w, rad: π n ε_α for the harmonic n of the mesh.
        contact_ratio : float
            ε_α.

        Returns
        -------
        ndarray
            As many as frequencies.
        """
        w = np.asarray(frequency, dtype=float)
        if self is PairShape.CONSTANT:
            return _sinc(w)
        if self is PairShape.PARABOLA:
            return _sinc(w) - 1.8 * _second_moment(w)
        half = 0.5 * _width(contact_ratio)
        return 0.5 * (_sinc(half + w) + _sinc(half - w))


def _width(contact_ratio: float) -> float:
    """b_0 ε_α of the cosine."""
    ratio = max(contact_ratio, 1.0)
    return ratio / sqrt(0.5 * (1.11 + 0.5 * ratio) ** 2 - 1.17)


def _sinc(w: Reals) -> Reals:
    """sin w / w."""
    return np.sinc(w / pi)


def _second_moment(w: Reals) -> Reals:
    """∫ u² cos(2wu) du from −½ to ½."""
    small = np.abs(w) < 0.3
    safe = np.where(small, 1.0, w)
    exact = np.sin(safe) / (4 * safe) + np.cos(safe) / (2 * safe**2) - np.sin(safe) / (2 * safe**3)
    square = w * w  # near 0 the terms cancel: by the series
    series = 1 / 12 - square * (1 / 40 - square * (1 / 672 - square * (1 / 25920 - square / 1774080)))
    return np.where(small, series, exact)
