"""Verdicts: a pure comparison of what the article reports with what was computed."""

from __future__ import annotations

from math import isfinite

from gearlash.system import Label, Signature

REPRODUCED, SHIFTED, NOT_FOUND = "reproduced", "shifted", "not found"
CLOSE, FAR = 0.005, 0.10  # relative deviations: reproduced up to the first, shifted up to the second


def deviation(computed: float, reported: float) -> float:
    """Relative deviation of the computed from the reported value."""
    return (computed - reported) / reported


def verdict(deviations: list[float], labels_equal: bool) -> str:
    """``reproduced``: labels equal and every deviation within 0.5 %; ``shifted``: within 10 %; else ``not
    found``."""
    if not labels_equal or not deviations or not all(isfinite(d) for d in deviations):
        return NOT_FOUND
    worst = max(abs(d) for d in deviations)
    return REPRODUCED if worst <= CLOSE else SHIFTED if worst <= FAR else NOT_FOUND


def coincides(apart: float, value: float, printed: str) -> str:
    """Two places that are to be one: ``reproduced`` where they lie no further apart than one unit of the last
    printed digit, so that print does not tell them apart; ``shifted`` within 10 % of the value."""
    if not isfinite(apart):
        return NOT_FOUND
    digits = len(printed.partition(".")[2])
    if apart <= 10.0**-digits:
        return REPRODUCED
    return SHIFTED if apart <= FAR * abs(value) else NOT_FOUND


def worst(verdicts: list[str]) -> str:
    """The least good of several verdicts."""
    order = [REPRODUCED, SHIFTED, NOT_FOUND]
    return max(verdicts, key=order.index, default=NOT_FOUND)


def same_label(computed: Label | None, reported: str) -> bool:
    """Whether a motion has the signature that the article prints: 1-1-0 is "1-1"."""
    return bool(reported) and isinstance(computed, Signature) and computed == Signature.parse(reported)
