"""Numbers of a benchmark as text."""

from __future__ import annotations

from .results import Bar

NOTHING = "–"


def time(seconds: float | None) -> str:
    """A duration in the unit that suits it."""
    if seconds is None:
        return NOTHING
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def ratio(value: float | None) -> str:
    """Times as long."""
    if value is None:
        return NOTHING
    return f"{value:,.0f}" if value >= 100.0 else f"{value:.2g}" if value < 10.0 else f"{value:.1f}"


def error(value: float | None) -> str:
    """Two digits' worth."""
    return NOTHING if value is None else f"{value:.0e}"


def aim(bar: Bar) -> str:
    """What was wanted."""
    return f"{'≥' if bar.at_least else '≤'} {bar.aim:g}"


def measured(bar: Bar) -> str:
    """What came out."""
    least = "" if bar.least is None else f" (least of the repeats {bar.least:.3g})"
    return NOTHING if bar.measured is None else f"{bar.measured:.3g}{least}"


def verdict(bar: Bar) -> str:
    """In a word."""
    return "not measured" if bar.met is None else "met" if bar.met else "missed"
