"""First sign change of a polynomial on [0, 1], proved by its Bernstein coefficients.

A polynomial lies within the range of its Bernstein coefficients, and it has at most as many roots in the
interval as they have sign changes (Descartes). Subdividing until the answer is "none" or "one" therefore
finds the first root or proves that there is none; what stays open within the error bound is reported as
undecided.

Source: G. Farin, Curves and Surfaces for CAGD, 5th ed. (2002); B. Mourrain, F. Rouillier, M.-F. Roy,
"The Bernstein basis and real root isolation", MSRI Publications 52 (2005) 459-478.
"""

from __future__ import annotations

import functools

import numpy as np

from gearlash._kernel import fma, inner

NONE = 2.0  # "no root in [0, 1]"
DEPTH = 44  # subdivisions: an interval of 2^-44 of a cell is below the rounding of its ends


@inner
def first_exit(c, deflate, bound, basis, stack, limits):
    """First s in [0, 1] at which the distance polynomial ``c`` turns negative, and whether all was decided.

    ``deflate``: the distance is zero at s = 0 by construction (just crossed), so ``c(s)/s`` is examined.
    ``bound`` covers rounding and remainder of c. ``basis`` (2, d+1, d+1) turns Taylor into Bernstein
    coefficients, ``stack`` (DEPTH+2, d+1) and ``limits`` (DEPTH+2, 2) are scratch. Returns (s or NONE,
    undecided)."""
    degree = len(c) - 1
    first = 1 if deflate else 0
    q = c[first:]
    m = degree - first
    table = basis[first]
    for i in range(m + 1):
        value = 0.0
        for j in range(i + 1):
            value = fma(table[i, j], q[j], value)
        stack[0, i] = value
    limits[0, 0], limits[0, 1] = 0.0, 1.0
    undecided = False
    top = 1
    while top > 0:
        top -= 1
        lo, hi = limits[top, 0], limits[top, 1]
        b = stack[top]
        if _all_above(b, m, bound):
            continue
        if _leaves_zero(b, m, bound):
            # on the boundary and moving inward: plain at the start of the interval, a touch anywhere else
            undecided = undecided or deflate or lo > 0.0
            continue
        if b[0] < 0.0 or (b[0] == 0.0 and b[1] < 0.0):
            return lo, undecided or (deflate and b[0] > -bound)
        changes = _sign_changes(b, m)
        if changes == 1 and b[m] < -bound:
            return _polish(q, lo, hi), undecided
        if b[m] >= -bound and _falling(b, m, bound):
            continue  # one root at most, and it lies at or behind the end: the next interval has it
        if hi - lo < 2.0**-DEPTH or _all_below(b, m, bound) or top + 2 > DEPTH:
            undecided = True
            if b[m] < 0.0:
                return hi, True
            continue
        _split(stack, top, m)
        middle = 0.5 * (lo + hi)
        limits[top + 1, 0], limits[top + 1, 1] = lo, middle
        limits[top, 0], limits[top, 1] = middle, hi
        top += 2
    return NONE, undecided


@inner
def _all_above(b, m, bound):
    lowest = b[0]
    for i in range(1, m + 1):
        lowest = min(lowest, b[i])
    return lowest > bound


@inner
def _leaves_zero(b, m, bound):
    lowest = b[1]
    for i in range(2, m + 1):
        lowest = min(lowest, b[i])
    return abs(b[0]) <= bound and lowest > bound


@inner
def _all_below(b, m, bound):
    highest = 0.0
    for i in range(m + 1):
        highest = max(highest, abs(b[i]))
    return highest <= bound


@inner
def _falling(b, m, bound):
    for i in range(m):
        if b[i + 1] - b[i] >= 0.0:
            return False
    return b[0] - b[m] > 4.0 * bound


@inner
def _sign_changes(b, m):
    changes, last = 0, 0.0
    for i in range(m + 1):
        if b[i] != 0.0:
            if last * b[i] < 0.0:
                changes += 1
            last = 1.0 if b[i] > 0.0 else -1.0
    return changes


@inner
def _split(stack, top, m):
    """De Casteljau at the middle: the left half to row top+1, the right half stays in row `top`."""
    right, left = stack[top], stack[top + 1]
    for i in range(m + 1):
        left[i] = right[0]
        for j in range(m - i):
            right[j] = 0.5 * (right[j] + right[j + 1])
        # right[m - i] is now final


@inner
def _polish(q, lo, hi):
    """The one root in [lo, hi], where q falls from + to -: Newton's method kept inside a shrinking
    bracket."""
    s = 0.5 * (lo + hi)
    for _ in range(100):
        value, slope = 0.0, 0.0
        for j in range(len(q) - 1, -1, -1):
            slope = fma(slope, s, value)
            value = fma(value, s, q[j])
        if value > 0.0:
            lo = s
        elif value < 0.0:
            hi = s
        else:
            return s
        step = s - value / slope if slope != 0.0 else 0.5 * (lo + hi)
        if not lo < step < hi:
            step = 0.5 * (lo + hi)
        if abs(step - s) <= 2.3e-16 * s or step in (lo, hi):
            return step
        s = step
    return s


@inner
def all_roots(c, basis, stack, limits, out):
    """All simple roots in (0, 1] of the polynomial ``c``, ascending; returns their number (used for
    extrema)."""
    m = len(c) - 1
    for i in range(m + 1):
        value = 0.0
        for j in range(i + 1):
            value = fma(basis[i, j], c[j], value)
        stack[0, i] = value
    limits[0, 0], limits[0, 1] = 0.0, 1.0
    count, top = 0, 1
    while top > 0 and count < len(out):
        top -= 1
        lo, hi = limits[top, 0], limits[top, 1]
        changes = _sign_changes(stack[top], m)
        if changes == 0:
            if stack[top, m] == 0.0 and stack[top, 0] != 0.0:
                out[count] = hi  # exactly at the end of the interval
                count += 1
            continue
        ends = stack[top, 0] * stack[top, m]
        if changes == 1 and ends < 0.0:
            out[count] = _bracketed(c, lo, hi, stack[top, 0])
            count += 1
            continue
        if hi - lo < 2.0**-DEPTH or top + 2 > DEPTH:
            continue
        _split(stack, top, m)
        middle = 0.5 * (lo + hi)
        limits[top + 1, 0], limits[top + 1, 1] = lo, middle
        limits[top, 0], limits[top, 1] = middle, hi
        top += 2
    return count


@inner
def _bracketed(c, lo, hi, start):
    if start > 0.0:
        return _polish(c, lo, hi)
    return _polish(-c, lo, hi)


@functools.cache
def taylor_to_bernstein(degree: int, size: int) -> np.ndarray:
    """Matrix (size, size) with b_i = Σ_j C(i,j)/C(degree,j) c_j in its leading block."""
    from math import comb

    out = np.zeros((size, size))
    for i in range(degree + 1):
        for j in range(i + 1):
            out[i, j] = comb(i, j) / comb(degree, j)
    return out
