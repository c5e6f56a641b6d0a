"""Where a function of one parameter changes its sign first.

Steps, closer looks where the function is lowest, refinement: for what has one value at every parameter, as
the margin of a linear motion. Nothing is followed from one value to the next; `branches` does that."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from typing import NamedTuple

from .minimum import Sample, bracketed_minimum

TOLERANCE = 1e-15  # relative, of the place: as near as two numbers can be told apart
NEAREST = 1e-3  # of a bracket: no step comes nearer to its ends, so that both close in
MOST_LOOKS = 100  # into one bracket


class SignChange(NamedTuple):
    """A value on the positive side, next to the change; the function on the other side: -inf or NaN where it
    has no number there; the value there, so that the change lies between the two."""

    value: float
    beyond: float
    other: float


def first_sign_change(
    function: Callable[[float], float], start: Sample, factor: float, last: float
) -> tuple[SignChange | None, float]:
    """The first change of sign from ``start`` to ``last`` in steps by a factor, and the value farthest away
    that was looked at."""
    path = [start]
    farther = min if factor > 1.0 else max
    while path[-1][0] != last:
        there = farther(path[-1][0] * factor, last)
        path.append((there, function(there)))
        hidden = _between_steps(function, path[-3:])
        if hidden is not None:
            return hidden, there
        if (path[-1][1] > 0.0) != (start[1] > 0.0):
            return _refined(function, path[-2], path[-1]), there
    return None, last


def _between_steps(function: Callable[[float], float], path: list[Sample]) -> SignChange | None:
    """A loss of the sign beside the middle one of three values, where the function is lowest of the three and
    a closer look finds it no longer positive."""
    if len(path) < 3 or not path[2][1] > -inf:
        return None
    if not 0.0 < path[1][1] <= min(path[0][1], path[2][1]) < inf:
        return None
    lowest = bracketed_minimum(function, *path)
    return _refined(function, path[0], lowest) if lowest[1] <= 0.0 else None


def _refined(function: Callable[[float], float], here: Sample, there: Sample) -> SignChange:
    """Illinois method between two samples of different sign, halving where one is no number: M. Dowell and
    P. Jarratt, BIT 11 (1971) 168-174, doi:10.1007/BF01934364."""
    inside, outside = (here, there) if here[1] > 0.0 else (there, here)
    weights = [1.0, 1.0]  # of the values inside and outside, halved at an end that stays
    last = 0
    for _ in range(MOST_LOOKS):
        if abs(inside[0] - outside[0]) <= TOLERANCE * abs(inside[0]):
            break
        one, two = weights[0] * inside[1], weights[1] * outside[1]
        share = min(max(one / (one - two), NEAREST), 1.0 - NEAREST) if outside[1] > -inf else 0.5
        at = inside[0] + share * (outside[0] - inside[0])
        if at in (inside[0], outside[0]):
            break
        found = function(at)
        if found > 0.0:
            inside, weights = (at, found), [1.0, 0.5 * weights[1] if last > 0 else 1.0]
            last = 1
        else:
            outside, weights = (at, found), [0.5 * weights[0] if last < 0 else 1.0, 1.0]
            last = -1
    return SignChange(inside[0], outside[1], outside[0])
