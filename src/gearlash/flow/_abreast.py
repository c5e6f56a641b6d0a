"""The march of many motions side by side: of systems with one clearance and the rule `always`.

All are carried through the same cell before any goes on to the next. Blocks of eight, whose lanes share the
tables of a region, take what is proved to be clear at a glance. What is not, from all blocks, is gathered
eight by eight on a workbench (`_eight`): so crossings too are computed together, wherever in the blocks they
happen. Where too few do the same, and where a motion must be looked at in pieces, it is taken out and goes on
alone for a while (`_walk`). Either way every motion is, to the last bit, the one that `_march.run` makes."""

from __future__ import annotations

import numpy as np

from gearlash._kernel.jit import inlined, int64, kernel, record_of

from ._blocks import LANES
from ._eight import (
    GOING,
    INSIDE,
    KINDS,
    MOST,
    PROVED,
    WORKBENCH,
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
from ._exits import NONE, ones
from ._glance import CLEAR, UNSURE
from ._lanes import (
    apart,
    apart_from_abreast,
    bounds_abreast,
    choose,
    linear_abreast,
    over_abreast,
    under_abreast,
    weigh_abreast,
)
from ._march import Scratch, begin
from ._motion import DIVERGED, HUGE, OK, Motion, leave_behind
from ._pieces import cross, in_pieces
from ._record import Record
from ._surfaces import ROUNDING, one_crossing, verdict_of
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
from ._together import crossing


@inlined
def _laps(shape: Shape, memory, slot_of, lanes, b):
    """Carries those of a block over a whole base period that are proved to stay clear in it (`_walk`);
    returns their mask."""
    left, passed, row = lanes.masks[KINDS * b + GOING], 0, b * shape.p
    while left != 0:
        mode, group = alike(lanes, b, left)
        left &= ~group
        slot = slot_of_mode(shape, slot_of, mode)
        apart_from_abreast(memory, slot + shape.centred, lanes.u, row, lanes.out, shape.p)
        weigh_abreast(memory, slot + shape.swing, shape.p, lanes.out, 0, lanes.near)
        below, above = memory[slot + shape.margin], memory[slot + shape.margin + 1]
        for lane in range(LANES):
            away = lanes.near[lane]
            within = (mode == PLUS or away < above) and (mode == MINUS or away < below)
            if not (within and away < np.inf):
                group &= ~(1 << lane)
        if group != 0:
            used = used_rows(shape)
            linear_abreast(memory, slot + shape.lap, shape.p, used, 1 + shape.n, lanes.u, row, lanes.out, 0)
            choose(group, lanes.out, lanes.u, row, used)
            settle(lanes, b, group)
            passed |= group
    return passed


@inlined
def _clear(shape: Shape, memory, slot, k, mode, lanes, row):
    """Mask of the motions that are proved at a glance to keep their mode through a whole cell; as
    `_surfaces.stays` has it."""
    weigh_abreast(memory, slot + shape.near + k * shape.p, shape.p, lanes.u, row, lanes.near)
    if mode == PLUS:
        return over_abreast(lanes.out, shape.p, lanes.near)
    if mode == MINUS:
        bounds_abreast(0.0, -1.0, lanes.near, 0.0, lanes.limit)
        return under_abreast(lanes.out, shape.p, lanes.limit)
    plus, minus, reach = memory[shape.gaps], memory[shape.gaps + 1], ROUNDING * memory[shape.reach]
    bounds_abreast(plus, -1.0, lanes.near, reach, lanes.limit)
    clear = under_abreast(lanes.out, shape.p, lanes.limit)
    bounds_abreast(-minus, 1.0, lanes.near, reach, lanes.limit)
    return clear & over_abreast(lanes.out, shape.p, lanes.limit)


@inlined
def _over_clear(shape: Shape, memory, slot_of, lanes, b, k):
    """Carries those of a block through cell k that are proved at a glance to stay clear in it; the others
    queue up."""
    rows, used, row = shape.rows, used_rows(shape), b * shape.p
    pending = lanes.masks[KINDS * b + GOING] & ~lanes.passed[b]
    while pending != 0:
        mode, group = alike(lanes, b, pending)
        pending &= ~group
        slot = slot_of_mode(shape, slot_of, mode)
        step = slot + shape.step + k * (1 + shape.n) * rows
        linear_abreast(memory, step, rows, used, 1 + shape.n, lanes.u, row, lanes.out, 0)
        linear_abreast(memory, step + shape.p, rows, ROUGH, 1 + shape.n, lanes.u, row, lanes.out, shape.p)
        clear = group & ~lanes.masks[KINDS * b + INSIDE] & _clear(shape, memory, slot, k, mode, lanes, row)
        if clear != 0:
            choose(clear, lanes.out, lanes.u, row, used)
            settle(lanes, b, clear)
        rest = group & ~clear
        while rest != 0:
            lane = lowest(rest)
            rest &= ~(1 << lane)
            lanes.queue[MOST * mode + lanes.waiting[mode]] = LANES * b + lane
            lanes.waiting[mode] += 1


@inlined
def _through_queue(
    shape: Shape, memory, slot_of, rules, lanes, motion, cell, k, hold, counts, stretch, outcomes, record,
):  # fmt: skip
    """Carries what waits through cell k, eight by eight."""
    for mode in (PLUS, FREE, MINUS):
        first, waiting = MOST * mode, lanes.waiting[mode]
        lanes.waiting[mode] = 0
        while waiting > 0:
            count = min(waiting, LANES)
            waiting -= count
            place = first + waiting
            for i in range(count):
                source = lanes.queue[place + i]
                transfer(shape, lanes, source // LANES, source % LANES, WORKBENCH, i)
            _on_workbench(
                shape, memory, slot_of, rules, lanes, motion, (1 << count) - 1, cell, k, hold, counts,
                stretch, outcomes, record,
            )  # fmt: skip
            for i in range(count):
                target = lanes.queue[place + i]
                transfer(shape, lanes, WORKBENCH, i, target // LANES, target % LANES)


@inlined
def _on_workbench(
    shape: Shape, memory, slot_of, rules, lanes, motion, pending, cell, k, hold, counts, stretch, outcomes,
    record,
):  # fmt: skip
    """Carries the ``pending`` ones through cell k."""
    rows, used = shape.rows, used_rows(shape)
    while pending != 0:
        mode, rest = alike(lanes, WORKBENCH, pending)
        slot = slot_of_mode(shape, slot_of, mode)
        weigh_abreast(memory, slot + shape.rest + k * shape.p, shape.p, lanes.u, 0, lanes.near)
        fine = slot + shape.fine + k * (1 + shape.n) * TERMS
        linear_abreast(memory, fine, TERMS, TERMS, 1 + shape.n, lanes.u, 0, lanes.fine, 0)
        apart(lanes.fine, 0, TERMS, lanes.seen)
        clear, over, alone = 0, 0, 0
        while rest != 0:
            lane = lowest(rest)
            one = 1 << lane
            rest &= ~one
            verdict, boundary = verdict_of(
                shape, memory, 0, mode, rules[0], on_boundary(lanes, WORKBENCH, lane),
                holds(lanes, WORKBENCH, INSIDE, lane), lanes.near[lane], lanes.seen, lane * TERMS,
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
            linear_abreast(memory, step, rows, used, 1 + shape.n, lanes.u, 0, lanes.out, 0)
            choose(clear, lanes.out, lanes.u, 0, used)
            settle(lanes, WORKBENCH, clear)
            pending &= ~clear
        if over != 0:
            alone |= crossing(shape, memory, slot_of, slot, k, mode, over, lanes, counts, stretch)
        while alone != 0:
            lane = lowest(alone)
            alone &= ~(1 << lane)
            pending &= ~_go_alone(
                shape, memory, slot_of, slot, rules, lanes, motion, lane, cell, k, hold, counts, stretch,
                outcomes, record,
            )  # fmt: skip


@inlined
def _go_alone(
    shape: Shape, memory, slot_of, slot, rules, lanes, motion, lane, cell, k, hold, counts, stretch, outcomes,
    record,
):  # fmt: skip
    """Takes one out, and puts it back; returns its bit if it is through the cell, or has ended, else 0."""
    take_out(shape, lanes, motion, WORKBENCH, lane, cell)
    outcome = _alone(
        shape, memory, slot_of, slot, rules, lanes, motion, lane, k, hold,
        counts[lanes.motions[lane], stretch], record,
    )  # fmt: skip
    if outcome != OK:
        end(lanes, WORKBENCH, lane, outcome, outcomes)
        return 1 << lane
    put_back(shape, lanes, motion, WORKBENCH, lane)
    return 1 << lane if motion.position[0] != cell else 0


@inlined
def _alone(
    shape: Shape, memory, slot_of, slot, rules, lanes, motion, lane, k, hold, counts, record,
):  # fmt: skip
    """What `_walk.walk` does with one cell of a motion of which this verdict holds. Returns an outcome."""
    u, modes, s = motion.u, motion.modes, motion.position[1]
    verdict, boundary = lanes.verdict[lane], lanes.boundary[lane]
    at = NONE
    if verdict != UNSURE:
        at = one_crossing(
            shape, memory, slot, k, 0, modes[0], boundary, verdict, s, u, lanes.seen, lane * TERMS,
            motion.work,
        )  # fmt: skip
    mark(lanes, WORKBENCH, PROVED, lane, False)
    if at == NONE:
        return in_pieces(shape, memory, slot_of, rules, motion, 0, k, 1.0, False, hold, counts, record)
    behind = FREE if modes[0] != FREE else (PLUS if boundary > 0 else MINUS)
    outcome = cross(
        shape, memory, slot_of, slot, rules, motion, 0, k, at, 0, boundary, behind, False, False, counts,
        record,
    )  # fmt: skip
    leave_behind(motion)
    motion.on[0], motion.position[1] = boundary, at
    return outcome


@inlined
def _arrive(
    shape: Shape, memory, slot_of, rules, lanes, motion, b, hold, strobes, counts, stretch, outcomes, record
):
    """The end of a stretch, for one block: crossings just there, and the strobe."""
    for lane in range(LANES):
        if not holds(lanes, b, GOING, lane):
            continue
        which = lanes.motions[LANES * b + lane]
        if not holds(lanes, b, PROVED, lane):
            take_out(shape, lanes, motion, b, lane, 0.0)
            outcome = in_pieces(
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
        if not size < HUGE:  # as `_motion.bounded` has it
            end(lanes, b, lane, DIVERGED, outcomes)
    lanes.masks[KINDS * b + PROVED] = 0


@inlined
def _set_out(shape: Shape, memory, slot_of, rules, lanes, motion, motions, done, strobes):
    """Puts the motions into their blocks; returns the number of these."""
    blocks = (len(motions) + LANES - 1) // LANES
    for i in range(LANES * (blocks + 1)):
        b, lane = i // LANES, i % LANES
        number = i - LANES  # behind the workbench
        which = motions[number] if 0 <= number < len(motions) else motions[0]
        lanes.motions[i] = which
        motion.u[:] = 0.0
        motion.u[0] = 1.0
        for v in range(shape.n):
            motion.u[1 + v] = strobes[which, done, v]
        begin(shape, memory, slot_of, rules, motion, 0, 0.0, 0.0, strobes[which, done:], motion.moved)
        put_back(shape, lanes, motion, b, lane)
        mark(lanes, b, PROVED, lane, False)
        mark(lanes, b, GOING, lane, 0 <= number < len(motions))
    return blocks


@kernel(
    int64(
        SIZES, FLOATS, INTS, INTS, INTS, int64, int64, int64, CUBE, CUBE_OF_INTS, INTS, MUTABLE, INTS, INTS,
        MUTABLE, record_of(Record, INTS, MATRIX, CUBE, MATRIX, MATRIX),
        record_of(Scratch, *6 * [MUTABLE], INTS),
        record_of(Lanes, *2 * [MUTABLE], *5 * [INTS], *13 * [MUTABLE], *2 * [INTS]),
    ),
    alone=True,
)  # fmt: skip
def abreast(
    sizes, memory, slot_of, rules, motions, stretch, done, stretches, strobes, counts, outcomes, hold, modes,
    on, position, record, scratch, lanes,
):  # fmt: skip
    """Carries the motions with these numbers, up to `MOST`, from phase zero over ``stretches`` of ``stretch``
    base periods each.

    strobes (all motions, rows, n) holds their starts in row ``done`` and receives the states in the rows
    behind, counts (all motions, rows, 5), zero at first, what happened in each stretch from row ``done`` on,
    outcomes (all motions) how each ended: what is written of one that did not end well is of no use. All
    regions that can be met must have been built. The last three are work
    space (`_march.scratch`, `_eight.room`)."""
    shape = shape_of(sizes)
    u = scratch.origin
    motion = Motion(
        u, u[:0], modes, position, scratch.work, scratch.moved, scratch.zc, scratch.series, scratch.factors,
        scratch.sides, on,
    )  # fmt: skip
    masks, passed = lanes.masks, lanes.passed
    ones(scratch.work)
    lanes.waiting[:] = 0
    blocks = _set_out(shape, memory, slot_of, rules, lanes, motion, motions, done, strobes)
    for i in range(done, done + stretches):
        for cycle in range(stretch):
            left = 0
            for b in range(1, blocks + 1):
                passed[b] = _laps(shape, memory, slot_of, lanes, b)
                left |= masks[KINDS * b + GOING] & ~passed[b]
            for k in range(shape.cells if left != 0 else 0):
                for b in range(1, blocks + 1):
                    _over_clear(shape, memory, slot_of, lanes, b, k)
                _through_queue(
                    shape, memory, slot_of, rules, lanes, motion, float(cycle * shape.cells + k), k, hold,
                    counts, i, outcomes, record,
                )  # fmt: skip
        for b in range(1, blocks + 1):
            _arrive(
                shape, memory, slot_of, rules, lanes, motion, b, hold, strobes, counts, i, outcomes, record
            )
    return OK
