"""Extrema of an orbit at phase zero, where its trace begins and ends.

There rounding may put the extremum before the beginning and behind the end, so that it is found nowhere, or
into both."""

from __future__ import annotations

import numpy as np

from gearlash.flow.events import gap_displacement, gap_velocity
from gearlash.orbits import Orbit

SEAM = 1e-6  # mesh cycles: an extremum so near phase zero is the one there
ASIDE = 1e-4  # mesh cycles: where the velocity is read for the curvature


def lost_at_seam(orbit: Orbit, clearance: int, phases: list[float]) -> tuple[float, float] | None:
    """X and X″ of an extremum at phase zero that is not among those of these phases; None as a rule."""
    system, length = orbit.propagators.system, float(orbit.period)
    if any(min(phase, length - phase) <= ASIDE for phase in phases):
        return None
    places = np.array([0.0, ASIDE, length - ASIDE])
    states = orbit.trace.at(places).state
    after, before = gap_velocity(system, places[1:], states[1:], clearance).tolist()
    if not after * before < 0.0:  # at the seam itself both velocities are rounding, of either sign
        return None
    x = float(gap_displacement(system, places[:1], states[:1], clearance)[0])
    return x, (after - before) / (2.0 * ASIDE * system.period / system.cycles)


def near_seam(phase: float, length: float) -> bool:
    """Whether a phase is that of the beginning or of the end of the trace."""
    return min(phase, length - phase) <= SEAM


def twice_at_seam(one: float, other: float, length: float) -> bool:
    """Whether two extrema of one kind are the same, found at both ends of the trace."""
    low, high = sorted((one, other))
    return low <= SEAM and length - high <= SEAM
