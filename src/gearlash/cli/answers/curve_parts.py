"""Parts of the answer of `gearlash curve`: curves, their points at which two things happen at once, ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Annotated

from gearlash.case import Case

from .parts import Multiplier, PhysicalValue, multiplier_rows, physical_values

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.branches.continuation import SpecialPoint
    from gearlash.branches.curves import CodimTwoPoint, Curve, CurvePoint

    from .branch_parts import LimitsUsed

SAME = 1e-9  # relative: values of a parameter that differ by less are one


@dataclass(frozen=True, eq=False)
class Begun:
    """The special point number ``number`` (from 1), and the curve through it, or why there is none."""

    number: int
    special: SpecialPoint | CodimTwoPoint
    curve: Curve | None
    why: str = ""


@dataclass(frozen=True)
class CurveStart:
    """What the special points belong to that curves begin at."""

    source: Annotated[str, "branch or curve; motion, where it could not be followed"]
    label: Annotated[str, "of the motion that it goes through"]
    status: Annotated[str, "of that motion"]
    message: Annotated[str, "what is known about it"]
    special: Annotated[tuple[str, ...], "kinds of its special points in their order, the first is number 1"]


@dataclass(frozen=True)
class CodimTwoFound:
    """A point of a curve at which two things happen at once."""

    number: Annotated[int, "on its curve, from 1; --at takes it"]
    kind: str
    note: Annotated[str, "what else there is to tell"]
    values: Annotated[tuple[float, float], "of the two parameters, dimensionless"]
    errors: Annotated[
        tuple[float | None, float | None], "estimates of their errors; null: none could be made"
    ]
    values_asked: Annotated[tuple[float, float], "the values in the units that were asked for"]
    physical: Annotated[tuple[tuple[PhysicalValue, ...], ...], "of either parameter"]
    label_before: Annotated[str, "of the orbits before it, in the order of the curve"]
    label_after: Annotated[str, "of the orbits after it"]
    solved: Annotated[bool, "both conditions were solved for together; else a zero along the curve"]
    admissible: Annotated[bool, "whether its orbit is one of the real system"]
    period: Annotated[int, "of the orbit, in mesh cycles"]
    multipliers: Annotated[tuple[Multiplier, ...], "there, by modulus, descending"]
    status: str


@dataclass(frozen=True)
class CurveEnd:
    """Why a curve is not followed farther."""

    kind: str
    values: Annotated[tuple[float, float], "of the two parameters, dimensionless"]
    note: Annotated[str, "the evidence in words"]


@dataclass(frozen=True)
class CurveOrbit:
    """An orbit of a curve; its state and all its multipliers are in the file of --out."""

    values: tuple[float, float]
    arclength: Annotated[float, "along the curve, in scaled unknowns"]
    label: Annotated[str, "P-Q-R (/Q-R of every further clearance); what touches is not counted"]
    unstable: Annotated[int, "multipliers outside the unit circle"]
    admissible: Annotated[bool, "whether it is an orbit of the real system"]


@dataclass(frozen=True)
class CurveFound:
    """One curve of special orbits."""

    number: Annotated[int, "from 1"]
    begun_at: Annotated[int, "number of the special point that it goes through"]
    kind: Annotated[str, "grazing, fold, doubling or Neimark-Sacker"]
    touches: Annotated[str, "of a grazing: which boundary is touched, and the gap"]
    period: Annotated[int, "of its first orbit, in mesh cycles"]
    labels: Annotated[tuple[str, ...], "that occur on it, that of its first orbit first"]
    fixed: Annotated[
        dict[str, float],
        "other parameters by short name that have another value than in the case: that of the point begun at",
    ]
    throughout: Annotated[
        tuple[str, ...], "kinds of what happens at once on all of its orbits, so that no point of it is told"
    ]
    special: Annotated[tuple[CodimTwoFound, ...], "in the order of the curve"]
    ends: Annotated[tuple[CurveEnd, ...], "the first and the last"]
    lowest: Annotated[tuple[float, float], "least value of either parameter on it"]
    highest: Annotated[tuple[float, float], "largest value of either parameter on it"]
    residual: Annotated[float, "largest of its orbits, relative to the sizes of the motion"]
    orbits: Annotated[tuple[CurveOrbit, ...], "in the order of the curve"]


@dataclass(frozen=True)
class NotBegun:
    """A special point through which no curve was followed."""

    number: int
    kind: str
    why: str


def curve_found(
    case: Case,
    number: int,
    begun_at: int,
    curve: Curve,
    limits: Sequence[LimitsUsed],
    gaps: Sequence[str],
) -> CurveFound:
    """The record of a curve; ``gaps``: names of the clearances."""
    table = curve.parameters
    low, high = table.min(axis=0), table.max(axis=0)
    first = min(curve.points, key=lambda point: abs(point.arclength))
    return CurveFound(
        number=number,
        begun_at=begun_at,
        kind=str(curve.kind),
        touches=_touches(first, gaps),
        period=first.period,
        labels=tuple(dict.fromkeys(str(point.signature) for point in (first, *curve.points))),
        fixed=_fixed(case, curve),
        throughout=tuple(map(str, curve.throughout)),
        special=tuple(_special(case, i, each, curve, limits) for i, each in enumerate(curve.special, 1)),
        ends=tuple(CurveEnd(str(end.kind), end.values, end.note) for end in curve.ends),
        lowest=(float(low[0]), float(low[1])),
        highest=(float(high[0]), float(high[1])),
        residual=max(point.residual for point in curve.points),
        orbits=tuple(
            CurveOrbit(each.values, each.arclength, str(each.signature), each.unstable, each.admissible)
            for each in curve.points
        ),
    )


def _fixed(case: Case, curve: Curve) -> dict[str, float]:
    """What the point of a file brought with it, which was followed in another parameter."""
    own = case.family()[0].complete()
    return {
        name: value
        for name, value in curve.values.items()
        if name not in curve.names and abs(value - own[name]) > SAME * max(abs(value), abs(own[name]))
    }


def _touches(first: CurvePoint, gaps: Sequence[str]) -> str:
    return ", ".join(
        f"{gaps[touch.clearance]}, {'drive' if touch.boundary > 0 else 'back'} side"
        for touch in first.touches
    )


def _special(
    case: Case, number: int, special: CodimTwoPoint, curve: Curve, limits: Sequence[LimitsUsed]
) -> CodimTwoFound:
    one, two = special.errors
    x, y = (limit.asked.value(value) for limit, value in zip(limits, special.values, strict=True))
    return CodimTwoFound(
        number=number,
        kind=str(special.kind),
        note=special.note,
        values=special.values,
        errors=(one if isfinite(one) else None, two if isfinite(two) else None),
        values_asked=(x, y),
        physical=tuple(
            physical_values(case, name, value)
            for name, value in zip(curve.names, special.values, strict=True)
        ),
        label_before=str(special.label_before),
        label_after=str(special.label_after),
        solved=special.solved,
        admissible=special.point.admissible,
        period=special.point.period,
        multipliers=multiplier_rows(special.point.multipliers),
        status=str(special.status),
    )
