"""Tolerances: the probability that teeth stay in contact, over the bands that hold for all, some and none."""

from __future__ import annotations

from dataclasses import dataclass
from textwrap import wrap
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import PercentFormatter
from numpy.typing import NDArray

from gearlash.case.units import pretty
from gearlash.results.tolerance import Band, Influence, Tolerance, least_chance

from . import style
from .regimes import DRIVE, FREE
from .units import literal

Numbers = NDArray[np.float64]
ROWS = ("all tried", "as it is", "none tried")
HEIGHTS = (34.0, 18.0)  # mm of probability, bands
BAR = 0.62  # of a row
LEAST_BAR = 0.01  # share of the variance below which a value is named without a bar
UNKNOWN = 0.5  # error of a share with which nothing of it is known
LINE = 90  # characters
NOWHERE: dict[str, Any] = {"va": "center", "fontsize": "small"}


@style.styled
def tolerance_bands(found: Tolerance, title: str = "") -> Figure:
    """The probability of impact-free motion, the bands under it, and what each value makes of the margin.

    Values that make less than 1 % of its variance are named without a bar; without any other, or where the
    work was stopped before, there is no such panel. Of work that was stopped the figure says so, and how many
    combinations were done; before two whole sets of samples are, it has no probability.

    Parameters
    ----------
    found : Tolerance
        As from `gearlash.tolerance`.
    title : str
        What the tolerances are of.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> case, speeds = gl.load_case("kahraman-singh"), gl.Axis.even("omega", 0.6, 0.9, 4)
    >>> found = gl.tolerance(case, speeds, {"load": (0.1, 0.3)}, samples=2, replicates=2)
    >>> len(plots.tolerance_bands(found).axes)
    2
    """
    shown = _shown(found)
    likely = found.complete or found.profile is not None
    heights = [*(HEIGHTS if likely else HEIGHTS[1:])]
    heights += [6.0 * len(shown.ranked) + 6.0] if shown.ranked else []
    said = [literal(title)] if title else []
    said += [] if found.complete else [_incomplete(found)]
    figure = style.figure(style.PAGE, sum(heights) + 38.0 + 6.0 * len(said) + 4.0 * len(shown.rest))
    panels = list(np.atleast_1d(figure.subplots(len(heights), 1, height_ratios=heights)))
    if likely:
        _probability(panels[0], found)
        panels[0].sharex(panels[1])
        panels[0].tick_params(labelbottom=False)
    _bands(panels[1 if likely else 0], found)
    if shown.ranked:
        _indices(panels[-1], found, shown)
    if said:
        panels[0].set_title("\n".join(said), pad=6.0)
    return figure


def _incomplete(found: Tolerance) -> str:
    """How much of what was planned is in the figure."""
    planned = found.corners + found.samples * found.replicates
    if found.tried >= planned:
        return "incomplete: stopped in the search for a worse combination, or for the shares of values"
    return f"incomplete: stopped when {found.tried} combinations were done, of {planned} planned"


def _probability(axes: Axes, found: Tolerance) -> None:
    """Between the solved ends of the samples' bands, and dots at the values of the axis."""
    if found.profile is not None:
        edges, share, error = (np.array(each) for each in vars(found.profile).values())
        low, high = _limits(share, error, found.drawn)
        axes.stairs(high, edges, baseline=low, fill=True, color="0.8", lw=0)
        axes.stairs(share, edges, baseline=None, color="black", lw=0.9)
    axes.plot(found.axis.values, found.probability, "o", color="black", ms=2.0)
    axes.set_ylim(-0.04, 1.04)
    axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    axes.set_ylabel("contact kept,\nprobability\n(grey: 95 % limits)")
    _present(axes, found)


def _limits(share: Numbers, error: Numbers, count: int) -> tuple[Numbers, Numbers]:
    """Between which probabilities lie, at 95 %: two standard errors; where all samples agree there is no
    error, and so many samples bound what it can be."""
    low, high = np.clip(share - 2.0 * error, 0.0, 1.0), np.clip(share + 2.0 * error, 0.0, 1.0)
    bound = least_chance(count)
    return np.where(share >= 1.0, bound, low), np.where(share <= 0.0, 1.0 - bound, high)


def _bands(axes: Axes, found: Tolerance) -> None:
    """Three rows: in all combinations, in the case itself, in none."""
    rows: list[tuple[tuple[Band, ...], str]] = [
        (found.always, FREE.colour),
        (found.nominal.bands, "0.6"),
        (found.never, DRIVE.colour),
    ]
    for at, (bands, colour) in enumerate(rows):
        if not bands:
            axes.text(0.01, at, "nowhere in the range", transform=axes.get_yaxis_transform(), **NOWHERE)
        for low, high in bands:
            axes.barh(at, high - low, BAR, low, color=colour, edgecolor="black", lw=0.4)
    axes.set_yticks(range(len(ROWS)), ROWS)
    axes.set_ylim(len(ROWS) - 0.5, -0.5)
    axes.tick_params(axis="y", length=0)
    axes.set_xlim(float(found.axis.values[0]), float(found.axis.values[-1]))
    table, _, leaf = found.axis.name.rpartition(".")
    name = (f"{table} {leaf}" if table in ("pinion", "gear") else leaf).replace("_", " ")
    axes.set_xlabel(literal(f"{name}  [{pretty(found.axis.unit)}]" if found.axis.unit else name))
    axes.set_ylabel("contact\nkept in")
    _present(axes, found)


def _present(axes: Axes, found: Tolerance) -> None:
    if found.axis.values[0] <= found.present <= found.axis.values[-1]:
        axes.axvline(found.present, color="black", lw=0.8, ls=(0, (5, 2)))


def _indices(axes: Axes, found: Tolerance, shown: _Shown) -> None:
    """Total Sobol indices of the margin at the present value, the largest first. A whisker goes no farther
    than a share can; where the samples leave it open, that is said and no bar is drawn."""
    rows = range(len(shown.ranked))
    totals = np.array([min(max(one.total, 0.0), 1.0) for one in shown.ranked])
    errors = np.array([one.total_error for one in shown.ranked])
    known = errors < UNKNOWN
    whiskers = np.array([np.minimum(errors, totals), np.minimum(errors, 1.0 - totals)])
    axes.barh(
        np.flatnonzero(known), totals[known], BAR, xerr=whiskers[:, known], color="0.75", edgecolor="black",
        lw=0.4, error_kw={"lw": 0.7},
    )  # fmt: skip
    for at in np.flatnonzero(~known):
        axes.text(0.01, float(at), "the samples tell nothing of its share", va="center", fontsize="small")
    axes.set_yticks(rows, [literal(found.sharing(one.path)) for one in shown.ranked])
    axes.set_ylim(len(totals) - 0.5, -0.5)
    axes.set_xlim(0.0, 1.0)
    axes.xaxis.set_major_formatter(PercentFormatter(1.0))
    label = "share of the variance of least over static compression at the dashed value, with interactions"
    axes.set_xlabel("\n".join([label, *shown.rest]))


@dataclass(frozen=True)
class _Shown:
    """Values with a bar, and the lines that name the others."""

    ranked: tuple[Influence, ...]
    rest: tuple[str, ...]


def _shown(found: Tolerance) -> _Shown:
    small = [one for one in found.influences if one.total < LEAST_BAR and one.total_error < LEAST_BAR]
    named = ", ".join(literal(found.sharing(one.path)) for one in small)
    rest = wrap(f"less than {LEAST_BAR:.0%} each: {named}".replace("%", " %"), LINE) if small else []
    return _Shown(tuple(one for one in found.influences if one not in small), tuple(rest))
