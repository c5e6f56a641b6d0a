"""One value of a case as shown to a person."""

from __future__ import annotations

from dataclasses import dataclass

from .stated import Provenance

DERIVED = "derived"
"""Provenance of what was computed."""


@dataclass(frozen=True)
class Value:
    """One value as shown to a person.

    ``value`` is in ``unit``; ``provenance`` is a `Provenance` or ``derived`` (``reason`` is then the
    formula); ``rests_on`` names the assumed values that a derived number was computed from; ``text`` is
    what was written.
    """

    path: str
    value: float | str
    unit: str
    provenance: str
    reason: str
    short: str | None = None
    description: str = ""
    rests_on: tuple[str, ...] = ()
    text: str = ""

    @property
    def uncertain(self) -> bool:
        """Is it assumed, or computed from something assumed?"""
        return self.provenance == Provenance.ASSUMED or bool(self.rests_on)
