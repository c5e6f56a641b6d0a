"""Periodic orbits and where their multipliers reach the unit circle, solved for by simple shooting in 80 bit.

Nothing of the package is used but the numbers of a `System`: the flow and its derivative, through events too,
are those of `region_oracle`. A fold or a doubling is where the bordered matrix

    [ M - μ I   b ] [v]   [0]
    [   cᵀ      0 ] [g] = [1]          M the monodromy, μ = 1 or -1

has g = 0; a Neimark-Sacker point where a pair of multipliers has modulus 1. With the return to the start
these are as many equations as unknowns (state, parameter). Their Jacobian takes differences where M is
differentiated, so Newton converges linearly, with a factor of about 1e-6 a step; the equations are exact.

W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria (2000), doi:10.1137/1.9780898719543.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from gearlash.system import System

from . import region_oracle
from .clearances import Real
from .motion import Walk

Test = Callable[[np.ndarray], float]
"""A number made of a monodromy that is zero at the point looked for."""

STEP = 1e-7  # of differences, over the size of what is moved
ITERATIONS = 14


@dataclass(frozen=True)
class Returns:
    """The return map of a line of systems: ``build`` of the parameter, carried over ``cycles`` mesh cycles.

    ``mirrored``: the state is then turned into its negative. Half a period of an orbit that is symmetric
    under X → -X half a period later is such a return; the square of its monodromy is that of the whole.
    """

    build: Callable[[float], System]
    cycles: float
    mirrored: bool = False

    def walk(self, state: np.ndarray, value: float) -> Walk:
        """From phase zero, with the derivative."""
        return region_oracle.run(self.build(float(value)), state, self.cycles, variational=True)

    def image(self, state: np.ndarray, value: float) -> tuple[np.ndarray, np.ndarray]:
        """The state after one return, and the derivative by the first."""
        walk, sign = self.walk(state, value), -1 if self.mirrored else 1
        assert walk.jacobian is not None
        return sign * walk.state, sign * walk.jacobian


@dataclass(frozen=True)
class Found:
    """An orbit, and the parameter at which it is what was looked for. ``defect``: of the equations."""

    state: np.ndarray
    value: float
    monodromy: np.ndarray
    defect: float

    @property
    def multipliers(self) -> np.ndarray:
        return np.linalg.eigvals(self.monodromy.astype(float))


def closed(returns: Returns, state, value: float) -> Found:
    """The orbit near a state at one value of the parameter."""
    z = np.asarray(state, dtype=Real)
    for _ in range(ITERATIONS):
        image, monodromy = returns.image(z, value)
        step = refined(monodromy - np.eye(len(z)), image - z)
        z = z - step
        if np.abs(step).max() < 1e-16 * max(1.0, float(np.abs(z).max())):
            break
    image, monodromy = returns.image(z, value)
    return Found(z, float(value), monodromy, float(np.abs(image - z).max()))


def multiplier_at(returns: Returns, state, value: float, mu: float, scale: float = 1.0) -> Found:
    """Where a multiplier is ``mu`` (1: fold, -1: doubling), near an orbit. ``scale``: of the parameter."""
    left, right = _borders(returns.image(np.asarray(state, Real), value)[1].astype(float), mu)

    def test(monodromy: np.ndarray) -> float:
        return bordered(monodromy, mu, left, right)

    return solved(returns, state, value, test, scale)


def torus_at(returns: Returns, state, value: float, near: complex, scale: float = 1.0) -> Found:
    """Where the pair of multipliers near ``near`` has modulus 1."""

    def test(monodromy: np.ndarray) -> float:
        multipliers = np.linalg.eigvals(monodromy.astype(float))
        return float(np.abs(multipliers[np.argmin(np.abs(multipliers - near))]) - 1.0)

    return solved(returns, state, value, test, scale)


def endless_at(returns: Returns, state, value: float, scale: float = 1.0) -> Found:
    """Where motions of every size are closed: ``returns`` are those without excitation and gaps, which carry
    a multiple of a state into the same multiple of its image. ``state``: the direction."""
    z, p = np.asarray(state, dtype=Real), float(value)
    along = z / (z @ z)
    best: Found | None = None
    for _ in range(ITERATIONS):
        image, monodromy = returns.image(z, p)
        defect = np.append(image - z, along @ z - 1)
        found = Found(z, p, monodromy, float(np.abs(defect).max() / np.abs(z).max()))
        if best is not None and found.defect > 0.3 * best.defect and best.defect < 1e-11:
            break
        best, there = found, float(p + STEP * scale)
        by_value = (returns.image(z, there)[0] - image) / (Real(there) - Real(p))
        rows = np.vstack([monodromy - np.eye(len(z)), along])
        change = refined(np.column_stack([rows, np.append(by_value, Real(0))]), defect)
        z, p = z - change[:-1], float(p - change[-1])
    assert best is not None
    return best


def bordered(monodromy: np.ndarray, mu: float, left: np.ndarray, right: np.ndarray) -> float:
    """g: zero where ``mu`` is a multiplier."""
    n = len(monodromy)
    matrix = np.zeros((n + 1, n + 1), dtype=Real)
    matrix[:n, :n] = monodromy - mu * np.eye(n)
    matrix[:n, n], matrix[n, :n] = left, right
    return float(refined(matrix, np.eye(n + 1)[n])[n])


def _borders(monodromy: np.ndarray, mu: float) -> tuple[np.ndarray, np.ndarray]:
    """Left and right vectors of the smallest singular value: with them the bordered matrix is regular."""
    left, _, right = np.linalg.svd(monodromy - mu * np.eye(len(monodromy)))
    return left[:, -1], right[-1]


def solved(returns: Returns, state, value: float, test: Test, scale: float) -> Found:
    """Newton on (return = start, test = 0) for (state, parameter)."""
    n = len(state)
    z, p = np.asarray(state, dtype=Real), float(value)
    size = max(1e-3, float(np.abs(z).max()))
    best: Found | None = None
    for _ in range(ITERATIONS):
        image, monodromy = returns.image(z, p)
        defect = np.append(image - z, Real(test(monodromy)))
        found = Found(z, p, monodromy, float(np.abs(defect).max()))
        if best is not None and found.defect > 0.3 * best.defect and best.defect < 1e-11:
            break
        best = found
        jacobian = np.zeros((n + 1, n + 1), dtype=Real)
        jacobian[:n, :n] = monodromy - np.eye(n)
        for i in range(n + 1):
            step = Real(STEP * (size if i < n else scale))
            moved, there = z.copy(), p
            if i < n:
                moved[i] += step
            else:
                there = float(p + step)
                step = Real(there) - Real(p)
            other, matrix = returns.image(moved, there)
            if i == n:
                jacobian[:n, n] = (other - image) / step
            jacobian[n, i] = (test(matrix) - defect[n]) / step
        change = refined(jacobian, defect)
        z, p = z - change[:n], float(p - change[n])
    assert best is not None
    return best


def refined(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Solution of a linear system in 80 bit: LAPACK's, corrected twice by its residual."""
    low, b = matrix.astype(float), np.asarray(right, dtype=Real)
    x = np.linalg.solve(low, b.astype(float)).astype(Real)
    for _ in range(2):
        x = x + np.linalg.solve(low, (b - matrix @ x).astype(float))
    return x
