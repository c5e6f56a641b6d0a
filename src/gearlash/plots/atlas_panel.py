"""One panel of an atlas: its curves with the names of their motions, and the points that they meet in."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

from gearlash.branches.curves import CodimTwoKind, CodimTwoPoint, Curve

from . import style
from .branch_lines import LEADER
from .curve_pieces import LOST, LOST_LOOK, MARKERS, Array, Drawn, Piece
from .plane_lines import LOOKS, OTHER
from .regimes import short
from .room import Room, around

WIDTHS = (1.5, 1.1, 0.8)  # points: of curves of orbits of period 1, 2, and longer
UNSTABLE = 0.45  # of the width: where the orbits are unstable
FADED, FAINT = 0.75, 0.35  # how much of it is seen there, and where they are none of the real system
NUMBER, LABEL = 5.6, 6.0  # points: the size of numbers and of names of motions
MARKER = {"ls": "none", "color": style.INK, "mfc": "white", "ms": 3.6, "mew": 0.6}
DOT = {"ls": "none", "marker": ".", "color": style.GREY, "ms": 2.2, "mew": 0.0}
TOGETHER = 1.4  # mm: points so near to each other have one marker and one number
REACH = 0.75  # mm: half the size of a marker
FAR = (0.7, 1.6, 3.0, 4.6)  # mm: of a number from its marker
MOST_COVERED = 4  # points of curves under a number or a name: more, and neither can be read
SHORTEST = 5.0  # mm: a piece of a curve that has a name
STEEP = 2.5  # height over width from which on names are turned
PLACES = (0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9, 0.05, 0.95)
BESIDE = (1.5, -1.5, 2.2, -2.2)  # mm: of a name from its curve
UNIT = 1.0 + 1e-6  # modulus from which on a multiplier is outside the unit circle


@dataclass(frozen=True, eq=False)
class NumberedPoint:
    """A point at which two things happen: ``number`` as in the table; whether its orbit is not unstable."""

    special: CodimTwoPoint
    number: str
    bounds: bool

    @property
    def kind(self) -> CodimTwoKind:
        return self.special.kind


def marks_of(curves: Sequence[Curve], same: tuple[float, float]) -> list[NumberedPoint]:
    """All points, each with the number of the first curve on which it is."""
    found: list[NumberedPoint] = []
    for i, curve in enumerate(curves, 1):
        for number, special in enumerate(curve.special, 1):
            if not any(_one(special, other.special, same) for other in found):
                bounds = bool((np.abs(special.point.multipliers) <= UNIT).all())
                found.append(NumberedPoint(special, f"{i}.{number}", bounds))
    return found


def _one(one: CodimTwoPoint, other: CodimTwoPoint, same: tuple[float, float]) -> bool:
    alike = one.kind is other.kind and one.point.period == other.point.period
    pairs = zip(one.values, other.values, same, strict=True)
    return alike and all(abs(a - b) <= limit for a, b, limit in pairs)


def draw_curves(room: Room, drawn: Sequence[Drawn]) -> None:
    """All pieces that come into the panel, wide by period, and where curves could not be followed on."""
    panel = room.panel
    for each in drawn:
        colour, dashes = LOOKS.get(str(each.curve.kind), OTHER)
        wide = WIDTHS[min(each.curve.points[0].period, len(WIDTHS)) - 1]
        for piece in each.pieces:
            x, y = piece.values.T
            if not _comes_in(panel, piece.values):
                continue
            room.fill(x, y)
            width = wide if piece.stable else UNSTABLE * wide
            alpha = FAINT if not piece.admissible else 1.0 if piece.stable else FADED
            panel.plot(x, y, color=colour, ls=dashes, lw=width, alpha=alpha, zorder=3.0)
        for end in each.curve.ends:
            if end.kind in LOST:
                panel.plot(*end.values, zorder=4.0, **LOST_LOOK)


def draw_marks(room: Room, marks: Sequence[NumberedPoint]) -> tuple[set[CodimTwoKind], bool, int]:
    """Markers with their numbers, those of one place together, and dots where orbits are unstable. Returns
    the kinds that have a marker, whether there is a dot, and how many points have their number."""
    inside = [mark for mark in marks if _inside(room, *mark.special.values)]
    places = {id(mark): room.at(*mark.special.values) for mark in inside}
    taken, kinds, numbered = [], set[CodimTwoKind](), 0
    groups = list(_together([mark for mark in inside if mark.bounds], places))
    for group in groups:
        first = group[0]
        room.panel.plot(*first.special.values, marker=MARKERS[first.kind], zorder=5.0, **MARKER)
        kinds.add(first.kind)
        u, v = places[id(first)]
        room.mark(u, v, REACH)
        taken.append((u, v))
    dots = [mark for mark in inside if not mark.bounds]
    dots = [m for m in dots if all(np.hypot(*np.subtract(places[id(m)], at)) > REACH for at in taken)]
    for mark in dots:
        room.panel.plot(*mark.special.values, zorder=4.5, **DOT)
    for group in groups:
        more = f" +{len(group) - 1}" if len(group) > 1 else ""
        numbered += _number(room, group[0].number + more, *group[0].special.values)
    return kinds, bool(dots), numbered


def _together(
    marks: Sequence[NumberedPoint], places: dict[int, tuple[float, float]]
) -> Iterator[list[NumberedPoint]]:
    """Those at one place."""
    left = list(marks)
    while left:
        first = places[id(left[0])]
        group = [m for m in left if np.hypot(*np.subtract(places[id(m)], first)) <= TOGETHER]
        left = [m for m in left if m not in group]
        yield group


def _number(room: Room, text: str, x: float, y: float) -> bool:
    u, v = room.at(x, y)
    places = [place for away in FAR for place in around(text, NUMBER, u, v, away + REACH)]
    placed = room.place(text, NUMBER, places, most=MOST_COVERED)
    if placed is None:
        return False
    shift = ((placed[0] - u) / 25.4 * 72.0, (placed[1] - v) / 25.4 * 72.0)
    room.panel.annotate(
        text, (x, y), shift, textcoords="offset points", fontsize=NUMBER, ha="center", va="center",
        zorder=6.0, arrowprops=LEADER,
    )  # fmt: skip
    return True


def name_curves(room: Room, drawn: Sequence[Drawn]) -> None:
    """Every motion of every curve once, beside its longest piece in the panel, where there is room; longer
    pieces first."""
    wanted: list[tuple[float, str, str, Array]] = []
    for each in drawn:
        longest = dict[str, tuple[float, Array]]()
        for piece in each.pieces:
            if piece.admissible:
                for part, length in _parts(room, piece):
                    if length > longest.get(piece.label, (SHORTEST, None))[0]:
                        longest[piece.label] = length, part
        colour, _ = LOOKS.get(str(each.curve.kind), OTHER)
        wanted += [(length, short(label), colour, part) for label, (length, part) in longest.items()]
    for _, text, colour, part in sorted(wanted, key=lambda each: -each[0]):
        _name(room, text, colour, part)


def _parts(room: Room, piece: Piece) -> Iterator[tuple[Array, float]]:
    """What of a piece lies in the panel, in mm, with its length."""
    u, v = room.at(*piece.values.T)  # pyright: ignore[reportArgumentType]
    places = np.column_stack([u, v])
    inside = ((places >= 0.0) & (places <= (room.width, room.height))).all(axis=1)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], inside.astype(int), [0]])))
    for first, last in edges.reshape(-1, 2):
        part = places[first:last]
        if len(part) > 1:
            yield part, float(np.linalg.norm(np.diff(part, axis=0), axis=1).sum())


def _name(room: Room, text: str, colour: str, part: Array) -> None:
    width, height = np.ptp(part, axis=0)
    turned = bool(height > STEEP * width)
    along = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(part, axis=0), axis=1)))
    at = [along[-1] * share for share in PLACES]
    u, v = (np.interp(at, along, part[:, axis]) for axis in (0, 1))
    beside = [(a, 0.0) if turned else (0.0, a) for a in BESIDE]
    places = [(float(p) + a, float(q) + b) for p, q in zip(u, v, strict=True) for a, b in beside]
    placed = room.place(text, LABEL, places, most=MOST_COVERED, turned=turned)
    if placed is not None:
        room.panel.text(
            *room.back(*placed), text, fontsize=LABEL, ha="center", va="center", color=style.words_in(colour),
            rotation=90.0 if turned else 0.0, zorder=6.0, path_effects=style.cased(1.6),
        )  # fmt: skip


def _comes_in(panel: Axes, values: Array) -> bool:
    """Whether a part of what lies around some points (m, 2) is in the panel."""
    low, high = values.min(axis=0), values.max(axis=0)
    ends = np.array([panel.get_xlim(), panel.get_ylim()])
    return bool((low <= ends[:, 1]).all() and (high >= ends[:, 0]).all())


def settled(panel: Axes) -> None:
    """What is drawn inside a panel does not take part in the layout of the figure."""
    for artist in (*panel.lines, *panel.texts, *panel.patches, *panel.collections):
        artist.set_in_layout(False)


def _inside(room: Room, x: float, y: float) -> bool:
    (left, right), (low, high) = room.panel.get_xlim(), room.panel.get_ylim()
    return left <= x <= right and low <= y <= high


def panel_room(panel: Axes, limits: Sequence[Sequence[float]], size: tuple[float, float]) -> Room:
    """A panel with its limits, and the room in it."""
    panel.set_xlim(*limits[0])
    panel.set_ylim(*limits[1])
    return Room(panel, *size)
