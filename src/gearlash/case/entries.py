"""One stated value of a case: what it is, by which name it was stated, and where it is from."""

from __future__ import annotations

from dataclasses import dataclass

from .stated import Provenance, Stated


@dataclass(frozen=True)
class Entry:
    """A quantity (``key``), the ``path`` it was named by, its value in SI, text, provenance and reason."""

    key: str
    path: str
    value: float | str
    text: str
    provenance: Provenance
    reason: str

    @property
    def number(self) -> float:
        return float(self.value)

    @property
    def dimensionless(self) -> bool:
        return self.path.startswith("dimensionless.")


Entries = dict[str, Entry]
BY_OVERRIDE = "set by an override"
"""The reason of a value that an override set without one of its own."""


def overridden(stated: Stated) -> Stated:
    """With the reason that an override gives, unless it states its own."""
    if stated.reason:
        return stated
    return Stated(stated.value, stated.text, stated.provenance, BY_OVERRIDE)
