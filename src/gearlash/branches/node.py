"""One orbit on the way along a branch, and what tells whether a second one is its continuation."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gearlash.orbits import GrazingCheck, Orbit, grazing_checks
from gearlash.system import Label

Array = NDArray[np.float64]
SAMPLES = 32  # of a mesh cycle: for the range of every state
STATE_ROUNDING = 1e-11  # of the state: an extremum so near a boundary may be on either side
LEAST_SIZE = 1e-3  # of the largest state: what a state that hardly moves is measured by

Kind = tuple[int, int, str, int]
"""Clearance, boundary, surface, and sign of the curvature: extrema of one kind."""


@dataclass(frozen=True, eq=False)
class Node:
    """A periodic orbit at one value of the parameter."""

    value: float
    orbit: Orbit

    @property
    def state(self) -> Array:
        return self.orbit.state

    @property
    def label(self) -> Label:
        return self.orbit.label

    @cached_property
    def course(self) -> Array:
        """(m, n): the states at equal phases of the orbit; at one phase alone it may stand still while the
        parameter moves."""
        return self.orbit.trace.samples(SAMPLES * self.orbit.period + 1).state

    @cached_property
    def ranges(self) -> Array:
        """(n,): how far every state moves in the course of the orbit, the unit for what is near; at least
        `LEAST_SIZE` of the largest state, as an orbit may shrink to rest and grow again."""
        moved = self.course.max(axis=0) - self.course.min(axis=0)
        return np.maximum(moved, LEAST_SIZE * max(float(np.abs(self.course).max()), LEAST_SIZE))

    @cached_property
    def checks(self) -> tuple[GrazingCheck, ...]:
        """Every extremum beside every boundary, nearest first."""
        return grazing_checks(self.orbit)

    @cached_property
    def extrema(self) -> dict[Kind, list[GrazingCheck]]:
        """The same by kind, in the order of their phases."""
        found: dict[Kind, list[GrazingCheck]] = defaultdict(list)
        for check in sorted(self.checks, key=lambda check: check.phase):
            sign = 1 if check.a0 > 0.0 else -1
            found[check.clearance, check.boundary, check.surface, sign].append(check)
        return dict(found)

    def between(self, one: Array, two: Array) -> float:
        """Largest distance of states (n,) or courses (m, n) of equal phases, in units of `ranges`."""
        return float((np.abs(one - two) / self.ranges).max())

    def apart(self, state: Array) -> float:
        """Distance of a state from this orbit's at phase zero, in units of `ranges`."""
        return self.between(state, self.state)


@dataclass(frozen=True, eq=False)
class Pair:
    """Two orbits of a branch, compared extremum by extremum."""

    before: Node
    after: Node

    @cached_property
    def matched(self) -> list[tuple[GrazingCheck, GrazingCheck]]:
        """Extrema of both that continue each other: of one kind, as many in both, in the order of phases."""
        pairs: list[tuple[GrazingCheck, GrazingCheck]] = []
        for kind, mine in self.before.extrema.items():
            its = self.after.extrema.get(kind, [])
            if len(its) == len(mine):
                pairs += zip(mine, self._turned(mine, its), strict=True)
        return pairs

    @cached_property
    def unmatched(self) -> list[GrazingCheck]:
        """Extrema of either orbit that were born or ended between them, or cannot be told apart."""
        here, there = self.before.extrema, self.after.extrema
        kinds = [kind for kind in {*here, *there} if len(here.get(kind, [])) != len(there.get(kind, []))]
        return [check for kind in kinds for side in (here, there) for check in side.get(kind, [])]

    @cached_property
    def moved(self) -> float:
        """Largest change of the distance of an extremum from its boundary."""
        return max((abs(a.distance - b.distance) for a, b in self.matched), default=0.0)

    @property
    def crossed(self) -> bool:
        """Whether an extremum lies on one side of its boundary before and on the other after; of one that
        touches it within rounding only the contacts tell."""
        zero = STATE_ROUNDING * max(1.0, float(np.abs(self.before.state).max()))
        sure = (pair for pair in self.matched if min(abs(check.distance) for check in pair) > zero)
        return any((a.distance > 0.0) != (b.distance > 0.0) for a, b in sure)

    def _turned(self, mine: list[GrazingCheck], its: list[GrazingCheck]) -> list[GrazingCheck]:
        """The second list begun where it fits the first one best: the first extremum after phase zero may
        have passed it."""
        cycles = float(self.before.orbit.period)
        one, two = (np.array([check.phase for check in side]) for side in (mine, its))

        def misfit(shift: int) -> float:
            away = (np.roll(two, -shift) - one) % cycles
            return float(np.minimum(away, cycles - away).max())

        best = min({0, 1 % len(its), len(its) - 1}, key=misfit)
        return its[best:] + its[:best]
