"""Orbits between two neighbours of a branch, told by how far along the way they lie."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from math import acos

import numpy as np

from .equations import Array
from .node import Node, node_near

MOST_BISECTIONS = 60
SHARP = 1e-13  # of the way: where a zero is bracketed so closely, it is found
JUMP = 1e-10  # of the way: where a bracket so small has large values at both ends, the function jumps
AGREE = 0.1  # least progress of a place along the direction of the branch
CLOSE_ENOUGH = 1e-2  # of the way: a bracket that is kept where the orbits in it cannot be had
BOW = 0.1  # of the chord: how far beside it an orbit of a straight piece may lie
PART_OF_ANGLE = (
    0.5  # how much farther for each rad of turning: a circle's bow is an eighth, a corner's a quarter
)
WELL = 0.1  # least component of the direction for the parameter to tell a place


@dataclass(frozen=True, eq=False)
class Between:
    """The piece of a branch between two orbits; places on it go from 0 to its length."""

    left: Node
    right: Node
    _known: dict[float, Node] = field(default_factory=dict)

    @cached_property
    def length(self) -> float:
        return float(np.linalg.norm(self.right.u - self.left.u))

    @cached_property
    def row(self) -> Array:
        """What tells a place: row·(u - left) from 0 to `length`. The parameter, where that runs along well: a
        system is then built once for each orbit; else the chord, which goes round a fold, too."""
        turns = self.left.direction[-1], self.right.direction[-1]
        if turns[0] * turns[1] > 0.0 and min(map(abs, turns)) > WELL:
            row = np.zeros_like(self.left.u)
            row[-1] = self.length / (self.right.u[-1] - self.left.u[-1])
            return row
        return (self.right.u - self.left.u) / self.length

    def node(self, place: float) -> Node | None:
        """The orbit at a place, linked to the left end."""
        if place in self._known:
            return self._known[place]
        left, right = self._neighbours(place)
        part = self._part(left, right, place)
        between = self._guess(left, right, place), (1.0 - part) * left.slope + part * right.slope
        # Where a contact is born on the way the curve is bent sharply there: it is straight up to there.
        straight = ((self._along(node, place), node.slope) for node in (left, right))
        # Beside a point where two branches meet directions are not known, and only the chord is left.
        chord = (1.0 - part) * left.u + part * right.u, between[1]
        target = float(self.row @ self.left.u) + place
        for guess, slope in (between, *straight, chord):
            found = node_near(left.equations, guess, self.row, target, left, slope, exact=False)
            # A longer orbit has itself, begun at another base period, for a neighbour too.
            if found.node is None or float(np.linalg.norm(found.node.u - guess)) > self.length:
                continue
            if self.bow(found.node) <= BOW + PART_OF_ANGLE * self.turned:
                self._known[place] = found.node.linked(self.left)
                return self._known[place]
        return None

    def bow(self, node: Node) -> float:
        """How far beside the chord an orbit lies, in lengths of it. Of an orbit of this branch that is a part
        of the angle by which the branch turns from end to end; one of another branch that crosses this one
        may lie as far aside as the chord is long."""
        chord = (self.right.u - self.left.u) / self.length
        way = node.u - self.left.u
        return float(np.linalg.norm(way - (way @ chord) * chord)) / self.length

    @cached_property
    def turned(self) -> float:
        """The angle between the directions at both ends, rad."""
        return acos(min(1.0, max(-1.0, float(self.left.direction @ self.right.direction))))

    def place(self, node: Node) -> float:
        return float(self.row @ (node.u - self.left.u))

    def _neighbours(self, place: float) -> tuple[Node, Node]:
        """The nearest known orbits on both sides."""
        known = {0.0: self.left, self.length: self.right, **self._known}
        return known[max(p for p in known if p <= place)], known[min(p for p in known if p >= place)]

    def _part(self, left: Node, right: Node, place: float) -> float:
        start, stop = self.place(left), self.place(right)
        return (place - start) / (stop - start) if stop > start else 0.0

    def _along(self, node: Node, place: float) -> Array:
        """By the direction of one orbit alone."""
        ahead = (place - self.place(node)) / max(float(self.row @ node.direction), AGREE)
        return node.u + ahead * node.direction

    def _guess(self, left: Node, right: Node, place: float) -> Array:
        """By the cubic with the values and directions at both ends."""
        width, t = self.place(right) - self.place(left), self._part(left, right, place)
        one, two = (n.direction / max(float(self.row @ n.direction), AGREE) * width for n in (left, right))
        h00, h10 = (1 + 2 * t) * (1 - t) ** 2, t * (1 - t) ** 2
        h01, h11 = t * t * (3 - 2 * t), t * t * (t - 1)
        return h00 * left.u + h10 * one + h01 * right.u + h11 * two


def zero(
    function: Callable[[float], float | None], left: tuple[float, float], right: tuple[float, float]
) -> tuple[float, float, float] | None:
    """A zero between two places with values of opposite sign, with the last bracket.

    By false position that halves the value of an end that stays (N. Anderson and Å. Björck, BIT 13 (1973),
    doi:10.1007/BF01933401), and halvings where it is slow. Where the function jumps over zero that is the
    jump. None where the function cannot be had, but for a last piece."""
    (a, fa), (b, fb) = left, right
    sharp, small = SHARP * abs(b - a), SHARP * max(abs(fa), abs(fb))
    best = (a, fa) if abs(fa) < abs(fb) else (b, fb)
    wide = abs(b - a)
    for look in range(MOST_BISECTIONS):
        if abs(b - a) <= sharp or fa == fb:
            break
        at = b - fb * (b - a) / (fb - fa)
        inside = min(a, b) < at < max(a, b)
        if not inside or (look % 4 == 3 and abs(b - a) > 0.25 * wide):
            at = 0.5 * (a + b)
        if look % 4 == 3:
            wide = abs(b - a)
        if at in (a, b):
            break
        value = function(at)
        if value is None:
            if abs(b - a) > CLOSE_ENOUGH * abs(right[0] - left[0]):
                return None
            break
        if abs(value) < abs(best[1]):
            best = (at, value)
        if abs(value) <= small:
            break
        if (value > 0.0) == (fb > 0.0):
            ratio = 1.0 - value / fb
            fa *= ratio if ratio > 0.0 else 0.5
        else:
            a, fa = b, fb
        b, fb = at, value
    low, high = min(a, b), max(a, b)
    jumps = high - low <= JUMP * abs(right[0] - left[0]) and not low <= best[0] <= high
    return (b if jumps else best[0]), low, high
