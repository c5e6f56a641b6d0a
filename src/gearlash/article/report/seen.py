"""What a motion of either model does, in the words of the report."""

from __future__ import annotations

from .teeth import told

RULES = ("always", "in-contact", "no-tension")
HELD = ("stiffness", "dimensionless")
"""The ways in which all dimensionless numbers but the ripple of the stiffness are those of the case."""


def parts(label: str, apart: float | None) -> bool:
    """Whether teeth part: by the label, or of a motion without one whether they were seen apart. An aperiodic
    motion of the lumped model parts, as one without contact events would be periodic."""
    if label.count("-") == 2:
        return not label.endswith("-0-0")
    return label == "aperiodic" or bool(apart)


def motion(label: str, apart: float) -> str:
    """A label in words, with the share of time apart where teeth part."""
    return f"{told(label)}, apart {share(apart)}" if parts(label, apart) else told(label)


def share(part: float) -> str:
    """A share in per cent."""
    return f"{100.0 * part:.3g} %"
