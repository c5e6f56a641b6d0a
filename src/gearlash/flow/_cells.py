"""Tables of one region: what a motion does in every cell, column by column, by Taylor series.

A column is the response to a unit start in one state, or from rest to one unit input: a harmonic of the
forcing on one state, the edge of a gap, or a harmonic of a gap's offset. Load, error and gap are amplitudes
of such inputs, so changing them rebuilds nothing (`_assemble`). Where nobody will change them, an input is a
whole series of harmonics (`responses.summed`), and there are few columns. Columns lie side by side in the
lanes of vectors, and all are carried through the recurrence of a cell at once."""

from __future__ import annotations

import numpy as np

from gearlash._kernel.jit import allocating, array_of, boolean, float64, inner, int64, kernel, tuple_of, void

from ._blocks import LANES, padded
from ._remainder import eta_bounds, majorant
from ._series import fill, fourier_taylor
from ._tables import CUBE, FREE, INTS, MATRIX, MUTABLE, ORDER, SIZES, TABLE, TERMS, Shape, shape_of
from ._vector import add, linear, move, multiple, peak

TOGETHER = 4  # cells that are carried through the recurrence at a time
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
    n, gaps, cells, lanes, states, equations, filled, readers, active, eta, duration, units, sources, z, new,
    total, x, last, read,
):  # fmt: skip
    """Taylor series of all columns over some ``cells``, each of which has ``lanes`` of its own: ``total``
    (n, cells, lanes) receives the states at their ends, ``x`` (gaps, ORDER+1, cells, lanes) the coefficients
    of what ``readers`` (gaps, n) read; last (n) the largest of the last coefficients of each state, read
    (gaps, ORDER+1) the largest of what is read.

    states: how many columns are unit starts, those of the units lie behind them; equations (n, n + gaps):
    the matrix, and how each force enters; filled (n, 2): where in each row the first number is that is not
    zero, and how many follow up to the last (of springs and dampers, half the rows hold a single 1); eta
    (cells, gaps, TERMS): coefficients of η in falling order; units (u, 3): kind, clearance or state, slot of
    the series; sources (cells, u, TERMS). z, new (n + gaps, cells, lanes): work."""
    width = cells * lanes
    series, inputs = (ORDER + 1) * width, len(units) * TERMS
    for j in range(ORDER + 1):
        for c in range(gaps):
            linear(z, 0, width, width, n, readers, c * n, x, c * series + j * width)
        for u in range(len(units)):
            if units[u, 0] <= OFFSET:
                place = units[u, 1] * series + j * width + states + u
                for k in range(cells):
                    x[place + k * lanes] -= sources[k * inputs + u * TERMS + j]
        for c in range(gaps):
            size = peak(x, c * series + j * width, width)
            if not size <= read[c, j]:
                read[c, j] = size
        if j == ORDER:
            break
        for c in range(gaps):
            if active[c] != 0:
                for k in range(cells):
                    own, at = k * lanes, (k * gaps + c) * TERMS + ORDER - j
                    linear(x, c * series + own, width, lanes, j + 1, eta, at, z, (n + c) * width + own)
        scale = duration / (j + 1)
        for i in range(n):
            first = filled[i, 0]
            row = i * (n + gaps) + first
            linear(z, first * width, width, width, filled[i, 1], equations, row, new, i * width)
        multiple(scale, new, 0, new, 0, n * width)
        for u in range(len(units)):
            if units[u, 0] == FORCED:
                place = units[u, 1] * width + states + u
                for k in range(cells):
                    new[place + k * lanes] += sources[k * inputs + u * TERMS + j] * scale
        add(1.0, new, 0, total, 0, n * width)
        z, new = new, z
    for i in range(n):
        size = peak(z, i * width, width)
        if not size <= last[i]:
            last[i] = size


@allocating
def _zeros(size):
    """So many, whole blocks on cache lines of their own: one that lies across two takes many times as long to
    load just after it was stored (`_tables.aligned`)."""
    room = np.zeros(size + LANES)
    first = -(room.ctypes.data // room.itemsize) % LANES
    return room[first : first + size]


@inner
def _start(n, cells, lanes, states, units, series, centres, z, new, total):
    """Unit starts in the first lanes of every cell, n of them or none; the centre that undoes an edge or a
    constant offset in theirs (``total`` is told from there)."""
    width = cells * lanes
    fill(z, 0.0)
    fill(new, 0.0)
    fill(total, 0.0)
    for k in range(cells):
        for i in range(states):
            z[i * width + k * lanes + i] = 1.0
            total[i * width + k * lanes + i] = 1.0
        for u in range(len(units)):
            if units[u, 0] <= OFFSET:
                for i in range(n):
                    z[i * width + k * lanes + states + u] = series[u, 0] * centres[units[u, 1], i]


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
def _keep_states(shape: Shape, memory, at, cell, width, own, total, x):
    """The columns of unit starts, which lie from ``own`` on in rows of this width."""
    n, count = shape.n, shape.clearances
    for column in range(n):
        place = at + shape.step + (cell * (1 + n) + 1 + column) * shape.rows
        for i in range(n):
            memory[place + 1 + i] = total[i * width + own + column]
        for c in range(count):
            place = at + shape.gap + ((cell * count + c) * (1 + n) + 1 + column) * TERMS
            for j in range(ORDER + 1):
                memory[place + j] = x[(c * (ORDER + 1) + j) * width + own + column]


@inner
def _keep_units(cell, width, own, total, x, ends, gaps):
    """The columns of unit inputs."""
    for u in range(ends.shape[1]):
        for i in range(ends.shape[2]):
            ends[cell, u, i] = total[i * width + own + u]
        for c in range(gaps.shape[1]):
            for j in range(ORDER + 1):
                gaps[cell, c, u, j] = x[(c * (ORDER + 1) + j) * width + own + u]


@inner
def _keep_backward(shape: Shape, memory, at, cell, width, own, x):
    """What the transposed system reads with g is the flow from s back to the start of the cell, applied to
    g."""
    count = shape.clearances
    for c in range(count):
        for j in range(ORDER + 1):
            place = at + shape.pull + ((cell * count + c) * (ORDER + 1) + j) * shape.p
            for i in range(shape.n):
                memory[place + 1 + i] = x[(c * (ORDER + 1) + j) * width + own + i]
        _times_stiffness(shape, memory, at, cell, c, 0)
        row = (cell * count + c) * 2
        push, length = at + shape.push + row * (ORDER + 1) * shape.p, (ORDER + 1) * shape.p
        if _same(memory, shape.eta + row * TERMS, shape.eta + (row + 1) * TERMS):
            move(memory, push, memory, push + length, length)
        else:
            _times_stiffness(shape, memory, at, cell, c, 1)


@inner
def _same(memory, one, other):
    """Whether two polynomials are the same."""
    equal = 0
    for j in range(TERMS):
        equal += memory[one + j] == memory[other + j]
    return equal == TERMS


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


@inner
def _is_steady(shape: Shape, memory, sides):
    """Whether the equations of a region are the same in all cells: no stiffness that acts has harmonics."""
    series = 2 * shape.harmonics + 1
    for c in range(shape.clearances):
        if sides[c] != FREE:
            at = shape.stiffness + (2 * c + (0 if sides[c] == 0 else 1)) * series
            for k in range(1, series):
                if memory[at + k] != 0.0:
                    return False
    return True


@inner
def _inputs(shape: Shape, memory, sides, units, series, cell, k, one, eta, sources):
    """eta (cells, gaps, TERMS), sources (cells, u, TERMS) ← Taylor coefficients over a cell, as the ``k``th:
    of the stiffness that acts, in falling order, and of every unit input."""
    count, width = shape.clearances, memory[shape.scalars + 2]
    for c in range(count):
        place = shape.eta + ((cell * count + c) * 2 + (0 if sides[c] == 0 else 1)) * TERMS
        for j in range(ORDER + 1):
            eta[(k * count + c) * TERMS + ORDER - j] = memory[place + j]
    for u in range(len(units)):
        fill(one, 0.0)
        for slot in range(units[u, 2] + 1):
            one[slot] = series[u, slot]
        at = (k * len(units) + u) * TERMS
        fourier_taylor(one, 0, (units[u, 2] + 1) // 2, cell * width, width, sources, at)


@inner
def _highest(units):
    """The highest harmonic of all unit inputs."""
    highest = 0
    for u in range(len(units)):
        highest = max(highest, (units[u, 2] + 1) // 2)
    return highest


@allocating
def _through_cells(
    shape: Shape, memory, at, equations, filled, reads, sides, active, units, series, centres, back, ends,
    gaps, first, until, last, read, bound,
):  # fmt: skip
    """Carries all columns through the cells from ``first`` on and before ``until``, forward or ``back`` (the
    transposed system in reversed time), and keeps them, with the largest of what the remainder is bounded
    by (`_recurrence`); returns the bounds of `_remainder.majorant` behind the last cell, infinite ones as
    soon as the first cell shows that they would be above ``bound``.

    Cells are carried some at a time: what one waits for, others need not. Where the equations are the same in
    all of them, unit starts are carried through the first one only."""
    n, count, steady, own = shape.n, shape.clearances, _is_steady(shape, memory, sides), len(units)
    lanes, few, rows, highest = _padded(n + own), _padded(own), n + count, _highest(units)
    most = 1 if steady else TOGETHER
    duration, turn = memory[shape.scalars + 1], highest * memory[shape.scalars + 2]
    bounds = eta_bounds(shape, memory, active, sides, memory[shape.scalars + 2])
    eta, sources = np.zeros(TOGETHER * count * TERMS), np.zeros(TOGETHER * max(1, own) * TERMS)
    one, step = np.zeros(2 * highest + 1), -duration if back else duration
    size = max(most * lanes, TOGETHER * few)
    z, new, total = _zeros(rows * size), _zeros(rows * size), _zeros(n * most * lanes)
    x = _zeros(count * (ORDER + 1) * most * lanes)
    few_ends, few_x = _zeros(n * TOGETHER * few), _zeros(count * (ORDER + 1) * TOGETHER * few)
    cell, width = first, lanes
    while cell < until:
        cells = 1 if cell == first else min(TOGETHER, until - cell)
        for k in range(cells):
            _inputs(shape, memory, sides, units, series, cell + k, k, one, eta, sources)
        if cell == first or not steady:
            width = cells * lanes
            _start(n, cells, lanes, n, units, series, centres, z, new, total)
            _recurrence(
                n, count, cells, lanes, n, equations, filled, reads, active, eta, step, units, sources, z,
                new, total, x, last, read,
            )  # fmt: skip
            for k in range(cells):
                _keep_units(cell + k, width, k * lanes + n, total, x, ends, gaps)
        elif own > 0:
            _start(n, cells, few, 0, units, series, centres, z, new, few_ends)
            _recurrence(
                n, count, cells, few, 0, equations, filled, reads, active, eta, step, units, sources, z, new,
                few_ends, few_x, last, read,
            )  # fmt: skip
            for k in range(cells):
                _keep_units(cell + k, cells * few, k * few, few_ends, few_x, ends, gaps)
        for k in range(cells):
            place = 0 if steady else k * lanes
            if back:
                _keep_backward(shape, memory, at, cell + k, width, place, x)
            else:
                _keep_states(shape, memory, at, cell + k, width, place, total, x)
        if cell == 0 and not back:
            least, _ = majorant(equations, filled, reads, last, read, bounds, duration, turn, False)
            if not least <= bound:
                return np.inf, np.inf
        cell += cells
    if until < shape.cells:
        return 0.0, 0.0
    return majorant(equations, filled, reads, last, read, bounds, duration, turn, True)


@kernel(
    tuple_of(float64, 2)(
        SIZES, MUTABLE, int64, MATRIX, MATRIX, MATRIX, MATRIX, INTS, TABLE, CUBE, array_of(float64, 4),
        int64, int64, MATRIX, CUBE, float64, MATRIX, boolean,
    ),
    allocates=True,
)  # fmt: skip
def respond(
    sizes, memory, at, matrix, readers, actors, centres, sides, units, ends, gaps, first, until, last, read,
    bound, series, backward,
):  # fmt: skip
    """Fills, for the cells from ``first`` on and before ``until``, the columns of unit starts of `step` and
    `gap` in the slot at ``at``, with ``backward`` those of `pull`, and the unit responses ends (cells, u, n),
    gaps (cells, clearances, u, TERMS). With the last cell it returns the Taylor remainders of a unit column
    (of its states; with every term times its order), or infinity where that is above ``bound``; before,
    zeros. last (2, n) and read (2, clearances, ORDER+1), zeros at first, carry what they are bounded by from
    call to call, forward and backward.

    matrix (n, n) with its damping; readers, actors, centres (clearances, n): h, g, c with h_j·c_k = 1 for
    j = k, else 0; sides (clearances): `PLUS`, `FREE` or `MINUS`; units (u, 3): kind, clearance or state, the
    last slot of the series; series (u, slots): those series, whose absolute values sum up to 1 at most."""
    shape = shape_of(sizes)
    n, count = shape.n, shape.clearances
    equations, reads, active = np.zeros(n * (n + count)), np.zeros(count * n), np.zeros(count, np.int64)
    filled = np.zeros((n, 2), np.int64)
    for c in range(count):
        active[c] = 0 if sides[c] == FREE else 1
    _equations(n, count, matrix, readers, actors, False, equations, filled, reads)
    value, derived = _through_cells(
        shape, memory, at, equations, filled, reads, sides, active, units, series, centres, False, ends, gaps,
        first, until, last[0], read[0], bound,
    )  # fmt: skip
    if not value <= bound:
        return np.inf, np.inf
    if not backward:
        return value, derived
    _equations(n, count, matrix, readers, actors, True, equations, filled, reads)
    none, no_ends, no_gaps = np.zeros((0, 3), np.int64), np.zeros((0, 0, 0)), np.zeros((0, 0, 0, 0))
    back, _ = _through_cells(
        shape, memory, at, equations, filled, reads, sides, active, none, series, centres, True, no_ends,
        no_gaps, first, until, last[1], read[1], bound,
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
