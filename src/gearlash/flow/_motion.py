"""What moves: its state, where it is, in which region.

A position is counted in cells from phase zero of the base period: an integer cell and a local time s in [0,
1]. The state is that at the beginning of its cell, under the flow of its present region: where a crossing has
happened in the cell this is no state the motion was in, but the one that leads to it (`_switch`)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearlash._kernel.jit import inlined, inner

from ._switch import region_code, side_of
from ._tables import Array, Shape
from ._vector import linear, move

OK, TOO_MANY, DIVERGED, NEED_REGION = 0, 1, 2, 3
DIVERGED_BEYOND = 1e200
NEEDED, FRESH = 4, 5  # places in `position`


class MotionState(NamedTuple):
    """What moves, and work space; all arrays are changed in place."""

    u: Array  # (p): (1, z - c) at the beginning of the cell, under the flow of the present region
    tangents: Array  # (m·p): (0, v) likewise
    modes: np.ndarray  # (clearances) int
    # (6): cell, s; cell and s of the end of the stretch; number of a region that is needed; 1 where the
    # motion has only just been put there
    position: Array
    work: Array  # see `_workspace`
    moved: Array  # (rows + clearances·TERMS)
    zc: Array  # ((ORDER+1)·p)
    series: Array  # see `_expand`
    factors: Array  # (n + clearances)
    sides: np.ndarray  # (clearances) int
    on: np.ndarray  # (clearances) int: the boundary ±1 that was crossed at the present position, or 0


@inlined
def slot_place(shape: Shape, slot_of, modes):
    """Where the slot of the present region begins, or -1 where it is not built yet."""
    slot = slot_of[region_code(modes)]
    return shape.slots + slot * shape.slot if slot >= 0 else -1


@inner
def bounded(u, p):
    """Whether a state has not grown beyond every bound, nor become NaN."""
    size = 0.0
    for i in range(p):
        size += abs(u[i])
    return size < DIVERGED_BEYOND


@inner
def forget_crossed(motion):
    """What was crossed, and the start itself, are behind."""
    motion.position[FRESH] = 0.0
    for c in range(len(motion.on)):
        motion.on[c] = 0


@inner
def sides_of(motion):
    """Fills `sides` from the modes."""
    for c in range(len(motion.modes)):
        motion.sides[c] = side_of(motion.modes[c])


@inner
def apply_map(shape: Shape, memory, table, stride, u, tangents, m, moved):
    """State and tangents over one cell or lap, by the table that begins at a place."""
    linear(memory, table, stride, shape.p, 1 + shape.n, u, 0, moved, 0)
    move(moved, 0, u, 0, shape.p)
    if m > 0:
        map_tangents(shape, memory, table, stride, tangents, m, moved)


@inner
def map_tangents(shape: Shape, memory, table, stride, tangents, m, moved):
    """Tangents alone."""
    for v in range(m):
        linear(memory, table, stride, shape.p, 1 + shape.n, tangents, v * shape.p, moved, 0)
        move(moved, 0, tangents, v * shape.p, shape.p)
