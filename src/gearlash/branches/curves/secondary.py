"""Functions along a curve that vanish where a second thing happens.

Source: Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory (2004), ch. 9 and 10,
doi:10.1007/978-1-4757-3978-7."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

import numpy as np

from .conditions import At, Double, Turning, circle_cosine
from .node import Node
from .plane import Array
from .points import CodimTwoKind
from .problem import Problem

Function = Callable[[Node], float]
SECOND_STEP, THIRD_STEP = 1e-3, 2e-3  # of scaled states: for second and third derivatives of the map
CLEAR = 0.02  # of the distance of the nearest extremum from its boundary: the same
LEAST_SECOND_STEP, LEAST_THIRD_STEP = 1e-9, 2e-5
ALONG = 1e-10  # of multipliers, and of distances in units of the motion: what is less is rounding
OTHER = 0.5  # of the step: another one, by which the error is told
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


def holds_along(test: Function, left: Node, right: Node) -> bool:
    """Whether a condition on multipliers holds on both of two neighbours: where motions of the plane are
    multiples of each other it holds all along a curve, and a sign of its test function is rounding."""
    known: dict[Function, Function] = {
        fold: _away_from(1.0),
        flip: _away_from(-1.0),
        torus: _away_from_circle,
    }
    away = known.get(test)
    return away is not None and max(away(left), away(right)) <= ALONG


def _away_from(value: float) -> Function:
    return lambda node: float(np.abs(node.spectrum.multipliers - value).min())


def _away_from_circle(node: Node) -> float:
    multipliers = node.spectrum.multipliers
    first, second = np.triu_indices(len(multipliers), 1)
    return float(np.abs(multipliers[first] * multipliers[second] - 1.0).min())


@lru_cache(maxsize=8)
def quadratic(node: Node, part: float = 1.0) -> float:
    """Change of the condition along the null vector, by differences over a part of the step: the quadratic
    coefficient of the fold. At a touch that of the side with the contact goes to infinity."""
    here, size, condition = node.here, node.problem.size, node.problem.conditions[0]
    right, _ = _null(node)
    width = part * max(LEAST_SECOND_STEP, min(SECOND_STEP, CLEAR * node.motion.nearest(here)))

    def value(k: float) -> float:
        flow = here.carried_from(here.problem.state(here.u) + k * width * right * size)[1][-1]
        return condition.value(flow * size / size[:, None])

    return (8.0 * (value(1.0) - value(-1.0)) - (value(2.0) - value(-2.0))) / (12.0 * width)


@lru_cache(maxsize=8)
def cubic(node: Node, part: float = 1.0) -> float:
    """The cubic coefficient of the doubling, from differences of the exact Jacobian over a part of the step:
    at its zero the doubled orbit changes sides. NaN where a boundary is so near that the map is not smooth
    within the differences: at a touch the coefficient of the side with the contact goes to infinity."""
    right, left = _null(node)
    width = min(THIRD_STEP, CLEAR * node.motion.nearest(node.here))
    if width < LEAST_THIRD_STEP:
        return float("nan")
    width *= part
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


BY_DIFFERENCES: dict[CodimTwoKind, Function] = {
    CodimTwoKind.CUSP: lambda node: quadratic(node, OTHER),
    CodimTwoKind.GENERALISED_DOUBLING: lambda node: cubic(node, OTHER),
}
"""The functions that are no more than their differences, by those over another step."""


def with_both(kind: CodimTwoKind, node: Node) -> Problem:
    """The equations of a point of a curve where multipliers coincide: the condition of the curve and
    another one."""
    problem = node.problem
    (condition,) = problem.conditions
    if kind is CodimTwoKind.FOLD_FLIP:
        other = At.MINUS_ONE if condition.at is At.ONE else At.ONE
        return problem.with_condition(other, node.here)
    double = condition.at is not At.CIRCLE
    return replace(problem, further=(Double(condition) if double else Turning(TURNS[kind]),))


def _null(node: Node) -> tuple[Array, Array]:
    """Right and left null vectors, of unit length, their signs those of the borders."""
    condition = node.problem.conditions[0]
    right, left = condition.solved(node.here.scaled_monodromy)
    return right[:-1] / np.linalg.norm(right[:-1]), left[:-1] / np.linalg.norm(left[:-1])


def _turning(cosine: float) -> Function:
    return lambda node: circle_cosine(node.spectrum.multipliers) - cosine


def curvature(node: Node) -> float:
    """H″ of the touch."""
    return float(node.touch_series[0][2])


def jerk(node: Node) -> float:
    """H‴ of the touch."""
    return float(node.touch_series[0][3])
