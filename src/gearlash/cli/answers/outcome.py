"""What a study of many points says of itself as a whole."""

from __future__ import annotations

from collections.abc import Mapping

from gearlash.system import Status

from .excitation import NOT_EXCITED, Unexcited

OK, INCOMPLETE, FAILED, PARTLY_FAILED = "ok", "incomplete", "failed", "partly-failed"
RESUME = "call it again for the rest"  # what to do about incomplete
MEANING = (
    "ok; incomplete if it was stopped; failed if no {0} is ok; partly-failed if a {0} has no motion (its "
    "system could not be built or solved), or most are not ok; not-excited if nothing varies with time"
)
POINTS, PIXELS = MEANING.format("point"), MEANING.format("pixel")


def study_status(complete: bool, statuses: Mapping[Status, int], idle: Unexcited | None = None) -> str:
    """Of a study with so many points of each status; ``idle`` says why it answers nothing, if so."""
    if not complete:
        return INCOMPLETE
    if idle is not None:
        return NOT_EXCITED
    good, every = statuses.get(Status.OK, 0), sum(statuses.values())
    if not good:
        return FAILED
    return PARTLY_FAILED if statuses.get(Status.FAILED) or 2 * good < every else OK


def troubles(statuses: Mapping[Status, int], reason: str, what: str = "point") -> str:
    """How many points failed, the first with its reason, and how many are flagged; empty where none is.
    ``reason`` is that of the first that failed."""
    every = sum(statuses.values())
    failed = statuses.get(Status.FAILED, 0)
    flagged = {s: n for s, n in statuses.items() if n and s.computed and not s.ok}
    parts = []
    if failed:
        first = f", the first: {reason}" if failed > 1 else f": {reason}"
        parts.append(f"{failed} of {every} {what}s failed{first if reason else ''}")
    if flagged:
        named = ", ".join(f"{count} {status}" for status, count in flagged.items())
        count = sum(flagged.values())
        parts.append(f"{count} of {every} {what}s {'are' if count > 1 else 'is'} flagged ({named})")
    return "; ".join(parts)
