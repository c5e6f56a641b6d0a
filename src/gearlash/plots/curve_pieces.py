"""Curves cut into pieces that are drawn alike, and the markers of points where two things happen at once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.interpolate import PchipInterpolator

from gearlash.branches.curves import CodimTwoKind, Curve, CurveEndKind, CurvePoint

from . import style
from .plane_lines import BETWEEN

Array = np.ndarray
MARKERS = {
    CodimTwoKind.GRAZING_DOUBLING: "o",
    CodimTwoKind.GRAZING_FOLD: "D",
    CodimTwoKind.GRAZING_TORUS: "s",
    CodimTwoKind.CORNER: "^",
    CodimTwoKind.TWO_GRAZINGS: "P",
    CodimTwoKind.DEGENERATE: "v",
    CodimTwoKind.FLAT: "*",
    CodimTwoKind.NO_ROOT: "X",
    CodimTwoKind.CUSP: "<",
    CodimTwoKind.GENERALISED_DOUBLING: ">",
    CodimTwoKind.FOLD_FLIP: "h",
    CodimTwoKind.ONE_ONE: "p",
    CodimTwoKind.ONE_TWO: "d",
    CodimTwoKind.ONE_THREE: "8",
    CodimTwoKind.ONE_FOUR: "H",
}
LOST = {
    CurveEndKind.TOUCH, CurveEndKind.SHORT, CurveEndKind.UNBUILT, CurveEndKind.POINTS, CurveEndKind.CANCELLED,
}  # fmt: skip
LOST_LOOK = {"ls": "none", "marker": "x", "color": style.INK, "ms": 3.6, "mew": 0.8}


@dataclass(frozen=True, eq=False)
class Piece:
    """A part of a curve within which neither admissibility nor stability nor the label changes."""

    values: Array  # (m, 2)
    label: str
    admissible: bool
    stable: bool


@dataclass(frozen=True, eq=False)
class Drawn:
    """A curve with its pieces."""

    curve: Curve
    pieces: list[Piece]


def pieces_of(curve: Curve) -> Iterator[Piece]:
    """Cut at special points too, where a curve may have a corner."""
    nodes: list[CurvePoint] = sorted(
        [*curve.points, *(special.point for special in curve.special)], key=lambda point: point.arclength
    )
    corners = {special.arclength for special in curve.special}
    run = nodes[:1]
    for one, other in pairwise(nodes):
        run.append(other)
        if other.arclength in corners or _look(one) != _look(other) or other is nodes[-1]:
            middle = run[len(run) // 2] if len(run) > 2 else run[0]
            yield Piece(_smooth(run), *_look(middle))
            run = [other]
    if len(nodes) == 1:
        yield Piece(np.array([nodes[0].values]), *_look(nodes[0]))


def _look(point: CurvePoint) -> tuple[str, bool, bool]:
    return str(point.signature), point.admissible, point.unstable == 0


def _smooth(run: Sequence[CurvePoint]) -> Array:
    """Monotone cubics along the arclength, through every point."""
    s = np.array([point.arclength for point in run])
    values = np.array([point.values for point in run], dtype=np.float64)
    kept = np.append(True, np.diff(s) > 0.0)
    s, values = s[kept], values[kept]
    if len(s) < 3:
        return values
    fine = np.append(np.linspace(s[:-1], s[1:], BETWEEN, endpoint=False, axis=1).ravel(), s[-1])
    found: Array = PchipInterpolator(s, values)(fine)
    return found
