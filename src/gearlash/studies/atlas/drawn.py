"""The curves drawn so far, and whether an orbit lies on one of them."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import Extremum
from gearlash.branches.curves import Curve
from gearlash.system import Family

from .seeds import Seed, strobes_of

Array = NDArray[np.float64]
SAGITTA = 0.05  # of a step: how far beside its chord a curve may lie; it turns by 0.3 rad on one at the most
ROUNDING = 1e-6  # of the rectangle, and of the states
SAME_STATE = 0.4  # of what the states move by on a step: how far beside the chord an orbit may lie
MOST_MOVED = 0.1  # of the states: as far as two neighbours of a curve may be told apart
LEAST = 1e-150  # length of a step, where both ends are one
MEETS = 1e-3  # of the rectangle: how near to a point a curve that begins beside it ends
SAME_PHASE = 0.05  # mesh cycles: how far two touches of one curve may lie from each other


@dataclass(frozen=True, eq=False)
class Line:
    """A curve in arrays: ``places`` (m, 2) in units of the rectangle, ``states`` (m, n)."""

    curve: Curve
    places: Array
    states: Array
    period: int

    @staticmethod
    def of(curve: Curve, lower: Array, width: Array) -> Line:
        points = curve.points
        states = np.array([point.state for point in points])
        return Line(curve, (curve.parameters - lower) / width, states, points[0].period)

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
        near = np.flatnonzero(away <= SAGITTA * length + ROUNDING)
        return [(int(i), float(part[i])) for i in near]

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
            for point in (self.curve.points[i], self.curve.points[j])
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
        replaces."""
        line = Line.of(curve, self.lower, self.width)
        for i, known in enumerate(self.lines):
            if known.curve.kind is not curve.kind or known.period != line.period:
                continue
            if self._lies_on(line, known):
                return i
            if self._lies_on(known, line):
                self.lines[i] = line
                return i
        self.lines.append(line)
        self.ways.append(way)
        return len(self.lines) - 1

    def _lies_on(self, line: Line, other: Line) -> bool:
        """All of it in the plane, and its orbits at both ends and in the middle."""
        if not all(other.beside(place) for place in line.places):
            return False
        last = len(line.places) - 1
        return all(self._holds(other, line, i) for i in sorted({0, last // 2, last}))

    def _holds(self, other: Line, line: Line, i: int) -> bool:
        point = line.curve.points[i]
        values = {**line.curve.values, **dict(zip(self.names, point.values, strict=True))}
        touch = point.touches[0] if point.touches else None
        return other.holds(line.places[i], strobes_of(self.family, values, point), touch, self.cycles)
