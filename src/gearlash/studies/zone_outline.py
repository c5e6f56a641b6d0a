"""The border of a zone put together: along curves to where another takes over, and along the rectangle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from .zone_parts import CLOSED, EDGE, Part

Array = NDArray[np.float64]
NEAR = 1e-6  # of the rectangle: two ends that are one
BETWEEN = 12  # places between two computed ones
Step = tuple[Part, bool]
"""A piece, and whether it is passed from its first to its last orbit."""


@dataclass(frozen=True, eq=False)
class Border:
    """A closed border: its polygon (m, 2) and the pieces on it; or why it could not be closed, and where."""

    polygon: Array
    parts: tuple[Part, ...]
    reason: str = ""
    where: tuple[float, float] | None = None


def smooth(part: Part, unit: Array) -> Array:
    """Places (m, 2) on a piece, on a spline between those that were solved for."""
    points = part.bound.values
    steps = np.linalg.norm(np.diff(points, axis=0) / unit, axis=1)
    points = points[np.append(True, steps > 1e-12)]
    steps = steps[steps > 1e-12]
    if len(points) < 4:
        return points
    along = np.append(0.0, np.cumsum(steps))
    between = np.linspace(along[:-1], along[1:], BETWEEN, endpoint=False, axis=1).ravel()
    found: Array = CubicSpline(along, points)(np.append(between, along[-1]))
    return found


@dataclass(frozen=True, eq=False)
class Tracer:
    """Of the pieces in a rectangle with corners ``lower`` and ``upper`` (2,)."""

    parts: Sequence[Part]
    lower: Array
    upper: Array

    @property
    def unit(self) -> Array:
        return self.upper - self.lower

    def scaled(self, place: Array) -> Array:
        found: Array = (np.asarray(place) - self.lower) / self.unit
        return found

    def place_of(self, part: Part, last: bool) -> Array:
        return part.bound.values[-1 if last else 0]

    def toward(self, part: Part, place: Array, outward: Array) -> bool:
        """Whether the zone lies left of a piece that is passed forwards, where a line leaves the zone."""
        along = smooth(part, self.unit)
        scaled = self.scaled(along)
        at = int(np.linalg.norm(scaled - self.scaled(place), axis=1).argmin())
        low, high = max(at - 1, 0), min(at + 1, len(scaled) - 1)
        tangent = scaled[high] - scaled[low]
        return bool(tangent[1] * outward[0] - tangent[0] * outward[1] > 0.0)

    def border(self, start: Step | None, place: Array) -> Border:
        """With the zone on the left: from a piece, or from a place of the rectangle."""
        polygon: list[Array] = []
        passed: list[Step] = []
        step, here = start, np.asarray(place, dtype=np.float64)
        if step is None:
            step = self.along_rectangle(here, None, polygon)
        while step is not None:
            if any(step[0] is part and step[1] is forward for part, forward in passed):
                break
            passed.append(step)
            part, forward = step
            places = smooth(part, self.unit)
            polygon.append(places if forward else places[::-1])
            if part.how[0] == CLOSED:
                break
            how, last = part.how[1 if forward else 0], self.place_of(part, forward)
            if how == EDGE:
                step = self.along_rectangle(last, (part, forward), polygon)
                continue
            step = None if how else self.taking_over(part, forward)
            if step is None:
                end = part.bound.ends[1 if forward else 0]
                why = (
                    how
                    or f"at a {end.kind if end is not None else 'point'} no curve was found that takes over"
                )
                return Border(
                    np.empty((0, 2)), tuple(p for p, _ in passed), why, (float(last[0]), float(last[1]))
                )
        first = passed[0] if passed else None
        if first is not None and start is None:  # from the rectangle: what was passed before the first piece
            polygon = polygon[1:] if len(passed) > 1 or polygon else polygon
        return Border(np.concatenate(polygon) if polygon else self.corners, tuple(p for p, _ in passed))

    @property
    def corners(self) -> Array:
        (a, b), (c, d) = self.lower, self.upper
        return np.array([[a, b], [c, b], [c, d], [a, d]])

    def taking_over(self, part: Part, forward: bool) -> Step | None:
        """The piece that begins where one ends; of several the one that turns left most."""
        here = self.scaled(self.place_of(part, forward))
        back = self.leaving(part, not forward)
        found: list[tuple[float, Step]] = []
        for other in self.parts:
            for last in (False, True):
                if other.how[1 if last else 0] or (other is part and last is forward):
                    continue
                if np.abs(self.scaled(self.place_of(other, last)) - here).max() <= NEAR:
                    away = self.leaving(other, not last)
                    angle = float(np.arctan2(back[1], back[0]) - np.arctan2(away[1], away[0])) % (2.0 * np.pi)
                    found.append((angle, (other, not last)))
        return min(found, key=lambda pair: pair[0])[1] if found else None

    def leaving(self, part: Part, forward: bool) -> Array:
        """Direction (2,) in which a piece leaves its first (or last) place, scaled."""
        places = self.scaled(smooth(part, self.unit))
        places = places if forward else places[::-1]
        found: Array = places[min(BETWEEN // 2, len(places) - 1)] - places[0]
        return found

    def along_rectangle(self, place: Array, came: Step | None, polygon: list[Array]) -> Step | None:
        """Counter-clockwise to where the next piece ends; puts the corners on the way into the polygon."""
        here = self.perimeter(place)
        ends = [
            ((self.perimeter(self.place_of(part, last)) - here) % 4.0, (part, not last))
            for part in self.parts
            for last in (False, True)
            if part.how[1 if last else 0] == EDGE
        ]
        mine = None if came is None else (came[0], not came[1])
        ahead = [
            (4.0 if mine is not None and step[0] is mine[0] and step[1] is mine[1] else way, step)
            for way, step in ends
        ]
        way, step = min(ahead, key=lambda pair: pair[0], default=(4.0, None))
        corners = [k for k in range(1, 9) if here < k < here + way]
        if corners:
            polygon.append(np.array([self.corners[k % 4] for k in corners]))
        return step

    def perimeter(self, place: Array) -> float:
        """How far along the rectangle, counter-clockwise from its lower left corner, in sides."""
        x, y = np.clip(self.scaled(place), 0.0, 1.0).tolist()
        side = int(np.argmin([y, 1.0 - x, 1.0 - y, x]))
        return [x, 1.0 + y, 2.0 + 1.0 - x, 3.0 + 1.0 - y][side] % 4.0


def area(polygon: Array) -> float:
    """Positive where it is passed counter-clockwise."""
    x, y = polygon.T
    return 0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1))


def apart(tracer: Tracer, place: Array) -> Iterator[tuple[float, Part]]:
    """How far a place lies from every piece, of the rectangle."""
    here = tracer.scaled(place)
    for part in tracer.parts:
        places = tracer.scaled(smooth(part, tracer.unit))
        one, chord = places[:-1], np.diff(places, axis=0)
        length = np.maximum((chord**2).sum(axis=1), 1e-300)
        share = np.clip(((here - one) * chord).sum(axis=1) / length, 0.0, 1.0)
        yield float(np.linalg.norm(one + share[:, None] * chord - here, axis=1).min()), part
