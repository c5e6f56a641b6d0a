"""Branches in a panel: their lines, the markers of special points with their numbers, the boundaries of the
gap, and the labels of the motions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from . import style
from .followed import Array, Followed, Piece, parameter, read
from .marks import TICKS
from .room import Room

DASHED = (0, (3.2, 1.6))
MARKERS = TICKS | {
    "Krein collision": "h",
    "joins the orbit of half its period": "<",
    "joins a symmetric orbit": ">",
    "end of existence": "*",
}
OTHER_MARKER = "X"
LIMITS = ("lower limit of the parameter", "upper limit of the parameter")
ORDINARY = (
    *LIMITS,
    "closed loop: the branch comes back to where it began",
    "joins the orbit of half its period",
)
OTHER_COLOUR = "#5a5a5a"
MARKER = {"ls": "none", "color": style.INK, "mfc": "white", "ms": 2.8, "mew": 0.5}
SAME_PLACE = 0.7  # mm: markers of one kind nearer to each other than this are one
CROWD, MOST_CROWDED = 1.4, 2  # so many markers within so many mm, of any kind: more would hide the lines
SMALL = 6.5  # points: the size of numbers and labels
LEADER = {"arrowstyle": "-", "lw": 0.3, "color": style.GREY, "shrinkA": 0.0, "shrinkB": 0.0}
AROUND = (
    (1.0, 1.0),
    (-1.0, 1.0),
    (1.0, -1.0),
    (-1.0, -1.0),
    (0.0, 1.25),
    (0.0, -1.25),
    (1.4, 0.0),
    (-1.4, 0.0),
)
"""Where the number of a marker may stand, over how far it stands away."""
FAR = ((1.9, 2.1), (3.0, 3.6))  # mm: to the side and up of the marker
PLACES = (0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9)  # along a stretch, where its label may stand
BESIDE = ((0.0, 1.9), (0.0, -1.9), (0.0, 3.2), (0.0, -3.2))  # mm from it
SHORTEST = 0.02  # of the width: a stretch that has a label
MOST_COVERED = 6  # points of curves under a number: more, and neither can be read
MARGIN = 0.1  # of the height of what attracts, above and below
UNSTABLE = 2.5  # of that height: unstable branches that need no more are shown whole
NEAR = 0.35  # of the height: boundaries of the gap and special points not farther outside are shown


@dataclass(frozen=True)
class Shown:
    """Special points in the picture: how many there are, have a number, and have a marker; and, in words,
    which branches leave it."""

    inside: int
    numbered: int
    marked: int
    cut: str = ""


def pieces(every: Sequence[xr.Dataset], measure: str) -> list[Piece]:
    """Of all branches, in their order."""
    found = list[Piece]()
    for dataset in every:
        special = read(dataset, measure, "special_")
        found += Followed.of(dataset, read(dataset, measure), special).pieces()
    return found


def special_heights(every: Sequence[xr.Dataset], measure: str) -> Array:
    """(2, m): where the special points lie."""
    tables = [(each["special_value"].values, read(each, measure, "special_")) for each in every]
    return np.concatenate(
        [np.stack([np.repeat(x, y.shape[1]), y.ravel()]) for x, y in tables], axis=1, dtype=np.float64
    )


def line(panel: Axes, piece: Piece, colours: dict[str, str]) -> None:
    """Solid where stable."""
    look = {"color": colours.get(piece.label, OTHER_COLOUR), "ls": "-" if piece.stable else DASHED}
    width = 1.1 if piece.stable else 0.9
    panel.plot(piece.values, piece.y, lw=width, zorder=3.0, path_effects=style.cased(width + 1.2), **look)


def fit(
    panel: Axes, seen: Sequence[tuple[Array, Array]], drawn: Sequence[Piece], beside: Sequence[Array]
) -> None:
    """As high as what attracts, and unstable branches that are not much higher; others leave the picture.
    ``beside``, (2, m) each: boundaries of the gap and special points, which are in it where they lie near."""
    stable = [piece for piece in drawn if piece.stable]
    shown = [*seen, *((p.values, p.y) for p in (stable if stable or seen else drawn))]
    left, right = panel.get_xlim()
    heights = np.concatenate([y[(x >= left) & (x <= right)].ravel() for x, y in shown])
    heights = heights[np.isfinite(heights)]
    if not len(heights):
        return
    low, high = float(heights.min()), float(heights.max())
    tall = max(high - low, 1e-9 * max(1.0, abs(low), abs(high)))
    bottom, top = low - NEAR * tall, high + NEAR * tall
    for x, y in beside:
        near = y[(x >= left) & (x <= right) & (y >= bottom) & (y <= top)]
        low, high = min([low, *near]), max([high, *near])
    every = np.concatenate([p.y[(p.values >= left) & (p.values <= right)].ravel() for p in drawn])
    lowest, highest = float(np.nanmin([low, *every])), float(np.nanmax([high, *every]))
    if highest - lowest <= UNSTABLE * tall:
        low, high = lowest, highest
    room = MARGIN * max(high - low, tall)
    panel.set_ylim(low - room, high + room)


def cut(panel: Axes, drawn: Sequence[Piece]) -> str:
    """Which branches leave the picture, in words; empty where none does."""
    (left, right), (low, high) = panel.get_xlim(), panel.get_ylim()
    inside = [p.y[(p.values >= left) & (p.values <= right)] for p in drawn]
    above = any((y > high).any() for y in inside)
    below = any((y < low).any() for y in inside)
    where = " and ".join([*(["above"] if above else []), *(["below"] if below else [])])
    return f"unstable branches go on {where} what is shown" if where else ""


def edges_of(every: Sequence[xr.Dataset]) -> list[tuple[str, Array]]:
    """Boundaries of the gap over the parameter, (2, m), with their names; none that do not act."""
    found = []
    for name in ("plus", "minus"):
        parts = [
            np.stack([each[parameter(each)].values, each[f"boundary_{name}"].values])
            for each in every
            if f"boundary_{name}" in each
        ]
        table = np.unique(np.concatenate(parts, axis=1), axis=1) if parts else np.empty((2, 0))
        table = table[:, np.isfinite(table[1])]
        if table.shape[1]:
            found.append((name, table))
    if (
        len(found) == 2
        and found[0][1].shape == found[1][1].shape
        and np.allclose(found[0][1][1], -found[1][1][1])
    ):
        return [("$+D$", found[0][1]), ("$-D$", found[1][1])]
    return [("$+D$" if name == "plus" else "$-D^-$", table) for name, table in found]


def edge_lines(panel: Axes, room: Room, edges: Sequence[tuple[str, Array]]) -> None:
    """Thin lines at the boundaries of the gap, named at the right."""
    low, high = panel.get_ylim()
    for text, (x, y) in edges:
        if not ((y >= low) & (y <= high)).any():
            continue
        room.fill(x, y)
        panel.plot(x, y, lw=0.6, ls=(0, (6, 1.5, 1, 1.5)), color=style.GREY, zorder=1.5)
        left, right = panel.get_xlim()
        at = np.interp((right - 0.02 * (right - left), left + 0.02 * (right - left)), x, y)
        places = [
            (u, room.at(0.0, float(v))[1] + up)
            for u, v in zip((room.width - 4.0, 4.0), at, strict=True)
            for up in (1.6, -1.6)
        ]
        placed = room.place("+D", SMALL, places)
        if placed is not None:
            panel.text(*room.back(*placed), text, color=style.GREY, **_TEXT)


_TEXT = {
    "fontsize": SMALL, "ha": "center", "va": "center", "zorder": 6.0, "path_effects": style.cased(1.6)
}  # fmt: skip


def special(panel: Axes, room: Room, every: Sequence[xr.Dataset], measure: str) -> Shown:
    """Markers under the lines, and numbers as in the table beside them, where there is room."""
    left, right = panel.get_xlim()
    low, high = panel.get_ylim()
    taken: list[tuple[str, float, float]] = []
    marked = 0
    wanted: list[tuple[str, list[tuple[float, float]]]] = []
    for text, kind, value, heights in _points(every, measure):
        inside = [float(y) for y in heights if np.isfinite(y) and low < y < high]
        if not left < value < right or not inside:
            continue
        marker = MARKERS.get(kind, OTHER_MARKER)
        places = [room.at(value, y) for y in inside]
        kept = [y for y, place in zip(inside, places, strict=True) if _free(taken, marker, *place)]
        if kept:
            panel.plot([value] * len(kept), kept, marker=marker, zorder=2.5, **MARKER)
        if text:
            marked += bool(kept)
            wanted.append((text, sorted(places, key=lambda place: -place[1])))
    numbered = sum(_number(panel, room, text, places) for text, places in wanted)
    return Shown(len(wanted), numbered, marked)


def _points(every: Sequence[xr.Dataset], measure: str) -> Iterator[tuple[str, str, float, Array]]:
    """Number as in the table, kind, value and heights of every special point; ends that are none have no
    number."""
    for i, dataset in enumerate(every, 1):
        heights = read(dataset, measure, "special_")
        kinds, values = dataset["special_kind"].values, dataset["special_value"].values
        for number, (kind, value) in enumerate(zip(kinds, values, strict=True), 1):
            text = str(number) if len(every) == 1 else f"{i}.{number}"
            yield text, str(kind), float(value), heights[number - 1]
        for at in (0, -1):
            kind = str(dataset["end_kind"].values[at])
            if kind not in ORDINARY:
                yield "", kind, float(dataset["end_value"].values[at]), read(dataset, measure)[at]


def _free(taken: list[tuple[str, float, float]], marker: str, x: float, y: float) -> bool:
    """Whether a marker can be seen there, and does not hide what lies there; it lies there from now on."""
    near = [(kind, max(abs(x - u), abs(y - v))) for kind, u, v in taken]
    near = [(kind, apart) for kind, apart in near if apart < CROWD]
    if len(near) >= MOST_CROWDED or any(kind == marker and apart < SAME_PLACE for kind, apart in near):
        return False
    taken.append((marker, x, y))
    return True


def _number(panel: Axes, room: Room, text: str, places: Iterable[tuple[float, float]]) -> bool:
    """Beside the highest of the markers that has room; whether there was any."""
    for u, v in places:
        around = [(u + a * far, v + b * up) for far, up in FAR for a, b in AROUND]
        placed = room.place(text, SMALL, around, MOST_COVERED)
        if placed is not None:
            shift = ((placed[0] - u) / 25.4 * 72.0, (placed[1] - v) / 25.4 * 72.0)
            panel.annotate(
                text, room.back(u, v), shift, textcoords="offset points", color=style.INK, arrowprops=LEADER,
                **_TEXT,
            )  # fmt: skip
            return True
    return False


def labels(panel: Axes, room: Room, drawn: Sequence[Piece], colours: dict[str, str]) -> None:
    """Every label once, beside its longest stretch, where there is room: colours need not be told apart."""
    left, right = panel.get_xlim()
    longest: dict[str, Piece] = {}
    for piece in (each.within(left, right) for each in drawn):
        known = longest.get(piece.label)
        if known is None or (piece.stable, piece.length) > (known.stable, known.length):
            longest[piece.label] = piece
    for label, piece in longest.items():
        if piece.length < SHORTEST * (right - left):
            continue
        places = []
        for share in PLACES:
            at = int(share * (len(piece.values) - 1))
            for y in sorted(piece.y[at][np.isfinite(piece.y[at])], reverse=True):
                u, v = room.at(float(piece.values[at]), float(y))
                places += [(u + a, v + b) for a, b in BESIDE]
        placed = room.place(label, SMALL, places)
        if placed is not None:
            panel.text(
                *room.back(*placed), label, color=style.words_in(colours.get(label, OTHER_COLOUR)), **_TEXT
            )
