"""The three Poincaré sections as data."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.flow.events import contact_force, gap_displacement, gap_velocity
from gearlash.system import ContactRule, Record, System

from .grazing import motion_of
from .results import Attractor

ENTERING, LEAVING = 1, -1


@dataclass(frozen=True, eq=False, repr=False)
class Section(Record):
    """Points of one section: phase (mesh cycles), state (m, n), displacement X, velocity X', contact force
    Φ (positive where the drive side is compressed), and direction: +1 into contact, -1 out of it (0 on
    σ_t)."""

    phase: NDArray[np.float64]
    state: NDArray[np.float64]
    displacement: NDArray[np.float64]
    velocity: NDArray[np.float64]
    force: NDArray[np.float64]
    direction: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.phase)

    @property
    def entering(self) -> Section:
        """The impacts: crossings into contact only."""
        return self._where(self.direction == ENTERING)

    @property
    def leaving(self) -> Section:
        """The releases: crossings out of contact."""
        return self._where(self.direction == LEAVING)

    def _where(self, mask: NDArray[np.bool_]) -> Section:
        return Section(
            self.phase[mask],
            self.state[mask],
            self.displacement[mask],
            self.velocity[mask],
            self.force[mask],
            self.direction[mask],
        )


@dataclass(frozen=True, eq=False, repr=False)
class Sections(Record):
    """σ_t (every base period), σ_d (all contact events at Σ1: X = +D) and σ_b (all at Σ2: X = -D). With the
    rule `no-tension` contact ends where the force does, so beyond the boundary."""

    time: Section
    drive: Section
    back: Section


def sections(attractor: Attractor, clearance: int = 0) -> Sections:
    """The sections of one orbit, or of the stretch kept of another motion, in the gap of a clearance."""
    clearance = motion_of(attractor).trace.which(clearance)
    drive, back = (_crossings(attractor, clearance, boundary) for boundary in (1, -1))
    return Sections(_strobes(attractor, clearance), drive, back)


def _strobes(attractor: Attractor, clearance: int) -> Section:
    system, state = attractor.propagators.system, attractor.strobes
    phase = np.arange(len(state), dtype=np.float64) * system.cycles
    x = gap_displacement(system, phase, state, clearance)
    velocity = gap_velocity(system, phase, state, clearance)
    force = _force(system, clearance, phase, x, velocity)
    return Section(phase, state, x, velocity, force, np.zeros(len(phase), dtype=np.int64))


def _force(
    system: System, clearance: int, phase: NDArray, x: NDArray, velocity: NDArray
) -> NDArray[np.float64]:
    """Φ of a state: contact is where there is a stop beyond its boundary, and with `no-tension` presses."""
    c = system.clearances[clearance]
    plus, minus = (x > c.gap_plus) & c.stops(1), (x < -c.gap_minus) & c.stops(-1)
    region = np.where(plus, 0, np.where(minus, 2, 1))
    force = contact_force(system, phase, x, velocity, region, clearance)
    if c.contact is ContactRule.NO_TENSION:
        force = np.where(plus, np.maximum(force, 0.0), np.where(minus, np.minimum(force, 0.0), force))
    return force


def _crossings(attractor: Attractor, clearance: int, boundary: int) -> Section:
    events = attractor.events.of(clearance)
    chosen = events.where(events.boundary == boundary)
    x = gap_displacement(attractor.propagators.system, chosen.phase, chosen.state, clearance)
    direction = np.where(chosen.engaging, ENTERING, LEAVING)
    return Section(chosen.phase, chosen.state, x, chosen.velocity, chosen.force, direction)
