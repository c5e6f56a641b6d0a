"""Motions in blocks of eight: where they lie, what holds of which, and how they are moved about.

Block 0 is the gather block: what is looked at more closely is gathered there, from all blocks, so that eight
motions do the same thing at the same time. The blocks behind it hold the motions under way."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearlash._kernel.jit import inlined

from ._blocks import LANES, ROWS
from ._motion import FRESH
from ._switch import side_of
from ._tables import FREE, MINUS, PLUS, TERMS, Array, Shape, aligned, aligned_ints
from ._vector import ones_in

BLOCKS = 8  # under way at the same time, at the most: enough that eight motions often do the same
MOST_MOTIONS = LANES * BLOCKS
GATHER_BLOCK = 0


class Lanes(NamedTuple):
    """Value i of the motion in lane l of block b at place 8·(b·rows + i) + l; where there is no block, of
    those on the gather block."""

    u: Array  # (blocks, p): (1, z - c) at the beginning of the cell, under the flow of the present region
    s: Array  # (blocks): where in the cell each is
    motions: np.ndarray  # (blocks) int: their numbers in the arrays of all motions
    masks: np.ndarray  # (blocks·MASK_KINDS) int: of each block, of which lanes something holds, see below
    passed: np.ndarray  # (blocks) int: mask of those that are through the present base period
    queue: np.ndarray  # (3, motions under way) int: what waits for the gather block, by mode
    waiting: np.ndarray  # (3) int: how many do
    out: Array  # (rows): what the table `step` makes of u
    fine: Array  # (TERMS): the `fine_coefficients`
    gap: Array  # (TERMS): X - edge over the cell
    push: Array  # (TERMS): work
    moments: Array  # (TERMS): work
    powers: Array  # (TERMS): of the local time of a crossing
    jet: Array  # (3): value, slope, half the second derivative
    near: Array  # bound on the error of a coefficient
    limit: Array
    lo: Array
    hi: Array
    at: Array  # of the crossing
    seen: Array  # (motions, TERMS): the same as `fine`, motion by motion
    verdict: np.ndarray  # int: of `sign_test`, and
    boundary: np.ndarray  # int: the one that it is about


# places in `masks`; first, at the place of each mode, those that are in it
IN_MID_CELL = 3  # no longer at the beginning of their cell
ON_PLUS, ON_MINUS = 4, 5  # boundary that was crossed where they are
AT_START = 6  # have not left their start
PROVED = 7  # the last cell was proved to be clear
UNDER_WAY = 8  # still under way
MASK_KINDS = 9


def lane_workspace(shape: Shape) -> Lanes:
    """Work space for `Lanes`, in its order."""
    p, rows, blocks = shape.p, shape.rows, BLOCKS + 1
    ints = (LANES * blocks, MASK_KINDS * blocks, blocks, 3 * MOST_MOTIONS, 3)
    sizes = (rows, TERMS, TERMS, TERMS, TERMS, TERMS, 3, 1, 1, 1, 1, 1, TERMS)
    return Lanes(
        *aligned(LANES * blocks * p, LANES * blocks),
        *aligned_ints(*ints),
        *aligned(*(LANES * size for size in sizes)),
        *aligned_ints(LANES, LANES),
    )


@inlined
def used_rows(shape: Shape):
    """Rows of a state that are not there to fill a block, in whole blocks of products. The rest stay zero."""
    return (1 + shape.n + ROWS - 1) // ROWS * ROWS


@inlined
def lowest(mask):
    """Number of the lowest one of a mask."""
    return ones_in((mask & -mask) - 1)


@inlined
def slot_of_mode(shape: Shape, slot_of, mode):
    return shape.slots + slot_of[side_of(mode)] * shape.slot


@inlined
def holds(lanes, b, which, lane):
    """Whether one of the masks of a block has a lane."""
    return (lanes.masks[MASK_KINDS * b + which] >> lane) & 1 != 0


@inlined
def mark(lanes, b, which, lane, value):
    """Puts a lane into one of the masks, or takes it out."""
    place = MASK_KINDS * b + which
    lanes.masks[place] = (lanes.masks[place] & ~(1 << lane)) | (int(value) << lane)


@inlined
def mode_of(lanes, b, lane):
    return PLUS if holds(lanes, b, PLUS, lane) else (MINUS if holds(lanes, b, MINUS, lane) else FREE)


@inlined
def on_boundary(lanes, b, lane):
    """The boundary that was crossed where a motion is, or 0."""
    return 1 if holds(lanes, b, ON_PLUS, lane) else (-1 if holds(lanes, b, ON_MINUS, lane) else 0)


@inlined
def inside(lanes, b, lane):
    """Where in its cell a motion is."""
    return lanes.s[LANES * b + lane] if holds(lanes, b, IN_MID_CELL, lane) else 0.0


@inlined
def alike(lanes, b, pending):
    """The mode of the lowest of these lanes, and those that are in it too."""
    mode = mode_of(lanes, b, lowest(pending))
    return mode, pending & lanes.masks[MASK_KINDS * b + mode]


@inlined
def settle(lanes, b, mask):
    """To the beginning of the next cell: what was crossed, and the start, are behind."""
    for which in (IN_MID_CELL, ON_PLUS, ON_MINUS, AT_START):
        lanes.masks[MASK_KINDS * b + which] &= ~mask
    lanes.masks[MASK_KINDS * b + PROVED] |= mask


@inlined
def transfer(shape: Shape, lanes, source, lane, target, place):
    """A motion from a lane of one block to that of another."""
    for i in range(1 + shape.n):
        lanes.u[LANES * (target * shape.p + i) + place] = lanes.u[LANES * (source * shape.p + i) + lane]
    lanes.s[LANES * target + place] = lanes.s[LANES * source + lane]
    lanes.motions[LANES * target + place] = lanes.motions[LANES * source + lane]
    for which in range(MASK_KINDS):
        mark(lanes, target, which, place, holds(lanes, source, which, lane))


@inlined
def take_out(shape: Shape, lanes, motion, b, lane, cell):
    """One motion to where it can go on alone."""
    for i in range(shape.p):
        motion.u[i] = lanes.u[LANES * (b * shape.p + i) + lane]
    motion.modes[0], motion.on[0] = mode_of(lanes, b, lane), on_boundary(lanes, b, lane)
    motion.position[0], motion.position[1] = cell, inside(lanes, b, lane)
    motion.position[FRESH] = 1.0 if holds(lanes, b, AT_START, lane) else 0.0


@inlined
def put_back(shape: Shape, lanes, motion, b, lane):
    """The motion that went on alone to its lane."""
    for i in range(shape.p):
        lanes.u[LANES * (b * shape.p + i) + lane] = motion.u[i]
    for mode in (PLUS, FREE, MINUS):
        mark(lanes, b, mode, lane, motion.modes[0] == mode)
    lanes.s[LANES * b + lane] = motion.position[1]
    mark(lanes, b, IN_MID_CELL, lane, motion.position[1] != 0.0)
    mark(lanes, b, ON_PLUS, lane, motion.on[0] > 0)
    mark(lanes, b, ON_MINUS, lane, motion.on[0] < 0)
    mark(lanes, b, AT_START, lane, motion.position[FRESH] != 0.0)


@inlined
def end(lanes, b, lane, outcome, outcomes):
    """One that cannot go on."""
    outcomes[lanes.motions[LANES * b + lane]] = outcome
    lanes.masks[MASK_KINDS * b + UNDER_WAY] &= ~(1 << lane)
