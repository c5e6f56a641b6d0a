"""A touch from the gap under the rule `no-tension`, where the stroboscopic map has a corner.

There the damping force sets in with its full size and the change of the motion is linear in the depth: on
both sides of the touch the map is smooth, with another derivative. The branch comes to the touch with one
direction and leaves it with another: onwards in the parameter, or back. Sources: M. di Bernardo, C. Budd, A.
Champneys, P. Kowalczyk, Piecewise-smooth Dynamical Systems (2008), sect. 3, doi:10.1007/978-1-84628-708-4
(border collisions); docs/theory for the law."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import prod

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
APPROACHES = 24  # to the touch, from one side
SHORT_OF = (0.01, 0.1, 0.5)  # of the way to it: each approach stops so much before
ASIDE = (1e-6, 1e-5, 1e-4, 1e-7, 1e-3)  # of the parameter's interval: an orbit beside the one at the touch
NO_DISTANCE = 1e-11  # distance that is called none
SAME_HALVES = 1e-8  # of the scale: halves of an orbit that are the same
AHEAD = (1e-4, 1e-5, 1e-6, 1e-3)  # lengths of the first step beyond
PASSES = "the map has a corner there: the branch goes on"
TURNS = "the map has a corner there: the branch turns back"
HALVES = "the map has a corner there: the branch ends in an orbit of half its period"
ENDS = "the map has a corner there, and no orbit of the same period was found beyond it"


@dataclass(frozen=True, eq=False)
class Corner:
    """The touch, None where it lies behind already; and the first orbit of the branch beyond it, or None."""

    located: Located | None
    after: Node | None


def corner(before: Node | None, node: Node, passed: int | None = None) -> Corner | None:
    """What stops a branch at ``node``, if it is a touch from the gap under `no-tension`: of an extremum that
    is about to touch, or of the one that has just ``passed`` its boundary, beside which no direction can be
    had."""
    extremum = _nearest(node)
    beside = None if extremum is None else _beside(before, node, extremum)
    if extremum is None or beside is None:
        return None
    if extremum.number == passed:
        away = beside.u - node.u
        return Corner(None, beside if beside.direction @ away > 0.0 else beside.turned)
    touch = _approached(beside, node, extremum.number)
    if touch is None:
        return None
    after, note = None, HALVES
    if not at_half(touch):
        after = _beyond(touch, extremum)
        note = ENDS
        if after is not None:
            note = PASSES if after.direction[-1] * touch.direction[-1] > 0.0 else TURNS
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


def at_half(node: Node) -> bool:
    """Whether an orbit closes after half its period already."""
    return node.equations.period % 2 == 0 and float(np.linalg.norm(halves(node))) <= SAME_HALVES


def still_beside(node: Node, number: int) -> bool:
    """Whether an extremum is so near its boundary that it may be what stops the branch."""
    extremum = node.extrema.by_number.get(number)
    return extremum is not None and abs(extremum.distance) <= _near(node)


def _near(node: Node) -> float:
    return MAY_CROSS * max(float(np.abs(node.orbit.state).max()), 1.0)


def _nearest(node: Node) -> Extremum | None:
    """The extremum that is nearest to a boundary at which the force sets in at once."""
    found = [extremum for extremum in node.extrema.all if abrupt(node.here.props.system, extremum)]
    near = min(found, key=lambda each: abs(each.distance), default=None)
    return near if near is not None and abs(near.distance) <= _near(node) else None


def _at(node: Node, value: float, guess: Array, number: int) -> Node | None:
    """The orbit at a value of the parameter, with the contacts of ``node`` and the extremum on the same side:
    so near a corner the derivative along the parameter cannot be had, and none is needed."""
    line, row = node.equations.line, np.zeros_like(guess)
    if not line.lower <= value <= line.upper:
        return None
    row[-1], guess[-1] = 1.0, value / line.unit
    found = node_near(node.equations, guess, row, guess[-1], node, node.slope).node
    if found is None or found.orbit.label != node.orbit.label or number not in found.extrema.by_number:
        return None
    sides = (each.extrema.by_number[number].distance for each in (node, found))
    return found if prod(sides) > 0.0 else None


def _beside(before: Node | None, node: Node, extremum: Extremum) -> Node | None:
    """An orbit a little farther from the touch, sought where the last two orbits lead to."""
    unit, along, near = node.equations.line.unit, np.zeros_like(node.u), abs(extremum.distance)
    if before is not None and before.value != node.value and before.u.shape == node.u.shape:
        along = (before.u - node.u) / (before.value - node.value)
    for length in ASIDE:
        for move in (length * unit, -length * unit):
            found = _at(node, node.value + move, node.u + move * along, extremum.number)
            if found is not None and abs(found.extrema.by_number[extremum.number].distance) > near:
                return found
    return None


def _approached(last: Node, node: Node, number: int) -> Node | None:
    """The touching orbit, come to from one side, each time almost as far as the last two orbits tell; with
    the direction in which they lead to it."""
    for _ in range(APPROACHES):
        along, ahead = node.u - last.u, _ahead(last, node, number)
        if ahead is None:
            return None
        if abs(node.extrema.by_number[number].distance) <= NO_DISTANCE:
            return replace(node, direction=along / np.linalg.norm(along))
        parts = (ahead * (1.0 - left) for left in SHORT_OF)
        step = node.value - last.value
        found = (_at(node, node.value + t * step, node.u + t * along, number) for t in parts)
        last, node = node, next((each for each in found if each is not None), node)
        if node is last:
            return None
    return None


def _ahead(last: Node, node: Node, number: int) -> float | None:
    """How far the touch is, in units of the way between the two orbits."""
    if number not in last.extrema.by_number or number not in node.extrema.by_number:
        return None
    there, here = (each.extrema.by_number[number].distance for each in (last, node))
    return here / (there - here) if abs(here) < abs(there) else None


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
    near = float(np.linalg.norm(node.u - touch.u)) <= 10.0 * length
    other = node.extrema.by_number.get(extremum.number)
    return node if near and other is not None and other.distance * extremum.distance < 0.0 else None
