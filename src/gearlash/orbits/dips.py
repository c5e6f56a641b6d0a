"""Closer looks at a distance that is known at some values, where it is least: does it vanish there?"""

from __future__ import annotations

from collections.abc import Callable

LOOKS = 12  # at one dip
ALWAYS = 3  # of them, whatever they find
LITTLE = 0.1  # of what is left: a look that gains less is the last
GOLDEN = 0.382
NEAR = 0.1  # of the wider side: a look nearer to the middle says nothing new

Sample = tuple[float, float]  # value of the parameter, distance there


def dip(distance: Callable[[float], float], left: Sample, middle: Sample, right: Sample) -> Sample:
    """The least distance that is found between ``left`` and ``right`` (ascending or descending values), of
    which ``middle`` is the lowest so far: by parabolas, kept apart by golden sections (R. P. Brent,
    Algorithms for Minimization without Derivatives, 1973, ch. 5), and only until it is no longer positive, or
    is seen to stay so."""
    for look in range(LOOKS):
        at = _next(left, middle, right)
        found = at, distance(at)
        before = middle[1]
        inner = (at - middle[0]) * (right[0] - middle[0]) > 0.0
        if found[1] < before:
            left, middle, right = (middle, found, right) if inner else (left, found, middle)
        elif inner:
            right = found
        else:
            left = found
        if middle[1] <= 0.0 or (look >= ALWAYS - 1 and middle[1] > (1.0 - LITTLE) * before):
            break
    return middle


def _next(left: Sample, middle: Sample, right: Sample) -> float:
    """Where to look: the vertex of the parabola, unless that is where was looked already."""
    below, above = middle[0] - left[0], right[0] - middle[0]
    wide = above if abs(above) > abs(below) else -below
    fall, rise = (middle[1] - left[1]) / below, (right[1] - middle[1]) / above
    if rise != fall:
        step = -0.5 * (fall * above + rise * below) / (rise - fall)
        inside = step * above < above * above if step * above > 0.0 else step * below > -below * below
        if inside and abs(step) >= NEAR * abs(wide):
            return middle[0] + step
    return middle[0] + GOLDEN * wide
