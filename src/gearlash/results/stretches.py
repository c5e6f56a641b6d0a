"""Where the orbits of a branch are stable, and where several stable ones lie at the same value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from gearlash.system import Signature

from .between_points import Here, Passing, between

if TYPE_CHECKING:
    from gearlash.branches.continuation import Branch


TOUCHING = 1e-9  # of the interval of the parameter: stretches that overlap by less only meet


@dataclass(frozen=True)
class Stretch:
    """A part of a branch along which the parameter goes one way, and orbits have one label and are stable, or
    not: values at its two ends, ascending."""

    low: float
    high: float
    label: Signature
    stable: bool
    rising: bool


@dataclass(frozen=True)
class StableBeside:
    """Values at which stable orbits of several stretches lie, with their labels."""

    low: float
    high: float
    labels: tuple[Signature, ...]


@dataclass(frozen=True)
class _Step:
    """From one node to the next."""

    left: float
    right: float
    label: Signature
    stable: bool

    @property
    def look(self) -> tuple[Signature, bool, bool]:
        return self.label, self.stable, self.right > self.left


def stretches(branch: Branch) -> tuple[Stretch, ...]:
    """In the order of the branch; they end at special points exactly."""
    runs: list[list[_Step]] = []
    for step in _steps(branch):
        if runs and step.look == runs[-1][-1].look:
            runs[-1].append(step)
        else:
            runs.append([step])
    return tuple(_stretch(run) for run in runs)


def _steps(branch: Branch) -> Iterator[_Step]:
    """Between all neighbours of orbits and special points."""
    rows: list[tuple[float, float, Here[Signature] | Passing[Signature]]] = [
        (point.arclength, point.value, Here(point.label, point.unstable)) for point in branch.points
    ]
    for special in branch.special:
        before = Here(special.label_before, special.unstable_before)
        after = Here(special.label_after, special.unstable_after)
        rows.append((special.arclength, special.point.value, Passing(str(special.kind), before, after)))
    rows.sort(key=lambda row: row[0])
    found = between([row[2] for row in rows])
    for (_, left, _), (_, right, _), here in zip(rows[:-1], rows[1:], found, strict=True):
        if left != right:
            yield _Step(left, right, here.label, here.unstable == 0)


def _stretch(run: Sequence[_Step]) -> Stretch:
    low, high = sorted((run[0].left, run[-1].right))
    label, stable, rising = run[0].look
    return Stretch(low, high, label, stable, rising)


def beside_each_other(every: Sequence[Stretch], unit: float) -> tuple[StableBeside, ...]:
    """Intervals in which two or more of the stretches hold a stable orbit. ``unit``: width of the interval of
    the parameter."""
    stable = [each for each in every if each.stable]
    ends = sorted({end for each in stable for end in (each.low, each.high)})
    found: list[StableBeside] = []
    for low, high in pairwise(ends):
        here = [each for each in stable if each.low <= low and high <= each.high]
        if len(here) < 2 or high - low < TOUCHING * unit:
            continue
        labels = tuple(each.label for each in here)
        if found and found[-1].high == low and found[-1].labels == labels:
            found[-1] = StableBeside(found[-1].low, high, labels)
        else:
            found.append(StableBeside(low, high, labels))
    return tuple(found)
