"""Why an orbit can be followed no farther, and above all whether it ends in a fold.

For a stable orbit that is followed, `is_fold` decides that, and nothing else does: from a fold that was
solved for, or, where none was, from the step that no shortening helps. `Outcome` says what else it may be:
an orbit that loses its stability, joins the one of half its period, or is lost. A jump between two orbits of
one label is a fold like any other: labels are not asked, only whether the orbit itself goes on. On a branch
in arclength folds are solved for in `continuation/locate.py`."""

from __future__ import annotations

from enum import StrEnum

from gearlash.orbits import orbit_at

from .bifurcation import BifurcationPoint, born_by_doubling
from .grazing_point import GrazingPoint
from .node import Node, Pair
from .stepping import Line, Refusal
from .steps import member

SolvedPoint = GrazingPoint | BifurcationPoint
FOLD_NEAR = 1e-3  # of the scale: a fold is believed from an orbit so near
FOLD_APART = 0.1  # of the orbit's ranges: and that lies so near in the state
AT_ONE = 0.99  # a leading multiplier above it, where no step is short enough, is that of a fold


class Outcome(StrEnum):
    """Why an orbit is followed no farther."""

    ARRIVED = "arrived"
    FOLD = "the orbit ends in a fold"
    TOUCH = "beyond the touch the orbit is not stable, or not found"
    DOUBLING = "beyond the doubling no stable orbit was found"
    PERIOD = "beyond the doubling the period is longer than was to be followed"
    UNSTABLE = "the orbit loses its stability"
    UNBUILT = "beyond it no system can be built"
    LOST = "the orbit could not be followed farther"


def is_fold(line: Line, last: Node, stopped: BifurcationPoint | Refusal | None) -> bool:
    """Whether the branch of an orbit ends in a fold just beyond ``last``.

    ``stopped`` is a point with the multiplier +1 that was solved for from there: it is that fold if it lies
    close by, both in the parameter and in the state, and no touch lies between. Or it is the reason why even
    the shortest step was refused: a fold was met if Newton's method finds no orbit in the place where it
    should be, while a multiplier has come to +1, and the orbit is not one that was born at a doubling."""
    if isinstance(stopped, BifurcationPoint):
        return (
            stopped.multiplier > 0
            and is_close(line, last, stopped)
            and not _touches_before(line, last, stopped)
        )
    alone = stopped in (Refusal.NEWTON, Refusal.FAR)
    orbit = last.orbit
    at_one = orbit.leading.imag == 0.0 and orbit.leading.real > AT_ONE
    return alone and at_one and not born_by_doubling(orbit.propagators, orbit.state, orbit.shot.period)


def is_close(line: Line, before: Node, point: BifurcationPoint) -> bool:
    """Whether an orbit lies so close to where a branch ends, or joins another, that no step is short enough:
    there it leaves as the root of the distance."""
    near = abs(point.value - before.value) <= FOLD_NEAR * line.scale
    return near and before.apart(point.state) <= FOLD_APART


def _touches_before(line: Line, before: Node, point: BifurcationPoint) -> bool:
    """Whether an extremum lies on the other side of its boundary at a point than before it."""
    props = member(line.family, line.values, line.name, point.value, before.orbit.propagators)
    there = orbit_at(props, point.state, before.orbit.shot.period, iterations=1)
    return there is None or Pair(before, Node(point.value, there)).crossed


def ends_branch(point: SolvedPoint, orbit: Node) -> bool:
    """Whether the branch of an orbit ends at a point ahead: in a fold, or in the orbit of half its period."""
    return isinstance(point, BifurcationPoint) and (point.multiplier > 0 or point.period < orbit.orbit.period)


def at_point(point: SolvedPoint, before: Node, longest: int) -> Outcome:
    """Of an orbit that was followed to a point, and not beyond it."""
    if isinstance(point, GrazingPoint):
        return Outcome.TOUCH
    if point.multiplier > 0:
        return Outcome.FOLD
    if point.period < before.orbit.period:
        return Outcome.DOUBLING
    return Outcome.PERIOD if 2 * before.orbit.shot.period > longest else Outcome.DOUBLING


def without_point(line: Line, last: Node, refusal: Refusal | None) -> Outcome:
    """Of an orbit from which the shortest step was refused, with nothing solved for that explains it."""
    if refusal is Refusal.UNBUILT:
        return Outcome.UNBUILT
    if refusal is Refusal.UNSTABLE:
        return Outcome.UNSTABLE
    return Outcome.FOLD if is_fold(line, last, refusal) else Outcome.LOST
