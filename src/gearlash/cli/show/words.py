"""Words of gears where a gap is the one between two meshing gears, and words of any system elsewhere."""

from __future__ import annotations

SIGNS = {"drive": "side +", "back": "side -"}


def cycles(count: float, teeth: bool) -> str:
    """``1 mesh cycle``, ``6 cycles``."""
    return f"{count:g} {'mesh ' if teeth else ''}cycle{'s' if count != 1 else ''}"


def side(name: str, teeth: bool) -> str:
    """``drive``, ``side +``."""
    return name if teeth else SIGNS[name]
