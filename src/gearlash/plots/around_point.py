"""Curves that leave one point of two parameters, where a line of one parameter cuts them, and how far apart
two of them run."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from scipy.interpolate import CubicSpline

from . import style
from .plane_lines import PlaneLine, draw_lines
from .units import ASSUMED, Units, literal, second
from .words import Words, drawn
from .words import words as words_of

ROOM = 0.07  # of the picture, around all that is in it
ACROSS = (0, (6, 2))
WIDE = 3.4  # of the line of the first curve: what lies over it shows both
MILLIONS = 1e6


@style.styled
def around_point(
    lines: Sequence[PlaneLine],
    point: tuple[float, float],
    across: float,
    cuts: Sequence[tuple[float, str]],
    names: tuple[str, str],
    words: str = "",
    units: Units | None = None,
) -> Figure:
    """Curves that leave a point, and a line on which the second parameter is fixed.

    Parameters
    ----------
    lines : sequence of PlaneLine
        Each over the second parameter. In a panel of its own stands by how much the last one lies below the
        first one.
    point : (float, float)
        That they leave.
    across : float
        The second parameter on the line.
    cuts : sequence of (float, str)
        First parameters where the line cuts curves, with what stands there.
    names : (str, str)
        Short names of the two parameters.
    words : str
        What the line is.
    units : Units, optional
        Second axes in physical units.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> from gearlash import plots
    >>> second = [0.5, 0.4, 0.3, 0.2, 0.1]
    >>> lines = [plots.PlaneLine([(c * (0.5 - y), y) for y in second], "doubling", "") for c in (1, 1.5)]
    >>> figure = plots.around_point(lines, (0.0, 0.5), 0.1, [(0.4, "here")], ("D", "load"))
    >>> len(figure.axes)
    2
    """
    units = units or Units()
    said = words_of(None, units)
    figure = style.figure(style.PAGE, 92.0)
    plane, apart = figure.subplots(1, 2, width_ratios=(1.6, 1.0))
    every = np.concatenate([np.asarray(line.values) for line in lines])
    low, high = every.min(axis=0), np.maximum(every.max(axis=0), (-np.inf, across))
    unit = high - low
    plane.set_xlim(low[0] - ROOM * unit[0], high[0] + ROOM * unit[0])
    plane.set_ylim(min(low[1], across) - 2.0 * ROOM * unit[1], high[1] + 2.0 * ROOM * unit[1])
    key = [*draw_lines(plane, lines[:1], unit, WIDE), *draw_lines(plane, lines[1:], unit)]
    for i, line in enumerate(lines[1:]):
        _along(plane, line, i < len(lines) - 2)
    plane.axhline(across, color=style.GREY, lw=0.8, ls=ACROSS, zorder=1.0)
    plane.plot(*point, ls="none", marker="*", ms=8.0, mew=0.7, color=style.INK, mfc="white", zorder=5.0)
    for value, text in cuts:
        _cut(plane, value, across, text)
    plane.set_xlabel(said.name(names[0]))
    plane.set_ylabel(said.name(names[1]))
    twins = [units.of_parameter(each) for each in names]
    second(plane, twins[0])
    second(plane, twins[1], "y")
    _apart(apart, lines[0], lines[-1], across, names, said)
    marks = [
        Line2D([], [], ls="none", marker="*", ms=7.0, color=style.INK, mfc="white", label=_pair(point)),
        Line2D([], [], color=style.GREY, lw=0.8, ls=ACROSS, label=drawn(words)),
    ]
    figure.legend(
        handles=[*key, *marks], loc="outside lower center", ncols=2, columnspacing=1.6,
        title=ASSUMED if any(twin is not None and twin.assumed for twin in twins) else None,
        title_fontsize=6.5,
    )  # fmt: skip
    return figure


def _pair(point: tuple[float, float]) -> str:
    return f"all three meet: ({point[0]:.6g}, {point[1]:.6g})"


def _along(axes: Axes, line: PlaneLine, left: bool) -> None:
    """The text of a curve beside it: left of its middle, or right of it farther down."""
    value, height = line.values[int((0.5 if left else 0.7) * len(line.values))]
    axes.annotate(
        literal(line.text), (value, height), (-7.0 if left else 7.0, -2.0), textcoords="offset points",
        ha="right" if left else "left", va="top", fontsize=7.0,
    )  # fmt: skip


def _cut(axes: Axes, value: float, across: float, text: str) -> None:
    axes.plot(
        [value], [across], ls="none", marker="o", ms=4.4, mew=0.8, color=style.INK, mfc="white", zorder=5.0
    )
    axes.annotate(
        literal(text), (value, across), (0.0, -6.0), textcoords="offset points", ha="center", va="top",
        fontsize=7.0,
    )  # fmt: skip


def _apart(
    axes: Axes, one: PlaneLine, other: PlaneLine, across: float, names: tuple[str, str], said: Words
) -> None:
    """By how much the first parameter of one curve is larger than that of the other, over the second."""
    base = np.asarray(one.values)[::-1]
    base = base[np.argsort(base[:, 1])]
    there = np.asarray(other.values)
    difference = MILLIONS * (CubicSpline(base[:, 1], base[:, 0])(there[:, 1]) - there[:, 0])
    axes.axvline(0.0, color=style.INK, lw=0.6)
    line = PlaneLine(np.column_stack([difference, there[:, 1]]).tolist(), other.kind)
    draw_lines(axes, [line], np.array([max(float(np.ptp(difference)), 1e-300), float(np.ptp(there[:, 1]))]))
    axes.axhline(across, color=style.GREY, lw=0.8, ls=ACROSS, zorder=1.0)
    axes.plot(
        [difference[0]], [there[0, 1]], ls="none", marker="*", ms=8.0, mew=0.7, color=style.INK, mfc="white"
    )
    axes.set_xlabel(f"{said.symbol(names[0])}: first less last curve  [10⁻⁶]")
    axes.set_ylabel(said.name(names[1]))
