"""Units as they are printed."""

from __future__ import annotations

PRETTY = {"um": "µm", "N*m": "N·m", "kg*m^2": "kg·m²", "deg": "°"}


def pretty(unit: str) -> str:
    """``um`` → ``µm``, ``N*m`` → ``N·m``."""
    return PRETTY.get(unit, unit)
