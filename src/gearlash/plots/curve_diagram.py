"""Curves of special orbits in a plane of two parameters, with the points where two things happen at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from gearlash.branches.curves import CodimTwoKind, Curve
from gearlash.case import Case
from gearlash.system import Family, GearlashError, given

from . import style
from .branch_lines import LEADER, SMALL
from .curve_pieces import LOST, LOST_LOOK, MARKERS, Drawn, Piece, pieces_of
from .legends import legend_below
from .plane import fill_plane
from .plane_lines import LOOKS, OTHER
from .room import Room, around
from .scales import scales
from .units import ASSUMED, Twin, Units, literal
from .words import ANY, GEARS

Array = np.ndarray
INNER, TALL = 148.0, 104.0  # mm of the panel
THICK, THIN, PALE_WIDTH = (
    1.7,
    0.9,
    0.7,
)  # of curves of stable and other orbits, and of none of the real system
FAINT = 0.35
LEGEND = 18.0  # mm: height of a legend for which there is room
ROOM = 0.02  # of the picture, around what is in it
PALE = 0.4  # how much of the colours of a map behind curves is left
MARKER = {"ls": "none", "color": style.INK, "mfc": "white", "ms": 4.6, "mew": 0.7}
FAR = (1.0, 2.4)  # mm: of a number from its marker
REACH = 0.8  # mm: half the size of a marker
BESIDE = (
    (0.0, 2.2),
    (0.0, -2.2),
    (5.0, 0.0),
    (-5.0, 0.0),
    (5.0, 2.2),
    (-5.0, 2.2),
    (5.0, -2.2),
    (-5.0, -2.2),
)
PLACES = (0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9)  # along a curve, where its label may stand


@style.styled
def curve_diagram(
    curves: Sequence[Curve],
    model: Case | Family | None = None,
    *,
    title: str = "",
    behind: xr.Dataset | None = None,
    span: Sequence[Sequence[float]] = (),
    along: Sequence[Twin | None] = (None, None),
) -> Figure:
    """Curves of grazing, folds, doublings and Neimark-Sacker points in the plane of their two parameters.

    The kind of a curve is told by colour and dashes, and the label of its orbits stands beside it. A curve is
    thick where no other multiplier of its orbits lies outside the unit circle, so that the motion that ends
    or changes there is stable on one side; it is pale where its orbits are none of the real system. Markers
    are the points at which two things happen at once, with their numbers as in the table where there is
    room; of several curves with that of the curve before it (2.1).

    Parameters
    ----------
    curves : sequence of Curve
        All in the same two parameters: the first one lies along x.
    model : Case or Family, optional
        That of the curves; of a case the axes have units.
    title : str
        What the curves are of.
    behind : xarray.Dataset, optional
        A map, of `gearlash.plane_dataset`, over the same parameters: it lies in pale colours behind them.
    span : sequence of two pairs of float
        First and last value of either parameter that are shown; the limits of the curves where nothing is
        given.
    along : sequence of Twin or None
        For either parameter the unit in which it was asked for: it stands first. Without it the physical unit
        of the case is the second scale.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    GearlashError
        For curves in different parameters, and where there is none.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> fold = branch.of_kind("fold")[-1]
    >>> curve = gl.continue_curve(case, ("omega", "D"), fold, lower=(0.6, 0.13), upper=(0.8, 1.1))
    >>> figure = plots.curve_diagram([curve], case)
    >>> figure.axes[0].get_xlabel()
    'mesh frequency  $\\\\omega$'
    """
    curves = given.items("curves", curves, "curves, as from gearlash.continue_curve")
    names = _common(curves)
    figure = style.figure(style.PAGE, TALL + 38.0)
    panel: Axes = figure.subplots()
    limits = span or _limits(curves)
    if len(limits) != 2 or any(len(each) != 2 or not each[0] < each[1] for each in limits):
        raise GearlashError("span: expected a first and a larger last value of both parameters")
    looks = [] if behind is None else fill_plane(panel, behind, names, PALE)
    panel.set_xlim(*limits[0])
    panel.set_ylim(*limits[1])
    room = Room(panel, INNER, TALL)
    drawn = [Drawn(curve, list(pieces_of(curve))) for curve in curves]
    known = dict[str, Array]()
    for each in drawn:
        _draw(panel, room, each, known)
    numbered = _special(panel, room, curves)
    for each in drawn:
        _label(panel, room, each)
    units = Units.of(model) if isinstance(model, Case) else Units()
    said = GEARS if units.teeth else ANY
    twins = [units.asked(name, own) for own, name in zip(along, names, strict=True)]
    for which, name, twin, own in zip("xy", names, twins, along, strict=True):
        scales(panel, which, said.name(name), twin, first=own is not None)
    if title:
        panel.set_title(literal(title))
    assumed = any(twin is not None and twin.assumed for twin in twins)
    told = " ".join([*numbered, *([ASSUMED] if assumed else [])]) or None
    legend_below(figure, [*_key(drawn), *_marks(curves), *looks], told, columns=3, room=LEGEND)
    return figure


def _common(curves: Sequence[Curve]) -> tuple[str, str]:
    for curve in curves:
        given.instance("curves", curve, Curve, "curves, as from gearlash.continue_curve")
    names = {curve.names for curve in curves}
    if len(names) != 1:
        found = "; ".join(" and ".join(each) for each in sorted(names))
        raise GearlashError(f"curves: expected some in the same two parameters, in one order, got {found}")
    return names.pop()


def _limits(curves: Sequence[Curve]) -> list[tuple[float, float]]:
    """Of all curves, with a little room for markers at the ends."""
    found = []
    for i in range(2):
        low, high = min(curve.lower[i] for curve in curves), max(curve.upper[i] for curve in curves)
        room = ROOM * (high - low)
        found.append((low - room, high + room))
    return found


def _draw(panel: Axes, room: Room, drawn: Drawn, known: dict[str, Array]) -> None:
    """What runs along ``known`` curves of its kind (points in mm) is not drawn again: dashes would close."""
    kind = str(drawn.curve.kind)
    colour, dashes = LOOKS.get(kind, OTHER)
    before, new = known.get(kind, np.empty((0, 2))), len(room.curves)
    for piece in drawn.pieces:
        x, y = piece.values.T
        if room.covered(x, y, before):
            continue
        room.fill(x, y)
        width = PALE_WIDTH if not piece.admissible else THICK if piece.stable else THIN
        alpha = 1.0 if piece.admissible else FAINT
        panel.plot(x, y, color=colour, ls=dashes, lw=width, alpha=alpha, zorder=3.0)
    known[kind] = np.concatenate([before, room.curves[new:]])
    for end in drawn.curve.ends:
        if end.kind in LOST:
            panel.plot(*end.values, zorder=4.0, **LOST_LOOK)


def _special(panel: Axes, room: Room, curves: Sequence[Curve]) -> list[str]:
    """Markers, each place once, and their numbers; what is said of these."""
    (left, right), (low, high) = panel.get_xlim(), panel.get_ylim()
    taken = list[tuple[CodimTwoKind, float, float]]()
    inside = numbered = 0
    for i, curve in enumerate(curves, 1):
        for number, special in enumerate(curve.special, 1):
            x, y = special.values
            if not (left <= x <= right and low <= y <= high):
                continue
            u, v = room.at(x, y)
            inside += 1
            if not any(kind is special.kind and np.hypot(u - a, v - b) < 0.5 for kind, a, b in taken):
                panel.plot(x, y, marker=MARKERS[special.kind], zorder=5.0, **MARKER)
                taken.append((special.kind, u, v))
                room.mark(u, v, REACH)
            text = str(number) if len(curves) == 1 else f"{i}.{number}"
            places = [place for away in FAR for place in around(text, SMALL, u, v, away)]
            placed = room.place(text, SMALL, places)
            if placed is not None:
                numbered += 1
                shift = ((placed[0] - u) / 25.4 * 72.0, (placed[1] - v) / 25.4 * 72.0)
                panel.annotate(
                    text, (x, y), shift, textcoords="offset points", fontsize=SMALL, ha="center", va="center",
                    zorder=6.0, arrowprops=LEADER,
                )  # fmt: skip
    if not inside:
        return []
    row = "rows of the table" if len(curves) == 1 else "curve.number in its table"
    left_out = f"; {numbered} of {inside} points have one" if numbered < inside else ""
    return [f"Numbers: {row}{left_out}."]


def _label(panel: Axes, room: Room, drawn: Drawn) -> None:
    """Every label of the curve once, beside its longest piece."""
    colour, _ = LOOKS.get(str(drawn.curve.kind), OTHER)
    longest: dict[str, Piece] = {}
    for piece in drawn.pieces:
        known = longest.get(piece.label)
        if piece.admissible and (known is None or len(piece.values) > len(known.values)):
            longest[piece.label] = piece
    for label, piece in longest.items():
        places = []
        for share in PLACES:
            x, y = piece.values[int(share * (len(piece.values) - 1))]
            u, v = room.at(float(x), float(y))
            places += [(u + a, v + b) for a, b in BESIDE]
        placed = room.place(label, SMALL, places)
        if placed is not None:
            panel.text(
                *room.back(*placed), label, fontsize=SMALL, ha="center", va="center",
                color=style.words_in(colour), zorder=6.0,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6, "alpha": 0.75},
            )  # fmt: skip


def _key(drawn: Sequence[Drawn]) -> list[Line2D | Patch]:
    """Kinds of curves, and what their widths mean where there are several."""
    found: list[Line2D | Patch] = []
    for kind in dict.fromkeys(str(each.curve.kind) for each in drawn):
        colour, dashes = LOOKS.get(kind, OTHER)
        found.append(Line2D([], [], color=colour, ls=dashes, lw=THICK, label=kind))
    pieces = [piece for each in drawn for piece in each.pieces]
    real = [piece for piece in pieces if piece.admissible]
    if any(not piece.stable for piece in real):
        found.append(Line2D([], [], color=style.INK, lw=THIN, label="thin: of an orbit that is unstable"))
    if len(real) < len(pieces):
        words = "pale: no orbit of the real system"
        found.append(Line2D([], [], color=style.INK, lw=PALE_WIDTH, alpha=FAINT, label=words))
    return found


def _marks(curves: Sequence[Curve]) -> list[Line2D]:
    kinds = dict.fromkeys(special.kind for curve in curves for special in curve.special)
    found = [Line2D([], [], marker=MARKERS[kind], label=str(kind), **MARKER) for kind in kinds]
    if any(end.kind in LOST for curve in curves for end in curve.ends):
        found.append(Line2D([], [], label="not followed farther", **LOST_LOOK))
    return found
