"""Distances between a `gearlash.flow` trace and the truth, in the units of the accuracy bars."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from gearlash.flow import Trace
from gearlash.system import System

if TYPE_CHECKING:
    from .heyoka_oracle import Run

EPSILON = np.finfo(float).eps


@dataclass(frozen=True)
class Distance:
    """Largest differences over a trace. ``state`` is over max(1, ‖z‖); ``event_time`` over the bar
    1e-12 + 8ε·scale/|X′|; ``on_boundary`` is |X ∓ D| over scale; ``extremum_phase`` in mesh cycles.
    scale is the largest ‖z‖ met on the way, at least 1."""

    same_crossings: bool
    same_extrema: bool
    state: float
    event_time: float
    on_boundary: float
    extremum_phase: float
    extremum_displacement: float


def distance(system: System, trace: Trace, truth: Run) -> Distance:
    """How far a trace is from the truth, both from the same start and phase."""
    events, extrema = trace.events, trace.extrema
    crossings = list(zip(events.boundary.tolist(), events.engaging.tolist(), strict=True))
    same = crossings == truth.crossings
    met = np.concatenate([truth.states, truth.extremum_state, [truth.state, trace.polynomials[0, 0]]])
    scale = max(1.0, float(np.linalg.norm(met.astype(float), axis=1).max()))
    time = on = 0.0
    if same and len(events):
        late = np.abs(events.phase - truth.phase) * 2 * np.pi / system.omega
        time = float(np.max(late / (1e-12 + 8 * EPSILON * scale / np.abs(truth.velocity))))
        on = float(np.max(np.abs(gap_error(system, events)))) / scale
    turns = len(extrema) == len(truth.extremum_phase)
    at = np.abs(extrema.phase - truth.extremum_phase) if turns else np.zeros(0)
    size = max(1.0, float(np.linalg.norm(truth.state)))
    c = system.clearances[0]
    there = np.abs((extrema.state - truth.extremum_state) @ c.h) if turns else np.zeros(0)
    return Distance(
        same_crossings=same,
        same_extrema=turns,
        state=float(np.abs(trace.end - truth.state).max()) / size,
        event_time=time,
        on_boundary=on,
        extremum_phase=float(at.max(initial=0.0)),
        extremum_displacement=float(there.max(initial=0.0)) / scale,
    )


def gap_error(system: System, events) -> np.ndarray:
    """X ∓ D at the events of a trace."""
    c = system.clearances[0]
    angle = np.multiply.outer(
        2 * np.pi * events.phase / system.cycles, np.arange(1, (len(c.offset) + 1) // 2)
    )
    offset = c.offset[0] + np.cos(angle) @ c.offset[1::2] + np.sin(angle) @ c.offset[2::2]
    return events.state @ c.h - offset - np.where(events.boundary > 0, c.gap_plus, -c.gap_minus)
