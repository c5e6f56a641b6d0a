"""Constant columns of a region, and the bounds that prove cells and whole periods clear.

They depend on load, error and gap, and are summed anew when one of those changes (`_cells` is not)."""

from __future__ import annotations

import numpy as np

from gearlash._kernel.jit import array_of, boolean, float64, inlined, inner, int64, kernel, void

from ._series import contact_force, cut_off
from ._tables import CUBE, FREE, INTS, MUTABLE, NO_TENSION, ORDER, ROUGH, SIZES, TERMS, Shape, shape_of
from ._vector import greatest, least, linear, move, peak, weigh

UNIT_ROUNDING = 2.0**-53
TABLE_ROUNDING = 32.0 * UNIT_ROUNDING  # of a table's entries and of what is summed from them
LAP_DOUBLINGS = 10  # laps of a region, 2^10 of them, after which its own motion repeats


@inlined
def fine_coefficients(shape: Shape, memory, slot, cell, u, first, out, to):
    """out[to:] ← Bernstein coefficients (clearances, TERMS) of what is watched over the cell that starts
    (virtually) at the state at ``first`` in u."""
    length = shape.clearances * TERMS
    place = slot + shape.fine + cell * (1 + shape.n) * length
    linear(memory, place, length, length, 1 + shape.n, u, first, out, to)


@inner
def _watch(shape: Shape, memory, at, cell, c, column, sides, rules, watched):
    """Bernstein coefficients of what is watched of clearance c (X, or with the rule `no-tension` in contact
    Φ), a bound on their error, and one on the error of X, for one column of one cell."""
    n, count = shape.n, shape.clearances
    x = at + shape.gap + ((cell * count + c) * (1 + n) + column) * TERMS
    bulk = 0.0
    for j in range(ORDER + 1):
        watched[j] = memory[x + j]
        bulk += abs(memory[x + j])
    row = (cell * count + c) * shape.p + column
    tails = at + shape.tail + 4 * c
    own = 0 if column > 0 else 1
    tail, size = memory[tails + own], bulk
    memory[at + shape.bound + row] = tail + TABLE_ROUNDING * bulk
    if rules[c] == NO_TENSION and sides[c] != FREE:
        side = 0 if sides[c] == 0 else 1
        eta = shape.eta + ((cell * count + c) * 2 + side) * TERMS
        rate = memory[shape.gaps + 4 * c + 2 + side] / memory[shape.scalars + 1]
        lost = memory[shape.lost + 2 * c + side]
        stiff = lost
        for j in range(ORDER + 1):
            stiff += abs(memory[eta + j])
        size = stiff * size + rate * ORDER * bulk
        tail = stiff * tail + rate * memory[tails + 2 + own] + lost * bulk + cut_off(memory, eta, memory, x)
        contact_force(memory, eta, memory, x, memory[x], rate, watched, TERMS, 0)
    place = at + shape.fine + ((cell * (1 + n) + column) * count + c) * TERMS
    linear(memory, shape.bernstein, TERMS, TERMS, ORDER + 1, watched, 0, memory, place)
    memory[at + shape.rest + row] = tail + TABLE_ROUNDING * size
    place = at + shape.step + (cell * (1 + n) + column) * shape.rows + shape.p + ROUGH * c
    linear(memory, shape.rough, ROUGH, ROUGH, ORDER + 1, watched, 0, memory, place)
    spared = weigh(memory, shape.spared, TERMS, watched, 0)
    memory[at + shape.near + row] = tail + TABLE_ROUNDING * size + spared


@kernel(
    void(SIZES, MUTABLE, int64, MUTABLE, CUBE, array_of(float64, 4), INTS, INTS, boolean, int64, int64),
    allocates=True,
)
def assemble(sizes, memory, at, amplitudes, ends, gaps, sides, rules, all_columns, first, until):
    """Sums unit responses to the constant columns of the slot at ``at``, and writes for them (or for all
    columns) the Bernstein coefficients of what is watched, with their bounds; for the cells from ``first``
    on and before ``until``.

    amplitudes (u)."""
    shape = shape_of(sizes)
    n, count = shape.n, shape.clearances
    watched = np.zeros(3 * TERMS)
    for cell in range(first, until):
        place = at + shape.step + cell * (1 + n) * shape.rows
        for i in range(shape.rows):
            memory[place + i] = 0.0
        memory[place] = 1.0
        for u in range(len(amplitudes)):
            for i in range(n):
                memory[place + 1 + i] += amplitudes[u] * ends[cell, u, i]
        for c in range(count):
            place = at + shape.gap + (cell * count + c) * (1 + n) * TERMS
            for j in range(TERMS):
                memory[place + j] = 0.0
            for u in range(len(amplitudes)):
                for j in range(ORDER + 1):
                    memory[place + j] += amplitudes[u] * gaps[cell, c, u, j]
            for column in range(1 + n if all_columns else 1):
                _watch(shape, memory, at, cell, c, column, sides, rules, watched)


@inner
def _over_the_period(shape: Shape, memory, at, columns, out, swing):
    """columns (1+n, p) ← the map over a base period; swing (clearances, p) ← how far a unit of each
    state moves what is watched, at most."""
    n, p, count, rows = shape.n, shape.p, shape.clearances, shape.rows
    for k in range(1 + n):
        columns[k * p + k] = 1.0
    for cell in range(shape.cells):
        step = at + shape.step + cell * (1 + n) * rows
        for k in range(1 + n):
            linear(memory, step, rows, p, 1 + n, columns, k * p, out, 0)
            fine_coefficients(shape, memory, at, cell, columns, k * p, out, p)
            for c in range(count):
                rest = weigh(memory, at + shape.rest + (cell * count + c) * p, p, columns, k * p)
                swing[c * p + k] = max(swing[c * p + k], peak(out, p + TERMS * c, TERMS) + rest)
            move(out, 0, columns, k * p, p)
    for c in range(count):
        swing[c * p] = 0.0


@inner
def _margins(shape: Shape, memory, at, sides, u, out):
    """How far what is watched stays from its limits on the motion that starts at u (p), over a base
    period."""
    n, p, count, rows = shape.n, shape.p, shape.clearances, shape.rows
    for c in range(2 * count):
        memory[at + shape.margin + c] = np.inf
    for cell in range(shape.cells):
        step = at + shape.step + cell * (1 + n) * rows
        linear(memory, step, rows, p, 1 + n, u, 0, out, 0)
        fine_coefficients(shape, memory, at, cell, u, 0, out, p)
        for c in range(count):
            rest = weigh(memory, at + shape.rest + (cell * count + c) * p, p, u, 0)
            lower = -memory[shape.gaps + 4 * c + 1] if sides[c] == FREE else 0.0
            upper = memory[shape.gaps + 4 * c] if sides[c] == FREE else 0.0
            margin = at + shape.margin + 2 * c
            below = (least(out, p + TERMS * c) - rest - lower) * (1.0 - 1e-9)
            above = (upper - greatest(out, p + TERMS * c) - rest) * (1.0 - 1e-9)
            memory[margin] = below if not below >= memory[margin] else memory[margin]
            memory[margin + 1] = above if not above >= memory[margin + 1] else memory[margin + 1]
        move(out, 0, u, 0, p)


@kernel(void(SIZES, MUTABLE, int64, INTS), allocates=True)
def laps(sizes, memory, at, sides):
    """Writes what proves a whole base period to be clear at once: the map over it, a motion in the
    region that (where it is stable) repeats itself, how far that one stays from its limits, and how far
    a unit of each state can move another one from it."""
    shape = shape_of(sizes)
    n, p, count = shape.n, shape.p, shape.clearances
    columns, twice, out = np.zeros((1 + n) * p), np.zeros((1 + n) * p), np.zeros(p + TERMS * count)
    swing, u = np.zeros(count * p), np.zeros(p)
    _over_the_period(shape, memory, at, columns, out, swing)
    move(columns, 0, memory, at + shape.lap, (1 + n) * p)
    move(swing, 0, memory, at + shape.swing, count * p)
    for _ in range(LAP_DOUBLINGS):
        for k in range(1 + n):
            linear(columns, 0, p, p, 1 + n, columns, k * p, twice, k * p)
        columns, twice = twice, columns
    move(columns, 0, u, 0, p)
    move(u, 0, memory, at + shape.centred, p)
    _margins(shape, memory, at, sides, u, out)
