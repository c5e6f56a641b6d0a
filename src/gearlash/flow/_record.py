"""What a trace keeps of a motion."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearlash._kernel.jit import inner

from ._expand import carry_inside, expand
from ._motion import sides_of
from ._tables import ORDER, Array, Shape


class Record(NamedTuple):
    """What a trace keeps: every piece as a polynomial, every contact event."""

    used: np.ndarray  # (2) int: pieces, events; the first is -1 where nothing is kept
    piece: Array  # (pieces, 2 + clearances): position of its start, length in cells, modes
    poly: Array  # (pieces, ORDER+1, n)
    event: Array  # (events, 4): position, clearance, boundary ±1, engaging 1 or 0
    state: Array  # (events, n)


@inner
def keep_event(shape: Shape, memory, slot, motion, k, at, which, boundary, engaging, record):
    """Writes an event down. False where there is no room for it."""
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
def keep_piece(shape: Shape, memory, slot, motion, k, start, end, record):
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
