"""Entry points of the march: strobes and counts, tangents, traces, extrema."""

from __future__ import annotations

import numpy as np
from numba import float64, int64, types

from gearlash._kernel import inner, kernel

from ._roots import DEPTH, all_roots
from ._series import copy, copy_first, polynomial
from ._tables import FLOATS, INTS, MATRIX, ORDER, TABLES, Tables
from ._walk import OK, TOO_MANY, Record, arrives, cross, region_of, scratch, walk

_CUBE = types.Array(float64, 3, "C")
_COUNTS = types.Array(int64, 2, "C")


@inner
def _orthonormalise(tangents, sums):
    """Modified Gram-Schmidt, twice, on the rows of `tangents`; adds the logarithms of their lengths to
    `sums`."""
    m, n = tangents.shape
    for i in range(m):
        for _twice in range(2):
            for j in range(i):
                dot = 0.0
                for k in range(n):
                    dot += tangents[i, k] * tangents[j, k]
                for k in range(n):
                    tangents[i, k] -= dot * tangents[j, k]
        size = 0.0
        for k in range(n):
            size += tangents[i, k] ** 2
        size = np.sqrt(size)
        sums[i] += np.log(size)
        for k in range(n):
            tangents[i, k] /= size


@kernel(
    int64(
        TABLES,
        FLOATS,
        MATRIX,
        float64,
        float64,
        FLOATS,
        MATRIX,
        _COUNTS,
        FLOATS,
        INTS,
        MATRIX,
        _CUBE,
        MATRIX,
        MATRIX,
    )
)
def run(
    t: Tables,
    state_in,
    tangents_in,
    start,
    length,
    hold,
    strobes,
    counts,
    sums,
    used,
    piece,
    poly,
    event,
    state,
):
    """The one march: carries state and tangents (m, n) in place over len(counts) stretches of `length` cells.

    strobes (stretches+1, n) receives the state at every start and at the end, counts (stretches, 5) what
    happened in each stretch. With sums (m) the tangents are orthonormalised after each stretch. used[0] = -1
    records nothing, else piece, poly, event and state are filled (see `Record`). One entry point, because
    compiling each variant of the march apart would cost a new user half a minute. Returns an outcome code.
    """
    w = scratch(t)
    n, m = len(state_in), tangents_in.shape[0]
    z, tangents = np.zeros(len(t.gain)), np.zeros((m, len(t.gain)))
    copy(state_in, z)
    for v in range(m):
        copy(tangents_in[v], tangents[v])
    record = Record(used, piece, poly, event, state)
    cell = int(np.floor(start))
    s = start - cell
    region, on = region_of(t, w, z, cell, s)
    copy(state_in, strobes[0])
    for i in range(len(counts)):
        for j in range(counts.shape[1]):
            counts[i, j] = 0
    for stretch in range(len(counts)):
        stop_cell = int(np.floor(cell + s + length))
        stop_s = (s + length) - (stop_cell - cell)
        outcome, region = walk(
            t, w, z, tangents, region, on, cell, s, stop_cell, stop_s, hold, counts[stretch], record
        )
        on = 0
        # A span includes its end: a crossing just there is this span's, and the next starts behind it.
        at_end = arrives(t, w, region, z, stop_cell % t.maps.shape[1], stop_s) if outcome == OK else 0
        if at_end != 0 and not (at_end == hold[0] and hold[1] <= stop_cell + stop_s <= hold[2]):
            kept, region = cross(region, at_end, stop_cell + stop_s, z, counts[stretch], record)
            on = at_end
            outcome = OK if kept else TOO_MANY
        copy_first(z, n, state_in)
        copy(state_in, strobes[stretch + 1])
        if outcome != OK:
            return outcome
        if len(sums) > 0:
            _orthonormalise(tangents, sums)
        cell, s = stop_cell % t.maps.shape[1], stop_s
        if used[0] >= 0:
            cell = stop_cell
    for v in range(m):
        copy_first(tangents[v], n, tangents_in[v])
    return OK


@inner
def _second(c, s):
    value = 0.0
    for j in range(len(c) - 1, 1, -1):
        value = value * s + j * (j - 1) * c[j]
    return value


@kernel(int64(MATRIX, MATRIX, MATRIX, MATRIX))
def extrema(piece, gap, basis, found):
    """Simple zeros of X' over all pieces.

    gap (pieces, ORDER+1): Taylor coefficients of X per piece in its own local time; basis: Taylor to
    Bernstein of degree ORDER-1. found (m, 4) receives position, X, second derivative in local time, piece
    index."""
    slope, roots = np.empty(ORDER), np.empty(ORDER)
    stack, limits = np.empty((DEPTH + 2, ORDER + 1)), np.empty((DEPTH + 2, 2))
    count = 0
    for p in range(len(piece)):
        for j in range(ORDER):
            slope[j] = (j + 1) * gap[p, j + 1]
        number = all_roots(slope, basis, stack, limits, roots)
        for r in range(number):
            if count >= len(found):
                return count
            s = roots[r]
            found[count, 0] = piece[p, 0] + s * piece[p, 1]
            found[count, 1] = polynomial(gap[p], s)
            found[count, 2] = _second(gap[p], s)
            found[count, 3] = p
            count += 1
    return count
