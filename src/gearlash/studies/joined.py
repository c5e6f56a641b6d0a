"""Between which neighbours of sweeps no line may be drawn, because the motion changed over to another one."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from time import monotonic

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import ContinuationSettings
from gearlash.case import Case
from gearlash.jobs import Progress, ProgressCallback, stopping
from gearlash.results import Direction, Sweep
from gearlash.results.steps import Rows, apart, doubtful, one_motion

from .model import Model
from .transition import GRAZING, Transition
from .transitions import by_step

LONG = ContinuationSettings(first=0.02, longest=1.0, certify=False, most_points=20_000)
"""Whether a motion goes on is asked, not where it touches: so steps are as long as angle and contraction of
the branch let them be. Where a member is built from a drawing, each costs a tenth of a second and more."""
Flags = NDArray[np.bool_]


def apart_in(
    model: Model, sweeps: Sequence[Sweep], progress: ProgressCallback | None = None
) -> tuple[Flags, ...]:
    """Steps (m-1,) of every sweep over which the motion does not go on. That of each step that is not small,
    or where the ways part or meet, is followed from one point to the other; a touch on the way is no end.
    Where every value makes another pair from a drawing that would take minutes: there only the points tell.

    Parameters
    ----------
    model : Case or Family
    sweeps : sequence of Sweep
        Over one axis.
    progress : callable, optional
        Is called after every step that was looked at.

    Returns
    -------
    tuple of ndarray of bool
    """
    rows = Rows.of_sweeps(sweeps)
    if isinstance(model, Case) and model.content.rebuilt(sweeps[0].axis.name):
        return tuple(apart(rows))
    told, look = apart(rows), doubtful(rows)
    told &= look | ~rows.periodic()
    began, done, total = monotonic(), 0, int(np.count_nonzero(look))
    for i, sweep in enumerate(sweeps):
        alike = [one_motion(rows, i, k) for k in range(i)]
        for at in np.flatnonzero(look[i]).tolist():
            if stopping():
                return tuple(told)
            known = next((k for k, same in enumerate(alike) if same[at] and same[at + 1]), None)
            told[i, at] = _parts(model, sweep, at) if known is None else told[known, at]
            done, elapsed = done + 1, monotonic() - began
            if progress is not None:
                progress(Progress(done, total, elapsed, elapsed / done * (total - done)))
    return tuple(told)


def _parts(model: Model, sweep: Sweep, at: int) -> bool:
    rising, fixed = sweep.direction is not Direction.DOWN, dict(sweep.fixed)
    pair, name = sweep.points[at : at + 2], sweep.axis.name
    found = by_step(model, name, pair, values=fixed, rising=rising, steps=LONG)
    return any(parts(changes) for _, changes in found)


def apart_at(sweep: Sweep, changes: Sequence[Transition]) -> Flags:
    """The same of one sweep, where all changes along it are known."""
    rows, values = Rows.of_sweeps([sweep]), sweep.axis.values
    inside = [
        [each for each in changes if low <= each.value <= high] for low, high in pairwise(values.tolist())
    ]
    known = np.array([parts(some) for some in inside], dtype=bool)
    return np.where(rows.periodic()[0], known, apart(rows)[0])


def parts(changes: Sequence[Transition]) -> bool:
    """Whether a motion ends with one of these changes: at a touch alone it goes on."""
    return any(change.kind != GRAZING for change in changes)
