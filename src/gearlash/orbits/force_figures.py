"""Extremes of motion and force of a trace, cheap enough for every point of a sweep."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Trace
from gearlash.flow.events import contact_force

from .peaks import CLOSER, Places, largest

Array = NDArray[np.float64]

NODES, WEIGHTS = np.polynomial.legendre.leggauss(10)
LOCAL = np.concatenate([[0.0], (NODES + 1.0) / 2.0, [1.0]])


def force_figures(trace: Trace) -> dict[str, float]:
    """Extremes of X (exact, at its extrema), extremes and rms of Φ, share of time without contact (0 to 1).

    Each piece of the motion is read at 10 Gauss nodes and both ends. Pieces are shorter than a third of the
    fastest oscillation, so the rms is good to rounding; around its extreme readings Φ is read once more,
    closely, up to where it jumps or bends, and a parabola makes the extremes good to about 1e-7 of their
    span.
    """
    pieces = np.arange(len(trace.lengths))
    x, force = _read(trace, pieces[:, None], LOCAL[None, :])
    weight = trace.lengths / trace.lengths.sum()
    square = float((weight * (force[:, 1:-1] ** 2 * (WEIGHTS / 2.0)).sum(axis=1)).sum())

    def closer(first: Places, last: Places) -> Array:
        start, stop = LOCAL[first % len(LOCAL)], LOCAL[last % len(LOCAL)]
        return _read(trace, first // len(LOCAL), start + (stop - start) * CLOSER)[1]

    low = -largest(-force, lambda first, last: -closer(first, last))
    extrema = trace.extrema.displacement
    return {
        "minimum": float(min(x.min(), extrema.min(initial=np.inf))),
        "maximum": float(max(x.max(), extrema.max(initial=-np.inf))),
        "force_min": low,
        "force_max": largest(force, closer),
        "force_rms": square**0.5,
        "share_without_contact": float(weight[trace.free].sum()),
    }


def _read(trace: Trace, piece: NDArray[np.int64], local: Array) -> tuple[Array, Array]:
    """X and Φ at local times (0 to 1) of pieces, in the shape that both broadcast to."""
    gap, props = trace.gap[piece], trace.propagators
    powers = np.vander(local.ravel(), gap.shape[-1], increasing=True).reshape(*local.shape, -1)
    # einsum and not a matrix product: a fixed order of summation, whatever the number of threads
    x = np.einsum("...j,...j->...", gap, powers)
    order = np.arange(1, gap.shape[-1])
    slope = np.einsum("...j,...j->...", gap[..., 1:] * order, powers[..., :-1])
    velocity = slope / (trace.lengths[piece] * props.cell_duration)
    phase = trace.base + (trace.positions[piece] + trace.lengths[piece] * local) / props.cells_per_cycle
    region = np.broadcast_to(trace.regions[piece], x.shape)
    return x, contact_force(props.system, phase, x, velocity, region)
