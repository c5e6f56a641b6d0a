"""Intervals in which a function of one number is positive, its ends solved for; unions and what all share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from math import inf, isfinite

from scipy.optimize import root_scalar

from gearlash.orbits.minimum import Sample, bracketed_minimum
from gearlash.results.tolerance import Band

HALVINGS = 60  # where a function has no number on one side
FLAT = 1e-9
"""Of a height: three that differ less are rounding of one and the same, and none of them is the least. Values
that a function does not depend on would be looked at more closely than any other."""
XTOL, RTOL = 1e-300, 1e-14  # of an end: as near as doubles come


def positive_bands(
    function: Callable[[float], float], values: Sequence[float], near: float = inf
) -> tuple[Band, ...]:
    """Where a function is positive between the first and the last of ascending values.

    Between two values its sign is taken to change once or not at all; where the function is least or largest
    of three values next to each other, and nearer to zero than ``near``, a closer look finds what lies
    between them.
    """
    samples = [(value, function(value)) for value in values]
    samples += [
        look
        for three in zip(samples, samples[1:], samples[2:], strict=False)
        if abs(three[1][1]) < near and (look := _between(function, *three)) is not None
    ]
    samples.sort()
    cuts: list[float] = [samples[0][0]] if samples[0][1] > 0.0 else []
    for left, right in pairwise(samples):
        if (left[1] > 0.0) != (right[1] > 0.0):
            cuts.append(_change(function, left, right))
    if samples[-1][1] > 0.0:
        cuts.append(samples[-1][0])
    return tuple(zip(cuts[::2], cuts[1::2], strict=True))


def _between(
    function: Callable[[float], float], left: Sample, middle: Sample, right: Sample
) -> Sample | None:
    """A value of the other sign beside the middle one of three, where that is least or largest."""
    heights = [left[1], middle[1], right[1]]
    if not all(map(isfinite, heights)) or len({height > 0.0 for height in heights}) > 1:
        return None
    if max(heights) - min(heights) <= FLAT * abs(middle[1]):
        return None
    sign = 1.0 if middle[1] > 0.0 else -1.0
    if not sign * middle[1] <= min(sign * left[1], sign * right[1]):
        return None

    def distance(at: float) -> float:
        found = sign * function(at)
        return found if isfinite(found) else inf

    at = _vertex(left, middle, right)
    found = distance(at)
    if found > 0.0:
        three = ((value, sign * height) for value, height in (left, middle, right))
        at, found = bracketed_minimum(distance, *three)
    return (at, sign * found) if found <= 0.0 and isfinite(found) else None


def _vertex(left: Sample, middle: Sample, right: Sample) -> float:
    """Of the parabola through three samples; the middle one where they lie on a line."""
    (a, fa), (b, fb), (c, fc) = left, middle, right
    left_part, right_part = (b - a) * (fb - fc), (b - c) * (fb - fa)
    above, below = (b - a) * left_part - (b - c) * right_part, left_part - right_part
    return b if below == 0.0 else min(max(b - 0.5 * above / below, a), c)


def _change(function: Callable[[float], float], left: Sample, right: Sample) -> float:
    """Where the sign changes between two values."""
    if isfinite(left[1]) and isfinite(right[1]) and left[1] != 0.0 != right[1]:
        ends = dict((left, right))  # solved for anew, a number near zero may have the other sign

        def number(at: float) -> float:
            found = ends[at] if at in ends else function(at)
            return found if isfinite(found) else -max(abs(left[1]), abs(right[1]))

        found = root_scalar(number, bracket=(left[0], right[0]), method="brentq", xtol=XTOL, rtol=RTOL)
        return float(found.root)
    low, high = left[0], right[0]
    positive_left = left[1] > 0.0
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if (function(middle) > 0.0) == positive_left else (low, middle)
    return low if positive_left else high


def shared(rows: Iterable[Sequence[Band]]) -> tuple[Band, ...]:
    """Where every row has a band."""
    found: list[Band] | None = None
    for row in rows:
        if found is None:
            found = list(row)
            continue
        pairs = [(max(a[0], b[0]), min(a[1], b[1])) for a in found for b in row]
        found = sorted(pair for pair in pairs if pair[0] < pair[1])
    return tuple(found or ())


def outside(rows: Iterable[Sequence[Band]], lower: float, upper: float) -> tuple[Band, ...]:
    """Where no row has a band, between two limits."""
    at, found = lower, []
    for low, high in sorted(band for row in rows for band in row):
        if low > at:
            found.append((at, low))
        at = max(at, high)
    if at < upper:
        found.append((at, upper))
    return tuple(found)


def contains(bands: Iterable[Band], value: float) -> bool:
    """Does a value lie in one of them?"""
    return any(low <= value <= high for low, high in bands)
