"""Functions along a curve that vanish where a second thing happens.

Source: Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory (2004), ch. 9 and 10,
doi:10.1007/978-1-4757-3978-7."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from .conditions import At
from .node import Node
from .plane import Array
from .points import CodimTwoKind

Function = Callable[[Node], float]
NORMAL_STEP = 5e-4  # of scaled states: for third derivatives of the map
CLEAR = 0.1  # of the distance of the nearest extremum from its boundary: the same
LEAST_NORMAL_STEP = 2e-5
TURNS = {
    CodimTwoKind.ONE_ONE: 1.0,
    CodimTwoKind.ONE_TWO: -1.0,
    CodimTwoKind.ONE_THREE: -0.5,
    CodimTwoKind.ONE_FOUR: 0.0,
}
"""Cosine of the angle by which the pair turns."""


def of_condition(node: Node) -> dict[CodimTwoKind, Function]:
    """Of a curve of folds, doublings or Neimark-Sacker points."""
    at = node.problem.conditions[0].at
    if at is At.CIRCLE:
        return {kind: _turning(cosine) for kind, cosine in TURNS.items()}
    if at is At.ONE:
        return {CodimTwoKind.CUSP: quadratic, CodimTwoKind.ONE_ONE: product, CodimTwoKind.FOLD_FLIP: flip}
    tests = {CodimTwoKind.ONE_TWO: product, CodimTwoKind.FOLD_FLIP: fold}
    return tests if node.linear else {CodimTwoKind.GENERALISED_DOUBLING: cubic, **tests}


def flip(node: Node) -> float:
    return node.spectrum.doubling


def fold(node: Node) -> float:
    return node.spectrum.at_one


def torus(node: Node) -> float:
    return node.spectrum.torus


def product(node: Node) -> float:
    """Of the left and the right null vector: zero where the multiplier is double."""
    right, left = _null(node)
    return float(left @ right)


def quadratic(node: Node) -> float:
    """Change of the condition along the null vector: the quadratic coefficient of the fold."""
    n = node.problem.states
    return float(node.jacobian[-1, :n] @ _null(node)[0])


@lru_cache(maxsize=4)
def cubic(node: Node) -> float:
    """The cubic coefficient of the doubling, from differences of the exact Jacobian: at its zero the doubled
    orbit changes sides. NaN where a boundary is so near that the map is not smooth within the differences:
    at a touch the coefficient of the side with the contact goes to infinity."""
    right, left = _null(node)
    width = min(NORMAL_STEP, CLEAR * _nearest(node))
    if width < LEAST_NORMAL_STEP:
        return float("nan")
    here, n = node.here, node.problem.states
    left = left / float(left @ right)

    def jacobian(step: Array) -> Array:
        flow = here.carried_from(here.problem.state(here.u) + step * here.problem.size)[1][-1]
        found: Array = flow * here.problem.size / here.problem.size[:, None]
        return found

    far, up, middle, down, back = (jacobian(k * width * right) for k in (2.0, 1.0, 0.0, -1.0, -2.0))
    second = (8.0 * (up - down) - (far - back)) / (12.0 * width)
    third = (16.0 * (up + down) - (far + back) - 30.0 * middle) / (12.0 * width**2) @ right
    inner = np.linalg.solve(np.eye(n) - middle, second @ right)
    return float(left @ third / 6.0 + 0.5 * left @ (second @ inner))


def _nearest(node: Node) -> float:
    """Distance of the nearest extremum from its boundary, in units of the motion."""
    system, size = node.here.props.system, node.problem.size
    return min(
        (
            abs(e.distance) / float(np.linalg.norm(system.clearances[e.clearance].h * size))
            for e in node.extrema.all
        ),
        default=np.inf,
    )


def _null(node: Node) -> tuple[Array, Array]:
    """Right and left null vectors, of unit length, their signs those of the borders."""
    condition = node.problem.conditions[0]
    right, left = condition.solved(node.here.scaled_monodromy)
    return right[:-1] / np.linalg.norm(right[:-1]), left[:-1] / np.linalg.norm(left[:-1])


def _turning(cosine: float) -> Function:
    return lambda node: circle_cosine(node) - cosine


def circle_cosine(node: Node) -> float:
    """Half the sum of the two multipliers whose product is nearest to 1."""
    values = node.spectrum.multipliers
    first, second = np.triu_indices(len(values), 1)
    nearest = int(np.argmin(np.abs(values[first] * values[second] - 1.0)))
    return 0.5 * float((values[first[nearest]] + values[second[nearest]]).real)


def curvature(node: Node) -> float:
    """H″ of the touch."""
    return float(node.touch_series[0][2])


def jerk(node: Node) -> float:
    """H‴ of the touch."""
    return float(node.touch_series[0][3])
