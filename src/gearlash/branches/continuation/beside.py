"""What the orbits just beside a special point are: their contacts, and how many multipliers are unstable.

Beside a computed orbit that is known. Several special points may lie between the same two computed orbits.
Between them it follows from what each of them changes: a graze the impacts of one side by one, a fold, a
doubling or a branch point the number of unstable multipliers by one, a torus by two."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import accumulate, product

import numpy as np

from gearlash.system import Signature

from .locate import Located
from .node import Node
from .points import SpecialKind
from .testfunctions import outside

CHANGED = {
    SpecialKind.FOLD: 1,
    SpecialKind.DOUBLING: 1,
    SpecialKind.BRANCH_POINT: 1,
    SpecialKind.TORUS: 2,
    SpecialKind.KREIN: 2,
}  # how many multipliers cross the unit circle

TOGETHER = 1e-10  # arclength: points so near to each other cannot be told apart


@dataclass(frozen=True)
class Beside:
    """An orbit very near a special point."""

    label: Signature
    unstable: int

    @staticmethod
    def of(node: Node) -> Beside:
        return Beside(node.label, node.spectrum.unstable.total)


@dataclass(frozen=True, eq=False)
class Passed:
    """A special point between two computed orbits; ``before`` and ``after``: what lies just beside it, where
    that is not what these two are."""

    left: Node
    right: Node
    located: Located
    before: Beside | None = None
    after: Beside | None = None

    @property
    def sides(self) -> tuple[Beside, Beside]:
        """What lies just beside it."""
        return self.before or Beside.of(self.left), self.after or Beside.of(self.right)


@dataclass(frozen=True, eq=False)
class Unexplained:
    """A step on which something changed that no special point was found for."""

    left: Node
    right: Node
    note: str


Item = Node | Passed | Unexplained


def told_apart(start: Node, items: Iterable[Item]) -> Iterator[Item]:
    """The items of a step that begins at an orbit, each special point with what lies just beside it."""
    last, waiting, others = start, list[Passed](), list[Unexplained]()
    for item in items:
        if isinstance(item, Passed):
            waiting.append(item)
        elif isinstance(item, Node):
            yield from _run(last, waiting, item)
            yield from others
            yield item
            last, waiting, others = item, [], []
        else:
            others.append(item)
    yield from _run(last, waiting, waiting[-1].right if waiting else last)
    yield from others


def _run(left: Node, passed: Sequence[Passed], right: Node) -> Iterator[Passed]:
    """Special points with no orbit between them, in order, from an orbit to the next."""
    labels = _labels(left, passed, right)
    counts = _counts(left, passed, right)
    for i, one in enumerate(passed):
        before, after = one.sides
        if labels is not None:
            first, last = _at_one_place(passed, i)
            before, after = replace(before, label=labels[first]), replace(after, label=labels[last + 1])
        if counts is not None:
            before, after = replace(before, unstable=counts[i]), replace(after, unstable=counts[i + 1])
        yield replace(one, before=before, after=after)


def _at_one_place(passed: Sequence[Passed], which: int) -> tuple[int, int]:
    """The first and the last of the points that cannot be told apart from one of them, as where a symmetric
    orbit touches both sides at once: there is no orbit between them that had a label of its own."""
    here = passed[which].located.node
    near = [one.located.node.apart(here) <= TOGETHER for one in passed]
    first, last = which, which
    while first > 0 and near[first - 1]:
        first -= 1
    while last + 1 < len(passed) and near[last + 1]:
        last += 1
    return first, last


def _labels(left: Node, passed: Sequence[Passed], right: Node) -> list[Signature] | None:
    """Between all of them; None where what the touches change does not lead from one end to the other."""
    touches = [one for one in passed if one.located.kind is SpecialKind.GRAZING]
    found = [left.label]
    for one in passed:
        if one not in touches:
            found.append(found[-1])
        elif len(touches) == 1:
            found.append(right.label)
        else:
            found.append(_over_touch(one, found[-1]) or found[-1])
    return found if found[-1] == right.label else None


def _over_touch(one: Passed, label: Signature) -> Signature | None:
    """The label beyond a touch. A maximum above its boundary, or a minimum below it, is one impact more."""
    number = one.located.change.number
    extremum = one.left.extrema.by_number.get(number)
    if extremum is None:
        return None
    more = 1 if extremum.distance * extremum.a0 > 0.0 else -1
    pairs = [list(pair) for pair in label.counts]
    pairs[extremum.clearance][0 if extremum.boundary > 0 else 1] += more
    if min(map(min, pairs)) < 0:
        return None
    (drive, back), *rest = [(pair[0], pair[1]) for pair in pairs]
    return Signature(label.period, drive, back, tuple(rest))


def _counts(left: Node, passed: Sequence[Passed], right: Node) -> list[int] | None:
    """Unstable multipliers between all of them: up or down at each, so that from one end the other is
    reached, and as the multipliers at the points themselves tell. None where that cannot be."""
    first, last = left.spectrum.unstable.total, right.spectrum.unstable.total
    changed = [CHANGED.get(one.located.kind, 0) if one.located.kind else 0 for one in passed]
    ways = [
        list(accumulate((sign * change for sign, change in zip(signs, changed, strict=True)), initial=first))
        for signs in product(*((1, -1) if change else (1,) for change in changed))
    ]
    possible = [way for way in ways if way[-1] == last and min(way) >= 0]
    others = [_others(one.located, change) for one, change in zip(passed, changed, strict=True)]

    def amiss(way: list[int]) -> int:
        lower = (min(way[i], way[i + 1]) for i in range(len(others)))
        return sum(abs(one - other) for one, other in zip(lower, others, strict=True))

    return min(possible, key=amiss) if possible else None


def _others(located: Located, changed: int) -> int:
    """Unstable multipliers at a special point beside those that cross the unit circle there."""
    multipliers = located.node.spectrum.multipliers
    reciprocal = located.node.spectrum.reciprocal
    if reciprocal is not None and located.kind is SpecialKind.KREIN:
        return reciprocal.outside_beside_meeting
    if reciprocal is not None:
        changed *= 2  # those within the circle with them
    away = np.abs(np.abs(multipliers) - 1.0)
    if located.kind is not SpecialKind.TORUS and changed:
        away = np.abs(multipliers - (-1.0 if located.kind is SpecialKind.DOUBLING else 1.0))
    return len(outside(np.delete(multipliers, np.argsort(away)[:changed])))
