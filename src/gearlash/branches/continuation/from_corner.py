"""Orbits of other periods that begin in a touch at which the map has a corner.

On both sides of the touch the map is nearly linear, z* + A y + a μ and z* + B y + b μ, y being the state's
and μ the parameter's distance from the touch. If A and B differ by an odd number of multipliers below -1, an
orbit of twice the period begins there that is in contact every other time: y1 = A y0 + a μ, y0 = B y1 + b μ.
Source: M. di Bernardo, M. I. Feigin, S. J. Hogan, M. E. Homer, Chaos, Solitons & Fractals 10 (1999) 1881,
doi:10.1016/S0960-0779(98)00317-8."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearlash.orbits import Orbit, orbit_at

from .branch import Branch
from .equations import UNBUILT, Array, Line
from .points import SpecialPoint

Side = tuple[Array, Array]
AWAY = (
    1e-5,
    1e-6,
    1e-4,
    1e-3,
)  # of the parameter's interval: from the touch, at which an orbit is solved for
NEAR = 30.0  # times the way that linear maps tell: as far as the orbit may lie from the touch


def doubled_at_corner(line: Line, branch: Branch, special: SpecialPoint) -> tuple[float, Orbit] | None:
    """The orbit of twice the period that begins at a touch, near by; and the parameter's value there."""
    sides = _sides(line, branch, special)
    if sides is None:
        return None
    (first, drift), (second, other) = sides
    period = 2 * special.point.period // line.system_at(special.value).system.cycles
    try:
        begins = np.asarray(
            np.linalg.solve(np.eye(len(drift)) - second @ first, second @ drift + other), dtype=np.float64
        )
    except np.linalg.LinAlgError:
        return None
    for away in AWAY:
        for move in (away * line.unit, -away * line.unit):
            orbit = _solved(
                line, special, special.value + move, np.asarray(move * begins, dtype=np.float64), period
            )
            if orbit is not None and orbit.shot.period == period:
                return special.value + move, orbit
    return None


def halved_at_corner(line: Line, special: SpecialPoint) -> Iterator[tuple[float, Orbit]]:
    """The orbits of half the period beside the touch in which one of this period ends."""
    period = special.point.period // line.system_at(special.value).system.cycles // 2
    for move in (AWAY[0] * line.unit, -AWAY[0] * line.unit):
        orbit = _solved(line, special, special.value + move, np.zeros_like(special.point.state), period)
        if orbit is not None:
            yield special.value + move, orbit


def _sides(line: Line, branch: Branch, special: SpecialPoint) -> tuple[Side, Side] | None:
    """A and a on both sides of the touch: of the branch's own orbits y = A y + a μ."""
    cycles = line.system_at(special.value).system.cycles
    before = [each for each in branch.points if each.arclength < special.arclength]
    after = [each for each in branch.points if each.arclength > special.arclength]
    if not before or not after:
        return None
    found = []
    for near in (before[-1], after[0]):
        orbit = orbit_at(line.system_at(near.value), near.state, near.period // cycles)
        if orbit is None or near.value == special.value:
            return None
        slope = (orbit.state - special.point.state) / (near.value - special.value)
        found.append((orbit.shot.monodromy, slope - orbit.shot.monodromy @ slope))
    return found[0], found[1]


def _solved(line: Line, special: SpecialPoint, value: float, away: Array, period: int) -> Orbit | None:
    if not line.lower <= value <= line.upper:
        return None
    try:
        orbit = orbit_at(line.system_at(value), special.point.state + away, period, least=True)
    except UNBUILT:
        return None
    if orbit is None:
        return None
    far = NEAR * float(np.linalg.norm(away)) + NEAR * abs(value - special.value) / line.unit
    return orbit if float(np.linalg.norm(orbit.state - special.point.state)) <= far else None
