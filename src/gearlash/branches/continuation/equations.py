"""The equations of a branch of periodic orbits: P^period(z, λ) = z, one more unknown than equations.

The unknowns are scaled: every state by how far it moves in the course of the orbit, the parameter by the
width of the interval in which it is followed. So the length of a step means the same in all of them. With
more than one segment the orbit is cut into pieces of whole base periods, whose ends must meet (multiple
shooting): errors then grow over one piece only."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from math import isclose, isfinite

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators, Trace
from gearlash.flow.sensitivity import sensitivity
from gearlash.orbits import Orbit
from gearlash.orbits.shooting import size_of
from gearlash.system import CARRIED, Family, GearlashError, System

from .derivative import Along

Array = NDArray[np.float64]
UNBUILT = (GearlashError, np.linalg.LinAlgError)
"""What a system that cannot be built or carried raises."""
ULPS = 1e-15  # relative: what rounding makes of a limit
LEAST_SIZE = 1e-3  # of the largest state: the size of one that hardly moves
MOST_SEGMENTS = 16
KEPT_SYSTEMS = 3  # systems that are kept, the last ones asked for


@dataclass(frozen=True, eq=False)
class Line:
    """What a branch is followed along: parameter ``name`` of a family between two limits, all other
    ``values`` fixed. ``least_unit``: the unit of the parameter is no smaller, however near the limits are."""

    family: Family
    values: Mapping[str, float]
    name: str
    lower: float
    upper: float
    least_unit: float = 0.0
    _built: dict[float, Propagators] = field(default_factory=dict)

    @cached_property
    def along(self) -> Along:
        """How systems change along the parameter."""
        own = next(each for each in self.family.parameters if each.name == self.name)
        return Along.over(self.build, (self.lower, self.upper), (own.lower, own.upper))

    def build(self, value: float) -> System:
        return self.family.system({**self.values, self.name: value})

    def system_at(self, value: float) -> Propagators:
        """Raises what `UNBUILT` names."""
        found = self._built.pop(value, None)
        if found is None:
            reuse = next(reversed(self._built.values()), None)
            system = self.build(value)
            self.along.hold(value, system)
            found = flow.propagators(system, reuse)
        self._built[value] = found
        while len(self._built) > KEPT_SYSTEMS:
            del self._built[next(iter(self._built))]
        return found

    def within(self, value: float) -> float:
        """The same, or the limit that it is within rounding."""
        limits = (limit for limit in (self.lower, self.upper) if isclose(value, limit, rel_tol=ULPS))
        return next(limits, value)

    @property
    def unit(self) -> float:
        """Of the parameter."""
        return max(self.upper - self.lower, self.least_unit)


def scale_of(trace: Trace, segments: int = 1) -> Array:
    """(n,): how far every state moves in the course of an orbit, which is cut into so many segments."""
    starts = trace.polynomials[:, 0]
    moved = starts.max(axis=0) - starts.min(axis=0)
    least = LEAST_SIZE * max(float(np.abs(starts).max()), LEAST_SIZE)
    found: Array = np.maximum(moved, least) * np.sqrt(moved.size * segments)
    return found


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
    """For orbits of ``period`` base periods, cut into ``segments``; ``size`` (n,): scale of the states;
    ``phase`` (mesh cycles) at which every base period is begun."""

    line: Line
    period: int
    segments: int
    size: Array
    phase: float = 0.0

    @staticmethod
    def of(line: Line, orbit: Orbit, phase: float = 0.0) -> Equations:
        period = orbit.shot.period
        segments = max(d for d in range(1, MOST_SEGMENTS + 1) if period % d == 0)
        return Equations(line, period, segments, scale_of(orbit.trace, segments), phase)

    @cached_property
    def scale(self) -> Array:
        """(m·n+1,) of all unknowns."""
        return np.append(np.tile(self.size, self.segments), self.line.unit)

    def unknowns(self, orbit: Orbit, value: float) -> Array:
        """Scaled, of an orbit of this period."""
        states, every = orbit.strobes, self.period // self.segments
        if self.phase != 0.0:
            cycles = orbit.propagators.system.cycles
            states = orbit.trace.at(self.phase + cycles * np.arange(self.period)).state
        return np.append(states[::every].ravel(), value) / self.scale

    def at_zero(self, here: Evaluated) -> Array:
        """The state (n,) at phase zero."""
        states = self.states(here.u)
        if self.phase == 0.0:
            return states[0]
        cycles, left = here.props.system.cycles, self.period // self.segments - 1
        ahead = (left + 1) * cycles - self.phase
        return flow.carry(here.props, states[-1], ahead, self.phase).state

    def value(self, u: Array) -> float:
        return self.line.within(float(u[-1]) * self.line.unit)

    def states(self, u: Array) -> Array:
        """(m, n) at the beginning of every segment."""
        return (u * self.scale)[:-1].reshape(self.segments, -1)

    def evaluate(self, u: Array, props: Propagators | None = None) -> Evaluated | None:
        """None where the motion could not be carried, or runs away. Raises what `UNBUILT` names."""
        props = self.line.system_at(self.value(u)) if props is None else props
        states, carried = self.states(u), self.carried(props, u)
        if carried is None:
            return None
        ends, blocks = carried
        missed = ends - np.roll(states, -1, axis=0)
        size = size_of(np.concatenate([states, ends]))
        unit = np.abs(blocks) @ size + size
        residual = float((np.abs(missed) / unit).max())
        if not isfinite(residual):
            return None
        return Evaluated(u, props, (missed / self.size).ravel(), blocks, residual)

    def carried(self, props: Propagators, u: Array) -> tuple[Array, Array] | None:
        """The ends (m, n) of the segments and their Jacobians (m, n, n)."""
        length = float(self.period // self.segments)
        ends, blocks = [], []
        for z in self.states(u):
            if self.phase == 0.0:
                lap = flow.lap(props, z, 1, length)
                end, block = lap.end, lap.jacobian
            else:
                lap = flow.variational(props, z, length * props.system.cycles, self.phase)
                end, block = lap.state, lap.jacobian
            if lap.status not in CARRIED or block is None or not np.isfinite(block).all():
                return None
            ends.append(end)
            blocks.append(block)
        return np.array(ends), np.array(blocks)

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

    def solve(self, here: Evaluated, slope: Array, row: Array, right: Array) -> Array:
        """The solution of ``matrix`` for a right side, by eliminating all segments but the first: a system of
        n+1 unknowns is left. Raises `LinAlgError` where that is singular."""
        m, n = self.segments, len(self.size)
        blocks = here.blocks * self.size / self.size[:, None]
        columns = np.stack([slope, -right[:-1]], axis=1).reshape(m, n, 2)  # of the parameter, and constant
        rows = row[:-1].reshape(m, n)
        flow, drift = np.eye(n), np.zeros((n, 2))  # of each segment's state, by the first one and these two
        left = np.zeros(n + 2)
        left[n:] = row[-1], -right[-1]
        states = []
        for block, column, part in zip(blocks, columns, rows, strict=True):
            states.append((flow, drift))
            left[:n] += part @ flow
            left[n:] += part @ drift
            flow, drift = block @ flow, block @ drift + column
        reduced = np.zeros((n + 1, n + 1))
        reduced[:n, :n], reduced[:n, n], reduced[n] = flow - np.eye(n), drift[:, 0], left[: n + 1]
        found = np.linalg.solve(reduced, -np.append(drift[:, 1], left[n + 1]))
        first, along = found[:n], float(found[n])
        parts = [flow @ first + drift[:, 0] * along + drift[:, 1] for flow, drift in states]
        return np.append(np.concatenate(parts), along)

    def slope(self, here: Evaluated, trace: Trace | None = None) -> Array:
        """(m·n,): derivative of the defect along the scaled parameter, exact where the systems' is (`Along`).
        ``trace``: the orbit, where that is what was evaluated. Raises what `UNBUILT` names."""
        change = self.line.along.at(self.value(here.u), here.props.system)
        if trace is not None and trace.phase == self.phase:
            ends = sensitivity(trace, change, self.segments)
        else:
            ends = np.concatenate([sensitivity(each, change) for each in self.traces(here)])
        return (ends / self.size).ravel() * self.line.unit

    def traces(self, here: Evaluated) -> Iterator[Trace]:
        """Of every segment."""
        cycles = float(self.period // self.segments * here.props.system.cycles)
        for z in self.states(here.u):
            found = flow.trace(here.props, z, cycles, self.phase)
            if found.status not in CARRIED:
                raise GearlashError("the motion could not be carried")
            yield found
