"""Where the branches of a scan are stable, and where several of them are so side by side."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gearlash import Branch, EndKind, EndOfBranch, SpecialPoint
from gearlash.system import Signature

from .reproduction import Stretch, Together

SAME_POINT = 1e-10  # relative distance of two values that are one point
SAME_STATE = 1e-6  # of the largest state, likewise


@dataclass(frozen=True, eq=False)
class _Part:
    """Of a branch, between two neighbouring ends."""

    label: Signature
    unstable: int
    first: SpecialPoint | EndOfBranch
    last: SpecialPoint | EndOfBranch
    values: tuple[float, ...]


def special_points(branch: Branch) -> tuple[SpecialPoint, ...]:
    """Those of a branch, each once: the last step of a closed loop passes its beginning."""
    return branch.special[: _once_round(branch)]


def stretches(branches: Sequence[Branch]) -> tuple[Stretch, ...]:
    """The stable parts of all branches, by rising value."""
    found = [
        _stretch(number, part)
        for number, branch in enumerate(branches)
        for part in _parts(branch)
        if part.unstable == 0
    ]
    return tuple(sorted(found, key=lambda each: (each.lower, each.upper)))


def together(found: Sequence[Stretch]) -> tuple[Together, ...]:
    """The intervals in which more than one stretch lies, by rising value."""
    values: list[float] = []
    for value in sorted(value for each in found for value in (each.lower, each.upper)):
        if not values or value - values[-1] > SAME_POINT * abs(value):
            values.append(value)
    made = []
    for lower, upper in pairwise(values):
        middle = 0.5 * (lower + upper)
        here = tuple(i for i, each in enumerate(found) if each.lower < middle < each.upper)
        if len(here) > 1:
            made.append(Together(lower, upper, here))
    return tuple(made)


def _once_round(branch: Branch) -> int:
    """How many special points come before the first of them comes again."""
    found = branch.special
    again = (i for i in range(1, len(found)) if _same(found[0], found[i]))
    return next(again, len(found))


def _same(one: SpecialPoint, two: SpecialPoint) -> bool:
    if one.kind is not two.kind or abs(one.value - two.value) > SAME_POINT * abs(one.value):
        return False
    size = float(np.abs(one.point.state).max())
    return float(np.abs(two.point.strobes - one.point.state).max(axis=1).min()) <= SAME_STATE * size


def _parts(branch: Branch) -> list[_Part]:
    """Between neighbouring special points, and up to the ends of the branch."""
    cuts = special_points(branch)
    if not cuts:
        point = branch.points[0]
        return [_Part(point.label, point.unstable, branch.ends[0], branch.ends[1], tuple(branch.parameter))]
    parts = [_between(branch, one, two) for one, two in pairwise(cuts)]
    first, last = cuts[0], cuts[-1]
    if branch.ends[-1].kind is EndKind.CLOSED:
        return [*parts, _around(branch, first, last)]
    before = [p.value for p in branch.points if p.arclength < first.arclength]
    after = [p.value for p in branch.points if p.arclength > last.arclength]
    if branch.ends[0].kind is not EndKind.JOINED and before:
        values = (*before, first.value)
        parts.insert(0, _Part(first.label_before, first.unstable_before, branch.ends[0], first, values))
    if branch.ends[1].kind is not EndKind.JOINED and after:
        values = (last.value, *after)
        parts.append(_Part(last.label_after, last.unstable_after, last, branch.ends[1], values))
    return parts


def _around(branch: Branch, first: SpecialPoint, last: SpecialPoint) -> _Part:
    """Of a closed loop, through the orbit that it was begun with."""
    if _once_round(branch) < len(branch.special):
        end = branch.special[_once_round(branch)].arclength
        values = [p.value for p in branch.points if last.arclength < p.arclength < end]
    else:  # the last point lies beyond the first one
        values = [p.value for p in branch.points[:-1] if not first.arclength <= p.arclength <= last.arclength]
    return _Part(last.label_after, last.unstable_after, last, first, (last.value, *values, first.value))


def _between(branch: Branch, one: SpecialPoint, two: SpecialPoint) -> _Part:
    inside = [p.value for p in branch.points if one.arclength < p.arclength < two.arclength]
    return _Part(one.label_after, one.unstable_after, one, two, (one.value, *inside, two.value))


def _stretch(number: int, part: _Part) -> Stretch:
    """With its lower and upper end: between two folds a branch goes one way."""
    ends = (part.first, part.last) if part.first.value <= part.last.value else (part.last, part.first)
    return Stretch(number, part.label, min(part.values), max(part.values), ends[0], ends[1])
