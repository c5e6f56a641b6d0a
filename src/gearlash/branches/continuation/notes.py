"""What is said of a special point."""

from __future__ import annotations

from .beside import Passed
from .corner import PASSES, TURNS, abrupt
from .infinity import at_infinity
from .node import Node
from .points import SpecialKind, grazing_kind

BACK = {
    1: "return to contact on the drive side, beyond the boundary or through the gap (minimum of X at +D)",
    -1: "return to contact on the back side, beyond the boundary or through the gap (maximum of X at -D)",
}
BORN = "an odd number of multipliers jumps over -1, so that an orbit of twice the period begins there"
EVERY = "the orbit meets no boundary, so that its motion is linear: "
DOUBLED = f"{EVERY}orbits of twice the period and every size up to the first touch exist at this one value"
TORI = f"{EVERY}quasi-periodic motions of every size up to the first touch exist at this one value"
ORTHOGONAL = f"{EVERY}orbits of every size up to the first touch exist at this one value"


def note_of(passed: Passed) -> str:
    """The kind in words, of a graze with its boundary, and what else there is to tell."""
    located = passed.located
    node, kind = located.node, located.kind
    if kind is SpecialKind.GRAZING:
        extremum = node.extrema.by_number[located.change.number]
        if not abrupt(node.here.props.system, extremum):
            return _joined(grazing_kind(extremum), located.note)
        kind_ = BACK[extremum.boundary] if extremum.boundary * extremum.a0 > 0.0 else grazing_kind(extremum)
        below = [side.spectrum.unstable.below for side in (passed.left, passed.right)]
        same_way = passed.left.direction[-1] * passed.right.direction[-1] > 0.0
        way = located.note or (PASSES if same_way else TURNS)
        return _joined(kind_, way, BORN if sum(below) % 2 else "")
    return _joined(str(kind), located.note or _degenerate(node, kind))


def _joined(*parts: str) -> str:
    return "; ".join(filter(None, parts))


def _degenerate(node: Node, kind: SpecialKind | None) -> str:
    """What is special where the motion is linear."""
    if any(map(any, node.orbit.signature.counts)):
        return ""
    if kind is SpecialKind.DOUBLING:
        return DOUBLED
    if kind is SpecialKind.TORUS:
        return TORI
    if kind is SpecialKind.KREIN:
        return ""
    found = at_infinity(node.equations.line, node.orbit, node.value)
    return "" if found is None else _joined(ORTHOGONAL if found.orthogonal else "", found.condition)
