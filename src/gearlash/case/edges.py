"""How the end of an interval is rounded: into the interval, and to the same number wherever it is shown."""

from __future__ import annotations

from math import ceil, floor, isfinite, log10

DIGITS = 4  # significant ones of an end, at least
MOST_DECIMALS = 15  # decimals
COARSEST = 0.01  # of the distance to the present value: no rounding is coarser, so that the two stay in order
EXACT = 1e-9  # relative: what lies so near to a round number is that number


def shown_edge(value: float, inwards: int, beside: float | None = None) -> str:
    """The end of an interval as text: rounded up (``inwards`` +1: a lower end) or down (-1: an upper end), to
    the nearest where 0, to whole numbers or `DIGITS` significant digits, finer where the present value
    ``beside`` it lies nearer than that."""
    return _text(_rounded(value, inwards, decimals(value, beside)), decimals(value, beside))


def rounded_edge(value: float, inwards: int, beside: float | None = None) -> float:
    """The number that `shown_edge` shows."""
    return _rounded(value, inwards, decimals(value, beside))


def shown_interval(low: float, high: float, digits: int = DIGITS) -> tuple[str, str]:
    """Both ends of an interval as text, rounded into it to so many significant digits, finer where it is
    narrow."""
    finest = max(abs(low), abs(high))
    more = digits - 1 - floor(log10(finest)) if isfinite(finest) and finest > 0.0 else 0
    places = min(max(decimals(low, high), decimals(high, low), more), MOST_DECIMALS)
    return _text(_rounded(low, 1, places), places), _text(_rounded(high, -1, places), places)


def shown_distance(value: float, edge: float, inwards: int) -> str:
    """How far a value lies from an end, as both are shown: never more than it is."""
    places = decimals(edge, value)
    apart = abs(value - _rounded(edge, inwards, places))
    return _text(_rounded(apart, -1, places), places)


def at_most(value: float, digits: int = DIGITS) -> str:
    """A size, of zero or more, to so many significant digits: never more than it is."""
    if not isfinite(value) or value == 0.0:
        return f"{value:g}"
    places = digits - 1 - floor(log10(value))
    return _text(_rounded(value, -1, places), max(0, places))


def decimals(value: float, beside: float | None = None) -> int:
    """How many of them an end is shown with."""
    if not isfinite(value) or value == 0.0:
        return 0
    places = max(0, DIGITS - 1 - floor(log10(abs(value))))
    apart = 0.0 if beside is None else abs(value - beside)
    if apart > 0.0:
        places = max(places, -floor(log10(COARSEST * apart)))
    return min(places, MOST_DECIMALS)


def _rounded(value: float, inwards: int, places: int) -> float:
    scaled = value * 10.0**places
    near = round(scaled)
    if inwards == 0 or abs(scaled - near) <= EXACT * max(abs(scaled), 1.0):
        return near / 10.0**places
    return (ceil(scaled) if inwards > 0 else floor(scaled)) / 10.0**places


def _text(value: float, places: int) -> str:
    text = f"{value:.{places}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text
