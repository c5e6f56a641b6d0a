"""Points of a curve where a second thing happens, solved for together with the first."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from gearlash.branches.continuation.extrema import Extremum

from .conditions import At
from .motion import CurveOrbit
from .newton import correct
from .node import Node, solved, touch_of, well_begun
from .plane import UNBUILT, Array
from .points import CodimTwoKind
from .problem import Evaluated, Problem
from .secondary import Function, with_both

NEAR = 3.0  # times the length of a step: how far a point may lie from where it was found
ON_CIRCLE = 1e-7  # distance of a pair from the unit circle
NEARLY_FLAT = 1e-3  # H‴ in units of the motion: where it is less, it may be none
SECANTS = 60
FIRST_WAY, CLOSE = 0.01, 1e-6  # scaled: of secants along a grazing curve
NO_NUMBER = -1  # of an extremum that is none on both sides
NUDGE = 1e-3  # of a step: so far beside a zero its function is looked at again, for its error
ZERO = 1e-13  # of the way: a bracket so narrow is a place
THROUGH_INFINITY = 1e-2  # of the values at both ends: a zero at which more is left is none


@dataclass(frozen=True, eq=False)
class Met:
    """Two conditions at once: the kind, the solution (or the orbit of the curve where one is a zero of a test
    function only), the Jacobian of the equations there, its motion, what touches, more in words; of such a
    zero how far (2,) it may be off along the curve."""

    kind: CodimTwoKind
    here: Evaluated
    jacobian: Array
    motion: CurveOrbit
    touched: tuple[Extremum, ...]
    note: str = ""
    along: Array | None = None

    @property
    def solved(self) -> bool:
        """Whether both conditions were solved for together."""
        return self.along is None

    @property
    def place(self) -> Array:
        return self.here.problem.place(self.here.u)

    @property
    def errors(self) -> Array:
        """(2,) of the parameters: what is left, times how far they move with it."""
        gains = np.abs(np.linalg.pinv(self.jacobian)[-2:]) @ (np.abs(self.here.residual) + 4e-16)
        found: Array = gains * self.here.problem.plane.unit + 1e-15 * np.abs(self.place)
        return found if self.along is None else found + self.along


def touch_on(node: Node, extremum: Extremum, guess: Array | None = None) -> Met | None:
    """On a curve of a condition: where an extremum touches. ``guess``: the curve's unknowns near there."""
    try:
        begun = well_begun(node, [extremum.phase])
    except UNBUILT:
        return None
    touch, phase = touch_of(begun, extremum)
    n = begun.problem.states
    u = begun.u if guess is None or begun is not node else guess
    problem = replace(begun.problem, touches=(touch,), kept=())
    found = _two(problem, np.concatenate([u[:n], [phase], u[n:]]), begun)
    return None if found is None else replace(found, kind=_with_touch(found))


def touch_along(node: Node, extremum: Extremum) -> Met | None:
    """On a curve of a condition: where an extremum of little depth touches, which may be far ahead. It is
    sought along the grazing curve beside, on which the condition is smooth."""
    try:
        begun = well_begun(node, [extremum.phase])
    except UNBUILT:
        return None
    touch, phase = touch_of(begun, extremum)
    n, condition = begun.problem.states, begun.problem.conditions[0]
    both = replace(begun.problem, touches=(touch,), kept=())
    alone = replace(both, conditions=())
    first = np.concatenate([begun.u[:n], [phase], begun.u[n:]])
    row = np.concatenate([np.zeros(n + 1), begun.direction[-2:] / np.linalg.norm(begun.direction[-2:])])
    known = {0.0: first}

    def value(place: float) -> float:
        nearest = min(known, key=lambda other: abs(other - place))
        guess = known[nearest] + (place - nearest) * row
        corrected = correct(alone, guess, row, float(row @ first) + place)
        if corrected.here is None:
            raise RuntimeError(corrected.failure)
        known[place] = corrected.here.u
        return condition.value(corrected.here.scaled_monodromy)

    from scipy.optimize import newton  # here, as it loads for long

    try:
        place = float(newton(value, 0.0, x1=FIRST_WAY, tol=CLOSE, maxiter=SECANTS))
    except (RuntimeError, *UNBUILT):
        return None
    nearest = min(known, key=lambda other: abs(other - place))
    found = _two(both, known[nearest], begun)
    return None if found is None else replace(found, kind=_with_touch(found))


def _with_touch(met: Met) -> CodimTwoKind:
    at = met.here.problem.conditions[0].at
    return {
        At.ONE: CodimTwoKind.GRAZING_FOLD,
        At.MINUS_ONE: CodimTwoKind.GRAZING_DOUBLING,
        At.CIRCLE: CodimTwoKind.GRAZING_TORUS,
    }[at]


def multiplier_on(left: Node, right: Node, part: float, at: At) -> Met | None:
    """On a grazing curve: where a condition on multipliers holds, near a part of the way."""
    guess = left.u + part * (right.u - left.u)
    try:
        there = left.problem.evaluate(guess)
        problem = left.problem.with_condition(at, there)
    except UNBUILT:
        return None
    found = _two(problem, guess, left)
    if found is None:
        return None
    linear = not any(map(any, found.motion.signature.counts))
    if at is At.ONE:
        return replace(found, kind=CodimTwoKind.CORNER if linear else CodimTwoKind.GRAZING_FOLD)
    if at is At.MINUS_ONE:
        return replace(found, kind=CodimTwoKind.GRAZING_DOUBLING)
    values = np.linalg.eigvals(found.here.monodromy)
    pairs = values[values.imag > 0.0]
    if not len(pairs) or float(np.abs(np.abs(pairs) - 1.0).min()) > ON_CIRCLE:
        return None
    return replace(found, kind=CodimTwoKind.GRAZING_TORUS)


def second_touch(left: Node, right: Node, number: int) -> Met | None:
    """On a grazing curve: where another extremum touches, too."""
    one, two = left.extrema.by_number[number], right.extrema.by_number[number]
    part = one.distance / (one.distance - two.distance)
    first = left.touched
    try:
        begun = well_begun(left, [*(each.phase for each in first), one.phase])
    except UNBUILT:
        return None
    guess = begun.u if begun is not left else left.u + part * (right.u - left.u)
    n = begun.problem.states
    touch, phase = touch_of(begun, one)
    moved = (two.phase - one.phase + 0.5 * left.here.cycles) % left.here.cycles - 0.5 * left.here.cycles
    phases = np.append(begun.problem.phases(guess), phase + part * moved)
    problem = replace(begun.problem, touches=(*begun.problem.touches, touch))
    found = _two(problem, np.concatenate([guess[:n], phases, guess[-2:]]), begun)
    return None if found is None else replace(found, kind=CodimTwoKind.TWO_GRAZINGS)


def coinciding(left: Node, right: Node, part: float, kind: CodimTwoKind) -> Met | None:
    """On a curve of a condition: where two multipliers are one, or a pair turns by a part of a circle."""
    found = _two(with_both(kind, left), left.u + part * (right.u - left.u), left)
    return None if found is None else replace(found, kind=kind)


def degenerate(left: Node, right: Node, part: float) -> Met | None:
    """On a grazing curve: where H″ = 0."""
    found = _degenerate(left, left.u + part * (right.u - left.u), (2,))
    if found is None:
        return None
    window, here = found.here.problem.touches[0].window, found.here
    size = float(here.surface_size(window)[0]) * here.props.system.omega**3
    flat = None
    if abs(here.at_touch(0)[3]) <= NEARLY_FLAT * size:
        flat = _degenerate(left, here.u, (2, 3))
    return (
        replace(found, kind=CodimTwoKind.DEGENERATE)
        if flat is None
        else replace(flat, kind=CodimTwoKind.FLAT)
    )


def flat(left: Node, right: Node, part: float) -> Met | None:
    """On a grazing curve: where H″ = 0 and H‴ = 0. That is one equation too many: it has a solution where
    a symmetry, or a third parameter, has been chosen so."""
    found = _degenerate(left, left.u + part * (right.u - left.u), (2, 3))
    return None if found is None else replace(found, kind=CodimTwoKind.FLAT)


def _degenerate(left: Node, guess: Array, orders: tuple[int, ...]) -> Met | None:
    touches = tuple(replace(each, zero=orders, held=False) for each in left.problem.touches)
    return _two(replace(left.problem, touches=touches), guess, left)


def _two(problem: Problem, guess: Array, near: Node) -> Met | None:
    """The solution of both conditions near a point of a curve."""
    corrected = correct(problem, guess)
    if corrected.here is None:
        return None
    try:
        problem = problem.near(corrected.here)
        here = Evaluated(problem, corrected.here.u, corrected.here.props)
        jacobian, motion = here.jacobian(), CurveOrbit.of(here)
    except UNBUILT:
        return None
    motion = replace(motion, extrema=motion.extrema.after(near.extrema))
    return Met(CodimTwoKind.CUSP, here, jacobian, motion, _touched(here, motion))


def _touched(here: Evaluated, motion: CurveOrbit) -> tuple[Extremum, ...]:
    """What touches. A degenerate one is no extremum that the motion would show."""
    found = []
    for k, touch in enumerate(here.problem.touches):
        phase, window = float(here.problem.phases(here.u)[k]), touch.window
        extremum = None if touch.zero else motion.beside(phase, window)
        if extremum is None:
            series = here.at_touch(k)
            place, side = phase % motion.cycles, (window.clearance, window.surface, window.boundary)
            extremum = Extremum(NO_NUMBER, *side, place, float(series[0]), float(series[2]))
        found.append(extremum)
    return tuple(found)


class _LostError(Exception):
    """An orbit on the way could not be had."""


@dataclass(frozen=True, eq=False)
class Zero:
    """The orbit of a curve where a function along it vanishes, and by how much (2,) the parameters may be
    off."""

    node: Node
    error: Array


def zero_between(left: Node, right: Node, test: Function, other: Function | None = None) -> Zero | None:
    """Where a test function vanishes between two points of a curve; None where an orbit on the way cannot be
    had, or the function only jumps, or changes sign through infinity. ``other``: the same function, computed
    in another way: by what both differ its error is told."""
    length = float(np.linalg.norm(right.u - left.u))
    row = (right.u - left.u) / length
    ends = {0.0: left, length: right}
    most = max(abs(test(left)), abs(test(right)))

    def node_at(place: float) -> Node:
        if place not in ends:
            guess = left.u + place * row
            node = solved(left.problem, guess, row, float(row @ left.u) + place, left)[0]
            if node is None:
                raise _LostError
            ends[place] = node
        return ends[place]

    from scipy.optimize import brentq  # here, as it loads for long

    def value(at: float) -> float:
        found = test(node_at(float(at)))
        if not np.isfinite(found):  # a boundary is so near that the map is not smooth there
            raise _LostError
        return found

    try:
        place: Any = brentq(value, 0.0, length, xtol=ZERO * length, maxiter=SECANTS)
        place = float(place)
        node, beside = node_at(place), [node_at(place + k * NUDGE * length) for k in (-1.0, 1.0)]
    except (_LostError, RuntimeError):
        return None
    here, below, above = (test(each) for each in (node, *beside))
    if not abs(here) <= THROUGH_INFINITY * most:
        return None
    unsure = abs(here) + abs(above + below - 2.0 * here) + (0.0 if other is None else abs(other(node) - here))
    slope = abs(above - below) / (2.0 * NUDGE * length)
    moved = np.abs(beside[1].place - beside[0].place) / (2.0 * NUDGE * length)
    return Zero(node, moved * min(unsure / max(slope, 1e-300), length))


def named(kind: CodimTwoKind, zero: Zero, note: str = "") -> Met:
    """A zero of a test function along a curve."""
    node = zero.node
    return Met(kind, node.here, node.jacobian, node.motion, tuple(node.touched), note, zero.error)
