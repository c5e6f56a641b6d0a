"""The place of a zone's boundary that is nearest to the operating point, in units of tolerances."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

from gearlash.branches.curves import Plane, beginning
from gearlash.system import GearlashError

from .plane_zone import ToleranceMargin
from .zone_end import RANGE
from .zone_parts import Part

Array = NDArray[np.float64]
BOX, ELLIPSE = "box", "ellipse"
SCANNED = 12  # places on a piece between two that were solved for
FINE = 1e-13  # of the way along a piece
FEWEST = 4  # orbits of a piece of which a spline is made


@dataclass(frozen=True, eq=False)
class Nearest:
    """Around a place (2,), with tolerances (2,)."""

    plane: Plane
    at: Array
    tolerances: Array

    def of(self, norm: str, parts: Sequence[Part]) -> ToleranceMargin:
        """The smallest multiple of the tolerances at which something is touched."""
        limits = (
            np.array([self.at - np.array(self.plane.lower), np.array(self.plane.upper) - self.at])
            / self.tolerances
        )
        side, axis = np.unravel_index(int(limits.argmin()), limits.shape)
        edge = self.at.copy()
        edge[axis] = (self.plane.upper if side else self.plane.lower)[axis]
        best = ToleranceMargin(norm, float(limits.min()), (float(edge[0]), float(edge[1])), RANGE, False)
        for part in parts:
            place = self.on(norm, part)
            multiple = self.size(norm, place)
            if multiple < best.multiple:
                best = ToleranceMargin(
                    norm, multiple, (float(place[0]), float(place[1])), part.bound.event, True
                )
        return best

    def size(self, norm: str, place: Array) -> float:
        away = (place - self.at) / self.tolerances
        return float(np.abs(away).max() if norm == BOX else np.linalg.norm(away))

    def on(self, norm: str, part: Part) -> Array:
        """The nearest place of a piece, solved for on its curve."""
        walked = _Walked.of(part, self.plane)
        ends = [part.bound.values[0], part.bound.values[-1]]
        if walked is None:
            return min(part.bound.values, key=lambda place: self.size(norm, place))
        scanned = walked.scanned()
        sizes = [self.size(norm, walked.place(s)) for s in scanned]
        at = int(np.argmin(sizes))
        low, high = float(scanned[max(at - 1, 0)]), float(scanned[min(at + 1, len(scanned) - 1)])
        found = [*ends, *self.solved(norm, walked, low, high)]
        return min(found, key=lambda place: self.size(norm, place))

    def solved(self, norm: str, walked: _Walked, low: float, high: float) -> list[Array]:
        """Where, between two places of a piece, the size is stationary, or (of a box) a corner lies on it."""

        def stationary(place: Array, tangent: Array) -> float:
            return float((place - self.at) / self.tolerances**2 @ tangent)

        def corner(place: Array, tangent: Array) -> float:
            one, two = np.abs(place - self.at) / self.tolerances
            return float(one - two)

        def first(place: Array, tangent: Array) -> float:
            return float(tangent[0])

        def second(place: Array, tangent: Array) -> float:
            return float(tangent[1])

        tests: list[Callable[[Array, Array], float]] = (
            [stationary] if norm == ELLIPSE else [corner, first, second]
        )
        found = []
        for test in tests:
            one, two = test(*walked.exact(low)), test(*walked.exact(high))
            if one * two < 0.0:
                root: Any = brentq(lambda s, test=test: test(*walked.exact(float(s))), low, high, xtol=FINE)
                found.append(walked.exact(float(root))[0])
        return found or [walked.exact(0.5 * (low + high))[0]]


@dataclass(frozen=True, eq=False)
class _Walked:
    """A piece by the length along it, from 0 to 1."""

    part: Part
    plane: Plane
    along: Array
    spline: CubicSpline
    known: dict[float, tuple[Array, Array]]

    @staticmethod
    def of(part: Part, plane: Plane) -> _Walked | None:
        """None for one of few orbits."""
        points = part.bound.points
        steps = np.linalg.norm(np.diff(part.bound.values, axis=0) / plane.unit, axis=1)
        kept = [points[0], *(p for p, step in zip(points[1:], steps, strict=True) if step > 1e-9)]
        if len(kept) < FEWEST:
            return None
        along = np.append(0.0, np.cumsum(steps[steps > 1e-9]))
        along = along / along[-1]
        phases = np.unwrap([_phase(p) for p in kept], period=float(points[0].period))
        table = np.array([[*p.values, phase, *p.state] for p, phase in zip(kept, phases, strict=True)])
        return _Walked(part, plane, along, CubicSpline(along, table), {})

    def scanned(self) -> Array:
        between = np.linspace(self.along[:-1], self.along[1:], SCANNED, endpoint=False, axis=1).ravel()
        return np.append(between, 1.0)

    def place(self, s: float) -> Array:
        found: Array = self.spline(s)[:2]
        return found

    def exact(self, s: float) -> tuple[Array, Array]:
        """The place on the curve that is nearest to the one on the spline, and the direction there."""
        if s not in self.known:
            row = self.spline(s)
            near = self.part.bound.points[
                int(np.abs(np.linspace(0.0, 1.0, len(self.part.bound.points)) - s).argmin())
            ]
            touches = tuple(each._replace(phase=float(row[2]) % near.period) for each in near.touches[:1])
            point = replace(near, values=(float(row[0]), float(row[1])), state=row[3:], touches=touches)
            kind = self.part.bound.kind
            try:
                node = beginning(self.plane, point, row[:2], kind).ahead
                self.known[s] = node.place, node.direction[-2:] * self.plane.unit
            except GearlashError:  # beside what cannot be held: as the spline has it
                self.known[s] = row[:2], self.spline(s, 1)[:2]
            place, tangent = self.known[s]
            if tangent @ self.spline(s, 1)[:2] < 0.0:
                self.known[s] = place, -tangent
        return self.known[s]


def _phase(point: Any) -> float:
    return float(point.touches[0].phase) if point.touches else 0.0
