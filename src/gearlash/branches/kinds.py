"""The bifurcation types of the article's Table 2."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

STANDARD = "standard grazing"
CODIMENSION_TWO = "co-dimension-2 grazing"
SMOOTH = "smooth"
CRITICAL = 1e-3  # |λ ± 1| below which a grazing point counts as coincident with a doubling or a fold


def distance_to_unit(multipliers: NDArray[np.complex128]) -> tuple[float, float]:
    """(least |λ + 1|, least |λ - 1|) over all multipliers."""
    return float(np.abs(multipliers + 1.0).min()), float(np.abs(multipliers - 1.0).min())


def table2_type(multipliers: NDArray[np.complex128], critical: float = CRITICAL) -> str:
    """Type of a grazing point by Table 2: standard where the largest exponent is negative and the period goes
    on, co-dimension 2 where a multiplier is at ±1 within ``critical`` (the largest exponent is then about
    zero)."""
    return CODIMENSION_TWO if min(distance_to_unit(multipliers)) < critical else STANDARD
