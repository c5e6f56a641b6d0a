"""Room for the results that callers ask for, refused in words where there is not as much."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearlash.system import GearlashError


def empty(*shape: int) -> NDArray[np.float64]:
    """Room for results that a caller asked for."""
    try:
        return np.empty(shape)
    except (MemoryError, ValueError):
        size = float(np.prod([float(length) for length in shape])) * 8.0 / 2**30
        raise GearlashError(
            f"results of shape {shape} need {size:.3g} GiB, more than there is: march in parts, or keep "
            "fewer states with a longer stretch"
        ) from None
