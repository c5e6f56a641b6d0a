"""A zone in a plane of two parameters: its border, the operating point in it, and margins as arrows."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Ellipse, Patch, PathPatch, Rectangle
from matplotlib.path import Path

from gearlash.case import Case
from gearlash.case.edges import at_most
from gearlash.case.units import pretty
from gearlash.studies.plane_zone import AxisMargin, PlaneZone, ToleranceMargin
from gearlash.system import Family, given

from . import style
from .legends import legend_below
from .plane_lines import PlaneLine, draw_lines
from .regimes import DRIVE, FREE, short
from .room import Room, around
from .scales import scales
from .units import ASSUMED, Twin, Units, literal
from .words import words

TALL, INNER = 104.0, 150.0  # mm: the panel, its words beside it
FONT = 6.5  # points, of what stands beside an arrow
BESIDE = 0.8  # mm between an arrow and its words
SHARES = 0.5, 0.35, 0.65, 0.2, 0.8, 0.95  # of an arrow: where words are tried, the middle first
FILLS = {"impact-free": FREE.colour, "drive-side-only": DRIVE.colour}
WORDS = {"impact-free": "no impacts", "drive-side-only": "back side not hit"}
TOLERANCE = (0, (1.5, 1.5))
OUTSIDE = "#f2f2f2"
LEGEND = 16.0  # mm: height of a legend for which there is room


@style.styled
def zone_in_plane(
    zone: PlaneZone,
    model: Case | Family | None = None,
    *,
    title: str = "",
    along: Sequence[Twin | None] = (None, None),
) -> Figure:
    """A zone in a plane of two parameters, with what bounds it and the margins of its operating point.

    Parameters
    ----------
    zone : PlaneZone
        Of `gearlash.plane_zone`.
    model : Case or Family, optional
        That of the zone; of a case the axes and margins have units.
    title : str
        What the zone is of.
    along : sequence of Twin or None
        For either parameter the unit in which it was asked for: it stands first. Without it the physical unit
        of the case is the second scale.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> case = gl.load_case("kahraman-singh")
    >>> limits = {"lower": (0.78, 0.9), "upper": (0.85, 1.1)}
    >>> zone = gl.plane_zone(case, ("omega", "D"), **limits, values={"omega": 0.8}, lines=0)
    >>> len(plots.zone_in_plane(zone, case).axes)
    1
    """
    given.instance("zone", zone, PlaneZone, "a PlaneZone, as from gearlash.plane_zone")
    units = Units.of(model) if isinstance(model, Case) else Units()
    said, unit = words(None, units), np.subtract(zone.upper, zone.lower)
    figure = style.figure(style.PAGE, TALL + 34.0)
    panel = figure.subplots()
    panel.set_xlim(zone.lower[0], zone.upper[0])
    panel.set_ylim(zone.lower[1], zone.upper[1])
    _fill(panel, zone)
    key = draw_lines(panel, [_line(part.values, part.kind, part.event) for part in zone.parts], unit, 1.5)
    for each in zone.special:
        panel.plot(
            *each.values, ls="none", marker="*", ms=7.0, mew=0.7, color=style.INK, mfc="white", zorder=5.0
        )
    room = Room(panel, INNER, TALL)
    for part in zone.parts:
        room.fill(*np.asarray(part.values, dtype=float).T)
    for margin in zone.margins:
        room.fill(*np.array([zone.at, _end(zone, margin)]).T)
    for margin in zone.margins:
        _arrow(panel, zone, margin, room)
    key += [_tolerance(panel, zone, margin) for margin in zone.tolerance_margins]
    panel.plot(*zone.at, ls="none", marker="o", ms=4.6, color=style.INK, zorder=6.0)
    twins = [units.asked(name, twin) for twin, name in zip(along, zone.names, strict=True)]
    for which, name, twin, first in zip("xy", zone.names, twins, along, strict=True):
        scales(panel, which, said.name(name), twin, first=first is not None)
    panel.set_title(literal(title or f"around {short(zone.label)}"), fontsize=7.5)
    fill = Patch(
        facecolor=FILLS[str(zone.quiet)], edgecolor=style.INK, linewidth=0.4, label=WORDS[str(zone.quiet)]
    )
    told = ASSUMED if any(twin is not None and twin.assumed for twin in twins) else None
    legend_below(figure, [fill, *key, *_marks(zone)], told, columns=2, room=LEGEND)
    return figure


def _line(values: np.ndarray, kind: object, event: str) -> PlaneLine:
    return PlaneLine([(float(x), float(y)) for x, y in values], str(kind), event)


def _fill(panel: Axes, zone: PlaneZone) -> None:
    """The zone, with holes left out; all else pale."""
    panel.set_facecolor(OUTSIDE)
    rings = [zone.outline, *zone.holes] if len(zone.outline) else []
    if not rings:
        return
    steps = [
        np.array([Path.MOVETO, *[Path.LINETO] * (len(ring) - 1), Path.CLOSEPOLY], dtype=Path.code_type)
        for ring in rings
    ]
    corners = [np.concatenate([ring, ring[:1]]) for ring in rings]
    path = Path(np.concatenate(corners), np.concatenate(steps))
    panel.add_patch(
        PathPatch(path, facecolor=FILLS[str(zone.quiet)], edgecolor="none", alpha=0.7, zorder=0.5)
    )


def _end(zone: PlaneZone, margin: AxisMargin) -> tuple[float, float]:
    """Where the zone ends along one axis."""
    across = zone.names.index(margin.name) == 0
    return (margin.value, zone.at[1]) if across else (zone.at[0], margin.value)


def _arrow(panel: Axes, zone: PlaneZone, margin: AxisMargin, room: Room) -> None:
    """From the operating point to where the zone ends, with the distance beside it where it hides no curve;
    grey where only the range ends."""
    end = _end(zone, margin)
    colour = style.INK if margin.bounded else style.GREY
    arrow = {"arrowstyle": "-|>", "color": colour, "lw": 0.8, "shrinkA": 2.5, "shrinkB": 0.0}
    panel.annotate("", end, zone.at, arrowprops=arrow, zorder=4.0)
    text, (u, v), (u_end, v_end) = _said(margin), room.at(*zone.at), room.at(*end)
    along = [(u + share * (u_end - u), v + share * (v_end - v)) for share in SHARES]
    places = [place for at in along for place in around(text, FONT, *at, BESIDE)]
    chosen = room.place(text, FONT, places)
    if chosen is not None:
        panel.text(
            *room.back(*chosen), literal(text), ha="center", va="center", fontsize=FONT, color=colour,
            zorder=6.0, bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4, "alpha": 0.8},
        )  # fmt: skip


def _said(margin: AxisMargin) -> str:
    """How far, never more than it is."""
    sign, least = ("+" if margin.upward else "−"), "" if margin.bounded else "beyond "
    if margin.physical:
        _, distance, unit = margin.physical[0]
        return f"{least}{sign}{at_most(distance)} {pretty(unit)}"
    return f"{least}{sign}{at_most(margin.distance)}"


def _tolerance(panel: Axes, zone: PlaneZone, margin: ToleranceMargin) -> Line2D:
    """The box or ellipse that touches the boundary, and where."""
    half = margin.multiple * np.array(zone.tolerances)
    look = {"fill": False, "edgecolor": style.INK, "lw": 0.8, "ls": TOLERANCE, "zorder": 3.5}
    corner = (zone.at[0] - half[0], zone.at[1] - half[1])
    box = margin.norm == "box"
    panel.add_patch(
        Rectangle(corner, 2.0 * half[0], 2.0 * half[1], **look)
        if box
        else Ellipse(zone.at, 2.0 * half[0], 2.0 * half[1], **{**look, "edgecolor": style.GREY})
    )
    if margin.bounded:
        panel.plot(*margin.values, ls="none", marker="s" if box else "D", ms=3.6, color=style.INK, zorder=6.0)
    least = "" if margin.bounded else "at least "
    text = f"{margin.norm} of {least}{at_most(margin.multiple, 3)} times the tolerances"
    colour = style.INK if box else style.GREY
    return Line2D([], [], color=colour, lw=0.8, ls=TOLERANCE, marker="s" if box else "D", ms=3.6, label=text)


def _marks(zone: PlaneZone) -> list[Line2D]:
    found = [Line2D([], [], ls="none", marker="o", ms=4.6, color=style.INK, label="operating point")]
    if zone.special:
        star = {"ls": "none", "marker": "*", "ms": 7.0, "color": style.INK, "mfc": "white"}
        found.append(Line2D([], [], **star, label="one curve takes over from another"))
    return found
