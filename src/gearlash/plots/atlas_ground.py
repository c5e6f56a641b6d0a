"""The map behind an atlas: pale colours of regimes, white lines between motions, names in their regions."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import ListedColormap, to_hex, to_rgb
from matplotlib.patches import Patch, PathPatch
from numpy.typing import NDArray

from gearlash.system import GearlashError, Label, read_label

from . import style
from .plane import cells, edges_of, rooms
from .regimes import APERIODIC, BACK, BACK_ONLY, DRIVE, FREE, Regime, regime, short
from .room import CHARACTER, POINT, Room

Codes = NDArray[np.int64]
STRENGTH = 0.38  # how much of the colours is left
ORDER = (FREE, DRIVE, BACK_ONLY, BACK, APERIODIC)
UP = (0.0, 3.0, -3.0, 6.0, -6.0, 9.0, -9.0, 14.0, -14.0, 20.0, -20.0)  # mm: from the widest place of a region
ASIDE = (0.0, 1.5, -1.5)  # mm: the same to the sides
NAMES = 6.0  # points: the size of names of regions
HATCH = "////"


def fill_ground(panel: Axes, behind: xr.Dataset, names: tuple[str, str]) -> list[Patch]:
    """Fills a panel with the regimes of a map; returns their legend. Raises `GearlashError` for a map of
    other parameters."""
    if (behind.attrs.get("x"), behind.attrs.get("y")) != names:
        raise GearlashError(f"behind: expected a map over {names[0]} and {names[1]}, in this order")
    codes, labels, edges = _read(behind, names)
    kinds = [regime(label) for label in labels]
    used = [kind for kind in dict.fromkeys([*ORDER, *kinds]) if kind in set(kinds)]
    shown = np.full(codes.shape, -1)
    for code, kind in enumerate(kinds):
        shown[codes == code] = used.index(kind)
    colours = ListedColormap(["white", *(_pale(kind) for kind in used)])
    panel.pcolormesh(
        *edges, shown, cmap=colours, vmin=-1.5, vmax=len(used) - 0.5, rasterized=True, zorder=0.5
    )
    for i, kind in enumerate(used):
        if _hatch(kind) and (shown == i).any():
            path = cells(edges, shown == i)
            panel.add_patch(
                PathPatch(path, fill=False, hatch=_hatch(kind), lw=0.0, edgecolor=style.PALE, zorder=0.6)
            )
    panel.add_collection(
        LineCollection(_between(codes, edges), colors="white", linewidths=0.6, zorder=0.7), autolim=False
    )
    return [
        Patch(facecolor=_pale(kind), edgecolor=style.GREY, linewidth=0.4, hatch=_hatch(kind) or None,
              label=kind.words)
        for kind in used
    ]  # fmt: skip


def name_ground(room: Room, behind: xr.Dataset, names: tuple[str, str]) -> None:
    """The motion of each region of a map, where it has room within the region and beside what is there."""
    codes, labels, edges = _read(behind, names)
    for code, label in enumerate(labels):
        if label is None or regime(label) in (APERIODIC, FREE):
            continue
        text = short(label)
        reach = 0.4 * POINT * NAMES * CHARACTER * len(text)
        for x, y in rooms(edges, codes == code, reach, room.height, room.width):
            u, v = room.at(x, y)
            places = [(u + a, v + b) for b in UP for a in ASIDE]
            placed = room.place(
                text, NAMES, [each for each in places if _is(room, each, edges, codes, code)], 0
            )
            if placed is not None:
                panel = room.panel
                panel.text(
                    *room.back(*placed), text, fontsize=NAMES, ha="center", va="center", color=style.GREY,
                    style="italic", zorder=2.0,
                )  # fmt: skip


def _is(
    room: Room, place: tuple[float, float], edges: tuple[np.ndarray, np.ndarray], codes: Codes, code: int
) -> bool:
    """Whether a place (mm) lies in a pixel of a motion."""
    x, y = room.back(*place)
    column, row = (int(np.searchsorted(ends, at)) - 1 for ends, at in zip(edges, (x, y), strict=True))
    return 0 <= row < len(codes) and 0 <= column < codes.shape[1] and int(codes[row, column]) == code


def _read(
    behind: xr.Dataset, names: tuple[str, str]
) -> tuple[Codes, Sequence[Label | None], tuple[np.ndarray, np.ndarray]]:
    codes = np.asarray(behind["label"].values, dtype=np.int64)
    labels = [read_label(str(each)) for each in behind["label_name"].values]
    return codes, labels, (edges_of(behind[names[0]].values), edges_of(behind[names[1]].values))


def _between(codes: Codes, edges: tuple[np.ndarray, np.ndarray]) -> list[list[tuple[float, float]]]:
    """The sides of pixels beyond which there is another motion."""
    x, y = edges
    rows, columns = np.nonzero(codes[:, 1:] != codes[:, :-1])
    upright = [[(x[c + 1], y[r]), (x[c + 1], y[r + 1])] for r, c in zip(rows, columns, strict=True)]
    rows, columns = np.nonzero(codes[1:] != codes[:-1])
    level = [[(x[c], y[r + 1]), (x[c + 1], y[r + 1])] for r, c in zip(rows, columns, strict=True)]
    return [*upright, *level]


def _pale(kind: Regime) -> str:
    red, green, blue = (1.0 - STRENGTH * (1.0 - part) for part in to_rgb(kind.colour))
    return to_hex((red, green, blue))


def _hatch(kind: Regime) -> str:
    return HATCH if kind is FREE else kind.hatch
