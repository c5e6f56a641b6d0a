"""Any object in a few characters: for error texts, and for what a result prints of itself."""

from __future__ import annotations

import reprlib
from collections.abc import Mapping
from enum import Enum
from typing import Any

import numpy as np

LONGEST_TEXT = 60
FEW = 6  # numbers of an array that are shown; of longer ones its shape


class _Short(reprlib.Repr):
    """`reprlib`'s, which survives a `__repr__` that raises, in one line."""

    def __init__(self) -> None:
        super().__init__()
        self.maxstring = self.maxother = self.maxlong = LONGEST_TEXT

    def repr_int(self, x: int, level: int) -> str:
        if x.bit_length() > 13_000:  # Python itself refuses to print 5000 digits
            return f"a whole number of about {int(x.bit_length() * 0.30103) + 1} digits"
        return repr(x)


_short = _Short()


def shown(value: object) -> str:
    """A value as it stands in an error text: its repr in one line, cut to a readable length."""
    text = _short.repr(value)
    return cut(" ".join(text.split()))


def brief(value: Any) -> str:
    """A value as a result tells it: numbers to six digits, long arrays and collections by their size."""
    if isinstance(value, Enum):
        return shown(str(value.value))
    if isinstance(value, (bool, np.bool_)) or value is None:
        return str(value)
    if isinstance(value, (float, complex, np.inexact)):
        return f"{value:.6g}"
    if isinstance(value, np.ndarray):
        return _array(value)
    if isinstance(value, Mapping):
        parts = [f"{key}: {brief(each)}" for key, each in list(value.items())[: FEW + 1]]
        return _collected(parts, len(value), "{}")
    if isinstance(value, (tuple, list)):
        return _collected([brief(each) for each in value[: FEW + 1]], len(value), "()")
    if callable(value) and hasattr(value, "__qualname__"):
        return cut(value.__qualname__)
    return shown(value)


def cut(text: str, longest: int = LONGEST_TEXT) -> str:
    """The text, cut to at most ``longest`` characters."""
    return text if len(text) <= longest else text[: longest - 1] + "…"


def _array(value: np.ndarray) -> str:
    if value.ndim == 1 and value.size <= FEW:
        return f"[{', '.join(brief(each) for each in value.tolist())}]"
    return f"array of shape {value.shape}"


def _collected(parts: list[str], count: int, ends: str) -> str:
    text = f"{ends[0]}{', '.join(parts)}{ends[1]}"
    return text if count <= FEW and len(text) <= LONGEST_TEXT else f"{count} of them"
