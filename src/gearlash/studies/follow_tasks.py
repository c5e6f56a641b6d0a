"""Tasks of following: the branch of an orbit, the branches that meet it at a special point, and the motion
that a state leads to. Workers do them; which of them are worth while is decided in `followed`."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches.continuation import (
    Branch,
    ContinuationSettings,
    EndKind,
    EndOfBranch,
    SpecialKind,
    SpecialPoint,
    continue_orbit,
    switched,
)
from gearlash.jobs import Part, stopping
from gearlash.orbits import Settings, orbit_at
from gearlash.system import Family, GearlashError

from .model import Source
from .point import evaluate
from .work import MANY

Array = NDArray[np.float64]

LONGEST = 0.3  # step; on a large motion one of a small motion's size is short
SAME = 1e-6  # of the size of a motion: what agrees so well is the same
DOUBLED, BROKEN, SINGLE = "doubling", "symmetry breaking", "orbit of half its period"
GOES_ON = "goes on as a branch that was followed before"


@dataclass(frozen=True, eq=False)
class Question:
    """What is asked of every branch: the parameter and its limits, all else fixed."""

    source: Source
    fixed: tuple[tuple[str, float], ...]
    name: str
    lower: float
    upper: float
    settings: Settings

    def values(self, family: Family, value: float) -> dict[str, float]:
        return family.complete({**dict(self.fixed), self.name: value})

    @property
    def width(self) -> float:
        return self.upper - self.lower


@dataclass(frozen=True, eq=False)
class Seed:
    """A periodic orbit with which a branch begins, and how it was found."""

    value: float
    state: Array
    periods: int
    way: str


@dataclass(frozen=True, eq=False)
class Cut:
    """Where a branch was followed no farther as it has as many orbits as were allowed: its last orbit, and
    whether it would go on upwards."""

    value: float
    strobes: Array
    up: bool

    def is_end_of(self, branch: Branch, upper: bool) -> bool:
        """Whether a branch that comes from beyond it ends in the same orbit; ``upper``: at its last end."""
        strobes = branch.points[-1 if upper else 0].strobes
        size = max(float(np.abs(strobes).max()), 1e-3)
        return strobes.shape == self.strobes.shape and distance(strobes, self.strobes[0]) <= SAME * size


@dataclass(frozen=True, eq=False)
class Follow:
    """A task: the branch of a seed, of at most so many orbits each way, and no farther than to where another
    one was cut: between ``above`` the nearest such place below it and ``below`` the nearest one above it."""

    question: Question
    seed: Seed
    most_points: int = MANY
    above: Cut | None = None
    below: Cut | None = None

    @property
    def lower(self) -> float:
        return self.question.lower if self.above is None else self.above.value

    @property
    def upper(self) -> float:
        return self.question.upper if self.below is None else self.below.value

    def joined(self, branch: Branch) -> Branch | None:
        """The branch, whose ends at a cut say that another one goes on there. None where one of them is no
        orbit of that other branch."""
        ends = []
        for i, end in enumerate(branch.ends):
            cut = {EndKind.LOWER: self.above, EndKind.UPPER: self.below}.get(end.kind)
            if cut is not None and not cut.is_end_of(branch, i > 0):
                return None
            ends.append(end if cut is None else EndOfBranch(EndKind.ARRIVED, end.value, GOES_ON))
        return replace(branch, lower=self.question.lower, upper=self.question.upper, ends=tuple(ends))


@dataclass(frozen=True, eq=False)
class Traced:
    """A branch, and how many orbits were computed for it: those of a first attempt count, too."""

    branch: Branch
    orbits: int


@dataclass(frozen=True, eq=False)
class Switch:
    """A task: orbits of the branches that meet one at a special point."""

    question: Question
    branch: Branch
    special: SpecialPoint


@dataclass(frozen=True, eq=False)
class Look:
    """A task: what motion from a state leads to at a value."""

    question: Question
    value: float
    state: Array


def follow_branch(task: Follow, carry: object) -> Part:
    """The branch of a seed, or why there is none."""
    q, seed = task.question, task.seed
    family = q.source.family()
    steps = ContinuationSettings(longest=LONGEST, most_points=task.most_points, certify=False)
    try:
        values = q.values(family, seed.value)
        orbit = orbit_at(flow.propagators(family.system(values)), seed.state, seed.periods)
        if orbit is None:
            return Part(("its orbit was not found again",))

        def between(low: float, high: float) -> Branch:
            return continue_orbit(family, values, q.name, orbit, low, high, steps, None, stopping)

        found = between(task.lower, task.upper)
        orbits = len(found.points)
        if not stopping() and (task.above or task.below):
            joined = task.joined(found)
            found = joined or between(q.lower, q.upper)
            orbits += 0 if joined else len(found.points)
    except (GearlashError, np.linalg.LinAlgError) as error:
        return Part((str(error),))
    return Part(()) if stopping() else Part((Traced(found, orbits),))


def switch_branch(task: Switch, carry: object) -> Part:
    """Seeds on the other branches at a special point."""
    family = task.question.source.family()
    way = {SpecialKind.DOUBLING: DOUBLED, SpecialKind.JOINS: SINGLE}.get(task.special.kind, BROKEN)
    try:
        found = switched(family, task.branch, task.special)
    except (GearlashError, np.linalg.LinAlgError):
        return Part(((),))
    inside = [s for s in found if task.question.lower <= s.value <= task.question.upper]
    return Part((tuple(Seed(s.value, s.orbit.state, s.orbit.shot.period, way) for s in inside),))


def look(task: Look, carry: object) -> Part:
    """The attractor that a state leads to."""
    q = task.question
    family = q.source.family()
    values = q.values(family, task.value)
    return Part((evaluate(family, values, q.name, task.state, None, q.settings, None)[0],))


def cuts_of(branch: Branch) -> Iterator[Cut]:
    """The ends of a branch at which as many orbits were had as were allowed."""
    for end, point, ahead in zip(
        branch.ends, (branch.points[0], branch.points[-1]), (-1.0, 1.0), strict=True
    ):
        if end.kind is EndKind.POINTS:
            yield Cut(point.value, point.strobes, ahead * point.turn > 0.0)


def distance(strobes: Array, state: Array) -> float:
    """Of a state from the nearest of an orbit's."""
    return float(np.abs(strobes - state).max(axis=1).min())
