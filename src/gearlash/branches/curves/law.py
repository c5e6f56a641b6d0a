"""What a touch does to the leading multiplier, along a grazing curve.

An excursion of depth d moves a simple multiplier λ as λ0 + c √d. Where c = 0 the law has no root: no fold and
no doubling lies at a small depth. Source: M. di Bernardo, C. Budd, A. Champneys, Physica D 160 (2001) 222,
doi:10.1016/S0167-2789(01)00349-9."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from gearlash.flow.regions import matrix_of
from gearlash.system import ContactRule, evaluate

from .node import Node
from .plane import Array
from .problem import Evaluated
from .touch import carried, surface_rows, traced

REAL = 1e-9  # of its modulus: imaginary part of a real multiplier


@lru_cache(maxsize=4)
def coefficient(node: Node) -> float:
    """c of the leading multiplier, without the factor 2 √(2/|a0|) that has no zero; NaN where it is not real,
    and for a touch from the gap under `no-tension`, which is linear."""
    here, touch = node.here, node.problem.touches[0]
    kick = _kick(here)
    if kick is None:
        return float("nan")
    phase = float(here.problem.phases(here.u)[0])
    index = here.leg_of(phase)
    states, flows = here.course
    after = carried(here.props, states[index], here.legs[index], phase)[1]
    first = after @ flows[index]
    gradient = surface_rows(here.props, touch.window, states[index], here.legs[index], phase, after)[0]
    values, right = np.linalg.eig(here.monodromy)
    leading = int(np.argmax(np.abs(values)))
    if abs(values[leading].imag) > REAL * abs(values[leading]):
        return float("nan")
    column = here.monodromy @ np.linalg.solve(first, kick)
    moved = np.linalg.inv(right)[leading] @ column * (gradient @ flows[index] @ right[:, leading])
    return float(moved.real)


def _kick(here: Evaluated) -> Array | None:
    """The direction (n,) in which an excursion changes the motion."""
    window, system = here.problem.touches[0].window, here.props.system
    clearance, plus = system.clearances[window.clearance], window.boundary > 0
    if window.surface == "force":
        return clearance.g
    damping = clearance.dampings[0 if plus else 1]
    series = clearance.stiffness_plus if plus else clearance.stiffness_minus
    phase = float(here.problem.phases(here.u)[0])
    kick: Array = float(evaluate(series, 2.0 * np.pi / system.cycles * phase)) * clearance.g
    if clearance.contact is ContactRule.ALWAYS or damping == 0.0:
        return kick
    if clearance.contact is ContactRule.NO_TENSION:
        return None
    index = here.leg_of(phase)
    trace = traced(here.props, here.course[0][index], here.legs[index], phase)
    sides = tuple(int(trace.regions_of(j)[-1]) for j in range(len(system.clearances)))
    found: Array = kick + damping * (matrix_of(system, sides) @ clearance.g)
    return found
