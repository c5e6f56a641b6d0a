"""Periodic orbits by Newton's method on the stroboscopic map, with its exact Jacobian."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import isfinite
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.flow.march import LONGEST, start_state
from gearlash.system import Record, Status, given

TOLERANCE = 1e-11  # of the residual, relative to max(1, |z|); above it a status is not ok
GOAL = 2e-14  # Newton goes on to here, or until rounding stops it
ITERATIONS = 25


@dataclass(frozen=True, eq=False, repr=False)
class Shot(Record):
    """A solution of P^period(z) = z: state (n,), period in base periods, residual (∞-norm of the return
    relative to max(1, |z|)), monodromy (n, n), and ``error``: an estimate, to first order, of the largest
    error of a component of the state, from residual and rounding. ``contacts`` (4·clearances,) as in
    `flow.Strobes`, over the whole period, where they were counted; ``strobes`` (period, n) the states at
    phase zero, where they were marched.
    """

    _told: ClassVar = ("status", "period", "residual", "error", "iterations", "state")

    state: NDArray[np.float64]
    period: int
    residual: float
    monodromy: NDArray[np.float64]
    error: float
    iterations: int
    status: Status
    contacts: NDArray[np.int64] | None = None
    strobes: NDArray[np.float64] | None = None


def shoot(
    props: Propagators,
    guess: ArrayLike,
    period: int,
    iterations: int = ITERATIONS,
    reach: float | None = None,
) -> Shot:
    """Newton's method from ``guess`` (n,) for a fixed point of the ``period``-fold map. Steps that make the
    residual grow tenfold end the search with status `not-converged`. With ``reach`` a guess is expected to be
    near: the search ends too where the first step is longer, or does not make the residual smaller, and where
    two steps have not halved it."""
    z: NDArray[np.float64] = start_state(props, guess)
    period = given.whole("period", period, 1, LONGEST)
    iterations = given.whole("iterations", iterations)
    reach = None if reach is None else given.number("reach", reach)
    cycles, unit = float(period * props.system.cycles), np.eye(len(z))
    best: tuple[NDArray[np.float64], float, flow.Carried, int] | None = None
    residuals: list[float] = []
    for iteration in range(iterations):
        end = flow.variational(props, z, cycles)
        if end.jacobian is None or end.status not in (Status.OK, Status.UNCERTAIN):
            return _failed(z, period, iteration, end.status) if best is None else _shot(period, *best)
        defect = end.state - z
        residual = float(np.abs(defect).max()) / max(1.0, float(np.abs(z).max()))
        if best is None or residual < best[1]:
            best = z, residual, end, iteration
        elif residual > 10.0 * best[1] or best[1] <= TOLERANCE:
            break
        residuals.append(residual)
        if residual <= GOAL or (reach is not None and _hopeless(residuals)):
            break
        try:
            step = np.linalg.solve(end.jacobian - unit, defect)
        except np.linalg.LinAlgError:
            break
        length = float(np.abs(step).max())
        if not isfinite(length) or (reach is not None and iteration == 0 and length > reach):
            break
        z = z - step
    assert best is not None
    return _shot(period, *best)


def _hopeless(residuals: list[float]) -> bool:
    if len(residuals) == 2:
        return residuals[1] > residuals[0]
    return len(residuals) > 2 and residuals[-1] > 0.5 * residuals[-3]


def _shot(period: int, z: NDArray[np.float64], residual: float, end: flow.Carried, iteration: int) -> Shot:
    """A shot with its error |(J - I)^-1| · (residual + rounding of the return): to first order."""
    assert end.jacobian is not None
    rounding = 1e-15 * (1.0 + np.abs(end.jacobian).sum(axis=1).max())
    try:
        gain = float(np.abs(np.linalg.inv(end.jacobian - np.eye(len(z)))).sum(axis=1).max())
    except np.linalg.LinAlgError:
        gain = np.inf
    error = gain * (residual + rounding) * max(1.0, float(np.abs(z).max()))
    converged = end.status if residual <= TOLERANCE else Status.NOT_CONVERGED
    return Shot(z, period, residual, end.jacobian, error, iteration, converged, end.contacts)


def _failed(z, period, iteration, status: Status) -> Shot:
    n = len(z)
    return Shot(z, period, np.inf, np.full((n, n), np.nan), np.inf, iteration, status)


def minimal(props: Propagators, shot: Shot) -> Shot:
    """The same orbit with its least period: returns at every proper divisor must differ by far more than the
    error. Where one does not, the orbit of that divisor is solved for; where both readings stand within
    the error, the status becomes `uncertain`."""
    if shot.period == 1 or not np.isfinite(shot.error):
        return shot
    strobes = flow.march(props, shot.state, shot.period).states
    shot = replace(shot, strobes=strobes[:-1])
    scale = max(1.0, float(np.abs(strobes).max()))
    for divisor in (d for d in range(1, shot.period) if shot.period % d == 0):
        distance = float(np.abs(strobes[divisor] - strobes[0]).max())
        if distance > max(1e3 * shot.error, 1e-9 * scale):
            continue
        smaller = shoot(props, shot.state, divisor)
        near = np.abs(smaller.state - shot.state).max() <= max(1e4 * shot.error, 1e-8 * scale)
        if smaller.residual <= TOLERANCE and near:
            return smaller
        if distance <= 10.0 * shot.error:
            return replace(shot, status=Status.UNCERTAIN)
    return shot
