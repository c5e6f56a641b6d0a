"""Histories of what is measured on a motion: forces and transmission error over time, side by side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style
from .units import literal

Array = NDArray[np.float64]
LEGEND = (0.25, 0.45)  # of the height of a strip: a legend of one row, and of two
LINES = (
    (style.BLUE, "-"),
    (style.VERMILION, (0, (5, 1.5))),
    (style.GREEN, (0, (1.5, 1))),
    (style.PURPLE, (0, (4, 1, 1, 1))),
)


@dataclass(frozen=True, eq=False)
class Strip:
    """Quantities of one unit in one panel.

    Parameters
    ----------
    label : str
        Of the axis.
    lines : tuple of (str, ndarray)
        Words and values of shape (m,).
    level : float, optional
        A horizontal line, such as the boundary of the gap.
    """

    label: str
    lines: tuple[tuple[str, Array], ...]
    level: float | None = None


@dataclass(frozen=True, eq=False)
class Column:
    """One motion: time, and its panels from top to bottom.

    Parameters
    ----------
    title : str
    time : ndarray of shape (m,)
    free : ndarray of bool, shape (m,)
        Where there is no contact.
    strips : tuple of Strip
    """

    title: str
    time: Array
    free: NDArray[np.bool_]
    strips: tuple[Strip, ...]


@style.styled
def measured_histories(columns: Sequence[Column], time: str) -> Figure:
    """Histories of one or several motions, a column each.

    Parameters
    ----------
    columns : sequence of Column
        With as many strips each, of the same quantities.
    time : str
        Label of the axis of time.

    Returns
    -------
    matplotlib.figure.Figure
    """
    rows = len(columns[0].strips)
    figure = style.figure(style.PAGE, 23.0 * rows + 16.0)
    panels = figure.subplots(rows, len(columns), squeeze=False, sharex="col", sharey="row")
    for j, column in enumerate(columns):
        for strip, panel in zip(column.strips, panels[:, j], strict=True):
            panel.fill_between(
                column.time, 0.0, 1.0, where=column.free.tolist(), transform=panel.get_xaxis_transform(),
                facecolor=style.FREE_SHADE, edgecolor="none", zorder=0.1,
            )  # fmt: skip
            for (words, values), (colour, dash) in zip(strip.lines, LINES, strict=False):
                panel.plot(column.time, values, color=colour, ls=dash, label=words)
            if strip.level is not None:
                panel.axhline(strip.level, color=style.BOUNDARY, lw=0.7)
            panel.margins(x=0.0, y=0.1)
            panel.set_ylabel(strip.label if j == 0 else "")
            if j == 0:
                panel.legend(loc="upper left", ncols=2, fontsize=6.5, frameon=True, facecolor="white",
                             framealpha=0.8, edgecolor="none")  # fmt: skip
        panels[0, j].set_title(literal(column.title))
        panels[-1, j].set_xlabel(time)
    _room_for_legends(columns, list(panels[:, 0]))
    return figure


def _room_for_legends(columns: Sequence[Column], first: Sequence[Axes]) -> None:
    """Above what all columns of a row show."""
    for i, panel in enumerate(first):
        share = LEGEND[len(columns[0].strips[i].lines) > 2]
        low, high = panel.get_ylim()
        panel.set_ylim(low, high + share * (high - low))
