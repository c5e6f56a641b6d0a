"""What happens at the end of a zone, in the words of who runs a machine."""

from __future__ import annotations

from math import floor, log10
from typing import Protocol

from gearlash.system import Label

CHANGES = {
    "fold": "ends (fold)",
    "doubling": "doubles its period (doubling)",
    "Neimark-Sacker": "loses its stability (Neimark-Sacker)",
    "Krein collision": "loses its stability (Krein collision)",
    "branch point": "loses its stability (branch point)",
    "joins the orbit of half its period": "ends in the orbit of half its period (doubling)",
    "joins a symmetric orbit": "ends in a symmetric orbit",
    "end of existence": "grows without bound (end of existence)",
}
BEGINS = {"fold": "begins"}
SEEN_ONLY = "seen on the grid only"


class SolvedPoint(Protocol):
    """A special point that was solved for."""

    @property
    def note(self) -> str: ...
    @property
    def label_before(self) -> Label | str: ...
    @property
    def label_after(self) -> Label | str: ...


class End(Protocol):
    """The end of a zone, as a study or an answer has it."""

    @property
    def kind(self) -> str: ...
    @property
    def inside(self) -> Label | str | None: ...
    @property
    def outside(self) -> Label | str | None: ...
    @property
    def point(self) -> SolvedPoint | None: ...


def event(end: End, between_teeth: bool) -> str:
    """What happens at an end, as a clause."""
    if end.kind == "grazing" and end.point is not None:
        return f"{_touch(end.point.note, between_teeth)} (grazing)"
    if end.point is not None and end.kind in CHANGES:
        if end.inside in (end.point.label_before, end.point.label_after):
            return f"the motion {CHANGES[end.kind]}"
        return f"another motion, {end.outside}, {BEGINS.get(end.kind, 'becomes stable')} ({end.kind})"
    return f"other motion is seen ({end.outside})" if end.kind == SEEN_ONLY else f"its end lies ({end.kind})"


def _touch(note: str, between_teeth: bool) -> str:
    """A grazing in the words of who runs a machine."""
    side, teeth = " on the back side" if "back side" in note else "", "teeth " if between_teeth else ""
    if note.startswith("loss of contact"):
        return f"{teeth}begin to separate{side}" if teeth else f"contact begins to be lost{side}"
    return f"{teeth}begin to hit{side}" if teeth else f"impacts begin{side}"


def percent(value: float) -> str:
    """Two significant digits, rounded down."""
    places = max(0, 1 - floor(log10(value))) if value > 0.0 else 0
    return f"{floor(value * 10**places) / 10**places:.{places}f}"
