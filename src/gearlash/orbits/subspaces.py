"""Eigenvalues of a long product of matrices, each group of like size in its own subspace.

An orthogonal frame is carried through the factors again and again: its leading columns turn into the space
of the largest eigenvalues, and in that frame the product is triangular except for blocks of eigenvalues of
like modulus. The factors' blocks are multiplied with their size kept apart as a logarithm, so that nothing
vanishes and nothing drowns: G. Golub and C. Van Loan, Matrix Computations, 4th ed. (2013), sect. 7.3."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

Complex = NDArray[np.complex128]
Matrix = NDArray[np.float64]
GROUP_DISTANCE = 1.0  # powers of e between two groups: they part by so much in each turn
MOST_TURNS = 40  # at the most; e^-40 is below rounding
SEPARATED = 1e-9  # how little directions of two groups may turn into each other


def by_subspaces(factors: list[Matrix]) -> tuple[Complex, NDArray[np.float64]]:
    """Eigenvalues (n,) of the product of ``factors``, the first one rightmost, by modulus, descending, and
    the logarithms (n,) of their moduli. An eigenvalue beyond the range of floats is zero or infinite, its
    logarithm is not."""
    begin = frame = np.eye(len(factors[0]))
    triangles, sizes = factors, np.zeros(len(frame))
    for turn in range(1, MOST_TURNS + 1):
        begin = frame
        frame, triangles = _turn(factors, begin)
        sizes = np.sum([np.log(np.abs(np.diag(each))) for each in triangles], axis=0)
        gaps = sizes[:-1] - sizes[1:]
        nearest = gaps[gaps > GROUP_DISTANCE].min(initial=np.inf)  # powers of e by which two groups part
        if turn > 2 and (turn - 2) * nearest > MOST_TURNS * GROUP_DISTANCE:
            break
    turned = begin.T @ frame  # the frame comes back to itself except for a turn within each group
    values, logarithms = [], []
    for group in _groups(sizes, turned):
        block, logarithm = np.eye(len(group)), 0.0
        for triangle in triangles:
            block = triangle[np.ix_(group, group)] @ block
            size = float(np.abs(block).max())
            if size == 0.0:  # below every float already in one factor
                break
            block, logarithm = block / size, logarithm + np.log(size)
        inner = np.linalg.eigvals(turned[np.ix_(group, group)] @ block)
        with np.errstate(over="ignore", under="ignore", divide="ignore"):
            logarithms.append(np.log(np.abs(inner)) + logarithm)
            values.append(inner * np.exp(logarithm))
    found: Complex = np.concatenate(values).astype(np.complex128)
    size = np.concatenate(logarithms)
    order = np.lexsort((-found.imag, -np.round(size, 12)))
    return found[order], size[order]


def _turn(factors: list[Matrix], frame: Matrix) -> tuple[Matrix, list[Matrix]]:
    triangles = []
    for factor in factors:
        frame, triangle = np.linalg.qr(factor @ frame)
        triangles.append(triangle)
    return frame, triangles


def _groups(sizes: NDArray[np.float64], turned: Matrix) -> Iterator[list[int]]:
    """Neighbours whose sizes are less than `GROUP_DISTANCE` from each other, or whose directions still turn
    into each other, as those of a complex pair do."""
    group = [0]
    for i in range(1, len(sizes)):
        mixed = max(np.abs(turned[:i, i:]).max(), np.abs(turned[i:, :i]).max())
        if sizes[i - 1] - sizes[i] > GROUP_DISTANCE and mixed < SEPARATED:
            yield group
            group = []
        group.append(i)
    yield group


def ordered(values: NDArray[Any]) -> Complex:
    """By modulus descending, then by imaginary part, so that pairs print in one order."""
    found: Complex = np.asarray(values, dtype=np.complex128)
    with np.errstate(divide="ignore"):
        size = np.round(np.log(np.abs(found)), 12)
    return found[np.lexsort((-found.imag, -size))]
