"""The march through cells: a whole cell by one product where no boundary can be reached; with the sign test
(`_sign_test`) where one can; event by event (`_cell_events`) where the sign test is not enough."""

from __future__ import annotations

import numpy as np

from gearlash._kernel.jit import inlined, inner

from ._assemble import fine_coefficients
from ._cell_events import cell_events, cross
from ._motion import DIVERGED, OK, apply_map, bounded, forget_crossed, map_tangents, slot_place
from ._root_isolation import NO_ROOT
from ._sign_test import CLEAR, UNSURE
from ._surfaces import cell_verdict, one_crossing, stays
from ._tables import FREE, MINUS, PLUS, TERMS, Shape
from ._vector import add, linear, move, weigh

MIN_SEPARATION = 1e-9  # of a cell: crossings that are nearer are taken one by one, in pieces


@inlined
def _all_verdicts(shape: Shape, memory, slot, k, rules, motion, begun):
    """What the sign test proves of a cell, or of the rest of it where it has ``begun``: no exit (`CLEAR`),
    an exit of one clearance (a verdict of `sign_test`, clearance, boundary), or `UNSURE`: exits of several
    clearances, or nothing certain. Then the cell is gone through event by event."""
    verdict, which, through = CLEAR, 0, 0
    for c in range(shape.clearances):
        found, boundary = cell_verdict(
            shape, memory, slot, k, c, motion.modes[c], rules[c], motion.on[c], begun, motion.u, motion.moved
        )
        if found != CLEAR:
            if verdict != CLEAR:
                return UNSURE, 0, 0
            verdict, which, through = found, c, boundary
    return verdict, which, through


@inlined
def _by_sign_test(shape: Shape, memory, slot, k, rules, motion, m, begun):
    """`_all_verdicts` of cell k; carries the motion over it where nothing comes."""
    u, moved = motion.u, motion.moved
    fine_coefficients(shape, memory, slot, k, u, 0, moved, shape.rows)
    verdict, which, boundary = _all_verdicts(shape, memory, slot, k, rules, motion, begun)
    if verdict == CLEAR:
        step = slot + shape.step + k * (1 + shape.n) * shape.rows
        linear(memory, step, shape.rows, shape.p, 1 + shape.n, u, 0, moved, 0)
        move(moved, 0, u, 0, shape.p)
        if m > 0:
            map_tangents(shape, memory, step, shape.rows, motion.tangents, m, moved)
        forget_crossed(motion)
    return verdict, which, boundary


@inner
def _earliest_crossing(shape: Shape, memory, slot, k, rules, motion, s):
    """The first of the crossings of several clearances from s on, where every one of them is certain and no
    other is too near to say which comes first: (time or `NO_ROOT`, clearance, boundary)."""
    at, after, which, through = NO_ROOT, NO_ROOT, 0, 0
    for c in range(shape.clearances):
        verdict, boundary = cell_verdict(
            shape, memory, slot, k, c, motion.modes[c], rules[c], motion.on[c], s > 0.0, motion.u,
            motion.moved,
        )  # fmt: skip
        if verdict == CLEAR:
            continue
        if verdict == UNSURE:
            return NO_ROOT, 0, 0
        there = one_crossing(
            shape, memory, slot, k, c, motion.modes[c], boundary, verdict, s, motion.u, motion.moved,
            shape.rows + TERMS * c, motion.work,
        )  # fmt: skip
        if there == NO_ROOT:
            return NO_ROOT, 0, 0
        if there < at:
            at, after, which, through = there, at, c, boundary
        elif there < after:
            after = there
    return (at, which, through) if after - at > MIN_SEPARATION else (NO_ROOT, 0, 0)


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
                    forget_crossed(motion)
                if passed == left:
                    continue
                verdict, which, boundary = _by_sign_test(shape, memory, slot, k, rules, motion, m, False)
                if verdict == CLEAR:
                    cell, s, proved = cell + 1, 0.0, True
                    k = k + 1 if k + 1 < cells else 0
                    continue
            else:  # in a place of its own: what is found here is another thing, and so can be foreseen
                verdict, which, boundary = _by_sign_test(shape, memory, slot, k, rules, motion, m, True)
                if verdict == CLEAR:
                    cell, s, proved = cell + 1, 0.0, True
                    k = k + 1 if k + 1 < cells else 0
                    continue
            at = NO_ROOT
            if verdict != UNSURE:
                at = one_crossing(
                    shape, memory, slot, k, which, modes[which], boundary, verdict, s, u, moved,
                    shape.rows + TERMS * which, motion.work,
                )  # fmt: skip
            elif shape.clearances > 1:
                at, which, boundary = _earliest_crossing(shape, memory, slot, k, rules, motion, s)
            if at != NO_ROOT:
                motion.position[0], motion.position[1] = cell, s
                behind = FREE if modes[which] != FREE else (PLUS if boundary > 0 else MINUS)
                outcome = cross(
                    shape, memory, slot_of, slot, rules, motion, m, k, at, which, boundary, behind,
                    False, False, counts, record,
                )  # fmt: skip
                if outcome != OK:
                    return outcome
                forget_crossed(motion)
                motion.on[which], s, proved = boundary, at, False
                slot = slot_place(shape, slot_of, modes)
                continue
        motion.position[0], motion.position[1], proved = cell, s, False
        outcome = cell_events(
            shape, memory, slot_of, rules, motion, m, k, end, arriving, hold, counts, record
        )
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
            map_tangents(shape, memory, step, shape.rows, motion.tangents, m, moved)
        passed += 1
        k = k + 1 if k + 1 < cells else 0
    return passed, k


@inner
def _over_laps(shape: Shape, memory, slot, motion, m, most):
    """Carries a motion over whole base periods that are proved to be clear; returns their number."""
    for passed in range(most):
        if not _lap(shape, memory, slot, motion.modes, motion.u, motion.moved):
            return passed
        apply_map(shape, memory, slot + shape.lap, shape.p, motion.u, motion.tangents, m, motion.moved)
    return most


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
