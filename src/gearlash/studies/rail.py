"""The stable motion that passes through the points of a sweep, followed from one to the next.

It is followed once, as `walk` does, however many points lie along it; whether a point lies on it is seen from
the orbits on both sides of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import EndOfBranch, Item, Node, SpecialPoint
from gearlash.system import Label, Signature

ON_WAY = 1e-3  # of the way between two orbits: a point so near to the curve through them is on the branch
ROUNDING = 1e-9  # of the states
STEEP = 1e-6  # a direction with less of the parameter than this has no slope along it

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Station:
    """An orbit of the way: states (P, n) at phase zero, their derivative along the parameter where it is
    known, the special point that it is, and the label of the motion behind it."""

    value: float
    strobes: Array
    slope: Array | None
    label: Signature
    special: SpecialPoint | None = None

    @staticmethod
    def of(item: Node | SpecialPoint) -> Station:
        if isinstance(item, Node):
            return Station(item.value, item.orbit.strobes, _slope(item), item.label)
        return Station(item.value, item.point.strobes, None, item.label_after, item)


@dataclass(frozen=True)
class Passed:
    """A special point on the way, with the labels before and behind it."""

    point: SpecialPoint
    before: Label
    after: Label


@dataclass(eq=False)
class Rail:
    """A walk, in the direction of ``sign``, that is read as far as it is asked for."""

    items: Iterator[Item]
    sign: float
    left: Station | None = None
    right: Station | None = None
    passed: list[Passed] = field(default_factory=list)

    def reaches(self, value: float) -> bool:
        """Whether the motion is followed to a value; then ``left`` and ``right`` lie on both sides of it."""
        while self.right is None or self.sign * (value - self.right.value) > 0.0:
            item = next(self.items, None)
            if item is None or isinstance(item, EndOfBranch):
                return False
            self.read(item)
        return True

    def is_beyond(self, value: float) -> bool:
        """Whether it was read beyond a value already."""
        return self.right is not None and self.sign * (self.right.value - value) >= 0.0

    def read(self, item: Node | SpecialPoint) -> None:
        here, station = self.right, Station.of(item)
        if here is not None and here.special is not None:
            label = item.label if isinstance(item, Node) else item.label_before
            self.passed.append(Passed(here.special, here.special.label_before, label))
            here = replace(here, label=label)
        self.left, self.right = here, station

    def take(self) -> list[Passed]:
        """What was passed since it was asked last."""
        found, self.passed = self.passed, []
        return found

    def meets(self, value: float, state: Array) -> bool:
        """Whether a state at phase zero, at a value that the way reaches, is plainly one of its orbit there,
        at whichever base period that begins."""
        left, right = self.left, self.right
        assert right is not None
        if left is None or right.value == value:
            return right.special is None and _nearest(right.strobes, state) <= ROUNDING * _size(right.strobes)
        if left.strobes.shape != right.strobes.shape:
            return False
        chord = float(np.abs(right.strobes - left.strobes).max())
        between = _between(left, right, value)
        return _nearest(between, state) <= ON_WAY * chord + ROUNDING * _size(between)


def _nearest(strobes: Array, state: Array) -> float:
    return float(np.abs(strobes - state).max(axis=1).min())


def _size(strobes: Array) -> float:
    return max(1.0, float(np.abs(strobes).max()))


def _slope(node: Node) -> Array | None:
    equations, along = node.equations, float(node.direction[-1])
    if equations.phase != 0.0 or equations.segments != equations.period or abs(along) < STEEP:
        return None
    return equations.states(node.direction) / (along * equations.line.unit)


def _between(left: Station, right: Station, value: float) -> Array:
    """By the cubic, or what is left of it where a derivative is not known."""
    width = right.value - left.value
    t = (value - left.value) / width
    chord = right.strobes - left.strobes
    straight: Array = left.strobes + t * chord
    at_left = None if left.slope is None else width * left.slope - chord
    at_right = None if right.slope is None else chord - width * right.slope
    first, last = (at_right if at_left is None else at_left), (at_left if at_right is None else at_right)
    if first is None or last is None:
        return straight
    bent: Array = t * (1.0 - t) * ((1.0 - t) * first + t * last)
    return straight + bent
