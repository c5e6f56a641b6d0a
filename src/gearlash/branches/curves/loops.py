"""Where a curve comes back to an orbit that is on it already."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from .locate import Met
from .node import Node, solved, state_at
from .plane import Array

LOOP_CLOSES = 0.5  # of a step: how near the first parameters are passed where a loop may close
SAME = 1e-6  # scaled: orbits so near to each other are one


def passes(target: Node, left: Array, right: Array, nodes: Sequence[Node]) -> bool:
    """Whether a curve comes by an orbit between two places, solved for from the nearest of some nodes there.
    A step from that orbit on does not."""
    near = _nearest(nodes, target)
    unit = near.problem.plane.unit
    chord, away = (right - left) / unit, (target.place - left) / unit
    length = float(np.linalg.norm(chord))
    if length == 0.0 or np.linalg.norm(away) <= SAME:
        return False
    if float(chord @ target.direction[-2:]) <= 0.0:  # an arm of a cusp comes back
        return False
    chord /= length
    along = float(chord @ away)
    if not 0.0 < along <= length + SAME or np.linalg.norm(away - along * chord) > LOOP_CLOSES * length:
        return False
    row, left = np.zeros(len(near.u)), left / unit
    row[-2:] = chord
    aim = float(chord @ left) + along
    ahead = near.direction / float(row @ near.direction)
    guess = near.u + (aim - float(row @ near.u)) * ahead
    node = solved(near.problem, guess, row, aim, near)[0]
    return node is not None and is_one(node, target)


def is_one(node: Node, other: Node) -> bool:
    """Whether two orbits are one, begun at any of its base periods."""
    size, cycles = node.problem.size, float(node.here.props.system.cycles)
    if float(np.linalg.norm((node.place - other.place) / node.problem.plane.unit)) > SAME:
        return False
    state = state_at(node.here, 0.0)
    return any(
        float(np.linalg.norm((state_at(other.here, k * cycles) - state) / size)) <= SAME
        for k in range(other.problem.period)
    )


def not_again(met: tuple[Met, ...], left: Node, right: Node, target: Node) -> Iterator[Met]:
    """Of what is met on the step that closes a loop, what lies before the orbit at which it closes."""
    unit = left.problem.plane.unit
    chord = (right.place - left.place) / unit
    end = float(chord @ ((target.place - left.place) / unit))
    yield from (each for each in met if float(chord @ ((each.place - left.place) / unit)) <= end)


def _nearest(nodes: Sequence[Node], target: Node) -> Node:
    unit = target.problem.plane.unit
    return min(nodes, key=lambda node: float(np.linalg.norm((node.place - target.place) / unit)))
