"""A branch of periodic orbits with heyoka: pseudo-arclength on its variational flow, derivatives by the
parameter included, crossings as terminal events, extrema as events, multipliers by numpy. As one would write
it with that integrator at hand: fixed steps, one compilation for the whole branch, nothing solved for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import heyoka as hy
import numpy as np
from numpy.typing import NDArray

from .heyoka import TOLERANCE, _nonzero, _series
from .plain import Array, Pair

NEWTON = 8
GOAL = 1e-13  # of the defect, and of the last step
BRANCH = "variational equations in state and parameter, events, Newton with fixed steps of arclength"
OMEGA, GAP, SWITCH, SIDE = 0, 1, 2, 3  # places among the runtime parameters


@dataclass(frozen=True, eq=False)
class Point:
    """One orbit of a branch: parameter, state (n,), multipliers (n,), extrema of X in the order they come."""

    value: float
    state: Array
    multipliers: NDArray[np.complex128]
    extrema: tuple[float, ...]


class Branch:
    """Orbits of ``period`` base periods of the pairs that differ from ``pair`` in ω or in D alone."""

    def __init__(self, pair: Pair, name: str, period: int):
        self.n, self.period, self.name = pair.system.size, period, name
        self.omega, self.edge = pair.system.omega, pair.edge
        self.extrema: list[float] = []
        box: list[Any] = []
        equations, gap, velocity = _equations(pair)
        free = hy.par[OMEGA if name == "omega" else GAP]
        states = [variable for variable, _ in equations]
        variational = hy.var_ode_sys(equations, [*states, free], order=1)
        place = self.n - 2

        def turned(ta, time, sign):
            ta.update_d_output(time)
            self.extrema.append(float(ta.d_output[place]))

        self.integrator: Any = hy.taylor_adaptive(
            variational,
            np.zeros(self.n * (2 + self.n)),
            tol=TOLERANCE,
            pars=np.zeros(4),
            t_events=[
                hy.t_event(gap - hy.par[GAP], callback=_crossing(box, 1)),
                hy.t_event(gap + hy.par[GAP], callback=_crossing(box, -1)),
            ],
            nt_events=[hy.nt_event(velocity, callback=turned)],
            fast_math=True,
        )
        box.append(self.integrator.pars)

    def follow(self, z: Array, value: float, length: float, points: int, upper: float) -> list[Point]:
        """At the most so many points from an orbit on, in the direction of rising values, until ``upper``."""
        u, found = np.append(z, value), []
        row = np.zeros(self.n + 1)
        row[-1] = 1.0
        u, matrix = self._corrected(u, row)
        direction = row
        while u is not None and len(found) < points and u[-1] <= upper:
            jacobian = matrix[:-1, :-1] + np.eye(self.n)
            found.append(
                Point(u[-1], u[:-1], np.linalg.eigvals(jacobian).astype(np.complex128), tuple(self.extrema))
            )
            matrix[-1] = direction
            tangent = np.linalg.solve(matrix, row)
            direction = tangent / np.linalg.norm(tangent)
            u, matrix = self._corrected(u + length * direction, direction)
        return found

    def _corrected(self, guess: Array, row: Array) -> tuple[Array | None, Array]:
        """The orbit on the plane through the guess, and the bordered matrix there."""
        u, n = guess.copy(), self.n
        matrix, right = np.empty((n + 1, n + 1)), np.zeros(n + 1)
        for _ in range(NEWTON):
            right[:n] = u[:n] - self._carried(u, matrix)
            matrix[n], right[n] = row, row @ (guess - u)
            step = np.linalg.solve(matrix, right)
            if np.abs(right).max() < GOAL or np.abs(step).max() < GOAL:
                return u, matrix
            u = u + step
        return None, matrix

    def _carried(self, u: Array, matrix: Array) -> Array:
        """The end of the orbit; its derivatives by state and parameter, less the start's, into the matrix."""
        ta, n = self.integrator, self.n
        omega, edge = (u[n], self.edge) if self.name == "omega" else (self.omega, u[n])
        side = int(u[n - 2] > edge) - int(u[n - 2] < -edge)
        ta.time = 0.0
        ta.state[:n] = u[:n]
        ta.state[n:] = np.eye(n, n + 1).ravel()
        ta.pars[:] = omega, edge, float(abs(side)), float(side)
        ta.reset_cooldowns()
        self.extrema.clear()
        ta.propagate_until(float(self.period))
        matrix[:n] = ta.state[n:].reshape(n, n + 1)
        matrix[:n, :n] -= np.eye(n)
        return ta.state[:n]


def _equations(pair: Pair) -> tuple[Any, Any, Any]:
    """Of a pair over base periods, with ω, D and the region as runtime parameters; X and X'. The error drives
    X through its second derivative, so its forcing goes with the square of the speed."""
    n, p = pair.system.size, pair.numbers
    z = hy.make_vars(*[f"z{i}" for i in range(n)])
    phase = 2.0 * np.pi * hy.time
    faster = (hy.par[OMEGA] / float(pair.system.omega)) ** 2.0
    forced = {k: float(p.forcing[k]) * (faster if k else 1.0) for k in _nonzero(p.forcing)}
    eta = _series({k: float(p.stiffness[k]) for k in _nonzero(p.stiffness)}, phase)
    gap, velocity = z[n - 2], z[n - 1]
    force = eta * (hy.par[SWITCH] * gap - hy.par[SIDE] * hy.par[GAP]) + p.damping * velocity
    rates = []
    for i in range(n // 2):
        terms = [c * z[2 * i + k] for k, c in enumerate(p.own[i].tolist()) if c]
        if 2 * i + 2 == n:
            terms = [c * z[j] for j, c in enumerate(p.last.tolist()) if c] + [_series(forced, phase)]
        rates += [z[2 * i + 1], hy.sum([*terms, float(p.g[i]) * force])]
    duration = 2.0 * np.pi * pair.system.cycles / hy.par[OMEGA]
    return [(var, duration * rate) for var, rate in zip(z, rates, strict=True)], gap, velocity


def _crossing(box: list, boundary: int) -> Any:
    """Callback of a terminal event: writes the region into the parameters."""

    def switch(ta, sign):
        outward, pars = sign == boundary, box[0]
        pars[SWITCH], pars[SIDE] = (1.0, float(boundary)) if outward else (0.0, 0.0)
        return True

    return switch
