"""The march of an ensemble of motions side by side: of systems with one clearance and the rule `always`.

All motions are carried through the same cell before any goes on to the next. They lie in blocks of eight
lanes, which share the tables of a region. Where the sign test proves that a motion meets no boundary in the
cell, it is carried with its block. The others, from all blocks, are gathered in one block (`_lanes`), eight
at a time: so crossings are computed eight at a time too. Where too few motions do the same, and where a cell
must be gone through event by event, a motion leaves its lane and is carried alone for a while (`_walk`).
Either way every motion is, to the last bit, the one that `_march.run` computes."""

from __future__ import annotations

import numpy as np

from gearlash._kernel.jit import inlined, int64, kernel, record_of

from ._blocks import LANES
from ._cell_events import cell_events, cross
from ._lane_crossings import cross_in_lanes
from ._lane_vectors import (
    apart,
    bounds_lanes,
    choose,
    difference_lanes,
    linear_lanes,
    over_lanes,
    under_lanes,
    weigh_lanes,
)
from ._lanes import (
    GATHER_BLOCK,
    IN_MID_CELL,
    MASK_KINDS,
    MOST_MOTIONS,
    PROVED,
    UNDER_WAY,
    Lanes,
    alike,
    end,
    holds,
    lowest,
    mark,
    mode_of,
    on_boundary,
    put_back,
    settle,
    slot_of_mode,
    take_out,
    transfer,
    used_rows,
)
from ._march import begin, scratch_in
from ._motion import DIVERGED, DIVERGED_BEYOND, OK, MotionState, forget_crossed
from ._record import Record
from ._root_isolation import NO_ROOT, ones
from ._sign_test import CLEAR, UNSURE
from ._surfaces import PLACE_ROUNDING, one_crossing, verdict_of
from ._tables import (
    CUBE,
    CUBE_OF_INTS,
    FLOATS,
    FREE,
    INTS,
    MATRIX,
    MINUS,
    MUTABLE,
    PLUS,
    ROUGH,
    SIZES,
    TERMS,
    Shape,
    shape_of,
)


@inlined
def _laps(shape: Shape, memory, slot_of, lanes, b):
    """Carries those of a block over a whole base period that are proved to stay clear in it (`_walk`);
    returns their mask."""
    left, passed, row = lanes.masks[MASK_KINDS * b + UNDER_WAY], 0, b * shape.p
    while left != 0:
        mode, group = alike(lanes, b, left)
        left &= ~group
        slot = slot_of_mode(shape, slot_of, mode)
        difference_lanes(memory, slot + shape.centred, lanes.u, row, lanes.out, shape.p)
        weigh_lanes(memory, slot + shape.swing, shape.p, lanes.out, 0, lanes.near)
        below, above = memory[slot + shape.margin], memory[slot + shape.margin + 1]
        for lane in range(LANES):
            away = lanes.near[lane]
            within = (mode == PLUS or away < above) and (mode == MINUS or away < below)
            if not (within and away < np.inf):
                group &= ~(1 << lane)
        if group != 0:
            used = used_rows(shape)
            linear_lanes(memory, slot + shape.lap, shape.p, used, 1 + shape.n, lanes.u, row, lanes.out, 0)
            choose(group, lanes.out, lanes.u, row, used)
            settle(lanes, b, group)
            passed |= group
    return passed


@inlined
def _clear(shape: Shape, memory, slot, k, mode, lanes, row):
    """Mask of the motions that are proved by the sign test to keep their mode through a whole cell; as
    `_surfaces.stays` has it."""
    weigh_lanes(memory, slot + shape.near + k * shape.p, shape.p, lanes.u, row, lanes.near)
    if mode == PLUS:
        return over_lanes(lanes.out, shape.p, lanes.near)
    if mode == MINUS:
        bounds_lanes(0.0, -1.0, lanes.near, 0.0, lanes.limit)
        return under_lanes(lanes.out, shape.p, lanes.limit)
    plus, minus, reach = memory[shape.gaps], memory[shape.gaps + 1], PLACE_ROUNDING * memory[shape.reach]
    bounds_lanes(plus, -1.0, lanes.near, reach, lanes.limit)
    clear = under_lanes(lanes.out, shape.p, lanes.limit)
    bounds_lanes(-minus, 1.0, lanes.near, reach, lanes.limit)
    return clear & over_lanes(lanes.out, shape.p, lanes.limit)


@inlined
def _clear_cells(shape: Shape, memory, slot_of, lanes, b, k):
    """Carries those of a block through cell k of which the sign test proves that they meet no boundary in it;
    the others are put into the queue."""
    rows, used, row = shape.rows, used_rows(shape), b * shape.p
    pending = lanes.masks[MASK_KINDS * b + UNDER_WAY] & ~lanes.passed[b]
    while pending != 0:
        mode, group = alike(lanes, b, pending)
        pending &= ~group
        slot = slot_of_mode(shape, slot_of, mode)
        step = slot + shape.step + k * (1 + shape.n) * rows
        linear_lanes(memory, step, rows, used, 1 + shape.n, lanes.u, row, lanes.out, 0)
        linear_lanes(memory, step + shape.p, rows, ROUGH, 1 + shape.n, lanes.u, row, lanes.out, shape.p)
        clear = group & ~lanes.masks[MASK_KINDS * b + IN_MID_CELL]
        clear &= _clear(shape, memory, slot, k, mode, lanes, row)
        if clear != 0:
            choose(clear, lanes.out, lanes.u, row, used)
            settle(lanes, b, clear)
        rest = group & ~clear
        while rest != 0:
            lane = lowest(rest)
            rest &= ~(1 << lane)
            lanes.queue[MOST_MOTIONS * mode + lanes.waiting[mode]] = LANES * b + lane
            lanes.waiting[mode] += 1


@inlined
def _queued_cell(
    shape: Shape, memory, slot_of, rules, lanes, motion, cell, k, hold, counts, stretch, outcomes, record,
):  # fmt: skip
    """Carries what waits through cell k, eight by eight."""
    for mode in (PLUS, FREE, MINUS):
        first, waiting = MOST_MOTIONS * mode, lanes.waiting[mode]
        lanes.waiting[mode] = 0
        while waiting > 0:
            count = min(waiting, LANES)
            waiting -= count
            place = first + waiting
            for i in range(count):
                source = lanes.queue[place + i]
                transfer(shape, lanes, source // LANES, source % LANES, GATHER_BLOCK, i)
            _gathered_cell(
                shape, memory, slot_of, rules, lanes, motion, (1 << count) - 1, cell, k, hold, counts,
                stretch, outcomes, record,
            )  # fmt: skip
            for i in range(count):
                target = lanes.queue[place + i]
                transfer(shape, lanes, GATHER_BLOCK, i, target // LANES, target % LANES)


@inlined
def _gathered_cell(
    shape: Shape, memory, slot_of, rules, lanes, motion, pending, cell, k, hold, counts, stretch, outcomes,
    record,
):  # fmt: skip
    """Carries the ``pending`` ones through cell k."""
    rows, used = shape.rows, used_rows(shape)
    while pending != 0:
        mode, rest = alike(lanes, GATHER_BLOCK, pending)
        slot = slot_of_mode(shape, slot_of, mode)
        weigh_lanes(memory, slot + shape.rest + k * shape.p, shape.p, lanes.u, 0, lanes.near)
        fine = slot + shape.fine + k * (1 + shape.n) * TERMS
        linear_lanes(memory, fine, TERMS, TERMS, 1 + shape.n, lanes.u, 0, lanes.fine, 0)
        apart(lanes.fine, 0, TERMS, lanes.seen)
        clear, over, alone = 0, 0, 0
        while rest != 0:
            lane = lowest(rest)
            one = 1 << lane
            rest &= ~one
            verdict, boundary = verdict_of(
                shape, memory, 0, mode, rules[0], on_boundary(lanes, GATHER_BLOCK, lane),
                holds(lanes, GATHER_BLOCK, IN_MID_CELL, lane), lanes.near[lane], lanes.seen, lane * TERMS,
            )  # fmt: skip
            lanes.verdict[lane], lanes.boundary[lane] = verdict, boundary
            if verdict == CLEAR:
                clear |= one
            elif verdict != UNSURE:
                over |= one
            else:
                alone |= one
        if clear != 0:
            step = slot + shape.step + k * (1 + shape.n) * rows
            linear_lanes(memory, step, rows, used, 1 + shape.n, lanes.u, 0, lanes.out, 0)
            choose(clear, lanes.out, lanes.u, 0, used)
            settle(lanes, GATHER_BLOCK, clear)
            pending &= ~clear
        if over != 0:
            alone |= cross_in_lanes(shape, memory, slot_of, slot, k, mode, over, lanes, counts, stretch)
        while alone != 0:
            lane = lowest(alone)
            alone &= ~(1 << lane)
            pending &= ~_leave_lanes(
                shape, memory, slot_of, slot, rules, lanes, motion, lane, cell, k, hold, counts, stretch,
                outcomes, record,
            )  # fmt: skip


@inlined
def _leave_lanes(
    shape: Shape, memory, slot_of, slot, rules, lanes, motion, lane, cell, k, hold, counts, stretch, outcomes,
    record,
):  # fmt: skip
    """Takes one out, and puts it back; returns its bit if it is through the cell, or has ended, else 0."""
    take_out(shape, lanes, motion, GATHER_BLOCK, lane, cell)
    outcome = _one_cell_alone(
        shape, memory, slot_of, slot, rules, lanes, motion, lane, k, hold,
        counts[lanes.motions[lane], stretch], record,
    )  # fmt: skip
    if outcome != OK:
        end(lanes, GATHER_BLOCK, lane, outcome, outcomes)
        return 1 << lane
    put_back(shape, lanes, motion, GATHER_BLOCK, lane)
    return 1 << lane if motion.position[0] != cell else 0


@inlined
def _one_cell_alone(
    shape: Shape, memory, slot_of, slot, rules, lanes, motion, lane, k, hold, counts, record,
):  # fmt: skip
    """What `_walk.walk` does with one cell of a motion of which this verdict holds. Returns an outcome."""
    u, modes, s = motion.u, motion.modes, motion.position[1]
    verdict, boundary = lanes.verdict[lane], lanes.boundary[lane]
    at = NO_ROOT
    if verdict != UNSURE:
        at = one_crossing(
            shape, memory, slot, k, 0, modes[0], boundary, verdict, s, u, lanes.seen, lane * TERMS,
            motion.work,
        )  # fmt: skip
    mark(lanes, GATHER_BLOCK, PROVED, lane, False)
    if at == NO_ROOT:
        return cell_events(shape, memory, slot_of, rules, motion, 0, k, 1.0, False, hold, counts, record)
    behind = FREE if modes[0] != FREE else (PLUS if boundary > 0 else MINUS)
    outcome = cross(
        shape, memory, slot_of, slot, rules, motion, 0, k, at, 0, boundary, behind, False, False, counts,
        record,
    )  # fmt: skip
    forget_crossed(motion)
    motion.on[0], motion.position[1] = boundary, at
    return outcome


@inlined
def _end_of_stretch(
    shape: Shape, memory, slot_of, rules, lanes, motion, b, hold, strobes, counts, stretch, outcomes, record
):
    """The end of a stretch, for one block: crossings just there, and the strobe."""
    for lane in range(LANES):
        if not holds(lanes, b, UNDER_WAY, lane):
            continue
        which = lanes.motions[LANES * b + lane]
        if not holds(lanes, b, PROVED, lane):
            take_out(shape, lanes, motion, b, lane, 0.0)
            outcome = cell_events(
                shape, memory, slot_of, rules, motion, 0, 0, 0.0, True, hold, counts[which, stretch], record,
            )  # fmt: skip
            put_back(shape, lanes, motion, b, lane)
            if outcome != OK:
                end(lanes, b, lane, outcome, outcomes)
        centre, size = slot_of_mode(shape, slot_of, mode_of(lanes, b, lane)) + shape.centre, 1.0
        for i in range(1, 1 + shape.n):
            value = lanes.u[LANES * (b * shape.p + i) + lane]
            size += abs(value)
            strobes[which, stretch + 1, i - 1] = value + memory[centre + i]
        if not size < DIVERGED_BEYOND:  # as `_motion.bounded` has it
            end(lanes, b, lane, DIVERGED, outcomes)
    lanes.masks[MASK_KINDS * b + PROVED] = 0


@inlined
def _put_into_lanes(shape: Shape, memory, slot_of, rules, lanes, motion, motions, done, strobes):
    """Puts the motions into their blocks; returns the number of these."""
    blocks = (len(motions) + LANES - 1) // LANES
    for i in range(LANES * (blocks + 1)):
        b, lane = i // LANES, i % LANES
        number = i - LANES  # behind the gather block
        which = motions[number] if 0 <= number < len(motions) else motions[0]
        lanes.motions[i] = which
        motion.u[:] = 0.0
        motion.u[0] = 1.0
        for v in range(shape.n):
            motion.u[1 + v] = strobes[which, done, v]
        begin(shape, memory, slot_of, rules, motion, 0, 0.0, 0.0, strobes[which, done:], motion.moved)
        put_back(shape, lanes, motion, b, lane)
        mark(lanes, b, PROVED, lane, False)
        mark(lanes, b, UNDER_WAY, lane, 0 <= number < len(motions))
    return blocks


@kernel(
    int64(
        SIZES, FLOATS, INTS, INTS, INTS, int64, int64, int64, CUBE, CUBE_OF_INTS, INTS, MUTABLE, MUTABLE,
        INTS, record_of(Record, INTS, MATRIX, CUBE, MATRIX, MATRIX),
        record_of(Lanes, *2 * [MUTABLE], *5 * [INTS], *13 * [MUTABLE], *2 * [INTS]),
    ),
    alone=True,
)  # fmt: skip
def march_ensemble(
    sizes, memory, slot_of, rules, motions, stretch, done, stretches, strobes, counts, outcomes, hold,
    numbers, ints, record, lanes,
):  # fmt: skip
    """Carries the motions with these numbers, up to `MOST_MOTIONS`, from phase zero over ``stretches``
    stretches of ``stretch`` base periods each.

    strobes (all motions, rows, n) holds their starts in row ``done`` and receives the states in the rows
    behind, counts (all motions, rows, 5), zero at first, what happened in each stretch from row ``done`` on,
    outcomes (all motions) how each ended: what is written of one that did not end well is of no use. All
    regions that can be met must have been built. numbers, ints and lanes are work space (`_march.scratch`,
    `_lanes.lane_workspace`), record keeps nothing."""
    shape = shape_of(sizes)
    room = scratch_in(shape, numbers, ints)
    u = room.origin
    motion = MotionState(
        u, u[:0], room.modes, room.position, room.work, room.moved, room.zc, room.series, room.factors,
        room.sides, room.on,
    )  # fmt: skip
    masks, passed = lanes.masks, lanes.passed
    ones(room.work)
    lanes.waiting[:] = 0
    blocks = _put_into_lanes(shape, memory, slot_of, rules, lanes, motion, motions, done, strobes)
    for i in range(done, done + stretches):
        for cycle in range(stretch):
            left = 0
            for b in range(1, blocks + 1):
                passed[b] = _laps(shape, memory, slot_of, lanes, b)
                left |= masks[MASK_KINDS * b + UNDER_WAY] & ~passed[b]
            for k in range(shape.cells if left != 0 else 0):
                for b in range(1, blocks + 1):
                    _clear_cells(shape, memory, slot_of, lanes, b, k)
                _queued_cell(
                    shape, memory, slot_of, rules, lanes, motion, float(cycle * shape.cells + k), k, hold,
                    counts, i, outcomes, record,
                )  # fmt: skip
        for b in range(1, blocks + 1):
            _end_of_stretch(
                shape, memory, slot_of, rules, lanes, motion, b, hold, strobes, counts, i, outcomes, record
            )
    return OK
