"""Physical numbers in the unit that reads best, where nobody asked for one."""

from __future__ import annotations

LEAST, MOST = 1e-2, 1e4
"""A number from the one to below the other is written in its own unit."""
PREFIXES = {
    "µm": (("nm", 1e-3), ("mm", 1e3), ("m", 1e6)),
    "N": (("mN", 1e-3), ("kN", 1e3), ("MN", 1e6)),
    "N·m": (("mN·m", 1e-3), ("kN·m", 1e3), ("MN·m", 1e6)),
    "mm/s": (("µm/s", 1e-3), ("m/s", 1e3)),
    "ms": (("µs", 1e-3), ("s", 1e3)),
}
"""Units beside a unit, ascending, with their size in it."""


def readable(value: float, unit: str) -> tuple[float, str]:
    """A finite number in a unit of the same kind in which it is neither long nor tiny; as it is where its own
    unit will do, or where no other is known."""
    size = abs(value)
    if size == 0.0 or LEAST <= size < MOST:
        return value, unit
    others = [(name, factor) for name, factor in PREFIXES.get(unit, ()) if (factor > 1.0) == (size >= MOST)]
    if not others:
        return value, unit
    name, factor = next((one for one in others if size / one[1] < MOST), others[-1])
    return value / factor, name
