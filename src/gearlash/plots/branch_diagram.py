"""Branches of periodic orbits as the field draws them: solid where stable, dashed where not, with markers at
special points and a colour for every count of impacts."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from gearlash.system import GearlashError, given, read_label

from . import style
from .followed import MEASURES, Array, Followed, Piece, parameter, read
from .marks import TICKS
from .regimes import FREE, regime, short
from .swept import axis_name, swept
from .units import ASSUMED, Twin, Units, literal, name, second

COLOURS = (style.BLUE, style.VERMILION, style.GREEN, style.PURPLE, style.ORANGE, style.SKY)
FREE_COLOUR, OTHER_COLOUR = style.INK, style.GREY
DASHED = (0, (3.2, 1.6))
MARKERS = TICKS | {
    "joins the orbit of half its period": "<",
    "joins a symmetric orbit": ">",
    "end of existence": "*",
}
OTHER_MARKER = "X"
LOST = "not followed farther"
LIMITS = ("lower limit of the parameter", "upper limit of the parameter")
ORDINARY = (
    *LIMITS,
    "closed loop: the branch comes back to where it began",
    "joins the orbit of half its period",
)
MOST_NAMED = 5  # labels of one colour in the legend
CLOUD = "#b5b5b5"
LEAST_MODULUS = 1e-3  # of a multiplier that is drawn
WIDE = 4.0  # the modulus from which moduli are drawn over a logarithmic axis
IN_CLOUD = {"extremes": ("minimum", "maximum")}
PLACES = (0.5, 0.35, 0.65, 0.2, 0.8)  # along a stretch, where its label may stand
SHORTEST = 0.03  # of the width: a stretch that has a label
BESIDE = 0.012  # of the width, left and right
MARGIN = 0.1  # of the height of what attracts, above and below


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

    Solid lines are stable, dashed ones unstable; special points have markers; every signature, that is every
    count of impacts, has its colour. Lines go through the computed orbits and special points, smoothly in
    between.

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
        The physical scale of the parameter; without it that of ``units``.

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
    left, right = span or _limits(every, cloud)
    units = units or Units()
    heights = [78.0, 34.0] if multipliers else [78.0]
    figure = style.figure(style.PAGE, sum(heights) + 36.0)
    made = figure.subplots(len(heights), 1, sharex=True, height_ratios=heights, squeeze=False)
    panels: list[Axes] = list(made[:, 0])
    panels[0].set_xlim(left, right)
    colours, seen = _colours(every), [] if cloud is None else _behind(panels[0], cloud, measure)
    _branches(panels[0], every, measure, colours, seen)
    panels[0].set_ylabel(MEASURES[measure][0])
    second(panels[0], units.length if MEASURES[measure][1] == "length" else units.force, "y")
    if multipliers:
        _multipliers(panels[1], every, colours)
    panels[-1].set_xlabel(name(axis))
    twin = along or units.of_parameter(axis)
    second(panels[-1], twin, below=9.5)
    if title:
        panels[0].set_title(literal(title))
    shown = (twin, units.length if MEASURES[measure][1] == "length" else units.force)
    figure.legend(
        handles=[*_styles(every), *_labels(colours), *_kinds(every), *_cloud_key(cloud)],
        loc="outside lower center", ncols=4, columnspacing=1.4,
        title=ASSUMED if any(each is not None and each.assumed for each in shown) else None,
        title_fontsize=6.5,
    )  # fmt: skip
    return figure


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
    room = BESIDE * (high - low)
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
            look = {"s": 0.8, "c": CLOUD, "linewidths": 0.0, "zorder": 1.0, "rasterized": True}
            panel.scatter(*drawn[-1], **look)
    return drawn


def _fit(panel: Axes, seen: Sequence[tuple[Array, Array]], pieces: Sequence[Piece]) -> None:
    """As high as what attracts: unstable branches may leave the picture, unless there is nothing else."""
    stable = [piece for piece in pieces if piece.stable]
    drawn = [*seen, *((p.values, p.y) for p in (stable if stable or seen else pieces))]
    left, right = panel.get_xlim()
    inside = [y[(x >= left) & (x <= right)].ravel() for x, y in drawn]
    heights = np.concatenate(inside)
    heights = heights[np.isfinite(heights)]
    if len(heights):
        room = MARGIN * max(float(np.ptp(heights)), 1e-9 * max(1.0, float(np.abs(heights).max())))
        panel.set_ylim(float(heights.min()) - room, float(heights.max()) + room)


def _colours(every: Sequence[xr.Dataset]) -> dict[str, str]:
    """A colour for every label, those without impacts in black, others in the order in which they are met."""
    labels = dict.fromkeys(str(label) for dataset in every for label in dataset["label"].values)
    left, found = list(COLOURS), {}
    for label in labels:
        if regime(read_label(label)) is FREE:
            found[label] = FREE_COLOUR
        else:
            found[label] = left.pop(0) if left else OTHER_COLOUR
    return found


def _branches(
    panel: Axes,
    every: Sequence[xr.Dataset],
    measure: str,
    colours: dict[str, str],
    seen: Sequence[tuple[Array, Array]],
) -> None:
    """Lines, markers and labels, in a picture as high as these and what is ``seen`` behind them need."""
    drawn = []
    for dataset in every:
        special = read(dataset, measure, "special_")
        pieces = list(Followed.of(dataset, read(dataset, measure), special).pieces())
        drawn += pieces
        for piece in pieces:
            _line(panel, piece, colours)
        for kind, value, heights in zip(
            dataset["special_kind"].values, dataset["special_value"].values, special, strict=True
        ):
            _mark(panel, MARKERS.get(str(kind), OTHER_MARKER), float(value), heights)
        for at in (0, -1):
            if str(dataset["end_kind"].values[at]) not in ORDINARY:
                _mark(panel, OTHER_MARKER, float(dataset["end_value"].values[at]), read(dataset, measure)[at])
    _fit(panel, seen, drawn)
    _words(panel, drawn, colours)


def _line(panel: Axes, piece: Piece, colours: dict[str, str]) -> None:
    look = {"color": colours.get(piece.label, OTHER_COLOUR), "ls": "-" if piece.stable else DASHED}
    panel.plot(piece.values, piece.y, lw=1.1 if piece.stable else 0.9, zorder=3.0, **look)


def _mark(panel: Axes, marker: str, value: float, heights: Array) -> None:
    shown = heights[np.isfinite(heights)]
    panel.plot(
        np.full(len(shown), value), shown, ls="none", marker=marker, ms=4.2, mew=0.7, color=style.INK,
        mfc="white", zorder=5.0,
    )  # fmt: skip


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
            _line(panel, piece, colours)
    panel.set_ylabel("multipliers,  modulus")


def _words(panel: Axes, pieces: Sequence[Piece], colours: dict[str, str]) -> None:
    """Every label once, beside its longest stretch, where there is room: colours need not be told apart."""
    left, right = panel.get_xlim()
    longest: dict[str, Piece] = {}
    for piece in (each.within(left, right) for each in pieces):
        known = longest.get(piece.label)
        if known is None or (piece.stable, piece.length) > (known.stable, known.length):
            longest[piece.label] = piece
    width, (low, high) = float(np.ptp(panel.get_xlim())), panel.get_ylim()
    placed: list[tuple[float, float]] = []
    for label, piece in longest.items():
        if piece.length < SHORTEST * width:
            continue
        for share in PLACES:
            at = int(share * (len(piece.values) - 1))
            x, y = float(piece.values[at]), float(np.nanmax(piece.y[at]))
            apart = all(abs(x - u) > 0.07 * width or abs(y - v) > 0.045 * (high - low) for u, v in placed)
            if apart and low < y < high:
                placed.append((x, y))
                _word(panel, label, x, y, colours)
                break


def _word(panel: Axes, label: str, x: float, y: float, colours: dict[str, str]) -> None:
    panel.annotate(
        short(label), (x, y), (0.0, 3.0), textcoords="offset points", ha="center", va="bottom",
        fontsize=6.5, zorder=2.0, color=colours.get(label, OTHER_COLOUR),
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4, "alpha": 0.8},
    )  # fmt: skip


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
        shared.setdefault(colour, []).append(short(label))
    return [Line2D([], [], color=colour, lw=2.2, label=_listed(words)) for colour, words in shared.items()]


def _listed(words: Sequence[str]) -> str:
    left = len(words) - MOST_NAMED
    return ", ".join(words[:MOST_NAMED]) + (f" and {left} more" if left > 0 else "")


def _kinds(every: Sequence[xr.Dataset]) -> list[Line2D]:
    look = {"ls": "none", "color": style.INK, "mfc": "white", "ms": 4.2, "mew": 0.7}
    kinds = dict.fromkeys(str(kind) for dataset in every for kind in dataset["special_kind"].values)
    found = [Line2D([], [], marker=MARKERS.get(kind, OTHER_MARKER), label=kind, **look) for kind in kinds]
    if any(str(kind) not in ORDINARY for dataset in every for kind in dataset["end_kind"].values):
        found.append(Line2D([], [], marker=OTHER_MARKER, label=LOST, **look))
    return found


def _cloud_key(cloud: xr.Dataset | None) -> list[Line2D]:
    if cloud is None:
        return []
    ways = ", ".join(way.direction for way in swept(cloud))
    return [Line2D([], [], ls="none", marker="o", ms=2.4, mew=0.0, color=CLOUD, label=f"swept: {ways}")]
