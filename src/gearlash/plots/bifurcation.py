"""The bifurcation diagram of a sweep: labels, X on σ_t, contact force on σ_d and σ_b, largest exponent."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from . import style
from .marks import LINES, OTHER_LINE, OTHER_TICK, TICKS, Mark, height, lines, texts
from .strip import key, strip
from .swept import Swept, axis_name, differs, swept
from .units import ASSUMED, EXPONENT, ForceAxis, Units, second
from .words import words

# How the directions look: colour, marker, size of a point (pt²), order of drawing.
DIRECTION_STYLES = {
    "cold": (style.INK, "o", 0.55, 2.0),
    "up": (style.BLUE, "^", 3.2, 3.0),
    "down": (style.VERMILION, "v", 3.2, 3.0),
}
WIDTH = 146.0  # mm of the panels of a figure of page width: what is left beside the labels
BACK = ("back_force", "back_release_force")  # impacts, and releases, which are drawn paler
AGREEING = " (also up and down, where not drawn)"


@style.styled
def diagram(
    dataset: xr.Dataset,
    marks: Sequence[Mark] = (),
    units: Units | None = None,
    force: ForceAxis | None = None,
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
    rows = swept(dataset)
    axis = axis_name(dataset)
    shown = new_points(rows)
    back = any(np.isfinite(b.back_force).any() for b in rows)
    heights = [height(marks), 4.6 * len(rows), 50.0, 34.0, 34.0 if back else 5.0, 30.0]
    figure = style.figure(style.PAGE, sum(heights) + 38.0)
    panels: list[Axes] = list(figure.subplots(6, 1, sharex=True, height_ratios=heights))
    band, bars, *rest = panels
    values = np.concatenate([row.values for row in rows])
    panels[0].set_xlim(float(values.min()), float(values.max()))
    texts(band, marks, WIDTH)
    seen = strip(bars, rows, WIDTH)
    _points(rest[0], rows, shown, ("strobes",), r"$X_n$  on  $\sigma_t$")
    _points(rest[1], rows, shown, ("drive_force",), f"{force.symbol}  on  $\\sigma_d$", force.sign)
    _points(rest[2], rows, shown, BACK, f"{force.symbol}  on  $\\sigma_b$", force.sign)
    _exponents(rest[3], rows, shown)
    lines(panels[1:], marks)
    for panel in rest:
        panel.tick_params(which="both", top=True, right=True)
    bars.tick_params(which="both", bottom=False, top=False)
    rest[3].set_xlabel(words(dataset, units).name(axis))
    twin = (units or Units()).of_parameter(axis)
    second(rest[3], twin, below=9.5)
    style.align_labels(rest)
    handles = [*directions(rows, shown), *_mark_kinds(marks), *key(seen)]
    figure.legend(
        handles=handles, loc="outside lower center", ncols=4, columnspacing=1.4,
        title=ASSUMED if twin is not None and twin.assumed else None, title_fontsize=6.5,
    )  # fmt: skip
    return figure


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
    drawn = 0
    for way, keep in zip(rows, shown, strict=True):
        for array in arrays:
            x, y = way.points(array, keep)
            drawn += len(x)
            scatter(panel, way.direction, x, sign * y, hollow=array == BACK[1])
    if not drawn:
        _empty(panel, label)
        return
    panel.set_ylabel(label)
    panel.margins(y=0.06)
    if arrays == BACK:
        _told_apart(panel, sign)


def _empty(panel: Axes, label: str) -> None:
    """Says that there is nothing to draw."""
    panel.set_yticks([])
    panel.text(
        0.5,
        0.45,
        f"{label}:  no impact was found in these sweeps",
        transform=panel.transAxes,
        ha="center",
        va="center_baseline",
        color=style.GREY,
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


def _exponents(panel: Axes, rows: list[Swept], shown: list[NDArray[np.bool_]]) -> None:
    panel.axhline(0.0, color=style.INK, lw=0.6)
    panel.set_ylabel(EXPONENT)
    lowest = []
    for way, keep in zip(rows, shown, strict=True):
        colour, marker, size, order = DIRECTION_STYLES.get(way.direction, DIRECTION_STYLES["cold"])
        keep = keep & np.isfinite(way.exponent)
        x, y, bar = way.values[keep], way.exponent[keep], way.exponent_error[keep]
        lowest.append(y)
        panel.scatter(x, y, s=max(size, 1.2), marker=marker, facecolors=colour, linewidths=0.0, zorder=order)
        with_bar = bar > 0.0
        panel.errorbar(
            x[with_bar], y[with_bar], bar[with_bar], fmt="none", ecolor=colour, elinewidth=0.5, capsize=0.0
        )
    values = np.concatenate(lowest)
    low, high = float(np.quantile(values, 0.01)), float(values.max())
    room = high - low if high > low else max(abs(high), 1e-3)
    panel.set_ylim(low - 0.08 * room, high + 0.12 * room)


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
