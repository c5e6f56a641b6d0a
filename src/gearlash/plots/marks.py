"""Labelled vertical lines for special points, kept apart where they lie close together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from . import style

LINES = {"grazing": (0, (4, 1.5)), "doubling": (0, (1, 1.2)), "fold": (0, (5, 1.2, 1, 1.2))}
TICKS = {"grazing": "v", "doubling": "o", "fold": "D", "Neimark-Sacker": "s", "branch point": "P"}
OTHER_LINE, OTHER_TICK = (0, (2, 3)), "|"


@dataclass(frozen=True)
class Mark:
    """A special point on the axis of a diagram.

    Parameters
    ----------
    value : float
    kind : str
        ``grazing``, ``doubling``, ``fold``, or any other: it decides the line.
    text : str
        Beside the line; without a text there is no line, only a tick above the panels.
    strong : bool
        Line and text are bold.

    Examples
    --------
    >>> from gearlash.plots import Mark
    >>> Mark(1.112, "grazing", "1-0 → 1-1").strong
    False
    """

    value: float
    kind: str
    text: str
    strong: bool = False


def spread(positions: Sequence[float], gap: float, low: float, high: float) -> NDArray[np.float64]:
    """Positions (m,) moved as little as possible so that neighbours are ``gap`` apart, within low and high.

    Isotonic regression by pooling neighbours that collide; the order stays. Too many for the room lie closer.
    """
    count = len(positions)
    gap = min(gap, (high - low) / max(1, count - 1))
    order = np.argsort(positions, kind="stable")
    steps = gap * np.arange(count)
    blocks: list[tuple[float, int]] = []  # mean of the positions less their steps, how many
    for target in np.asarray(positions, dtype=float)[order] - steps:
        blocks.append((float(target), 1))
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            (mean, n), (before, m) = blocks.pop(), blocks.pop()
            blocks.append(((mean * n + before * m) / (n + m), n + m))
    level = np.concatenate([np.full(n, mean) for mean, n in blocks]) if blocks else np.empty(0)
    placed = np.empty(count)
    placed[order] = np.clip(level, low, high - gap * (count - 1)) + steps
    return placed


def height(marks: Sequence[Mark]) -> float:
    """Height (mm) of the band that holds the texts of the marks."""
    longest = max((len(m.text) for m in marks), default=0)
    return 4.5 + 1.5 * longest if longest else 2.0


def lines(panels: Sequence[Axes], marks: Sequence[Mark]) -> None:
    """The lines themselves, through every panel."""
    for mark in marks:
        for panel in panels if mark.text else ():
            panel.axvline(
                mark.value,
                color=style.INK if mark.strong else style.GREY,
                lw=0.7 if mark.strong else 0.5,
                ls=LINES.get(mark.kind, OTHER_LINE),
                zorder=0.5,
            )


def texts(band: Axes, marks: Sequence[Mark], millimetres: float, line_height: float = 3.3) -> None:
    """Upright texts in a frameless band above the panels, joined to their lines. ``millimetres``: width of
    the band, whose height is `height`."""
    band.set_ylim(0.0, height(marks))
    band.set_yticks([])
    for side in band.spines.values():
        side.set_visible(False)
    band.tick_params(which="both", bottom=False, labelbottom=False, top=False)
    for mark in marks:
        marker = TICKS.get(mark.kind, OTHER_TICK)
        band.plot([mark.value], [0.0], marker=marker, ms=2.6, mew=0.0, color=style.INK, clip_on=False)
    marks = [m for m in marks if m.text]
    if not marks:
        return
    left, right = band.get_xlim()
    unit = (right - left) / millimetres
    placed = spread([m.value for m in marks], line_height * unit, left + unit, right - unit)
    for mark, x in zip(marks, placed, strict=True):
        band.plot(
            [mark.value, mark.value, x],
            [0.0, 1.0, 3.0],
            color=style.INK if mark.strong else style.GREY,
            lw=0.5,
        )
        band.text(
            x,
            3.6,
            mark.text,
            rotation=90,
            ha="center",
            va="bottom",
            fontsize=7,
            fontweight="bold" if mark.strong else "normal",
            color=style.INK if mark.strong else style.GREY,
        )
