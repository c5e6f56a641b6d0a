"""First time at which a distance to a surface turns negative, proved by Bernstein coefficients.

A polynomial lies within the range of its Bernstein coefficients, and it has at most as many roots in the
interval as they have sign changes (Descartes). Subdividing until the answer is "none" or "one" therefore
finds the first root or proves that there is none. Every coefficient is known within a bound (Taylor remainder
and rounding); one within its bound of zero counts as either sign, so that the answer holds for the true
function too. What stays open within the bound is reported as undecided.

Source: G. Farin, Curves and Surfaces for CAGD, 5th ed. (2002); B. Mourrain, F. Rouillier, M.-F. Roy,
"The Bernstein basis and real root isolation", MSRI Publications 52 (2005) 459-478.
"""

from __future__ import annotations

from gearlash._kernel.jit import inlined, inner

from ._blocks import LANES
from ._series import jet, recentre
from ._tables import ORDER, TERMS, Shape
from ._vector import linear, powers, times, weigh
from ._workspace import DEPTH, LIMITS, LOCAL, ONES, POWERS, SCALED, STACK, SURFACE

NO_ROOT = 2.0  # "no root in [0, 1]"
NO_CHANGE, ONE_CHANGE, UNDECIDED = 0, 1, 2
MOST_HALLEY_STEPS = 100  # of `polish`


@inlined
def first_root(shape: Shape, memory, work, start, end, bound, slope_bound, on):
    """First s in [start, end] at which the distance polynomial in `SURFACE` turns negative, or `NO_ROOT`, and
    whether anything stayed undecided.

    ``bound`` and ``slope_bound`` cover rounding and remainder of the polynomial and of its derivative. A
    start within the bound of the surface goes by its direction: it leaves inward, or exits at once.
    ``on``: it has just been crossed there, and is left inward."""
    length = end - start
    recentre(memory, shape.pascal, work, SURFACE, start, POWERS, SCALED, work, LOCAL)
    here, speed = work[LOCAL], work[LOCAL + 1]
    leaving, undecided = False, False
    if here < -bound and not on:
        return start, False
    if here <= bound:
        if on:
            undecided = speed <= slope_bound
        elif speed < -slope_bound:
            return start, False
        elif (
            speed <= slope_bound
        ):  # at rest on the surface: the curvature decides, surely only if it is exact
            if work[LOCAL + 2] < 0.0:
                return start, not (here == 0.0 and speed == 0.0)
            undecided = not (here == 0.0 and speed == 0.0)
        leaving = True
    if length <= 0.0:
        return NO_ROOT, undecided
    if length != 1.0:
        powers(length, work, POWERS)
        times(work, POWERS, work, LOCAL, TERMS)
    size = weigh(work, ONES, TERMS, work, LOCAL)
    first, limit = 0, bound
    if leaving:
        first, limit = 1, slope_bound * length
        size -= abs(here)
    if 2.0 * abs(work[LOCAL + first]) - size > limit and work[LOCAL + first] > 0.0:
        return NO_ROOT, undecided  # the leading term outweighs all others
    s, open_case = _isolate(shape, memory, work, first, limit)
    return (start + length * s if s < NO_ROOT else NO_ROOT), undecided or open_case


@inlined
def _isolate(shape: Shape, memory, work, first, bound):
    """First root in [0, 1] of the polynomial in `LOCAL`, divided by s if ``first`` is 1."""
    m = ORDER - first
    table = shape.bernstein + first * (ORDER + 1) * TERMS
    linear(memory, table, TERMS, TERMS, m + 1, work, LOCAL + first, work, STACK)
    work[LIMITS], work[LIMITS + 1] = 0.0, 1.0
    undecided, top = False, 1
    while top > 0:
        top -= 1
        b, lo, hi = STACK + top * TERMS, work[LIMITS + 2 * top], work[LIMITS + 2 * top + 1]
        verdict, place = _verdict(work, b, m, bound)
        if verdict == NO_CHANGE:
            continue
        if verdict == ONE_CHANGE:
            if place < 0:
                return lo, undecided  # at the beginning, within rounding
            fall = work[b + place] - work[b + place + 1]
            guess = lo + (hi - lo) * (place + work[b + place] / fall) / m
            return polish(work, LOCAL + first, 0.0, lo, hi, guess, 1.0), undecided
        last = work[b + m]
        if last >= -bound and _falling(work, b, m, bound):
            continue  # one root at most, and it lies at or behind the end: the next interval has it
        if lo > 0.0 and abs(work[b]) <= bound and _rising(work, b, m, bound):
            undecided = True  # it comes down to zero and goes up again: a touch within rounding
            continue
        if hi - lo < 2.0**-DEPTH or _all_small(work, b, m, bound) or top + 2 > DEPTH:
            undecided = True
            if last < 0.0:
                return hi, True
            continue
        _split(work, b, b + TERMS, m)
        middle = 0.5 * (lo + hi)
        work[LIMITS + 2 * top + 2], work[LIMITS + 2 * top + 3] = lo, middle
        work[LIMITS + 2 * top], work[LIMITS + 2 * top + 1] = middle, hi
        top += 2
    return NO_ROOT, undecided


@inlined
def _verdict(work, b, m, bound):
    """(NO_CHANGE, 0): all coefficients are above the bound. (ONE_CHANGE, i): they are above it up to i, then
    below it, with one at most between them that may be either: exactly one root (i = -1: at the beginning).
    Else (UNDECIDED, 0)."""
    i = 0
    while i <= m and work[b + i] > bound:
        i += 1
    if i > m:
        return NO_CHANGE, 0
    before = i - 1
    if work[b + i] >= -bound:
        i += 1
    if i > m:
        return UNDECIDED, 0  # the last one may be either
    while i <= m and work[b + i] < -bound:
        i += 1
    return (ONE_CHANGE if i > m else UNDECIDED), before


@inner
def _all_small(work, b, m, bound):
    highest = 0.0
    for i in range(m + 1):
        highest = max(highest, abs(work[b + i]))
    return highest <= bound


@inner
def _falling(work, b, m, bound):
    for i in range(m):
        if work[b + i + 1] - work[b + i] >= 0.0:
            return False
    return work[b] - work[b + m] > 4.0 * bound


@inner
def _rising(work, b, m, bound):
    for i in range(1, m + 1):  # noqa: SIM110 - kernels know no generators
        if work[b + i] <= bound:
            return False
    return True


@inner
def _split(work, right, left, m):
    """De Casteljau at the middle: the left half to ``left``, the right half stays."""
    for i in range(m + 1):
        work[left + i] = work[right]
        for j in range(m - i):
            work[right + j] = 0.5 * (work[right + j] + work[right + j + 1])
        # entry m - i of the right half is now final


@inlined
def polish(work, at, place, lo, hi, guess, sign):
    """Where in [lo, hi] the polynomial of `TERMS` coefficients comes to ``place``, while sign times it falls:
    Halley's method kept inside a shrinking bracket. It ends where the next step, of third order, would be
    below rounding."""
    s = guess if lo < guess < hi else 0.5 * (lo + hi)
    for _ in range(MOST_HALLEY_STEPS):
        value, slope, half_bend = jet(work, at, s)
        done, s, lo, hi = halley(value - place, slope, half_bend, sign, lo, hi, s)
        if done:
            break
    return s


@inlined
def halley(value, slope, half_bend, sign, lo, hi, s):
    """One step of `polish` from s: whether it was the last, where it leads, and the bracket."""
    if value == 0.0:
        return True, s, lo, hi
    before = sign * value > 0.0  # chosen without a branch, which nobody could foresee
    lo, hi = (s if before else lo), (hi if before else s)
    divisor = slope * slope - value * half_bend
    change = -value * slope / divisor if divisor > 0.0 else 2.0
    step = min(max(s + change, lo), hi)
    if abs(change) <= 2.3e-16 * s or (abs(change) <= 1e-6 and abs(change * half_bend) <= 1e-6 * abs(slope)):
        return True, step, lo, hi
    if step in (lo, hi):
        step = 0.5 * (lo + hi)
        if step in (lo, hi):
            return True, step, lo, hi
    return False, step, lo, hi


@inner
def all_roots(c, at, degree, basis, table, stack, limits, out):
    """All simple roots in (0, 1] of a polynomial, ascending; returns their number (used for extrema).

    basis from place ``table``: Taylor to Bernstein; stack, limits: work space as in `_workspace`, flat."""
    linear(basis, table, TERMS, TERMS, degree + 1, c, at, stack, 0)
    limits[0], limits[1] = 0.0, 1.0
    count, top = 0, 1
    while top > 0 and count < len(out):
        top -= 1
        b, lo, hi = top * TERMS, limits[2 * top], limits[2 * top + 1]
        changes = _sign_changes(stack, b, degree)
        if changes == 0:
            if stack[b + degree] == 0.0 and stack[b] != 0.0:
                out[count] = hi  # exactly at the end of the interval
                count += 1
            continue
        if changes == 1 and stack[b] * stack[b + degree] < 0.0:
            sign = 1.0 if stack[b] > 0.0 else -1.0
            out[count] = polish(c, at, 0.0, lo, hi, 0.5 * (lo + hi), sign)
            count += 1
            continue
        if hi - lo < 2.0**-DEPTH or top + 2 > DEPTH:
            continue
        _split(stack, b, b + TERMS, degree)
        middle = 0.5 * (lo + hi)
        limits[2 * top + 2], limits[2 * top + 3] = lo, middle
        limits[2 * top], limits[2 * top + 1] = middle, hi
        top += 2
    return count


@inner
def _sign_changes(b, at, m):
    changes, last = 0, 0.0
    for i in range(at, at + m + 1):
        if b[i] != 0.0:
            if last * b[i] < 0.0:
                changes += 1
            last = 1.0 if b[i] > 0.0 else -1.0
    return changes


@inner
def ones(work):
    """Writes the weights of a plain sum of absolute values, and zeros behind `LOCAL`."""
    for j in range(TERMS):
        work[ONES + j] = 1.0
    for j in range(LANES):
        work[LOCAL + TERMS + j] = 0.0
