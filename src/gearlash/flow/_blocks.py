"""Small matrix-vector products in blocks of eight rows.

Rows are padded to a multiple of eight with zeros. Eight running sums in eight plain variables are what the
compiler turns into one vector register; a loop over rows of unknown number it would not (it prepares for long
loops, and the rest of ten rows is done one by one)."""

from __future__ import annotations

import numpy as np

from gearlash._kernel import fma, inner

LANES = 8
# Unsigned indices: a signed one may be negative, counting from the end, and testing for it keeps eight
# neighbours from being loaded at once.
U0, U1, U2, U3, U4, U5, U6, U7, U8 = (np.uint64(i) for i in range(9))


@inner
def map_cell(maps, shift, region, cell, z, n, out):
    """out ← map · z + shift of one cell; z and out are padded."""
    for block in range(len(out) // LANES):
        o = np.uint64(block) * U8
        a0, a1 = shift[region, cell, o], shift[region, cell, o + U1]
        a2, a3 = shift[region, cell, o + U2], shift[region, cell, o + U3]
        a4, a5 = shift[region, cell, o + U4], shift[region, cell, o + U5]
        a6, a7 = shift[region, cell, o + U6], shift[region, cell, o + U7]
        for k in range(n):
            x = z[k]
            a0 = fma(maps[region, cell, k, o], x, a0)
            a1 = fma(maps[region, cell, k, o + U1], x, a1)
            a2 = fma(maps[region, cell, k, o + U2], x, a2)
            a3 = fma(maps[region, cell, k, o + U3], x, a3)
            a4 = fma(maps[region, cell, k, o + U4], x, a4)
            a5 = fma(maps[region, cell, k, o + U5], x, a5)
            a6 = fma(maps[region, cell, k, o + U6], x, a6)
            a7 = fma(maps[region, cell, k, o + U7], x, a7)
        out[o], out[o + U1], out[o + U2], out[o + U3] = a0, a1, a2, a3
        out[o + U4], out[o + U5], out[o + U6], out[o + U7] = a4, a5, a6, a7


@inner
def map_tangent(maps, region, cell, tangents, v, n, out):
    """out ← map · tangent of one cell, without its forced part."""
    for block in range(len(out) // LANES):
        o = np.uint64(block) * U8
        a0 = a1 = a2 = a3 = a4 = a5 = a6 = a7 = 0.0
        for k in range(n):
            x = tangents[v, k]
            a0 = fma(maps[region, cell, k, o], x, a0)
            a1 = fma(maps[region, cell, k, o + U1], x, a1)
            a2 = fma(maps[region, cell, k, o + U2], x, a2)
            a3 = fma(maps[region, cell, k, o + U3], x, a3)
            a4 = fma(maps[region, cell, k, o + U4], x, a4)
            a5 = fma(maps[region, cell, k, o + U5], x, a5)
            a6 = fma(maps[region, cell, k, o + U6], x, a6)
            a7 = fma(maps[region, cell, k, o + U7], x, a7)
        out[o], out[o + U1], out[o + U2], out[o + U3] = a0, a1, a2, a3
        out[o + U4], out[o + U5], out[o + U6], out[o + U7] = a4, a5, a6, a7


@inner
def next_coefficient(matrix, region, gain, push, scale, zc, j, n):
    """zc[j+1] ← scale · (matrix · zc[j] + gain · push): one step of the Taylor recurrence."""
    for block in range(zc.shape[1] // LANES):
        o = np.uint64(block) * U8
        a0, a1, a2, a3 = gain[o] * push, gain[o + U1] * push, gain[o + U2] * push, gain[o + U3] * push
        a4, a5, a6, a7 = gain[o + U4] * push, gain[o + U5] * push, gain[o + U6] * push, gain[o + U7] * push
        for k in range(n):
            x = zc[j, k]
            a0 = fma(matrix[region, k, o], x, a0)
            a1 = fma(matrix[region, k, o + U1], x, a1)
            a2 = fma(matrix[region, k, o + U2], x, a2)
            a3 = fma(matrix[region, k, o + U3], x, a3)
            a4 = fma(matrix[region, k, o + U4], x, a4)
            a5 = fma(matrix[region, k, o + U5], x, a5)
            a6 = fma(matrix[region, k, o + U6], x, a6)
            a7 = fma(matrix[region, k, o + U7], x, a7)
        zc[j + 1, o], zc[j + 1, o + U1] = a0 * scale, a1 * scale
        zc[j + 1, o + U2], zc[j + 1, o + U3] = a2 * scale, a3 * scale
        zc[j + 1, o + U4], zc[j + 1, o + U5] = a4 * scale, a5 * scale
        zc[j + 1, o + U6], zc[j + 1, o + U7] = a6 * scale, a7 * scale


@inner
def bernstein_range(check, region, cell, z, n):
    """Least and largest of the eight Bernstein coefficients of X over one cell."""
    a0, a1 = check[region, cell, n, U0], check[region, cell, n, U1]
    a2, a3 = check[region, cell, n, U2], check[region, cell, n, U3]
    a4, a5 = check[region, cell, n, U4], check[region, cell, n, U5]
    a6, a7 = check[region, cell, n, U6], check[region, cell, n, U7]
    for k in range(n):
        x = z[k]
        a0 = fma(check[region, cell, k, U0], x, a0)
        a1 = fma(check[region, cell, k, U1], x, a1)
        a2 = fma(check[region, cell, k, U2], x, a2)
        a3 = fma(check[region, cell, k, U3], x, a3)
        a4 = fma(check[region, cell, k, U4], x, a4)
        a5 = fma(check[region, cell, k, U5], x, a5)
        a6 = fma(check[region, cell, k, U6], x, a6)
        a7 = fma(check[region, cell, k, U7], x, a7)
    lowest = min(min(min(a0, a1), min(a2, a3)), min(min(a4, a5), min(a6, a7)))
    highest = max(max(max(a0, a1), max(a2, a3)), max(max(a4, a5), max(a6, a7)))
    return lowest, highest


def padded(n: int) -> int:
    """n rounded up to whole blocks."""
    return -(-n // LANES) * LANES
