"""Tables of one region: what a motion does in every cell, column by column, by Taylor series.

A column is the response to a unit start in one state, or from rest to one unit input: a harmonic of the
forcing on one state, the edge of a gap, or a harmonic of a gap's offset. Load, error and gap are amplitudes
of such inputs, so changing them rebuilds nothing (`_assemble`). Columns lie side by side in the lanes of
vectors, and all are carried through the recurrence of a cell at once."""

from __future__ import annotations

import numpy as np

from gearlash._kernel.jit import allocating, array_of, float64, inner, int64, kernel, tuple_of, void

from ._blocks import padded
from ._remainder import eta_bounds, majorant
from ._series import fill, fourier_taylor
from ._tables import CUBE, FREE, INTS, MATRIX, MUTABLE, ORDER, SIZES, TABLE, TERMS, Shape, shape_of
from ._vector import add, linear, multiple, peak

EDGE, OFFSET, FORCED = 0, 1, 2  # kinds of unit input; the first two start from the centre that undoes them

_padded = inner(padded)


@kernel(void(SIZES, MUTABLE))
def stiffness_series(sizes, memory):
    """Fills `eta`: Taylor coefficients of η over every cell, for both sides of every clearance."""
    shape = shape_of(sizes)
    width, series = memory[shape.scalars + 2], 2 * shape.harmonics + 1
    for cell in range(shape.cells):
        for k in range(2 * shape.clearances):
            place = shape.eta + (2 * cell * shape.clearances + k) * TERMS
            fourier_taylor(
                memory, shape.stiffness + k * series, shape.harmonics, cell * width, width, memory, place
            )


@inner
def _recurrence(
    n, gaps, lanes, equations, filled, readers, active, eta, duration, units, sources, z, new, total, x, last,
    read,
):  # fmt: skip
    """Taylor series of all columns over one cell: ``total`` (n, lanes) receives the states at its end, ``x``
    (gaps, ORDER+1, lanes) the coefficients of what ``readers`` (gaps, n) read; last (n) the largest of the
    last coefficients of each state, read (gaps, ORDER+1) the largest of what is read.

    equations (n, n + gaps): the matrix, and how each force enters; filled (n, 2): where in each row the first
    number is that is not zero, and how many follow up to the last (of springs and dampers, half the rows hold
    a single 1); eta (gaps, TERMS): coefficients of η in falling order; units (u, 3): kind, clearance or
    state, slot of the series. z, new (n + gaps, lanes): work.
    """
    series = (ORDER + 1) * lanes
    for j in range(ORDER + 1):
        for c in range(gaps):
            linear(z, 0, lanes, lanes, n, readers, c * n, x, c * series + j * lanes)
        for u in range(len(units)):
            if units[u, 0] <= OFFSET:
                x[units[u, 1] * series + j * lanes + n + u] -= sources[u * TERMS + j]
        for c in range(gaps):
            size = peak(x, c * series + j * lanes, lanes)
            if not size <= read[c, j]:
                read[c, j] = size
        if j == ORDER:
            break
        for c in range(gaps):
            if active[c] != 0:
                linear(x, c * series, lanes, lanes, j + 1, eta, c * TERMS + ORDER - j, z, (n + c) * lanes)
        scale = duration / (j + 1)
        for i in range(n):
            first = filled[i, 0]
            row = i * (n + gaps) + first
            linear(z, first * lanes, lanes, lanes, filled[i, 1], equations, row, new, i * lanes)
        multiple(scale, new, 0, new, 0, n * lanes)
        for u in range(len(units)):
            if units[u, 0] == FORCED:
                new[units[u, 1] * lanes + n + u] += sources[u * TERMS + j] * scale
        add(1.0, new, 0, total, 0, n * lanes)
        z, new = new, z
    for i in range(n):
        size = peak(z, i * lanes, lanes)
        if not size <= last[i]:
            last[i] = size


@inner
def _start(n, lanes, units, centres, z, total):
    """Unit starts in the first n lanes; the centre that undoes an edge or a constant offset in theirs
    (``total`` is told from there)."""
    fill(z, 0.0)
    fill(total, 0.0)
    for i in range(n):
        z[i * lanes + i] = 1.0
        total[i * lanes + i] = 1.0
    for u in range(len(units)):
        if units[u, 0] <= OFFSET and units[u, 2] == 0:
            for i in range(n):
                z[i * lanes + n + u] = centres[units[u, 1], i]


@inner
def _equations(n, count, matrix, readers, actors, turned, out, filled, reads):
    """out (n, n + clearances) ← the matrix and how each force enters, filled (n, 2) ← which part of each row
    is not zero, reads (clearances, n) ← how gaps are read; ``turned``: of the transposed system, in which h
    and g change places."""
    for i in range(n):
        for k in range(n):
            out[i * (n + count) + k] = matrix[k, i] if turned else matrix[i, k]
        for c in range(count):
            out[i * (n + count) + n + c] = readers[c, i] if turned else actors[c, i]
            reads[c * n + i] = actors[c, i] if turned else readers[c, i]
        first, last, row = 0, n + count - 1, i * (n + count)
        while first < last and out[row + first] == 0.0:
            first += 1
        while last > first and out[row + last] == 0.0:
            last -= 1
        filled[i, 0], filled[i, 1] = first, last - first + 1


@inner
def _keep_forward(shape: Shape, memory, at, cell, lanes, total, x, ends, gaps):
    n, count = shape.n, shape.clearances
    for column in range(n):
        place = at + shape.step + (cell * (1 + n) + 1 + column) * shape.rows
        for i in range(n):
            memory[place + 1 + i] = total[i * lanes + column]
        for c in range(count):
            place = at + shape.gap + ((cell * count + c) * (1 + n) + 1 + column) * TERMS
            for j in range(ORDER + 1):
                memory[place + j] = x[(c * (ORDER + 1) + j) * lanes + column]
    for u in range(ends.shape[1]):
        for i in range(n):
            ends[cell, u, i] = total[i * lanes + n + u]
        for c in range(count):
            for j in range(ORDER + 1):
                gaps[cell, c, u, j] = x[(c * (ORDER + 1) + j) * lanes + n + u]


@inner
def _keep_backward(shape: Shape, memory, at, cell, lanes, x):
    """What the transposed system reads with g is the flow from s back to the start of the cell, applied to
    g."""
    count = shape.clearances
    for c in range(count):
        for j in range(ORDER + 1):
            place = at + shape.pull + ((cell * count + c) * (ORDER + 1) + j) * shape.p
            for i in range(shape.n):
                memory[place + 1 + i] = x[(c * (ORDER + 1) + j) * lanes + i]
        for side in range(2):
            _times_stiffness(shape, memory, at, cell, c, side)


@inner
def _times_stiffness(shape: Shape, memory, at, cell, c, side):
    """`push` of one side of a clearance in one cell, behind ORDER cut off: `first_guess` has the rates of
    flow and stiffness together."""
    p, row = shape.p, cell * shape.clearances + c
    pull = at + shape.pull + row * (ORDER + 1) * p
    push = at + shape.push + (2 * row + side) * (ORDER + 1) * p
    eta = shape.eta + (2 * row + side) * TERMS
    for j in range(ORDER + 1):
        linear(memory, pull + j * p, -p, p, j + 1, memory, eta, memory, push + j * p)


@allocating
def _through_cells(
    shape: Shape, memory, at, equations, filled, reads, sides, active, units, centres, back, ends, gaps,
    first, until, last, read,
):  # fmt: skip
    """Carries all columns through the cells from ``first`` on and before ``until``, forward or ``back`` (the
    transposed system in reversed time), and keeps them, with the largest of what the remainder is bounded
    by (`_recurrence`); returns the bounds of `_remainder.majorant` behind the last cell."""
    n, count = shape.n, shape.clearances
    lanes, rows = _padded(n + len(units)), n + count
    duration, width = memory[shape.scalars + 1], memory[shape.scalars + 2]
    eta, sources = np.zeros(count * TERMS), np.zeros(max(1, len(units)) * TERMS)
    highest = 0
    for u in range(len(units)):
        highest = max(highest, (units[u, 2] + 1) // 2)
    one = np.zeros(2 * highest + 1)
    z, new, total = np.zeros(rows * lanes), np.zeros(rows * lanes), np.zeros(n * lanes)
    x = np.zeros(count * (ORDER + 1) * lanes)
    for cell in range(first, until):
        for c in range(count):
            place = shape.eta + ((cell * count + c) * 2 + (0 if sides[c] == 0 else 1)) * TERMS
            for j in range(ORDER + 1):
                eta[c * TERMS + ORDER - j] = memory[place + j]
        for u in range(len(units)):
            fill(one, 0.0)
            one[units[u, 2]] = 1.0  # an edge is a constant (slot 0)
            fourier_taylor(one, 0, (units[u, 2] + 1) // 2, cell * width, width, sources, u * TERMS)
        _start(n, lanes, units, centres, z, total)
        fill(new, 0.0)
        step = -duration if back else duration
        _recurrence(
            n, count, lanes, equations, filled, reads, active, eta, step, units, sources, z, new, total, x,
            last, read,
        )  # fmt: skip
        if back:
            _keep_backward(shape, memory, at, cell, lanes, x)
        else:
            _keep_forward(shape, memory, at, cell, lanes, total, x, ends, gaps)
    if until < shape.cells:
        return 0.0, 0.0
    bounds = eta_bounds(shape, memory, active, sides, width)
    return majorant(equations, reads, last, read, bounds, duration, highest * width)


@kernel(
    tuple_of(float64, 2)(
        SIZES, MUTABLE, int64, MATRIX, MATRIX, MATRIX, MATRIX, INTS, TABLE, CUBE, array_of(float64, 4),
        int64, int64, MATRIX, CUBE,
    ),
    allocates=True,
)  # fmt: skip
def respond(
    sizes, memory, at, matrix, readers, actors, centres, sides, units, ends, gaps, first, until, last, read,
):  # fmt: skip
    """Fills, for the cells from ``first`` on and before ``until``, the columns of unit starts of `step`,
    `gap` and `pull` in the slot at ``at``, and the unit responses ends (cells, u, n), gaps (cells,
    clearances, u, TERMS). With the last cell it returns the Taylor remainders of a unit column (of its
    states; with every term times its order), or infinity; before, zeros. last (2, n) and read (2, clearances,
    ORDER+1), zeros at first, carry what they are bounded by from call to call, forward and backward.

    matrix (n, n) with its damping; readers, actors, centres (clearances, n): h, g, c with h_j·c_k = 1 for
    j = k, else 0; sides (clearances): `PLUS`, `FREE` or `MINUS`; units (u, 3): kind, clearance or state, slot
    of the series."""
    shape = shape_of(sizes)
    n, count = shape.n, shape.clearances
    equations, reads, active = np.zeros(n * (n + count)), np.zeros(count * n), np.zeros(count, np.int64)
    filled = np.zeros((n, 2), np.int64)
    for c in range(count):
        active[c] = 0 if sides[c] == FREE else 1
    _equations(n, count, matrix, readers, actors, False, equations, filled, reads)
    value, derived = _through_cells(
        shape, memory, at, equations, filled, reads, sides, active, units, centres, False, ends, gaps,
        first, until, last[0], read[0],
    )  # fmt: skip
    _equations(n, count, matrix, readers, actors, True, equations, filled, reads)
    none = np.zeros((0, 3), np.int64)
    back, _ = _through_cells(
        shape, memory, at, equations, filled, reads, sides, active, none, centres, True, ends, gaps,
        first, until, last[1], read[1],
    )  # fmt: skip
    return max(value, back), derived


@kernel(float64(MATRIX, int64), allocates=True)
def spectral_radius(matrix, squarings):
    """Estimate of the largest |eigenvalue| as ‖A^(2^k)‖^(1/2^k), by plain loops so that it is the same
    everywhere."""
    n = matrix.shape[0]
    lanes = _padded(n)
    power, product, log = np.zeros(n * lanes), np.zeros(n * lanes), 0.0
    for i in range(n):
        for j in range(n):
            power[i * lanes + j] = matrix[i, j]
    for _ in range(squarings):
        for i in range(n):
            linear(power, 0, lanes, lanes, n, power, i * lanes, product, i * lanes)
        size = peak(product, 0, n * lanes)
        if size == 0.0:
            return 0.0
        for i in range(n * lanes):
            power[i] = product[i] / size
        log = 2.0 * log + np.log(size)
    rows = 0.0
    for i in range(n):
        row = 0.0
        for j in range(n):
            row += abs(power[i * lanes + j])
        rows = max(rows, row)
    return np.exp((log + np.log(rows)) / 2.0**squarings)
