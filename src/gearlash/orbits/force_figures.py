"""Extremes of motion and force of a trace, cheap enough for every point of a sweep."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Trace
from gearlash.flow.events import contact_force
from gearlash.orbits.statistics import top

Array = NDArray[np.float64]

NODES, WEIGHTS = np.polynomial.legendre.leggauss(10)
LOCAL = np.concatenate([[0.0], (NODES + 1.0) / 2.0, [1.0]])
AROUND = 3  # readings on either side of the extreme one, between which the force is read once more
CLOSER = np.linspace(0.0, 1.0, 61)


def force_figures(trace: Trace) -> dict[str, float]:
    """Extremes of X (exact, at its extrema), extremes and rms of Φ, share of time without contact (0 to 1).

    Each piece of the motion is read at 10 Gauss nodes and both ends. Pieces are shorter than a third of the
    fastest oscillation, so the rms is good to rounding; around its extreme readings Φ is read once more,
    closely, and a parabola makes the extremes good to about 1e-8 of their span.
    """
    pieces = np.arange(len(trace.lengths))
    x, force, phase = _read(trace, pieces[:, None], LOCAL[None, :])
    weight = trace.lengths / trace.lengths.sum()
    square = float((weight * (force[:, 1:-1] ** 2 * (WEIGHTS / 2.0)).sum(axis=1)).sum())
    low, high = _extremes(trace, force, phase)
    extrema = trace.extrema.displacement
    return {
        "minimum": float(min(x.min(), extrema.min(initial=np.inf))),
        "maximum": float(max(x.max(), extrema.max(initial=-np.inf))),
        "force_min": low,
        "force_max": high,
        "force_rms": square**0.5,
        "share_without_contact": float(weight[trace.free].sum()),
    }


def _read(trace: Trace, piece: NDArray[np.int64], local: Array) -> tuple[Array, Array, Array]:
    """X, Φ and phase (mesh cycles) at local times (0 to 1) of pieces, in the shape that both broadcast to."""
    gap, props = trace.gap[piece], trace.propagators
    powers = np.vander(local.ravel(), gap.shape[-1], increasing=True).reshape(*local.shape, -1)
    # einsum and not a matrix product: a fixed order of summation, whatever the number of threads
    x = np.einsum("...j,...j->...", gap, powers)
    order = np.arange(1, gap.shape[-1])
    slope = np.einsum("...j,...j->...", gap[..., 1:] * order, powers[..., :-1])
    velocity = slope / (trace.lengths[piece] * props.cell_duration)
    phase = trace.base + (trace.positions[piece] + trace.lengths[piece] * local) / props.cells_per_cycle
    region = np.broadcast_to(trace.regions[piece], x.shape)
    return x, contact_force(props.system, phase, x, velocity, region), phase


def _extremes(trace: Trace, force: Array, phase: Array) -> tuple[float, float]:
    """Least and largest Φ from readings (pieces, 12): around each it is read once more."""
    flat, when = force.ravel(), phase.ravel()  # pieces follow each other, and so do local times
    windows = []
    for i in (int(np.argmin(flat)), int(np.argmax(flat))):
        start, stop = when[max(0, i - AROUND)], when[min(len(when) - 1, i + AROUND)]
        windows.append(start + (stop - start) * CLOSER)
    cells = (np.concatenate(windows) - trace.base) * trace.propagators.cells_per_cycle
    piece = np.clip(np.searchsorted(trace.positions, cells, side="right") - 1, 0, len(trace.positions) - 1)
    local = (cells - trace.positions[piece]) / trace.lengths[piece]
    closer = _read(trace, piece, local)[1]
    least, most = closer[: len(CLOSER)], closer[len(CLOSER) :]
    return -max(top(-least), float(-flat.min())), max(top(most), float(flat.max()))
