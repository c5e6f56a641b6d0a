"""The arcs of a branch: between two points at which its stability or its contacts change, the motion is one.

A stable arc has no fold inside, so that it is an interval of the parameter with one orbit at every value."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import Branch, BranchPoint, EndKind, EndOfBranch, SpecialPoint
from gearlash.system import Signature

from .zone_end import RANGE, UNKNOWN, Interval, ZoneEnd

LIMITS = (EndKind.LOWER, EndKind.UPPER)
UNSEEN = "a change between two orbits of the branch that was not solved for"


@dataclass(frozen=True, eq=False, repr=False)
class Arc(Interval):
    """Orbits of one branch, of one label and either all stable or all not. ``branch`` is the number of the
    branch, ``points`` are in the order of the parameter."""

    branch: int
    label: Signature
    stable: bool
    points: tuple[BranchPoint, ...]

    @cached_property
    def values(self) -> NDArray[np.float64]:
        return np.array([point.value for point in self.points])

    def strobes(self, value: float) -> tuple[NDArray[np.float64], float]:
        """States (P, n) at phase zero at a value, between those of the two nearest points, and how far these
        two lie from each other. `contains` says whether there are any."""
        if not self.points:
            special = self.lower.point or self.upper.point
            assert isinstance(special, SpecialPoint)
            return special.point.strobes, 0.0
        at = int(np.clip(np.searchsorted(self.values, value), 1, max(len(self.points) - 1, 1)))
        low, high = self.points[at - 1], self.points[min(at, len(self.points) - 1)]
        if high.value <= low.value:
            return low.strobes, 0.0
        part = (value - low.value) / (high.value - low.value)
        return low.strobes + part * (high.strobes - low.strobes), float(
            np.abs(high.strobes - low.strobes).max()
        )


@dataclass(frozen=True, eq=False)
class _Cut:
    """Where an arc ends: a special point, an end of the branch, or a step with a change that was unsolved."""

    arclength: float
    value: float
    error: float
    kind: str
    special: SpecialPoint | None = None
    reason: str = ""

    @property
    def ends_branch(self) -> bool:
        return self.special is None and self.reason != UNSEEN


def arcs_of(branch: Branch, number: int = 0) -> tuple[Arc, ...]:
    """All arcs of a branch, in the order of its arclength."""
    cuts = list(_cuts(branch))
    lengths = np.array([point.arclength for point in branch.points])
    found: list[Arc] = []
    for first, last in pairwise(cuts):
        inside = slice(
            int(np.searchsorted(lengths, first.arclength, side="left")),
            int(np.searchsorted(lengths, last.arclength, side="right")),
        )
        arc = _arc(branch.points[inside], first, last, number)
        if arc is not None:
            found.append(arc)
    if branch.ends[0].kind is EndKind.CLOSED:
        found = _joined(found)
    return tuple(_told(each, found) for each in found)


def _arc(points: tuple[BranchPoint, ...], first: _Cut, last: _Cut, number: int) -> Arc | None:
    if not points and (first.special is None or last.special is None):
        return None
    if points:
        label, stable = points[len(points) // 2].signature, all(point.stable for point in points)
    else:
        assert first.special is not None
        label, stable = first.special.label_after, first.special.unstable_after == 0
    low, high = sorted((first, last), key=lambda cut: cut.value)
    ordered = tuple(sorted(points, key=lambda point: point.value))
    return Arc(_end(low, label), _end(high, label), number, label, stable, ordered)


def _end(cut: _Cut, label: Signature) -> ZoneEnd:
    return ZoneEnd(cut.value, cut.kind, cut.error, inside=label, point=cut.special, reason=cut.reason)


def _cuts(branch: Branch) -> Iterator[_Cut]:
    points = branch.points
    yield _of_end(branch.ends[0], points[0].arclength)
    inner = [_Cut(s.arclength, s.value, s.error, str(s.kind), s) for s in branch.special]
    known = np.array([each.arclength for each in inner])
    for left, right in pairwise(points):
        if _changes(left, right) and not ((left.arclength <= known) & (known <= right.arclength)).any():
            middle, half = 0.5 * (left.value + right.value), 0.5 * abs(right.value - left.value)
            between = 0.5 * (left.arclength + right.arclength)
            inner.append(_Cut(between, middle, half, UNKNOWN, None, UNSEEN))
    yield from sorted(inner, key=lambda cut: cut.arclength)
    yield _of_end(branch.ends[1], points[-1].arclength)


def _changes(left: BranchPoint, right: BranchPoint) -> bool:
    turned = left.turn * right.turn < 0.0
    return left.stable != right.stable or (left.stable and (left.signature != right.signature or turned))


def _of_end(end: EndOfBranch, arclength: float) -> _Cut:
    if end.kind in LIMITS:
        return _Cut(arclength, end.value, 0.0, RANGE)
    if end.kind is EndKind.LINEAR:
        return _Cut(arclength, end.value, 0.0, "doubling", None, str(end.kind))
    return _Cut(arclength, end.value, 0.0, UNKNOWN, None, end.note or str(end.kind))


def _joined(arcs: list[Arc]) -> list[Arc]:
    """Of a closed loop: its last arc and its first one are one, as the loop was begun in the middle of it."""
    if len(arcs) < 2 or arcs[0].label != arcs[-1].label or arcs[0].stable != arcs[-1].stable:
        return arcs
    parts = (arcs[-1], arcs[0])
    ends = [end for arc in parts for end in (arc.lower, arc.upper) if end.point is not None]
    if len(ends) < 2:
        return arcs
    low, high = min(ends, key=lambda end: end.value), max(ends, key=lambda end: end.value)
    points = {point.value: point for arc in parts for point in arc.points}
    ordered = tuple(points[value] for value in sorted(points))
    return [replace(arcs[0], lower=low, upper=high, points=ordered), *arcs[1:-1]]


def _told(arc: Arc, arcs: list[Arc]) -> Arc:
    """With the label of what the branch goes on as, stably, beyond each end."""
    ends = []
    for end in (arc.lower, arc.upper):
        beside = [
            other
            for other in arcs
            if other is not arc and other.stable and end.point is not None
            and any(far.point is end.point for far in (other.lower, other.upper))
        ]  # fmt: skip
        ends.append(replace(end, outside=beside[0].label) if beside else end)
    return replace(arc, lower=ends[0], upper=ends[1])
