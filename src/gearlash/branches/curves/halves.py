"""Where a curve joins that of the orbits of half its period: the halves of its orbits become one.

On the way there the distance h of the halves is the amplitude of the doubling. An orbit and the same one
begun half of it later have h and -h, and one pair of parameters, so that on a curve of a condition the
parameters are functions of h²; where one extremum touches that is not so, and they are functions of h. So
the end is told from orbits before it: at the end itself the equations of two curves hold, and no step is
short enough. Source: Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory (2004), ch. 9.4,
doi:10.1007/978-1-4757-3978-7."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.interpolate import BarycentricInterpolator

from .motion import CurveOrbit
from .node import Node, state_at
from .plane import Array
from .points import CurveEndKind, EndOfCurve
from .problem import Evaluated

HALF = 3e-3  # scaled: halves so near to each other are nearly one
LEAST, CLEAR = 3e-4, 5.0  # the same beside a touch; of the way to the next touch, which bends the curve
USED, FALLS, FAR = (
    3,
    0.7,
    5.0,
)  # orbits from which the end is told; how much nearer than the one before each is
# at least, and the farthest than the last one at most
REACH = 2.0  # times the way between these orbits: how far ahead the end may be told to lie


def between_halves(here: Evaluated) -> Array | None:
    """From the middle of an orbit to its beginning (n,), scaled; None for an orbit of odd period."""
    if here.problem.period % 2:
        return None
    one, two = (state_at(here, k * 0.5 * here.cycles) for k in (0, 1))
    found: Array = (one - two) / here.problem.size
    return found


def halves(here: Evaluated) -> float:
    """How far the states at the beginning of both halves of an orbit are apart, scaled."""
    between = between_halves(here)
    return float("inf") if between is None else float(np.linalg.norm(between))


def nearly_one(here: Evaluated, motion: CurveOrbit) -> bool:
    """Whether the halves of an orbit are so near to each other that its curve ends."""
    away = halves(here)
    if here.problem.touches or not LEAST < away <= HALF:
        return away <= LEAST
    return away <= CLEAR * motion.nearest(here)


def change_places(node: Node, after: Node) -> bool:
    """Whether the halves of an orbit have become one within a step, and apart again: from there on the curve
    comes back, its orbits begun half of them later."""
    one, two = between_halves(node.here), between_halves(after.here)
    return one is not None and two is not None and float(one @ two) < 0.0


def joins_half(past: Sequence[Node], after: Node) -> EndOfCurve | None:
    """The end of a curve behind its last orbits, those of ``past`` in order, where their halves become
    one."""
    away, node = halves(after.here), past[-1]
    if not np.isfinite(away) or not nearly_one(after.here, after.motion):
        return None
    if away > halves(node.here) and not change_places(node, after):
        return None
    place = _at_zero(past, after) if away > 0.0 else after.place
    note = f"told from orbits whose halves differ by {away:.0e} of the motion and more"
    return EndOfCurve(CurveEndKind.HALF_PERIOD, (float(place[0]), float(place[1])), note)


def _at_zero(past: Sequence[Node], last: Node) -> Array:
    """The parameters where the distance of the halves is zero, by those of the last orbits of which each is
    clearly nearer to it than the one before."""
    plane, power = last.problem.plane, 1.0 if last.problem.touches else 2.0
    used, places = [halves(last.here)], [last.place]
    for node in reversed(past):
        away = halves(node.here)
        if away > FAR * used[0]:
            break
        if used[-1] < FALLS * away:
            used.append(away)
            places.append(node.place)
        if len(used) == USED:
            break
    if len(used) == 1:
        return last.place
    found: Array = BarycentricInterpolator(np.array(used) ** power, np.array(places))(0.0)
    step = float(np.linalg.norm((places[0] - places[-1]) / plane.unit))
    if float(np.linalg.norm((found - last.place) / plane.unit)) > REACH * step:
        return last.place
    return np.clip(found, plane.lower, plane.upper)
