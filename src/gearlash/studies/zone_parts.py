"""The pieces of a curve that bound a zone: where its orbit is quiet, real, and stable but for the condition
of the curve."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from gearlash.branches.continuation import SpecialKind
from gearlash.branches.continuation.points import grazing_kind
from gearlash.branches.curves import CodimTwoPoint, Curve, CurveEndKind, CurvePoint

from .plane_zone import BoundaryPart
from .zone_end import Quiet

AT_POINT = 1e-9  # of the rectangle
ROUNDING = 1e-7  # of multipliers beside the unit circle
Token = tuple[CurvePoint, CodimTwoPoint | None]
EDGE, CLOSED, LOST = "limit", "closed", "lost"


@dataclass(frozen=True, eq=False)
class Part:
    """A piece; at each end a point of two conditions, or what else: the limit, itself, or lost and why."""

    bound: BoundaryPart
    how: tuple[str, str]


def parts_of(curve: Curve, quiet: Quiet, begun: CodimTwoPoint | None = None) -> list[Part]:
    """All pieces of a curve that may bound a zone; ``begun``: where two things happen, if it begins there."""
    tokens = _in_order(curve)
    runs = list(_runs(tokens, curve, quiet))
    loop = curve.ends[0].kind is CurveEndKind.CLOSED
    if loop and len(runs) == 1 and runs[0][0] == 0 and runs[0][1] == len(tokens):
        return [_part(curve, tokens, 0, len(tokens), (CLOSED, CLOSED))]
    found = []
    for first, last in runs:
        how = (
            _how(curve, tokens, first, first - 1, 0),
            _how(curve, tokens, last - 1, last, 1),
        )
        if last - first > 1:
            found.append(_part(curve, tokens, first, last, how))
    return found if begun is None else [_from(part, begun) for part in found]


def _from(part: Part, begun: CodimTwoPoint) -> Part:
    """The same, where it ends at the point that its curve was begun at."""
    ends, how = list(part.bound.ends), list(part.how)
    unit = np.subtract(part.bound.curve.upper, part.bound.curve.lower)
    for side in (0, -1):
        away = np.abs(np.subtract(part.bound.points[side].values, begun.values) / unit).max()
        if how[side].startswith(LOST) and away <= AT_POINT:
            ends[side], how[side] = begun, ""
    return Part(replace(part.bound, ends=(ends[0], ends[1])), (how[0], how[1]))


def _in_order(curve: Curve) -> list[Token]:
    """Its orbits and special points. One at which contacts change lies between orbits with those contacts:
    behind a touch, where a curve is begun anew, lengths along it do not tell."""
    lengths = [point.arclength for point in curve.points]
    labels = [point.signature for point in curve.points]
    unit = np.subtract(curve.upper, curve.lower)
    at: list[tuple[int, float, CodimTwoPoint]] = []
    for special in curve.special:
        gap = int(np.searchsorted(lengths, special.arclength))
        if special.label_before != special.label_after:
            wanted = special.label_before, special.label_after
            gaps = [i for i in range(1, len(labels)) if (labels[i - 1], labels[i]) == wanted]
            away = [np.linalg.norm(np.subtract(curve.points[i].values, special.values) / unit) for i in gaps]
            gap = gaps[int(np.argmin(away))] if gaps else gap
        at.append((gap, special.arclength, special))
    at.sort(key=lambda each: each[:2])
    tokens: list[Token] = []
    for i, point in enumerate(curve.points):
        tokens += [(special.point, special) for gap, _, special in at if gap == i]
        tokens.append((point, None))
    return [*tokens, *((special.point, special) for gap, _, special in at if gap == len(lengths))]


def _runs(tokens: list[Token], curve: Curve, quiet: Quiet) -> Iterator[tuple[int, int]]:
    """Neighbouring orbits that bound, with the special points between and beside them."""
    begun: int | None = None
    for i, (point, special) in enumerate(tokens):
        if special is not None:
            continue
        if bounds(point, curve.kind, quiet):
            if begun is None:
                begun = i - 1 if i and tokens[i - 1][1] is not None else i
        elif begun is not None:
            yield begun, _first_special(tokens, begun, i)
            begun = None
    if begun is not None:
        yield begun, len(tokens)


def _first_special(tokens: list[Token], begun: int, end: int) -> int:
    """Behind the first special point after the last orbit that bounds."""
    last = max(i for i in range(begun, end) if tokens[i][1] is None)
    return last + 2 if last + 1 < end else last + 1


def _how(curve: Curve, tokens: list[Token], inner: int, outer: int, side: int) -> str:
    if tokens[inner][1] is not None:
        return ""
    if 0 <= outer < len(tokens):
        return LOST
    kind = curve.ends[side].kind
    return EDGE if kind is CurveEndKind.LIMIT else f"{LOST}: {curve.ends[side].kind}"


def _part(curve: Curve, tokens: list[Token], first: int, last: int, how: tuple[str, str]) -> Part:
    chosen = tokens[first:last]
    points = tuple(token[0] for token in chosen)
    middle = points[len(points) // 2]
    event = str(curve.kind)
    if middle.touches:
        event = f"{event}, {grazing_kind(middle.touches[0])}"
    return Part(BoundaryPart(curve.kind, event, points, (chosen[0][1], chosen[-1][1]), curve), how)


def bounds(point: CurvePoint, kind: SpecialKind, quiet: Quiet) -> bool:
    """Whether an orbit of a curve is quiet, real, and stable but for the condition of the curve."""
    if not point.admissible or not quiet.holds_signature(point.signature):
        return False
    left = np.abs(point.multipliers)
    if kind is SpecialKind.FOLD:
        left = np.delete(left, int(np.abs(point.multipliers - 1.0).argmin()))
    elif kind is SpecialKind.DOUBLING:
        left = np.delete(left, int(np.abs(point.multipliers + 1.0).argmin()))
    elif kind is SpecialKind.TORUS:
        left = np.delete(left, np.argsort(np.abs(left - 1.0))[:2])
    return bool((left <= 1.0 + ROUNDING).all())
