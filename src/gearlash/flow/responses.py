"""What a region does with unit starts and with its inputs, cell by cell: the tables of `_cells`, and of which
inputs they are made."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearlash.system import System, padded

from ._cells import FORCED, OFFSET, respond
from ._tables import ORDER, TERMS, Array, Shape, sizes_of
from .equations import write_region
from .regions import Sides, centres_of, edges_of, forcing_of, matrix_of
from .tables import calls


class Inputs(NamedTuple):
    """Inputs of a region, each a Fourier series whose absolute values sum up to 1 at most.

    units (u, 3): kind, clearance or state, the last slot of the series that is not zero; series (u, slots);
    centres (clearances, n)."""

    units: Array
    series: Array
    centres: Array


class Responses(NamedTuple):
    """To the inputs: states at the ends of cells (cells, u, n), Taylor coefficients of gaps (cells,
    clearances, u, TERMS); bounds on the Taylor remainders of a unit column (of its states; with every term
    times its order)."""

    ends: Array
    gaps: Array
    remainder: float
    derived: float


def each_alone(units: Array, centres: Array, shape: Shape) -> Inputs:
    """Every slot of every series is an input: its amplitude may be changed later."""
    series = np.zeros((len(units), 2 * shape.harmonics + 1))
    series[np.arange(len(units)), units[:, 2]] = 1.0
    return Inputs(units, series, centres)


def summed(system: System, sides: Sides, shape: Shape) -> tuple[Inputs, Array]:
    """Whole series as inputs, with their amplitudes (u,): few columns, good for these numbers alone. The edge
    of a clearance is the mean of its offset."""
    slots = 2 * shape.harmonics + 1
    rows = [(OFFSET, c, padded(each.offset, shape.harmonics)) for c, each in enumerate(system.clearances)]
    for (_, _, series), edge in zip(rows, edges_of(system, sides), strict=True):
        series[0] += edge
    rows += [(FORCED, i, padded(each, shape.harmonics)) for i, each in enumerate(forcing_of(system, sides))]
    rows = [row for row in rows if row[2].any()]
    sizes = np.array([np.abs(series).sum() for *_, series in rows])
    units = np.array([(kind, index, slots - 1) for kind, index, _ in rows], dtype=np.int64).reshape(-1, 3)
    shapes = np.array([series for *_, series in rows]).reshape(-1, slots) / sizes[:, None]
    return Inputs(units, shapes, centres_of(system)), sizes


def responses(
    system: System, shape: Shape, memory: Array, at: int, sides: Sides, inputs: Inputs, bound: float,
    *, backward: bool = True,
) -> Responses:  # fmt: skip
    """Writes the homogeneous tables of a region into its slot; remainders are infinite where they are above
    the bound. Not ``backward``: without what contact events need."""
    ends = np.zeros((shape.cells, len(inputs.units), shape.n))
    gaps = np.zeros((shape.cells, shape.clearances, len(inputs.units), TERMS))
    matrix = matrix_of(system, sides).copy()
    readers = np.array([c.h for c in system.clearances], dtype=np.float64)
    actors = np.array([c.g for c in system.clearances], dtype=np.float64)
    last, read = np.zeros((2, shape.n)), np.zeros((2, shape.clearances, ORDER + 1))
    value = derived = 0.0
    for first, until in calls(shape):
        value, derived = respond(
            sizes_of(shape), memory, at, matrix, readers, actors, inputs.centres,
            np.array(sides, dtype=np.int64), inputs.units, ends, gaps, first, until, last, read, bound,
            inputs.series, backward,
        )  # fmt: skip
        if not value <= bound:
            break
    write_region(system, shape, memory, at, matrix)
    return Responses(ends, gaps, value, derived)
