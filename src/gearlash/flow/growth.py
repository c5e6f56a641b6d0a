"""Marching with one tangent: where the motion goes, and how fast its neighbours leave it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import Record, Status

from .march import CALL, STATUS, columns_of, run_all, start_state
from .propagators import Propagators

Array = NDArray[np.float64]


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


def growth(props: Propagators, z: ArrayLike, tangent: ArrayLike, periods: int, stretch: int) -> Growth:
    """Marches from phase zero over ``periods`` base periods, in stretches of ``stretch`` of them and what is
    left. Ends early, with its status, where the motion could not be carried on."""
    state = start_state(props, z)
    frame = np.array(tangent, dtype=np.float64)[None]
    states, sums = np.empty((periods + 1, len(state))), np.zeros(periods)
    states[0] = state
    counts = np.zeros((periods, columns_of(props)), dtype=np.int64)
    done, status = 0, Status.OK
    while done < periods and status.ok:
        end = min(done + CALL, periods)
        outcome = run_all(
            props, state[None], 0.0, float(props.cells), states[None, done : end + 1], counts[None, done:end],
            frame, sums[done:end],
        )  # fmt: skip
        status, done = STATUS[int(outcome[0])], end
    undecided = int(counts[:, -1].sum())
    if status.ok and undecided:
        status = Status.UNCERTAIN
    starts = np.arange(0, periods, stretch)
    logarithms, lengths = np.add.reduceat(sums, starts), np.minimum(stretch, periods - starts)
    return Growth(states[: done + 1], frame[0], logarithms, lengths, undecided, status)
