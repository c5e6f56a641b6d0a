"""The other grazing curve through a corner of a contact-only orbit.

Where a multiplier of a linear orbit is 1 and the forcing is orthogonal to the adjoint null vector, orbits
exist with every amplitude along the null vector, from the one that touches to another one that touches with
another extremum. Each lies on a grazing curve of its own; the two cross in the plane."""

from __future__ import annotations

from gearlash import flow
from gearlash.branches.continuation.extrema import Extremum
from gearlash.system import GearlashError

from .conditions import At, Condition
from .motion import CurveOrbit
from .node import Node, state_at
from .plane import Array
from .problem import Evaluated

LEAST, LARGEST = 1e-4, 1e4  # scaled: amplitudes between which the other touch is sought
HALVINGS = 60


def at_other_end(node: Node) -> tuple[Array, Extremum]:
    """The orbit (n,) at phase zero that touches with another extremum, and that. Raises `GearlashError` where
    none does."""
    here, n = node.here, node.problem.states
    condition = Condition.near(At.ONE, here.scaled_monodromy)
    null = condition.right
    deeper = float(node.jacobian[n, :n] @ null) * node.touch_series[0][2]
    away = null * node.problem.size * (1.0 if deeper > 0.0 else -1.0)
    state, origin = here.problem.state(here.u), here.problem.origin

    def meets(amplitude: float) -> bool:
        carried = flow.carry(here.props, state + amplitude * away, here.cycles, origin)
        return bool(carried.contacts.any())

    high = LEAST
    while not meets(high):
        high *= 2.0
        if high > LARGEST:
            raise GearlashError("at this corner no other orbit was found that touches")
    low = 0.5 * high
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if meets(middle) else (middle, high)
    u = here.u.copy()
    u[:n] += low * away / here.problem.size
    there = Evaluated(node.problem, u, here.props)
    return state_at(there, 0.0), min(CurveOrbit.of(there).extrema.all, key=lambda e: abs(e.distance))
