"""What a gear pair has the same at every torque, although teeth bend and flanks are relieved."""

from __future__ import annotations

from .pair import GearPair

STATED = (
    "stiffness and error are the same at every torque, as they are stated without the geometry that they "
    "follow from"
)
ESTIMATED = "of unmodified flanks, estimated for each torque; "
NOT_FOLLOWED = "the same at every torque"


def held(pair: GearPair, short: str) -> str:
    """A sentence for the load; empty for what else varies, and for a pair in numbers only."""
    if short != "load" or not pair.scales.physical:
        return ""
    if not pair.completed.follows_torque:
        return STATED
    fixed = [
        name
        for key, name in (("mesh.mean_stiffness", "mean stiffness"), ("ripple", "ripple"))
        if key in pair.entries and pair.entries[key].least is None
    ]
    words = " and ".join([*fixed, "error"])
    return f"stiffness is that {ESTIMATED}{words} {'are' if fixed else 'is'} {NOT_FOLLOWED}"
