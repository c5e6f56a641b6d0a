"""Order spectra: levels of single lines over multiples of the mesh frequency."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator
from numpy.typing import NDArray

from . import style
from .units import literal

Array = NDArray[np.float64]

HIGHEST = 10.0  # order that is drawn
FLOOR = 100.0  # dB below the highest line that is drawn: what is lower is not
BELOW, ABOVE = 6.0, 8.0  # dB from the lowest and the highest line to the ends of the axis
MOST_STEMS = 60  # lines; more are drawn as a curve


@dataclass(frozen=True, eq=False)
class Levels:
    """The lines of one quantity.

    Parameters
    ----------
    words : str
        Title of its panel.
    label : str
        Of the axis, with the reference.
    order, level : ndarray of shape (n,)
        Order of mesh frequency and level in dB; without the mean.
    """

    words: str
    label: str
    order: Array
    level: Array


@style.styled
def order_spectra(rows: Sequence[Sequence[Levels]], titles: Sequence[str]) -> Figure:
    """Spectra side by side: a column for every motion, a row for every quantity.

    Parameters
    ----------
    rows : sequence of sequences of Levels
        Rows of one quantity, with one entry for every motion.
    titles : sequence of str
        Of the columns.

    Returns
    -------
    matplotlib.figure.Figure
    """
    figure = style.figure(style.PAGE, 21.0 * len(rows) + 14.0)
    panels = figure.subplots(len(rows), len(titles), squeeze=False, sharex=True, sharey="row")
    for row, line in zip(rows, panels, strict=True):
        low, floor, high = _ends(row)
        for i, (levels, panel) in enumerate(zip(row, line, strict=True)):
            _draw(panel, levels, low, floor)
            panel.set_ylim(low, high)
            panel.set_ylabel(levels.label if i == 0 else "")
            panel.text(
                0.98, 0.95, levels.words, transform=panel.transAxes, ha="right", va="top", fontsize=7.5,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0, "alpha": 0.8},
            )  # fmt: skip
    for title, panel in zip(titles, panels[0], strict=True):
        panel.set_title(literal(title))
    for panel in panels[-1]:
        panel.set_xlabel("order of mesh frequency")
        panel.set_xlim(0.0, HIGHEST + 0.3)
        panel.xaxis.set_major_locator(MultipleLocator(2.0))
        panel.xaxis.set_minor_locator(MultipleLocator(1.0))
    return figure


def _shown(levels: Levels) -> NDArray[np.bool_]:
    """Lines of orders that are drawn, and not the mean."""
    return (levels.order > 0.0) & (levels.order <= HIGHEST + 1e-9)


def _ends(row: Sequence[Levels]) -> tuple[float, float, float]:
    """Least value of the axis of one quantity, the level below which no line is drawn, and greatest value."""
    level = np.concatenate([levels.level[_shown(levels)] for levels in row])
    top = float(level.max(initial=-np.inf))
    if not np.isfinite(top):
        return 0.0, 0.0, 1.0
    return float(level[level >= top - FLOOR].min()) - BELOW, top - FLOOR, top + ABOVE


def _draw(panel: Axes, levels: Levels, low: float, floor: float) -> None:
    shown = _shown(levels)
    order, seen = levels.order[shown], levels.level[shown] >= floor
    level = np.maximum(levels.level[shown], low)
    if len(order) <= MOST_STEMS:
        panel.vlines(order[seen], low, level[seen], color=style.BLUE, lw=1.2)
        panel.plot(order[seen], level[seen], ls="none", marker="o", ms=2.8, color=style.BLUE)
    else:
        panel.plot(order, level, color=style.BLUE, lw=0.7)
    panel.grid(axis="y", color=style.PALE, lw=0.4)
