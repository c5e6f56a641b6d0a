"""Whether a branch has come back to its first orbit."""

from __future__ import annotations

import numpy as np

from gearlash.orbits import orbit_at

from .between import Between
from .equations import Array
from .node import Node

BESIDE = 0.3  # of a step: how far the first orbit may lie from the straight way between two neighbours
SAME = 1e-6  # of the scale: orbits so near to each other are one


def closing(start: Node, left: Node, right: Node) -> Node | None:
    """The first orbit, begun at any of its base periods, if the branch passes it between two neighbours."""
    shift = _passed(start, left, right)
    if shift is None:
        return None
    equations, orbit = left.equations, start.orbit
    again = orbit_at(start.here.props, orbit.strobes[shift], equations.period, iterations=1)
    if again is None:
        return None
    u, piece = equations.unknowns(again, start.value), Between(left, right)
    place = float(piece.row @ (u - left.u))
    node = piece.node(place) if 0.0 < place < piece.length else None
    return node if node is not None and float(np.linalg.norm(node.u - u)) <= SAME else None


def _passed(start: Node, left: Node, right: Node) -> int | None:
    """At which of its base periods the first orbit is begun where it lies near the way between two orbits."""
    scale, strobes = start.equations.size, start.orbit.strobes
    first, last = (_place(each.orbit.strobes, each, scale) for each in (left, right))
    chord, length = last - first, float(np.linalg.norm(last - first))
    for shift in range(len(strobes)):
        away = _place(np.roll(strobes, -shift, axis=0), start, scale) - first
        along = float(chord @ away) / length
        beside = float(np.linalg.norm(away - along * chord / length))
        if 0.0 < along <= length and beside <= BESIDE * length:
            return shift
    return None


def _place(strobes: Array, node: Node, scale: Array) -> Array:
    """States at phase zero and the parameter, scaled."""
    return np.append((strobes / scale).ravel(), node.u[-1])
