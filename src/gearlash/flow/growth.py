"""Marching with one tangent: where the motion goes, and how fast its neighbours leave it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import Status

from .march import _run, start_state
from .propagators import Propagators

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Growth:
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
    state = start_state(z, props.system.size)
    frame = np.array(tangent, dtype=np.float64)[None]
    lengths = [stretch] * (periods // stretch) + ([periods % stretch] if periods % stretch else [])
    parts, logarithms, undecided, status = [state[None].copy()], np.zeros(len(lengths)), 0, Status.OK
    for i, length in enumerate(lengths):
        status, strobes, counts = _run(
            props, state, 0.0, float(props.cells), length, tangents=frame, sums=logarithms[i : i + 1]
        )
        parts.append(strobes[1:])
        undecided += int(counts[:, -1].sum())
        if not status.ok:
            break
    if status.ok and undecided:
        status = Status.UNCERTAIN
    return Growth(
        np.concatenate(parts), frame[0], logarithms, np.array(lengths, dtype=np.int64), undecided, status
    )
