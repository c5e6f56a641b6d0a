"""The bifurcation diagram of a sweep: labels, X on σ_t, contact force on σ_d and σ_b, largest exponent."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from gearlash.system import Signature

from . import style
from .legends import legend_below
from .marks import LINES, OTHER_LINE, OTHER_TICK, TICKS, Mark, height, lines, texts
from .regimes import FREE
from .strip import OVER_LINES, key, strip
from .swept import Swept, axis_name, differs, swept
from .units import ASSUMED, EXPONENT, ForceAxis, Twin, Units, literal, rests, second
from .words import words

# How the directions look: colour, marker, size of a point (pt²), order of drawing.
DIRECTION_STYLES = {
    "cold": (style.INK, "o", 0.55, 2.0),
    "up": (style.BLUE, "^", 3.2, 3.0),
    "down": (style.VERMILION, "v", 3.2, 3.0),
}
TALLEST = 184.0  # mm: of all panels and the texts above them
LOWEST = 0.6  # of its height: a panel is not made lower
WIDTH = 146.0  # mm of the panels of a figure of page width: what is left beside the labels
LEGEND = 15.0  # mm: height of it that the figure is made for
DENSE = 700  # values of an axis from which points are smallest, and not joined
LARGEST_DOT = 14.0  # times that size, of the points of a coarse axis
NOTHING = 1e-12  # contact force that is rounding
LEAST_SPAN = 1e-6  # per unit of τ: of the axis of exponents, which would show rounding otherwise
PRESENT: dict[str, Any] = {"color": style.VERMILION, "lw": 1.0, "ls": (0, (5, 2))}
BACK = ("back_force", "back_release_force")  # impacts, and releases, which are drawn paler
AGREEING = " (also up and down, where not drawn)"


@style.styled
def diagram(
    dataset: xr.Dataset,
    marks: Sequence[Mark] = (),
    units: Units | None = None,
    force: ForceAxis | None = None,
    title: str = "",
    present: float | None = None,
    asked: Twin | None = None,
    apart: Sequence[NDArray[np.bool_]] = (),
) -> Figure:
    """The bifurcation diagram of sweeps: labels, sections and largest exponent over the parameter.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of `gearlash.sweep_dataset`.
    marks : sequence of Mark
        Special points on the axis.
    units : Units, optional
        Second axes in physical units: `Units.of` a case.
    force : ForceAxis, optional
        Symbol and sign of the contact force; Φ where nothing is given.
    title : str
        What is swept.
    present : float, optional
        The dimensionless value of the case itself, for a line there.
    asked : Twin, optional
        The scale that the parameter was asked for in: it takes the place of the dimensionless one.
    apart : sequence of ndarray of bool, shape (m-1,), optional
        Of every direction the steps over which its motion changes to another one, where no line joins its
        points. Without, what the points alone tell: of one motion that is steep on a coarse axis too many.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    GearlashError
        For a dataset without any motion; `UnknownNameError` for one without directions.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> case = gl.load_case("kahraman-singh")
    >>> done = gl.sweep(case, gl.Axis.even("omega", 0.5, 0.6, 3))
    >>> figure = plots.diagram(gl.sweep_dataset(case, [done]))
    >>> len(figure.axes)
    6
    """
    force = force or ForceAxis()
    axis = axis_name(dataset)
    asked = asked or (units or Units()).alone(axis)
    factor = 1.0 if asked is None else asked.factor
    rows = [replace(row, values=factor * row.values) for row in swept(dataset, apart)]
    marks = [replace(mark, value=factor * mark.value) for mark in marks]
    shown = new_points(rows)
    forces = [5.0 if flat(rows, which) else 34.0 for which in (("drive_force",), BACK)]
    heights = _fitted([height(marks), 4.6 * len(rows), 50.0, *forces, 30.0])
    figure = style.figure(style.PAGE, sum(heights) + 38.0)
    panels: list[Axes] = list(figure.subplots(6, 1, sharex=True, height_ratios=heights))
    band, bars, *rest = panels
    values = np.concatenate([row.values for row in rows])
    panels[0].set_xlim(*sorted((float(values.min()), float(values.max()))))
    texts(band, marks, WIDTH)
    band.set_title(literal(title), pad=4.0)
    seen = strip(bars, rows, WIDTH)
    _points(rest[0], rows, shown, ("strobes",), r"$X_n$  on  $\sigma_t$")
    _points(rest[1], rows, shown, ("drive_force",), f"{force.symbol}  on  $\\sigma_d$", force.sign)
    _points(rest[2], rows, shown, BACK, f"{force.symbol}  on  $\\sigma_b$", force.sign)
    _exponents(rest[3], rows, shown)
    scales = units or Units()
    for panel, scale in zip(rest, (scales.length, scales.force, scales.force), strict=False):
        if len(panel.get_yticks()):
            second(panel, scale, "y")
    _shade(rest, rows)
    here = list(_present(panels[1:], present, factor))
    lines(panels[1:], marks)
    for panel in rest:
        panel.tick_params(which="both", top=True)
    bars.tick_params(which="both", bottom=False, top=False)
    twin = (units or Units()).of_parameter(axis) if asked is None else asked
    rest[3].set_xlabel(words(dataset, units).name(axis) if asked is None else asked.label)
    second(rest[3], twin if asked is None else None, below=9.5)
    style.align_labels(rest)
    handles = [*directions(rows, shown), *_mark_kinds(marks), *here, *key(seen)]
    told = ASSUMED if rests(twin, scales.length, scales.force) else None
    legend_below(figure, handles, told, columns=4, room=LEGEND)
    return figure


def _fitted(heights: list[float]) -> list[float]:
    """With panels, the last ones, as low as a sheet asks for that has the caption, too."""
    above, panels = heights[:2], heights[2:]
    share = min(1.0, (TALLEST - sum(above)) / sum(panels))
    return [*above, *(max(share, LOWEST) * each for each in panels)]


def new_points(rows: list[Swept]) -> list[NDArray[np.bool_]]:
    """Per direction, the axis values at which it shows another attractor than the first one."""
    return [np.ones(len(rows[0].values), dtype=bool), *(differs(b, rows[0]) for b in rows[1:])]


def _points(
    panel: Axes,
    rows: list[Swept],
    shown: list[NDArray[np.bool_]],
    arrays: tuple[str, ...],
    label: str,
    sign: float = 1.0,
) -> None:
    """The arrays, times ``sign``, of every direction in one panel."""
    if flat(rows, arrays):
        drawn = any(np.isfinite(getattr(way, array)).any() for way in rows for array in arrays)
        what = "zero at every impact of" if drawn else "no impact was found in"
        _empty(panel, f"{label}:  {what} these sweeps")
        return
    for way, keep in zip(rows, shown, strict=True):
        for array in arrays:
            x, y = way.points(array, keep)
            scatter(panel, way.direction, x, sign * y, hollow=array == BACK[1], larger=dot_size(way))
            along(panel, way, array, keep, sign)
    panel.set_ylabel(label)
    panel.margins(y=0.06)
    if arrays == BACK:
        _told_apart(panel, sign)


def flat(rows: Sequence[Swept], arrays: tuple[str, ...]) -> bool:
    """Whether there is nothing in these arrays, or only zero: no axis is to magnify that."""
    most = (
        float(np.abs(np.nan_to_num(getattr(way, array))).max(initial=0.0)) for way in rows for array in arrays
    )
    return max(most, default=0.0) <= NOTHING


def _empty(panel: Axes, text: str) -> None:
    """Says that there is nothing to draw."""
    panel.set_yticks([])
    panel.text(
        0.5,
        0.45,
        text,
        transform=panel.transAxes,
        ha="center",
        va="center_baseline",
        color=style.GREY,
        zorder=OVER_LINES,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
    )


def _told_apart(panel: Axes, sign: float) -> None:
    """Impacts and releases of the back side, on either side of zero: Φ is negative at its impacts, as X falls
    there, and positive at its releases."""
    panel.axhline(0.0, color=style.GREY, lw=0.5)
    impacts, releases = "impacts, S2 → S3", "releases, S3 → S2"
    above, below = (releases, impacts) if sign > 0.0 else (impacts, releases)
    for y, text in ((0.96, above), (0.04, below)):
        panel.text(
            0.99,
            y,
            text,
            transform=panel.transAxes,
            ha="right",
            va="top" if y > 0.5 else "bottom",
            fontsize=7,
            color=style.GREY,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
            zorder=4,
        )


def scatter(
    panel: Axes,
    direction: str,
    x: NDArray[np.float64],
    y: NDArray[np.float64],
    hollow: bool = False,
    larger: float = 1.0,
) -> None:
    """Points of one direction in its look, as a picture of print resolution inside the vector file;
    ``larger``: than usual, in area."""
    colour, marker, size, order = DIRECTION_STYLES.get(direction, DIRECTION_STYLES["cold"])
    panel.scatter(
        x,
        y,
        s=size * larger,
        marker=marker,
        facecolors=colour,
        edgecolors="none",
        linewidths=0.0,
        zorder=order,
        rasterized=True,
        alpha=0.6 if hollow else 1.0,
    )


def dot_size(way: Swept) -> float:
    """By how much, in area, points of a coarse axis are drawn larger: so that they show."""
    return min(LARGEST_DOT, max(1.0, (DENSE / max(len(way.values), 1)) ** 1.2))


def along(panel: Axes, way: Swept, array: str, keep: NDArray[np.bool_], sign: float = 1.0) -> None:
    """On a coarse axis, lines along periodic motions; none where they change over to another, or where the
    number of points that are drawn changes."""
    periodic = np.array([isinstance(label, Signature) for label in way.labels], dtype=bool)
    table = np.where((periodic & keep)[:, None], sign * np.sort(getattr(way, array), axis=1), np.nan)
    table = table[:, np.isfinite(table).any(axis=0)]
    if len(way.values) > DENSE or not table.size:
        return
    more = np.diff(np.isfinite(table).sum(axis=1)) != 0
    at = np.flatnonzero(way.apart | more) + 1
    colour = DIRECTION_STYLES.get(way.direction, DIRECTION_STYLES["cold"])[0]
    x, y = np.insert(way.values, at, np.nan), np.insert(table, at, np.nan, axis=0)
    panel.plot(x, y, color=colour, lw=0.5, zorder=1.5)


def _shade(panels: Sequence[Axes], rows: list[Swept]) -> None:
    """Behind the points: values at which every direction found a motion without impacts."""
    quiet = (
        np.all(
            [[isinstance(label, Signature) and label.impacts == 0 for label in row.labels] for row in rows],
            axis=0,
        )
        if len({len(row.values) for row in rows}) == 1
        else np.zeros(0, dtype=bool)
    )
    if not len(quiet):
        return
    edges, flags = rows[0].edges(), np.concatenate([[False], quiet, [False]]).astype(np.int8)
    for low, high in zip(
        np.flatnonzero(np.diff(flags) == 1), np.flatnonzero(np.diff(flags) == -1), strict=True
    ):
        for panel in panels:
            panel.axvspan(edges[low], edges[high], facecolor=FREE.colour, alpha=0.45, lw=0.0, zorder=0.1)


def _present(panels: Sequence[Axes], value: float | None, factor: float) -> Iterator[Line2D]:
    """A line where the case itself is, if that is in the range."""
    if value is None:
        return
    low, high = panels[0].get_xlim()
    if low <= factor * value <= high:
        for panel in panels:
            panel.axvline(factor * value, zorder=4, **PRESENT)
        yield Line2D([], [], label="present value", **PRESENT)


def _exponents(panel: Axes, rows: list[Swept], shown: list[NDArray[np.bool_]]) -> None:
    panel.axhline(0.0, color=style.INK, lw=0.6)
    panel.set_ylabel(EXPONENT)
    lowest, highest = [], []
    for way, keep in zip(rows, shown, strict=True):
        colour, marker, size, order = DIRECTION_STYLES.get(way.direction, DIRECTION_STYLES["cold"])
        keep = keep & np.isfinite(way.exponent)
        x, y, bar = way.values[keep], way.exponent[keep], way.exponent_error[keep]
        lowest.append(y)
        highest.append(y + np.nan_to_num(bar))
        panel.scatter(
            x,
            y,
            s=max(size, 1.2) * dot_size(way) ** 0.5,
            marker=marker,
            facecolors=colour,
            linewidths=0.0,
            zorder=order,
        )
        with_bar = bar > 0.0
        panel.errorbar(
            x[with_bar], y[with_bar], bar[with_bar], fmt="none", ecolor=colour, elinewidth=0.5, capsize=0.0
        )
    values = np.concatenate(lowest)
    low, high = min(float(np.quantile(values, 0.01)), 0.0), max(float(np.concatenate(highest).max()), 0.0)
    room = max(high - low, LEAST_SPAN)
    panel.set_ylim(high - 1.08 * room, high + 0.12 * room)


def directions(rows: list[Swept], shown: list[NDArray[np.bool_]] | None = None) -> list[Line2D]:
    """Legend entries of the directions; with ``shown``, of what is drawn of each."""
    handles = []
    for i, way in enumerate(rows):
        colour, marker, _, _ = DIRECTION_STYLES.get(way.direction, DIRECTION_STYLES["cold"])
        text = "cold start" if way.direction == "cold" else f"swept {way.direction}"
        if shown is not None and i == 0 and len(rows) > 1:
            text += AGREEING
        elif shown is not None and not shown[i].any():
            text += ": nowhere different"
        size = 2.2 if way.direction == "cold" else 3.6
        handles.append(Line2D([], [], ls="none", marker=marker, color=colour, ms=size, mew=0.0, label=text))
    return handles


def _mark_kinds(marks: Sequence[Mark]) -> list[Line2D]:
    kinds = dict.fromkeys(m.kind for m in marks)
    look = {"color": style.INK, "lw": 0.7, "ms": 2.8, "mew": 0.0}
    return [
        Line2D([], [], ls=LINES.get(k, OTHER_LINE), marker=TICKS.get(k, OTHER_TICK), label=k, **look)
        for k in kinds
    ]
