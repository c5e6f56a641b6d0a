"""The record of an atlas, of what was drawn and checked."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from gearlash.branches.curves import CodimTwoPoint, Curve, CurveEndKind
from gearlash.results.atlas import AtlasCurve, AtlasPoint, StraightPiece, Undone
from gearlash.results.plane import PlaneMap
from gearlash.system import Signature

from .changes import WAY
from .drawing import Drawing
from .drawn import Drawn
from .lines import OnLine
from .seeds import Seed, seed_of_special

SAME_POINT = 1e-6  # of the rectangle: points of one kind so near to each other are one
STAYS = 1e-9  # of the rectangle: what moves less does not change
SHORT = 0.02  # of the rectangle: what is straight on a shorter piece is not told
BESIDE = "no motion that attracts is seen to end there"
NO_CURVE = "no curve of this kind is followed"
NATURAL = (
    CurveEndKind.LIMIT,
    CurveEndKind.CLOSED,
    CurveEndKind.HALF_PERIOD,
    CurveEndKind.RESONANCE,
    CurveEndKind.FAR,
)
"""Ends at which nothing is left to be followed."""


def curves_of(drawn: Drawn) -> tuple[AtlasCurve, ...]:
    """All of them, with what is straight."""
    return tuple(
        AtlasCurve(line.curve, way, tuple(straight(line.curve, drawn.width)))
        for line, way in zip(drawn.lines, drawn.ways, strict=True)
    )


def straight(curve: Curve, width: np.ndarray) -> Iterator[StraightPiece]:
    """Pieces along which one parameter stays; points at which two things happen are on the way."""
    way = sorted(
        [(p.arclength, p.values) for p in curve.points] + [(s.arclength, s.values) for s in curve.special]
    )
    values = np.array([each for _, each in way])
    for axis in (0, 1):
        stays = np.abs(np.diff(values[:, 1 - axis])) <= STAYS * width[1 - axis]
        edges = np.flatnonzero(np.diff(np.concatenate([[0], stays.astype(int), [0]])))
        for first, last in edges.reshape(-1, 2):
            piece = values[first : last + 1, axis]
            low, high = float(piece.min()), float(piece.max())
            if high - low > SHORT * width[axis]:
                yield StraightPiece(curve.names[axis], low, high, float(values[first, 1 - axis]))


def points_of(drawn: Drawn) -> tuple[AtlasPoint, ...]:
    """Points where two things happen, each once."""
    found: list[tuple[CodimTwoPoint, set[int]]] = []
    for number, line in enumerate(drawn.lines):
        for special in line.curve.special:
            for known, curves in found:
                if _one_point(known, special, drawn.width):
                    curves.add(number)
                    break
            else:
                found.append((special, {number}))
    return tuple(AtlasPoint(special, tuple(sorted(curves))) for special, curves in found)


def _one_point(one: CodimTwoPoint, other: CodimTwoPoint, width: np.ndarray) -> bool:
    if one.kind is not other.kind or one.point.period != other.point.period:
        return False
    away = np.abs(np.array(one.values) - np.array(other.values)) / width
    return float(away.max()) <= SAME_POINT


def undone_of(
    drawing: Drawing, lines: Iterable[OnLine], beside: Sequence[Seed], plane: PlaneMap
) -> Iterator[Undone]:
    """Curves that were not drawn or not to their end, and motions that were not followed."""
    drawn = drawing.drawn
    for line in drawn.lines:
        for end in line.curve.ends:
            if end.kind not in NATURAL:
                what = f"end of a curve of kind {line.curve.kind}"
                why = f"{end.kind}; {end.note}" if end.note else str(end.kind)
                yield Undone(what, line.curve.points[0].signature, end.values, why)
    yield from _once(_without_curve(drawing, lines, beside))
    for line in lines:
        for label, value, why in line.missing:
            place = (value, line.value) if line.name == drawn.names[0] else (line.value, value)
            yield Undone("branch", label, place, why)
    yield from _long(plane, drawing.longest)


def _without_curve(
    drawing: Drawing, lines: Iterable[OnLine], beside: Sequence[Seed]
) -> Iterator[tuple[object, object, Undone]]:
    """Special points that lie on no curve, each place once: whatever else tells their curves apart, the line
    on which each was met, and what is said of it."""
    drawn, told = drawing.drawn, list[Seed]()
    for seed, why in [*drawing.left, *((seed, BESIDE) for seed in beside)]:
        known = any(_one_seed(seed, other, drawn) for other in told)
        if drawn.knows(seed) < 0 and not known:
            told.append(seed)
            touch = seed.touch
            kind = touch and (touch.clearance, touch.surface, touch.boundary)
            what = Undone(f"curve of kind {seed.kind}", seed.label, seed.place(drawn.names), why)
            yield (kind, seed.number, seed.doubled), what.values if seed.way == WAY else seed.way, what
    for line in lines:
        for special in (each for branch in line.branches for each in branch.special):
            if seed_of_special(special, line.way) is None:
                values = {**special.values, special.name: special.value}  # which its last orbit may not have
                x, y = (values[name] for name in drawn.names)
                what = Undone(f"curve of kind {special.kind}", special.label_before, (x, y), NO_CURVE)
                yield None, line.way, what


def _once(found: Iterable[tuple[object, object, Undone]]) -> Iterator[Undone]:
    """What may be one curve, since kind, motion and reason are the same, once, with how often it was met. Two
    points of one line are not put together: the first ones of all lines are, the second ones, and so on."""
    alike: dict[object, list[Undone]] = {}
    ranks = Counter[object]()
    for about, line, each in found:
        key = about, each.what, each.label, each.why
        alike.setdefault((key, ranks[key, line]), []).append(each)
        ranks[key, line] += 1
    for first, *others in alike.values():
        many = f"; met at {1 + len(others)} places, of one curve or of several" if others else ""
        yield Undone(first.what, first.label, first.values, first.why + many)


def _one_seed(one: Seed, other: Seed, drawn: Drawn) -> bool:
    away = (np.array(one.place(drawn.names)) - np.array(other.place(drawn.names))) / drawn.width
    alike = one.kind is other.kind and one.period == other.period and one.number == other.number
    return alike and one.doubled == other.doubled and float(np.abs(away).max()) <= SAME_POINT


def _long(plane: PlaneMap, longest: int) -> Iterator[Undone]:
    """Motions of the map that are longer than is followed, each with its first pixel."""
    for code, label in enumerate(plane.labels):
        if isinstance(label, Signature) and label.period > longest:
            rows, columns = np.nonzero(plane.label == code)
            place = float(plane.x.values[columns[0]]), float(plane.y.values[rows[0]])
            why = f"its period of {label.period} is longer than is followed; pixels with it: {len(rows)}"
            yield Undone("motion", label, place, why)
