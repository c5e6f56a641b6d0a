"""A touch from the gap under the rule `no-tension`, where the stroboscopic map has a corner.

There the damping force sets in with its full size and the change of the motion is linear in the depth: on
both sides of the touch the map is smooth, with another derivative. The branch comes to the touch with one
direction and leaves it with another: onwards in the parameter, or back. Sources: M. di Bernardo, C. Budd, A.
Champneys, P. Kowalczyk, Piecewise-smooth Dynamical Systems (2008), sect. 3, doi:10.1007/978-1-84628-708-4
(border collisions); docs/theory for the law."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from gearlash.system import ContactRule, System

from .changes import Change, Test, halves
from .equations import UNBUILT, Array
from .extrema import Extremum
from .locate import PARAMETER_ROUNDING, Located
from .newton import tangent
from .node import Node, node_near
from .points import SpecialKind

MAY_CROSS = (
    1e-4  # of a mesh cycle's size of motion: an extremum so near its boundary may be what stops a branch
)
APPROACHES = 12  # to the touch, from one side
SHORT_OF = 1e-2  # of the way to it: each approach stops so much before
NO_DISTANCE = 1e-11  # distance that is called none
SAME_HALVES = 1e-8  # of the scale: halves of an orbit that are the same
AHEAD = (1e-4, 1e-5, 1e-6, 1e-3)  # lengths of the first step beyond
PASSES = "the map has a corner there: the branch goes on"
TURNS = "the map has a corner there: the branch turns back"
HALVES = "the map has a corner there: the branch ends in an orbit of half its period"
ENDS = "the map has a corner there, and no orbit of the same period was found beyond it"


@dataclass(frozen=True, eq=False)
class Corner:
    """The touch, and the first orbit of the branch beyond it, or None."""

    located: Located
    after: Node | None


def corner(before: Node | None, node: Node) -> Corner | None:
    """What stops a branch at ``node``, if it is a touch from the gap under `no-tension`."""
    if before is None:
        return None
    extremum = _nearest(node)
    if extremum is None:
        return None
    touch = _approached(before, node, extremum.number)
    if touch is None:
        return None
    after = _beyond(touch, extremum)
    note = ENDS
    if after is not None:
        note = PASSES if after.direction[-1] * node.direction[-1] > 0.0 else TURNS
        if after.equations.period % 2 == 0 and float(np.linalg.norm(halves(after))) <= SAME_HALVES:
            after, note = None, HALVES
    left = abs(touch.extrema.by_number[extremum.number].distance)
    touch = replace(touch, touching=touch.touching | {extremum.number})
    error = left * touch.equations.line.unit + PARAMETER_ROUNDING * abs(touch.value)
    change = Change(Test.GRAZING, extremum.number)
    return Corner(Located(change, 0.0, touch, error, SpecialKind.GRAZING, note), after)


def abrupt(system: System, extremum: Extremum) -> bool:
    """Whether the force sets in at once where an extremum touches: from the gap, under `no-tension`, with
    damping."""
    clearance = system.clearances[extremum.clearance]
    damping = clearance.dampings[0 if extremum.boundary > 0 else 1]
    return extremum.surface == "gap" and clearance.contact is ContactRule.NO_TENSION and damping != 0.0


def _nearest(node: Node) -> Extremum | None:
    """The extremum that is nearest to a boundary at which the force sets in at once."""
    system, size = node.here.props.system, float(np.abs(node.orbit.state).max())
    found = [extremum for extremum in node.extrema.all if abrupt(system, extremum)]
    near = min(found, key=lambda each: abs(each.distance), default=None)
    return near if near is not None and abs(near.distance) <= MAY_CROSS * max(size, 1.0) else None


def _approached(before: Node, node: Node, number: int) -> Node | None:
    """The touching orbit, come to from one side, each time almost as far as the last two orbits tell."""
    last = before
    for _ in range(APPROACHES):
        if number not in last.extrema.by_number or number not in node.extrema.by_number:
            return None
        there, here = (each.extrema.by_number[number].distance for each in (last, node))
        if abs(here) <= NO_DISTANCE:
            return node
        width = float(np.linalg.norm(node.u - last.u))
        if there == here or width == 0.0:
            return None
        ahead = -here * width / (here - there) * (1.0 - SHORT_OF)
        if ahead <= 0.0:
            return None
        target = float(node.direction @ node.u) + ahead
        guess = node.u + ahead * node.direction
        found = node_near(node.equations, guess, node.direction, target, node, node.slope)
        if found.node is None or found.node.orbit.label != node.orbit.label:
            return None
        last, node = node, found.node
    return node


def _beyond(touch: Node, extremum: Extremum) -> Node | None:
    """The first orbit on the other side of the corner. Its direction is that of the map there, which is read
    where the branch would have led to without it."""
    equations = touch.equations
    for length in AHEAD:
        try:
            inside = equations.evaluate(touch.u + length * touch.direction)
            if inside is None:
                continue
            row = tangent(equations, inside, equations.slope(inside), touch.direction)
        except UNBUILT:
            continue
        for sign in (1.0, -1.0):
            node = _on_the_other_side(touch, sign * row, length, extremum)
            if node is not None:
                return node
    return None


def _on_the_other_side(touch: Node, row: Array, length: float, extremum: Extremum) -> Node | None:
    target = float(row @ touch.u) + length
    found = node_near(touch.equations, touch.u + length * row, row, target, None)
    if found.node is None:
        return None
    node = found.node.linked(replace(touch, direction=row))
    one = touch.orbit.signature.one_impact_from(node.orbit.signature)
    near = float(np.linalg.norm(node.u - touch.u)) <= 10.0 * length
    return node if near and one == (extremum.clearance, extremum.boundary) else None
