"""A curve restarted where it meets a grazing.

On the side where the extremum is clear the curve goes straight on to the touch. Beyond it a multiplier moves
like the root of the depth d, so that the curve of the other side leaves along the grazing curve, d growing as
the square of the way. Its first point is therefore sought on the curve of one small depth, along which
everything is smooth: there the condition on the multiplier is one equation for one unknown. Sources:
M. di Bernardo, C. Budd, A. Champneys, P. Kowalczyk, Piecewise-smooth Dynamical Systems (2008), ch. 8,
doi:10.1007/978-1-84628-708-4; docs/theory for the orders of contact."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .conditions import Condition
from .locate import Met
from .newton import Corrected, correct, tangent
from .node import Node, node_of
from .plane import UNBUILT, Array
from .problem import Evaluated, Problem

DEPTHS = (1e-7, 1e-6, 1e-5, 1e-4)  # of the size of the motion
LONGEST_WAY = 0.3  # scaled: how far from the touch the first point may lie
SECANTS = 30


def clear_side(met: Met) -> Node | None:
    """The touching orbit as a point of the curve of the side without the contact, its direction that way."""
    here, extremum = met.here, met.touched[0]
    n, k = here.problem.states, len(here.problem.touches)
    u = np.concatenate([here.u[:n], here.u[n + k :]])
    kept = tuple(
        (float(phase), touch.window)
        for phase, touch in zip(here.problem.phases(here.u), here.problem.touches, strict=True)
    )
    problem = replace(here.problem, touches=(), kept=kept)
    gradient = np.concatenate([met.jacobian[n, :n], met.jacobian[n, n + k :]]) * np.sign(extremum.a0)
    try:
        node = node_of(Corrected(Evaluated(problem, u, here.props), np.empty(0)), gradient, None)
    except UNBUILT:
        return None
    motion = replace(node.motion, extrema=node.motion.extrema.after(met.motion.extrema))
    return replace(node, motion=motion, touching=frozenset({extremum.number}))


def beyond(met: Met) -> tuple[Node, ...]:
    """The first points of the curve of the side with the contact, in order; their directions lead away from
    the touch. None where none was found."""
    found: list[Node] = []
    for depth in DEPTHS:
        node = _at_depth(met, depth)
        if node is not None and node.problem.plane.inside(node.place):
            found.append(node)
        elif found:
            break
    return tuple(found)


def _at_depth(met: Met, depth: float) -> Node | None:
    here = met.here
    condition = here.problem.conditions[0]
    touch, extremum = here.problem.touches[0], met.touched[0]
    deeper = -1.0 if extremum.a0 > 0.0 else 1.0  # a minimum goes below its boundary
    size = float(here.surface_size(touch.window)[0])
    shifted = replace(touch, depth=-deeper * depth * size, held=False)
    problem = replace(here.problem, touches=(shifted,), conditions=())
    smooth = met.jacobian[:-1]
    row = tangent(smooth, np.ones(len(here.u)))
    slope = float(met.jacobian[-1] @ row)
    found: dict[float, Corrected] = {}

    def value(place: float) -> float:
        corrected = correct(problem, here.u + place * row, row, float(row @ here.u) + place)
        if corrected.here is None:
            raise RuntimeError(corrected.failure)
        found[place] = corrected
        return condition.value(corrected.here.scaled_monodromy)

    from scipy.optimize import newton  # here, as it loads for long

    try:
        first = -value(0.0) / slope
        if not abs(first) < LONGEST_WAY:
            return None
        place = float(newton(value, first, x1=1.1 * first, tol=1e-9 * abs(first), maxiter=SECANTS))
        solution = found.get(place) or correct(
            problem, here.u + place * row, row, float(row @ here.u) + place
        )
        return _without_touch(met, solution, condition) if abs(place) < LONGEST_WAY else None
    except (RuntimeError, *UNBUILT):
        return None


def _without_touch(met: Met, solution: Corrected, condition: Condition) -> Node | None:
    """A point of the curve of the condition alone, near that at the depth."""
    here = solution.here
    if here is None:
        return None
    n, k = here.problem.states, len(here.problem.touches)
    problem: Problem = replace(here.problem, touches=(), conditions=(condition,), kept=())
    u: Array = np.concatenate([here.u[:n], here.u[n + k :]])
    away = u - np.concatenate([met.here.u[:n], met.here.u[n + k :]])
    away /= np.linalg.norm(away)
    corrected = correct(problem, u, away, float(away @ u))
    if corrected.here is None:
        return None
    node = node_of(corrected, away, None)
    return replace(node, motion=replace(node.motion, extrema=node.motion.extrema.after(met.motion.extrema)))
