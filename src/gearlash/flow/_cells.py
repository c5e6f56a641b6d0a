"""Cell propagators: the affine map over every cell of the phase grid, column by column, by Taylor series.

A column is the response to a unit start in one state, or from rest to one unit input: a harmonic of the
forcing on one state, the edge of the gap, or a harmonic of the gap's offset. Load, error and gap are
amplitudes of such inputs, so changing them rebuilds nothing (`combine`)."""

from __future__ import annotations

import numpy as np
from numba import float64, types

from gearlash._kernel import inner, kernel

from ._blocks import next_coefficient
from ._series import copy, fill, fourier_taylor, product
from ._tables import CHECK, FLOATS, INTS, MATRIX, ORDER

_CUBE = types.Array(float64, 3, "C")
_UNITS = types.Array(types.int64, 2, "C")

EDGE, OFFSET = -1, -2  # kinds of unit input; a kind >= 0 is a forced state
TAIL = 24  # further terms of the majorant that bounds the Taylor remainder
UNIT_ROUNDING = 2.0**-53


@inner
def _column(matrix, gain, reads, read, eta, kind, source, duration, zc, xc):
    """Taylor coefficients of one column. xc becomes X (without the edge), the force sees X - edge."""
    n = matrix.shape[1]
    for j in range(ORDER + 1):
        x = 0.0
        for i in range(len(reads)):
            x += read[i] * zc[j, reads[i]]
        if kind == OFFSET:
            x -= source[j]
        xc[j] = x
        if j == ORDER:
            break
        push = product(eta, xc, j)
        if kind == EDGE:
            push -= eta[j]
        scale = duration / (j + 1)
        next_coefficient(matrix, 0, gain, push, scale, zc, j, n)
        if kind >= 0:
            zc[j + 1, kind] += source[j] * scale


@inner
def _growth(matrix, gain, read, stiffness, width):
    """Norms for the majorant: [‖M‖∞, ‖g‖∞, ‖h‖₁, η̂_0, η̂_1, ...] with η̂_j ≥ |Taylor coefficient j of η|."""
    n = matrix.shape[1]
    out = np.zeros(3 + ORDER + TAIL + 1)
    for i in range(n):
        row = 0.0
        for k in range(n):
            row += abs(matrix[0, k, i])
        out[0] = max(out[0], row)
        out[1] = max(out[1], abs(gain[i]))
    for i in range(len(read)):
        out[2] += abs(read[i])
    out[3] = abs(stiffness[0])
    for h in range(1, (len(stiffness) + 1) // 2):
        term = np.sqrt(stiffness[2 * h - 1] ** 2 + stiffness[2 * h] ** 2)
        for j in range(ORDER + TAIL + 1):
            out[3 + j] += term
            term *= h * width / (j + 1)
    return out


@inner
def _remainder(growth, duration, read, zc, forced, kind, rate):
    """Bounds on the sum of all Taylor terms above ORDER: of the state (∞-norm), and of X.

    The recurrence is repeated with norms in place of vectors, from the computed terms on.
    """
    norm, x, source = np.zeros(ORDER + TAIL + 1), np.zeros(ORDER + TAIL + 1), np.zeros(ORDER + TAIL + 1)
    if forced:
        term = 1.0
        for j in range(ORDER + TAIL + 1):
            source[j] = term
            term *= rate / (j + 1)
    for j in range(ORDER + 1):
        for i in range(zc.shape[1]):
            norm[j] = max(norm[j], abs(zc[j, i]))
    state, gap = 0.0, 0.0
    for j in range(ORDER + TAIL):
        x[j] = growth[2] * norm[j]
        if kind == OFFSET or (kind == EDGE and j == 0):
            x[j] += source[j]
        if j < ORDER:
            continue
        push = 0.0
        for i in range(j + 1):
            push += growth[3 + i] * x[j - i]
        norm[j + 1] = (
            duration / (j + 1) * (growth[0] * norm[j] + growth[1] * push + (source[j] if kind >= 0 else 0.0))
        )
        state += norm[j + 1]
        gap += growth[2] * norm[j + 1] + (source[j + 1] if kind == OFFSET else 0.0)
    last = ORDER + TAIL
    total = 0.0
    for j in range(3, len(growth)):
        total += growth[j]
    ratio = duration * (growth[0] + growth[1] * growth[2] * (1.0 + total)) / last
    if ratio > 0.5:  # the majorant does not converge yet: no bound, more cells are needed
        return np.inf, np.inf
    return state + 2.0 * norm[last], gap + 2.0 * growth[2] * norm[last]


@kernel(
    types.void(_CUBE, FLOATS, INTS, FLOATS, FLOATS, _UNITS, float64, float64, _CUBE, _CUBE, _CUBE, MATRIX)
)
def unit_responses(matrix, gain, reads, read, stiffness, units, omega, duration, maps, forced, gap, tails):
    """Fills maps (N, n, p: [cell, column, row]), forced (N, units, p), gap (N, n + units, ORDER+1: Taylor
    coefficients of X) and tails (2, n + units: remainder of the state, of X; largest over the cells).

    matrix (1, n, p) and gain (p) are padded to whole blocks; reads and read (m) hold h without its zeros;
    `units` (units, 2) holds (kind, slot of the Fourier series)."""
    n, cells = matrix.shape[1], maps.shape[0]
    width = omega * duration
    eta, source, zc, xc = (
        np.empty(ORDER + 1),
        np.empty(ORDER + 1),
        np.zeros((ORDER + 1, len(gain))),
        np.empty(ORDER + 1),
    )
    slots = 0
    for u in range(len(units)):
        slots = max(slots, units[u, 1])
    one = np.zeros(2 * (slots // 2 + 1) + 1)
    growth = _growth(matrix, gain, read, stiffness, width)
    fill(tails[0], 0.0)
    fill(tails[1], 0.0)
    for cell in range(cells):
        theta = cell * width
        fourier_taylor(stiffness, theta, width, eta)
        for c in range(n + len(units)):
            fill(zc[0], 0.0)
            fill(source, 0.0)
            kind, harmonic = 0, 0
            if c < n:
                zc[0, c] = 1.0
            else:
                kind, slot = units[c - n, 0], units[c - n, 1]
                harmonic = (slot + 1) // 2
                fill(one, 0.0)
                one[slot] = 1.0
                if kind == EDGE:
                    source[0] = 1.0
                else:
                    fourier_taylor(one, theta, width, source)
            _column(matrix, gain, reads, read, eta, kind, source, duration, zc, xc)
            for j in range(ORDER + 1):
                gap[cell, c, j] = xc[j]
            out = maps[cell, c] if c < n else forced[cell, c - n]
            fill(out, 0.0)
            for j in range(ORDER, -1, -1):
                for i in range(len(out)):
                    out[i] += zc[j, i]
            state, x = _remainder(growth, duration, read, zc, c >= n, kind, harmonic * width)
            tails[0, c], tails[1, c] = max(tails[0, c], state), max(tails[1, c], x)


@inner
def _bounds(x, tail, to_check, check, slack, bend, c):
    """Bernstein coefficients of the leading part, a bound on the rest, and max|X''|/8, for one column."""
    highest, rest, curve, total = 0.0, 0.0, 0.0, 0.0
    for i in range(CHECK + 1):
        value = 0.0
        for j in range(i + 1):
            value += to_check[i, j] * x[j]
        check[i] = value
        highest = max(highest, abs(value))
    for j in range(ORDER + 1):
        total += abs(x[j])
        if j > CHECK:
            rest += abs(x[j])
        curve += j * (j - 1) * abs(x[j])
    slack[c] = rest + tail + 64.0 * UNIT_ROUNDING * (total + highest)
    bend[c] = curve / 8.0


@kernel(types.void(FLOATS, _CUBE, _CUBE, MATRIX, MATRIX, MATRIX, _CUBE, MATRIX, MATRIX, FLOATS))
def combine(amplitudes, forced, gap, tails, to_check, shift, check, slack, bend, tail):
    """Sums unit inputs to the forced part of one region's maps, and writes the bounds that prove cells clear.

    amplitudes (units); to_check (CHECK+1, CHECK+1) Taylor to Bernstein; shift (N, p); check (N, n+1,
    CHECK+1); slack, bend (N, n+1); tail (n+1). The last column holds the constant part."""
    cells, units = forced.shape[0], forced.shape[1]
    n, p = check.shape[1] - 1, forced.shape[2]
    x = np.empty(ORDER + 1)
    for c in range(n):
        tail[c] = tails[1, c]
    tail[n] = 0.0
    for u in range(units):
        tail[n] += abs(amplitudes[u]) * tails[1, n + u]
    for cell in range(cells):
        for i in range(p):
            shift[cell, i] = 0.0
        for u in range(units):
            for i in range(p):
                shift[cell, i] += amplitudes[u] * forced[cell, u, i]
        for c in range(n + 1):
            fill(x, 0.0)
            if c < n:
                copy(gap[cell, c], x)
            else:
                for u in range(units):
                    for j in range(ORDER + 1):
                        x[j] += amplitudes[u] * gap[cell, n + u, j]
            _bounds(x, tail[c], to_check, check[cell, c], slack[cell], bend[cell], c)


@kernel(float64(MATRIX, types.int64))
def spectral_radius(matrix, squarings):
    """Estimate of the largest |eigenvalue| as ‖A^(2^k)‖^(1/2^k), by plain loops so that it is the same
    everywhere."""
    n = matrix.shape[0]
    power, product, log = np.empty((n, n)), np.empty((n, n)), 0.0
    for i in range(n):
        copy(matrix[i], power[i])
    for _ in range(squarings):
        size = 0.0
        for i in range(n):
            for j in range(n):
                value = 0.0
                for m in range(n):
                    value += power[i, m] * power[m, j]
                product[i, j] = value
                size = max(size, abs(value))
        if size == 0.0:
            return 0.0
        for i in range(n):
            for j in range(n):
                power[i, j] = product[i, j] / size
        log = 2.0 * log + np.log(size)
    rows = 0.0
    for i in range(n):
        row = 0.0
        for j in range(n):
            row += abs(power[i, j])
        rows = max(rows, row)
    return np.exp((log + np.log(rows)) / 2.0**squarings)
