"""A cell gone through event by event, in whatever order they come."""

from __future__ import annotations

from gearlash._kernel.jit import inlined, inner

from ._motion import (
    DIVERGED,
    FRESH,
    NEED_REGION,
    NEEDED,
    OK,
    TOO_MANY,
    apply_map,
    bounded,
    forget_crossed,
    slot_place,
)
from ._record import keep_event, keep_piece
from ._root_isolation import NO_ROOT
from ._surfaces import next_exit
from ._switch import region_code, side_of, switch_state, switch_tangent
from ._tables import FREE, OVER_MINUS, OVER_PLUS, Shape

EVENTS_PER_CELL = 4096


@inner
def cell_events(shape: Shape, memory, slot_of, rules, motion, m, k, end, arriving, hold, counts, record):
    """Cell k from motion.position to local time ``end``, event by event, and on into the next cell where that
    is its end; ``arriving``: the crossings at a position only."""
    if not bounded(motion.u, shape.p):  # no polynomial of infinities can be subdivided to an end
        return DIVERGED
    outcome = _events_until(shape, memory, slot_of, rules, motion, m, k, end, arriving, hold, counts, record)
    if outcome == OK and not arriving and end == 1.0:
        slot = slot_place(shape, slot_of, motion.modes)
        step = slot + shape.step + k * (1 + shape.n) * shape.rows
        apply_map(shape, memory, step, shape.rows, motion.u, motion.tangents, m, motion.moved)
        motion.position[0], motion.position[1] = motion.position[0] + 1.0, 0.0
        forget_crossed(motion)
    return outcome


@inner
def _events_until(shape: Shape, memory, slot_of, rules, motion, m, k, end, arriving, hold, counts, record):
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
        if at == NO_ROOT:
            if arriving:
                break
            if undecided:
                counts[4 * shape.clearances] += 1
            if record.used[0] >= 0 and not keep_piece(shape, memory, slot, motion, k, s, stop, record):
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
    """First exit of any clearance in [s, stop]: (time or NO_ROOT, clearance, boundary, mode behind,
    undecided)."""
    best, which, through, behind, undecided = NO_ROOT, 0, 0, 0, False
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
    if record.used[0] >= 0 and not keep_piece(shape, memory, slot, motion, k, motion.position[1], at, record):
        return TOO_MANY
    if before == after:  # out of the overlap of `no-tension`: nothing presses on either side
        motion.modes[which] = behind
        return OK
    engaging = after != FREE
    overlapping = mode in (OVER_PLUS, OVER_MINUS) or behind in (OVER_PLUS, OVER_MINUS)
    if not silent:
        counts[4 * which + (0 if engaging else 2) + (0 if boundary > 0 else 1)] += 1
        if record.used[0] >= 0 and not keep_event(
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
