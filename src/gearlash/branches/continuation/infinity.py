"""Where a branch runs to infinity: the value of the parameter at which its orbits end to exist.

The larger a motion, the less gaps and forcing are beside it. Without them every multiple of a motion is a
motion, too: if one of them closes, there are closed ones of every size, and with the forcing in place the
branch grows without bound towards that value of the parameter, unless the forcing is orthogonal to the
adjoint null vector. For a motion that meets no boundary this is where a multiplier of its linear system is 1:
x = (I - M)⁻¹ b has no solution there (Fredholm's alternative). Source: J. K. Hale, Ordinary Differential
Equations (1980), ch. IV; for motions with impacts the field is homogeneous of degree one far out, and the
same holds with the derivative of its map."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from gearlash import flow
from gearlash.orbits import Orbit
from gearlash.system import CARRIED, System

from .changes import Change, Test
from .equations import UNBUILT, Array, Line
from .linear import homogeneous, linear_system, stays_in
from .locate import Located
from .node import Node
from .points import SpecialKind

ITERATIONS = 20
DIFFERENCE = 1e-6  # of the parameter's interval: for the derivative along it
LAST_STEP = 1e-13  # of Newton's method, relative
SOLVED = 1e-11  # what the last step may be where rounding makes it
VALUE_ROUNDING = 1e-14  # of the parameter
ROUNDING = 1e-13  # of a monodromy matrix, relative
CLEARLY = 10.0  # times its error: a number that is not zero
TOLD = 0.1  # error of a cosine from which on it tells nothing
GROWN = 30.0  # times the size of the first orbit: from there on a branch is asked whether it runs to infinity
AHEAD = 0.2  # how well the distance from that value must go as the inverse of the size


@dataclass(frozen=True, eq=False)
class AtInfinity:
    """Where motions of every size close: ``value`` of the parameter with its ``error``, the ``mode`` (n,) of
    unit length, the ``adjoint`` (n,), and the cosine between adjoint and forcing, with its error."""

    value: float
    error: float
    mode: Array
    adjoint: Array
    forcing: float
    forcing_error: float

    @property
    def orthogonal(self) -> bool:
        """Whether the forcing is orthogonal to the adjoint null vector, within the error."""
        return abs(self.forcing) <= CLEARLY * self.forcing_error

    @property
    def condition(self) -> str:
        """The adjoint condition in words."""
        if self.forcing_error > TOLD:
            return "whether the forcing is orthogonal to the adjoint null vector is not decided"
        said = "orthogonal to it" if self.orthogonal else "not orthogonal to it"
        return (
            f"the forcing is {said}: cosine to the adjoint null vector {self.forcing:.3e} ± "
            f"{self.forcing_error:.0e}"
        )


def runs_away(before: Node, node: Node) -> Located | None:
    """The end of existence that two large orbits of a branch tend to, or None."""
    line = node.equations.line
    found = at_infinity(line, node.orbit, node.value)
    if found is None:
        return None
    sizes = [float(np.linalg.norm(each.u[:-1])) for each in (before, node)]
    left = [(found.value - each.value) * size for each, size in zip((before, node), sizes, strict=True)]
    tends = sizes[1] > sizes[0] and left[1] * node.direction[-1] > 0.0
    if not tends or abs(left[0] - left[1]) > AHEAD * abs(left[1]):
        return None
    change = Change(Test.EXISTENCE)
    note = f"orbits were followed to {sizes[1]:.1e} times their scale; {found.condition}"
    return Located(change, 0.0, node, found.error, SpecialKind.EXISTENCE, note, found.value)


def at_infinity(line: Line, orbit: Orbit, value: float) -> AtInfinity | None:
    """The value nearest to ``value`` at which motions like ``orbit`` close at every size; None where there is
    none near by, or none between the limits."""
    sides, length = stays_in(orbit.trace), float(orbit.period)

    def affine(at: float) -> System:
        system = line.family.system({**line.values, line.name: at})
        return system if sides is None else linear_system(system, sides)

    try:
        found = _closed(lambda at: homogeneous(affine(at)), line, orbit, value, length)
        if found is None or not line.lower <= found[0] <= line.upper:
            return None
        at, error, mode = found
        whole = flow.variational(homogeneous(affine(at)), mode, length).jacobian
        size = 0.0 if sides is not None else float(np.abs(orbit.strobes).max())
        forced = flow.variational(affine(at), size * mode, length).state - size * mode
    except UNBUILT:
        return None
    assert whole is not None
    left, singular, _ = np.linalg.svd(whole - np.eye(len(mode)))
    adjoint, strength = left[:, -1], float(np.linalg.norm(forced))
    relative = ROUNDING * (1.0 + size / max(strength, 1e-300)) + error / line.unit
    spread = relative * max(1.0, float(singular[0])) / max(float(singular[-2]), 1e-300)
    cosine = float(adjoint @ forced) / strength if strength > 0.0 else 0.0
    return AtInfinity(at, error, mode, adjoint, cosine, spread)


def _closed(
    build: Callable[[float], System], line: Line, orbit: Orbit, value: float, length: float
) -> tuple[float, float, Array] | None:
    """Value, its error, and state of unit length of a closed motion of the homogeneous systems, by Newton's
    method from the direction of the orbit's largest state."""
    mode = orbit.state / np.linalg.norm(orbit.state)
    n, unit, last = len(mode), line.unit, np.inf
    for _ in range(ITERATIONS):
        here = flow.variational(build(value), mode, length)
        if here.status not in CARRIED or here.jacobian is None:
            return None
        step = DIFFERENCE * unit
        ends = [flow.carry(build(value + sign * step), mode, length).state for sign in (1.0, -1.0)]
        matrix = np.zeros((n + 1, n + 1))
        matrix[:n, :n] = here.jacobian - np.eye(n)
        matrix[:n, n] = (ends[0] - ends[1]) / (2.0 * DIFFERENCE)
        matrix[n, :n] = mode
        moved = np.linalg.solve(matrix, np.append(mode - here.state, 0.0))
        mode, value = mode + moved[:n], value + float(moved[n]) * unit
        size, mode = float(np.linalg.norm(moved)), mode / np.linalg.norm(mode)
        rounded = size <= SOLVED and size >= 0.5 * last
        if size <= LAST_STEP or rounded:
            return value, float(abs(moved[n])) * unit + VALUE_ROUNDING * abs(value), mode
        last = size
    return None
