"""Jumps of a measurement over speed, and the changes of the computed motion that lie at them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearlash.case.measurement import Measurement
from gearlash.system import Record

from .transition import Transition

JUMP = 5.0  # times the median change from one measured speed to the next: a larger one is a jump
SMALLEST_JUMP = 0.1  # of the span of what was measured
APART = 2.0
"""Times the change beside it: a flank climbs in several steps, a peak goes back, a jump does neither."""
NEAR = 2  # usual measured steps: so far from a jump an event may lie that it is put down to
LEAST_OF_A_RUN = 4  # rows one way; shorter ones are how a speed wanders
Array = NDArray[np.float64]
Run = tuple[str, Array, Array]


@dataclass(frozen=True, eq=False, repr=False)
class MeasuredJump(Record):
    """A jump of a measurement, and what may have made it.

    Parameters
    ----------
    direction : str
        ``up`` or ``down``, as the speeds of the rows rise or fall there; empty where they do neither.
    lower, upper : float
        Speeds ω between which it lies.
    change : float
        Of the measured value, upwards in speed.
    events : tuple of (str, Transition)
        Direction of speed and change of the computed motion; those of the same direction first, of these the
        nearest.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> rows = gl.measurement(case, [0.70, 0.72, 0.74, 0.76], [0.2, 0.21, 0.6, 0.61], "mesh_force")
    >>> jump = gl.compare(case, rows, "peak").jumps[0]
    >>> jump.direction, jump.lower, jump.upper
    ('up', 0.72, 0.74)
    """

    direction: str
    lower: float
    upper: float
    change: float
    events: tuple[tuple[str, Transition], ...]


def jumps_of(measurement: Measurement, changes: Sequence[tuple[str, Transition]]) -> tuple[MeasuredJump, ...]:
    """The jumps of every run of a measurement, by speed, with changes of the motion that lie there or
    beside."""
    span = float(np.ptp(measurement.values))
    found = [
        jump
        for way, omega, values in runs_of(measurement.omega, measurement.values)
        for jump in _jumps(way, omega, values, span, changes)
    ]
    return tuple(sorted(found, key=lambda jump: (jump.lower, jump.upper, jump.direction)))


def directions_of(omega: Array) -> tuple[str, ...]:
    """Of every row ``up`` or ``down``, as the speed came to it; empty where it wanders. The first row has the
    direction of the next ones."""
    found = [""] * len(omega)
    for direction, low, high in _stretches(omega):
        for row in range(low if low == 0 else low + 1, high + 1):
            found[row] = direction
    return tuple(found)


def runs_of(omega: Array, values: Array) -> Iterator[Run]:
    """Stretches of rows along which the speed rises or falls, each with its direction, ascending and with the
    mean at speeds that it has several times. Where the speed turns too often it is one run of none."""
    for direction, low, high in _stretches(omega):
        rows = slice(low, high + 1)
        yield direction, *_by_speed(omega[rows], values[rows])


def _stretches(omega: Array) -> Iterator[tuple[str, int, int]]:
    """Direction, first and last row; the row at which the speed turns ends one and begins the next."""
    steps = np.sign(np.diff(omega))
    moved = np.flatnonzero(steps)
    turns = moved[1:][steps[moved][1:] != steps[moved][:-1]]
    ends = [0, *turns.tolist(), len(omega) - 1]
    if len(ends) > 2 and any(high - low < LEAST_OF_A_RUN - 1 for low, high in pairwise(ends)):
        yield "", 0, len(omega) - 1
        return
    for low, high in pairwise(ends):
        yield "up" if omega[high] > omega[low] else "down", low, high


def _by_speed(omega: Array, values: Array) -> tuple[Array, Array]:
    once, place = np.unique(omega, return_inverse=True)
    return once, np.bincount(place, values) / np.bincount(place)


def _jumps(
    direction: str, omega: Array, values: Array, span: float, changes: Sequence[tuple[str, Transition]]
) -> Iterator[MeasuredJump]:
    """Changes that are much larger than most, and than those beside them."""
    changed = np.diff(values)
    if not len(changed):
        return
    usual, step = float(np.median(np.abs(changed))), float(np.median(np.diff(omega)))
    for at, (low, high) in enumerate(pairwise(omega.tolist())):
        missing = max(0.0, (high - low) / step - 1.0)  # steps without a row: values change over them, too
        least = max((JUMP + missing) * usual, SMALLEST_JUMP * span)
        if abs(changed[at]) <= least or not _alone(changed, at, missing):
            continue
        width = NEAR * min(high - low, step)
        near = [
            (direction not in ("", way), max(low - change.upper, change.lower - high, 0.0), way, change)
            for way, change in changes
            if change.upper >= low - width and change.lower <= high + width
        ]
        near.sort(key=lambda one: one[:2])
        events = tuple((way, change) for _, _, way, change in near)
        yield MeasuredJump(direction, low, high, float(changed[at]), events)


def _alone(changed: Array, at: int, missing: float) -> bool:
    """Whether a change, over so many missing steps, stands out from those beside it: from ones that go the
    same way, as on a flank, and from ones that take it back, as behind a peak of one row."""
    beside = [abs(changed[i]) for i in (at - 1, at + 1) if 0 <= i < len(changed)]
    return abs(changed[at]) > (APART + missing) * max(beside, default=0.0)
