"""A special point between two orbits of a branch, solved for to the precision of the orbits themselves."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from gearlash.orbits import Orbit, orbit_at

from .between import Between, zero
from .changes import TURN_ROUNDING, Change, Test, halves
from .equations import UNBUILT, Array
from .extrema import Extrema
from .node import Node
from .points import SpecialKind

BESIDE_BRANCH_POINT = 3e-3  # of the way: distance from a branch point at which test functions are read
PARAMETER_ROUNDING = 1e-14  # of the parameter
MEETING = 1e-8  # of the interval: where two branches meet, an orbit is known so well
SOLVED = 1e-11  # of the way: a test function that says so much is left is believed
SECANTS = 30
LAST_STEP = 1e-13  # of the parameter: a step of the secant method that is the last


@dataclass(frozen=True, eq=False)
class Located:
    """A zero of a test function: its place on the way, the orbit there, error of the parameter, kind (None
    where the zero is no special point: two real reciprocal multipliers), what else is to be said, and the
    value of the parameter where the orbit does not tell it as well."""

    change: Change
    place: float
    node: Node
    error: float
    kind: SpecialKind | None
    note: str = ""
    value: float | None = None


def locate(piece: Between, change: Change) -> Located | None:
    """None where an orbit between the two could not be had, or the extremum is not there on it."""

    if change.test is Test.JOIN:
        return joined(piece, change)

    def function(place: float) -> float | None:
        node = piece.node(place)
        return change.value(node) if node is not None and change.can_be_had(node) else None

    left, right = change.value(piece.left), change.value(piece.right)
    found = zero(function, (0.0, left), (piece.length, right))
    if found is None:
        return None
    place, low, high = found
    node = piece.left if place == 0.0 else piece.right if place == piece.length else piece.node(place)
    assert node is not None
    if change.test is Test.GRAZING:
        node = replace(node, touching=node.touching | {change.number})
    kind = _kind(piece, change, node)
    if kind is SpecialKind.BRANCH_POINT:
        return _at_branch_point(piece, change, node, place)
    error = _error(piece, change, node, high - low)
    if kind is SpecialKind.SYMMETRIC:  # two branches meet there, too
        error = max(error, MEETING * node.equations.line.unit)
    return Located(change, place, node, error, kind)


def _at_branch_point(piece: Between, change: Change, node: Node, near: float) -> Located | None:
    """Two branches meet there, and near by orbits are known to few digits only. So the test function is read
    at some distance on both sides, and its zero is that of the parabola, or cubic, through these values."""
    for offsets in ((-2.0, -1.0, 1.0, 2.0), (-4.0, -3.0, -2.0, -1.0), (1.0, 2.0, 3.0, 4.0)):
        step = BESIDE_BRANCH_POINT * piece.length
        places = near + step * np.array(offsets)
        if places.min() > 0.0 and places.max() < piece.length:
            fresh = Between(piece.left, piece.right)  # no orbit that rounding has moved is near
            found = [each for each in map(fresh.node, places.tolist()) if each is not None]
            if len(found) == len(places):
                return _by_parabola(piece, change, node, near, places, found)
    unit = node.equations.line.unit
    return Located(change, near, node, BESIDE_BRANCH_POINT * piece.length * unit, SpecialKind.BRANCH_POINT)


def _by_parabola(
    piece: Between, change: Change, node: Node, near: float, places: Array, found: list[Node]
) -> Located:
    step = BESIDE_BRANCH_POINT * piece.length
    tests, values = (np.array(each) for each in ([change.value(n) for n in found], [n.value for n in found]))
    roots = []
    for chosen in (slice(1, 4), slice(0, 4)):
        scaled = (places[chosen] - near) / step
        zeros = np.roots(np.polyfit(scaled, tests[chosen], len(scaled) - 1))
        roots.append(float(zeros[np.argmin(np.abs(zeros))].real))
    scaled = (places - near) / step
    value = float(np.polyval(np.polyfit(scaled, values, 3), roots[1]))
    width = abs(values[3] - values[0]) / 4.0
    error = abs(roots[1] - roots[0]) * width * BESIDE_BRANCH_POINT + PARAMETER_ROUNDING * abs(value)
    nearest = min(found, key=lambda each: abs(each.value - value))
    return Located(change, near + roots[1] * step, nearest, error, SpecialKind.BRANCH_POINT, value=value)


def _error(piece: Between, change: Change, node: Node, bracket: float) -> float:
    """Of the parameter: what is left of the test function, or the bracket where that is narrower; at a fold
    the square of it."""
    unit = node.equations.line.unit
    slope = abs(change.value(piece.right) - change.value(piece.left)) / piece.length
    left = abs(change.value(node)) / max(slope, 1e-300)
    left = (left if left <= SOLVED * piece.length else bracket) + 1e-15
    turn = abs(float(node.direction[-1]))
    return unit * (left * max(turn, left)) + PARAMETER_ROUNDING * abs(node.value)


def _kind(piece: Between, change: Change, node: Node) -> SpecialKind | None:
    if change.test is Test.GRAZING:
        return SpecialKind.GRAZING
    if change.test is Test.DOUBLING:
        return SpecialKind.DOUBLING
    if change.test is Test.TORUS:
        pair = node.spectrum.nearest_pair
        return SpecialKind.TORUS if abs(abs(pair) - 1.0) < 1e-4 else None
    if change.test is Test.KREIN:
        reciprocal = node.spectrum.reciprocal
        return SpecialKind.KREIN if reciprocal is not None and reciprocal.meets_on_circle else None
    if change.test is Test.AT_ONE:
        turns = min(abs(side.spectrum.turn) for side in (piece.left, piece.right))
        return SpecialKind.FOLD if turns <= TURN_ROUNDING else SpecialKind.BRANCH_POINT
    crosses = piece.left.spectrum.at_one * piece.right.spectrum.at_one < 0.0
    return SpecialKind.FOLD if crosses else SpecialKind.SYMMETRIC


def joined(piece: Between, change: Change) -> Located | None:
    """Where the orbit joins one of half its period: two branches meet there, and Newton's method fails near.
    So the other one is taken, which is regular there, and its doubling solved for."""
    left, right = piece.left, piece.right
    one, two = float(np.linalg.norm(halves(left))), float(np.linalg.norm(halves(right)))
    nearer, place = (left if one < two else right), piece.length * one / (one + two)
    line, half = left.equations.line, left.equations.period // 2
    strobes = nearer.orbit.strobes
    guess = 0.5 * (strobes[0] + strobes[half])

    def single(value: float) -> Orbit | None:
        return orbit_at(line.system_at(value), guess, half)

    try:
        found = _doubling_of(single, nearer.value, LAST_STEP**0.5 * line.unit)
        if found is None:
            return None
        value, error, orbit = found
        node = _as_doubled(piece, orbit, value)
    except UNBUILT:
        return None
    near = abs(value - nearer.value) <= piece.length * line.unit
    return Located(change, place, node, error, SpecialKind.JOINS) if node is not None and near else None


def _doubling_of(
    single: Callable[[float], Orbit | None], value: float, width: float
) -> tuple[float, float, Orbit] | None:
    """The value at which a multiplier of the single orbit is -1, by secants; its error, and the orbit."""
    before = single(value)
    if before is None:
        return None
    last, function = value, _at_minus_one(before)
    value += width
    for _ in range(SECANTS):
        orbit = single(value)
        if orbit is None:
            return None
        here = _at_minus_one(orbit)
        step = -here * (value - last) / (here - function) if here != function else 0.0
        if abs(step) <= LAST_STEP * max(abs(value), width):
            return value, abs(step) + PARAMETER_ROUNDING * abs(value), orbit
        last, function, value = value, here, value + step
    return None


def _at_minus_one(orbit: Orbit) -> float:
    return float(np.prod(1.0 + np.linalg.eigvals(orbit.shot.monodromy)).real)


def _as_doubled(piece: Between, orbit: Orbit, value: float) -> Node | None:
    """The single orbit, run through twice, as a point of the doubled branch."""
    equations = piece.left.equations
    twice = orbit_at(orbit.propagators, orbit.state, equations.period, iterations=1)
    if twice is None:
        return None
    here = equations.evaluate(equations.unknowns(twice, value), orbit.propagators)
    if here is None:
        return None
    chord = (piece.right.u - piece.left.u) / piece.length
    chord[-1] = 0.0
    node = Node(equations, here, piece.left.slope, chord, twice, Extrema.of(twice))
    return node.linked(piece.left)
