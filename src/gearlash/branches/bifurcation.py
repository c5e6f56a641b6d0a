"""Doublings and folds: where a multiplier of a periodic orbit is -1 or +1.

Unknowns z0 and μ, equations P(z0) = z0 and det(DP - λ I) = 0, by Newton's method; regular at a fold too. Source:
Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory, ch. 10, doi:10.1007/978-1-4757-3978-7.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import flow
from ..flow import Propagators
from ..orbits import Orbit
from ..orbits.floquet import ordered
from ..orbits.shooting import Shot
from ..system import Family, Status
from .kinds import SMOOTH

Array = NDArray[np.float64]
ITERATIONS = 30
STEP = 1e-6
NAMES = {-1: "period doubling", 1: "fold"}


@dataclass(frozen=True, eq=False)
class BifurcationPoint:
    """Where a multiplier is ``multiplier`` (±1): value of parameter ``name`` with its error estimate, state (n,) at phase
    zero, label of the orbit there, all its multipliers."""

    name: str
    value: float
    error: float
    values: Mapping[str, float]
    multiplier: int
    period: int
    state: Array
    label: str
    multipliers: NDArray[np.complex128]
    residual: float
    status: Status

    @property
    def kind(self) -> str:
        return NAMES[self.multiplier]

    @property
    def type(self) -> str:
        """As the article's Table 2 names it."""
        return SMOOTH


def locate_multiplier(
    family: Family, values: Mapping[str, float], name: str, orbit: Orbit, multiplier: int
) -> BifurcationPoint:
    """The value of ``name`` nearest to the orbit's at which a multiplier of it is ``multiplier`` (-1 or +1)."""
    period = orbit.shot.period
    cycles = float(orbit.period)
    n = len(orbit.state)
    unknown = np.append(orbit.state, float(values[name]))
    best, residual, change = unknown, np.inf, np.inf
    props = None

    def build(mu: float, reuse: Propagators | None = None) -> Propagators:
        return flow.propagators(family.system({**values, name: mu}), reuse)

    def equations(props: Propagators, z: Array) -> tuple[Array, Array]:
        end = flow.variational(props, z, cycles)
        assert end.jacobian is not None
        determinant = np.linalg.det(end.jacobian - multiplier * np.eye(n))
        return np.append(end.state - z, determinant), end.jacobian

    for _ in range(ITERATIONS):
        props = build(float(unknown[-1]), props)
        value, jacobian = equations(props, unknown[:-1])
        size = float(np.abs(value).max())
        if not np.isfinite(size):
            break
        if size < residual:
            best, residual = unknown.copy(), size
        elif residual <= 1e-12:
            break
        matrix = np.empty((n + 1, n + 1))
        matrix[:n, :n] = jacobian - np.eye(n)
        scale = STEP * max(1.0, float(np.abs(unknown[:-1]).max()))
        for i in range(n):
            shift = scale * np.eye(n)[i]
            up, down = equations(props, unknown[:-1] + shift)[0], equations(props, unknown[:-1] - shift)[0]
            matrix[n, i] = (up[n] - down[n]) / (2 * scale)
        step = STEP * max(abs(unknown[-1]), 1e-3)
        up, down = (equations(build(float(unknown[-1]) + d, props), unknown[:-1])[0] for d in (step, -step))
        matrix[:, n] = (up - down) / (2 * step)
        move = np.linalg.lstsq(matrix, -value, rcond=None)[0]
        limit = min(1.0, 0.05 * abs(unknown[-1]) / max(abs(move[-1]), 1e-300))
        unknown = unknown + limit * move
        change = abs(float(limit * move[-1]))
        if residual <= 1e-14:
            break
    props = build(float(best[-1]))
    _, jacobian = equations(props, best[:-1])
    status = Status.OK if residual <= 1e-10 else Status.NOT_CONVERGED
    shot = Shot(best[:-1], period, residual, jacobian, residual, 0, status)
    return BifurcationPoint(
        name=name,
        value=float(best[-1]),
        error=change,
        values={**values, name: float(best[-1])},
        multiplier=multiplier,
        period=orbit.period,
        state=best[:-1],
        label=Orbit(props, shot, 0, status, "").label,
        multipliers=ordered(np.linalg.eigvals(jacobian)),
        residual=residual,
        status=status,
    )
