"""The march of eight motions side by side: of systems with one clearance and the rule `always`.

All are carried through the same cell before any goes on to the next, in groups that are in the same region
there: such a group shares its tables, and what is seen at a glance (`_glance`) is done to all of it at once.
Where too few motions do the same, and where a motion must be looked at in pieces, it is taken out and goes on
alone for a while (`_walk`). Either way every motion is, to the last bit, the one that `_march.run` makes."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearlash._kernel import fma, inlined, int64, kernel

from ._exits import MOST_STEPS, NONE, halley, ones
from ._glance import AGAIN, CLEAR, ONCE, THERE_AND_BACK, farthest, leaving
from ._lanes import (
    ROWS,
    apart,
    choose,
    jets_abreast,
    linear_abreast,
    over_abreast,
    powers_abreast,
    under_abreast,
    values_abreast,
    weigh_abreast,
)
from ._march import begin
from ._surfaces import ROUNDING, inward_of, one_crossing, verdict_of
from ._switch import side_of
from ._tables import (
    CUBE,
    CUBE_OF_INTS,
    FLOATS,
    FREE,
    INTS,
    MATRIX,
    MINUS,
    MUTABLE,
    ORDER,
    PLUS,
    ROUGH,
    SHAPE,
    TERMS,
    Array,
    Shape,
    aligned,
    aligned_ints,
)
from ._vector import LANES, move, ones_in, times
from ._walk import DIVERGED, FRESH, HUGE, OK, Motion, Record, cross, in_pieces, leave_behind

ALL = (1 << LANES) - 1
FEW = 2  # so many crossings alone cost as much as eight at once


class Lanes(NamedTuple):
    """Eight motions: value i of motion l at place 8·i + l."""

    u: Array  # (p): (1, z - c) at the beginning of the cell, under the flow of the present region
    out: Array  # (rows): what the table `step` makes of u
    fine: Array  # (TERMS): the `fine_coefficients`
    gap: Array  # (TERMS): X - edge over the cell
    push: Array  # (TERMS): work
    moments: Array  # (TERMS): work
    powers: Array  # (TERMS): of the local time of a crossing
    jet: Array  # (3): value, slope, half the second derivative
    near: Array  # bound on the error of a coefficient
    limit: Array
    s: Array  # where in the cell each is
    lo: Array
    hi: Array
    at: Array  # of the crossing
    seen: Array  # (motions, TERMS): the same, motion by motion
    verdict: np.ndarray  # int: of `glance`, and
    boundary: np.ndarray  # int: the one that it is about
    masks: np.ndarray  # (9) int: the motions of which something holds, see below
    motions: np.ndarray  # int: their numbers in the arrays of all motions


# places in `masks`; first, at the place of each mode, those that are in it
INSIDE = 3  # no longer at the beginning of their cell
ON_PLUS, ON_MINUS = 4, 5  # boundary that was crossed where they are
FRESH_ONES = 6  # have not left their start
PROVED = 7  # the last cell was proved to be clear
GOING = 8  # still under way


def room(shape: Shape) -> tuple[Array, ...]:
    """Work space of `abreast`."""
    p, rows = shape.p, shape.rows
    sizes = (p, rows, TERMS, TERMS, TERMS, TERMS, TERMS, 3, 1, 1, 1, 1, 1, 1, TERMS)
    return (*aligned(*(LANES * size for size in sizes)), *aligned_ints(LANES, LANES, GOING + 1))


@inlined
def _used(shape: Shape):
    """Rows of a state that are not there to fill a block, in whole blocks of products. The rest stay zero."""
    return (1 + shape.n + ROWS - 1) // ROWS * ROWS


@inlined
def _lowest(mask):
    """Number of the lowest one of a mask."""
    return ones_in((mask & -mask) - 1)


@inlined
def _slot(shape: Shape, slot_of, mode):
    return shape.slots + slot_of[side_of(mode)] * shape.slot


@inlined
def _holds(lanes, which, lane):
    """Whether one of the masks has a motion."""
    return (lanes.masks[which] >> lane) & 1 != 0


@inlined
def _mark(lanes, which, lane, value):
    """Puts a motion into one of the masks, or takes it out."""
    lanes.masks[which] = (lanes.masks[which] & ~(1 << lane)) | (int(value) << lane)


@inlined
def _mode(lanes, lane):
    return PLUS if _holds(lanes, PLUS, lane) else (MINUS if _holds(lanes, MINUS, lane) else FREE)


@inlined
def _on(lanes, lane):
    """The boundary that was crossed where a motion is, or 0."""
    return 1 if _holds(lanes, ON_PLUS, lane) else (-1 if _holds(lanes, ON_MINUS, lane) else 0)


@inlined
def _inside(lanes, lane):
    """Where in its cell a motion is."""
    return lanes.s[lane] if _holds(lanes, INSIDE, lane) else 0.0


@inlined
def _take_out(shape: Shape, lanes, motion, lane, cell):
    """One of the eight to where it can go on alone."""
    for i in range(shape.p):
        motion.u[i] = lanes.u[LANES * i + lane]
    motion.modes[0], motion.on[0] = _mode(lanes, lane), _on(lanes, lane)
    motion.position[0], motion.position[1] = cell, _inside(lanes, lane)
    motion.position[FRESH] = 1.0 if _holds(lanes, FRESH_ONES, lane) else 0.0


@inlined
def _put_back(shape: Shape, lanes, motion, lane):
    for i in range(shape.p):
        lanes.u[LANES * i + lane] = motion.u[i]
    for mode in (PLUS, FREE, MINUS):
        _mark(lanes, mode, lane, motion.modes[0] == mode)
    lanes.s[lane] = motion.position[1]
    _mark(lanes, INSIDE, lane, motion.position[1] != 0.0)
    _mark(lanes, ON_PLUS, lane, motion.on[0] > 0)
    _mark(lanes, ON_MINUS, lane, motion.on[0] < 0)
    _mark(lanes, FRESH_ONES, lane, motion.position[FRESH] != 0.0)


@inlined
def _group(lanes, pending):
    """Those that are in the same region as the lowest."""
    mode = _mode(lanes, _lowest(pending))
    return mode, pending & lanes.masks[mode]


@inlined
def _settle(lanes, mask):
    """To the beginning of the next cell: what was crossed, and the start, are behind."""
    for which in (INSIDE, ON_PLUS, ON_MINUS, FRESH_ONES):
        lanes.masks[which] &= ~mask
    lanes.masks[PROVED] |= mask


@inlined
def _laps(shape: Shape, memory, slot_of, lanes):
    """Carries those over a whole base period that are proved to stay clear in it (`_walk`); returns their
    mask."""
    left, passed = lanes.masks[GOING], 0
    while left != 0:
        mode, group = _group(lanes, left)
        left &= ~group
        slot = _slot(shape, slot_of, mode)
        for i in range(shape.p):
            for lane in range(LANES):
                centred = memory[slot + shape.centred + i]
                lanes.out[LANES * i + lane] = fma(-1.0, centred, lanes.u[LANES * i + lane])
        weigh_abreast(memory, slot + shape.swing, shape.p, lanes.out, lanes.near)
        below, above = memory[slot + shape.margin], memory[slot + shape.margin + 1]
        for lane in range(LANES):
            away = lanes.near[lane]
            within = (mode == PLUS or away < above) and (mode == MINUS or away < below)
            if not (within and away < np.inf):
                group &= ~(1 << lane)
        if group != 0:
            used = _used(shape)
            linear_abreast(memory, slot + shape.lap, shape.p, used, 1 + shape.n, lanes.u, lanes.out, 0)
            choose(group, lanes.out, lanes.u, used)
            _settle(lanes, group)
            passed |= group
    return passed


@inlined
def _clear(shape: Shape, memory, slot, k, mode, lanes):
    """Mask of the motions that are proved at a glance to keep their mode through a whole cell; as
    `_surfaces.stays` has it."""
    weigh_abreast(memory, slot + shape.near + k * shape.p, shape.p, lanes.u, lanes.near)
    if mode != FREE:
        for lane in range(LANES):
            lanes.limit[lane] = lanes.near[lane] if mode == PLUS else -lanes.near[lane]
        if mode == PLUS:
            return over_abreast(lanes.out, shape.p, lanes.limit)
        return under_abreast(lanes.out, shape.p, lanes.limit)
    plus, minus, reach = memory[shape.gaps], memory[shape.gaps + 1], ROUNDING * memory[shape.reach]
    for lane in range(LANES):
        lanes.limit[lane] = plus - (lanes.near[lane] + reach)
    clear = under_abreast(lanes.out, shape.p, lanes.limit)
    for lane in range(LANES):
        lanes.limit[lane] = (lanes.near[lane] + reach) - minus
    return clear & over_abreast(lanes.out, shape.p, lanes.limit)


@inlined
def _polish(lanes, mask, place, sign):
    """`at` ← where each crosses, from `lo`, `hi` and the guess in `at`: `_exits.polish`, eight at a time."""
    for lane in range(LANES):
        guess, lo, hi = lanes.at[lane], lanes.lo[lane], lanes.hi[lane]
        lanes.at[lane] = guess if lo < guess < hi else 0.5 * (lo + hi)
    for _ in range(MOST_STEPS):
        jets_abreast(lanes.gap, lanes.at, lanes.jet)
        for lane in range(LANES):
            if (mask >> lane) & 1 != 0:
                done, lanes.at[lane], lanes.lo[lane], lanes.hi[lane] = halley(
                    lanes.jet[lane] - place, lanes.jet[LANES + lane], lanes.jet[2 * LANES + lane], sign,
                    lanes.lo[lane], lanes.hi[lane], lanes.at[lane],
                )  # fmt: skip
                if done:
                    mask &= ~(1 << lane)
        if mask == 0:
            break


@inlined
def _switch(shape: Shape, memory, source, target, k, side, sign, edge, mask, lanes):
    """u ← the virtual starts behind crossings at `at`: `_switch.switch_state`, eight at a time."""
    used = _used(shape)
    powers_abreast(lanes.at, lanes.powers)
    move(lanes.gap, 0, lanes.push, 0, LANES * TERMS)
    for lane in range(LANES):
        lanes.push[lane] = fma(-edge, 1.0, lanes.push[lane])
    times(lanes.powers, 0, lanes.push, 0, LANES * TERMS)
    linear_abreast(memory, shape.hilbert, TERMS, TERMS, ORDER + 1, lanes.push, lanes.moments, 0)
    times(lanes.powers, 0, lanes.moments, 0, LANES * TERMS)
    push = target + shape.push + (2 * k + side) * (ORDER + 1) * shape.p
    linear_abreast(memory, push, shape.p, used, ORDER + 1, lanes.moments, lanes.out, 0)
    for lane in range(LANES):
        lanes.limit[lane] = memory[shape.scalars + 1] * lanes.at[lane]
    for i in range(1 + shape.n):
        before, after = memory[source + shape.centre + i], memory[target + shape.centre + i]
        for lane in range(LANES):
            place = LANES * i + lane
            moved = fma(-sign, lanes.limit[lane] * lanes.out[place], lanes.u[place])
            lanes.out[place] = fma(-1.0, after, fma(1.0, before, moved))
    choose(mask, lanes.out, lanes.u, used)


@inlined
def _place(shape: Shape, memory, mode, boundary):
    """Of a boundary, told from the edge that X is told from in a mode."""
    return boundary * memory[shape.gaps + (0 if boundary > 0 else 1)] if mode == FREE else 0.0


@inlined
def _bracket(shape: Shape, memory, mode, mask, lanes):
    """Fills `lo`, `hi` and the guess in `at` of the crossings of a mask; returns those of which there is one
    for sure: the first part of `_surfaces.one_crossing`."""
    for lane in range(LANES):  # where two crossings may be or none: a place between them
        inward = inward_of(mode, lanes.boundary[lane])
        side = inward if lanes.verdict[lane] == AGAIN else -inward
        if (mask >> lane) & 1 != 0 and lanes.verdict[lane] != ONCE:
            lanes.at[lane] = farthest(lanes.seen, lane * TERMS, side)
    values_abreast(lanes.gap, lanes.at, lanes.limit)
    for lane in range(LANES):
        if (mask >> lane) & 1 == 0:
            continue
        verdict, boundary = lanes.verdict[lane], lanes.boundary[lane]
        inward, place = inward_of(mode, boundary), _place(shape, memory, mode, boundary)
        lanes.lo[lane], lanes.hi[lane] = _inside(lanes, lane), 1.0
        if verdict != ONCE:
            side, between = (inward if verdict == AGAIN else -inward), lanes.at[lane]
            near = lanes.near[lane] + ROUNDING * memory[shape.reach]
            if between <= lanes.lo[lane] or not side * (lanes.limit[lane] - place) > near:
                mask &= ~(1 << lane)
                continue
            if verdict == AGAIN:
                lanes.lo[lane] = between
            else:
                lanes.hi[lane] = between
        lanes.at[lane] = leaving(lanes.seen, lane * TERMS, inward, place, verdict == AGAIN)
    return mask


@inlined
def _cross_together(shape: Shape, memory, slot_of, slot, k, mode, boundary, mask, lanes, counts, stretch):
    """Carries the motions of a mask over their crossings of the same boundary in cell k."""
    side = 0 if boundary > 0 else 1
    behind = FREE if mode != FREE else (PLUS if boundary > 0 else MINUS)
    sign, target = (1.0 if behind != FREE else -1.0), _slot(shape, slot_of, behind)
    _polish(lanes, mask, _place(shape, memory, mode, boundary), inward_of(mode, boundary))
    edge = boundary * memory[shape.gaps + side] if sign > 0.0 else 0.0
    _switch(shape, memory, slot, target, k, side, sign, edge, mask, lanes)
    for which in (mode, ON_PLUS, ON_MINUS, FRESH_ONES, PROVED):
        lanes.masks[which] &= ~mask
    for which in (behind, INSIDE, ON_PLUS if boundary > 0 else ON_MINUS):
        lanes.masks[which] |= mask
    for lane in range(LANES):
        if (mask >> lane) & 1 != 0:
            counts[lanes.motions[lane], stretch, (0 if sign > 0.0 else 2) + side] += 1
            lanes.s[lane] = lanes.at[lane]


@inlined
def _crossing(shape: Shape, memory, slot_of, slot, k, mode, mask, lanes, counts, stretch):
    """Carries those of a mask over their next crossing, boundary by boundary, unless they are few or it is
    not certain. Returns those that it left."""
    if ones_in(mask) < FEW:
        return mask
    series = slot + shape.gap + k * (1 + shape.n) * TERMS
    linear_abreast(memory, series, TERMS, TERMS, 1 + shape.n, lanes.u, lanes.gap, 0)
    sure = _bracket(shape, memory, mode, mask, lanes)
    left, upward = mask & ~sure, 0
    for lane in range(LANES):
        if (sure >> lane) & 1 != 0 and lanes.boundary[lane] > 0:
            upward |= 1 << lane
    for boundary in (1, -1):
        group = upward if boundary > 0 else sure & ~upward
        if ones_in(group) < FEW:
            left |= group
        else:
            _cross_together(shape, memory, slot_of, slot, k, mode, boundary, group, lanes, counts, stretch)
    return left


@inlined
def _alone(
    shape: Shape, memory, slot_of, slot, rules, lanes, motion, lane, k, hold, counts, record,
):  # fmt: skip
    """What `_walk.walk` does with one cell of a motion of which this verdict holds. Returns an outcome."""
    u, modes, s = motion.u, motion.modes, motion.position[1]
    verdict, boundary = lanes.verdict[lane], lanes.boundary[lane]
    at = NONE
    if verdict == AGAIN or (s == 0.0 and verdict in (ONCE, THERE_AND_BACK)):
        at = one_crossing(
            shape,
            memory,
            slot,
            k,
            0,
            modes[0],
            boundary,
            verdict,
            s,
            u,
            lanes.seen,
            lane * TERMS,
            motion.work,
        )
    _mark(lanes, PROVED, lane, False)
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
def _through_cell(
    shape: Shape, memory, slot_of, rules, lanes, motion, pending, cell, k, hold, counts, stretch, outcomes,
    record,
):  # fmt: skip
    """Carries the ``pending`` ones through cell k."""
    rows, p, used = shape.rows, shape.p, _used(shape)
    while pending != 0:
        mode, group = _group(lanes, pending)
        slot = _slot(shape, slot_of, mode)
        step = slot + shape.step + k * (1 + shape.n) * rows
        linear_abreast(memory, step, rows, used, 1 + shape.n, lanes.u, lanes.out, 0)
        linear_abreast(memory, step + p, rows, ROUGH, 1 + shape.n, lanes.u, lanes.out, p)
        clear = group & ~lanes.masks[INSIDE] & _clear(shape, memory, slot, k, mode, lanes)
        rest, crossing, alone = group & ~clear, 0, 0
        if rest != 0:
            weigh_abreast(memory, slot + shape.rest + k * p, p, lanes.u, lanes.near)
            fine = slot + shape.fine + k * (1 + shape.n) * TERMS
            linear_abreast(memory, fine, TERMS, TERMS, 1 + shape.n, lanes.u, lanes.fine, 0)
            apart(lanes.fine, 0, TERMS, lanes.seen)
        while rest != 0:
            lane = _lowest(rest)
            one = 1 << lane
            rest &= ~one
            verdict, boundary = verdict_of(
                shape, memory, 0, mode, rules[0], _on(lanes, lane), lanes.near[lane], lanes.seen, lane * TERMS
            )
            lanes.verdict[lane], lanes.boundary[lane] = verdict, boundary
            if verdict == CLEAR:
                clear |= one
            elif verdict == AGAIN or (not _holds(lanes, INSIDE, lane) and verdict in (ONCE, THERE_AND_BACK)):
                crossing |= one
            else:
                alone |= one
        if clear != 0:
            choose(clear, lanes.out, lanes.u, used)
            _settle(lanes, clear)
            pending &= ~clear
        if crossing != 0:
            alone |= _crossing(shape, memory, slot_of, slot, k, mode, crossing, lanes, counts, stretch)
        while alone != 0:
            lane = _lowest(alone)
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
    _take_out(shape, lanes, motion, lane, cell)
    outcome = _alone(
        shape, memory, slot_of, slot, rules, lanes, motion, lane, k, hold,
        counts[lanes.motions[lane], stretch], record,
    )  # fmt: skip
    if outcome != OK:
        _end(lanes, lane, outcome, outcomes)
        return 1 << lane
    _put_back(shape, lanes, motion, lane)
    return 1 << lane if motion.position[0] != cell else 0


@inlined
def _end(lanes, lane, outcome, outcomes):
    """One that cannot go on."""
    outcomes[lanes.motions[lane]] = outcome
    lanes.masks[GOING] &= ~(1 << lane)


@inlined
def _arrive(
    shape: Shape, memory, slot_of, rules, lanes, motion, k, hold, strobes, counts, stretch, outcomes, record
):
    """The end of a stretch: crossings just there, and the strobe."""
    for lane in range(LANES):
        if (lanes.masks[GOING] >> lane) & 1 == 0:
            continue
        if not _holds(lanes, PROVED, lane):
            _take_out(shape, lanes, motion, lane, 0.0)
            outcome = in_pieces(
                shape, memory, slot_of, rules, motion, 0, k, 0.0, True, hold,
                counts[lanes.motions[lane], stretch], record,
            )  # fmt: skip
            _put_back(shape, lanes, motion, lane)
            if outcome != OK:
                _end(lanes, lane, outcome, outcomes)
        centre, size = _slot(shape, slot_of, _mode(lanes, lane)) + shape.centre, 1.0
        for i in range(1, 1 + shape.n):
            value = lanes.u[LANES * i + lane]
            size += abs(value)
            strobes[lanes.motions[lane], stretch + 1, i - 1] = value + memory[centre + i]
        if not size < HUGE:  # as `_walk.bounded` has it
            _end(lanes, lane, DIVERGED, outcomes)
    lanes.masks[PROVED] = 0


@kernel(
    int64(
        SHAPE, FLOATS, INTS, INTS, INTS, int64, int64, int64, CUBE, CUBE_OF_INTS, INTS, MUTABLE, INTS, INTS,
        MUTABLE, INTS, MATRIX, CUBE, MATRIX, MATRIX, MUTABLE, MUTABLE, MUTABLE, MUTABLE, MUTABLE, MUTABLE,
        INTS, MUTABLE, MUTABLE, MUTABLE, MUTABLE, MUTABLE, MUTABLE, MUTABLE, MUTABLE, MUTABLE, MUTABLE,
        MUTABLE, MUTABLE, MUTABLE, MUTABLE, MUTABLE, INTS, INTS, INTS,
    ),
    alone=True,
)  # fmt: skip
def abreast(
    shape: Shape, memory, slot_of, rules, motions, stretch, done, stretches, strobes, counts, outcomes, hold,
    modes, on, position, used, piece, poly, event, state, work, moved, zc, series, factors, origin, sides, u,
    out, fine, gap, push, moments, powers, jet, near, limit, s, lo, hi, at, seen, verdict, boundary, masks,
):  # fmt: skip
    """Carries the motions with these numbers, up to eight, from phase zero over ``stretches`` of ``stretch``
    base periods each.

    strobes (all motions, rows, n) holds their starts in row ``done`` and receives the states in the rows
    behind, counts (all motions, rows, 5), zero at first, what happened in each stretch from row ``done`` on,
    outcomes (all motions) how each ended: what is written of one that did not end well is of no use. All
    regions that can be met must have been built. The rest is work space (`_march.scratch`, `room`)."""
    lanes = Lanes(
        u, out, fine, gap, push, moments, powers, jet, near, limit, s, lo, hi, at, seen, verdict, boundary,
        masks, motions,
    )  # fmt: skip
    motion = Motion(origin, origin[:0], modes, position, work, moved, zc, series, factors, sides, on)
    record = Record(used, piece, poly, event, state)
    ones(work)
    masks[GOING] = (1 << len(motions)) - 1
    for lane in range(LANES):
        which = motions[lane] if lane < len(motions) else motions[0]
        motion.u[:] = 0.0
        motion.u[0] = 1.0
        for i in range(shape.n):
            motion.u[1 + i] = strobes[which, done, i]
        begin(shape, memory, slot_of, rules, motion, 0, 0.0, 0.0, strobes[which, done:], moved)
        _put_back(shape, lanes, motion, lane)
        _mark(lanes, PROVED, lane, False)
    for i in range(done, done + stretches):
        for cycle in range(stretch):
            passed = _laps(shape, memory, slot_of, lanes)
            if passed == masks[GOING]:
                continue
            for k in range(shape.cells):
                _through_cell(
                    shape, memory, slot_of, rules, lanes, motion, masks[GOING] & ~passed,
                    float(cycle * shape.cells + k), k, hold, counts, i, outcomes, record,
                )  # fmt: skip
        _arrive(shape, memory, slot_of, rules, lanes, motion, 0, hold, strobes, counts, i, outcomes, record)
    return OK
