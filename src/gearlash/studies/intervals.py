"""The algebra of intervals between ends: where all, or some, of several rows have one, and what is left."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from .zone_end import RANGE, Interval, ZoneEnd


def intersection(rows: Sequence[Iterable[Interval]]) -> list[Interval]:
    """Where all rows have an interval."""
    found = list(rows[0])
    for row in rows[1:]:
        row, pairs = list(row), []
        for a in found:
            for b in row:
                lower = a.lower if a.lower.value >= b.lower.value else b.lower
                upper = a.upper if a.upper.value <= b.upper.value else b.upper
                pairs.append(Interval(lower, upper))
        found = [pair for pair in pairs if pair.width > 0.0]
    return sorted(found, key=lambda interval: interval.lower.value)


def union(rows: Sequence[Iterable[Interval]], near: float = 0.0) -> list[Interval]:
    """Where some row has an interval; what overlaps, touches or lies as near as ``near`` is one."""
    found: list[Interval] = []
    for interval in sorted((i for row in rows for i in row), key=lambda i: i.lower.value):
        if found and interval.lower.value <= found[-1].upper.value + near:
            upper = max(found[-1].upper, interval.upper, key=lambda end: end.value)
            found[-1] = Interval(found[-1].lower, upper)
        else:
            found.append(Interval(interval.lower, interval.upper))
    return found


def without(
    intervals: Iterable[Interval],
    taken: Interval,
    seen_from_outside: Callable[[ZoneEnd], ZoneEnd],
    near: float = 0.0,
) -> list[Interval]:
    """What is left of intervals where another one is taken out; what is no wider than ``near`` is nothing. At
    an end of what was taken the interval ends as ``seen_from_outside`` says."""
    left: list[Interval] = []
    for one in intervals:
        if taken.upper.value <= one.lower.value + near or taken.lower.value >= one.upper.value - near:
            left.append(one)
            continue
        below = Interval(one.lower, seen_from_outside(taken.lower))
        above = Interval(seen_from_outside(taken.upper), one.upper)
        if taken.lower.kind != RANGE and below.width > near:
            left.append(below)
        if taken.upper.kind != RANGE and above.width > near:
            left.append(above)
    return left


def turned(end: ZoneEnd) -> ZoneEnd:
    """The same end from its other side."""
    return replace(end, inside=end.outside, outside=end.inside)
