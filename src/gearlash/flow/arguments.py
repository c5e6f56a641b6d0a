"""What callers hand over, checked once where it enters, and refused in words."""

from __future__ import annotations

from operator import index
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import GearlashError


def whole(name: str, value: Any, least: int = 1) -> int:
    """A whole number of at least so much."""
    try:
        number = index(value)
    except TypeError:
        number = least - 1
    if number < least:
        raise GearlashError(f"{name} is {value!r}: expected a whole number, {least} or more")
    return number


def finite(name: str, value: ArrayLike, shape: tuple[int | str, ...]) -> NDArray[np.float64]:
    """A fresh array of finite numbers of this shape; a word stands for any length."""
    expected = f"({', '.join(map(str, shape))}{',' if len(shape) == 1 else ''})"
    try:
        numbers = np.array(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise GearlashError(f"{name}: expected numbers of shape {expected}, not {value!r:.60}") from None
    fits = numbers.ndim == len(shape) and all(
        isinstance(there, str) or here == there for here, there in zip(numbers.shape, shape, strict=True)
    )
    if not fits:
        raise GearlashError(f"{name} has shape {numbers.shape}, expected {expected}")
    if not np.isfinite(numbers).all():
        raise GearlashError(f"{name} holds NaN or infinity")
    return numbers


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
