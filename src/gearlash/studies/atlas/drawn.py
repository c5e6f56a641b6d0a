"""The curves drawn so far, and whether an orbit lies on one of them."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import Extremum
from gearlash.branches.curves import Curve, CurveEndKind, CurvePoint
from gearlash.system import Family

from .joined import joined
from .seeds import Seed, strobes_of

Array = NDArray[np.float64]
SAGITTA = 0.05  # of a step: how far beside its chord a curve may lie; it turns by 0.3 rad on one at the most
BENT = (
    0.5  # of the way of a point from the chord of its neighbours: the same where there is a cusp in the plane
)
ROUNDING = 1e-6  # of the rectangle, and of the states
SAME_STATE = 0.4  # of what the states move by on a step: how far beside the chord an orbit may lie
MOST_MOVED = 0.1  # of the states: as far as two neighbours of a curve may be told apart
LEAST = 1e-150  # length of a step, where both ends are one
MEETS = 1e-3  # of the rectangle: how near to a point a curve that begins beside it ends
SAME_PHASE = 0.05  # mesh cycles: how far two touches of one curve may lie from each other


@dataclass(frozen=True, eq=False)
class Line:
    """A curve in arrays: ``nodes`` (m,) in order of arclength, its points and those at which two things
    happen, ``places`` (m, 2) of both in units of the rectangle, ``states`` (m, n); ``joins`` (k, 2): where it
    ends on a curve of half the period."""

    curve: Curve
    nodes: tuple[CurvePoint, ...]
    places: Array
    states: Array
    joins: Array
    period: int

    @staticmethod
    def of(curve: Curve, lower: Array, width: Array) -> Line:
        period = curve.points[0].period  # a doubled orbit begins at a point of the simple one
        both = [*curve.points, *(each.point for each in curve.special if each.point.period == period)]
        nodes = sorted(both, key=lambda point: point.arclength)
        places, states = (np.array([getattr(node, name) for node in nodes]) for name in ("values", "state"))
        joins = [end.values for end in curve.ends if end.kind is CurveEndKind.HALF_PERIOD]
        ends = (np.array(joins).reshape(-1, 2) - lower) / width
        return Line(curve, tuple(nodes), (places - lower) / width, states, ends, period)

    def holds(self, place: Array, strobes: Array, touch: Extremum | None, cycles: int) -> bool:
        """Whether an orbit lies on it: in the plane near one of its steps, with states between those of its
        ends, begun at any base period, and with the same extremum in touch."""
        return any(self._same(i, part, strobes, touch, cycles) for i, part in self.beside(place))

    def beside(self, place: Array) -> list[tuple[int, float]]:
        """The steps near which a place lies, and at which part of each."""
        left, right = self.places[:-1], self.places[1:]
        if len(self.places) == 1:
            left = right = self.places
        chord = right - left
        length = np.maximum(np.linalg.norm(chord, axis=1), LEAST)
        part = np.clip(((place - left) * chord).sum(axis=1) / length**2, 0.0, 1.0)
        away = np.linalg.norm(left + part[:, None] * chord - place, axis=1)
        near = np.flatnonzero(away <= np.maximum(SAGITTA * length, self.bent) + ROUNDING)
        return [(int(i), float(part[i])) for i in near]

    def around(self, step: int) -> tuple[CurvePoint, ...]:
        """The points of the curve on both sides of a step, of which an end may be one where two things
        happen."""
        last = min(step + 1, len(self.nodes) - 1)
        left, right = self.nodes[step].arclength, self.nodes[last].arclength
        points = self.curve.points
        before = [point for point in points if point.arclength <= left][-1:]
        return (*before, *[point for point in points if point.arclength >= right][:1])

    @cached_property
    def bent(self) -> Array:
        """(m - 1,): how far beside their chords the steps may lie, by how far their ends lie beside those of
        their neighbours."""
        if len(self.places) < 3:
            return np.zeros(max(1, len(self.places) - 1))
        left, right = self.places[:-2], self.places[2:]
        chord, away = right - left, self.places[1:-1] - left
        along = (away * chord).sum(axis=1) / np.maximum((chord**2).sum(axis=1), LEAST)
        beside = np.linalg.norm(away - np.clip(along, 0.0, 1.0)[:, None] * chord, axis=1)
        beside = BENT * np.concatenate([[0.0], beside, [0.0]])
        found: Array = np.maximum(beside[:-1], beside[1:])
        return found

    def near_end(self, place: Array) -> bool:
        """Whether a place is beside an end on a curve of half the period: where that is, is told from orbits
        before it."""
        return bool((np.abs(self.joins - place).max(axis=1) <= MEETS).any())

    def _same(self, i: int, part: float, strobes: Array, touch: Extremum | None, cycles: int) -> bool:
        j = min(i + 1, len(self.states) - 1)
        size = max(float(np.abs(strobes).max()), 1e-3)
        moved = min(float(np.abs(self.states[j] - self.states[i]).max()), MOST_MOVED * size)
        here = self.states[i] + part * (self.states[j] - self.states[i])
        away = np.abs(strobes - here).max(axis=1)
        shift = int(np.argmin(away))
        if float(away[shift]) > SAME_STATE * moved + ROUNDING * size:
            return False
        return touch is None or any(
            _one_touch(mine, touch, shift * cycles, self.period)
            for point in self.around(i)
            for mine in point.touches
        )


def _one_touch(mine: Extremum, other: Extremum, shift: int, period: int) -> bool:
    """Whether two touches are one, where the orbit of the second is begun ``shift`` mesh cycles later."""
    if (mine.clearance, mine.surface, mine.boundary) != (other.clearance, other.surface, other.boundary):
        return False
    apart = abs(mine.phase - (other.phase - shift)) % period
    return min(apart, period - apart) <= SAME_PHASE


@dataclass(eq=False)
class Drawn:
    """``lines`` by their numbers; ``ways``: how each was found."""

    family: Family
    names: tuple[str, str]
    lower: Array
    width: Array
    cycles: int
    lines: list[Line] = field(default_factory=list)
    ways: list[str] = field(default_factory=list)

    def knows(self, seed: Seed) -> int:
        """The number of the curve on which a seed lies, or -1. What is doubled begins beside its seed."""
        if seed.doubled:
            return self._doubled(seed)
        if seed.elsewhere:
            return -1
        place = (np.array(seed.place(self.names)) - self.lower) / self.width
        for i, line in enumerate(self.lines):
            alike = line.curve.kind is seed.kind and line.period == seed.period
            if alike and line.holds(place, seed.strobes, seed.touch, self.cycles):
                return i
        return -1

    def _doubled(self, seed: Seed) -> int:
        """Whether a curve of grazings of twice the period ends at a point."""
        place = (np.array(seed.place(self.names)) - self.lower) / self.width
        for i, line in enumerate(self.lines):
            ends = (np.array(end.values) for end in line.curve.ends)
            meets = any(float(np.abs((end - self.lower) / self.width - place).max()) <= MEETS for end in ends)
            if line.curve.kind is seed.kind and line.period == seed.period and meets:
                return i
        return -1

    def add(self, curve: Curve, way: str) -> int:
        """Its number: a new one, or that of the curve that it lies on, or of one that lies on it, which it
        replaces, or of one with which it is joined, since they are one in part."""
        line = Line.of(curve, self.lower, self.width)
        for i, known in enumerate(self.lines):
            if known.curve.kind is not curve.kind or known.period != line.period:
                continue
            if self._lies_on(line, known):
                return i
            if self._lies_on(known, line):
                self.lines[i] = line
                return i
            both = self._joined(known, line)
            if both is not None:
                self.lines[i] = Line.of(both, self.lower, self.width)
                return i
        self.lines.append(line)
        self.ways.append(way)
        return len(self.lines) - 1

    def _lies_on(self, line: Line, other: Line) -> bool:
        """All of it in the plane, and its orbits at both ends and in the middle."""
        asked = [i for i, place in enumerate(line.places) if not other.near_end(place)]
        inside = asked or list(range(len(line.places)))
        if not all(other.beside(line.places[i]) for i in inside):
            return False
        return all(self._holds(other, line, inside[k]) for k in {0, len(inside) // 2, len(inside) - 1})

    def _joined(self, known: Line, line: Line) -> Curve | None:
        """Both as one, where each has an end on the other and one beyond it."""
        if not any(known.beside(place) for place in (line.places[0], line.places[-1])):
            return None
        on_known = [self._holds(known, line, i) for i in range(len(line.places))]
        on_line = [self._holds(line, known, i) for i in (0, len(known.places) - 1)]
        return joined(known.curve, line.curve, line.nodes, on_known, (on_line[0], on_line[1]))

    def _holds(self, other: Line, line: Line, i: int) -> bool:
        point = line.nodes[i]
        if not other.beside(line.places[i]):
            return False
        values = {**line.curve.values, **dict(zip(self.names, point.values, strict=True))}
        touch = point.touches[0] if point.touches else None
        return other.holds(line.places[i], strobes_of(self.family, values, point), touch, self.cycles)
