"""The march through cells: a whole cell by one product where no contact is possible, event by event where it is.

A position is counted in cells from phase zero of the base period: an integer cell and a local time s in [0,
1]. The state of a walk is that at the beginning of its cell, under the flow of its present region: where a
crossing has happened in the cell this is no state the motion was in, but the one that leads to it
(`_switch`)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearlash._kernel import inner

from ._exits import NONE
from ._expand import carry_inside, expand
from ._surfaces import next_exit
from ._switch import region_code, side_of, switch_state, switch_tangent
from ._tables import FREE, MINUS, NO_TENSION, ORDER, OVER_MINUS, OVER_PLUS, PLUS, TERMS, Array, Shape
from ._vector import linear, weigh

OK, TOO_MANY, DIVERGED, WRONG_SIDE, NEED_REGION = 0, 1, 2, 3, 4
ENGAGE_PLUS, ENGAGE_MINUS, RELEASE_PLUS, RELEASE_MINUS = 0, 1, 2, 3  # of each clearance; last: undecided
EVENTS_PER_CELL = 4096
HUGE = 1e200
NEEDED, FRESH = 4, 5  # places in `position`


class Motion(NamedTuple):
    """What moves, and work space; all arrays are changed in place."""

    u: Array  # (p): (1, z - c) at the beginning of the cell, under the flow of the present region
    tangents: Array  # (m·p): (0, v) likewise
    modes: np.ndarray  # (clearances) int
    position: Array  # (6): cell, s; cell and s of the end of the stretch; number of a region that is needed; 1
    # where the motion has only just been put there
    work: Array  # see `_work`
    moved: Array  # (rows or p)
    zc: Array  # ((ORDER+1)·p)
    series: Array  # see `_expand`
    factors: Array  # (n + clearances)
    sides: np.ndarray  # (clearances) int
    on: np.ndarray  # (clearances) int: the boundary ±1 that was crossed at the present position, or 0


class Record(NamedTuple):
    """What a trace keeps: every piece as a polynomial, every contact event."""

    used: np.ndarray  # (2) int: pieces, events; the first is -1 where nothing is kept
    piece: Array  # (pieces, 2 + clearances): position of its start, length in cells, modes
    poly: Array  # (pieces, ORDER+1, n)
    event: Array  # (events, 4): position, clearance, boundary ±1, engaging 1 or 0
    state: Array  # (events, n)


@inner
def slot_place(shape: Shape, slot_of, modes):
    """Where the slot of the present region begins, or -1 where it is not built yet."""
    slot = slot_of[region_code(modes)]
    return shape.slots + slot * shape.slot if slot >= 0 else -1


@inner
def _clear(shape: Shape, memory, slot, cell, c, mode, u, moved):
    """Whether clearance c is proved to keep its mode through the whole cell that starts at u."""
    place = slot + shape.rest + (cell * shape.clearances + c) * shape.p
    rest = weigh(memory, place, shape.p, u, 0)
    first = shape.p + 8 * c
    low01, low23 = min(moved[first], moved[first + 1]), min(moved[first + 2], moved[first + 3])
    low45, low67 = min(moved[first + 4], moved[first + 5]), min(moved[first + 6], moved[first + 7])
    high01, high23 = max(moved[first], moved[first + 1]), max(moved[first + 2], moved[first + 3])
    high45, high67 = max(moved[first + 4], moved[first + 5]), max(moved[first + 6], moved[first + 7])
    lowest, highest = min(min(low01, low23), min(low45, low67)), max(max(high01, high23), max(high45, high67))
    plus, minus = memory[shape.gaps + 4 * c], -memory[shape.gaps + 4 * c + 1]
    if mode == FREE:
        return lowest - rest > minus and highest + rest < plus
    if mode == PLUS:
        return lowest - rest > 0.0
    if mode == MINUS:
        return highest + rest < 0.0
    return False


@inner
def _bounded(u, p):
    size = 0.0
    for i in range(p):
        size += abs(u[i])
    return size < HUGE


@inner
def walk(shape: Shape, memory, slot_of, rules, motion, m, stop_cell, stop_s, hold, counts, record):
    """Carries a motion with m tangents to (stop_cell, stop_s); returns an outcome. With `NEED_REGION` it stands
    where it was when it reached a region without tables, and can go on once they are there.

    hold (4): clearance, boundary that is not crossed between two positions (boundary 0: none). counts
    (4·clearances + 1) int is added to."""
    u, tangents, modes, moved = motion.u, motion.tangents, motion.modes, motion.moved
    cells, n, p, rows, count = shape.cells, shape.n, shape.p, shape.rows, shape.clearances
    keep = record.used[0] >= 0
    cell, s = int(motion.position[0]), motion.position[1]
    slot, plain = slot_place(shape, slot_of, modes), False
    while cell < stop_cell or (cell == stop_cell and s < stop_s):
        k = cell % cells
        end = 1.0 if cell < stop_cell else stop_s
        holding = hold[1] != 0.0 and hold[2] < cell + 1.0 and hold[3] > cell
        if s == 0.0 and end == 1.0 and not keep and not holding:
            step = slot + shape.step + k * (1 + n) * rows
            linear(memory, step, rows, rows, 1 + n, u, 0, moved, 0)
            clear = True
            for c in range(count):
                clear = clear and _clear(shape, memory, slot, k, c, modes[c], u, moved)
            if clear:
                if not plain:
                    plain = True
                    motion.position[FRESH] = 0.0
                    for c in range(count):
                        motion.on[c] = 0
                for i in range(p):
                    u[i] = moved[i]
                for v in range(m):
                    linear(memory, step, rows, p, 1 + n, tangents, v * p, moved, 0)
                    for i in range(p):
                        tangents[v * p + i] = moved[i]
                cell += 1
                continue
        if not _bounded(u, p):  # no polynomial of infinities can be subdivided to an end
            return DIVERGED
        motion.position[0], motion.position[1] = cell, s
        outcome = _by_pieces(shape, memory, slot_of, rules, motion, m, k, end, hold, counts, record)
        if outcome != OK:
            return outcome
        slot = slot_place(shape, slot_of, modes)
        s = motion.position[1]
        if end == 1.0:
            step = slot + shape.step + k * (1 + n) * rows
            linear(memory, step, rows, p, 1 + n, u, 0, moved, 0)
            for i in range(p):
                u[i] = moved[i]
            for v in range(m):
                linear(memory, step, rows, p, 1 + n, tangents, v * p, moved, 0)
                for i in range(p):
                    tangents[v * p + i] = moved[i]
            cell += 1
            s, plain = 0.0, False
            for c in range(count):
                motion.on[c] = 0
    motion.position[0], motion.position[1] = cell, s
    return OK if _bounded(u, p) else DIVERGED


@inner
def _by_pieces(shape: Shape, memory, slot_of, rules, motion, m, k, end, hold, counts, record):
    """One cell from motion.position to local time ``end``, event by event."""
    events = 0
    cell = motion.position[0]
    while motion.position[1] < end:
        s = motion.position[1]
        held, stop = _held(hold, cell, s, end)
        slot = slot_place(shape, slot_of, motion.modes)
        at, which, boundary, behind, undecided = _first(
            shape, memory, slot, k, rules, motion, s, stop, int(hold[0]), held
        )
        if at == NONE:
            if undecided:
                counts[4 * shape.clearances] += 1
            if not _keep_piece(shape, memory, slot, motion, k, s, stop, record):
                return TOO_MANY
            _advance(motion, stop)
            continue
        outcome = _cross(
            shape, memory, slot_of, slot, rules, motion, m, k, at, which, boundary, behind,
            motion.position[FRESH] != 0.0 and at == s, undecided, counts, record,
        )  # fmt: skip
        if outcome != OK:
            return outcome
        _advance(motion, at)
        motion.on[which] = boundary
        events += 1
        if events > EVENTS_PER_CELL:
            return TOO_MANY
    return OK


@inner
def _advance(motion, s):
    """To another place in the cell: what was crossed before is behind."""
    if s != motion.position[1]:
        for c in range(len(motion.on)):
            motion.on[c] = 0
    motion.position[1], motion.position[FRESH] = s, 0.0


@inner
def _held(hold, cell, s, end):
    """The boundary that is held at a position, and how far that stays so."""
    held, stop = 0, end
    if hold[1] != 0.0:
        if cell + s >= hold[2] and cell + s < hold[3]:
            held = int(hold[1])
            if hold[3] < cell + stop:
                stop = hold[3] - cell
        elif hold[2] > cell + s and hold[2] < cell + stop:
            stop = hold[2] - cell
    return held, stop


@inner
def _first(shape: Shape, memory, slot, k, rules, motion, s, stop, held_clearance, held):
    """First exit of any clearance in [s, stop]: (time or NONE, clearance, boundary, mode behind, undecided)."""
    best, which, through, behind, undecided = NONE, 0, 0, 0, False
    for c in range(shape.clearances):
        at, boundary, target, open_case = next_exit(
            shape, memory, slot, k, c, motion.modes[c], rules[c], motion.u, s, stop,
            motion.on[c], held if c == held_clearance else 0, motion.work,
        )  # fmt: skip
        undecided = undecided or open_case
        if at < best:
            best, which, through, behind = at, c, boundary, target
    return best, which, through, behind, undecided


@inner
def _cross(
    shape: Shape, memory, slot_of, slot, rules, motion, m, k, at, which, boundary, behind, silent, undecided,
    counts, record,
):  # fmt: skip
    """Carries a motion over one crossing in cell k, counts and records it (unless ``silent``)."""
    mode, count = motion.modes[which], shape.clearances
    before, after = side_of(mode), side_of(behind)
    if before != after:
        motion.modes[which] = behind
        target = slot_place(shape, slot_of, motion.modes)
        motion.position[NEEDED] = region_code(motion.modes)
        motion.modes[which] = mode
        if target < 0:
            return NEED_REGION
    if undecided:
        counts[4 * count] += 1
    if not _keep_piece(shape, memory, slot, motion, k, motion.position[1], at, record):
        return TOO_MANY
    if before == after:  # out of the overlap of `no-tension`: nothing presses on either side
        motion.modes[which] = behind
        return OK
    engaging = after != FREE
    overlapping = mode == OVER_PLUS or mode == OVER_MINUS or behind == OVER_PLUS or behind == OVER_MINUS
    if not silent:
        counts[4 * which + (0 if engaging else 2) + (0 if boundary > 0 else 1)] += 1
        if not _keep_event(shape, memory, slot, motion, k, at, which, boundary, engaging, record):
            return TOO_MANY
    sign = 1.0 if engaging else -1.0
    p, work = shape.p, motion.work
    target_place = target
    for v in range(m):
        tangent = motion.tangents[v * p : (v + 1) * p]
        switch_tangent(
            shape, memory, slot, target_place, k, which, boundary, sign, rules[which], overlapping, at,
            tangent, work, motion.moved,
        )  # fmt: skip
    switch_state(
        shape, memory, slot, target_place, k, which, boundary, sign, rules[which], at, motion.u, work, motion.moved
    )
    motion.modes[which] = behind
    return OK


@inner
def _keep_event(shape: Shape, memory, slot, motion, k, at, which, boundary, engaging, record):
    if record.used[0] < 0:
        return True
    i = record.used[1]
    if i >= len(record.event):
        return False
    record.event[i, 0] = motion.position[0] + at
    record.event[i, 1] = which
    record.event[i, 2] = boundary
    record.event[i, 3] = 1.0 if engaging else 0.0
    sides_of(motion)
    carry_inside(
        shape, memory, slot, motion.sides, k, 0.0, at, motion.u, motion.zc, motion.series, motion.factors,
        motion.moved,
    )  # fmt: skip
    for v in range(shape.n):
        record.state[i, v] = motion.moved[1 + v] + memory[slot + shape.centre + 1 + v]
    record.used[1] = i + 1
    return True


@inner
def _keep_piece(shape: Shape, memory, slot, motion, k, start, end, record):
    """Stores [start, end] of cell k as a polynomial in local time of its own (0 to 1 over the piece)."""
    i = record.used[0]
    if i < 0 or end <= start:
        return True
    if i >= len(record.piece):
        return False
    sides_of(motion)
    carry_inside(
        shape, memory, slot, motion.sides, k, 0.0, start, motion.u, motion.zc, motion.series, motion.factors,
        motion.moved,
    )  # fmt: skip
    theta, duration = (k + start) * memory[shape.scalars + 2], (end - start) * memory[shape.scalars + 1]
    expand(
        shape, memory, slot, motion.sides, theta, duration, motion.moved, motion.zc, motion.series,
        motion.factors,
    )  # fmt: skip
    record.piece[i, 0], record.piece[i, 1] = motion.position[0] + start, end - start
    for c in range(shape.clearances):
        record.piece[i, 2 + c] = motion.modes[c]
    for j in range(ORDER + 1):
        for v in range(shape.n):
            record.poly[i, j, v] = motion.zc[j * shape.p + 1 + v]
    for v in range(shape.n):
        record.poly[i, 0, v] += memory[slot + shape.centre + 1 + v]
    record.used[0] = i + 1
    return True


@inner
def sides_of(motion):
    """Fills `sides` from the modes."""
    for c in range(len(motion.modes)):
        motion.sides[c] = side_of(motion.modes[c])


@inner
def arrivals(shape: Shape, memory, slot_of, rules, motion, m, hold, counts, record):
    """A span includes its end: crossings just there are this span's, and the next starts behind them."""
    cell, s = motion.position[0], motion.position[1]
    k = int(cell) % shape.cells
    held, _ = _held(hold, cell, s, s)
    for c in range(shape.clearances):
        slot = slot_place(shape, slot_of, motion.modes)
        if not _near(shape, memory, slot, k, c, motion.modes[c], rules[c], motion.u, s):
            continue
        at, boundary, behind, _ = next_exit(
            shape, memory, slot, k, c, motion.modes[c], rules[c], motion.u, s, s,
            motion.on[c], held if c == int(hold[0]) else 0, motion.work,
        )  # fmt: skip
        if at == NONE:
            continue
        outcome = _cross(
            shape, memory, slot_of, slot, rules, motion, m, k, at, c, boundary, behind, False, False, counts,
            record,
        )  # fmt: skip
        if outcome != OK:
            return outcome
        motion.on[c] = boundary
    return OK


@inner
def _near(shape: Shape, memory, slot, k, c, mode, rule, u, s):
    """Whether it is worth a closer look at the end of a span; most states are nowhere near a boundary."""
    if s != 0.0 or (rule == NO_TENSION and mode != FREE):
        return True
    place = slot + shape.gap + (k * shape.clearances + c) * (1 + shape.n) * TERMS
    x, size = 0.0, 0.0
    for i in range(1 + shape.n):
        term = memory[place + i * TERMS] * u[i]
        x += term
        size += abs(term)
    plus, minus = memory[shape.gaps + 4 * c], memory[shape.gaps + 4 * c + 1]
    if mode == PLUS or mode == MINUS:
        return abs(x) <= 1e-9 * size
    return abs(x - plus) <= 1e-9 * (size + plus) or abs(x + minus) <= 1e-9 * (size + minus)
