"""Limits of phase portraits: of the whole motion, and of the place where it touches a boundary."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gearlash.studies.motion import Motion

SMALLEST_ZOOM = 2e-4  # half-width of a zoom at the least, of D + D⁻
Box = tuple[float, float, float, float]  # left, right, bottom, top


def frame(motions: Sequence[Motion]) -> Box:
    """Limits that hold every motion, and the boundaries near them."""
    low = min(float(m.displacement.min()) for m in motions)
    high = max(float(m.displacement.max()) for m in motions)
    bottom = min(float(m.velocity.min()) for m in motions)
    top = max(float(m.velocity.max()) for m in motions)
    wide, tall = high - low, top - bottom
    for m in motions:
        for edge in (m.gap_plus, -m.gap_minus):
            if low - 0.25 * wide < edge < high + 0.25 * wide:
                low, high = min(low, edge), max(high, edge)
    wide = high - low
    return low - 0.07 * wide, high + 0.07 * wide, bottom - 0.07 * tall, top + 0.12 * tall


def zoom_frame(motions: Sequence[Motion]) -> Box:
    """Limits around the touch: wide enough to see by how much the extremum misses or crosses before and
    after.
    """
    touched = next((m for m in motions if m.touch is not None), None)
    if touched is None or touched.touch is None:
        return frame(motions)
    side = touched.touch.boundary
    edge = touched.gap_plus if side > 0 else -touched.gap_minus
    size = touched.gap_plus + touched.gap_minus
    missed = [abs(_nearest_extremum(m, side)) for m in motions]
    half = max(1.7 * max(missed), SMALLEST_ZOOM * max(size, 1e-12))
    speed = max(_speed_at(m, side, half) for m in motions)
    moved = max(abs((m.gap_plus if side > 0 else -m.gap_minus) - edge) for m in motions)
    return edge - half - moved, edge + half + moved, -1.1 * speed, 1.1 * speed


def _gap(motion: Motion, side: int) -> NDArray[np.float64]:
    return motion.displacement - (motion.gap_plus if side > 0 else -motion.gap_minus)


def _nearest_extremum(motion: Motion, side: int) -> float:
    """Distance (signed) to the boundary of the extremum of X that lies nearest to it."""
    gap, x = _gap(motion, side), motion.displacement
    inner = np.flatnonzero((x[1:-1] - x[:-2]) * (x[2:] - x[1:-1]) <= 0.0) + 1
    return (
        float(gap[inner[np.argmin(np.abs(gap[inner]))]]) if len(inner) else float(gap[np.argmin(np.abs(gap))])
    )


def _speed_at(motion: Motion, side: int, half: float) -> float:
    """|X'| where the loop that all but touches leaves a strip of this half-width around the boundary."""
    gap = _gap(motion, side)
    x = motion.displacement
    inner = np.flatnonzero((x[1:-1] - x[:-2]) * (x[2:] - x[1:-1]) <= 0.0) + 1
    if not len(inner):
        return float(np.abs(motion.velocity).max())
    at = int(inner[np.argmin(np.abs(gap[inner]))])
    outside = np.flatnonzero(np.abs(gap - gap[at]) > 0.7 * half)
    after, before = outside[outside > at], outside[outside < at]
    speeds = [abs(float(motion.velocity[i])) for i in (*after[:1], *before[-1:])]
    return max(speeds, default=float(np.abs(motion.velocity).max()))
