"""What a change of the equations makes of a motion: the derivative by a parameter, piece by piece.

Inside a piece of a trace the motion z(φ) is a polynomial, and so, to the same degree, is what the change of
the equations adds to its rate. The derivative y of the state obeys the linear equations of the region with
that as its forcing, and is summed as a Taylor series, too. Where the field jumps, the crossing that moves
adds ± ζ g (h·y + what the gap itself moves by): no quotient is met. Source: M. di Bernardo et al.,
Piecewise-smooth Dynamical Systems (2008), ch. 2, doi:10.1007/978-1-84628-708-4."""

from __future__ import annotations

import numpy as np

from gearlash._kernel.jit import allocating, float64, inner, kernel, void

from ._series import fill, fourier_taylor, fourier_value
from ._tables import CUBE, FREE, INTS, MATRIX, MUTABLE, ORDER, PLUS, TABLE, TERMS

H, G, DH, DG = 0, 1, 2, 3  # in `vectors`
ETA, DETA, OFFSET, DOFFSET = 0, 2, 4, 5  # in `series`; of η both sides
EDGE, DEDGE = 0, 2  # in `edges`; both sides


@inner
def _dot(row, z):
    total = 0.0
    for i in range(len(z)):
        total += row[i] * z[i]
    return total


@inner
def _add_product(columns, z, out):
    """out (n) += the matrix with these columns (n, n) times z (n)."""
    for m in range(len(z)):
        for i in range(len(out)):
            out[i] += columns[m, i] * z[m]


@inner
def _cross(y, z, jump, vectors, series, edges, width, theta):
    """y (n) behind crossings at which z (n) is: jump (2·clearances) holds ± ζ of side + and of side - of
    every clearance whose force sets in or ceases."""
    count = len(jump) // 2
    harmonics = (width - 1) // 2
    for c in range(count):
        for side in range(2):
            size = jump[2 * c + side]
            if size == 0.0:
                continue
            sign = 1.0 if side == 0 else -1.0
            moved = _dot(vectors[H, c], y) + _dot(vectors[DH, c], z)
            moved -= fourier_value(series, (DOFFSET * count + c) * width, harmonics, theta)
            moved -= sign * edges[DEDGE + side, c]
            for i in range(len(y)):
                y[i] += size * vectors[G, c, i] * moved


@inner
def _product(one, other, at, j):
    """Coefficient j of the product of two polynomials."""
    total = 0.0
    for i in range(j + 1):
        total += one[at + i] * other[at + j - i]
    return total


@allocating
def _forced(poly, sides, change, forcing, vectors, series, edges, width, theta, turn, eta, source):
    """source (ORDER+1, n) ← coefficients of what the change of the equations adds to the rate of z, whose
    coefficients are poly (ORDER+1, n); eta (clearances·TERMS) ← those of η where there is contact."""
    n, count = poly.shape[1], len(sides)
    harmonics = (width - 1) // 2
    terms, x, dx, deta = np.zeros(TERMS), np.zeros(TERMS), np.zeros(TERMS), np.zeros(TERMS)
    for i in range(n):
        fourier_taylor(forcing, i * width, harmonics, theta, turn, terms, 0)
        for j in range(ORDER + 1):
            source[j, i] = terms[j]
    for j in range(ORDER + 1 if len(change) > 0 else 0):
        _add_product(change, poly[j], source[j])
    for c in range(count):
        if sides[c] == FREE:
            continue
        side = 0 if sides[c] == PLUS else 1
        sign = 1.0 if side == 0 else -1.0
        own = eta[c * TERMS : (c + 1) * TERMS]
        for kind, out in ((ETA + side, own), (DETA + side, deta), (OFFSET, x), (DOFFSET, dx)):
            fourier_taylor(series, (kind * count + c) * width, harmonics, theta, turn, out, 0)
        for j in range(ORDER + 1):
            dx[j] = _dot(vectors[DH, c], poly[j]) - dx[j]
            x[j] = _dot(vectors[H, c], poly[j]) - x[j]
        x[0] -= sign * edges[EDGE + side, c]
        dx[0] -= sign * edges[DEDGE + side, c]
        for j in range(ORDER + 1):
            force = _product(own, dx, 0, j) + _product(deta, x, 0, j)
            whole = _product(own, x, 0, j)
            for i in range(n):
                source[j, i] += vectors[G, c, i] * force + vectors[DG, c, i] * whole


@inner
def _carried(y, poly, sides, matrix, vectors, eta, source, duration, growth, series, read):
    """y (n) over one piece, in place; growth: how fast the period's rate changes, relative to it."""
    n, count = len(y), len(sides)
    for i in range(n):
        series[0, i] = y[i]
    for j in range(ORDER):
        for c in range(count):
            read[c * TERMS + j] = _dot(vectors[H, c], series[j])
        for i in range(n):
            series[j + 1, i] = source[j, i]
        _add_product(matrix, series[j], series[j + 1])
        for c in range(count):
            if sides[c] != FREE:
                own = eta[c * TERMS : (c + 1) * TERMS]
                force = _product(own, read[c * TERMS : (c + 1) * TERMS], 0, j)
                for i in range(n):
                    series[j + 1, i] += vectors[G, c, i] * force
        for i in range(n):
            series[j + 1, i] = duration / (j + 1) * series[j + 1, i] - growth * poly[j + 1, i]
            y[i] += series[j + 1, i]


@kernel(
    void(
        CUBE, MATRIX, INTS, TABLE, MATRIX, INTS, CUBE, CUBE, CUBE, CUBE, MUTABLE, MATRIX, float64, float64,
        MATRIX,
    ),
    allocates=True,
)  # fmt: skip
def carry_change(
    polynomials, spans, regions, sides, jumps, parts, matrices, changes, forcings, vectors, series, edges,
    rate, growth, ends,
):  # fmt: skip
    """ends (parts, n) ← the derivative by the parameter of the state at the end of every part of a motion,
    each from a start that is held.

    polynomials (pieces, ORDER+1, n), as of a trace; spans (pieces, 2): phase at the start of a piece and its
    width, in rad of the base period; regions (pieces): which row of sides (regions, clearances), transposed
    matrices (regions, n, n), their changes (the same, or without rows where there are none), and changes of
    forcings (regions, n, width) it has; jumps
    (pieces, 2·clearances): ± ζ of every force that sets in or ceases with a jump where a piece begins; parts
    (pieces): of which part each is. vectors (4, clearances, n): h, g, and their changes; series: η⁺, η⁻,
    their changes, e and its change, each (clearances, width); edges (4, clearances): D⁺, D⁻, their changes;
    rate: dφ/dτ, growth: its relative change."""
    pieces, n, width = len(polynomials), polynomials.shape[2], forcings.shape[2]
    count = sides.shape[1]
    y, source, terms = np.zeros(n), np.zeros((ORDER + 1, n)), np.zeros((ORDER + 1, n))
    eta, read = np.zeros(count * TERMS), np.zeros(count * TERMS)
    part = 0
    for k in range(pieces):
        if parts[k] != part:
            ends[part] = y
            fill(y, 0.0)
            part = parts[k]
        elif k > 0:
            _cross(y, polynomials[k, 0], jumps[k], vectors, series, edges, width, spans[k, 0])
        region = regions[k]
        _forced(
            polynomials[k], sides[region], changes[region], forcings[region].reshape(-1), vectors, series,
            edges, width, spans[k, 0], spans[k, 1], eta, source,
        )  # fmt: skip
        _carried(
            y, polynomials[k], sides[region], matrices[region], vectors, eta, source, spans[k, 1] / rate,
            growth, terms, read,
        )  # fmt: skip
    ends[part] = y
