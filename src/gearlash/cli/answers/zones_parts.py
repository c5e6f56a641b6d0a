"""Parts of the answer of `gearlash zones`: intervals, their ends, who lives in them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from .parts import PhysicalValue


@dataclass(frozen=True)
class EndPoint:
    """The special point of a branch that an end is; before and after: in the order of the branch, which may
    turn round in the parameter."""

    branch_kind: Annotated[str, "fold, doubling, Neimark-Sacker, branch point, grazing, …"]
    note: Annotated[str, "the kind in words, of a grazing with its boundary"]
    label_before: str
    label_after: str
    unstable_before: Annotated[int, "multipliers outside the unit circle before it; 0: stable"]
    unstable_after: int


@dataclass(frozen=True)
class ZoneEnd:
    """Where an interval ends."""

    value: float
    uncertainty: Annotated[float, "the value is known within plus or minus this"]
    physical: tuple[PhysicalValue, ...]
    kind: Annotated[
        str,
        "grazing, fold, doubling, Neimark-Sacker, Krein collision, branch point, joins the orbit of half its "
        "period, joins a symmetric orbit, end of existence, seen on the grid only, end of the range, not "
        "computed beyond",
    ]
    solved: Annotated[bool, "solved for as a special point of a branch; else halved, or nothing happens"]
    inside: Annotated[str, "label just inside"]
    outside: Annotated[str, "label just outside"]
    direction: Annotated[str, "how the motion that changes here was found: sweeps, or what led to its branch"]
    point: Annotated[EndPoint | None, "what was solved for; null where nothing was"] = None

    def inner(self, inwards: int) -> float:
        """The value that is shown: where it was halved, the last that was seen to be inside; ``inwards`` is
        +1 for a lower end, -1 for an upper."""
        return self.value if self.solved else self.value + inwards * self.uncertainty


@dataclass(frozen=True)
class Stay:
    """An interval of the parameter between two ends of a branch, or of a stable part of it."""

    lower: float
    upper: float
    lower_kind: Annotated[str, "what ends it there; end of the range: the limit of the scan, it may go on"]
    upper_kind: str


@dataclass(frozen=True)
class Assured:
    """Between which values a stable orbit exists at every value, provided that between neighbouring orbits
    the monodromy strays from the straight line by no more than twice as much as it does in the middle."""

    lower: float
    upper: float


@dataclass(frozen=True)
class Resident:
    """A motion that was found inside."""

    label: str
    directions: Annotated[tuple[str, ...], "sweeps that found it, or what led to its branch"]
    lower: Annotated[
        float,
        "least value at which it is stable with this label; of motion without a branch, at which it was seen",
    ]
    upper: Annotated[float, "largest value of the same"]
    quiet: bool
    coexisting: Annotated[bool, "found beside another motion at the same values"]
    stable: Annotated[Stay | None, "where it is stable with this label; null without a branch"] = None
    exists: Annotated[Stay | None, "where its whole branch exists, stable or not, with any label"] = None
    assured: Annotated[
        Assured | None, "of quiet motions in zones of every attractor; null where nothing was shown"
    ] = None


@dataclass(frozen=True)
class MarginFound:
    """From the present value to an end at which something happens."""

    distance: Annotated[float, "less the end's uncertainty, dimensionless"]
    asked: Annotated[float, "the same in the unit that was asked for"]
    physical: Annotated[tuple[PhysicalValue, ...], "the same in every physical unit"]
    percent: Annotated[float | None, "the same, of the present value; null where that is zero"]
    event: Annotated[str, "what happens there"]


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
    margin_below: Annotated[MarginFound | None, "to the lower end, where something happens at it"] = None
    margin_above: Annotated[MarginFound | None, "to the upper end, where something happens at it"] = None
    unique: Annotated[
        bool,
        "a contraction test proves, at every value of the axis inside and at both ends, that there is no "
        "other motion; false proves nothing",
    ] = False
