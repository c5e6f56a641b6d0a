"""The minimum of a function between two values, without derivatives: does a distance vanish there?"""

from __future__ import annotations

from collections.abc import Callable

EVALUATIONS = 12  # at one minimum, at the most
ALWAYS = 3  # of them, whatever they find
LITTLE = 0.1  # of what is left: an evaluation that gains less is the last
GOLDEN = 0.382
TOO_NEAR = 0.1  # of the wider side: a value nearer to the middle says nothing new

Sample = tuple[float, float]  # value of the parameter, distance there


def bracketed_minimum(
    distance: Callable[[float], float], left: Sample, middle: Sample, right: Sample
) -> Sample:
    """The least distance found between ``left`` and ``right`` (ascending or descending values), where
    ``middle`` is the lowest so far.

    By parabolas, kept apart by golden sections (R. P. Brent, Algorithms for Minimization without Derivatives,
    1973, ch. 5). It ends once the distance is no longer positive, or an evaluation gains little.
    """
    for look in range(EVALUATIONS):
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
        if inside and abs(step) >= TOO_NEAR * abs(wide):
            return middle[0] + step
    return middle[0] + GOLDEN * wide
