"""Curves in a plane of two parameters, all figures alike: a kind has its colour and its dashes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from scipy.interpolate import CubicSpline

from . import style

LOOKS = {
    "grazing": (style.BLUE, "-"),
    "doubling": (style.VERMILION, (0, (4, 1.5))),
    "fold": (style.GREEN, (0, (5, 1.2, 1, 1.2))),
    "Neimark-Sacker": (style.PURPLE, (0, (1, 1.2))),
}
OTHER = (style.INK, (0, (2, 3)))
BETWEEN = 8  # points drawn between two that were computed


@dataclass(frozen=True, eq=False)
class PlaneLine:
    """A curve of special orbits as it is drawn.

    Parameters
    ----------
    values : sequence of (float, float)
        Of the two parameters, in the order of the curve.
    kind : str
        ``grazing``, ``doubling``, ``fold``, ``Neimark-Sacker``, or any other: it decides the look.
    text : str
        In the legend; lines of one text have one entry.

    Examples
    --------
    >>> from gearlash.plots import PlaneLine
    >>> PlaneLine(((0.7, 0.1), (0.8, 0.2)), "fold", "fold of 1-1-0").kind
    'fold'
    """

    values: Sequence[tuple[float, float]]
    kind: str
    text: str = ""


def smooth(values: Sequence[tuple[float, float]], unit: np.ndarray) -> np.ndarray:
    """The same points (m, 2) with more between them, on a spline along the chords, in units (2,)."""
    points = np.asarray(values, dtype=np.float64)
    steps = np.linalg.norm(np.diff(points, axis=0) / unit, axis=1)
    points = points[np.append(True, steps > 0.0)]
    if len(points) < 4:
        return points
    along = np.append(0.0, np.cumsum(steps[steps > 0.0]))
    parts = np.linspace(along[:-1], along[1:], BETWEEN, endpoint=False, axis=1).ravel()
    found: np.ndarray = CubicSpline(along, points)(np.append(parts, along[-1]))
    return found


def draw_lines(axes: Axes, lines: Iterable[PlaneLine], unit: np.ndarray, width: float = 1.2) -> list[Line2D]:
    """Draws them; returns their legend."""
    key: dict[tuple[str, str], Line2D] = {}
    for line in lines:
        colour, dashes = LOOKS.get(line.kind, OTHER)
        shown = smooth(line.values, unit)
        axes.plot(shown[:, 0], shown[:, 1], color=colour, ls=dashes, lw=width, zorder=3.0)
        if line.text:
            entry = Line2D([], [], color=colour, ls=dashes, lw=width, label=line.text)
            key.setdefault((line.kind, line.text), entry)
    return list(key.values())
