"""The equations of a branch of periodic orbits: P^period(z, λ) = z, one more unknown than equations.

The unknowns are scaled: every state by how far it moves in the course of the orbit, the parameter by the
width of the interval in which it is followed. So the length of a step means the same in all of them. With
more than one segment the orbit is cut into pieces of whole base periods, whose ends must meet (multiple
shooting): errors then grow over one piece only."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import isfinite

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.orbits import Orbit
from gearlash.orbits.shooting import MOVING, size_of
from gearlash.system import Family, GearlashError

Array = NDArray[np.float64]
UNBUILT = (GearlashError, np.linalg.LinAlgError)
"""What a system that cannot be built or carried raises."""
LEAST = 1e-3  # of the largest state: the size of one that hardly moves
STEP = 1e-7  # of the unit of the parameter: for the derivative along it
MOST_SEGMENTS = 16
KEPT = 3  # systems that are kept, the last ones asked for


@dataclass(frozen=True, eq=False)
class Line:
    """What a branch is followed along: parameter ``name`` of a family between two limits, all other
    ``values`` fixed."""

    family: Family
    values: Mapping[str, float]
    name: str
    lower: float
    upper: float
    _built: dict[float, Propagators] = field(default_factory=dict)

    def system_at(self, value: float) -> Propagators:
        """Raises what `UNBUILT` names."""
        found = self._built.pop(value, None)
        if found is None:
            reuse = next(reversed(self._built.values()), None)
            found = flow.propagators(self.family.system({**self.values, self.name: value}), reuse)
        self._built[value] = found
        while len(self._built) > KEPT:
            del self._built[next(iter(self._built))]
        return found

    @property
    def unit(self) -> float:
        """Of the parameter."""
        return self.upper - self.lower


@dataclass(frozen=True, eq=False)
class Evaluated:
    """What the equations say at unknowns ``u``: ``defect`` (m·n,) in units of the states' scale, ``blocks``
    (m, n, n) the unscaled Jacobian of every segment, ``residual`` relative to what rounding acts on."""

    u: Array
    props: Propagators
    defect: Array
    blocks: Array
    residual: float

    @cached_property
    def monodromy(self) -> Array:
        product = np.eye(self.blocks.shape[1])
        for block in self.blocks:
            product = block @ product
        return product


@dataclass(frozen=True, eq=False)
class Equations:
    """For orbits of ``period`` base periods, cut into ``segments``; ``size`` (n,): scale of the states."""

    line: Line
    period: int
    segments: int
    size: Array

    @staticmethod
    def of(line: Line, orbit: Orbit) -> Equations:
        period = orbit.shot.period
        segments = max(d for d in range(1, MOST_SEGMENTS + 1) if period % d == 0)
        starts = orbit.trace.polynomials[:, 0]
        moved = starts.max(axis=0) - starts.min(axis=0)
        least = LEAST * max(float(np.abs(starts).max()), LEAST)
        size = np.maximum(moved, least) * np.sqrt(moved.size * segments)
        return Equations(line, period, segments, size)

    @cached_property
    def scale(self) -> Array:
        """(m·n+1,) of all unknowns."""
        return np.append(np.tile(self.size, self.segments), self.line.unit)

    def unknowns(self, strobes: Array, value: float) -> Array:
        """Scaled, from the states (period, n) at phase zero of every base period."""
        states = strobes[:: self.period // self.segments]
        return np.append(states.ravel(), value) / self.scale

    def value(self, u: Array) -> float:
        return float(u[-1]) * self.line.unit

    def states(self, u: Array) -> Array:
        """(m, n) at the beginning of every segment."""
        return (u * self.scale)[:-1].reshape(self.segments, -1)

    def evaluate(self, u: Array, props: Propagators | None = None) -> Evaluated | None:
        """None where the motion could not be carried, or runs away. Raises what `UNBUILT` names."""
        props = self.line.system_at(self.value(u)) if props is None else props
        states, length = self.states(u), float(self.period // self.segments)
        laps = [flow.lap(props, z, 1, length) for z in states]
        if any(lap.status not in MOVING or not np.isfinite(lap.jacobian).all() for lap in laps):
            return None
        ends, blocks = np.array([lap.end for lap in laps]), np.array([lap.jacobian for lap in laps])
        missed = ends - np.roll(states, -1, axis=0)
        size = size_of(np.concatenate([states, ends]))
        unit = np.abs(blocks) @ size + size
        residual = float((np.abs(missed) / unit).max())
        if not isfinite(residual):
            return None
        return Evaluated(u, props, (missed / self.size).ravel(), blocks, residual)

    def matrix(self, here: Evaluated, slope: Array, row: Array) -> Array:
        """(m·n+1, m·n+1): derivative of the defect by the scaled unknowns, bordered by a row."""
        m, n = self.segments, len(self.size)
        out = np.zeros((m * n + 1, m * n + 1))
        for k, block in enumerate(here.blocks):
            rows, after = slice(k * n, (k + 1) * n), (k + 1) % m * n
            out[rows, rows] += block * self.size / self.size[:, None]
            out[rows, after : after + n] -= np.eye(n)
        out[:-1, -1] = slope
        out[-1] = row
        return out

    def slope(self, here: Evaluated) -> Array:
        """(m·n,): derivative of the defect along the scaled parameter, by a difference. Its error is about
        1e-7 of itself, as a rule: it makes steps of Newton's method so much less exact, and no solution.
        Raises what `UNBUILT` names."""
        up = here.u[-1] + STEP <= self.line.upper / self.line.unit
        step = STEP if up else -STEP
        moved = here.u.copy()
        moved[-1] += step
        there = self.evaluate(moved)
        if there is None:
            raise GearlashError("the motion could not be carried beside the orbit")
        return (there.defect - here.defect) / step
