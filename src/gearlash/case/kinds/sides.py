"""How sides of a clearance without stiffness are read: whether they act, by their damping, or not."""

from __future__ import annotations

from collections.abc import Iterator

from gearlash.case.note import Note
from gearlash.system import Clearance, ContactRule


def notes_on_sides(clearance: Clearance, path: str) -> Iterator[Note]:
    """A remark on each side without stiffness; ``{side}`` in the path becomes plus or minus."""
    series = (clearance.stiffness_plus, clearance.stiffness_minus)
    for sign, boundary, stiffness, damping in zip("+-", (1, -1), series, clearance.dampings, strict=True):
        if stiffness.any():
            continue
        if clearance.stops(boundary):
            text = f"side {sign} has no stiffness: it acts by its damping {damping:g} alone"
        elif clearance.contact == ContactRule.ALWAYS:
            text = f"side {sign} has no stiffness: it does not act" + (
                " (the damping acts everywhere)" if damping else ""
            )
        else:
            text = f"side {sign} has no stiffness and no damping stated for it: it does not act"
        side = "plus" if boundary > 0 else "minus"
        yield Note(path.replace("{side}", side), text)
