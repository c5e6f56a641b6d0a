"""Extrema of the gap along a motion."""

from __future__ import annotations

from gearlash.flow import Extrema, Trace


def gap_extrema(trace: Trace, clearance: int) -> Extrema:
    """Extrema of X of a clearance; of the first one, from what the trace keeps."""
    return trace.extrema if clearance == 0 else trace.extrema_of(clearance)
