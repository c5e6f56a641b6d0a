"""The variational flow as orbits need it: over whole base periods with the states on the way, and from place
to place. Arguments are not checked here, as every orbit asks several times: callers have checked them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearlash.system import Status

from ._tables import Array
from .propagators import Propagators
from .run import run_one, with_doubt


class Lap(NamedTuple):
    """States (stretches+1, n) at equal phases from phase zero on; the Jacobian (n, n) of the last with
    respect to the first; contacts (4·clearances,) as in `Strobes`."""

    states: Array
    jacobian: Array
    contacts: NDArray[np.int64]
    status: Status

    @property
    def end(self) -> Array:
        return self.states[-1]


def lap(props: Propagators, z: Array, stretches: int, stretch: float = 1.0) -> Lap:
    """Carries a state (n,) from phase zero over stretches of so many base periods each (or of a half, a
    quarter: a power of two, exact then)."""
    tangents = np.eye(len(z))
    status, states, counts = run_one(
        props, z.copy(), 0.0, stretch * props.cells, stretches, tangents=tangents
    )
    contacts = counts.sum(axis=0)
    status = with_doubt(status, int(contacts[-1]))
    return Lap(states, np.ascontiguousarray(tangents.T), contacts[:-1], status)


def chain(props: Propagators, z: Array, places: list[float], stop: float) -> Array:
    """Carries a state (n,) from phase zero through ``places``, ascending, to ``stop``, all in cells.
    Returns the Jacobians (m+1, n, n): to the first place, from each to the next, from the last to the end."""
    state, n, before = z.copy(), len(z), 0.0
    steps, period = np.empty((len(places) + 1, n, n)), props.cells
    for step, after in zip(steps, [*places, stop], strict=True):
        tangents = np.eye(n)
        base = before // period * period
        run_one(props, state, before - base, after - before, 1, tangents=tangents)
        step[:] = tangents.T
        before = after
    return steps
