"""A motion that stays in one region: the map over a period, and its states at the starts of all cells."""

from __future__ import annotations

from gearlash._kernel.jit import int64, kernel, void

from ._tables import FLOATS, MUTABLE, SIZES, shape_of
from ._vector import linear, move


@kernel(void(SIZES, FLOATS, int64, int64, int64, MUTABLE, MUTABLE))
def over_cells(sizes, memory, at, first, until, columns, out):
    """columns (1+n, p) ← what the map over the cells from ``first`` on and before ``until`` makes of them;
    out (p): work."""
    shape = shape_of(sizes)
    n, p, rows = shape.n, shape.p, shape.rows
    for cell in range(first, until):
        step = at + shape.step + cell * (1 + n) * rows
        for k in range(1 + n):
            linear(memory, step, rows, p, 1 + n, columns, k * p, out, 0)
            move(out, 0, columns, k * p, p)


@kernel(void(SIZES, FLOATS, int64, int64, int64, MUTABLE, MUTABLE))
def states_in_cells(sizes, memory, at, first, until, u, states):
    """states (cells·p) ← u (p) at the starts of the cells from ``first`` on and before ``until``; u ← the
    state behind them."""
    shape = shape_of(sizes)
    n, p, rows = shape.n, shape.p, shape.rows
    for cell in range(first, until):
        step = at + shape.step + cell * (1 + n) * rows
        move(u, 0, states, cell * p, p)
        linear(memory, step, rows, p, 1 + n, states, cell * p, u, 0)
