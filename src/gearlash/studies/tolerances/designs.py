"""Which combinations of inputs are looked at: points of scrambled Sobol sequences, corners of the limits.

I. M. Sobol, USSR Comput. Math. Math. Phys. 7 (1967) 86, doi:10.1016/0041-5553(67)90144-9; scrambled after
A. B. Owen, J. Complexity 14 (1998) 466, doi:10.1006/jcom.1998.0487, by `scipy.stats.qmc`.
"""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import NDArray
from scipy.stats import qmc

from gearlash.results.tolerance import ToleranceInput

SEED = 20_000
MOST_CORNERED = 6  # inputs of which every corner is looked at
Points = NDArray[np.float64]


def samples(
    inputs: tuple[ToleranceInput, ...], count: int, replicates: int, columns: int = 1
) -> list[Points]:
    """Independent sets of points between the limits, each of shape (columns, count, inputs)."""
    size = len(inputs)
    found = []
    for one in range(replicates):
        engine = qmc.Sobol(columns * size, scramble=True, rng=np.random.default_rng([SEED, columns, one]))
        unit = engine.random(count).reshape(count, columns, size).swapaxes(0, 1)
        found.append(_between(inputs, unit))
    return found


def corners(inputs: tuple[ToleranceInput, ...]) -> Points:
    """All corners of the limits; with many inputs those that differ from the middle in one of them."""
    size = len(inputs)
    if size <= MOST_CORNERED:
        return _between(inputs, np.array(list(product((0.0, 1.0), repeat=size))))
    points = np.full((2 * size, size), 0.5)
    for i in range(size):
        points[2 * i, i], points[2 * i + 1, i] = 0.0, 1.0
    return _between(inputs, points)


def _between(inputs: tuple[ToleranceInput, ...], unit: Points) -> Points:
    lower = np.array([one.lower for one in inputs])
    upper = np.array([one.upper for one in inputs])
    return lower + (upper - lower) * unit
