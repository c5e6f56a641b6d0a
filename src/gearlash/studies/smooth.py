"""Which neighbours in a sweep are plainly on one branch, from the states that the sweep has kept."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from gearlash.system import Label

STRAIGHT = 0.03  # of a step: what a point may lie beside the curve through those on the other side
BOTH_SIDES = 3  # points of a curve


class Stated(Protocol):
    @property
    def value(self) -> float: ...
    @property
    def label(self) -> Label | None: ...
    @property
    def period(self) -> int: ...
    @property
    def state(self) -> NDArray[np.float64]: ...


def plainly_one(points: Sequence[Stated], i: int) -> bool:
    """Whether points ``i`` and ``i + 1`` need no closer look: with the three before and the three after they
    have one label, and each of the two lies where the three on the other side of the gap point to, to a few
    per cent of the step between them. A jump would have to be smaller than that."""
    if not BOTH_SIDES <= i + 1 <= len(points) - BOTH_SIDES:
        return False
    around = points[i + 1 - BOTH_SIDES : i + 1 + BOTH_SIDES]
    if not around[0].period or len({point.label for point in around}) > 1:
        return False
    values = np.array([point.value for point in around])
    states = np.array([point.state for point in around])
    if not (np.diff(values) > 0.0).all() or not np.isfinite(states).all():
        return False
    steps = np.abs(np.diff(states, axis=0))
    unit = np.maximum(steps[BOTH_SIDES - 1], 1e-3 * steps.max(axis=0)) + 1e-9
    before, after = slice(0, BOTH_SIDES), slice(BOTH_SIDES, 2 * BOTH_SIDES)
    ahead = _parabola(values[before], states[before], values[BOTH_SIDES])
    back = _parabola(values[after], states[after], values[BOTH_SIDES - 1])
    beside = np.maximum(np.abs(ahead - states[BOTH_SIDES]), np.abs(back - states[BOTH_SIDES - 1]))
    return bool((beside <= STRAIGHT * unit).all())


def _parabola(values: NDArray[np.float64], states: NDArray[np.float64], at: float) -> NDArray[np.float64]:
    """Through three states, at a value."""
    a, b, c = values
    weights = [
        (at - b) * (at - c) / ((a - b) * (a - c)),
        (at - a) * (at - c) / ((b - a) * (b - c)),
        (at - a) * (at - b) / ((c - a) * (c - b)),
    ]
    return np.asarray(weights) @ states
