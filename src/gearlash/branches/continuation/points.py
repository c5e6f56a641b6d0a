"""What a branch is told by: its points, the special ones among them, and why it ends."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash.orbits import Certificate, Signature
from gearlash.orbits.grazing import KINDS
from gearlash.system import Label, Record, Status

from .extrema import Extremum

Array = NDArray[np.float64]


class Kind(StrEnum):
    """Of a special point."""

    FOLD = "fold"
    DOUBLING = "period doubling"
    TORUS = "Neimark-Sacker"
    BRANCH_POINT = "branch point"
    JOINS = "joins the orbit of half its period"
    SYMMETRIC = "joins a symmetric orbit"
    GRAZING = "grazing"


class Ending(StrEnum):
    """Why a branch is not followed farther."""

    LOWER = "lower limit of the parameter"
    UPPER = "upper limit of the parameter"
    CLOSED = "closed loop: the branch comes back to where it began"
    JOINED = "joins the orbit of half its period"
    CORNER = "touch from the gap under no-tension, where the map has a corner"
    LINEAR = (
        "the touch where a linear motion is born at its doubling: at this value it has every lower amplitude"
    )
    SHORT = "no step is short enough"
    FAR = "the motion grows without bound"
    UNBUILT = "beyond it no system can be built"
    POINTS = "as many points as were allowed"
    CANCELLED = "cancelled"


@dataclass(frozen=True, eq=False, repr=False)
class BranchPoint(Record):
    """One orbit of a branch.

    ``value`` of the parameter; ``arclength`` from the first orbit, in scaled unknowns, negative towards the
    first end; ``state`` (n,) at phase zero and ``strobes`` (P, n) of every base period; ``turn``: how fast
    the parameter changes along the branch, scaled, between -1 and 1 and zero at a fold; ``signature`` P-Q-R;
    all ``multipliers`` (n,); ``extrema`` with their distances from their boundaries, each with a number of
    its own along the branch, those ``born`` and ``died`` since the point before; ``residual`` and ``error``
    of the state as of `Shot`; ``certificate``."""

    _printed: ClassVar = ("value", "label", "stable", "unstable", "arclength", "status")

    value: float
    arclength: float
    state: Array
    strobes: Array
    turn: float
    signature: Signature
    multipliers: NDArray[np.complex128]
    extrema: tuple[Extremum, ...]
    born: tuple[int, ...]
    died: tuple[int, ...]
    residual: float
    error: float
    certificate: Certificate
    status: Status

    @property
    def label(self) -> Label:
        return self.signature

    @property
    def period(self) -> int:
        """In mesh cycles."""
        return self.signature.period

    @property
    def unstable(self) -> int:
        """Multipliers outside the unit circle."""
        return int((np.abs(self.multipliers) > 1.0).sum())

    @property
    def stable(self) -> bool:
        return self.unstable == 0


@dataclass(frozen=True, eq=False, repr=False)
class SpecialPoint(Record):
    """Where something happens to a branch: ``point`` is the orbit there, all that a restart needs with it.

    ``value`` of the parameter with its ``error``; ``interval``: the values of the two orbits between which it
    was found, and their ``arclengths``; of a graze the ``extremum`` that touches, of which the distance is
    zero within rounding; ``label_before`` and ``label_after``, ``unstable_before`` and ``unstable_after``:
    contacts and number of unstable multipliers of these two. ``linear``: the orbit meets no boundary, so that
    its system is linear there: a doubling or torus is then degenerate, and what is born in it appears at the
    amplitude that grazes."""

    _printed: ClassVar = ("kind", "value", "error", "label_before", "label_after", "told", "status")

    kind: Kind
    value: float
    error: float
    interval: tuple[float, float]
    arclengths: tuple[float, float]
    point: BranchPoint
    label_before: Label
    label_after: Label
    unstable_before: int
    unstable_after: int
    extremum: Extremum | None
    linear: bool
    told: str
    status: Status

    @property
    def arclength(self) -> float:
        return self.point.arclength


def grazing_kind(extremum: Extremum) -> str:
    """Loss of contact or engagement, drive or back side."""
    return KINDS[(extremum.surface, extremum.boundary, 1 if extremum.a0 > 0.0 else -1)]  # type: ignore[index]


@dataclass(frozen=True, repr=False)
class BranchEnd(Record):
    """Why a branch ends at a value, with the evidence in words."""

    ending: Ending
    value: float
    told: str = ""


@dataclass(frozen=True, eq=False, repr=False)
class Branch(Record):
    """Periodic orbits along one parameter, in the order of their arclength.

    ``name`` of the parameter, all other ``values``, the limits ``lower`` and ``upper``; ``points``;
    ``special`` points in the same order; the two ``ends``; ``scale`` of the unknowns, in which arclength is
    told; ``unexplained``: steps on which something changed that no special point was found for."""

    _printed: ClassVar = ("name", "lower", "upper", "points", "special", "ends")

    name: str
    values: Mapping[str, float]
    lower: float
    upper: float
    points: tuple[BranchPoint, ...]
    special: tuple[SpecialPoint, ...]
    ends: tuple[BranchEnd, BranchEnd]
    scale: Array
    unexplained: tuple[str, ...] = ()

    @property
    def parameter(self) -> Array:
        """(m,): values of the parameter."""
        return np.array([point.value for point in self.points])

    def of_kind(self, kind: Kind | str) -> tuple[SpecialPoint, ...]:
        """The special points of one kind."""
        return tuple(special for special in self.special if special.kind == Kind(kind))

    def at(self, value: float) -> tuple[tuple[BranchPoint, BranchPoint], ...]:
        """The pairs of neighbouring points between which the branch passes a value."""
        pairs = zip(self.points, self.points[1:], strict=False)
        return tuple(p for p in pairs if min(p[0].value, p[1].value) <= value <= max(p[0].value, p[1].value))
