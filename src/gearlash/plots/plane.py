"""A map: which motion belongs to which pair of values of two parameters."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap, to_hex, to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray
from scipy import ndimage

from gearlash.results.contact_words import sided
from gearlash.system import GearlashError, Label, Signature, UnknownNameError, read_label

from . import style
from .fills import NONE, Fill, fills, legend_order
from .legends import legend_below
from .regimes import short
from .scales import scales
from .units import ASSUMED, Twin, Units, literal, rests
from .words import GEARS, Words, words

WIDTH, HEIGHT = 146.0, 104.0  # mm of the panel
KEY = "P-Q-R: P cycles with Q impacts on the drive side, R on the back side; R = 0 is left out."
KEY_OF_SEVERAL = "P-Q-R/Q-R…: P cycles; of every gap in turn Q impacts on the drive side, R on the back side."
LEGEND = 15.0  # mm: what the figure is made for
STAR = 3.0  # mm around the present point that its star takes
CHARACTER = 1.25  # mm of a character of a region's label
PRESENT: dict[str, Any] = {
    "ls": "none", "marker": "*", "ms": 11.0, "mfc": style.YELLOW, "mec": style.INK, "mew": 0.8,
}  # fmt: skip
BAND: dict[str, Any] = {
    "color": style.VERMILION, "lw": 1.6, "marker": "|", "ms": 8.0, "mew": 1.2, "solid_capstyle": "butt",
}  # fmt: skip
EDGE = {"path_effects": [withStroke(linewidth=3.6, foreground="white")]}
"""Bars stand on white, as what is below them may be as dark as they are."""
NOT_TOLD = {**BAND, "color": style.INK, "ls": (0, (1, 1)), "lw": 2.0}
Array = NDArray[np.float64]


@style.styled
def plane(
    dataset: xr.Dataset,
    units: Units | None = None,
    present: tuple[float, float] | None = None,
    title: str = "",
    height: float = HEIGHT,
    along: Sequence[Twin | None] = (None, None),
    physical: bool = False,
    bands: Sequence[tuple[float, float]] = (),
    not_told: Sequence[tuple[float, float]] = (),
) -> Figure:
    """A map of two parameters: a region for every label, named where there is room.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of `gearlash.plane_dataset`.
    units : Units, optional
        Second axes in physical units: `Units.of` a case.
    present : (float, float), optional
        The point of the case itself, which gets a mark.
    title : str
        In place of the case and its parameters.
    height : float
        Of the panel, mm.
    along : sequence of Twin or None
        The units that the two parameters were asked for in, whose scales then stand first.
    physical : bool
        Whether such a scale stands alone.
    bands : sequence of (float, float)
        Intervals of the first parameter, at the second one's present value, in which teeth separate: drawn
        over the pixels, however narrow. They need ``present``.
    not_told : sequence of (float, float)
        Likewise: those of which no motion tells whether teeth separate.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    UnknownNameError
        For a dataset that is no map.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> case = gl.load_case("kahraman-singh")
    >>> done = gl.map_plane(case, gl.Axis.even("omega", 0.5, 0.6, 2), gl.Axis.even("load", 0.1, 0.2, 2))
    >>> len(plots.plane(gl.plane_dataset(case, done)).axes)
    1
    """
    if "x" not in dataset.attrs or "label_name" not in dataset.dims:
        raise UnknownNameError("dimension", "label_name", [str(d) for d in dataset.dims])
    x, y, units = str(dataset.attrs["x"]), str(dataset.attrs["y"]), units or Units()
    codes = np.asarray(dataset["label"].values, dtype=np.int64)
    names = [read_label(str(each)) for each in dataset["label_name"].values]
    looks = _looks(names, codes)
    edges = edges_of(dataset[x].values), edges_of(dataset[y].values)
    made = style.figure(style.PAGE, height + 38.0)
    panel = made.subplots()
    _fill(panel, edges, codes, looks)
    _name(panel, edges, codes, names, looks, height, present)
    said = words(dataset, units)
    twins = [units.asked(name, own) for own, name in zip(along, (x, y), strict=True)]
    for which, name, twin, own in zip("xy", (x, y), twins, along, strict=True):
        scales(panel, which, said.name(name), twin, first=own is not None, only=physical)
    panel.set_title(literal(title) if title else _title(dataset, said, (x, y)), loc="left", fontsize=7.5)
    handles: list[Patch | Line2D] = [_patch(fill) for fill in legend_order(looks)]
    if present is not None:
        handles += _bands(panel, bands, present[1], BAND, "teeth separate, at the present point's height")
        handles += _bands(panel, not_told, present[1], NOT_TOLD, "not told whether teeth separate")
        panel.plot(*([at] for at in present), clip_on=False, zorder=6, **PRESENT)
        handles.append(Line2D([], [], label="present point", **PRESENT))
    alone = [physical and own is not None for own in along]  # such a scale is as it was asked for
    marked = any(rests(twin) for twin, bare in zip(twins, alone, strict=True) if not bare)
    key = KEY_OF_SEVERAL if any(isinstance(each, Signature) and each.others for each in names) else KEY
    key = sided(key, said is GEARS)
    legend_below(made, handles, f"{key} {ASSUMED}" if marked else key, columns=5, room=LEGEND)
    return made


def _bands(
    panel: Axes, bands: Sequence[tuple[float, float]], height: float, look: dict[str, Any], words: str
) -> list[Patch | Line2D]:
    """Intervals as bars with upright ends, so that the narrowest is seen, too; returns the legend."""
    for low, high in bands:
        panel.plot([low, high], [height, height], zorder=5, **EDGE, **look)
    return [Line2D([], [], label=words, **look)] if bands else []


def fill_plane(panel: Axes, dataset: xr.Dataset, names: tuple[str, str], strength: float) -> list[Patch]:
    """A map behind other things, paler so that these are seen on it: ``strength`` of its colours is left.
    Returns its legend. Raises `GearlashError` for a map of other parameters."""
    if (dataset.attrs.get("x"), dataset.attrs.get("y")) != names:
        raise GearlashError(f"behind: expected a map over {names[0]} and {names[1]}, in this order")
    codes = np.asarray(dataset["label"].values, dtype=np.int64)
    looks = _looks([read_label(str(each)) for each in dataset["label_name"].values], codes)
    pale = [replace(each, colour=_paler(each.colour, strength)) for each in looks]
    _fill(panel, (edges_of(dataset[names[0]].values), edges_of(dataset[names[1]].values)), codes, pale)
    ordered = dict(zip(looks, pale, strict=True))
    return [_patch(ordered[each]) for each in legend_order(looks)]


def _paler(colour: str, strength: float) -> str:
    red, green, blue = (1.0 - strength * (1.0 - part) for part in to_rgb(colour))
    return to_hex((red, green, blue))


def _title(dataset: xr.Dataset, said: Words, axes: tuple[str, str]) -> str:
    """The case, and the parameters that were set: those that have symbols, and all that were fixed."""
    values, fixed = (json.loads(dataset.attrs.get(key, "{}")) for key in ("parameters", "fixed"))
    shown = dict.fromkeys([*said.symbols, *fixed])
    parts = [
        f"{said.symbol(each)} = {values[each]:.4g}" for each in shown if each in values and each not in axes
    ]
    return ",  ".join([literal(str(dataset.attrs.get("case_name", ""))), *parts]).removeprefix(",  ")


def _looks(names: Sequence[Label | None], codes: NDArray[np.int64]) -> list[Fill]:
    """The fill of every code, and last that of pixels without a motion, where there are any."""
    counts = np.bincount(codes[codes >= 0], minlength=len(names))
    frequent = sorted(range(len(names)), key=lambda i: (-counts[i], i))
    found = fills([names[i] for i in frequent])
    return [*(found[each] for each in names), *([NONE] if (codes < 0).any() else [])]


def _fill(panel: Axes, edges: tuple[Array, Array], codes: NDArray[np.int64], looks: Sequence[Fill]) -> None:
    """Colours as a picture of print resolution, hatches as vectors."""
    shown = np.where(codes < 0, len(looks) - 1, codes)
    colours = ListedColormap([fill.colour for fill in looks])
    panel.pcolormesh(*edges, shown, cmap=colours, vmin=-0.5, vmax=len(looks) - 0.5, rasterized=True)
    for fill in dict.fromkeys(fill for fill in looks if fill.hatch):
        alike = [i for i, other in enumerate(looks) if other == fill]
        path = cells(edges, np.isin(shown, alike))
        panel.add_patch(PathPatch(path, fill=False, hatch=fill.hatch, linewidth=0.0, edgecolor=style.GREY))
    panel.set_xlim(edges[0][0], edges[0][-1])
    panel.set_ylim(edges[1][0], edges[1][-1])


def cells(edges: tuple[Array, Array], mask: NDArray[np.bool_]) -> Path:
    """One path of rectangles: every run of pixels in every row."""
    x, y = edges
    steps = np.diff(np.pad(mask.astype(np.int8), ((0, 0), (1, 1))), axis=1)
    rows, first = np.nonzero(steps == 1)
    _, last = np.nonzero(steps == -1)
    left, right, low, high = x[first], x[last], y[rows], y[rows + 1]
    corners = np.stack(
        [np.stack(c, axis=-1) for c in ((left, low), (right, low), (right, high), (left, high), (left, low))],
        axis=1,
    )
    steps_of_one = [Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY]
    return Path(corners.reshape(-1, 2), np.tile(steps_of_one, len(rows)))


def _name(
    panel: Axes,
    edges: tuple[Array, Array],
    codes: NDArray[np.int64],
    names: Sequence[Label | None],
    looks: Sequence[Fill],
    height: float,
    present: tuple[float, float] | None = None,
) -> None:
    """The label inside every region that has room for it, away from the star of the present point."""
    beside = None if present is None else _around(edges, present, height)
    for code, text in enumerate(map(short, names)):
        for x, y in rooms(edges, codes == code, CHARACTER * len(text) / 2.0 + 0.4, height, taken=beside):
            boxed = {"facecolor": looks[code].colour, "edgecolor": "none", "pad": 0.8}
            panel.text(
                x, y, text,
                ha="center", va="center_baseline", fontsize=6.5, color=looks[code].ink,
                bbox=boxed if looks[code].hatch else None,
            )  # fmt: skip


def _around(edges: tuple[Array, Array], at: tuple[float, float], height: float) -> NDArray[np.bool_]:
    """The pixels that the star of the present point covers."""
    x, y = ((each[1:] + each[:-1]) / 2.0 for each in edges)
    across = WIDTH * (x - at[0]) / float(np.ptp(edges[0]))
    up = height * (y - at[1]) / float(np.ptp(edges[1]))
    size = np.hypot(WIDTH / len(x), height / len(y)) / 2.0
    return np.hypot(across[None, :], up[:, None]) < STAR + size


def rooms(
    edges: tuple[Array, Array],
    mask: NDArray[np.bool_],
    reach: float,
    height: float = HEIGHT,
    width: float = WIDTH,
    taken: NDArray[np.bool_] | None = None,
) -> Iterator[tuple[float, float]]:
    """A place in every connected part of a mask that holds a circle of this radius (mm): where the widest
    one lies, and of several such places the one nearest to the middle of the part; nothing of it is
    ``taken``."""
    x, y = edges
    size = (height / mask.shape[0], width / mask.shape[1])
    parts, count = ndimage.label(mask)  # pyright: ignore[reportGeneralTypeIssues]
    for part in range(1, count + 1):
        inside = parts == part
        if inside.sum() * size[0] * size[1] < reach**2:
            continue
        # from the middle of a pixel to the middle of the nearest one outside, or beyond the frame
        free = inside if taken is None else inside & ~taken
        framed = ndimage.distance_transform_edt(np.pad(free, 1), sampling=size)
        away = np.asarray(framed)[1:-1, 1:-1] - min(size) / 2.0
        if away.max() < reach:
            continue
        places = np.argwhere(away >= 0.95 * away.max())
        middle = np.argwhere(inside).mean(axis=0)
        row, column = places[np.argmin((((places - middle) * size) ** 2).sum(axis=1))]
        yield float(x[column] + x[column + 1]) / 2.0, float(y[row] + y[row + 1]) / 2.0


def edges_of(values: Array) -> Array:
    """Limits (m+1,) of the cells around the values; outer cells reach as far out as in."""
    if len(values) == 1:
        return values[0] + np.array([-0.5, 0.5]) * (abs(values[0]) or 1.0)
    middle = (values[1:] + values[:-1]) / 2.0
    return np.concatenate([[2.0 * values[0] - middle[0]], middle, [2.0 * values[-1] - middle[-1]]])


def _patch(fill: Fill) -> Patch:
    look = {"facecolor": fill.colour, "edgecolor": style.GREY if fill.hatch else style.INK, "linewidth": 0.4}
    return Patch(**look, hatch=fill.hatch or None, label=fill.words)
