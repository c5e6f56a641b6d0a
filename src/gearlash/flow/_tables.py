"""The memory that kernels read: one flat array, and the places in it.

A base period is divided into N cells of equal phase; inside a cell local time s runs from 0 to 1. A
*region* says for every clearance whether its side + or - is in contact or neither; its tables are built
when a motion first comes there and lie in a *slot*. Inside a region everything that a motion does in a
cell is affine in one state, its state at the start of the cell. States are kept as (1, z - c), so that
affine is linear: a table has a column for the 1 and one for every state, and a tangent is (0, v). The
centre c of a region puts every gap in contact on its edge: with z itself, stiffness times D would be
subtracted from stiffness times X in every cell, and digits lost."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from math import comb
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearlash._kernel.jit import array_of, float64, int64, written_out

from ._blocks import LANES, padded
from ._shape import Shape

Array = NDArray[Any]  # of float64, where nothing else is said

PLUS, FREE, MINUS = 0, 1, 2  # of a clearance: contact on side +, none, contact on side -
OVER_PLUS, OVER_MINUS = 3, 4  # rule `no-tension`: still beyond the boundary, but nothing presses
ALWAYS, IN_CONTACT, NO_TENSION = 0, 1, 2

ORDER = 23  # degree of every Taylor polynomial
TERMS = 24  # its coefficients: whole blocks
ROUGH = 8  # coefficients of a polynomial of lower degree close to it: one block


SIZES = array_of(int64, 1, writable=False)
"""A `Shape` as kernels are given it (`sizes_of`), which read it with `shape_of`: a NamedTuple would be taken
apart number by number in every call."""
FLOATS = array_of(float64, 1, writable=False)
MUTABLE = array_of(float64, 1)
MATRIX = array_of(float64, 2)
CUBE = array_of(float64, 3)
INTS = array_of(int64, 1)
CUBE_OF_INTS = array_of(int64, 3)
TABLE = array_of(int64, 2)


def aligned(*sizes: int) -> list[Array]:
    """Zeros, each array on cache lines of its own: a block of eight then never lies across two, which costs
    twice the time to load and many times that to load just after it was stored; and two threads never write
    to the same one, for which each would wait."""
    places, total = [], 0
    for size in sizes:
        places.append(total)
        total += padded(size)
    room = np.zeros(total + LANES)
    first = -(room.__array_interface__["data"][0] // room.itemsize) % LANES
    return [room[first + at : first + at + size] for at, size in zip(places, sizes, strict=True)]


def aligned_ints(*sizes: int) -> list[Array]:
    """The same of whole numbers."""
    return [array.view(np.int64) for array in aligned(*sizes)]


class Plan(NamedTuple):
    """Sizes of a system from which a `Shape` is laid out."""

    n: int
    clearances: int
    cells: int
    harmonics: int


@cache
def lay_out(plan: Plan) -> Shape:
    """The places of everything, in the order of `Shape`."""
    n, j, cells, width = plan.n, plan.clearances, plan.cells, 2 * plan.harmonics + 1
    p = padded(n + 1)
    rows = p + ROUGH * j
    places, size = [], 0
    for length in (3, 4 * j, j, j * p, j * width, j * p, j * width, 2 * j * width, cells * j * 2 * TERMS,
                   2 * j, 2 * (ORDER + 1) * TERMS, (ORDER + 1) * TERMS, (ORDER + 1) * TERMS,
                   (ORDER + 1) * ROUGH, TERMS):  # fmt: skip
        places.append(size)
        size += padded(length)
    inside, slot = [], 0
    for length in (cells * (1 + n) * rows, cells * j * p, cells * (1 + n) * j * TERMS, cells * j * p,
                   cells * j * (1 + n) * TERMS, cells * j * p,
                   cells * j * (ORDER + 1) * p, 2 * cells * j * (ORDER + 1) * p, (n + j) * p, n * width,
                   4 * j, p, (1 + n) * p, p, j * p, 2 * j, j):  # fmt: skip
        inside.append(slot)
        slot += padded(length)
    return Shape._make([n, p, j, cells, rows, plan.harmonics, *places, size, slot, *inside])


@cache
def sizes_of(shape: Shape) -> Array:
    """A shape as an array of int64."""
    return np.array(shape, dtype=np.int64)


@written_out(f"{__package__}._shape_code")
def shape_of(sizes: Array) -> Shape:
    """The shape in such an array."""
    return Shape._make(sizes.tolist())


def constants(shape: Shape, memory: Array) -> None:
    """Writes the tables that are the same for every system (they lie side by side)."""
    table = _constants()
    memory[shape.bernstein : shape.bernstein + len(table)] = table


@cache
def _constants() -> Array:
    bernstein, pascal, hilbert = np.zeros((2, ORDER + 1, TERMS)), *np.zeros((2, ORDER + 1, TERMS))
    for which, degree in enumerate((ORDER, ORDER - 1)):
        for k in range(degree + 1):
            for i in range(k, degree + 1):
                bernstein[which, k, i] = comb(i, k) / comb(degree, k)
    for k in range(ORDER + 1):
        pascal[k, : k + 1] = [comb(k, i) for i in range(k + 1)]
        hilbert[k, : ORDER + 1] = 1.0 / (np.arange(ORDER + 1) + k + 1)
    return np.concatenate([part.ravel() for part in (bernstein, pascal, hilbert, *_economised())])


def _economised() -> tuple[Array, Array]:
    """(TERMS, ROUGH): Bernstein coefficients of degree ROUGH-1 of what is left of s^j in [0, 1] without its
    Chebyshev polynomials of higher degree; (TERMS,): the largest those can be, and what rounding adds.

    s^j = 2^(1-2j) Σ' C(2j, j-k) T_k(2s-1), with half of the term k = 0."""
    degree = ROUGH - 1
    rows, spared = np.zeros((TERMS, ROUGH)), np.zeros(TERMS)
    for j in range(TERMS):
        parts = [Fraction(2 * comb(2 * j, j - k), 4**j) for k in range(j + 1)]
        parts[0] /= 2
        exact = [Fraction(0)] * ROUGH
        for k, part in enumerate(parts[:ROUGH]):
            # T_k(2s-1) = Σ_i (-1)^(k-i) C(2k, 2i) s^i (1-s)^(k-i), raised to the degree
            own = [Fraction((-1) ** (k - i) * comb(2 * k, 2 * i), comb(k, i)) for i in range(k + 1)]
            for at in range(ROUGH):
                exact[at] += part * sum(
                    own[i] * Fraction(comb(k, i) * comb(degree - k, at - i), comb(degree, at))
                    for i in range(max(0, at - degree + k), min(k, at) + 1)
                )
        rows[j] = [float(value) for value in exact]
        largest = max(abs(value) for value in exact)
        spared[j] = float(sum(parts[ROUGH:], Fraction(0)) + largest * Fraction(1, 2**46)) * (1.0 + 1e-9)
    return rows, spared
