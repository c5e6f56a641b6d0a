"""Newton's method for one more point of a branch, and the direction in which it goes on.

The equations of the orbit are bordered by one row, which says how far along a direction the point lies. The
bordered matrix is regular at folds too. Source: H. B. Keller, Numerical solution of bifurcation and nonlinear
eigenvalue problems (1977); E. Allgower and K. Georg, Introduction to Numerical Continuation Methods (2003),
doi:10.1137/1.9780898719154."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .equations import UNBUILT, Array, Equations, Evaluated

GOAL = 2e-14  # residual at which Newton's method ends
ROUNDED = 1e-13  # residual that is accepted where rounding makes the steps
ENOUGH = 1e-12  # residual that is accepted where it no longer becomes smaller
CORRECTOR_ITERATIONS = 12
NOISE = 1e-11  # lengths of steps that rounding makes
SLOW = 0.01  # contraction from which on a derivative along the parameter that was handed over is taken anew
CONTRACTION = 0.7  # each step must be shorter than so much of the one before
HELD = 0.02  # component of a row along the parameter from which on that may be held after the first step
NEAR = 1e-3  # length of a first step after which it is


@dataclass(frozen=True, eq=False)
class Corrected:
    """A point of the branch: its evaluation, the derivative along the parameter beside it, the lengths of
    Newton's steps (the first tells how far the guess was off), and why there is none."""

    here: Evaluated | None
    slope: Array
    steps: tuple[float, ...]
    failure: str = ""

    @property
    def contraction(self) -> float:
        """Of the first two steps of Newton's method; 0 where one was enough."""
        return self.steps[1] / self.steps[0] if len(self.steps) > 1 and self.steps[0] > 1e-9 else 0.0


def correct(
    equations: Equations,
    guess: Array,
    row: Array,
    target: float,
    slope: Array | None = None,
    *,
    near: bool = False,
) -> Corrected:
    """The orbit with row·u = ``target`` near ``guess``. ``slope``: a derivative along the parameter that is
    near enough, so that it need not be taken anew. ``near``: so near to the target is near enough; then the
    parameter is held after the first step, away from folds, and no other system need be built."""
    none = np.empty(0) if slope is None else slope
    try:
        return _newton(equations, guess.copy(), row, target, slope, near)
    except UNBUILT as error:
        return Corrected(None, none, (), f"there is no system that could be built: {error}")


def _newton(
    equations: Equations, u: Array, row: Array, target: float, slope: Array | None, near: bool
) -> Corrected:
    steps: list[float] = []
    best: Evaluated | None = None
    chances = 2
    fresh = not row[:-1].any()  # along the parameter no step depends on the derivative by it
    if fresh and slope is None:
        slope = np.zeros(len(u) - 1)
    for iteration in range(CORRECTOR_ITERATIONS):
        here = equations.evaluate(u)
        if here is None:
            return Corrected(None, np.empty(0), tuple(steps), "the motion could not be carried")
        if best is None or here.residual < best.residual:
            best = here
        if here.residual <= GOAL and iteration > 0:
            break
        if best.residual <= ENOUGH and (best is not here or (steps and steps[-1] < 1e-13)):
            break
        if slope is None:
            slope, fresh = equations.slope(here), True
        step, length = _step(equations, here, slope, row, target)
        slow = len(steps) > 0 and length > max(NOISE, SLOW * steps[-1])
        if slow and not fresh:
            slope, fresh = equations.slope(here), True
            step, length = _step(equations, here, slope, row, target)
        elif slow and length > CONTRACTION * steps[-1] and chances > 0 and best.residual > ROUNDED:
            chances -= 1  # behind a touch the first steps may be as long as the map is bent
        elif slow and length > CONTRACTION * steps[-1]:
            if best.residual <= ROUNDED:  # rounding makes the steps: two branches meet near by
                break
            return Corrected(None, slope, (*steps, length), "Newton's method does not contract")
        if not np.isfinite(length):
            return Corrected(None, slope, tuple(steps), "Newton's method meets a singular matrix")
        steps.append(length)
        u = u + step
        if near and iteration == 0 and abs(row[-1]) > HELD and length < NEAR:
            row, target, fresh = along_parameter(u), float(u[-1]), True
    assert best is not None
    assert slope is not None
    if best.residual > ENOUGH:
        return Corrected(None, slope, tuple(steps), f"Newton's method stays at {best.residual:.0e}")
    return Corrected(best, slope, tuple(steps))


def along_parameter(u: Array) -> Array:
    """The row that says the value of the parameter."""
    row = np.zeros_like(u)
    row[-1] = 1.0
    return row


def _step(
    equations: Equations, here: Evaluated, slope: Array, row: Array, target: float
) -> tuple[Array, float]:
    """Of Newton's method, and its length."""
    right = np.append(-here.defect, target - row @ here.u)
    step = equations.solve(here, slope, row, right)
    return step, float(np.linalg.norm(step))


def tangent(equations: Equations, here: Evaluated, slope: Array, toward: Array) -> Array:
    """Unit vector along the branch, with a positive component along ``toward``."""
    right = np.zeros(len(here.u))
    right[-1] = 1.0
    found = equations.solve(here, slope, toward, right)
    return found / np.linalg.norm(found)
