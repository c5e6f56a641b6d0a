"""The march through cells: a whole cell by one product where no contact is possible, event by event where
it is.

A position is counted in cells from phase zero of the base period: an integer cell and a local time s in [0,
1]. The state of a walk is that at the beginning of its cell, under the flow of its present region: where a
crossing has happened in the cell this is no state the motion was in, but the one that leads to it
(`_switch`)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearlash._kernel import inlined, inner

from ._assemble import fine_coefficients
from ._exits import NONE
from ._expand import carry_inside, expand
from ._glance import CLEAR, UNSURE
from ._surfaces import next_exit, one_crossing, outlook, stays
from ._switch import region_code, side_of, switch_state, switch_tangent
from ._tables import FREE, MINUS, ORDER, OVER_MINUS, OVER_PLUS, PLUS, TERMS, Array, Shape
from ._vector import add, linear, move, weigh

OK, TOO_MANY, DIVERGED, NEED_REGION = 0, 1, 2, 3
EVENTS_PER_CELL = 4096
HUGE = 1e200
APART = 1e-9  # of a cell: crossings that are nearer are taken one by one, in pieces
NEEDED, FRESH = 4, 5  # places in `position`


class Motion(NamedTuple):
    """What moves, and work space; all arrays are changed in place."""

    u: Array  # (p): (1, z - c) at the beginning of the cell, under the flow of the present region
    tangents: Array  # (m·p): (0, v) likewise
    modes: np.ndarray  # (clearances) int
    position: (
        Array  # (6): cell, s; cell and s of the end of the stretch; number of a region that is needed; 1
    )
    # where the motion has only just been put there
    work: Array  # see `_work`
    moved: Array  # (rows + clearances·TERMS)
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


@inlined
def slot_place(shape: Shape, slot_of, modes):
    """Where the slot of the present region begins, or -1 where it is not built yet."""
    slot = slot_of[region_code(modes)]
    return shape.slots + slot * shape.slot if slot >= 0 else -1


@inlined
def _survey(shape: Shape, memory, slot, k, rules, motion, begun):
    """What a cell brings, or what is left of it where it has ``begun``, seen at a glance: nothing (`CLEAR`),
    something of one clearance (a verdict of `glance`, clearance, boundary), or `UNSURE`: of several, or what
    must be looked at in pieces."""
    verdict, which, through = CLEAR, 0, 0
    for c in range(shape.clearances):
        found, boundary = outlook(
            shape, memory, slot, k, c, motion.modes[c], rules[c], motion.on[c], begun, motion.u, motion.moved
        )
        if found != CLEAR:
            if verdict != CLEAR:
                return UNSURE, 0, 0
            verdict, which, through = found, c, boundary
    return verdict, which, through


@inlined
def _look(shape: Shape, memory, slot, k, rules, motion, m, begun):
    """`_survey` of cell k; carries the motion over it where nothing comes."""
    u, moved = motion.u, motion.moved
    fine_coefficients(shape, memory, slot, k, u, 0, moved, shape.rows)
    verdict, which, boundary = _survey(shape, memory, slot, k, rules, motion, begun)
    if verdict == CLEAR:
        step = slot + shape.step + k * (1 + shape.n) * shape.rows
        linear(memory, step, shape.rows, shape.p, 1 + shape.n, u, 0, moved, 0)
        move(moved, 0, u, 0, shape.p)
        if m > 0:
            _tangents_on(shape, memory, step, shape.rows, motion.tangents, m, moved)
        leave_behind(motion)
    return verdict, which, boundary


@inner
def _soonest(shape: Shape, memory, slot, k, rules, motion, s):
    """The first of the crossings of several clearances from s on, where every one of them is certain and no
    other is too near to say which comes first: (time or `NONE`, clearance, boundary)."""
    at, after, which, through = NONE, NONE, 0, 0
    for c in range(shape.clearances):
        verdict, boundary = outlook(
            shape, memory, slot, k, c, motion.modes[c], rules[c], motion.on[c], s > 0.0, motion.u,
            motion.moved,
        )  # fmt: skip
        if verdict == CLEAR:
            continue
        if verdict == UNSURE:
            return NONE, 0, 0
        there = one_crossing(
            shape, memory, slot, k, c, motion.modes[c], boundary, verdict, s, motion.u, motion.moved,
            shape.rows + TERMS * c, motion.work,
        )  # fmt: skip
        if there == NONE:
            return NONE, 0, 0
        if there < at:
            at, after, which, through = there, at, c, boundary
        elif there < after:
            after = there
    return (at, which, through) if after - at > APART else (NONE, 0, 0)


@inner
def bounded(u, p):
    """Whether a state has not grown beyond every bound, nor become NaN."""
    size = 0.0
    for i in range(p):
        size += abs(u[i])
    return size < HUGE


@inlined
def walk(  # noqa: PLR0915 - one loop: cut up, it was slower by a tenth
    shape: Shape, memory, slot_of, rules, motion, m, stop_cell, stop_s, hold, counts, record
):
    """Carries a motion with m tangents to (stop_cell, stop_s), crossings just there included; returns an
    outcome. With `NEED_REGION` it stands where it was when it reached a region without tables, and can go on
    once they are there.

    hold (4): clearance, boundary that is not crossed between two positions (boundary 0: none). counts
    (4·clearances + 1) int is added to: of each clearance engagements at + and -, releases at + and -; last
    what stayed undecided."""
    u, modes, moved = motion.u, motion.modes, motion.moved
    cells, p = shape.cells, shape.p
    keep = record.used[0] >= 0
    cell, s = int(motion.position[0]), motion.position[1]
    slot, proved = slot_place(shape, slot_of, modes), False
    k, whole = cell % cells, not keep and hold[1] == 0.0
    while True:
        arriving = not (cell < stop_cell or (cell == stop_cell and s < stop_s))
        if arriving and proved:
            break  # the last cell was proved to be clear, its end too
        end = s if arriving else (1.0 if cell < stop_cell else stop_s)
        if end == 1.0 and (whole or not (keep or (hold[2] < cell + 1.0 and hold[3] > cell))):
            if s == 0.0:
                left = stop_cell - cell if whole else 1
                passed, k = _over_clear_cells(shape, memory, slot, motion, m, k, left, whole)
                if passed > 0:
                    cell, proved = cell + passed, True
                    leave_behind(motion)
                if passed == left:
                    continue
                verdict, which, boundary = _look(shape, memory, slot, k, rules, motion, m, False)
                if verdict == CLEAR:
                    cell, s, proved = cell + 1, 0.0, True
                    k = k + 1 if k + 1 < cells else 0
                    continue
            else:  # in a place of its own: what is found here is another thing, and so can be foreseen
                verdict, which, boundary = _look(shape, memory, slot, k, rules, motion, m, True)
                if verdict == CLEAR:
                    cell, s, proved = cell + 1, 0.0, True
                    k = k + 1 if k + 1 < cells else 0
                    continue
            at = NONE
            if verdict != UNSURE:
                at = one_crossing(
                    shape, memory, slot, k, which, modes[which], boundary, verdict, s, u, moved,
                    shape.rows + TERMS * which, motion.work,
                )  # fmt: skip
            elif shape.clearances > 1:
                at, which, boundary = _soonest(shape, memory, slot, k, rules, motion, s)
            if at != NONE:
                motion.position[0], motion.position[1] = cell, s
                behind = FREE if modes[which] != FREE else (PLUS if boundary > 0 else MINUS)
                outcome = cross(
                    shape, memory, slot_of, slot, rules, motion, m, k, at, which, boundary, behind,
                    False, False, counts, record,
                )  # fmt: skip
                if outcome != OK:
                    return outcome
                leave_behind(motion)
                motion.on[which], s, proved = boundary, at, False
                slot = slot_place(shape, slot_of, modes)
                continue
        motion.position[0], motion.position[1], proved = cell, s, False
        outcome = in_pieces(shape, memory, slot_of, rules, motion, m, k, end, arriving, hold, counts, record)
        if outcome != OK:
            return outcome
        if arriving:
            break
        slot = slot_place(shape, slot_of, modes)
        s = motion.position[1]
        if end == 1.0:
            cell += 1
            k = k + 1 if k + 1 < cells else 0
    motion.position[0], motion.position[1] = cell, s
    return OK if bounded(u, p) else DIVERGED


@inlined
def _over_clear_cells(shape: Shape, memory, slot, motion, m, k, left, laps):
    """Carries a motion over cells that are proved to be clear, from cell k and ``left`` of them at the most,
    whole base periods at once if it may (``laps``). Returns their number and the cell behind them; of that
    one, if one is left, rough coefficients were not enough."""
    u, moved, cells, passed = motion.u, motion.moved, shape.cells, 0
    while passed < left:
        if k == 0 and laps and passed + cells <= left:
            passed += cells * _over_laps(shape, memory, slot, motion, m, (left - passed) // cells)
            if passed == left:
                break
        step = slot + shape.step + k * (1 + shape.n) * shape.rows
        linear(memory, step, shape.rows, shape.rows, 1 + shape.n, u, 0, moved, 0)
        clear = True
        for c in range(shape.clearances):
            clear = clear and stays(shape, memory, slot, k, c, motion.modes[c], u, moved)
        if not clear:
            break
        move(moved, 0, u, 0, shape.p)
        if m > 0:
            _tangents_on(shape, memory, step, shape.rows, motion.tangents, m, moved)
        passed += 1
        k = k + 1 if k + 1 < cells else 0
    return passed, k


@inner
def _over_laps(shape: Shape, memory, slot, motion, m, most):
    """Carries a motion over whole base periods that are proved to be clear; returns their number."""
    for passed in range(most):
        if not _lap(shape, memory, slot, motion.modes, motion.u, motion.moved):
            return passed
        _leap(shape, memory, slot + shape.lap, shape.p, motion.u, motion.tangents, m, motion.moved)
    return most


@inner
def _leap(shape: Shape, memory, table, stride, u, tangents, m, moved):
    """State and tangents over one cell or lap, by the table that begins at a place."""
    linear(memory, table, stride, shape.p, 1 + shape.n, u, 0, moved, 0)
    move(moved, 0, u, 0, shape.p)
    if m > 0:
        _tangents_on(shape, memory, table, stride, tangents, m, moved)


@inner
def _tangents_on(shape: Shape, memory, table, stride, tangents, m, moved):
    for v in range(m):
        linear(memory, table, stride, shape.p, 1 + shape.n, tangents, v * shape.p, moved, 0)
        move(moved, 0, tangents, v * shape.p, shape.p)


@inlined
def _lap(shape: Shape, memory, slot, modes, u, moved):
    """Whether a whole base period is proved to be clear: the state is so near to that of the region's own
    periodic motion that X cannot come as far as that motion's margin."""
    move(u, 0, moved, 0, shape.p)
    add(-1.0, memory, slot + shape.centred, moved, 0, shape.p)
    for c in range(shape.clearances):
        away = weigh(memory, slot + shape.swing + c * shape.p, shape.p, moved, 0)
        below, above = memory[slot + shape.margin + 2 * c], memory[slot + shape.margin + 2 * c + 1]
        if modes[c] == PLUS:
            above = np.inf
        elif modes[c] == MINUS:
            below = np.inf
        elif modes[c] != FREE:
            return False
        if not (away < below and away < above):
            return False
    return True


@inner
def leave_behind(motion):
    """What was crossed, and the start itself, are behind."""
    motion.position[FRESH] = 0.0
    for c in range(len(motion.on)):
        motion.on[c] = 0


@inner
def in_pieces(shape: Shape, memory, slot_of, rules, motion, m, k, end, arriving, hold, counts, record):
    """Cell k from motion.position to local time ``end``, event by event, and on into the next cell where that
    is its end; ``arriving``: the crossings at a position only."""
    if not bounded(motion.u, shape.p):  # no polynomial of infinities can be subdivided to an end
        return DIVERGED
    outcome = _by_pieces(shape, memory, slot_of, rules, motion, m, k, end, arriving, hold, counts, record)
    if outcome == OK and not arriving and end == 1.0:
        slot = slot_place(shape, slot_of, motion.modes)
        step = slot + shape.step + k * (1 + shape.n) * shape.rows
        _leap(shape, memory, step, shape.rows, motion.u, motion.tangents, m, motion.moved)
        motion.position[0], motion.position[1] = motion.position[0] + 1.0, 0.0
        leave_behind(motion)
    return outcome


@inner
def _by_pieces(shape: Shape, memory, slot_of, rules, motion, m, k, end, arriving, hold, counts, record):
    """The same up to ``end`` only."""
    events = 0
    cell = motion.position[0]
    while arriving or motion.position[1] < end:
        s = motion.position[1]
        held, stop = _held(hold, cell, s, end)
        slot = slot_place(shape, slot_of, motion.modes)
        at, which, boundary, behind, undecided = _first(
            shape, memory, slot, k, rules, motion, s, stop, int(hold[0]), held
        )
        if at == NONE:
            if arriving:
                break
            if undecided:
                counts[4 * shape.clearances] += 1
            if record.used[0] >= 0 and not _keep_piece(shape, memory, slot, motion, k, s, stop, record):
                return TOO_MANY
            _advance(motion, stop)
            continue
        outcome = _cross_called(
            shape, memory, slot_of, slot, rules, motion, m, k, at, which, boundary, behind,
            motion.position[FRESH] != 0.0 and at == s, undecided and not arriving, counts, record,
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


@inlined
def _first(shape: Shape, memory, slot, k, rules, motion, s, stop, held_clearance, held):
    """First exit of any clearance in [s, stop]: (time or NONE, clearance, boundary, mode behind,
    undecided)."""
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


@inlined
def cross(
    shape: Shape, memory, slot_of, slot, rules, motion, m, k, at, which, boundary, behind, silent, undecided,
    counts, record,
):  # fmt: skip
    """Carries a motion over one crossing in cell k, counts and records it (unless ``silent``)."""
    mode, count = motion.modes[which], shape.clearances
    before, after, target = side_of(mode), side_of(behind), slot
    if before != after:
        motion.modes[which] = behind
        target = slot_place(shape, slot_of, motion.modes)
        motion.position[NEEDED] = region_code(motion.modes)
        motion.modes[which] = mode
        if target < 0:
            return NEED_REGION
    if undecided:
        counts[4 * count] += 1
    if record.used[0] >= 0 and not _keep_piece(
        shape, memory, slot, motion, k, motion.position[1], at, record
    ):
        return TOO_MANY
    if before == after:  # out of the overlap of `no-tension`: nothing presses on either side
        motion.modes[which] = behind
        return OK
    engaging = after != FREE
    overlapping = mode in (OVER_PLUS, OVER_MINUS) or behind in (OVER_PLUS, OVER_MINUS)
    if not silent:
        counts[4 * which + (0 if engaging else 2) + (0 if boundary > 0 else 1)] += 1
        if record.used[0] >= 0 and not _keep_event(
            shape, memory, slot, motion, k, at, which, boundary, engaging, record
        ):
            return TOO_MANY
    sign = 1.0 if engaging else -1.0
    p, work = shape.p, motion.work
    for v in range(m):
        tangent = motion.tangents[v * p : (v + 1) * p]
        switch_tangent(
            shape, memory, slot, target, k, which, boundary, sign, rules[which], overlapping, at,
            tangent, work, motion.moved,
        )  # fmt: skip
    switch_state(
        shape,
        memory,
        slot,
        target,
        k,
        which,
        boundary,
        sign,
        rules[which],
        at,
        motion.u,
        work,
        motion.moved,
    )
    motion.modes[which] = behind
    return OK


@inner
def _cross_called(
    shape: Shape, memory, slot_of, slot, rules, motion, m, k, at, which, boundary, behind, silent, undecided,
    counts, record,
):  # fmt: skip
    """`cross`, as a call: away from the hot path."""
    return cross(
        shape, memory, slot_of, slot, rules, motion, m, k, at, which, boundary, behind, silent, undecided,
        counts, record,
    )  # fmt: skip


@inner
def _keep_event(shape: Shape, memory, slot, motion, k, at, which, boundary, engaging, record):
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
    if end <= start:
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
