"""Tolerances: the probability that teeth stay in contact, over the bands that hold for all, some and none."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import PercentFormatter

from gearlash.case.units import pretty
from gearlash.results.tolerance import Band, Tolerance

from . import style
from .regimes import DRIVE, FREE
from .units import literal

ROWS = ("all tried", "as it is", "none tried")
HEIGHTS = (34.0, 18.0, 30.0)  # mm of probability, bands, indices
BAR = 0.62  # of a row


@style.styled
def tolerance_bands(found: Tolerance, title: str = "") -> Figure:
    """The probability of impact-free motion, the bands under it, and what each value makes of the margin.

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
    ranked = found.influences
    heights = [HEIGHTS[0], HEIGHTS[1], *([6.0 * len(ranked) + 6.0] if ranked else [])]
    figure = style.figure(style.PAGE, sum(heights) + 44.0)
    panels = list(figure.subplots(len(heights), 1, height_ratios=heights))
    _probability(panels[0], found)
    _bands(panels[1], found)
    panels[0].sharex(panels[1])
    panels[0].tick_params(labelbottom=False)
    if ranked:
        _indices(panels[2], found)
    if title:
        panels[0].set_title(literal(title), pad=6.0)
    return figure


def _probability(axes: Axes, found: Tolerance) -> None:
    """Between the solved ends of the samples' bands, and dots at the values of the axis."""
    if found.profile is not None:
        edges, share, error = (np.array(each) for each in vars(found.profile).values())
        low, high = np.clip(share - 2.0 * error, 0, 1), np.clip(share + 2.0 * error, 0, 1)
        axes.stairs(high, edges, baseline=low, fill=True, color="0.8", lw=0)
        axes.stairs(share, edges, baseline=None, color="black", lw=0.9)
    axes.plot(found.axis.values, found.probability, "o", color="black", ms=2.0)
    axes.set_ylim(-0.04, 1.04)
    axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    axes.set_ylabel("probability\n(grey: ± 2 std. errors)")
    _present(axes, found)


def _bands(axes: Axes, found: Tolerance) -> None:
    """Three rows: in all combinations, in the case itself, in none."""
    rows: list[tuple[tuple[Band, ...], str]] = [
        (found.always, FREE.colour),
        (found.nominal.bands, "0.6"),
        (found.never, DRIVE.colour),
    ]
    for at, (bands, colour) in enumerate(rows):
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


def _indices(axes: Axes, found: Tolerance) -> None:
    """Total Sobol indices of the margin at the present value, the largest first."""
    rows = range(len(found.influences))
    totals = [one.total for one in found.influences]
    errors = [one.total_error for one in found.influences]
    axes.barh(rows, totals, BAR, xerr=errors, color="0.75", edgecolor="black", lw=0.4, error_kw={"lw": 0.7})
    axes.set_yticks(rows, [literal(one.path) for one in found.influences])
    axes.set_ylim(len(totals) - 0.5, -0.5)
    axes.set_xlim(
        0.0, max(1.0, 1.1 * max(total + error for total, error in zip(totals, errors, strict=True)))
    )
    axes.xaxis.set_major_formatter(PercentFormatter(1.0))
    axes.set_xlabel("share of the variance of the least compression at the dashed value, with interactions")
