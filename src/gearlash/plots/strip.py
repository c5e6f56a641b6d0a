"""A strip of labels over an axis: which motion each direction of a sweep finds where."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.patches import Patch, Rectangle

from . import style
from .regimes import ALL, Regime, regime, short
from .swept import Swept

OVER_LINES = 5  # lines through all panels, as of the present value, do not cross texts
CHARACTER = 1.25  # mm of a character at the size of the strip


def strip(axes: Axes, ways: Sequence[Swept], millimetres: float, height: float = 0.78) -> set[Regime]:
    """One row a direction, first on top; labels where they fit. Returns the regimes that occur."""
    span = ways[0].values[-1] - ways[0].values[0]
    room = span / millimetres  # of the axis per mm
    seen: set[Regime] = set()
    for row, way in enumerate(ways):
        bottom = len(ways) - 1 - row + (1.0 - height) / 2.0
        edges = way.edges()
        for first, last, label in way.runs():
            kind = regime(label)
            seen.add(kind)
            _cell(axes, float(edges[first]), float(edges[last]), bottom, height, kind)
            text = short(label)
            if edges[last] - edges[first] > room * (CHARACTER * len(text) + 0.6):
                middle = (edges[first] + edges[last]) / 2.0
                axes.text(
                    middle,
                    bottom + height / 2.0,
                    text,
                    ha="center",
                    va="center_baseline",
                    fontsize=6.5,
                    color=kind.ink,
                    zorder=OVER_LINES,
                    bbox={"facecolor": kind.colour, "edgecolor": "none", "pad": 0.3},
                )
    axes.set_ylim(0.0, len(ways))
    axes.set_yticks([len(ways) - 0.5 - i for i in range(len(ways))], [b.direction for b in ways])
    axes.tick_params(axis="y", length=0, which="both")
    for side in axes.spines.values():
        side.set_visible(False)
    return seen


def _cell(axes: Axes, left: float, right: float, bottom: float, height: float, kind: Regime) -> None:
    place = (left, bottom), right - left, height
    axes.add_patch(Rectangle(*place, facecolor=kind.colour, edgecolor="none", linewidth=0.0))
    axes.add_patch(
        Rectangle(*place, facecolor="none", edgecolor=style.INK, linewidth=0.25, hatch=kind.hatch or None)
    )


def key(seen: set[Regime]) -> list[Patch]:
    """Legend entries of the regimes that occur, in their order."""
    return [
        Patch(facecolor=r.colour, edgecolor=style.INK, linewidth=0.4, hatch=r.hatch or None, label=r.words)
        for r in ALL
        if r in seen
    ]
