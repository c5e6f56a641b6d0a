"""One step along a branch: from an orbit to the one at another value of the parameter, or why it is refused.

A step is taken only where the orbit found is the continuation of the one before as far as can be seen: it
lies where two orbits before it point to, closes after the same period, is stable, has the same contacts, and
no extremum has come to the other side of its boundary."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from gearlash.orbits import GrazingCheck, Orbit, orbit_at
from gearlash.system import Family

from .node import Array, Node, Pair
from .steps import UNBUILT, member

BEND = 0.15  # of a step's length: how far beside the curve through the orbits before it may end
SHORT = 1e-2  # of the orbit's ranges: longest step where there is no orbit before, so no curve
LONG = 0.2  # the same where there is one
NO_DIRECTION = 1e-7  # of the ranges: below it no direction is told
SHORTEST_AT_TOUCH = (
    1e-7  # of the scale: width of a step below which an extremum that only comes near has not crossed
)
BORN = 1e-5  # the same for extrema that are born or end near a boundary
GRID_STEP = 0.1  # of the motion's size: longest step on a coarse grid that needs no transient
NEWTON = 10  # iterations: from so near a few do

Earlier = tuple[Node, ...]
"""Orbits before one, the last first; two are enough."""


class Refusal(StrEnum):
    """Why a step was not taken."""

    UNBUILT = "there is no system that could be built"
    NEWTON = "Newton's method finds no orbit"
    FAR = "Newton's method finds an orbit somewhere else"
    PERIOD = "the orbit closes after a part of the period"
    UNSTABLE = "the orbit is not stable"
    LABEL = "the orbit has other contacts"
    CROSSED = "an extremum has crossed its boundary"
    TOUCHED = "an extremum may have touched its boundary"


@dataclass(frozen=True, eq=False)
class Step:
    """The orbit that a step led to and the bend on the way (of the step's length), or the refusal."""

    node: Node | None
    refusal: Refusal | None = None
    bend: float = 0.0
    reason: str = ""


@dataclass(frozen=True, eq=False)
class Line:
    """What a branch is followed along: parameter ``name`` of a family, other ``values``; ``scale``: the unit
    of the parameter for what is a short step."""

    family: Family
    values: Mapping[str, float]
    name: str
    scale: float

    def at(self, value: float) -> dict[str, float]:
        return {**self.values, self.name: value}

    def orbit(self, value: float, guess: Array, period: int, reuse: Orbit | None = None) -> Orbit | None:
        """The orbit of so many base periods at a value, by Newton's method, stable or not."""
        props = member(self.family, self.values, self.name, value, reuse.propagators if reuse else None)
        return orbit_at(props, guess, period, iterations=NEWTON, least=True)

    def step(self, before: Node, earlier: Earlier, value: float) -> Step:
        """From ``before`` to ``value``; ``earlier`` are the orbits before that one, the last first."""
        nodes = (before, *earlier)
        weights = _weights([node.value for node in nodes], value)
        guess = np.tensordot(weights, [node.state for node in nodes], 1)
        try:
            orbit = self.orbit(value, guess, before.orbit.shot.period, before.orbit)
        except UNBUILT as error:
            return Step(None, Refusal.UNBUILT, reason=str(error))
        if orbit is None:
            return Step(None, Refusal.NEWTON)
        return self.judged(before, earlier, Node(value, orbit))

    def judged(self, before: Node, earlier: Earlier, node: Node) -> Step:
        """The step from ``before`` to an orbit that was found."""
        if node.orbit.shot.period != before.orbit.shot.period:
            return Step(None, Refusal.PERIOD)
        nodes = (before, *earlier)
        weights = _weights([each.value for each in nodes], node.value)
        moved = before.between(node.course, before.course)
        if moved > (LONG if earlier else SHORT):
            return Step(None, Refusal.FAR)
        ahead = np.tensordot(weights, [each.course for each in nodes], 1)
        beside = before.between(node.course, ahead)
        if earlier and beside > BEND * moved + NO_DIRECTION:
            return Step(None, Refusal.FAR)
        refusal = self.compared(before, earlier, node)
        return Step(node, refusal, beside / (moved + NO_DIRECTION) if earlier else 0.0)

    def compared(self, before: Node, earlier: Earlier, after: Node) -> Refusal | None:
        """What speaks against ``after`` as the continuation, although it lies where it should."""
        if not after.orbit.stable:
            return Refusal.UNSTABLE
        if after.label != before.label:
            return Refusal.LABEL
        pair, width = Pair(before, after), abs(after.value - before.value)
        if pair.crossed:
            return Refusal.CROSSED
        if width > SHORTEST_AT_TOUCH * self.scale and _may_have_touched(pair, rates(earlier, before)):
            return Refusal.TOUCHED
        near = 3.0 * pair.moved
        if width > BORN * self.scale and any(abs(check.distance) <= near for check in pair.unmatched):
            return Refusal.TOUCHED
        return None


def is_near(before: Array, after: Array, size: float) -> bool:
    """Whether an orbit that Newton's method found from that of a neighbour on a coarse grid is taken for what
    the neighbour's motion comes to, without a transient that confirms it. ``before`` and ``after`` (n,) are
    their states, ``size`` that of the motion. Contacts may have changed between the two: a sweep asks for the
    attractor that is reached, not for one branch, which `Line.judged` tells."""
    return bool(np.abs(after - before).max() <= GRID_STEP * size)


def rates(earlier: Earlier, node: Node) -> dict[GrazingCheck, float]:
    """How fast the extrema of an orbit move from their boundaries, per unit of the parameter, from the orbit
    before it."""
    if not earlier:
        return {}
    width = node.value - earlier[0].value
    return {here: (here.distance - there.distance) / width for there, here in Pair(earlier[0], node).matched}


def _weights(values: list[float], at: float) -> Array:
    """Of what is known at up to three values, for the parabola (line, constant) through it, at another
    value."""
    return np.array(
        [
            math.prod((at - other) / (value - other) for j, other in enumerate(values) if j != i)
            for i, value in enumerate(values)
        ]
    )


def _may_have_touched(pair: Pair, rate: Mapping[GrazingCheck, float]) -> bool:
    """Whether an extremum that is on one side before and after may have been on the other in between: a
    parabola through its three distances leaves its chord by a quarter of what it misses the straight line
    by, at most."""
    width = pair.after.value - pair.before.value
    for before, after in pair.matched:
        if before in rate:
            bent = abs(after.distance - before.distance - rate[before] * width)
            if min(abs(before.distance), abs(after.distance)) < 0.5 * bent:
                return True
    return False
