"""How near the multipliers of a periodic orbit are to those at which it doubles or folds."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def distance_to_unit(multipliers: NDArray[np.complex128]) -> tuple[float, float]:
    """(least |λ + 1|, least |λ - 1|) over all multipliers: 0 at a doubling, and at a fold."""
    return float(np.abs(multipliers + 1.0).min()), float(np.abs(multipliers - 1.0).min())
