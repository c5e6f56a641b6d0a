"""The contact force of one side as a function of time, and its extrema.

With the rule `no-tension` a contact ends where its force falls to zero, before the gap opens. What a contact
may graze there is Φ = 0, so the extrema of Φ take the place of those of X. In pieces where the sides overlap
but nothing presses, Φ is what the force would be."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Trace
from gearlash.system import derivative, evaluate

Array = NDArray[np.float64]

NODES = np.linspace(0.0, 1.0, 9)  # of a piece, which is shorter than a fifth of the fastest oscillation
ROOT_STEPS = 60
ROUNDING = 2e-16  # of a piece
SIDE_OF_MODE = {0: 1, 2: -1, 3: 1, 4: -1}  # mode of a trace's piece → the boundary whose force acts, or would


@dataclass(frozen=True, eq=False)
class ForceExtrema:
    """Simple zeros of Φ' of one clearance: phase (mesh cycles), force Φ, curvature Φ'' (d²/dτ²), state (m,
    n), displacement X, boundary (±1), and whether the contact presses there."""

    phase: Array
    force: Array
    curvature: Array
    state: Array
    displacement: Array
    boundary: NDArray[np.int64]
    in_contact: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.phase)


def force_series(
    trace: Trace, clearance: int, piece: NDArray[np.int64], local: Array, boundary: NDArray[np.int64]
) -> tuple[Array, Array, Array]:
    """Φ, Φ' and Φ'' (τ) as side ``boundary`` would press, at local times (0 to 1) of pieces; all (m,)."""
    props, c = trace.propagators, trace.propagators.system.clearances[clearance]
    duration = trace.lengths[piece] * props.cell_duration
    x, x1, x2, x3 = _derivatives(trace.gap_of(clearance)[piece], local, duration)
    plus = boundary > 0
    beyond = x - np.where(plus, c.gap_plus, -c.gap_minus)
    theta = 2.0 * np.pi / props.cells * (trace.positions[piece] + trace.lengths[piece] * local)
    rate = props.system.omega / props.system.cycles
    series = [c.stiffness_plus, c.stiffness_minus]
    eta = np.where(plus, *(evaluate(s, theta) for s in series))
    eta1 = rate * np.where(plus, *(evaluate(derivative(s), theta) for s in series))
    eta2 = rate * rate * np.where(plus, *(evaluate(derivative(derivative(s)), theta) for s in series))
    damping = np.where(plus, *c.dampings)
    return (
        eta * beyond + damping * x1,
        eta1 * beyond + eta * x1 + damping * x2,
        eta2 * beyond + 2.0 * eta1 * x1 + eta * x2 + damping * x3,
    )


def force_extrema(trace: Trace, clearance: int) -> ForceExtrema:
    """Every extremum of the force of a clearance, where it presses or overlaps. To rounding; that there is no
    further one between the nodes of a piece is not proved."""
    piece, side = _overlapping(trace, clearance)
    at = np.broadcast_to(NODES, (len(piece), len(NODES)))
    index = np.repeat(piece[:, None], len(NODES), axis=1)
    sides = np.repeat(side[:, None], len(NODES), axis=1)
    slope = force_series(trace, clearance, index.ravel(), at.ravel(), sides.ravel())[1].reshape(at.shape)
    row, left = np.nonzero((slope[:, :-1] < 0.0) != (slope[:, 1:] < 0.0))
    piece, side = piece[row], side[row]
    local = _stationary(trace, clearance, piece, side, (NODES[left], NODES[left + 1]))
    force, _, curvature = force_series(trace, clearance, piece, local, side)
    per_cycle = trace.propagators.cells_per_cycle
    phase = trace.base + (trace.positions[piece] + trace.lengths[piece] * local) / per_cycle
    powers = np.vander(local, trace.polynomials.shape[1], increasing=True)
    state = np.einsum("mj,mjn->mn", powers, trace.polynomials[piece])
    gap = np.einsum("mj,mj->m", powers, trace.gap_of(clearance)[piece])
    in_contact = trace.modes[piece, clearance] <= 2
    return ForceExtrema(phase, force, curvature, state, gap, side, in_contact)


def _stationary(
    trace: Trace,
    clearance: int,
    piece: NDArray[np.int64],
    side: NDArray[np.int64],
    between: tuple[Array, Array],
) -> Array:
    """Zeros of Φ' at local times between two at which its signs differ: Newton's steps, and halves of what
    is left where one leads out of it."""
    low, high = between
    if not len(piece):
        return low
    duration = trace.lengths[piece] * trace.propagators.cell_duration
    falling = force_series(trace, clearance, piece, low, side)[1] < 0.0
    local = 0.5 * (low + high)
    for _ in range(ROOT_STEPS):
        _, slope, curvature = force_series(trace, clearance, piece, local, side)
        same = (slope < 0.0) == falling
        low, high = np.where(same, local, low), np.where(same, high, local)
        bend = curvature * duration
        step = np.divide(slope, bend, out=np.full_like(slope, np.inf), where=bend != 0.0)
        inside = (local - step >= low) & (local - step <= high)
        after = np.where(inside, local - step, 0.5 * (low + high))
        moved, local = np.abs(after - local).max(), after
        if moved <= ROUNDING:
            break
    return local


def least_force(trace: Trace, clearance: int) -> float:
    """The smallest |Φ| at extrema and kinks of the force, where it presses or overlaps; infinite without."""
    piece, side = _overlapping(trace, clearance)
    ends = []
    for local in (0.0, 1.0):  # a contact elsewhere may bend the force here
        force, *_ = force_series(trace, clearance, piece, np.full(len(piece), local), side)
        phase = trace.base + (trace.positions[piece] + local * trace.lengths[piece]) / (
            trace.propagators.cells_per_cycle
        )
        own = trace.events.of(clearance).phase
        apart = np.abs(phase[:, None] - own[None, :]).min(axis=1, initial=np.inf)
        ends.append(np.abs(force[apart > 1e-9]))
    return float(np.concatenate([*ends, np.abs(force_extrema(trace, clearance).force)]).min(initial=np.inf))


def _overlapping(trace: Trace, clearance: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Pieces in which a side overlaps, and that side (±1)."""
    modes = trace.modes[:, clearance]
    piece = np.flatnonzero(np.isin(modes, list(SIDE_OF_MODE)))
    return piece, np.array([SIDE_OF_MODE[int(mode)] for mode in modes[piece]], dtype=np.int64)


def _derivatives(coefficients: Array, local: Array, duration: Array) -> list[Array]:
    """A polynomial (m, degree+1) and its first three derivatives in τ at local times (m,)."""
    found, series = [], coefficients
    for _ in range(4):
        powers = np.vander(local, series.shape[1], increasing=True)
        found.append(np.einsum("mj,mj->m", powers, series))
        series = series[:, 1:] * np.arange(1, series.shape[1]) / duration[:, None]
    return found
