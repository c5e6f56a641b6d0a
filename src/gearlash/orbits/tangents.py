"""The variational flow round a periodic orbit, and what it makes of errors.

It is cut at places that the motion itself names (just after every contact, and between contacts that lie far
apart), so that what follows from it does not depend on where phase zero lies. Errors are kept apart by
component: in a stiff contact those of a velocity are far larger than those of a displacement."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators

Array = NDArray[Any]
SAMPLES = 8  # between far contacts: a base period at most and half of one at least apart
AFTER = 1.0 / 64.0  # of the time to the next contact: a place there is on no boundary
ROUNDING = 1e-15  # of a map, relative to the sizes that it works on
OWN_ROUNDING = 1e-14  # of a whole period's, relative to 1 + its norm


@dataclass(frozen=True, eq=False)
class Tangents:
    """Places (m,) in mesh cycles, from phase zero on; states (m, n) there; factors (m, n, n): the variational
    flow from each to the next, and from the last to the first."""

    places: Array
    states: Array
    factors: Array

    @cached_property
    def returns(self) -> Array:
        """The monodromy (m, n, n) at every place."""
        ahead, behind = _products(self.factors)
        return ahead[:-1] @ behind[:-1]

    def errors(self, defect: Array) -> Array:
        """Bounds (m, n) on the error of each component of the state at every place, to first order: the
        defect (n,) at phase zero and the rounding of every map, through the flow and all its returns.
        Raises `LinAlgError` where a multiplier is 1."""
        count, n = self.states.shape
        size = np.abs(self.states).max(axis=0)
        local = ROUNDING * (np.abs(self.factors) @ size + size)
        sources = np.roll(local, 1, axis=0)  # each arrives at the place after its map
        sources[0] += np.abs(defect)
        carried = np.linalg.inv(np.eye(n) - self.returns)
        found, start = np.zeros((count, n)), np.arange(count)
        for step in range(count):
            at = (start + step) % count
            found[at] += (np.abs(carried) @ sources[:, :, None])[:, :, 0]
            carried = self.factors[at] @ carried
        return found

    def calmest(self) -> int:
        """The place where the monodromy has the least norm: all have the same multipliers."""
        return int(np.argmin(norms(self.returns)))

    def from_place(self, first: int) -> tuple[Array, Array]:
        """The flow (m+1, n, n) from a place to those that follow it, and from there to its return."""
        return _products(np.roll(self.factors, -first, axis=0))


def round_orbit(props: Propagators, state: Array, contacts: Array, period: int) -> Tangents:
    """The variational flow round an orbit of ``period`` base periods from ``state`` (n,) at phase zero, with
    contacts at these phases (mesh cycles)."""
    base = props.system.cycles
    places = _places(contacts, base * period, base / max(1, min(2, SAMPLES // period)))
    lengths = np.diff(np.append(places, float(base * period)))
    z, states, factors = state, [], []
    for place, length in zip(places.tolist(), lengths.tolist(), strict=True):
        step = flow.variational(props, z, length, place)
        assert step.jacobian is not None
        states.append(z)
        factors.append(step.jacobian)
        z = step.state
    return Tangents(places, np.array(states), np.array(factors))


def _places(contacts: Array, cycles: float, longest: float) -> Array:
    marks = np.unique(contacts % cycles) if len(contacts) else np.zeros(1)
    found = [0.0]
    for start, stop in zip(marks, [*marks[1:], marks[0] + cycles], strict=True):
        parts = max(1, ceil((stop - start) / longest))
        found += [(start + (stop - start) * (part / parts + AFTER)) % cycles for part in range(parts)]
    return np.unique(found)


def norms(matrices: Array) -> Array:
    """∞-norms."""
    return np.abs(matrices).sum(axis=2).max(axis=1)


def _products(factors: Array) -> tuple[Array, Array]:
    unit = np.eye(factors.shape[1])
    ahead, behind = [unit], [unit]
    for first, last in zip(factors, factors[::-1], strict=True):
        ahead.append(first @ ahead[-1])
        behind.append(behind[-1] @ last)
    return np.array(ahead), np.array(behind[::-1])
