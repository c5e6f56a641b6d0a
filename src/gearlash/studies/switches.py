"""From branch to branch: at the special points of one to those that are born there, and on to theirs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gearlash import flow
from gearlash.branches.continuation import (
    Branch,
    ContinuationSettings,
    SpecialKind,
    SpecialPoint,
    Switched,
    continue_orbit,
    switched,
)
from gearlash.jobs import Execution
from gearlash.orbits import Orbit, orbit_at
from gearlash.system import Family

from .following import Following
from .model import Model, Source

BORN = (SpecialKind.DOUBLING, SpecialKind.BRANCH_POINT, SpecialKind.JOINS, SpecialKind.SYMMETRIC)
"""Kinds of points at which another branch of periodic orbits begins."""
MOST_BRANCHES = 32
SAME = 1e-6  # of the largest state: orbits that lie nearer to each other are one


@dataclass(frozen=True, eq=False)
class SwitchedBranch:
    """A branch, and where it was switched to: at special point ``at`` (from 0) of branch ``parent``; the
    first one has none (-1)."""

    branch: Branch
    parent: int = -1
    at: int = -1


@dataclass(frozen=True)
class NotSwitched:
    """Why no branch was followed from a special point: ``known``: the branch there (from 0) that was followed
    already, or ``why`` in words."""

    parent: int
    at: int
    known: int = -1
    why: str = ""


def with_switches(
    model: Model,
    first: Branch,
    points: Sequence[int] | None,
    depth: int,
    steps: ContinuationSettings | None = None,
    execution: Execution | None = None,
) -> tuple[tuple[SwitchedBranch, ...], tuple[NotSwitched, ...]]:
    """A branch with those that begin at its special points (``points``: their numbers, from 0; None: all),
    and at all of theirs, ``depth`` branches deep. Orbits that lie on a branch which was followed already are
    not followed once more."""
    family, listener = Source.of(model).family(), Following(Execution() if execution is None else execution)
    found, missed = [SwitchedBranch(first)], _none_begins(first, points or ())
    queue = [(0, i, 1) for i in _born(first) if points is None or i in points]
    while queue and not listener.stop():
        parent, i, level = queue.pop(0)
        branch = found[parent].branch
        others = switched(family, branch, branch.special[i])
        if not others:
            missed.append(NotSwitched(parent, i, why="no orbit of another branch was found near by"))
        for one in others:
            known = _on(family, [each.branch for each in found], one)
            if not branch.lower <= one.value <= branch.upper:
                missed.append(NotSwitched(parent, i, why="its first orbit lies outside the limits"))
            elif known >= 0:
                missed.append(NotSwitched(parent, i, known=known))
            elif len(found) == MOST_BRANCHES:
                missed.append(NotSwitched(parent, i, why=f"{MOST_BRANCHES} branches were followed before"))
            else:
                values = {**branch.values, branch.name: one.value}
                limits = branch.name, one.orbit, branch.lower, branch.upper
                grown = continue_orbit(family, values, *limits, steps, listener.tell, listener.stop)
                found.append(SwitchedBranch(grown, parent, i))
                if level < depth:
                    queue += [(len(found) - 1, j, level + 1) for j in _born(grown)]
    missed += [NotSwitched(parent, i, why="interrupted before") for parent, i, _ in queue]
    return tuple(found), tuple(missed)


def born_at(special: SpecialPoint) -> bool:
    """Whether another branch of periodic orbits begins there."""
    return special.kind in BORN


def _none_begins(branch: Branch, points: Sequence[int]) -> list[NotSwitched]:
    """The points that were asked for at which no branch begins."""
    count, found = len(branch.special), []
    for i in points:
        if i >= count:
            many = f"{count} special point{'' if count == 1 else 's'}"
            found.append(NotSwitched(0, i, why=f"the branch has {many}"))
        elif not born_at(branch.special[i]):
            kind = branch.special[i].kind
            found.append(NotSwitched(0, i, why=f"at a {kind} no other branch of periodic orbits begins"))
    return found


def _born(branch: Branch) -> list[int]:
    return [i for i, special in enumerate(branch.special) if born_at(special)]


def _on(family: Family, branches: Sequence[Branch], one: Switched) -> int:
    """The branch on which an orbit lies, -1: none. The orbits of each at the same value are solved for, from
    those beside it."""
    for i, branch in enumerate(branches):
        props = None
        for left, right in branch.at(one.value):
            if len(left.strobes) != len(one.orbit.strobes):
                continue
            props = flow.propagators(family.system({**branch.values, branch.name: one.value}), props)
            apart = right.value - left.value
            share = (one.value - left.value) / apart if apart else 0.0
            guess = left.state + share * (right.state - left.state)
            here = orbit_at(props, guess, len(left.strobes))
            if here is not None and _same(here, one.orbit):
                return i
    return -1


def _same(one: Orbit, other: Orbit) -> bool:
    """Whether two orbits are one, begun at any of its strobes."""
    size = max(1e-12, float(np.abs(one.strobes).max()))
    turned = (np.roll(other.strobes, shift, axis=0) for shift in range(len(other.strobes)))
    return any(float(np.abs(one.strobes - each).max()) <= SAME * size for each in turned)
