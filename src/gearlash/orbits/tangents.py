"""The variational flow round a periodic orbit, and what it makes of errors.

It is cut at places that the motion itself names (after every contact, and between contacts that lie far
apart), so that what follows from it does not depend on where phase zero lies. Every map adds rounding of its
own, and the return what Newton's method left open; an orbit that closes carries these errors round and round:
e = (I - M)⁻¹ s, with s the errors of one lap and M its map, both seen from the same place. They are followed
as variances of independent errors: a product of norms would count a stiff contact, which makes velocities of
displacements, once for every place. Everything is in units of the size of each component, so that the units
of the system do not matter either."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Trace

from .shooting import size_of

Array = NDArray[Any]
LEAST_PLACES = 2
LEAST_SIZE = 1e-12  # of a component, relative to the largest
PLACE_AFTER_CONTACT = 1.0 / 8.0  # of the time to the next contact: a place there is on no boundary
MAP_ROUNDING = 2.5e-16  # of a map, times the root of its cells, relative to the sizes in it


@dataclass(frozen=True, eq=False)
class Tangents:
    """Places (m,) in mesh cycles, ascending; ``size`` (n,) of every component along the orbit; in units of it
    the ``factors`` (m, n, n), the variational flow from each place to the next, and from the last to the
    first; their ``rounding`` (m,); and the ``defect`` (n,), what the orbit misses, seen from the first
    place."""

    places: Array
    size: Array
    factors: Array
    rounding: Array
    defect: Array

    @cached_property
    def products(self) -> tuple[Array, Array]:
        """The flow (m+1, n, n) from the first place to each and to its return, and from each on to there."""
        return _products(self.factors)

    @cached_property
    def returns(self) -> Array:
        """The monodromy (m, n, n) at every place."""
        ahead, behind = self.products
        return ahead[:-1] @ behind[:-1]

    @cached_property
    def deviations(self) -> Array:
        """Standard deviations (m, n) of the error of each component at every place, in units of its size, to
        first order. Raises `LinAlgError` where a multiplier is 1."""
        (ahead, behind), unit = self.products, np.eye(len(self.size))
        fresh = self.rounding[:, None] * (1.0 + np.abs(self.factors).sum(axis=2))
        later, earlier = np.outer(self.defect, self.defect), np.zeros_like(unit)
        once = np.empty_like(self.factors)
        for k in range(len(once) - 1, -1, -1):  # what comes from place k on, seen from the first place
            carried = behind[k + 1] * fresh[k]
            later += carried @ carried.T
            once[k] = ahead[k] @ later @ ahead[k].T
        for k in range(1, len(once)):  # what came before
            earlier = self.factors[k - 1] @ earlier @ self.factors[k - 1].T
            earlier.flat[:: len(unit) + 1] += fresh[k - 1] ** 2
            once[k] += earlier
        gain = np.linalg.inv(unit - self.returns)
        return np.sqrt(np.maximum((gain @ once * gain).sum(axis=2), 0.0))

    @cached_property
    def calmest(self) -> int:
        """The place where the monodromy has the least norm: all have the same multipliers."""
        return int(np.argmin(norms(self.returns)))

    def from_place(self, first: int) -> tuple[Array, Array]:
        """The flow (m+1, n, n) from a place to those that follow it, and from there to its return."""
        return _products(np.roll(self.factors, -first, axis=0)) if first else self.products


def round_orbit(trace: Trace, state: Array) -> Tangents:
    """The variational flow round an orbit, from its trace and its state (n,) at phase zero."""
    props = trace.propagators
    per_cycle, total = props.cells_per_cycle, float(round(trace.cycles * props.cells_per_cycle))
    marks = trace.events.phase.tolist()
    if not marks:  # then places are counted from where the first gap is widest
        extrema = trace.extrema
        marks = [float(extrema.phase[np.argmax(extrema.displacement)])] if len(extrema) else [0.0]
    places = _places({mark * per_cycle % total for mark in marks}, total, props.cells)
    steps = flow.chain(props, state, places, total)
    size = size_of(trace.polynomials[:, 0], LEAST_SIZE)
    steps *= size / size[:, None]
    factors = steps[1:].copy()
    np.matmul(steps[0], steps[-1], out=factors[-1])
    defect = steps[0] @ ((trace.end - state) / size)
    lengths = [after - before for before, after in pairwise([*places, places[0] + total])]
    rounding = MAP_ROUNDING * np.sqrt(np.array(lengths) + 1.0)
    return Tangents(np.array(places) / per_cycle, size, factors, rounding, defect)


def _places(marks: set[float], total: float, longest: float) -> list[float]:
    """Places between contacts at these marks, at the ends of cells where there is one: between those the
    flow costs least. All in cells."""
    if len(marks) < LEAST_PLACES and total <= longest:
        longest = total / LEAST_PLACES
    ascending, found = sorted(marks), []
    for start, stop in pairwise([*ascending, ascending[0] + total]):
        parts = max(1, ceil((stop - start) / longest))
        length = (stop - start) / parts
        for part in range(parts):
            place = start + length * (part + PLACE_AFTER_CONTACT)
            end = float(ceil(place))
            found.append((end if end - place < (1.0 - 2.0 * PLACE_AFTER_CONTACT) * length else place) % total)
    return sorted(found)


def norms(matrices: Array) -> Array:
    """∞-norms."""
    return np.abs(matrices).sum(axis=2).max(axis=1)


def _products(factors: Array) -> tuple[Array, Array]:
    count, n = len(factors), factors.shape[1]
    ahead, behind = np.empty((2, count + 1, n, n))
    ahead[0] = behind[count] = np.eye(n)
    for k in range(count):
        np.matmul(factors[k], ahead[k], out=ahead[k + 1])
        np.matmul(behind[count - k], factors[count - k - 1], out=behind[count - k - 1])
    return ahead, behind
