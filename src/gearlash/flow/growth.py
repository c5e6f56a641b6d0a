"""Marching with one tangent: where the motion goes, and how fast its neighbours leave it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import Record, Status, System, given

from .march import start_state
from .propagators import Propagators, propagators_of
from .run import LONGEST_STRETCH, STATUS, block_of, columns_of, run_all

Array = NDArray[np.float64]

CELLS_PER_PART = 64  # a tangent grows or shrinks by some e² in a cell, so by e^128 at most in a part


@dataclass(frozen=True, eq=False, repr=False)
class Growth(Record):
    """States (periods+1, n) at phase zero of every base period; the unit tangent (n,) at the end; the
    logarithms (m,) of its growth over stretches of ``lengths`` (m,) base periods; `undecided` counts places
    where touching lies within rounding."""

    states: Array
    tangent: Array
    logarithms: Array
    lengths: NDArray[np.int64]
    undecided: int
    status: Status


def growth(
    system: System | Propagators, start: ArrayLike, tangent: ArrayLike, periods: int, stretch: int
) -> Growth:
    """Marches from phase zero over ``periods`` base periods, in stretches of ``stretch`` of them; the last
    one may be shorter. Ends early, with its status, where the motion could not be carried on. In a period of
    very many cells the tangent is made a unit vector again several times, so that it neither vanishes nor
    overflows."""
    props = propagators_of(system)
    state = start_state(props, start)
    frame = given.numbers("tangent", tangent, (len(state),))[None]
    periods, stretch = given.whole("periods", periods, 0, LONGEST_STRETCH), given.whole("stretch", stretch)
    states, sums = np.empty((periods + 1, len(state))), np.zeros(periods)
    states[0] = state
    counts = np.zeros((periods, columns_of(props)), dtype=np.int64)
    parts, most = _parts(props), block_of(props, 1)
    done, status = 0, Status.OK
    while done < periods and status.ok:
        block = min(most, periods - done)
        strobes = np.empty((1, block * parts + 1, len(state)))
        happened = np.zeros((1, block * parts, counts.shape[1]), dtype=np.int64)
        logarithms = np.zeros(block * parts)
        outcome = run_all(props, state[None], 0.0, props.cells / parts, strobes, happened, frame, logarithms)
        status, end = STATUS[int(outcome[0])], done + block
        states[done + 1 : end + 1] = strobes[0, parts::parts]
        counts[done:end] = happened[0].reshape(block, parts, -1).sum(axis=1)
        sums[done:end] = logarithms.reshape(block, parts).sum(axis=1)
        done = end
    undecided = int(counts[:, -1].sum())
    if status.ok and undecided:
        status = Status.UNCERTAIN
    starts = np.arange(0, periods, stretch)
    logarithms, lengths = np.add.reduceat(sums, starts), np.minimum(stretch, periods - starts)
    return Growth(states[: done + 1], frame[0], logarithms, lengths, undecided, status)


def _parts(props: Propagators) -> int:
    """How often in a base period the tangent is given its length again: a power of two, so that the parts of
    a period are exact."""
    parts = 1
    while props.cells > CELLS_PER_PART * parts:
        parts *= 2
    return parts
