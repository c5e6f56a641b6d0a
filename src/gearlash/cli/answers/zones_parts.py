"""Parts of the answer of `gearlash zones`: intervals, their ends, who lives in them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from .parts import PhysicalValue


@dataclass(frozen=True)
class ZoneEnd:
    """Where an interval ends."""

    value: float
    uncertainty: Annotated[float, "the value is known within plus or minus this"]
    physical: tuple[PhysicalValue, ...]
    kind: Annotated[
        str,
        "grazing, fold, doubling, jump, onset of aperiodic motion, no periodic motion proved beyond, "
        "change of basin, end of the range, not computed beyond",
    ]
    solved: Annotated[bool, "solved for together with the orbit; else found by halving"]
    inside: Annotated[str, "label just inside"]
    outside: Annotated[str, "label just outside"]
    direction: Annotated[str, "sweep whose attractor changes here"]

    def inner(self, inwards: int) -> float:
        """The value that is shown: where it was halved, the last that was seen to be inside; ``inwards`` is
        +1 for a lower end, -1 for an upper."""
        return self.value if self.solved else self.value + inwards * self.uncertainty


@dataclass(frozen=True)
class Resident:
    """A motion that was seen inside."""

    label: str
    directions: Annotated[tuple[str, ...], "sweeps that found it"]
    lower: Annotated[float, "least value of the axis at which they did"]
    upper: Annotated[float, "largest value of the axis at which they did"]
    quiet: bool
    coexisting: Annotated[bool, "seen beside another motion at the same value"]


@dataclass(frozen=True)
class ZoneFound:
    """One interval."""

    kind: Annotated[Literal["impact-free", "drive-side-only"], "no impact at all, or none on the back side"]
    every: Annotated[
        bool, "every attractor that the sweeps found is quiet; false: at every value at least one is"
    ]
    lower: ZoneEnd
    upper: ZoneEnd
    margin: Annotated[
        float | None,
        "from the present value to the nearer end at which something happens, less its uncertainty; null "
        "outside, and where neither end was met within the range",
    ]
    margin_asked: Annotated[float | None, "the same in the unit that was asked for"]
    residents: tuple[Resident, ...]
