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
NEAR = 2  # measured steps: so far from a jump an event may lie that it is put down to
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


def runs_of(omega: Array, values: Array) -> Iterator[Run]:
    """Stretches of rows along which the speed rises or falls, each with its direction, ascending and with the
    mean at speeds that it has several times. Where the speed turns too often it is one run of none."""
    steps = np.sign(np.diff(omega))
    moved = np.flatnonzero(steps)
    turns = moved[1:][steps[moved][1:] != steps[moved][:-1]]  # the row at which it goes the other way
    ends = [0, *turns.tolist(), len(omega) - 1]
    if len(ends) > 2 and any(high - low < LEAST_OF_A_RUN - 1 for low, high in pairwise(ends)):
        yield "", *_by_speed(omega, values)
        return
    for low, high in pairwise(ends):
        rows = slice(low, high + 1)
        direction = "up" if omega[high] > omega[low] else "down"
        yield direction, *_by_speed(omega[rows], values[rows])


def _by_speed(omega: Array, values: Array) -> tuple[Array, Array]:
    once, place = np.unique(omega, return_inverse=True)
    return once, np.bincount(place, values) / np.bincount(place)


def _jumps(
    direction: str, omega: Array, values: Array, span: float, changes: Sequence[tuple[str, Transition]]
) -> Iterator[MeasuredJump]:
    """Changes that are much larger than most."""
    steps = np.abs(np.diff(values))
    if not len(steps):
        return
    least = max(JUMP * float(np.median(steps)), SMALLEST_JUMP * span)
    for at, (low, high) in enumerate(pairwise(omega.tolist())):
        if steps[at] <= least:
            continue
        width = NEAR * (high - low)
        near = [
            (direction not in ("", way), max(low - change.upper, change.lower - high, 0.0), way, change)
            for way, change in changes
            if change.upper >= low - width and change.lower <= high + width
        ]
        near.sort(key=lambda one: one[:2])
        events = tuple((way, change) for _, _, way, change in near)
        yield MeasuredJump(direction, low, high, float(values[at + 1] - values[at]), events)
