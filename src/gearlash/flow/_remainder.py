"""Bounds on what Taylor series leave out: the recurrence of a cell, repeated with absolute values."""

from __future__ import annotations

import numpy as np

from gearlash._kernel.jit import allocating, inner

from ._tables import ORDER, Shape

TAIL_TERMS = 24  # further terms of the majorant
LAST_TERM = ORDER + TAIL_TERMS
TAIL_RATIO = 0.375  # ratio of the geometric series that bounds all terms behind the last
RATIO_TRIES = 30  # at finding its first term


@allocating
def eta_bounds(shape: Shape, memory, active, sides, width):
    """(clearances, LAST_TERM+2): bounds on the Taylor coefficients of the stiffness that acts in a region;
    the last column holds their sum with weights `TAIL_RATIO`^-j, all orders included."""
    out, series = np.zeros((shape.clearances, LAST_TERM + 2)), 2 * shape.harmonics + 1
    for c in range(shape.clearances):
        if active[c] == 0:
            continue
        at = shape.stiffness + (2 * c + (0 if sides[c] == 0 else 1)) * series
        out[c, 0] = abs(memory[at])
        out[c, LAST_TERM + 1] = out[c, 0]
        for h in range(1, shape.harmonics + 1):
            term = np.sqrt(memory[at + 2 * h - 1] ** 2 + memory[at + 2 * h] ** 2)
            out[c, LAST_TERM + 1] += term * np.exp(h * width / TAIL_RATIO)
            for j in range(LAST_TERM + 1):
                out[c, j] += term
                term *= h * width / (j + 1)
    return out


@allocating
def majorant(equations, filled, readers, last, known, eta, duration, rate, all_terms):
    """Bound on the sum of all Taylor terms above ORDER of a unit column's states, and on that sum with every
    term times its order; infinite where it cannot be had (more cells are needed). Without ``all_terms`` those
    up to LAST_TERM alone, which are less, and grow with every number that is given.

    equations (n, n + gaps), readers (gaps, n) flat; filled (n, 2): the first number of each row that is not
    zero, and how many there are from it to the last; last (n): |term of degree ORDER| of each state;
    known (gaps, ORDER+1): |coefficients| of what is read; eta as from `eta_bounds`; rate: highest
    harmonic times the width of a cell, whose powers over factorials bound every unit input."""
    n, gaps = len(last), len(eta)
    terms, new, source = np.zeros(n), np.zeros(n), np.zeros(LAST_TERM + 1)
    read, pushed = np.zeros((gaps, LAST_TERM + 1)), np.zeros(gaps)
    for i in range(n):
        terms[i] = last[i]
    for c in range(gaps):
        for j in range(ORDER + 1):
            read[c, j] = known[c, j]
    term = 1.0
    for j in range(LAST_TERM + 1):
        source[j] = term
        term *= rate / (j + 1)
    value, derived = 0.0, 0.0
    for j in range(ORDER, LAST_TERM):
        for c in range(gaps):
            if j > ORDER:
                read[c, j] = source[j] + _read(readers, c, n, terms)
            force = eta[c, j]
            for i in range(j + 1):
                force += eta[c, i] * read[c, j - i]
            pushed[c] = force
        size = _step(equations, filled, n, gaps, terms, pushed, source[j], duration / (j + 1), new)
        for i in range(n):
            terms[i] = new[i]
        value += size
        derived += (j + 1) * size
    if not all_terms:
        return value, derived
    rest = _geometric(equations, filled, readers, terms, read, eta, source[LAST_TERM], duration, rate)
    return value + rest * TAIL_RATIO / (1.0 - TAIL_RATIO), derived + rest * (LAST_TERM + 2.0)


@inner
def _read(readers, c, n, terms):
    """|h_c| · terms."""
    total = 0.0
    for i in range(n):
        total += abs(readers[c * n + i]) * terms[i]
    return total


@inner
def _step(equations, filled, n, gaps, terms, pushed, source, factor, new):
    """new ← factor (|M| terms + |g| pushed + source); returns its largest entry."""
    size = 0.0
    for i in range(n):
        total, row, first = source, i * (n + gaps), filled[i, 0]
        behind = first + filled[i, 1]
        for k in range(first, min(n, behind)):
            total += abs(equations[row + k]) * terms[k]
        for c in range(max(0, first - n), behind - n):
            total += abs(equations[row + n + c]) * pushed[c]
        new[i] = total * factor
        size = max(size, new[i])
    return size


@allocating
def _geometric(equations, filled, readers, terms, read, eta, source, duration, rate):
    """The largest entry of a vector w such that all terms behind the last, L = LAST_TERM, obey
    t_(L+k) ≤ q^k w with q = TAIL_RATIO.

    Let r_k bound what is read, r_k ≤ R q^(k-L) for all k so far, and let the inputs fall by q too. If t ≤ w
    for the last term, |h| w + source ≤ R, and one more step of the recurrence from (w, R) gives at most q·w,
    then by induction every further step does. Such a w is looked for by raising it where it fails."""
    n, gaps = len(terms), len(eta)
    w, new, reached, pushed = np.zeros(n), np.zeros(n), np.zeros(gaps), np.zeros(gaps)
    if not rate / (LAST_TERM + 1) <= TAIL_RATIO:
        return np.inf
    for i in range(n):
        w[i] = terms[i]
    for c in range(gaps):
        weight = 1.0
        for k in range(LAST_TERM - 1, -1, -1):
            weight *= TAIL_RATIO
            reached[c] = max(reached[c], read[c, k] * weight)
    for _ in range(RATIO_TRIES):
        for c in range(gaps):
            reached[c] = max(reached[c], source + _read(readers, c, n, w))
            pushed[c] = eta[c, LAST_TERM + 1] * (reached[c] + source)
        _step(equations, filled, n, gaps, w, pushed, source, duration / (LAST_TERM + 1) / TAIL_RATIO, new)
        enough = True
        for i in range(n):
            if not new[i] <= w[i]:
                w[i] = 1.5 * new[i]
                enough = False
        if enough:
            size = 0.0
            for i in range(n):
                size = max(size, w[i])
            return size
    return np.inf
