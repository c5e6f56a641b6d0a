"""One stated value of a case: what it is, by which name it was stated, and where it is from."""

from __future__ import annotations

from dataclasses import dataclass, replace

from .stated import Provenance, Stated


@dataclass(frozen=True)
class Entry:
    """One stated value of a case.

    Attributes
    ----------
    key : str
        The quantity: the same for all paths that name it.
    path : str
        The path that it was stated by.
    value : float or str
        In SI, or the name of an option.
    text : str
        What was written.
    provenance : Provenance
    reason : str
        Why this value; empty where nothing was stated.
    least, greatest : float, optional
        In SI, the range that an estimated value may lie in, or limits that are stated; None where none are.

    Examples
    --------
    >>> import gearlash as gl
    >>> entry = gl.load_case("article").entries["D"]
    >>> entry.path, entry.number, entry.text
    ('mesh.backlash', 0.0001, '100 um')
    """

    key: str
    path: str
    value: float | str
    text: str
    provenance: Provenance
    reason: str
    least: float | None = None
    greatest: float | None = None

    @property
    def number(self) -> float:
        """The value of a quantity. Raises `ValueError` for the name of an option."""
        return float(self.value)

    @property
    def estimated(self) -> bool:
        """Is it an estimate with a range, and no value with limits that a file states?"""
        return self.least is not None and not self.text

    @property
    def limited(self) -> bool:
        """Does a file state its limits?"""
        return self.least is not None and bool(self.text)

    @property
    def dimensionless(self) -> bool:
        """Was it stated as a dimensionless number?"""
        return self.path.startswith("dimensionless.")


def entry_of(key: str, path: str, stated: Stated) -> Entry:
    """The entry of a value that was stated at a path."""
    return Entry(
        key, path, stated.value, stated.text, stated.provenance, stated.reason, stated.least, stated.greatest
    )


Entries = dict[str, Entry]
BY_OVERRIDE = "set by an override"
"""The reason of a value that an override set without one of its own."""


def overridden(stated: Stated) -> Stated:
    """With the reason that an override gives, unless it states its own."""
    if stated.reason:
        return stated
    return replace(stated, reason=BY_OVERRIDE)
