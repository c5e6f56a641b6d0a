"""What a trace holds: exact pieces, contact events, extrema of the gap."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from gearlash.system import GearlashError, Status, System, derivative, evaluate

from . import _march
from ._tables import FREE, MINUS, ORDER, PLUS, Array

if TYPE_CHECKING:
    from .propagators import Propagators


SLACK = 1e-9  # mesh cycles beyond its ends at which a trace is still read


@dataclass(frozen=True, eq=False)
class Events:
    """Contact events in order: phase (mesh cycles, θ/2π), state (m, n), velocity X', force Φ, boundary (+1:
    Σ1 at +D, -1: Σ2 at -D), engaging (True: into contact)."""

    phase: Array
    state: Array
    velocity: Array
    force: Array
    boundary: Array
    engaging: Array

    @staticmethod
    def build(system: System, phase: Array, state: Array, kind: Array) -> Events:
        velocity = gap_velocity(system, phase, state)
        # On its boundaries the elastic part is zero, so the force is that of damping alone, exactly.
        force = system.clearances[0].damping * velocity
        return Events(phase, state, velocity, force, kind[:, 0].astype(np.int64), kind[:, 1] == 1.0)

    def where(self, mask: Array) -> Events:
        """The events selected by a boolean mask (m,)."""
        parts = (self.phase, self.state, self.velocity, self.force, self.boundary, self.engaging)
        return Events(*(part[mask] for part in parts))

    def __len__(self) -> int:
        return len(self.phase)


@dataclass(frozen=True, eq=False)
class Extrema:
    """Simple zeros of X': phase (mesh cycles), displacement X, curvature X'' (d²/dτ²), state (m, n), region
    (0: side +, 1: free, 2: side -)."""

    phase: Array
    displacement: Array
    curvature: Array
    state: Array
    region: Array

    def __len__(self) -> int:
        return len(self.phase)


@dataclass(frozen=True, eq=False)
class Samples:
    """The motion at chosen phases: state (m, n), gap X, velocity X', contact force Φ, region."""

    phase: Array
    state: Array
    displacement: Array
    velocity: Array
    force: Array
    region: Array


@dataclass(frozen=True, eq=False)
class Trace:
    """A motion as polynomials: piece i starts at `positions[i]` (cells after phase `base`), has length
    `lengths[i]` (cells), runs in `regions[i]` and is `polynomials[i]` (degree+1, n) in its own local time
    from 0 to 1."""

    propagators: Propagators
    base: float
    start: float
    cycles: float
    positions: Array
    lengths: Array
    regions: Array
    polynomials: Array
    events: Events
    end: Array
    undecided: int
    status: Status

    @property
    def free(self) -> Array:
        """Which pieces (pieces,) run without contact: in the gap, or where there is nothing to hit."""
        clearance = self.propagators.system.clearances[0]
        free = self.regions == FREE
        for boundary, region in ((1, PLUS), (-1, MINUS)):
            if not clearance.stops(boundary):
                free = free | (self.regions == region)
        return free

    @cached_property
    def gap(self) -> Array:
        """Taylor coefficients of X per piece (pieces, degree+1), in local time."""
        clearance = self.propagators.system.clearances[0]
        out = self.polynomials @ clearance.h
        return out - _local_series(self.propagators, clearance.offset, self.positions, self.lengths)

    @cached_property
    def extrema(self) -> Extrema:
        """Every place where X' vanishes with a sign change."""
        found = np.empty((64 + 8 * len(self.positions), 4))
        pieces = np.column_stack([self.positions, self.lengths, self.regions.astype(float)])
        basis = self.propagators.tables.to_bernstein[1].copy()
        count = _march.extrema(pieces, np.ascontiguousarray(self.gap), basis, found)
        found = found[:count]
        index = found[:, 3].astype(int)
        local = (found[:, 0] - self.positions[index]) / self.lengths[index]
        duration = self.lengths[index] * self.propagators.tables.scalars[1]
        state = _values(self.polynomials[index], local)
        phase = self.base + found[:, 0] / self.propagators.cells_per_cycle
        return Extrema(phase, found[:, 1], found[:, 2] / duration**2, state, self.regions[index])

    def at(self, phase: ArrayLike) -> Samples:
        """The motion at phases (mesh cycles, within the trace), one or many.

        Raises `GearlashError` for a phase outside the trace: its polynomials say nothing there.
        """
        system = self.propagators.system
        phase = np.atleast_1d(np.asarray(phase, dtype=np.float64))
        last = self.start + self.cycles
        if phase.size and not (phase.min() >= self.start - SLACK and phase.max() <= last + SLACK):
            span = f"{self.start:g} to {last:g}"
            raise GearlashError(f"phases {phase.min():g} to {phase.max():g}: the trace goes from {span}")
        cell = (phase - self.base) * self.propagators.cells_per_cycle
        index = np.clip(np.searchsorted(self.positions, cell, side="right") - 1, 0, len(self.positions) - 1)
        local = (cell - self.positions[index]) / self.lengths[index]
        state, region = _values(self.polynomials[index], local), self.regions[index]
        x = gap_displacement(system, phase, state)
        velocity = gap_velocity(system, phase, state)
        return Samples(phase, state, x, velocity, contact_force(system, phase, x, velocity, region), region)

    def samples(self, points: int) -> Samples:
        """The motion at ``points`` equally spaced phases from start to end, both included."""
        return self.at(self.start + np.linspace(0.0, self.cycles, points))


def gap_displacement(system: System, phase: ArrayLike, state: Array) -> Array:
    """X = h·z - e at phases (mesh cycles) and states (m, n)."""
    c = system.clearances[0]
    return state @ c.h - evaluate(c.offset, _base_phase(system, phase))


def gap_velocity(system: System, phase: ArrayLike, state: Array) -> Array:
    """X' = h·(M z + b) - e' (the contact force does not enter, because h·g = 0)."""
    c, theta = system.clearances[0], _base_phase(system, phase)
    drift = state @ (c.h @ system.matrix) + evaluate(c.h @ system.forcing, theta)
    return drift - system.omega / system.cycles * evaluate(derivative(c.offset), theta)


def contact_force(system: System, phase: ArrayLike, x: Array, velocity: Array, region: Array) -> Array:
    """Φ at given displacements, velocities and regions."""
    c, theta = system.clearances[0], _base_phase(system, phase)
    elastic = np.where(region == PLUS, evaluate(c.stiffness_plus, theta) * (x - c.gap_plus), 0.0)
    elastic += np.where(region == MINUS, evaluate(c.stiffness_minus, theta) * (x + c.gap_minus), 0.0)
    return elastic + c.damping * velocity


def _base_phase(system: System, phase: ArrayLike) -> Array:
    return 2.0 * np.pi / system.cycles * np.asarray(phase, dtype=np.float64)


def _values(polynomials: Array, local: Array) -> Array:
    """Polynomials (m, degree+1, n) at local times (m,) → (m, n)."""
    out = polynomials[:, -1].copy()
    for j in range(polynomials.shape[1] - 2, -1, -1):
        out = out * local[:, None] + polynomials[:, j]
    return out


def _local_series(props: Propagators, series: Array, positions: Array, lengths: Array) -> Array:
    """Taylor coefficients (pieces, ORDER+1) of a Fourier series over each piece, in its local time."""
    width = 2.0 * np.pi / props.cells
    out = np.zeros((len(positions), ORDER + 1))
    out[:, 0] = series[0]
    for n in range(1, (len(series) + 1) // 2):
        rotor = (series[2 * n - 1] - 1j * series[2 * n]) * np.exp(1j * n * width * positions)
        term = rotor
        for j in range(ORDER + 1):
            out[:, j] += term.real
            term = term * (1j * n * width * lengths) / (j + 1)
    return out


REGION_NAMES = {PLUS: "drive side", FREE: "free", MINUS: "back side"}
