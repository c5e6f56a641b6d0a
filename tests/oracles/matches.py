"""Distance of a `gearlash.flow` trace from the truth of `region_oracle`, in units of the accuracy bars."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from gearlash.flow import Trace
from gearlash.system import System

if TYPE_CHECKING:
    from .motion import Event, Walk

EPSILON = np.finfo(float).eps
Kind = tuple[int, int, bool]  # clearance, boundary, engaging


@dataclass(frozen=True)
class Match:
    """``state`` is over max(1, ‖z‖) and ``event_time`` over 1e-12 + 8ε·scale/|slope of the surface|, where
    scale is the largest ‖z‖ met on the way, at least 1. Events of one instant have no order among different
    clearances, so those of each clearance are compared on their own."""

    same_events: bool
    state: float
    event_time: float
    told: str

    def holds(self, state: float = 1e-13) -> bool:
        return self.same_events and self.state < state and self.event_time < 1.0


def match(system: System, trace: Trace, truth: Walk) -> Match:
    """How far a trace is from the truth, both from the same start and phase."""
    found = list(zip(trace.events.phase.tolist(), kinds(trace.events), strict=True))
    size = max(1.0, float(np.linalg.norm(truth.state)))
    state = float(np.abs(trace.end - truth.state).max()) / size
    worst, same = 0.0, True
    for j in range(len(system.clearances)):
        mine = [(phase, kind) for phase, kind in found if kind[0] == j]
        theirs = [e for e in truth.events if e.clearance == j]
        if [kind for _, kind in mine] != [(e.clearance, e.boundary, e.engaging) for e in theirs]:
            same = False
            continue
        for (phase, _), event in zip(mine, theirs, strict=True):
            late = abs(float(phase - event.phase)) * 2 * np.pi / system.omega
            worst = max(worst, late / time_bar(system, event, truth.largest))
    wanted = [(float(e.phase), (e.clearance, e.boundary, e.engaging)) for e in truth.events]
    told = f"state {state:.1e}, time {worst:.1e} of its bar\nfound {found}\ntruth {wanted}"
    return Match(same, state, worst, told)


def kinds(events) -> list[Kind]:
    """(clearance, boundary, engaging) of the events of a trace."""
    index: Sequence[int] = getattr(events, "clearance", np.zeros(len(events), dtype=int)).tolist()
    return list(zip(index, events.boundary.tolist(), events.engaging.tolist(), strict=True))


def time_bar(system: System, event: Event, largest: float) -> float:
    """What an event's time may be wrong by, in τ. P is as large as its coefficients times the state."""
    c, factor = system.clearances[event.clearance], 1.0
    if event.early:
        series = c.stiffness_plus if event.boundary > 0 else c.stiffness_minus
        factor = max(1.0, float(np.abs(series).sum()) + c.dampings[0 if event.boundary > 0 else 1])
    return 1e-12 + 8 * EPSILON * factor * max(1.0, largest) / abs(float(event.slope))
