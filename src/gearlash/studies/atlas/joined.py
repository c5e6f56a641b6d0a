"""Two curves that are one in part, put together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gearlash.branches.curves import CodimTwoPoint, Curve, CurveEndKind, CurvePoint, EndOfCurve

LEAST = 2  # orbits of the piece that both have


def joined(
    known: Curve,
    other: Curve,
    nodes: Sequence[CurvePoint],
    on_known: Sequence[bool],
    on_other: tuple[bool, bool],
) -> Curve | None:
    """The first curve with what the other one has beyond an end of it; None where that is not one piece.
    ``nodes``: the other's points and special points in order, ``on_known``: which of them lie on the first
    curve; ``on_other``: whether the first one's first and last orbits lie on the other one."""
    if on_known[-1] and not on_known[0]:
        other, nodes, on_known = _turned(other), _turned_nodes(nodes), on_known[::-1]
    count = len(on_known)
    begins = next((i for i, on in enumerate(on_known) if not on), count)
    ends = next((i for i in range(begins, count) if on_known[i]), count)
    if not LEAST <= begins < count or not all(on_known[ends:]):
        return None
    closed = ends < count
    if closed and count - ends < LEAST:
        return None
    if (closed and on_other != (True, True)) or not any(on_other):
        return None
    from_, to = nodes[begins].arclength, nodes[ends - 1].arclength
    if not on_other[1]:  # beyond the first orbit of the first curve: it is turned, and turned back
        turned = joined(_turned(known), other, nodes, on_known, (False, True))
        return None if turned is None else _turned(turned)
    by = known.points[-1].arclength + _way(known.points[-1], nodes[begins], known) - from_
    rest = [point for point in other.points if from_ <= point.arclength <= to]
    special = [each for each in other.special if from_ <= each.arclength <= to]
    last = EndOfCurve(CurveEndKind.CLOSED, known.points[0].values)
    return replace(
        known,
        points=(*known.points, *(_moved(point, by) for point in rest)),
        special=(*known.special, *(replace(each, point=_moved(each.point, by)) for each in special)),
        ends=(last, last) if closed else (known.ends[0], other.ends[1]),
    )


def _way(one: CurvePoint, two: CurvePoint, curve: Curve) -> float:
    """From one point to the next in the plane, scaled."""
    return float(
        sum(((a - b) / s) ** 2 for a, b, s in zip(one.values, two.values, curve.scale[-2:], strict=True))
        ** 0.5
    )


def _moved(point: CurvePoint, by: float) -> CurvePoint:
    return replace(point, arclength=point.arclength + by)


def _turned_nodes(nodes: Sequence[CurvePoint]) -> tuple[CurvePoint, ...]:
    return tuple(replace(node, arclength=-node.arclength) for node in reversed(nodes))


def _turned(curve: Curve) -> Curve:
    """The same in the other order."""
    return replace(
        curve,
        points=_turned_nodes(curve.points),
        special=tuple(_turned_special(each) for each in reversed(curve.special)),
        ends=curve.ends[::-1],
    )


def _turned_special(each: CodimTwoPoint) -> CodimTwoPoint:
    point = replace(each.point, arclength=-each.point.arclength)
    return replace(each, point=point, label_before=each.label_after, label_after=each.label_before)
