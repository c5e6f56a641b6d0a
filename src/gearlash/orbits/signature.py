"""The impact signature P-Q-R."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.system import GearlashError


@dataclass(frozen=True, order=True)
class Signature:
    """``period`` mesh cycles with ``drive`` impacts on the drive side (Q) and ``back`` on the back side (R)
    in them.

    An impact is an engagement: X rises through +D, or falls through -D.
    """

    period: int
    drive: int
    back: int = 0

    def __str__(self) -> str:
        return f"{self.period}-{self.drive}-{self.back}"

    @property
    def short(self) -> str:
        """As the article prints it: without R where the back side is not met."""
        return str(self) if self.back else f"{self.period}-{self.drive}"

    @staticmethod
    def parse(text: str) -> Signature:
        """``"6-6-1"`` or ``"1-0"``. Raises `GearlashError` for anything else."""
        parts = text.split("-")
        if len(parts) not in (2, 3) or not all(p.isdigit() for p in parts):
            raise GearlashError(
                f"signature {text!r}: expected P-Q or P-Q-R with whole numbers, for example 6-6-1"
            )
        return Signature(*(int(p) for p in parts))
