"""How the load is shared: the forces that push apart, and only push, what the gaps make overlap.

With the compliance C of all places on each other and the flattening w(f) of each contact itself the forces
f ≥ 0 make ½ fᵀCf + Σ ∫w df + fᵀg least. That is convex and has one answer; Newton's method on the set of
places that push finds it. The flattening is that of a line of contact down to the depth h below the surface,

    w = (f/l) (B − ½A ln(R f/l)),   A = Σ 2(1 − ν²)/(πE),

C. Weber, K. Banaschek, Formänderung und Profilrücknahme bei gerad- und schrägverzahnten Rädern, Vieweg,
Braunschweig 1953."""

from __future__ import annotations

from math import log, sqrt

from gearlash._kernel.jit import inner

from ._tables import HERTZ, LEAST_LOAD, LENGTH, LOG_LEAST, MOST_LOAD

STEPS = 60
CLOSE = 1e-5
"""Over the greatest force: behind a Newton step this small there is its square."""


@inner
def flattening(x, depth, f):
    """Approach w of one contact, its slope, and the work ∫w df; straight lines below the least load, where
    the logarithm has no slope, and above the most, where the contact is half as wide as the depth."""
    length, half = x[LENGTH], 0.5 * x[HERTZ]
    p, low, high = f / length, x[LEAST_LOAD], x[MOST_LOAD]
    soft = depth - half * x[LOG_LEAST]
    if p <= low:
        return soft * p, soft / length, 0.5 * soft * p * f
    at = min(p, high)
    ln = log(at)
    w, slope = at * (depth - half * ln), depth - half * ln - half
    work = 0.5 * soft * low * low + 0.5 * (at * at - low * low) * depth
    work -= 0.5 * half * (at * at * (ln - 0.5) - low * low * (x[LOG_LEAST] - 0.5))
    beyond = p - at
    return w + slope * beyond, slope / length, length * (work + beyond * (w + 0.5 * slope * beyond))


@inner
def factorise(matrix, n, column):
    """The lower triangle becomes its Cholesky factor; whether it is positive definite. Column by column, so
    that the innermost loop sums nothing up and goes several numbers at a time."""
    for j in range(n):
        if not matrix[j, j] > 0.0:
            return False
        pivot = sqrt(matrix[j, j])
        matrix[j, j] = pivot
        for i in range(j + 1, n):
            column[i] = matrix[i, j] / pivot
            matrix[i, j] = column[i]
        for i in range(j + 1, n):
            factor, row, above = column[i], matrix[i, j + 1 : i + 1], column[j + 1 : i + 1]
            for k in range(len(row)):
                row[k] -= factor * above[k]
    return True


@inner
def solve(matrix, n, right):
    """right ← what solves the factorised system."""
    for i in range(n):
        total = right[i]
        for k in range(i):
            total -= matrix[i, k] * right[k]
        right[i] = total / matrix[i, i]
    for i in range(n - 1, -1, -1):
        right[i] /= matrix[i, i]
        known, row, rest = right[i], matrix[i, :i], right[:i]
        for k in range(len(row)):
            rest[k] -= known * row[k]


@inner
def _begin(x, n, gap, compliance, depth, f, pushing):
    """First guess: the forces that are there, and more where they leave gaps closed; without any, as if all
    contacts were pressed alike."""
    m = 0
    for i in range(n):
        if f[i] > 0.0:
            pushing[m] = i
            m += 1
    if m > 0:
        return _called(n, gap, compliance, f, pushing, m)
    for i in range(n):
        row = 0.0
        for j in range(n):
            row += compliance[i, j]
        f[i] = -gap[i] / (row + (depth[i] - 0.5 * x[HERTZ] * log(1e5)) / x[LENGTH])
        pushing[i] = i
    return n


@inner
def share(x, n, gap, compliance, depth, f, factor, right, column, pushing):
    """f, a guess or zeros ← forces of n places; returns how many push, which ones in ``pushing``, the
    stiffness of those in ``factor``; −1: not found."""
    m = _begin(x, n, gap, compliance, depth, f, pushing)
    for _ in range(STEPS):
        for i in range(m):
            a = pushing[i]
            w, slope, _work = flattening(x, depth[a], f[a])
            right[i] = -gap[a] - w + slope * f[a]
            for j in range(i + 1):
                factor[i, j] = compliance[a, pushing[j]]
            factor[i, i] += slope
        if not factorise(factor, m, column):
            return -1
        solve(factor, m, right)
        moved, most, kept = 0.0, 0.0, 0
        for i in range(m):
            a = pushing[i]
            moved = max(moved, abs(right[i] - f[a]))
            f[a] = right[i] if right[i] > 0.0 else 0.0
            most = max(most, f[a])
        for i in range(m):
            if f[pushing[i]] > 0.0:
                pushing[kept] = pushing[i]
                kept += 1
        if kept == m and moved <= CLOSE * most:
            m = _called(n, gap, compliance, f, pushing, m)
            if m == kept:
                return m
        else:
            m = kept
        if m == 0:  # a guess that was all wrong
            m = _begin(x, n, gap, compliance, depth, f, pushing)
    return -1


@inner
def _called(n, gap, compliance, f, pushing, m):
    """Adds to those that push the others whose gap stays closed under the forces."""
    count = m
    for i in range(n):
        if f[i] > 0.0:
            continue
        left = gap[i]
        for j in range(m):
            left += compliance[i, pushing[j]] * f[pushing[j]]
        if left < 1e-9 * gap[i]:
            pushing[count] = i
            count += 1
    return count
