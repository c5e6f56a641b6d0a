"""A special point between two orbits of a branch, solved for to the precision of the orbits themselves."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .between import Between, zero
from .changes import Change, Test
from .equations import Array
from .node import Node
from .points import Kind

ROUNDING = 1e-14  # of the parameter
SAME = 1e-6  # of the scale of the states: a return so near after half the period is one


@dataclass(frozen=True, eq=False)
class Located:
    """A zero of a test function: its place on the chord, the orbit there, error of the parameter, kind (None
    where the zero is no special point: two real reciprocal multipliers)."""

    change: Change
    place: float
    node: Node
    error: float
    kind: Kind | None


def locate(piece: Between, change: Change) -> Located | None:
    """None where an orbit between the two could not be had, or the extremum is not there on it."""

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
    return Located(change, place, node, _error(piece, change, node, high - low), kind)


def _error(piece: Between, change: Change, node: Node, bracket: float) -> float:
    """Of the parameter: what is left of the test function, or the bracket where that is narrower; at a fold
    the square of it."""
    unit = node.equations.line.unit
    slope = abs(change.value(piece.right) - change.value(piece.left)) / piece.length
    left = min(bracket, abs(change.value(node)) / max(slope, 1e-300)) + 1e-15
    turn = abs(float(node.direction[-1]))
    return unit * (left * max(turn, left)) + ROUNDING * abs(node.value)


def _kind(piece: Between, change: Change, node: Node) -> Kind | None:
    if change.test is Test.GRAZING:
        return Kind.GRAZING
    if change.test is Test.DOUBLING:
        return Kind.DOUBLING
    if change.test is Test.TORUS:
        pair = node.spectrum.nearest_pair
        return Kind.TORUS if abs(abs(pair) - 1.0) < 1e-4 else None
    if change.test is Test.AT_ONE:
        return Kind.BRANCH_POINT
    if half_period(node):
        return Kind.JOINS
    crosses = piece.left.spectrum.at_one * piece.right.spectrum.at_one < 0.0
    return Kind.FOLD if crosses else Kind.SYMMETRIC


def half_period(node: Node) -> bool:
    """Whether an orbit closes after half its period."""
    period = node.equations.period
    if period % 2:
        return False
    strobes: Array = node.orbit.strobes
    apart = np.abs(strobes[period // 2] - strobes[0]) / node.equations.size
    return bool(apart.max() <= SAME**0.5)
