"""Entry points of the march: strobes and counts, tangents, traces; extrema."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearlash._kernel.jit import float64, inlined, inner, int64, kernel

from ._expand import carry_inside
from ._motion import FRESH, NEED_REGION, NEEDED, OK, MotionState, sides_of, slot_place
from ._record import Record
from ._root_isolation import all_roots, ones
from ._series import polynomial
from ._surfaces import first_mode
from ._switch import region_code
from ._tables import (
    CUBE,
    CUBE_OF_INTS,
    FLOATS,
    INTS,
    MATRIX,
    MUTABLE,
    ORDER,
    SIZES,
    TERMS,
    Array,
    Shape,
    aligned,
    aligned_ints,
    shape_of,
)
from ._vector import add
from ._walk import walk
from ._workspace import DEPTH, GAPS


class Scratch(NamedTuple):
    """Work space of one motion: of its `MotionState`, and for tangents. It comes to kernels as one array of
    numbers and one of whole numbers, as each argument of an entry point takes its time in every call."""

    position: Array
    work: Array
    moved: Array
    zc: Array
    series: Array
    origin: Array
    factors: Array
    progress: np.ndarray
    modes: np.ndarray
    on: np.ndarray
    sides: np.ndarray


def split(shape: Shape, numbers, ints):
    """The parts of both arrays. All but the last of the numbers have whole blocks of eight."""
    n, p, j = shape.n, shape.p, shape.clearances
    work = 8 + GAPS + j * TERMS + p  # where each part ends
    moved = work + shape.rows + j * TERMS
    zc = moved + (ORDER + 1) * p
    series = zc + (4 * j + n) * TERMS
    origin = series + p
    return Scratch(
        numbers[0:6],
        numbers[8:work],
        numbers[work:moved],
        numbers[moved:zc],
        numbers[zc:series],
        numbers[series:origin],
        numbers[origin : origin + n + j],
        ints[0:3],
        ints[3 : 3 + j],
        ints[3 + j : 3 + 2 * j],
        ints[3 + 2 * j : 3 + 3 * j],
    )


scratch_in = inlined(split)


def scratch(shape: Shape) -> tuple[Array, Array]:
    """Numbers and whole numbers, for motions of systems of this shape."""
    n, p, j = shape.n, shape.p, shape.clearances
    before = 8 + GAPS + j * TERMS + p + shape.rows + j * TERMS + (ORDER + 1) * p + (4 * j + n) * TERMS + p
    (numbers,), (ints,) = aligned(before + n + j), aligned_ints(3 + 3 * j)
    return numbers, ints


STARTED, STRETCH, MOTION = 0, 1, 2  # in `progress`: how far a call came that ran into an unbuilt region


@inner
def _orthonormalise(tangents, m, p, sums, first):
    """Modified Gram-Schmidt, twice, on the rows of `tangents`; adds the logarithms of their lengths to
    `sums` from a place on."""
    for i in range(m):
        for _twice in range(2):
            for j in range(i):
                dot = 0.0
                for k in range(1, p):
                    dot += tangents[i * p + k] * tangents[j * p + k]
                for k in range(1, p):
                    tangents[i * p + k] -= dot * tangents[j * p + k]
        size = 0.0
        for k in range(1, p):
            size += tangents[i * p + k] ** 2
        size = np.sqrt(size)
        sums[first + i] += np.log(size)
        for k in range(1, p):
            tangents[i * p + k] /= size


@inner
def _inside_to(shape: Shape, memory, slot, motion, start, end, vector):
    """moved (p) ← what the present flow makes of a vector (p) from ``start`` to ``end`` of the cell."""
    sides_of(motion)
    k = int(motion.position[0]) % shape.cells
    carry_inside(
        shape, memory, slot, motion.sides, k, start, end, vector, motion.zc, motion.series, motion.factors,
        motion.moved,
    )  # fmt: skip


@inner
def _inside(shape: Shape, memory, slot, motion, start, end, vector):
    """The same in place."""
    _inside_to(shape, memory, slot, motion, start, end, vector)
    for i in range(shape.p):
        vector[i] = motion.moved[i]


@inner
def _tangents_inside(shape: Shape, memory, slot, motion, m, start, end, origin):
    """The same for tangents: differences of the affine flow, which the state's own part cancels in."""
    p = shape.p
    if start == end or m == 0:
        return
    for i in range(p):
        origin[i] = 0.0
    origin[0] = 1.0
    _inside(shape, memory, slot, motion, start, end, origin)
    for v in range(m):
        tangent = motion.tangents[v * p : (v + 1) * p]
        tangent[0] = 1.0
        _inside(shape, memory, slot, motion, start, end, tangent)
        for i in range(p):
            tangent[i] -= origin[i]
        tangent[0] = 0.0


@inner
def _ahead(cell, s, length):
    stop_cell = np.floor(cell + s + length)
    return stop_cell, (s + length) - (stop_cell - cell)


@inlined
def _strobe(shape: Shape, memory, slot_of, motion, row, strobes):
    """The state that the motion is in now; u itself stays the virtual start of its cell."""
    slot = slot_place(shape, slot_of, motion.modes)
    centre = memory[slot + shape.centre : slot + shape.centre + shape.p]
    if motion.position[1] == 0.0:
        _from_centre(shape, motion.u, centre, strobes[row])
    else:
        _inside_to(shape, memory, slot, motion, 0.0, motion.position[1], motion.u)
        _from_centre(shape, motion.moved, centre, strobes[row])


@inlined
def _from_centre(shape: Shape, values, centre, state):
    """A state of the system. (What is read begins with the array: an index that may be negative, for all that
    the compiler knows, makes of eight numbers eight.)"""
    for i in range(shape.n):
        state[i] = values[1 + i] + centre[1 + i]


@inner
def begin(shape: Shape, memory, slot_of, rules, motion, m, start, length, strobes, origin):
    """Puts a motion at its start, or returns `NEED_REGION`."""
    u, modes, position = motion.u, motion.modes, motion.position
    cell = int(np.floor(start))
    s = start - cell
    for c in range(shape.clearances):
        modes[c] = first_mode(shape, memory, c, rules[c], (cell + s) * memory[shape.scalars + 2], u)
        motion.on[c] = 0
    slot = slot_place(shape, slot_of, modes)
    if slot < 0:
        position[NEEDED] = region_code(modes)
        return NEED_REGION
    for i in range(shape.n):
        strobes[0, i] = u[1 + i]
    position[0], position[1], position[FRESH] = cell, s, 1.0
    add(-1.0, memory, slot + shape.centre, u, 0, shape.p)
    _inside(shape, memory, slot, motion, s, 0.0, u)
    _tangents_inside(shape, memory, slot, motion, m, s, 0.0, origin)
    position[2], position[3] = _ahead(cell, s, length)
    return OK


@inner
def _carry(
    shape: Shape, memory, slot_of, rules, motion, m, length, hold, strobes, counts, sums, progress, record,
    origin,
):  # fmt: skip
    """Carries a motion over the stretches that are left of it."""
    position, n = motion.position, shape.n
    while progress[STRETCH] < len(counts):
        stretch = progress[STRETCH]
        stop_cell, stop_s = int(position[2]), position[3]
        outcome = walk(
            shape, memory, slot_of, rules, motion, m, stop_cell, stop_s, hold, counts[stretch], record
        )
        if outcome == NEED_REGION:
            return outcome
        row = stretch + 1
        _strobe(shape, memory, slot_of, motion, row, strobes)
        if outcome != OK:
            for i in range(n):
                motion.u[1 + i] = strobes[row, i]
            for later in range(row + 1, len(counts) + 1):
                for i in range(n):
                    strobes[later, i] = np.nan
            return outcome
        if len(sums) > 0:
            _orthonormalise(motion.tangents, m, shape.p, sums, stretch * m)
        if record.used[0] < 0:
            position[0] = stop_cell % shape.cells
        position[2], position[3] = _ahead(int(position[0]), position[1], length)
        progress[STRETCH] = stretch + 1
    slot = slot_place(shape, slot_of, motion.modes)
    _tangents_inside(shape, memory, slot, motion, m, 0.0, position[1], origin)
    for i in range(n):
        motion.u[1 + i] = strobes[len(counts), i]
    return OK


@kernel(
    int64(
        SIZES, FLOATS, INTS, INTS, MUTABLE, MUTABLE, float64, float64, MUTABLE, CUBE, CUBE_OF_INTS, MUTABLE,
        INTS, INTS, MATRIX, CUBE, MATRIX, MATRIX, MUTABLE, INTS,
    ),
    alone=True,
)  # fmt: skip
def run(
    sizes, memory, slot_of, rules, u, tangents, start, length, hold, strobes, counts, sums, outcomes, used,
    piece, poly, event, state, numbers, ints,
):  # fmt: skip
    """The one march: carries motions, one after the other, in place over stretches of `length` cells: of each
    u (p) = (1, z) and tangents (m·p) = (0, v), side by side in their arrays.

    strobes (motions, stretches+1, n) receives the states at every start and at the end (NaN where a motion
    does not come), counts (motions, stretches, 4·clearances+1), zero at first, what happened in each stretch,
    outcomes (motions) how each ended. With sums (stretches·m), of one motion only, tangents are
    orthonormalised after each stretch, and the logarithms of their lengths added there. used[0] = -1 records
    nothing, else piece, poly, event and state are filled (`Record`), of one motion. numbers and ints are work
    space (`scratch`); its `progress`, zero at first, lets a call that returned `NEED_REGION` go on once that
    region is built. There is one entry point, as each variant would have to be compiled for itself."""
    shape = shape_of(sizes)
    p, motions = shape.p, len(counts)
    m = len(tangents) // (p * motions)
    room = scratch_in(shape, numbers, ints)
    progress = room.progress
    ones(room.work)
    record = Record(used, piece, poly, event, state)
    while progress[MOTION] < motions:
        which = progress[MOTION]
        motion = MotionState(
            u[which * p : (which + 1) * p], tangents[which * m * p : (which + 1) * m * p], room.modes,
            room.position, room.work, room.moved, room.zc, room.series, room.factors, room.sides, room.on,
        )  # fmt: skip
        if progress[STARTED] == 0:
            outcome = begin(
                shape, memory, slot_of, rules, motion, m, start, length, strobes[which], room.origin
            )
            if outcome != OK:
                return outcome
            progress[STARTED], progress[STRETCH] = 1, 0
        outcome = _carry(
            shape, memory, slot_of, rules, motion, m, length, hold, strobes[which], counts[which], sums,
            progress, record, room.origin,
        )  # fmt: skip
        if outcome == NEED_REGION:
            return outcome
        outcomes[which] = outcome
        progress[MOTION], progress[STARTED] = which + 1, 0
    return OK


@inner
def _second(c, at, s):
    value = 0.0
    for j in range(ORDER, 1, -1):
        value = value * s + j * (j - 1) * c[at + j]
    return value


@kernel(int64(MATRIX, MUTABLE, FLOATS, int64, MATRIX), allocates=True)
def extrema(piece, gap, basis, table, found):
    """Simple zeros of X' over all pieces.

    gap (pieces·TERMS): Taylor coefficients of X per piece in its own local time; basis from place ``table``:
    Taylor to Bernstein of degree ORDER-1. found (m, 4) receives position, X, second derivative in local time,
    piece index."""
    slope, roots = np.zeros(TERMS), np.empty(ORDER)
    stack, limits = np.empty((DEPTH + 2) * TERMS), np.empty(2 * (DEPTH + 2))
    count = 0
    for p in range(len(piece)):
        for j in range(ORDER):
            slope[j] = (j + 1) * gap[p * TERMS + j + 1]
        number = all_roots(slope, 0, ORDER - 1, basis, table, stack, limits, roots)
        for r in range(number):
            if count >= len(found):
                return count
            s = roots[r]
            found[count, 0] = piece[p, 0] + s * piece[p, 1]
            found[count, 1] = polynomial(gap, p * TERMS, s)
            found[count, 2] = _second(gap, p * TERMS, s)
            found[count, 3] = p
            count += 1
    return count
