"""Periodic orbits by Newton's method on the stroboscopic map, with its exact Jacobian."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.system import Status

TOLERANCE = 1e-11  # of the residual, relative to max(1, |z|); above it a status is not ok
GOAL = 2e-14  # Newton goes on to here, or until rounding stops it
ITERATIONS = 25


@dataclass(frozen=True, eq=False)
class Shot:
    """A solution of P^period(z) = z: state (n,), period in base periods, residual (∞-norm of the return
    relative to max(1, |z|)), monodromy (n, n), and a bound on the error of the state from residual and
    rounding."""

    state: NDArray[np.float64]
    period: int
    residual: float
    monodromy: NDArray[np.float64]
    error: float
    iterations: int
    status: Status


def shoot(
    props: Propagators, guess: ArrayLike, period: int, iterations: int = ITERATIONS, patient: bool = True
) -> Shot:
    """Newton's method from ``guess`` (n,) for a fixed point of the ``period``-fold map. Steps that make the
    residual grow tenfold end the search with status `not-converged`; without patience, so does a residual
    that two steps have not halved."""
    z = np.array(guess, dtype=np.float64)
    cycles = float(period * props.system.cycles)
    best: Shot | None = None
    residuals: list[float] = []
    for iteration in range(iterations):
        end = flow.variational(props, z, cycles)
        if end.jacobian is None or end.status not in (Status.OK, Status.UNCERTAIN):
            return best or _failed(z, period, iteration, end.status)
        defect = end.state - z
        scale = max(1.0, float(np.abs(z).max()))
        residual = float(np.abs(defect).max()) / scale
        if best is None or residual < best.residual:
            best = _shot(z, period, residual, end.jacobian, iteration, end.status)
        elif residual > 10.0 * best.residual or best.residual <= TOLERANCE:
            break
        residuals.append(residual)
        hopeless = not patient and iteration >= 2 and residual > 0.5 * residuals[-3]
        if residual <= GOAL or hopeless:
            break
        try:
            z = z - np.linalg.solve(end.jacobian - np.eye(len(z)), defect)
        except np.linalg.LinAlgError:
            break
        if not np.isfinite(z).all():
            break
    assert best is not None
    return best


def _shot(z, period, residual, jacobian, iteration, status) -> Shot:
    """A shot with the error bound |(J - I)^-1| · (residual + rounding of the return)."""
    rounding = 1e-15 * (1.0 + np.abs(jacobian).sum(axis=1).max())
    try:
        gain = float(np.abs(np.linalg.inv(jacobian - np.eye(len(z)))).sum(axis=1).max())
    except np.linalg.LinAlgError:
        gain = np.inf
    scale = max(1.0, float(np.abs(z).max()))
    error = gain * (residual + rounding) * scale
    converged = status if residual <= TOLERANCE else Status.NOT_CONVERGED
    return Shot(z.copy(), period, residual, jacobian, error, iteration, converged)


def _failed(z, period, iteration, status: Status) -> Shot:
    n = len(z)
    return Shot(z, period, np.inf, np.full((n, n), np.nan), np.inf, iteration, status)


def minimal(props: Propagators, shot: Shot) -> Shot:
    """The same orbit with its least period: returns at every proper divisor must differ by far more than the
    error bound. Where one does not, the orbit of that divisor is solved for; where both readings stand within
    the error, the status becomes `uncertain`."""
    if shot.period == 1 or not np.isfinite(shot.error):
        return shot
    strobes = flow.march(props, shot.state, shot.period).states
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
            return Shot(**{**shot.__dict__, "status": Status.UNCERTAIN})
    return shot
