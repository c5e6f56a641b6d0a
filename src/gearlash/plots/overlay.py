"""A measurement over speed, laid over what is computed; residuals below."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gearlash.system import GearlashError

from . import style
from .over_speed import broken
from .units import literal

JUMP_SHADE = "0.88"
MEASURED = {
    "up": ("^", "measured, speed rising"),
    "down": ("v", "measured, speed falling"),
    "": ("o", "measured"),
}
"""Marker and words of rows, by the way of speed."""


@style.styled
def overlay(
    speed: Sequence[float],
    measured: Sequence[float],
    up: Sequence[float | None],
    down: Sequence[float | None],
    speed_label: str,
    label: str,
    title: str = "",
    jumps: Sequence[tuple[float, float]] = (),
    directions: Sequence[str] = (),
    apart: Sequence[NDArray[np.bool_]] = (),
) -> Figure:
    """Measured dots over computed lines, and what is left.

    Parameters
    ----------
    speed, measured : sequence of float
    up, down : sequence of float or None
        Computed with speed rising and falling.
    speed_label, label : str
        Of the axes, with units.
    title : str
    jumps : sequence of (float, float)
        Intervals in which the measurement jumps.
    directions : sequence of str
        Of every measured row ``up``, ``down`` or empty, as the speed came to it: residuals are to the motion
        computed that way. Without any, to both.
    apart : sequence of ndarray of bool, shape (m-1,)
        With speed rising and falling, the steps over which the computed motion changes to another one: no
        line joins them. Without, all are joined.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> from gearlash import plots
    >>> figure = plots.overlay([1, 2], [3.0, 4.0], [3.1, 4.1], [3.1, None], "speed [rpm]", "force [N]")
    >>> len(figure.axes)
    2
    """
    rising, falling = (np.array([np.nan if x is None else x for x in row], float) for row in (up, down))
    values = np.asarray(measured, float)
    figure = style.figure(style.PAGE, 110.0)
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=[3, 1])
    ways = np.array(directions or [""] * len(values))
    places = np.asarray(speed, float)
    up_look = {"color": style.BLUE, "lw": 2.4, "alpha": 0.5, "label": "computed, speed rising"}
    down_look = {
        "color": style.VERMILION, "lw": 1.0, "ls": (0, (4, 1.5)), "label": "computed, speed falling"
    }  # fmt: skip
    if apart and [np.shape(each) for each in apart] != [(len(values) - 1,)] * 2:
        raise GearlashError(f"apart: expected twice {len(values) - 1} flags, with speed rising and falling")
    nowhere = np.zeros(max(len(values) - 1, 0), dtype=bool)
    for line, steps, look in zip(
        (rising, falling), apart or (nowhere,) * 2, (up_look, down_look), strict=True
    ):
        upper.plot(*broken(places, line, steps), **look)
        alone = _alone(line, steps)
        if not alone.any():
            continue
        dot = {"color": look["color"], "alpha": look.get("alpha"), "ms": look["lw"] + 1.0, "mew": 0.0}
        upper.plot(places[alone], line[alone], ls="none", marker="o", **dot)
    for way, (marker, words) in MEASURED.items():
        rows = ways == way
        if rows.any():
            look = {"color": style.INK, "ms": 2.8, "mfc": "white", "mew": 0.7, "ls": "none"}
            upper.plot(places[rows], values[rows], marker=marker, label=words, **look)
    went_up, went_down = ways != "down", ways != "up"
    hollow = {"ls": "none", "mfc": "none", "mew": 0.7}
    for rows, line, colour, marker, size in (
        (went_up, rising, style.BLUE, "^" if directions else "o", 3.6),
        (went_down, falling, style.VERMILION, "v" if directions else "s", 2.8),
    ):
        lower.plot(places[rows], (values - line)[rows], marker=marker, color=colour, ms=size, **hollow)
    for low, high in jumps:
        for panel in (upper, lower):
            panel.axvspan(low, high, color=JUMP_SHADE, lw=0, zorder=0.1)
    lower.axhline(0.0, color=style.INK, lw=0.6)
    upper.set_ylabel(literal(label))
    unit = label[label.rindex("[") :] if "[" in label else ""
    lower.set_ylabel(literal(f"measured less\ncomputed  {unit}".rstrip()))
    lower.set_xlabel(literal(speed_label + ("   (grey: measured jumps)" if jumps else "")))
    upper.legend(loc="best")
    style.align_labels([upper, lower], 13.0)
    if title:
        upper.set_title(literal(title), pad=6.0)
    return figure


def _alone(line: NDArray[np.float64], steps: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Values that no line goes to: a dot shows them."""
    gone = steps | np.isnan(line[1:]) | np.isnan(line[:-1])
    return np.isfinite(line) & np.concatenate([[True], gone]) & np.concatenate([gone, [True]])
