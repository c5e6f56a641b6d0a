"""The periodic motion that a system of one clearance would have if it stayed in one of its regions for ever.

There it is linear with periodic coefficients: one period's map has one fixed point, which is solved for, not
searched. No contact event can happen on it, so that less has to be made than tables for marching (those of
`propagators`): only what goes forward, and one column for all harmonics of an input."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import numpy as np

from gearlash.system import GearlashError, System

from . import _march
from ._cells import stiffness_series
from ._one_region import over_cells, states_in_cells
from ._tables import FREE, ORDER, PLUS, TERMS, Array, Shape, aligned, constants, sizes_of
from .budget import check_cells, check_memory, laid_out
from .equations import write_system
from .propagators import GENTLE_TRIES, LATE_REFINEMENT, REFINEMENT, TRUNCATION
from .regions import Sides, first_guess
from .responses import responses, summed
from .tables import calls


@dataclass(frozen=True, eq=False)
class LinearMotion:
    """The periodic motion of one region.

    Parameters
    ----------
    system : System
    side : int
        Its region: `PLUS`, `FREE` or `MINUS`.
    map : array (n, n)
        Derivative of the return after a base period.
    duration : float
        Of a cell, in τ.
    beyond : array (cells, TERMS)
        Taylor coefficients of the gap from the edge of the region, in local time of every cell.
    stiffness : array (cells, TERMS)
        The same of the stiffness that acts.
    to_bernstein : array
        From Taylor coefficients of degree ORDER - 1.
    """

    system: System
    side: int
    map: Array
    duration: float
    beyond: Array
    stiffness: Array
    to_bernstein: Array

    @property
    def stable(self) -> bool:
        """Whether all multipliers lie inside the unit circle."""
        return bool(np.abs(np.linalg.eigvals(self.map)).max() < 1.0)

    @property
    def force(self) -> Array:
        """Taylor coefficients (cells, TERMS) of the contact's force, cut off behind degree ORDER."""
        clearance, found = self.system.clearances[0], np.zeros_like(self.beyond)
        for j in range(ORDER + 1):
            found[:, j:] += self.stiffness[:, j : j + 1] * self.beyond[:, : TERMS - j]
        rates = self.beyond[:, 1:] * np.arange(1, TERMS) / self.duration
        found[:, :-1] += clearance.dampings[0 if self.side == PLUS else 1] * rates
        return found

    def least(self, series: Array, sign: int) -> float:
        """The least value over the period of ``sign`` times what polynomials (cells, TERMS) give."""
        pieces = np.zeros((len(series), 3))
        pieces[:, 0], pieces[:, 1] = np.arange(len(series)), 1.0
        found = np.empty((64 + 8 * len(series), 4))
        flat = np.ascontiguousarray(series).reshape(-1)
        count = _march.extrema(pieces, flat, self.to_bernstein, 0, found)
        return float(min((sign * series[:, 0]).min(), (sign * found[:count, 1]).min(initial=np.inf)))


def linear_motion(system: System, side: int) -> LinearMotion | None:
    """The periodic motion of a system of one clearance in a region, as if that had no end; None where there
    is no one such motion.

    Parameters
    ----------
    system : System
    side : int
        `PLUS`, `FREE` or `MINUS`.

    Raises
    ------
    GearlashError
        For several clearances, and systems that would need too many cells or too much memory.
    """
    if len(system.clearances) != 1:
        raise GearlashError(f"{len(system.clearances)} clearances: expected one")
    cells, tried = first_guess(system), 0
    while True:
        check_cells(system, cells)
        tables = _tables(system, (side,), int(cells))
        if tables is not None:
            return _closed_motion(system, side, *tables)
        cells, tried = ceil((REFINEMENT if tried < GENTLE_TRIES else LATE_REFINEMENT) * cells), tried + 1


def _tables(system: System, sides: Sides, cells: int) -> tuple[Shape, Array, Array] | None:
    """The memory with the tables of one region, and the constant columns of its gap (cells, TERMS); None
    where the Taylor remainder is above `TRUNCATION`."""
    shape = laid_out(system, cells)
    inputs, sizes = summed(system, sides, shape)
    check_memory(system, shape, 1, len(sizes))
    (memory,) = aligned(shape.slots + shape.slot)
    constants(shape, memory)
    write_system(system, shape, memory)
    stiffness_series(sizes_of(shape), memory)
    found = responses(system, shape, memory, shape.slots, sides, inputs, TRUNCATION, backward=False)
    if not found.remainder <= TRUNCATION:
        return None
    steps = memory[shape.slots + shape.step :][: cells * (1 + shape.n) * shape.rows]
    first = steps.reshape(cells, 1 + shape.n, shape.rows)[:, 0]
    first[:, 0], first[:, 1 : 1 + shape.n] = 1.0, np.einsum("u,cun->cn", sizes, found.ends)
    return shape, memory, np.einsum("u,cuj->cj", sizes, found.gaps[:, 0])


def _closed_motion(
    system: System, side: int, shape: Shape, memory: Array, constant: Array
) -> LinearMotion | None:
    """The motion that closes after a period."""
    n, p, at = shape.n, shape.p, shape.slots
    columns, start, work = aligned((1 + n) * p, p, p)
    columns[np.arange(1 + n) * (p + 1)] = 1.0
    for first, until in calls(shape):
        over_cells(sizes_of(shape), memory, at, first, until, columns, work)
    period = columns.reshape(1 + n, p)
    turned = np.ascontiguousarray(period[1:, 1 : 1 + n].T)
    try:
        start[0], start[1 : 1 + n] = 1.0, np.linalg.solve(np.eye(n) - turned, period[0, 1 : 1 + n])
    except np.linalg.LinAlgError:
        return None
    if not np.isfinite(start).all():
        return None
    (found,) = aligned(shape.cells * p)
    for first, until in calls(shape):
        states_in_cells(sizes_of(shape), memory, at, first, until, start, found)
    states = found.reshape(shape.cells, p)
    own = memory[at + shape.gap :][: shape.cells * (1 + n) * TERMS].reshape(shape.cells, 1 + n, TERMS)[:, 1:]
    beyond = constant + np.einsum("ci,cij->cj", states[:, 1 : 1 + n], own)
    eta = memory[shape.eta :][: shape.cells * 2 * TERMS].reshape(shape.cells, 2, TERMS)
    stiffness = np.zeros_like(beyond) if side == FREE else eta[:, 0 if side == PLUS else 1].copy()
    basis = memory[shape.bernstein + (ORDER + 1) * TERMS :][: (ORDER + 1) * TERMS].copy()
    return LinearMotion(system, side, turned, system.period / shape.cells, beyond, stiffness, basis)
