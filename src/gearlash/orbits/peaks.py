"""The largest of what is read at some places of every piece of a motion, and read once more, closely, around
the highest readings."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Places = NDArray[np.int64]

AROUND = 3  # readings on either side of a high one, between which is read once more
CLOSER = np.linspace(0.0, 1.0, 61)
BETWEEN = 0.02  # of the span: more than a peak can be above the readings beside it, 12 a piece
MOST = 8  # peaks that are looked at, the highest readings first


def largest(readings: Array, closer: Callable[[Places, Places], Array]) -> float:
    """The largest value, from readings (pieces, local times). ``closer`` reads at `CLOSER` between two
    readings of a piece, given by their places in the flat array, both (m, 1).

    The largest reading need not be beside the largest peak: all are looked at whose reading is near to it."""
    flat = readings.ravel()
    peaks = np.flatnonzero((flat >= np.roll(flat, 1)) & (flat >= np.roll(flat, -1)))
    high = peaks[flat[peaks] >= flat.max() - BETWEEN * np.ptp(flat)]
    high = high[np.argsort(-flat[high], kind="stable")[:MOST]]
    found = [window for place in high.tolist() for window in _windows(place, *readings.shape)]
    first, last = (np.array(column)[:, None] for column in zip(*dict.fromkeys(found), strict=True))
    return max(*map(top, closer(first, last)), float(flat.max()))


def top(values: Array) -> float:
    """The largest of equally spaced values, refined by the parabola through it and its neighbours, or, at an
    end, through the last three, where its vertex lies among them."""
    highest = int(np.argmax(values))
    middle = min(max(highest, 1), len(values) - 2)
    before, here, after = (float(v) for v in values[middle - 1 : middle + 2])
    bend, slope = before - 2.0 * here + after, after - before
    within = bend < 0.0 and abs(slope) <= -2.0 * bend
    vertex = here - slope * slope / (8.0 * bend) if within else -np.inf
    return max(float(values[highest]), vertex)


def _windows(place: int, pieces: int, each: int) -> list[tuple[int, int]]:
    """First and last reading, in each piece, of those around one. A quantity may jump or bend where contact
    begins or ends, so that no parabola may reach over the end of a piece. The first reading follows the last
    one, as in a motion that repeats itself."""
    near = [(place + step) % (pieces * each) for step in range(-AROUND, AROUND + 1)]
    parts = [[one for one in near if one // each == piece] for piece in {one // each for one in near}]
    return sorted((min(part), max(part)) for part in parts)
