"""One value of a case as shown to a person."""

from __future__ import annotations

from dataclasses import dataclass

from .stated import Provenance

DERIVED = "derived"
"""Provenance of what was computed."""


@dataclass(frozen=True)
class Value:
    """One value of a case as shown to a person, as `Case.values` returns them.

    Attributes
    ----------
    path : str
        Where it stands in a file (``table.leaf``), or ``derived.…``.
    value : float or str
        A number in ``unit``, or the name of an option.
    unit : str
        Empty for a plain number.
    provenance : str
        A `Provenance`, or ``derived`` for what was computed.
    reason : str
        As stated; of a derived value its formula.
    short : str or None
        Short name of the parameter, if it has one.
    description : str
    rests_on : tuple of str
        The assumed values that a derived number was computed from, by path.
    text : str
        What was written; empty where nothing was.
    least, greatest : float, optional
        In ``unit``, the range that an estimated value may lie in, or the limits that are stated.

    Examples
    --------
    >>> import gearlash as gl
    >>> teeth = gl.load_case("article").values()[0]
    >>> teeth.path, teeth.value, str(teeth.provenance), teeth.uncertain
    ('pinion.teeth', 28, 'given', False)
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
    least: float | None = None
    greatest: float | None = None

    @property
    def estimated(self) -> bool:
        """Is it an estimate with a range, also one that the file states as assumed?"""
        return self.least is not None and not self.limited

    @property
    def limited(self) -> bool:
        """Does the case state its limits, and not assume them?"""
        return self.least is not None and bool(self.text) and self.provenance != Provenance.ASSUMED

    @property
    def uncertain(self) -> bool:
        """Is it assumed, or computed from something assumed?"""
        return self.provenance == Provenance.ASSUMED or bool(self.rests_on)
