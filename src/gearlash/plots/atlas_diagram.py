"""An atlas: its curves over its map, with closer looks at what is crowded, and the points where they meet."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from gearlash.branches.curves import CodimTwoKind
from gearlash.case import Case
from gearlash.results.atlas import Atlas, AtlasCurve
from gearlash.results.plane_dataset import plane_dataset
from gearlash.system import Family, GearlashError, given

from . import style
from .atlas_ground import fill_ground, name_ground
from .atlas_panel import (
    DOT,
    FADED,
    MARKER,
    UNSTABLE,
    WIDTHS,
    NumberedPoint,
    draw_curves,
    draw_marks,
    marks_of,
    name_curves,
    panel_room,
    settled,
)
from .crowds import Box, crowds
from .curve_pieces import LOST, LOST_LOOK, MARKERS, Drawn, pieces_of
from .legends import legend_below
from .plane_lines import LOOKS
from .scales import scales
from .units import ASSUMED, Twin, Units, literal
from .words import ANY, GEARS

INNER, ALONE, ABOVE, CLOSE = (
    148.0,
    104.0,
    66.0,
    76.0,
)  # mm: width of a panel, heights of it alone, above, below
BESIDE = 66.0  # mm: width of one of two panels beside each other
SCALES, LEGEND = 20.0, 22.0  # mm: height of the scales below the panels, and of the legend
MOST = 2  # closer looks
SAME = 1e-6  # of the rectangle: points so near to each other are one
SHORT = {
    CodimTwoKind.GRAZING_DOUBLING: "grazing, multiplier −1",
    CodimTwoKind.GRAZING_FOLD: "grazing, multiplier 1",
    CodimTwoKind.GRAZING_TORUS: "grazing, pair on the circle",
    CodimTwoKind.CORNER: "corner of permanent contact",
    CodimTwoKind.TWO_GRAZINGS: "two extrema graze",
    CodimTwoKind.DEGENERATE: "degenerate grazing",
    CodimTwoKind.FLAT: "flat degenerate grazing",
    CodimTwoKind.NO_ROOT: "grazing, c = 0",
}
"""Words of the legend; other kinds have their own."""


@style.styled
def atlas_diagram(
    atlas: Atlas,
    model: Case | Family,
    *,
    title: str = "",
    span: Sequence[Sequence[float]] = (),
    along: Sequence[Twin | None] = (None, None),
) -> Figure:
    """The curves of an atlas over its map in pale colours, with the points where two things happen at once.

    The kind of a curve is told by colour and dashes, the period of its orbits by its width; it is thin where
    these are unstable. Up to two parts of the rectangle that are crowded are framed and shown closer in
    panels of their own; there and where there is room the points have their numbers, ``curve.number`` in the
    table of the atlas. Points that lie together have one marker, and how many more there are. Upright names
    are those of motions of the map.

    Parameters
    ----------
    atlas : Atlas
        With at least one curve.
    model : Case or Family
        That of the atlas; of a case the axes have units.
    title : str
        What the atlas is of.
    span : sequence of two pairs of float
        First and last value of either parameter that are shown; the rectangle where nothing is given.
    along : sequence of Twin or None
        For either parameter the unit in which it was asked for.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    GearlashError
        For an atlas without curves.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> case = gl.load_case("kahraman-singh")
    >>> x, y = gl.Axis.even("omega", 0.81, 0.83, 2), gl.Axis.even("D", 0.9, 1.1, 2)
    >>> figure = plots.atlas_diagram(gl.atlas(case, x, y, lines=1), case)
    >>> [round(float(end), 6) for end in figure.axes[0].get_xlim()]
    [0.81, 0.83]
    """
    given.instance("atlas", atlas, Atlas, "an atlas, as from gearlash.atlas")
    if not atlas.curves:
        raise GearlashError("atlas: expected at least one curve")
    ends = [(float(axis.values[0]), float(axis.values[-1])) for axis in (atlas.plane.x, atlas.plane.y)]
    limits = [(float(each[0]), float(each[1])) for each in span or ends if len(each) == 2]
    if len(limits) != 2 or not all(low < high for low, high in limits):
        raise GearlashError("span: expected a first and a larger last value of both parameters")
    curves = [each.curve for each in atlas.curves]
    width = limits[0][1] - limits[0][0], limits[1][1] - limits[1][0]
    scene = _Scene(
        [Drawn(curve, list(pieces_of(curve))) for curve in curves],
        marks_of(curves, (SAME * width[0], SAME * width[1])),
        plane_dataset(model, atlas.plane),
        atlas.names,
        _Axes.of(model, atlas.names, along),
        [(i, place) for i, each in enumerate(atlas.curves) for place in _bent(each, atlas.names)],
    )
    return scene.figure(limits, title)


def _bent(each: AtlasCurve, names: tuple[str, str]) -> Iterator[tuple[float, float]]:
    """Orbits of a curve that lie on no straight piece of it."""
    for point in each.curve.points:
        own = dict(zip(names, point.values, strict=True))
        if not any(piece.lower <= own[piece.name] <= piece.upper for piece in each.straight):
            yield point.values


@dataclass(frozen=True, eq=False)
class _Axes:
    """Words and scales of both parameters; ``asked``: whether the physical scale stands first."""

    words: tuple[str, str]
    twins: tuple[Twin | None, Twin | None]
    asked: tuple[bool, bool]

    @staticmethod
    def of(model: Case | Family, names: tuple[str, str], along: Sequence[Twin | None]) -> _Axes:
        units = Units.of(model) if isinstance(model, Case) else Units()
        said = GEARS if units.teeth else ANY
        one, two = (units.asked(name, own) for own, name in zip(along, names, strict=True))
        asked = along[0] is not None, along[1] is not None
        return _Axes((said.name(names[0]), said.name(names[1])), (one, two), asked)

    @property
    def assumed(self) -> bool:
        return any(twin is not None and twin.assumed for twin in self.twins)

    def both(self, panel: Axes) -> None:
        """All scales."""
        for which, text, twin, asked in zip("xy", self.words, self.twins, self.asked, strict=True):
            scales(panel, which, text, twin, first=asked)

    def first(self, panel: Axes) -> None:
        """Those that stand first."""
        for which, text, twin, asked in zip("xy", self.words, self.twins, self.asked, strict=True):
            if asked and twin is not None:
                scales(panel, which, text, twin, first=True)
            else:
                scales(panel, which, text, None, first=False)


@dataclass(frozen=True, eq=False)
class _Scene:
    """What is drawn in every panel."""

    drawn: Sequence[Drawn]
    marks: Sequence[NumberedPoint]
    behind: xr.Dataset
    names: tuple[str, str]
    axes: _Axes
    bent: Sequence[tuple[int, tuple[float, float]]]  # curve and place of orbits where it is not straight

    def figure(self, limits: Sequence[tuple[float, float]], title: str) -> Figure:
        boxes = self._boxes(limits)
        rows = [ABOVE, CLOSE] if boxes else [ALONE]
        figure = style.figure(style.PAGE, sum(rows) + SCALES * len(rows) + LEGEND)
        grid = figure.add_gridspec(len(rows), max(1, len(boxes)), height_ratios=rows)
        panels = [
            figure.add_subplot(grid[0, :]),
            *(figure.add_subplot(grid[1, i]) for i in range(len(boxes))),
        ]
        closer = INNER if len(boxes) == 1 else BESIDE
        shown = [(panels[0], limits, (INNER, rows[0]))]
        shown += [
            (p, _within(limits, box), (closer, CLOSE)) for p, box in zip(panels[1:], boxes, strict=True)
        ]
        kinds, dots, numbered = set[CodimTwoKind](), False, 0
        ground: list[Patch] = []
        for i, (panel, span, size) in enumerate(shown):
            ground = fill_ground(panel, self.behind, self.names)
            room = panel_room(panel, span, size)
            draw_curves(room, self.drawn)
            marks = self.marks
            if i == 0:
                for letter, box in zip("bcdef", boxes, strict=False):
                    _frame(panel, _within(limits, box), letter)
                    room.mark_box(*(_mm(box, size)))
                marks = [mark for mark in marks if not _hidden(mark, limits, boxes)]
            found, dotted, count = draw_marks(room, marks)
            kinds, dots, numbered = kinds | found, dots or dotted, numbered + count
            name_ground(room, self.behind, self.names)
            name_curves(room, self.drawn)
            settled(panel)
            (self.axes.first if i else self.axes.both)(panel)
            if boxes:
                panel.set_title(_lettered("abcdef"[i], title if i == 0 else ""))
        if not boxes and title:
            panels[0].set_title(literal(title))
        told = ["Numbers: curve.number in the table."] if numbered else []
        told += [ASSUMED] if self.axes.assumed else []
        key = [*self._key(), *_marked(kinds, dots), *self._lost(), *ground]
        legend_below(figure, key, " ".join(told) or None, columns=4, room=LEGEND)
        return figure

    def _boxes(self, limits: Sequence[tuple[float, float]]) -> list[Box]:
        """Where points are crowded; where none are, where curves that are not straight lie together."""
        low, high = (np.array([each[i] for each in limits]) for i in (0, 1))
        points = [mark.special.values for mark in self.marks if mark.bounds]
        owners = np.array([number for number, _ in self.bent], np.int64)
        for places, own in ((points, None), ([place for _, place in self.bent], owners)):
            shares = (np.array(places).reshape(-1, 2) - low) / (high - low)
            inside = ((shares >= 0.0) & (shares <= 1.0)).all(axis=1)
            own = None if own is None else own[inside]
            found = crowds(shares[inside], (INNER, ABOVE), (BESIDE, CLOSE), MOST, own)
            if found:
                return found
        return []

    def _key(self) -> list[Line2D]:
        """Kinds of curves, and what their widths mean."""
        found = []
        for kind in dict.fromkeys(str(each.curve.kind) for each in self.drawn):
            colour, dashes = LOOKS[kind]
            found.append(Line2D([], [], color=colour, ls=dashes, lw=WIDTHS[0], label=kind))
        periods = sorted({min(each.curve.points[0].period, len(WIDTHS)) for each in self.drawn})
        for period in periods if len(periods) > 1 else []:
            words = f"period {period}" + (" and longer" if period == len(WIDTHS) else "")
            found.append(Line2D([], [], color=style.INK, lw=WIDTHS[period - 1], label=words))
        if any(piece.admissible and not piece.stable for each in self.drawn for piece in each.pieces):
            look = {"color": style.INK, "lw": UNSTABLE * WIDTHS[0], "alpha": FADED}
            found.append(Line2D([], [], label="thin: orbits are unstable", **look))
        return found

    def _lost(self) -> list[Line2D]:
        lost = any(end.kind in LOST for each in self.drawn for end in each.curve.ends)
        return [Line2D([], [], label="not followed farther", **LOST_LOOK)] if lost else []


def _marked(kinds: set[CodimTwoKind], dots: bool) -> list[Line2D]:
    ordered = [kind for kind in CodimTwoKind if kind in kinds]
    found = [Line2D([], [], marker=MARKERS[k], label=SHORT.get(k, str(k)), **MARKER) for k in ordered]
    return [*found, *([Line2D([], [], label="the same, orbit unstable", **DOT)] if dots else [])]


def _lettered(letter: str, title: str) -> str:
    return rf"$\bf{{{letter}}}$" + (f"  {literal(title)}" if title else "")


def _within(limits: Sequence[tuple[float, float]], box: Box) -> list[tuple[float, float]]:
    """Of a part of a panel, the first and last value of both parameters."""
    (left, right), (low, high) = limits
    return [
        (left + box.left * (right - left), left + box.right * (right - left)),
        (low + box.low * (high - low), low + box.high * (high - low)),
    ]


def _mm(box: Box, size: tuple[float, float]) -> tuple[float, float, float, float]:
    return box.left * size[0], box.low * size[1], box.right * size[0], box.high * size[1]


def _frame(panel: Axes, span: Sequence[tuple[float, float]], letter: str) -> None:
    (left, right), (low, high) = span
    look = {"fill": False, "edgecolor": style.INK, "linewidth": 0.7, "zorder": 7.0}
    panel.add_patch(Rectangle((left, low), right - left, high - low, **look))
    panel.annotate(
        rf"$\bf{{{letter}}}$", (right, high), (-2.0, -2.0), textcoords="offset points", fontsize=8.0,
        ha="right", va="top", zorder=7.0, bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.8},
    )  # fmt: skip


def _hidden(mark: NumberedPoint, limits: Sequence[tuple[float, float]], boxes: Sequence[Box]) -> bool:
    """Whether a point is shown in a closer look."""
    places = [(v - low) / (high - low) for v, (low, high) in zip(mark.special.values, limits, strict=True)]
    return any(b.left <= places[0] <= b.right and b.low <= places[1] <= b.high for b in boxes)
