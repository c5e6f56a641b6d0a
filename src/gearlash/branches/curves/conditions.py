"""Conditions on the multipliers of an orbit, as smooth functions that vanish where they hold.

A matrix A is singular where g vanishes in [[A, b], [cᵀ, 0]] [w, g] = [0, 1], with b and c near its null
vectors; g is as smooth as A and of the size of its least singular value, which a determinant is not. A is
DP - I at a fold, DP + I at a doubling; where a pair of multipliers crosses the unit circle it is C - I, with
C the second compound of DP, whose eigenvalues are the products of two multipliers. Sources: W. Govaerts,
Numerical Methods for Bifurcations of Dynamical Equilibria (2000), doi:10.1137/1.9780898719543; Yu. A.
Kuznetsov, Elements of Applied Bifurcation Theory (2004), ch. 10, doi:10.1007/978-1-4757-3978-7."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from .plane import Array


class At(StrEnum):
    """Where multipliers lie."""

    ONE = "a multiplier is 1"
    MINUS_ONE = "a multiplier is -1"
    CIRCLE = "a pair of multipliers lies on the unit circle"


@dataclass(frozen=True, eq=False)
class Condition:
    """One of them, with its borders (m,)."""

    at: At
    left: Array
    right: Array

    def renewed(self, monodromy: Array) -> Condition:
        """The same with the borders that fit a monodromy."""
        return Condition.near(self.at, monodromy, self)

    @staticmethod
    def near(at: At, monodromy: Array, before: Condition | None = None) -> Condition:
        """With the borders that fit a monodromy (n, n), turned as those of the point ``before`` were."""
        u, _, vt = np.linalg.svd(singular(at, monodromy))
        left, right = u[:, -1], vt[-1]
        if before is not None:
            left = left if float(left @ before.left) >= 0.0 else -left
            right = right if float(right @ before.right) >= 0.0 else -right
        return Condition(at, left, right)

    def value(self, monodromy: Array) -> float:
        """g. Raises `LinAlgError` where the borders do not fit at all."""
        return float(self.solved(monodromy)[0][-1])

    def solved(self, monodromy: Array) -> tuple[Array, Array]:
        """(w, g) and (v, g) of the bordered matrix and of its transpose: at g = 0 the null vectors."""
        matrix = singular(self.at, monodromy)
        m = len(matrix)
        bordered = np.zeros((m + 1, m + 1))
        bordered[:m, :m], bordered[:m, m], bordered[m, :m] = matrix, self.left, self.right
        last = np.zeros(m + 1)
        last[m] = 1.0
        solve = np.linalg.solve
        return solve(bordered, last).astype(np.float64), solve(bordered.T, last).astype(np.float64)


@dataclass(frozen=True, eq=False)
class Double:
    """That the multiplier of a condition is a double one: its left and right null vectors are orthogonal."""

    simple: Condition

    def renewed(self, monodromy: Array) -> Double:
        return Double(self.simple.renewed(monodromy))

    def value(self, monodromy: Array) -> float:
        right, left = self.simple.solved(monodromy)
        right, left = right[:-1], left[:-1]
        return float(left @ right) / float(np.linalg.norm(left) * np.linalg.norm(right))


@dataclass(frozen=True)
class Turning:
    """That the pair on the unit circle turns by an angle with a given cosine."""

    cosine: float

    def renewed(self, _: Array) -> Turning:
        return self

    def value(self, monodromy: Array) -> float:
        return circle_cosine(np.linalg.eigvals(monodromy).astype(np.complex128)) - self.cosine


def circle_cosine(multipliers: NDArray[np.complex128]) -> float:
    """Half the sum of the two multipliers whose product is nearest to 1: as smooth as the matrix, even where
    the two are one."""
    first, second = np.triu_indices(len(multipliers), 1)
    nearest = int(np.argmin(np.abs(multipliers[first] * multipliers[second] - 1.0)))
    return 0.5 * float((multipliers[first[nearest]] + multipliers[second[nearest]]).real)


def singular(at: At, monodromy: Array) -> Array:
    """The matrix that is singular where the condition holds."""
    if at is At.CIRCLE:
        return _compound(monodromy) - np.eye(len(monodromy) * (len(monodromy) - 1) // 2)
    return monodromy - (1.0 if at is At.ONE else -1.0) * np.eye(len(monodromy))


def _compound(matrix: Array) -> Array:
    """All minors of two rows and two columns."""
    first, second = np.triu_indices(len(matrix), 1)
    one, two = matrix[first], matrix[second]
    found: Array = one[:, first] * two[:, second] - one[:, second] * two[:, first]
    return found
