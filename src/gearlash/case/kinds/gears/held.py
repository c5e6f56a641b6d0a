"""What a gear pair has the same at every torque, although teeth bend and flanks are relieved."""

from __future__ import annotations

from gearlash.case.errors import Problem

from .drawn import GEAR_TORQUE, POWERED
from .entries import place_of
from .pair import GearPair

STATED = (
    "stiffness and error are the same at every torque, as they are stated without the geometry that they "
    "follow from"
)
ESTIMATED = "of unmodified flanks (no tip relief is stated), estimated for each torque; "
MODIFIED = "stiffness, contact ratio and the error of relief are those of the stated modification, "
NOT_FOLLOWED = "the same at every torque"


def held(pair: GearPair, name: str) -> str:
    """A sentence for the torque, however it is named; empty for what else varies, and for a pair in numbers
    only."""
    place = place_of(pair.places, name)
    if isinstance(place, Problem) or not pair.scales.physical:
        return ""
    if place.path not in (GEAR_TORQUE, POWERED) and "load" not in pair.places.keys(place):
        return ""
    if not pair.completed.follows_torque:
        return STATED
    fixed = [
        name
        for key, name in (("mesh.mean_stiffness", "mean stiffness"), ("ripple", "ripple"))
        if key in pair.entries and not pair.entries[key].estimated
    ]
    words = " and ".join([*fixed, "error of the flanks" if _modified(pair) else "error"])
    if _modified(pair):
        return f"{MODIFIED}found for each torque; {words} {'are' if fixed else 'is'} {NOT_FOLLOWED}"
    return f"stiffness is that {ESTIMATED}{words} {'are' if fixed else 'is'} {NOT_FOLLOWED}"


def _modified(pair: GearPair) -> bool:
    drawing = pair.completed.drawing
    return drawing is not None and drawing.modification.modified
