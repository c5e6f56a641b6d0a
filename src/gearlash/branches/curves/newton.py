"""Newton's method for a point of a curve, or for one where two things happen at once.

The Jacobian is kept from point to point and improved by every step (Broyden): another system would have to
be built for each parameter otherwise. Source: J. E. Dennis, R. B. Schnabel, Numerical Methods for
Unconstrained Optimization and Nonlinear Equations (1996), ch. 8, doi:10.1137/1.9781611971200."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .plane import UNBUILT, Array
from .problem import Evaluated, Problem

GOAL = 1e-14  # residual at which it ends where two things happen at once
ON_CURVE = 5e-13  # the same on a curve
PLAIN = 1e-11  # the same in no units, of equations that change fast, too: as far as rounding allows
ENOUGH = 2e-11  # residual that is accepted where it no longer becomes smaller
NO_STEP = 1e-14  # a step that is rounding
ITERATIONS = 20
SLOW = 0.1  # contraction from which on the Jacobian is taken anew
OLD = 1e-4  # a step behind which the Jacobian is taken anew, where no other system need be built for it
WORSE = 2.0  # growth of the residual, with a new Jacobian, that ends it
LONGEST = 0.5  # a step, in scaled unknowns


@dataclass(frozen=True, eq=False)
class Corrected:
    """The solution, the Jacobian beside it, the lengths of the steps, and why there is none; then ``nearest``
    is what came nearest to one."""

    here: Evaluated | None
    jacobian: Array
    steps: tuple[float, ...] = ()
    failure: str = ""
    nearest: Evaluated | None = None

    @property
    def contraction(self) -> float:
        """Of the first two steps; 0 where one was enough."""
        return self.steps[1] / self.steps[0] if len(self.steps) > 1 and self.steps[0] > 1e-8 else 0.0


def correct(
    problem: Problem,
    guess: Array,
    row: Array | None = None,
    target: float = 0.0,
    jacobian: Array | None = None,
) -> Corrected:
    """The solution near ``guess``; of a curve the one with row·u = ``target``."""
    reached: list[Evaluated] = []
    try:
        return _newton(problem, guess.copy(), row, target, jacobian, reached)
    except UNBUILT as error:
        return Corrected(None, np.empty(0), (), str(error), reached[-1] if reached else None)


def _newton(
    problem: Problem,
    u: Array,
    row: Array | None,
    target: float,
    jacobian: Array | None,
    reached: list[Evaluated],
) -> Corrected:
    steps: list[float] = []
    here = problem.evaluate(u)
    fresh = jacobian is None
    jacobian = here.jacobian() if jacobian is None else jacobian
    best, least = here, left_over(here, jacobian)
    reached.append(best)
    for _ in range(ITERATIONS):
        along = 0.0 if row is None else target - float(row @ u)
        at_goal = least <= (GOAL if row is None else ON_CURVE) and abs(along) <= ON_CURVE
        if at_goal and float(np.abs(here.residual).max()) <= PLAIN:
            break
        step = _solved(jacobian, row, here.residual, along)
        length = float(np.linalg.norm(step))
        if not np.isfinite(length):
            return Corrected(None, jacobian, tuple(steps), "Newton's method meets a singular matrix", best)
        if steps and length > SLOW * steps[-1] and not fresh and length > 1e-10:
            jacobian, fresh = here.jacobian(), True
            step = _solved(jacobian, row, here.residual, along)
            length = float(np.linalg.norm(step))
        if length > LONGEST:
            step *= LONGEST / length
        steps.append(length)
        if row is None:
            unit, place = problem.plane.unit, problem.place(u)
            step = step * problem.plane.part_within(place, step[-len(place) :] * unit)
            if not step.any():  # at the end of a range
                break
        u = u + step
        after = problem.evaluate(u)
        left = left_over(after, jacobian)
        if not left <= WORSE * least and fresh and len(steps) > 3:
            break
        exact = row is None and problem.is_plain and length > OLD
        jacobian = after.jacobian() if exact else _improved(jacobian, after.residual - here.residual, step)
        stalled = left >= 0.5 * least and left <= ENOUGH
        here, fresh = after, exact
        if left < least:
            best, least = after, left
            reached.append(best)
        if stalled or length <= NO_STEP or (length <= 1e-13 and left <= ENOUGH):
            break
    if least > ENOUGH:
        return Corrected(None, jacobian, tuple(steps), f"Newton's method stays at {least:.0e}", best)
    return Corrected(best, jacobian, tuple(steps))


def _improved(jacobian: Array, change: Array, step: Array) -> Array:
    """By what a step has changed (Broyden)."""
    return jacobian + np.outer(change - jacobian @ step, step) / float(step @ step)


def left_over(here: Evaluated, jacobian: Array) -> float:
    """What is left of the equations; of those that change fast, in units of the change: rounding of the
    unknowns is all that can be asked for."""
    return float((np.abs(here.residual) / np.maximum(1.0, np.linalg.norm(jacobian, axis=1))).max())


def _solved(jacobian: Array, row: Array | None, residual: Array, along: float) -> Array:
    if row is not None:
        jacobian, residual = np.vstack([jacobian, row]), np.append(residual, -along)
    if jacobian.shape[0] > jacobian.shape[1]:  # more equations than unknowns: a degenerate touch that is flat
        return -np.linalg.lstsq(jacobian, residual, rcond=None)[0].astype(np.float64)
    return -np.linalg.solve(jacobian, residual).astype(np.float64)


def tangent(jacobian: Array, toward: Array) -> Array:
    """Unit vector along a curve, with a positive component along ``toward``."""
    found = np.linalg.svd(jacobian)[2][-1].astype(np.float64)
    return found if float(found @ toward) >= 0.0 else -found
