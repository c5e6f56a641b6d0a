"""Tables of one region: what a motion does in every cell, column by column, by Taylor series.

A column is the response to a unit start in one state, or from rest to one unit input: a harmonic of the
forcing on one state, the edge of a gap, or a harmonic of a gap's offset. Load, error and gap are amplitudes
of such inputs, so changing them rebuilds nothing (`assemble`). Columns lie side by side in the lanes of
vectors, and all are carried through the recurrence of a cell at once."""

from __future__ import annotations

import numpy as np
from numba import float64, int64, types

from gearlash._kernel import allocating, inner, kernel

from ._series import fill, fourier_taylor, pressing
from ._tables import CHECK, CUBE, FREE, INTS, MATRIX, MUTABLE, NO_TENSION, ORDER, SHAPE, TABLE, TERMS, Shape
from ._vector import add, greatest, least, linear, move, multiple, padded, peak, weigh

EDGE, OFFSET, FORCED = 0, 1, 2  # kinds of unit input; the first two start from the centre that undoes them
DOUBLINGS = 10  # laps of a region, 2^10 of them, after which its own motion repeats
TAIL = 24  # further terms of the majorant that bounds the Taylor remainder
UNIT_ROUNDING = 2.0**-53
ROUNDING = 24.0 * UNIT_ROUNDING  # of a table's entries and of what is summed from them

_padded = inner(padded)


@kernel(types.void(SHAPE, MUTABLE))
def stiffness_series(shape: Shape, memory):
    """Fills `eta`: Taylor coefficients of η over every cell, for both sides of every clearance."""
    width, series = memory[shape.scalars + 2], 2 * shape.harmonics + 1
    for cell in range(shape.cells):
        for k in range(2 * shape.clearances):
            place = shape.eta + (2 * cell * shape.clearances + k) * TERMS
            fourier_taylor(
                memory, shape.stiffness + k * series, shape.harmonics, cell * width, width, memory, place
            )


@inner
def _recurrence(
    n, gaps, lanes, equations, readers, active, eta, duration, units, sources, z, new, total, x, last, read
):
    """Taylor series of all columns over one cell: ``total`` (n, lanes) receives the states at its end, ``x``
    (gaps, ORDER+1, lanes) the coefficients of what ``readers`` (gaps, n) read; last (n) the largest of the
    last coefficients of each state, read (gaps, ORDER+1) the largest of what is read.

    equations (n, n + gaps): the matrix, and how each force enters; eta (gaps, TERMS): coefficients of η in
    falling order; units (u, 3): kind, clearance or state, slot of the series. z, new (n + gaps, lanes): work.
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
            linear(z, 0, lanes, lanes, n + gaps, equations, i * (n + gaps), new, i * lanes)
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
    """Unit starts in the first n lanes; the centre that undoes an edge or a constant offset in theirs (``total``
    is told from there)."""
    fill(z, 0.0)
    fill(total, 0.0)
    for i in range(n):
        z[i * lanes + i] = 1.0
        total[i * lanes + i] = 1.0
    for u in range(len(units)):
        if units[u, 0] <= OFFSET and units[u, 2] == 0:
            for i in range(n):
                z[i * lanes + n + u] = centres[units[u, 1], i]


@allocating
def _majorant(equations, readers, last, known, eta, duration, rate):
    """Bound on the sum of all Taylor terms above ORDER of a unit column's states, and on that sum with every
    term times its order. The recurrence is repeated with absolute values, from the computed terms on.

    equations (n, n + gaps), readers (gaps, n) flat; last (n): |term of degree ORDER| of each state; known
    (gaps, ORDER+1): |coefficients| of what is read; eta (gaps, ORDER+TAIL+1) ≥ |those of η|."""
    n, gaps = len(last), len(eta)
    terms, new, source = np.zeros(n), np.zeros(n), np.zeros(ORDER + TAIL + 1)
    for i in range(n):
        terms[i] = last[i]
    read = np.zeros((gaps, ORDER + TAIL + 1))
    for c in range(gaps):
        for j in range(ORDER + 1):
            read[c, j] = known[c, j]
    pushed = np.zeros(gaps)
    term = 1.0
    for j in range(ORDER + TAIL + 1):
        source[j] = term
        term *= rate / (j + 1)
    value, derived, size = 0.0, 0.0, 0.0
    for j in range(ORDER, ORDER + TAIL):
        for c in range(gaps):
            if j > ORDER:
                read[c, j] = source[j]
                for i in range(n):
                    read[c, j] += abs(readers[c * n + i]) * terms[i]
            pushed[c] = eta[c, j]
            for i in range(j + 1):
                pushed[c] += eta[c, i] * read[c, j - i]
        size = 0.0
        for i in range(n):
            new[i] = source[j]
            for k in range(n):
                new[i] += abs(equations[i * (n + gaps) + k]) * terms[k]
            for c in range(gaps):
                new[i] += abs(equations[i * (n + gaps) + n + c]) * pushed[c]
            new[i] *= duration / (j + 1)
            size = max(size, new[i])
        for i in range(n):
            terms[i] = new[i]
        value += size
        derived += (j + 1) * size
    return _closed(value, derived, size, equations, readers, eta, n, duration, rate)


@inner
def _closed(value, derived, size, equations, readers, eta, n, duration, rate):
    """The same with all that comes behind the last term (a geometric series), or infinity where the terms do
    not fall fast enough yet: more cells are needed."""
    gaps, last, ratio = len(eta), ORDER + TAIL, 0.0
    for i in range(n):
        row = 1.0
        for k in range(n):
            row += abs(equations[i * (n + gaps) + k])
        for c in range(gaps):
            through = 0.0
            for k in range(n):
                through += abs(readers[c * n + k])
            total = 0.0
            for k in range(last + 1):
                total += eta[c, k]
            row += abs(equations[i * (n + gaps) + n + c]) * through * total
        ratio = max(ratio, row)
    # two steps of the recurrence shrink by at least a half: positions and speeds may differ in size
    if not (duration * ratio / last) * (duration / last) <= 0.25 or not rate / last <= 0.5:
        return np.inf, np.inf
    return value + 4.0 * size * max(1.0, duration * ratio / last), derived + 8.0 * last * size * max(
        1.0, duration * ratio / last
    )


@allocating
def _eta_bounds(shape: Shape, memory, active, sides, width):
    """(gaps, ORDER+TAIL+1): bounds on the Taylor coefficients of the stiffness that acts in this region."""
    out, series = np.zeros((shape.clearances, ORDER + TAIL + 1)), 2 * shape.harmonics + 1
    for c in range(shape.clearances):
        if active[c] == 0:
            continue
        at = shape.stiffness + (2 * c + (0 if sides[c] == 0 else 1)) * series
        out[c, 0] = abs(memory[at])
        for h in range(1, shape.harmonics + 1):
            term = np.sqrt(memory[at + 2 * h - 1] ** 2 + memory[at + 2 * h] ** 2)
            for j in range(ORDER + TAIL + 1):
                out[c, j] += term
                term *= h * width / (j + 1)
    return out


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


@kernel(
    types.UniTuple(float64, 2)(
        SHAPE, MUTABLE, int64, MATRIX, MATRIX, MATRIX, MATRIX, INTS, TABLE, CUBE, types.Array(float64, 4, "C")
    ),
    allocates=True,
)
def respond(shape: Shape, memory, at, matrix, readers, actors, centres, sides, units, ends, gaps):
    """Fills the columns of unit starts of `step`, `gap` and `pull` in the slot at ``at``, and the unit
    responses ends (cells, u, n), gaps (cells, clearances, u, TERMS); returns the Taylor remainders of a unit
    column (of its states; with every term times its order), or infinity.

    matrix (n, n) with its damping; readers, actors, centres (clearances, n): h, g, c with h_j·c_k = 1 for j = k,
    else 0; sides (clearances): `PLUS`, `FREE`
    or `MINUS`; units (u, 3): kind, clearance or state, slot of the series."""
    n, count, lanes = shape.n, shape.clearances, _padded(shape.n + len(units))
    across = _padded(n)
    duration, width = memory[shape.scalars + 1], memory[shape.scalars + 2]
    forward, backward = np.zeros(n * (n + count)), np.zeros(n * (n + count))
    h, g, active = np.zeros(count * n), np.zeros(count * n), np.zeros(count, np.int64)
    for i in range(n):
        for k in range(n):
            forward[i * (n + count) + k] = matrix[i, k]
            backward[i * (n + count) + k] = matrix[k, i]
        for c in range(count):
            forward[i * (n + count) + n + c] = actors[c, i]
            backward[i * (n + count) + n + c] = readers[c, i]
            h[c * n + i], g[c * n + i] = readers[c, i], actors[c, i]
    for c in range(count):
        active[c] = 0 if sides[c] == FREE else 1
    bounds = _eta_bounds(shape, memory, active, sides, width)
    eta, sources = np.zeros(count * TERMS), np.zeros(max(1, len(units)) * TERMS)
    highest = 0
    for u in range(len(units)):
        highest = max(highest, (units[u, 2] + 1) // 2)
    one = np.zeros(2 * highest + 1)
    rows = n + count
    z, new, total = np.zeros(rows * lanes), np.zeros(rows * lanes), np.zeros(n * lanes)
    x, last, read = np.zeros(count * (ORDER + 1) * lanes), np.zeros(n), np.zeros((count, ORDER + 1))
    w, wnew, wtotal = np.zeros(rows * across), np.zeros(rows * across), np.zeros(n * across)
    y, wlast, wread = np.zeros(count * (ORDER + 1) * across), np.zeros(n), np.zeros((count, ORDER + 1))
    none = np.zeros((0, 3), np.int64)
    for cell in range(shape.cells):
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
        _recurrence(
            n, count, lanes, forward, h, active, eta, duration, units, sources, z, new, total, x, last, read
        )
        _keep_forward(shape, memory, at, cell, lanes, total, x, ends, gaps)
        _start(n, across, none, centres, w, wtotal)
        fill(wnew, 0.0)
        _recurrence(
            n,
            count,
            across,
            backward,
            g,
            active,
            eta,
            -duration,
            none,
            sources,
            w,
            wnew,
            wtotal,
            y,
            wlast,
            wread,
        )
        for c in range(count):
            for j in range(ORDER + 1):
                place = at + shape.pull + ((cell * count + c) * (ORDER + 1) + j) * shape.p
                for i in range(n):
                    memory[place + 1 + i] = y[(c * (ORDER + 1) + j) * across + i]
    value, derived = _majorant(forward, h, last, read, bounds, duration, highest * width)
    back, _ = _majorant(backward, g, wlast, wread, bounds, duration, 0.0)
    if not back <= np.inf:
        return np.inf, np.inf
    return max(value, back), derived


@inner
def _watch(shape: Shape, memory, at, cell, c, column, sides, rules, check, watched, out):
    """Bernstein coefficients of degree CHECK of what is watched of clearance c (X, or with the rule
    `no-tension` in contact Φ), a bound on the rest, and one on the error of X, for one column of one cell."""
    n, count = shape.n, shape.clearances
    x = at + shape.gap + ((cell * count + c) * (1 + n) + column) * TERMS
    bulk = 0.0
    for j in range(ORDER + 1):
        watched[j] = memory[x + j]
        bulk += abs(memory[x + j])
    row = at + shape.rest + (cell * count + c) * shape.p + column
    tails = at + shape.tail + 4 * c
    own = 0 if column > 0 else 1
    tail, size = memory[tails + own], bulk
    memory[at + shape.bound + (cell * count + c) * shape.p + column] = tail + ROUNDING * bulk
    if rules[c] == NO_TENSION and sides[c] != FREE:
        side = 0 if sides[c] == 0 else 1
        eta = shape.eta + ((cell * count + c) * 2 + side) * TERMS
        rate = memory[shape.gaps + 4 * c + 2 + side] / memory[shape.scalars + 1]
        stiff = 0.0
        for j in range(ORDER + 1):
            stiff += abs(memory[eta + j])
        size = stiff * size + rate * ORDER * bulk
        tail = stiff * tail + rate * memory[tails + 2 + own]
        pressing(memory, eta, memory, x, memory[x], rate, watched, TERMS, 0)
    rest = tail
    for j in range(CHECK + 1, ORDER + 1):
        rest += abs(watched[j])
    linear(check, 0, 8, 8, CHECK + 1, watched, 0, out, 0)
    place = at + shape.step + (cell * (1 + n) + column) * shape.rows + shape.p + 8 * c
    for i in range(CHECK + 1):
        memory[place + i] = out[i]
    memory[row] = rest + ROUNDING * size


@kernel(
    types.void(
        SHAPE, MUTABLE, int64, MUTABLE, CUBE, types.Array(float64, 4, "C"), INTS, INTS, MUTABLE, types.boolean
    ),
    allocates=True,
)
def assemble(shape: Shape, memory, at, amplitudes, ends, gaps, sides, rules, check, all_columns):
    """Sums unit responses to the constant columns of the slot at ``at``, and writes for them (or for all
    columns) the Bernstein coefficients of what is watched, with their bounds.

    amplitudes (u); check (64): Taylor to Bernstein of degree CHECK, by columns."""
    n, count, cells = shape.n, shape.clearances, shape.cells
    watched, out = np.zeros(3 * TERMS), np.zeros(8)
    for cell in range(cells):
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
                _watch(shape, memory, at, cell, c, column, sides, rules, check, watched, out)


@kernel(types.void(SHAPE, MUTABLE, int64, INTS), allocates=True)
def laps(shape: Shape, memory, at, sides):
    """Writes what proves a whole base period to be clear at once: the map over it, a motion in the region that
    (where it is stable) repeats itself, how far that one stays from its limits, and how far a unit of each
    state can move another one from it."""
    n, p, count, rows = shape.n, shape.p, shape.clearances, shape.rows
    columns, out = np.zeros((1 + n) * p), np.zeros(rows)
    swing = np.zeros(count * p)
    for k in range(1 + n):
        columns[k * p + k] = 1.0
    for cell in range(shape.cells):
        step = at + shape.step + cell * (1 + n) * rows
        for k in range(1 + n):
            linear(memory, step, rows, rows, 1 + n, columns, k * p, out, 0)
            for c in range(count):
                rest = weigh(memory, at + shape.rest + (cell * count + c) * p, p, columns, k * p)
                swing[c * p + k] = max(swing[c * p + k], peak(out, p + 8 * c, 8) + rest)
            move(out, 0, columns, k * p, p)
    move(columns, 0, memory, at + shape.lap, (1 + n) * p)
    twice = np.zeros((1 + n) * p)
    for _ in range(DOUBLINGS):
        for k in range(1 + n):
            linear(columns, 0, p, p, 1 + n, columns, k * p, twice, k * p)
        columns, twice = twice, columns
    u = np.zeros(p)
    move(columns, 0, u, 0, p)
    move(u, 0, memory, at + shape.centred, p)
    for c in range(count):
        swing[c * p] = 0.0
        memory[at + shape.margin + 2 * c], memory[at + shape.margin + 2 * c + 1] = np.inf, np.inf
    move(swing, 0, memory, at + shape.swing, count * p)
    for cell in range(shape.cells):
        step = at + shape.step + cell * (1 + n) * rows
        linear(memory, step, rows, rows, 1 + n, u, 0, out, 0)
        for c in range(count):
            rest = weigh(memory, at + shape.rest + (cell * count + c) * p, p, u, 0)
            lower = -memory[shape.gaps + 4 * c + 1] if sides[c] == FREE else 0.0
            upper = memory[shape.gaps + 4 * c] if sides[c] == FREE else 0.0
            margin = at + shape.margin + 2 * c
            below = (least(out, p + 8 * c) - rest - lower) * (1.0 - 1e-9)
            above = (upper - greatest(out, p + 8 * c) - rest) * (1.0 - 1e-9)
            memory[margin] = below if not below >= memory[margin] else memory[margin]
            memory[margin + 1] = above if not above >= memory[margin + 1] else memory[margin + 1]
        move(out, 0, u, 0, p)


@kernel(float64(MATRIX, types.int64), allocates=True)
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
