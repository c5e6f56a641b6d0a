"""Where words and numbers have room in a panel: beside the curves, not on them, and not on each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray
from scipy.spatial import KDTree

Array = NDArray[np.float64]

POINT = 25.4 / 72.0  # mm
CHARACTER, LINE = 0.6, 1.05  # width of a character and height of a line, over the size of the font
APART = 0.5  # mm between two points that stand for a curve


@dataclass(eq=False)
class Room:
    """A panel of ``width`` by ``height`` mm, whose limits are settled: what lies in it already."""

    panel: Axes
    width: float
    height: float
    curves: Array = field(default_factory=lambda: np.empty((0, 2)))
    boxes: list[tuple[float, float, float, float]] = field(
        default_factory=list[tuple[float, float, float, float]]
    )

    def at(self, x: float, y: float) -> tuple[float, float]:
        """A place of the panel in mm from its lower left corner."""
        (left, right), (low, high) = self.panel.get_xlim(), self.panel.get_ylim()
        return self.width * (x - left) / (right - left), self.height * (y - low) / (high - low)

    def back(self, x: float, y: float) -> tuple[float, float]:
        """The place in the panel of mm from its lower left corner."""
        (left, right), (low, high) = self.panel.get_xlim(), self.panel.get_ylim()
        return left + (right - left) * x / self.width, low + (high - low) * y / self.height

    def fill(self, x: Array, y: Array) -> None:
        """A curve through x (m,) and y (m,) lies here."""
        u, v = self.at(x, y)  # pyright: ignore[reportArgumentType]
        points = np.column_stack([u, v])
        points = points[np.isfinite(points).all(axis=1)]
        if len(points) > 1:
            points = _dense(points)
        inside = (points >= 0.0).all(axis=1) & (points <= (self.width, self.height)).all(axis=1)
        self.curves = np.concatenate([self.curves, points[inside]])

    def place(
        self,
        text: str,
        size: float,
        places: Sequence[tuple[float, float]],
        most: int | None = None,
        turned: bool = False,
    ) -> tuple[float, float] | None:
        """The place (its centre, in mm) with the least of curves under a text of this size (points), of those
        that lie inside and on no other text; None where there is none, or ``most`` points of curves are
        covered everywhere. The text, ``turned`` by a right angle or not, is taken to stand there from now
        on."""
        half = _half(text, size)[::-1] if turned else _half(text, size)
        best, least = None, np.inf
        for u, v in places:
            box = u - half[0], v - half[1], u + half[0], v + half[1]
            inside = box[0] >= 0.0 and box[1] >= 0.0 and box[2] <= self.width and box[3] <= self.height
            if not inside or any(_overlap(box, other) for other in self.boxes):
                continue
            covered = self._covered(box)
            if covered < least and (most is None or covered <= most):
                best, least = (u, v), covered
        if best is not None:
            u, v = best
            self.boxes.append((u - half[0], v - half[1], u + half[0], v + half[1]))
        return best

    def mark(self, u: float, v: float, reach: float) -> None:
        """No text covers what lies there (in mm)."""
        self.boxes.append((u - reach, v - reach, u + reach, v + reach))

    def mark_box(self, left: float, low: float, right: float, high: float) -> None:
        """The same of a rectangle."""
        self.boxes.append((left, low, right, high))

    def covered(self, x: Array, y: Array, others: Array) -> bool:
        """Whether a curve runs along others (points in mm, no farther than `APART` from each other)."""
        u, v = self.at(x, y)  # pyright: ignore[reportArgumentType]
        if not len(others):
            return False
        tree = KDTree(others)
        return bool((tree.query(np.column_stack([u, v]))[0] < APART).all())

    def _covered(self, box: tuple[float, float, float, float]) -> int:
        x, y = self.curves.T
        return int(((x > box[0]) & (x < box[2]) & (y > box[1]) & (y < box[3])).sum())


def around(text: str, size: float, u: float, v: float, away: float) -> list[tuple[float, float]]:
    """Where a text may stand so that it begins ``away`` from a place, all in mm: right above it first."""
    right, up = (half + away for half in _half(text, size))
    corner = 0.7 * right, 0.9 * up
    signs = ((1, 1), (-1, 1), (1, -1), (-1, -1))
    corners = [(u + a * max(corner[0], right - 0.4), v + b * corner[1]) for a, b in signs]
    return [*corners, (u, v + up), (u, v - up), (u + right, v), (u - right, v)]


def _half(text: str, size: float) -> tuple[float, float]:
    """Half the width and height (mm) of a text of a size in points."""
    return 0.5 * POINT * size * CHARACTER * len(text) + 0.2, 0.5 * POINT * size * LINE + 0.1


def _overlap(one: tuple[float, float, float, float], other: tuple[float, float, float, float]) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def _dense(points: Array) -> Array:
    """So that no two neighbours lie farther apart than `APART`; jumps over the whole panel stay jumps."""
    lengths = np.hypot(*np.diff(points, axis=0).T)
    counts = np.clip(np.ceil(lengths / APART), 1, 400).astype(int)
    shares = np.concatenate([np.arange(count) / count for count in counts])
    first = np.repeat(np.arange(len(counts)), counts)
    made = points[first] + shares[:, None] * (points[first + 1] - points[first])
    return np.concatenate([made, points[-1:]])
