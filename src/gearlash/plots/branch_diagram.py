"""Branches of periodic orbits as the field draws them: solid where stable, dashed where not, with markers at
special points and a colour for every count of impacts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from gearlash.system import GearlashError, given, read_label

from . import style
from .branch_lines import (
    DASHED,
    MARKER,
    MARKERS,
    ORDINARY,
    OTHER_COLOUR,
    OTHER_MARKER,
    Shown,
    cut,
    edge_lines,
    edges_of,
    fit,
    labels,
    line,
    pieces,
    special,
    special_heights,
)
from .followed import MEASURES, Array, Followed, parameter
from .legends import legend_below
from .regimes import FREE, regime
from .room import Room
from .scales import scales
from .swept import axis_name, swept
from .units import ASSUMED, Twin, Units, literal, second
from .words import words

COLOURS = (style.BLUE, style.VERMILION, style.GREEN, style.PURPLE, style.ORANGE, style.SKY)
FREE_COLOUR = style.INK
LOST = "not followed farther"
MOST_NAMED = 5  # labels of one colour in the legend
CLOUD = "#b4b4b4"
LEAST_MODULUS = 1e-3  # of a multiplier that is drawn
WIDE = 4.0  # the modulus from which moduli are drawn over a logarithmic axis
IN_CLOUD = {"extremes": ("minimum", "maximum")}
ROOM = 0.012  # of the width, left and right
TALL, LOW = 84.0, 34.0  # mm: heights of the panels
LEGEND = 15.0  # mm: height of it that the figure is made for
INNER = 158.0  # mm: width of a panel without its words, at least


@style.styled
def branch_diagram(
    datasets: Sequence[xr.Dataset],
    measure: str = "extremes",
    *,
    cloud: xr.Dataset | None = None,
    multipliers: bool = False,
    title: str = "",
    span: Sequence[float] = (),
    units: Units | None = None,
    along: Twin | None = None,
) -> Figure:
    """One or several branches of periodic orbits over their parameter.

    Solid lines are stable, dashed ones unstable; special points have markers under them, with their numbers
    as in the table where there is room (of several branches with that of the branch before it: 2.1); every
    signature, that is every count of impacts, has its colour. Lines go through the computed orbits and
    special points, smoothly in between. Thin lines are the boundaries of the gap of the first clearance.

    Parameters
    ----------
    datasets : sequence of xarray.Dataset
        Of `gearlash.branch_dataset`, all over the same parameter.
    measure : str
        What stands on the y axis: ``extremes`` (least and largest X), ``minimum``, ``maximum``, ``amplitude``
        (half the span of X), ``strobes`` (X on σ_t), ``force_max``, ``force_min`` or ``force_rms``.
    cloud : xarray.Dataset, optional
        Of `gearlash.sweep_dataset`, over the same parameter: its points lie in grey behind the branches.
    multipliers : bool
        Whether a second panel has the moduli of all multipliers.
    title : str
        What the branches are of.
    span : sequence of float
        First and last value of the parameter that are shown; all of it where nothing is given.
    units : Units, optional
        Second axes in physical units: `Units.of` a case.
    along : Twin, optional
        The unit in which the parameter was asked for: it stands first, the dimensionless value below it.
        Without it that of ``units`` is the second scale.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    GearlashError
        For datasets that do not go together, and a measure that there is not.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> figure = plots.branch_diagram([gl.branch_dataset(case, branch)], multipliers=True)
    >>> len(figure.axes)
    2
    """
    given.known("measure", measure, MEASURES)
    every, axis = list(datasets), _common(datasets, cloud)
    if span and not (len(span) == 2 and span[0] < span[1]):
        raise GearlashError(f"span = {tuple(span)}: expected a first and a larger last value")
    units = units or Units()
    heights = [TALL, LOW] if multipliers else [TALL]
    figure = style.figure(style.PAGE, sum(heights) + 36.0)
    made = figure.subplots(len(heights), 1, sharex=True, height_ratios=heights, squeeze=False)
    panels: list[Axes] = list(made[:, 0])
    panels[0].set_xlim(*(span or _limits(every, cloud)))
    colours, seen = _colours(every, panels[0]), [] if cloud is None else _behind(panels[0], cloud, measure)
    shown = _branches(panels[0], every, measure, colours, seen)
    panels[0].set_ylabel(MEASURES[measure][0])
    up = units.length if MEASURES[measure][1] == "length" else units.force
    second(panels[0], up, "y")
    if multipliers:
        _multipliers(panels[1], every, colours)
    twin = units.asked(axis, along)
    scales(panels[-1], "x", words(every[0], units).name(axis), twin, first=along is not None)
    if title:
        panels[0].set_title(literal(title))
    assumed = any(each is not None and each.assumed for each in (twin, up))
    handles = [*_styles(every), *_labels(colours), *_kinds(every), *_cloud_key(cloud)]
    told = " ".join([_said(shown, several=len(every) > 1), *([ASSUMED] if assumed else [])]).strip()
    legend_below(figure, handles, told or None, columns=4, room=LEGEND)
    return figure


def _said(shown: Shown, *, several: bool) -> str:
    """What the numbers are, how many have no room, and which branches leave the picture."""
    row = "branch.number in its table" if several else "rows of the table"
    said = [f"Numbers: {row}" if shown.numbered else "Numbers have no room"] if shown.inside else []
    if shown.numbered < shown.inside:
        said.append(f"{shown.numbered} of {shown.inside} special points shown have one")
    if shown.marked < shown.inside:
        left = shown.inside - shown.marked
        many = "1 marker is left out where it" if left == 1 else f"{left} markers are left out where they"
        said.append(f"{many} would hide the lines")
    text = "; ".join([*said, *([shown.cut] if shown.cut else [])])
    return f"{text[0].upper()}{text[1:]}." if text else ""


def _common(every: Sequence[xr.Dataset], cloud: xr.Dataset | None) -> str:
    """The parameter of all of them. Raises `GearlashError` where it is not one."""
    axes = {parameter(dataset): str(dataset.attrs["axis"]) for dataset in every}
    if cloud is not None:
        given.instance("cloud", cloud, xr.Dataset, "a dataset, as from gearlash.sweep_dataset")
        axes |= {axis_name(cloud): str(cloud.attrs.get("axis", axis_name(cloud)))}
    if len(set(axes.values())) > 1:
        raise GearlashError(f"over different parameters: {', '.join(axes.values())}")
    return next(iter(axes.values()))


def _limits(every: Sequence[xr.Dataset], cloud: xr.Dataset | None) -> tuple[float, float]:
    """Of the parameter, with a little room at the ends for markers."""
    values = [dataset[parameter(dataset)].values for dataset in every]
    if cloud is not None:
        values.append(cloud[axis_name(cloud)].values)
    low, high = (float(end(np.concatenate(values))) for end in (np.min, np.max))
    room = ROOM * (high - low)
    return low - room, high + room


def _behind(panel: Axes, cloud: xr.Dataset, measure: str) -> list[tuple[Array, Array]]:
    """What a sweep found, in grey; values and heights of it."""
    drawn = []
    for way in swept(cloud):
        values = cloud[axis_name(cloud)].values
        one = cloud.sel(direction=way.direction)
        names = IN_CLOUD.get(measure, (measure,))
        tables = [one[each].values.reshape(len(values), -1) for each in names if each in one]
        if measure == "amplitude":
            tables = [0.5 * (one["maximum"].values - one["minimum"].values)[:, None]]
        for table in tables:
            shown = np.isfinite(table)
            x = np.broadcast_to(values[:, None], table.shape)[shown]
            drawn.append((x, table[shown]))
            look = {"s": 1.6, "c": CLOUD, "linewidths": 0.0, "zorder": 1.0, "rasterized": True}
            panel.scatter(*drawn[-1], **look)
    return drawn


def _colours(every: Sequence[xr.Dataset], panel: Axes) -> dict[str, str]:
    """A colour for every label in the picture, those without impacts in black, others in the order in which
    they are met."""
    limits = panel.get_xlim()
    found, left = dict[str, str](), list(COLOURS)
    for dataset in every:
        values = dataset[parameter(dataset)].values
        inside = dataset["label"].values[(values >= limits[0]) & (values <= limits[1])]
        for label in dict.fromkeys(map(str, inside)):
            if label not in found and regime(read_label(label)) is FREE:
                found[label] = FREE_COLOUR
            elif label not in found:
                found[label] = left.pop(0) if left else OTHER_COLOUR
    return found


def _branches(
    panel: Axes,
    every: Sequence[xr.Dataset],
    measure: str,
    colours: dict[str, str],
    seen: Sequence[tuple[Array, Array]],
) -> Shown:
    """Lines, markers and labels, in a picture as high as these and what is ``seen`` behind them need."""
    drawn, edges = pieces(every, measure), []
    if MEASURES[measure][1] == "length" and measure != "amplitude":
        edges = edges_of(every)
    for piece in drawn:
        line(panel, piece, colours)
    fit(panel, seen, drawn, [*(table for _, table in edges), special_heights(every, measure)])
    room = Room(panel, INNER, TALL)
    for piece in drawn:
        for column in piece.y.T:
            room.fill(piece.values, column)
    edge_lines(panel, room, edges)
    shown = special(panel, room, every, measure)
    labels(panel, room, drawn, colours)
    return replace(shown, cut=cut(panel, drawn))


def _multipliers(panel: Axes, every: Sequence[xr.Dataset], colours: dict[str, str]) -> None:
    """Moduli of all multipliers; outside the unit circle they stand above the line at 1."""
    panel.axhline(1.0, color=style.INK, lw=0.6)
    highest = max(float(dataset["multiplier_modulus"].max()) for dataset in every)
    if highest > WIDE:
        panel.set_yscale("log")
        panel.yaxis.set_major_locator(LogLocator(subs=(1.0,), numticks=8))
        panel.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        panel.yaxis.set_minor_formatter(NullFormatter())
    for dataset in every:
        modulus, special = (
            np.maximum(dataset[f"{of}multiplier_modulus"].values, LEAST_MODULUS) for of in ("", "special_")
        )
        for piece in Followed.of(dataset, modulus, special).pieces():
            line(panel, piece, colours)
    panel.set_ylabel("multipliers,  modulus")


def _styles(every: Sequence[xr.Dataset]) -> list[Line2D]:
    stable = np.concatenate([dataset["unstable"].values == 0 for dataset in every])
    found = []
    if stable.any():
        found.append(Line2D([], [], color=style.INK, lw=1.1, label="stable"))
    if not stable.all():
        found.append(Line2D([], [], color=style.INK, lw=0.9, ls=DASHED, label="unstable"))
    return found


def _labels(colours: dict[str, str]) -> list[Line2D]:
    """Labels of one colour stand in one entry."""
    shared: dict[str, list[str]] = {}
    for label, colour in colours.items():
        shared.setdefault(colour, []).append(label)
    return [Line2D([], [], color=colour, lw=2.2, label=_listed(words)) for colour, words in shared.items()]


def _listed(words: Sequence[str]) -> str:
    left = len(words) - MOST_NAMED
    return ", ".join(words[:MOST_NAMED]) + (f" and {left} more" if left > 0 else "")


def _kinds(every: Sequence[xr.Dataset]) -> list[Line2D]:
    kinds = dict.fromkeys(str(kind) for dataset in every for kind in dataset["special_kind"].values)
    found = [Line2D([], [], marker=MARKERS.get(kind, OTHER_MARKER), label=kind, **MARKER) for kind in kinds]
    if any(str(kind) not in ORDINARY for dataset in every for kind in dataset["end_kind"].values):
        found.append(Line2D([], [], marker=OTHER_MARKER, label=LOST, **MARKER))
    return found


def _cloud_key(cloud: xr.Dataset | None) -> list[Line2D]:
    if cloud is None:
        return []
    ways = ", ".join(way.direction for way in swept(cloud))
    return [Line2D([], [], ls="none", marker="o", ms=2.4, mew=0.0, color=CLOUD, label=f"swept: {ways}")]
