"""The three Poincaré sections as data."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.flow.events import Events, contact_force, gap_displacement, gap_velocity

from .results import Attractor

ENTERING, LEAVING = 1, -1


@dataclass(frozen=True, eq=False)
class Section:
    """Points of one section: phase (mesh cycles), state (m, n), displacement X, velocity X', force F in the
    sign of the article (F = -Φ), and direction: +1 into contact, -1 out of it (0 on σ_t)."""

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
        """The releases: crossings out of contact. The article's σ_b samples these (S3 → S2)."""
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


@dataclass(frozen=True, eq=False)
class Sections:
    """σ_t (every base period), σ_d (all crossings of Σ1: X = +D) and σ_b (all crossings of Σ2: X = -D)."""

    time: Section
    drive: Section
    back: Section


def sections(attractor: Attractor) -> Sections:
    """The sections of one orbit, or of the stretch kept of another motion."""
    events = attractor.events
    return Sections(_strobes(attractor), _crossings(attractor, events, 1), _crossings(attractor, events, -1))


def _strobes(attractor: Attractor) -> Section:
    system, state = attractor.propagators.system, attractor.strobes
    clearance = system.clearances[0]
    phase = np.arange(len(state), dtype=np.float64) * system.cycles
    x, velocity = gap_displacement(system, phase, state), gap_velocity(system, phase, state)
    region = np.where(x > clearance.gap_plus, 0, np.where(x < -clearance.gap_minus, 2, 1))
    force = -contact_force(system, phase, x, velocity, region)
    return Section(phase, state, x, velocity, force, np.zeros(len(phase), dtype=np.int64))


def _crossings(attractor: Attractor, events: Events, boundary: int) -> Section:
    chosen = events.where(events.boundary == boundary)
    x = gap_displacement(attractor.propagators.system, chosen.phase, chosen.state)
    direction = np.where(chosen.engaging, ENTERING, LEAVING)
    return Section(chosen.phase, chosen.state, x, chosen.velocity, -chosen.force, direction)
