"""What a motion of either model does, in the words of the report."""

from __future__ import annotations

from gearlash.article.verified import Verified, VerifiedWay

NOT_COMPUTED = "—"
NONE, KEPT, UNEVEN = "none", "kept", "uneven"
"""Instead of P-Q-R: of motions that do not come back within 8 mesh cycles, with teeth apart and always in
contact; and of those that part and come back, but without as many impacts in every period."""
NOT_REPEATING = "not repeating"
IMPACTS = "impacts not repeating"
RULES = ("always", "in-contact", "no-tension")
HELD = ("stiffness", "dimensionless")
"""The ways in which all dimensionless numbers but the ripple of the stiffness are those of the case."""
MODIFIED = "modified"
"""The way with flanks that are relieved and crowned."""


def case_itself(found: Verified) -> VerifiedWay | None:
    """The way that has the numbers of the case."""
    return next((way for way in found.ways if way.name == HELD[0]), None)


def told(label: str) -> str:
    """A label in words."""
    words = {
        NONE: "parts, not repeating within 1 %",
        KEPT: "in contact, not repeating within 1 %",
        UNEVEN: f"parts, {IMPACTS}",
        "": NOT_COMPUTED,
    }
    return words.get(label, label)


def has_label(label: str) -> bool:
    """Whether it is P-Q-R, as of a motion that repeats."""
    return label.count("-") == 2


def parts(label: str, apart: float | None) -> bool:
    """Whether teeth part: by the label, or as they were seen apart. An aperiodic motion of the lumped model
    parts, as one without contact events would be periodic."""
    if has_label(label) and not label.endswith("-0-0"):
        return True
    return label == "aperiodic" or bool(apart)


def motion(label: str, apart: float) -> str:
    """A label, or that there is none, with the share of time apart where teeth part."""
    if parts(label, apart):
        without = IMPACTS if label == UNEVEN else NOT_REPEATING
        return f"{label if has_label(label) else without}, apart {share(apart)}"
    return label if has_label(label) else f"contact, {NOT_REPEATING}"


def share(part: float) -> str:
    """A share in per cent."""
    return f"{100.0 * part:.3g} %"
