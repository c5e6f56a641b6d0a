"""The impact signature P-Q-R, and P-Q-R/Q-R of several clearances."""

from __future__ import annotations

import re
from dataclasses import dataclass

from . import given
from .record import Record
from .short_text import shown
from .status import GearlashError

PATTERN = re.compile(r"[0-9]+-[0-9]+(-[0-9]+)?(/[0-9]+-[0-9]+)*")


@dataclass(frozen=True, order=True, repr=False)
class Signature(Record):
    """The impact signature P-Q-R of a periodic motion.

    In P mesh cycles the first clearance has Q impacts on the drive side and R on the back side; P-Q-R/Q-R and
    so on of several clearances. An impact is a beginning of contact: X rises through +D, or falls through -D.
    With the rule `no-tension` it is also a contact that presses again before the gap had opened.

    Parameters
    ----------
    period : int
        P, at least 1.
    drive, back : int
        Q and R, at least 0.
    others : tuple of (int, int), optional
        Q and R of every further clearance, in the order of the system's.

    Raises
    ------
    GearlashError
        For anything else.

    Notes
    -----
    It prints as P-Q-R, and is equal to this text: ``point.label == "1-1-0"``.

    Examples
    --------
    >>> import gearlash as gl
    >>> found = gl.Signature(6, 6, 1)
    >>> str(found), found.impacts, found == "6-6-1"
    ('6-6-1', 7, True)
    >>> gl.Signature.parse("1-1-0").short
    '1-1'
    """

    period: int
    drive: int
    back: int = 0
    others: tuple[tuple[int, int], ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "period", given.whole("period of a signature", self.period))
        counts = [(self.drive, self.back), *given.items("other impacts", self.others, "pairs of counts")]
        pairs = [given.items("impacts", pair, "a pair of counts, drive and back") for pair in counts]
        if any(len(pair) != 2 for pair in pairs):
            raise GearlashError(f"impacts of a signature: {shown(self.others)}: expected pairs of counts")
        (drive, back), *others = [tuple(given.whole("impacts", each, 0) for each in pair) for pair in pairs]
        for name, value in (("drive", drive), ("back", back), ("others", tuple(others))):
            object.__setattr__(self, name, value)

    @property
    def counts(self) -> tuple[tuple[int, int], ...]:
        """(Q, R) of every clearance, in the order of the system's."""
        return ((self.drive, self.back), *self.others)

    @property
    def impacts(self) -> int:
        """Of all clearances and sides together."""
        return sum(drive + back for drive, back in self.counts)

    @property
    def back_impacts(self) -> int:
        """On side - of all clearances together."""
        return sum(back for _, back in self.counts)

    @property
    def twice(self) -> Signature:
        """The same motion, run through twice."""
        others = tuple((2 * drive, 2 * back) for drive, back in self.others)
        return Signature(2 * self.period, 2 * self.drive, 2 * self.back, others)

    def one_impact_from(self, other: Signature) -> tuple[int, int] | None:
        """The one impact by which two signatures of one period differ.

        Parameters
        ----------
        other : Signature

        Returns
        -------
        (int, int) or None
            Index of the clearance and boundary (±1) of the one count that differs, by one; None where that is
            not so.
        """
        if self.period != other.period or len(self.counts) != len(other.counts):
            return None
        differing = [
            (clearance, boundary, abs(mine - its))
            for clearance, pair in enumerate(zip(self.counts, other.counts, strict=True))
            for boundary, mine, its in zip((1, -1), *pair, strict=True)
            if mine != its
        ]
        return differing[0][:2] if len(differing) == 1 and differing[0][2] == 1 else None

    def __eq__(self, other: object) -> bool:
        if isinstance(other, str):  # its text: what labels in files and in a person's own lines are
            return str(self) == other
        if not isinstance(other, Signature):
            return NotImplemented
        return (self.period, self.counts) == (other.period, other.counts)

    def __hash__(self) -> int:
        return hash(str(self))

    def __repr__(self) -> str:  # in lists of labels too it is read as P-Q-R
        return str(self)

    def __format__(self, spec: str) -> str:
        return format(str(self), spec)

    def __str__(self) -> str:
        rest = "".join(f"/{drive}-{back}" for drive, back in self.others)
        return f"{self.period}-{self.drive}-{self.back}{rest}"

    @property
    def short(self) -> str:
        """Without R where the back side is not met: 1-1 for 1-1-0."""
        return str(self) if self.back or self.others else f"{self.period}-{self.drive}"

    @staticmethod
    def parse(text: str) -> Signature:
        """The signature of a text.

        Parameters
        ----------
        text : str
            ``"6-6-1"``, ``"1-0"``, or ``"3-2-0/1-1"`` of two clearances.

        Returns
        -------
        Signature

        Raises
        ------
        GearlashError
            For anything else.

        Examples
        --------
        >>> import gearlash as gl
        >>> gl.Signature.parse("3-2-0/1-1").others
        ((1, 1),)
        """
        if not (isinstance(text, str) and PATTERN.fullmatch(text)):
            raise GearlashError(
                f"signature {shown(text)}: expected P-Q or P-Q-R with whole numbers, for example 6-6-1, "
                "and /Q-R for every further clearance"
            )
        first, *rest = text.split("/")
        others = [tuple(map(int, part.split("-"))) for part in rest]
        return Signature(*map(int, first.split("-")), others=tuple((q, r) for q, r in others))
