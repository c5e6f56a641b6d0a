"""Where in the cycle the base periods of an orbit are begun.

Where contact damping comes and goes the acceleration jumps at a contact. If one comes to the phase at which
periods are begun, the states there have a kink along the branch, although the orbit has none. So periods are
begun elsewhere before that."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gearlash.system import ContactRule

from .equations import UNBUILT, Array, Equations
from .node import Node

NEAR_BEGINNING = 0.02  # of the base period: a contact so near to the beginning is too near
FAR = 2.0  # times as far must the nearest contact be from the new one
SLOPED = 1e-6  # a direction that has so much of the parameter is turned by it


def begun_elsewhere(node: Node) -> Node | None:
    """The same orbit with periods begun far from all contacts; None where they are so already, or nothing
    jumps, or contacts lie everywhere."""
    if not any(_jumps(c.contact, c.dampings) for c in node.here.props.system.clearances):
        return None
    cycles = float(node.here.props.system.cycles)
    phases = node.orbit.events.phase % cycles
    if not len(phases) or _distance(phases, node.equations.phase, cycles) > NEAR_BEGINNING * cycles:
        return None
    phase = _middle_of_the_widest_gap(phases, cycles)
    if _distance(phases, phase, cycles) < FAR * NEAR_BEGINNING * cycles:
        return None
    equations = Equations(
        node.equations.line, node.equations.period, node.equations.segments, node.equations.size, phase
    )
    try:
        return _begun(node, equations)
    except UNBUILT:
        return None


def _begun(node: Node, equations: Equations) -> Node | None:
    here = equations.evaluate(equations.unknowns(node.orbit, node.value), node.here.props)
    if here is None:
        return None
    slope = equations.slope(here)
    matrix = equations.matrix(here, slope, np.zeros(len(here.u)))[:-1]
    direction: Array = np.linalg.svd(matrix)[2][-1]
    if _turned(node, equations, direction):
        direction = -direction
    return replace(node, equations=equations, here=here, slope=slope, direction=direction)


def _turned(node: Node, equations: Equations, direction: Array) -> bool:
    """Whether a direction of the orbit begun elsewhere is the other way than the node's: by the parameter;
    at a fold, where that does not move, by the orbit a little farther on."""
    along = node.direction[-1] * direction[-1]
    if abs(along) > SLOPED**2:
        return bool(along < 0.0)
    there = node.equations.evaluate(node.u + SLOPED * node.direction, node.here.props)
    assert there is not None
    moved = node.equations.at_zero(there) - node.orbit.state
    here = equations.evaluate(
        equations.unknowns(node.orbit, node.value) + SLOPED * direction, node.here.props
    )
    assert here is not None
    return (
        float(moved / equations.size @ ((equations.at_zero(here) - node.orbit.state) / equations.size)) < 0.0
    )


def _jumps(rule: ContactRule, dampings: tuple[float, float]) -> bool:
    return rule is not ContactRule.ALWAYS and any(dampings)


def _distance(phases: Array, phase: float, cycles: float) -> float:
    away = np.abs(phases - phase) % cycles
    return float(np.minimum(away, cycles - away).min())


def _middle_of_the_widest_gap(phases: Array, cycles: float) -> float:
    ascending = np.sort(phases)
    widths = np.diff(np.append(ascending, ascending[0] + cycles))
    widest = int(np.argmax(widths))
    return float((ascending[widest] + 0.5 * widths[widest]) % cycles)
