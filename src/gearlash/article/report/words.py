"""Words and signs that several parts of the article's report share."""

from __future__ import annotations

from gearlash.article import NOT_FOUND, REPRODUCED, SHIFTED
from gearlash.report.blocks import Badge

VERDICT_STYLES = {REPRODUCED: "good", SHIFTED: "fair", NOT_FOUND: "bad"}
PROVENANCE = {"given": "good", "calibrated": "good", "inferred": "fair", "assumed": "doubt"}


def verdict(text: str) -> Badge:
    """A verdict as a badge."""
    return Badge(text or "not compared", VERDICT_STYLES.get(text, "plain"))


def provenance(text: str) -> Badge:
    """Where a value is from, as a badge."""
    return Badge(text, PROVENANCE.get(text, "plain"))


def plural(count: int, one: str, more: str | None = None) -> str:
    """``1 claim``, ``2 claims``."""
    return f"{count} {one if count == 1 else more or one + 's'}"


def joined(words: list[str]) -> str:
    """``a, b and c``."""
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + " and " + words[-1] if words else ""


def yes_or_no(holds: bool | None) -> Badge:
    """Whether a bound or condition holds; neither where nothing is claimed."""
    if holds is None:
        return Badge("for information", "plain")
    return Badge("yes", "good") if holds else Badge("no", "bad")
