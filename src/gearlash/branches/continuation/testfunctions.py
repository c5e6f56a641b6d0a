"""Functions along a branch that vanish where something happens to the stability of its orbits.

Of the multipliers μ: Π(μ+1) at a doubling, Π(μ−1) at a fold or a branch point, Π_{i<j}(μ_i μ_j − 1) where a
pair crosses the unit circle (or where two real ones are reciprocal, which is nothing); without damping that
product vanishes everywhere, and the discriminant of the μ + 1/μ stands for it. And dλ/ds, which
vanishes at a fold. All are smooth along the branch but at a graze, where they move like the root of the
depth. Source: Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory (2004), ch. 10,
doi:10.1007/978-1-4757-3978-7."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from .reciprocal import Reciprocal

Complex = NDArray[np.complex128]
NEUTRAL = 1e-11  # how far from the unit circle a multiplier must lie to be off it: less may be rounding


def outside(multipliers: Complex) -> Complex:
    """Those outside the unit circle beyond rounding. Without damping whole branches lie on it, and near a
    double multiplier rounding makes the root of its size: there their sums tell (`Reciprocal`)."""
    reciprocal = Reciprocal.of(multipliers)
    if reciprocal is None:
        return multipliers[np.abs(multipliers) > 1.0 + NEUTRAL]
    return multipliers[np.argsort(-np.abs(multipliers), kind="stable")[: reciprocal.outside]]


def neutral(multipliers: Complex) -> bool:
    """Whether one lies on the unit circle within rounding."""
    return bool((np.abs(np.abs(multipliers) - 1.0) <= NEUTRAL).any())


@dataclass(frozen=True)
class Unstable:
    """Multipliers outside the unit circle: real ones above 1, real ones below -1, complex pairs."""

    above: int
    below: int
    pairs: int

    @property
    def total(self) -> int:
        return self.above + self.below + 2 * self.pairs


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Multipliers of one orbit, and ``turn``: dλ/ds of the branch there, scaled."""

    multipliers: Complex
    turn: float

    @cached_property
    def reciprocal(self) -> Reciprocal | None:
        """Without damping."""
        return Reciprocal.of(self.multipliers)

    @cached_property
    def unstable(self) -> Unstable:
        if self.reciprocal is not None:
            return Unstable(self.reciprocal.above, self.reciprocal.below, self.reciprocal.complex)
        found = outside(self.multipliers)
        real = found.real[found.imag == 0.0]
        return Unstable(int((real > 1.0).sum()), int((real < -1.0).sum()), int((found.imag > 0.0).sum()))

    @cached_property
    def doubling(self) -> float:
        if self.reciprocal is not None:
            return self.reciprocal.doubling
        return float(np.prod(1.0 + self.multipliers).real)

    @cached_property
    def at_one(self) -> float:
        if self.reciprocal is not None:
            return self.reciprocal.at_one
        return float(np.prod(self.multipliers - 1.0).real)

    @cached_property
    def krein(self) -> float:
        """Zero where two pairs meet; 1 with damping, or where there is one pair only."""
        return 1.0 if self.reciprocal is None else self.reciprocal.discriminant

    @cached_property
    def torus(self) -> float:
        first, second = np.triu_indices(len(self.multipliers), 1)
        return float(np.prod(self.multipliers[first] * self.multipliers[second] - 1.0).real)

    @property
    def nearest_pair(self) -> complex:
        """Of the complex pairs, that which is nearest to the unit circle; 0 where there is none."""
        pairs = self.multipliers[self.multipliers.imag > 0.0]
        return complex(pairs[np.argmin(np.abs(np.abs(pairs) - 1.0))]) if len(pairs) else 0.0j
