"""Multipliers of motions without damping: with μ comes 1/μ.

The sums ρ = μ + 1/μ are the roots of a polynomial of half the degree. A pair lies on the unit circle where ρ
is real between -2 and 2, on the real axis where it is real and beyond, and off both, as one of four, where ρ
is complex. So a pair leaves the circle through 1 or -1 where ρ passes 2 or -2, and elsewhere only where it
meets another pair, which is a double root ρ: there the discriminant vanishes (Krein collision). All this is
known to rounding, where moduli near a double multiplier are known to its root only. Source: V. I. Arnold, A.
Avez, Ergodic Problems of Classical Mechanics (1968), app. 29; V. A. Yakubovich, V. M. Starzhinskii, Linear
Differential Equations with Periodic Coefficients (1975), ch. 3."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
PALINDROMIC = 1e-9  # of the largest coefficient: by how much the characteristic polynomial may miss it
COMPLEX = 1e-6  # imaginary part of a sum of two pairs that have left the circle: less may be rounding


@dataclass(frozen=True, eq=False)
class Reciprocal:
    """The sums μ + 1/μ of reciprocal multipliers."""

    sums: Complex

    @staticmethod
    def of(multipliers: Complex) -> Reciprocal | None:
        """None where the multipliers are not reciprocal, as with damping."""
        size = len(multipliers)
        if size == 0 or size % 2 or not np.isfinite(multipliers).all():
            return None
        if abs(np.prod(multipliers) - 1.0) > PALINDROMIC:
            return None
        coefficients = np.poly(multipliers).real
        missed = float(np.abs(coefficients - coefficients[::-1]).max())
        if missed > PALINDROMIC * float(np.abs(coefficients).max()):
            return None
        return Reciprocal(_sums(0.5 * (coefficients + coefficients[::-1])))

    @property
    def outside(self) -> int:
        """Multipliers outside the unit circle."""
        return self.above + self.below + 2 * self.complex

    @property
    def above(self) -> int:
        """Pairs on the real axis beyond 1."""
        return int((self._real & (self.sums.real > 2.0)).sum())

    @property
    def below(self) -> int:
        """Pairs on the real axis beyond -1."""
        return int((self._real & (self.sums.real < -2.0)).sum())

    @property
    def complex(self) -> int:
        """Sets of four that lie off circle and axis."""
        return int((self.sums.imag >= COMPLEX).sum())

    @property
    def _real(self) -> NDArray[np.bool_]:
        return np.abs(self.sums.imag) < COMPLEX

    @cached_property
    def at_one(self) -> float:
        """Π(μ - 1)."""
        return float(np.prod(2.0 - self.sums).real)

    @cached_property
    def doubling(self) -> float:
        """Π(μ + 1)."""
        return float(np.prod(2.0 + self.sums).real)

    @cached_property
    def discriminant(self) -> float:
        """Of the polynomial of the sums: zero where two pairs meet."""
        first, second = np.triu_indices(len(self.sums), 1)
        return float(np.prod((self.sums[first] - self.sums[second]) ** 2).real)

    @property
    def meets_on_circle(self) -> bool:
        """Whether the two sums that are nearest to each other belong to pairs on the unit circle."""
        return abs(float(self.sums[self._meeting].real.mean())) < 2.0

    @property
    def outside_beside_meeting(self) -> int:
        """Multipliers outside the unit circle without those of these two pairs."""
        return Reciprocal(np.delete(self.sums, self._meeting)).outside

    @property
    def _meeting(self) -> list[int]:
        """The two sums that are nearest to each other."""
        first, second = np.triu_indices(len(self.sums), 1)
        nearest = int(np.argmin(np.abs(self.sums[first] - self.sums[second])))
        return [int(first[nearest]), int(second[nearest])]


def _sums(coefficients: Array) -> Complex:
    """Roots of the polynomial of μ + 1/μ that belongs to one of μ with these coefficients."""
    half = len(coefficients) // 2
    powers = [np.poly1d([2.0]), np.poly1d([1.0, 0.0])]  # μ^k + μ^-k as a polynomial of the sum
    while len(powers) <= half:
        powers.append(np.poly1d([1.0, 0.0]) * powers[-1] - powers[-2])
    reduced = np.poly1d([coefficients[half]])
    for k in range(1, half + 1):
        reduced = reduced + coefficients[half - k] * powers[k]
    return np.atleast_1d(np.asarray(reduced.roots, dtype=np.complex128))
