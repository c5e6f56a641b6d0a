"""What may stop a step along a branch: grazing, doubling and fold, solved for from the last orbit before."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gearlash.system import Status

from .bifurcation import BifurcationPoint, locate_multiplier
from .ending import SolvedPoint, ends_branch, is_close, is_fold
from .grazing import locate_grazing
from .grazing_point import GrazingPoint
from .node import Node
from .stepping import Earlier, Line, rates
from .steps import UNBUILT

AHEAD = 4.0  # lengths of the refused step: how far ahead an extremum may seem to touch, to be solved for
TRIES = 6  # extrema solved for at one orbit
NEAR_BOUNDARY = (
    0.05  # of the orbit's size: extrema so near a boundary are tried where no motion of them is known
)
WORTH = 0.8  # a real multiplier beyond it is followed to ±1
LEADING = 1e-5  # what a multiplier of modulus 1 may exceed it by, where it is known to the root of rounding


@dataclass(frozen=True, eq=False)
class Causes:
    """Points ahead of ``before`` in the way of ``sign``, nearest first."""

    before: Node
    points: tuple[SolvedPoint, ...]

    @staticmethod
    def ahead(
        line: Line, before: Node, earlier: Earlier, value: float, *, touches: bool, losses: bool
    ) -> Causes:
        """Those that a refused step from ``before`` to ``value`` may have met: touches, and where the orbit
        loses its stability or ends."""
        sign = 1.0 if value > before.value else -1.0
        found: list[SolvedPoint] = []
        if touches:
            found += _grazings(line, before, earlier, value)
        if losses:
            joined = list(_joined(line, before))
            found += joined or _multipliers(line, before)
        ahead = (p for p in found if sign * (p.value - before.value) >= -slack(p.value))
        return Causes(before, tuple(sorted(ahead, key=lambda p: sign * p.value)))

    def up_to(self, value: float, sign: float) -> Iterator[SolvedPoint]:
        """Those not beyond a value. No step leads to where a branch ends, only ever nearer: that is met as
        soon as it is believed."""
        for point in self.points:
            if ends_branch(point, self.before) or sign * (point.value - value) <= slack(value):
                yield point


def slack(value: float) -> float:
    """What is no difference of two values."""
    return 1e-9 * max(abs(value), 1e-3)


def _grazings(line: Line, before: Node, earlier: Earlier, value: float) -> Iterator[GrazingPoint]:
    """The touches of the extrema that come nearest to their boundaries."""
    width, sign = value - before.value, 1 if value > before.value else -1
    rate, size, tried = rates(earlier, before), float(before.ranges.max()), []
    for check in before.checks:
        if check in rate and rate[check] != 0.0:
            ahead = -check.distance / rate[check] / width
            if 0.0 <= ahead <= AHEAD:
                tried.append((ahead, check))
        elif check not in rate and abs(check.distance) <= NEAR_BOUNDARY * size:
            tried.append((abs(check.distance) / size, check))
    for _, check in sorted(tried, key=lambda one: one[0])[:TRIES]:
        try:
            point = locate_grazing(line.family, line.name, before.orbit, check, values=line.at(before.value))
        except UNBUILT:
            continue
        near = point.label_below if sign > 0 else point.label_above
        if point.status is Status.OK and near == before.label:
            yield point


def _multipliers(line: Line, before: Node) -> Iterator[BifurcationPoint]:
    """The doubling and the fold that real multipliers on their way to -1 and +1 speak for."""
    multipliers = np.linalg.eigvals(before.orbit.shot.monodromy)
    real = multipliers.real[np.abs(multipliers.imag) <= 1e-6 * np.abs(multipliers)]
    for target in (-1, 1):
        if (target * real).max(initial=0.0) < WORTH:
            continue
        try:
            point = locate_multiplier(
                line.family, line.name, before.orbit, target, values=line.at(before.value)
            )
        except UNBUILT:
            continue
        stable = float(np.abs(point.multipliers).max()) <= 1.0 + LEADING  # what crossed ±1 before was the end
        if point.status is not Status.OK or point.label != before.label or not stable:
            continue
        if target < 0 or is_fold(line, before, point):
            yield point


def _joined(line: Line, before: Node) -> Iterator[BifurcationPoint]:
    """The doubling at which an orbit ends that was born from one of half its period: solved for from that
    one, which lies between the two halves."""
    orbit, half = before.orbit, before.orbit.shot.period // 2
    if orbit.shot.period % 2 or orbit.leading.imag != 0.0 or orbit.leading.real < WORTH:
        return
    try:
        between = 0.5 * (orbit.strobes[0] + orbit.strobes[half])
        single = line.orbit(before.value, between, half, orbit)
        if single is None or single.shot.period != half or before.label != single.signature.twice:
            return
        point = locate_multiplier(line.family, line.name, single, -1, values=line.at(before.value))
    except UNBUILT:
        return
    if point.status is Status.OK and point.label == single.label and is_close(line, before, point):
        yield point
