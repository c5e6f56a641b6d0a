"""Between neighbouring orbits of a stable arc: is there a stable orbit at every value in between?

At two neighbours the monodromies A and B are known. Take the norm in which A is diagonal: there A is as
large as its largest multiplier, and whatever is smaller than 1 has all its multipliers inside the unit
circle. So have all matrices on the straight line from A to B if both are, and all that stray from it by
less than what is left to 1. Then no multiplier is 1, so that the orbit goes on by the implicit function
theorem, and none leaves the circle. How far the monodromy strays is known in the middle; between, it is
taken to be no more than `ROOM` times as much. That is not proved. Steps for which this leaves no room are
halved."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches.continuation import SpecialPoint
from gearlash.jobs import Chain, Part, stopping
from gearlash.orbits import orbit_at
from gearlash.system import GearlashError

from .arcs import Arc
from .follow_tasks import Question
from .followed import Followed

Array = NDArray[np.float64]

ROOM = (
    2.0  # times the change from one neighbour to the other: what the monodromy is taken to change by between
)
NARROWEST = 1e-5  # of the axis: steps are not halved further
MOST_ORBITS = 200  # of one arc


@dataclass(frozen=True, eq=False)
class At:
    """The orbit of an arc at a value: its state at phase zero and its monodromy."""

    value: float
    state: Array
    monodromy: Array

    @cached_property
    def modes(self) -> Array:
        return np.linalg.eig(self.monodromy)[1]

    @cached_property
    def spectral_radius(self) -> float:
        return float(np.abs(np.linalg.eigvals(self.monodromy)).max())

    def size(self, matrix: Array) -> float:
        """The size of a matrix, in the norm in which this monodromy is diagonal."""
        try:
            return float(np.linalg.norm(np.linalg.solve(self.modes, matrix @ self.modes), 2))
        except np.linalg.LinAlgError:
            return np.inf

    def leaves_room(self, other: At, middle: At) -> bool:
        """Whether all that lies between leaves the unit circle to no multiplier."""
        strays = self.size(middle.monodromy - 0.5 * (self.monodromy + other.monodromy))
        return max(self.spectral_radius, self.size(other.monodromy)) + ROOM * strays < 1.0


@dataclass(frozen=True, eq=False)
class Assure:
    """A task: an arc between two values; ``known`` are values and states at phase zero of its orbits."""

    question: Question
    periods: int
    known: tuple[tuple[float, Array], ...]


def assure(task: Assure, carry: object) -> Part:
    """The intervals, in order, in which neighbours leave room for stable orbits only."""
    walk = _Walk(task)
    nodes = [node for value, state in task.known if (node := walk.at(value, state)) is not None]
    found: list[tuple[float, float]] = []
    for left, right in pairwise(nodes):
        for low, high in walk.between(left, right):
            if found and found[-1][1] == low:
                found[-1] = found[-1][0], high
            else:
                found.append((low, high))
    return Part((tuple(found),))


@dataclass(eq=False)
class _Walk:
    task: Assure
    orbits: int = 0

    def at(self, value: float, state: Array) -> At | None:
        question = self.task.question
        family = question.source.family()
        self.orbits += 1
        try:
            props = flow.propagators(family.system(question.values(family, value)))
            orbit = orbit_at(props, state, self.task.periods)
        except (GearlashError, np.linalg.LinAlgError):
            return None
        return None if orbit is None else At(value, orbit.state, orbit.shot.monodromy)

    def between(self, left: At, right: At) -> list[tuple[float, float]]:
        """The parts of a step that are assured."""
        width = right.value - left.value
        if width <= 0.0 or stopping():
            return []
        narrow = width <= NARROWEST * self.task.question.width or self.orbits >= MOST_ORBITS
        middle = self.at(0.5 * (left.value + right.value), 0.5 * (left.state + right.state))
        if middle is None:
            return []
        if left.leaves_room(right, middle) or right.leaves_room(left, middle):
            return [(left.value, right.value)]
        return [] if narrow else [*self.between(left, middle), *self.between(middle, right)]


def assured(followed: Followed, arcs: Iterable[tuple[Arc, float, float]]) -> dict[int, tuple[float, float]]:
    """Of every arc, told by its number among all, the widest interval between two values in which a stable
    orbit is assured at every value; arcs of which there is none are left out."""
    chains = []
    for arc, low, high in arcs:
        known = tuple(_known(arc, low, high))
        if len(known) > 1:
            periods = len(known_strobes(arc))
            chains.append(Chain(followed.arcs.index(arc), (Assure(followed.question, periods, known),), (1,)))
    done = followed.done(assure, chains)
    widest = {name: max(found, key=lambda part: part[1] - part[0]) for name, found in done.items() if found}
    return {int(str(name)): part for name, part in widest.items()}


def known_strobes(arc: Arc) -> Array:
    """States at phase zero of the base periods of one of its orbits."""
    return arc.strobes(0.5 * (arc.lower.value + arc.upper.value))[0]


def _known(arc: Arc, low: float, high: float) -> Iterable[tuple[float, Array]]:
    """Orbits of an arc from one value to another, those at its ends with them."""
    for end in (arc.lower, arc.upper):
        if end is arc.upper:
            inner = [
                p for p in arc.points if max(low, arc.lower.value) < p.value < min(high, arc.upper.value)
            ]
            yield from ((point.value, point.state) for point in inner)
        value = max(low, end.value) if end is arc.lower else min(high, end.value)
        special = end.point if isinstance(end.point, SpecialPoint) and value == end.value else None
        yield value, (arc.strobes(value)[0][0] if special is None else special.point.state)
