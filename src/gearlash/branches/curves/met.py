"""What is met between two neighbouring orbits of a curve."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from gearlash.branches.continuation.extrema import Extremum

from . import secondary
from .conditions import At
from .law import coefficient
from .locate import (
    NEAR,
    Met,
    coinciding,
    degenerate,
    flat,
    multiplier_on,
    named,
    second_touch,
    touch_on,
    zero_between,
)
from .motion import is_clear
from .node import Node, solved
from .points import CodimTwoKind

HALVINGS = 14  # of a step on which the leading multiplier becomes complex
UNSURE = 1e-6  # length of a step below which it is not cut because something was not solved for
UNEXPLAINED = "contacts change on it although nothing touches at its ends"
OF_MULTIPLIERS = {At.MINUS_ONE: secondary.flip, At.ONE: secondary.fold, At.CIRCLE: secondary.torus}


@dataclass(frozen=True, eq=False)
class Happened:
    """In order along the step; ``touch``: that which ends the curve of this side; ``doubt``: why the step
    should be cut, or nothing."""

    met: tuple[Met, ...] = ()
    touch: Met | None = None
    doubt: str = ""


def between(left: Node, right: Node, length: float) -> Happened:
    """All that is met on a step of a curve."""
    happened = _on_grazing(left, right) if left.problem.touches else _on_condition(left, right)
    return Happened(happened.met, happened.touch) if length < UNSURE else happened


def _on_grazing(left: Node, right: Node) -> Happened:
    found: list[tuple[float, Met]] = []
    tries: list[tuple[Callable[[Node], float], Callable[[float], Met | None], bool]] = [
        (test, lambda part, at=at: multiplier_on(left, right, part, at), at is not At.CIRCLE)
        for at, test in OF_MULTIPLIERS.items()
    ]
    tries.append((secondary.curvature, lambda part: degenerate(left, right, part), True))
    if _may_be_flat(left, right):
        tries.append((secondary.jerk, lambda part: flat(left, right, part), False))
    for test, solve, needed in tries:
        one, two = test(left), test(right)
        if not one * two < 0.0 or secondary.holds_along(test, left, right):
            continue
        part = one / (one - two)
        met = solve(part)
        if met is not None and _near(met, left, right):
            if not any(other.kind is met.kind for _, other in found):
                found.append((part, met))
        elif needed:
            return Happened(doubt="a second condition holds on it that could not be solved for")
    change = _of_law(left, right)
    if change is not None:
        zero = zero_between(*change, coefficient)
        if zero is not None:
            found.append((_part(left, zero.node, right), named(CodimTwoKind.NO_ROOT, zero)))
    crossed = _crossed(left, right)
    if not crossed and _unexplained(left, right):
        return Happened(doubt=UNEXPLAINED)
    for number in crossed:
        met = second_touch(left, right, number)
        if met is None or not _near(met, left, right):
            return Happened(doubt="another extremum touches on it and could not be solved for")
        one, two = (abs(side.extrema.by_number[number].distance) for side in (left, right))
        found.append((one / (one + two), met))
    return Happened(tuple(met for _, met in sorted(found, key=lambda pair: pair[0])))


def _of_law(left: Node, right: Node) -> tuple[Node, Node] | None:
    """Two orbits of the step between which c changes sign. Where the leading multiplier becomes complex there
    is none behind: then what is left of the step is looked at."""
    one, two = coefficient(left), coefficient(right)
    if one * two < 0.0:
        return left, right
    if np.isnan(one) == np.isnan(two):
        return None
    known, other = (right, left) if np.isnan(one) else (left, right)
    for _ in range(HALVINGS):
        row, length = other.u - known.u, float(np.linalg.norm(other.u - known.u))
        middle = 0.5 * (known.u + other.u)
        node = solved(left.problem, middle, row / length, float(row @ middle) / length, left)[0]
        if node is None:
            return None
        there = coefficient(node)
        if coefficient(known) * there < 0.0:
            return (node, known) if np.isnan(one) else (known, node)
        known, other = (known, node) if np.isnan(there) else (node, other)
    return None


def _part(left: Node, node: Node, right: Node) -> float:
    """Of the way, at which a point lies."""
    return float(np.linalg.norm(node.u - left.u) / np.linalg.norm(right.u - left.u))


def _may_be_flat(left: Node, right: Node) -> bool:
    """Whether H″ may vanish where H‴ does: as the touch moves along the orbit, H″ would come down to less
    than half."""
    series, omega = left.touch_series[0], left.here.props.system.omega
    here, there = (float(node.problem.phases(node.u)[0]) for node in (left, right))
    one, two = series[3], right.touch_series[0][3]
    if not one * two < 0.0:
        return False
    moved = (there - here) * one / (one - two) * 2.0 * np.pi / omega
    return bool(abs(series[2] + 0.5 * one * moved) < 0.5 * abs(series[2]))


def _on_condition(left: Node, right: Node) -> Happened:
    crossed = _crossed(left, right)
    found = _secondary(left, right)
    if found is None:
        return Happened(doubt="multipliers coincide on it where they could not be solved for")
    if not crossed:
        return Happened(found, doubt=UNEXPLAINED if _unexplained(left, right) else "")
    number = crossed[0]
    one, two = left.extrema.by_number[number], right.extrema.by_number[number]
    kept = [window for _, window in left.problem.kept]
    is_kept = any((w.clearance, w.surface, w.boundary) == one.group[:3] for w in kept)
    if len(crossed) > 1 or not is_clear(one) or not is_kept:
        return Happened(doubt="an extremum that was not kept crosses its boundary on it")
    part = one.distance / (one.distance - two.distance)
    touch = touch_on(left, one, left.u + part * (right.u - left.u))
    if touch is None or not _near(touch, left, right):
        return Happened(doubt="a touch on it could not be solved for")
    return Happened(found, touch)


def _secondary(left: Node, right: Node) -> tuple[Met, ...] | None:
    """In order along the step; None where one could not be solved for."""
    found: list[tuple[float, Met]] = []
    for kind, test in secondary.of_condition(left).items():
        one, two = test(left), test(right)
        if not one * two < 0.0 or secondary.holds_along(test, left, right):
            continue
        if kind in secondary.BY_DIFFERENCES:
            if kind is CodimTwoKind.CUSP and not _turns_back(left, right):
                continue
            zero = zero_between(left, right, test, secondary.BY_DIFFERENCES[kind])
            if zero is not None:
                found.append((_part(left, zero.node, right), named(kind, zero)))
            continue
        part = one / (one - two)
        met = coinciding(left, right, part, kind)
        if met is None or not _near(met, left, right):
            return None
        found.append((part, met))
    return tuple(met for _, met in sorted(found, key=lambda pair: pair[0]))


def _turns_back(left: Node, right: Node) -> bool:
    """Whether the curve has come back in the plane: the quadratic coefficient of a fold may change sign at a
    touch as well, through infinity."""
    return float(left.direction[-2:] @ right.direction[-2:]) < 0.0


def _crossed(left: Node, right: Node) -> list[int]:
    """Numbers of extrema that have come to the other side of their boundary; not of those that touch on both
    orbits, as where motions of the plane are multiples of each other."""
    there, settled = right.extrema.by_number, left.touching | right.touching
    return [
        extremum.number
        for extremum in left.extrema.all
        if extremum.number in there
        and extremum.number not in settled
        and is_clear(extremum) != is_clear(there[extremum.number])
        and not (_touches(left, extremum) and _touches(right, there[extremum.number]))
    ]


def _touches(node: Node, extremum: Extremum) -> bool:
    """Within rounding."""
    size = float(np.linalg.norm(node.here.props.system.clearances[extremum.clearance].h * node.problem.size))
    return abs(extremum.distance) <= secondary.ALONG * size


def _unexplained(left: Node, right: Node) -> bool:
    """Whether contacts have come or gone although no extremum is on the other side: two of them may have
    merged within the step."""
    return left.motion.signature != right.motion.signature


def _near(met: Met, left: Node, right: Node) -> bool:
    unit = left.problem.plane.unit
    step = float(np.linalg.norm(right.u - left.u))
    return float(np.linalg.norm((met.place - left.place) / unit)) <= NEAR * step
