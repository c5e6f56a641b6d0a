"""Parts of the answer of `gearlash branch`: special points, ends, stretches, the law of a touch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case

from .asked import Asked
from .parts import Multiplier, PhysicalValue, multiplier_rows, physical_values

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.branches.continuation import Branch, GrazingLaw, SpecialKind, SpecialPoint


@dataclass(frozen=True)
class NextPoint:
    """A fold or doubling beyond a touch, by the law or as computed."""

    kind: Annotated[str, "fold or doubling"]
    depth: Annotated[
        float | None, "of the extremum beyond its boundary, in units of X (of Φ on the surface force)"
    ]
    value: Annotated[float | None, "of the parameter, dimensionless; null: not found"]


@dataclass(frozen=True)
class LawFound:
    """How the multipliers move at a touch: λ0 + c √d with the depth d beyond it."""

    multipliers: Annotated[tuple[Multiplier, ...], "λ0 of the touching orbit, by modulus, descending"]
    coefficients: Annotated[tuple[Multiplier, ...], "c of each, predicted from the field"]
    a0: Annotated[float, "X″ at the touch; Φ″ where the surface is the force"]
    rate: Annotated[float | None, "how fast the extremum moves with the parameter; null: not found"]
    missing: Annotated[tuple[str, ...], "conditions of the law that do not hold; it then says nothing"]
    predicted: Annotated[NextPoint | None, "the next fold or doubling by the law; null: it predicts none"]
    computed: Annotated[
        NextPoint | None,
        "the next special point of this branch beyond the touch, if it is a fold or doubling; else null",
    ]
    until: Annotated[str, "where none was computed: what ended the search; empty where one was"]


@dataclass(frozen=True)
class SpecialFound:
    """A special point of a branch, solved for."""

    number: Annotated[int, "on its branch, from 1; --switch and --at take it"]
    kind: Annotated[
        str,
        "fold, doubling, Neimark-Sacker, Krein collision, branch point, grazing, end of existence, joins the "
        "orbit of half its period, joins a symmetric orbit",
    ]
    note: Annotated[str, "the kind in words, of a grazing with its boundary, and what else there is to tell"]
    value: Annotated[float, "of the parameter, dimensionless"]
    error: Annotated[float | None, "estimate of its error; null: none could be made"]
    value_asked: Annotated[float, "the value in the unit that was asked for"]
    physical: tuple[PhysicalValue, ...]
    interval: Annotated[tuple[float, float], "values of the two orbits between which it was found"]
    period: Annotated[int, "of the orbit, in mesh cycles"]
    clearance: Annotated[str | None, "of a grazing: name of the gap"]
    side: Annotated[Literal["drive", "back"] | None, "of a grazing"]
    surface: Annotated[Literal["gap", "force"] | None, "of a grazing: what is touched"]
    phase: Annotated[float | None, "of a grazing: when, in mesh cycles"]
    label_before: Annotated[str, "of the orbit before it, in the order of the branch"]
    label_after: Annotated[str, "of the orbit after it"]
    unstable_before: Annotated[int, "multipliers outside the unit circle before it"]
    unstable_after: Annotated[int, "multipliers outside the unit circle after it"]
    multipliers: Annotated[tuple[Multiplier, ...], "there, by modulus, descending"]
    linear: Annotated[bool, "the orbit meets no boundary, so that its motion is linear there"]
    born: Annotated[bool, "another branch of periodic orbits begins there"]
    law: Annotated[LawFound | None, "of a grazing, with --law; null: not asked for, or there is none"]
    law_missing: Annotated[str, "why there is no law, where one was asked for"]


@dataclass(frozen=True)
class BranchEnd:
    """Why a branch is not followed farther."""

    kind: str
    value: Annotated[float, "of the parameter, dimensionless"]
    note: Annotated[str, "the evidence in words"]


@dataclass(frozen=True)
class StretchFound:
    """A part of a branch with one label and one stability, along which the parameter goes one way."""

    label: str
    stable: bool
    low: float
    high: float


@dataclass(frozen=True)
class OrbitFound:
    """An orbit of a branch; its state and all its multipliers are in the file of --out."""

    value: float
    arclength: Annotated[float, "along the branch, in scaled unknowns"]
    label: str
    unstable: Annotated[int, "multipliers outside the unit circle"]
    leading: Annotated[float, "modulus of the largest multiplier"]
    certificate: Annotated[str, "certified, uncertain or failed"]


@dataclass(frozen=True)
class LimitsUsed:
    """The parameter, and between which values branches were followed."""

    name: Annotated[str, "short name; its values are dimensionless"]
    named: Annotated[str, "as it was typed, or the quantity that its unit means"]
    lower: float
    upper: float
    physical_lower: tuple[PhysicalValue, ...]
    physical_upper: tuple[PhysicalValue, ...]
    asked: Annotated[Asked, "the unit that sentences and tables tell values in"]
    held: Annotated[str, "what is taken to be the same all along it, although it may not be"] = ""


@dataclass(frozen=True)
class BranchStart:
    """The motion that the first branch goes through."""

    value: Annotated[float, "of the parameter, dimensionless"]
    label: Annotated[str, "P-Q-R (/Q-R of every further clearance), aperiodic, neutral, unresolved, or empty"]
    status: Annotated[str, "of that motion"]
    message: Annotated[str, "what is known about it"]


@dataclass(frozen=True)
class BranchFound:
    """One branch of periodic motions."""

    number: Annotated[int, "from 1"]
    parent: Annotated[int | None, "number of the branch that it was switched to from; null: none"]
    parent_special: Annotated[int | None, "number of the special point there"]
    period: Annotated[int, "of its orbits, in mesh cycles"]
    labels: Annotated[tuple[str, ...], "that occur on it"]
    special: Annotated[tuple[SpecialFound, ...], "in the order of the branch"]
    stretches: tuple[StretchFound, ...]
    ends: Annotated[tuple[BranchEnd, ...], "the first and the last"]
    unexplained: Annotated[
        tuple[str, ...], "steps on which something changed that no special point was found for"
    ]
    certificates: Annotated[dict[str, int], "number of orbits certified, uncertain, failed"]
    orbits: Annotated[tuple[OrbitFound, ...], "in the order of the branch"]


@dataclass(frozen=True)
class Missed:
    """A special point from which no branch was followed."""

    branch: Annotated[int, "number of the branch"]
    special: Annotated[int, "number of the point on it"]
    known: Annotated[int | None, "number of the branch there that was followed already; null: none"]
    why: str


@dataclass(frozen=True)
class BesideFound:
    """Values at which several stable orbits of the branches lie."""

    low: float
    high: float
    labels: tuple[str, ...]


def special_found(
    case: Case, branch: Branch, number: int, names: Sequence[str], factor: float, law: GrazingLaw | str
) -> SpecialFound:
    """The record of special point ``number``, from 1; ``names`` are those of the gaps, ``factor`` turns
    values into what was asked for, ``law`` is that of a touch, or why there is none (empty: not asked)."""
    from gearlash.studies.switches import born_at

    special = branch.special[number - 1]
    touch = special.extremum
    return SpecialFound(
        number=number,
        kind=str(special.kind),
        note=special.note,
        value=special.value,
        error=special.error if isfinite(special.error) else None,
        value_asked=special.value * factor,
        physical=physical_values(case, branch.name, special.value, back_side_met=_meets_back(special)),
        interval=special.interval,
        period=special.point.period,
        clearance=None if touch is None else names[touch.clearance],
        side=None if touch is None else ("drive" if touch.boundary > 0 else "back"),
        surface=None if touch is None else ("gap" if touch.surface == "gap" else "force"),
        phase=None if touch is None else touch.phase,
        label_before=str(special.label_before),
        label_after=str(special.label_after),
        unstable_before=special.unstable_before,
        unstable_after=special.unstable_after,
        multipliers=multiplier_rows(special.point.multipliers),
        linear=special.linear,
        born=born_at(special),
        law=None if isinstance(law, str) else _law(law, branch, special),
        law_missing=law if isinstance(law, str) else "",
    )


def _meets_back(special: SpecialPoint) -> bool:
    sides = special.label_before, special.label_after
    touch = special.extremum
    return any(one.back_impacts > 0 for one in sides) or (touch is not None and touch.boundary < 0)


def _law(law: GrazingLaw, branch: Branch, special: SpecialPoint) -> LawFound:
    return LawFound(
        multipliers=multiplier_rows(law.multipliers),
        coefficients=multiplier_rows(law.coefficients),
        a0=law.a0,
        rate=law.rate if isfinite(law.rate) else None,
        missing=law.missing,
        predicted=_next(law.predicted_kind, law.predicted_depth, law.predicted_value),
        computed=_next(law.computed_kind, law.computed_depth, law.computed_value),
        until="" if law.computed_kind is not None else _until(branch, special),
    )


def _until(branch: Branch, special: SpecialPoint) -> str:
    """What comes next beyond a touch: another special point, or the end of the branch."""
    touch = special.touch
    for way in (1.0, -1.0):
        points = [p for p in branch.points if way * (p.arclength - special.arclength) > 0.0]
        nearest = min(points, key=lambda p: abs(p.arclength - special.arclength), default=None)
        mine = [] if nearest is None else [e for e in nearest.extrema if e.number == touch.number]
        if not mine or mine[0].distance * touch.a0 > 0.0:
            continue  # not on this side: there the extremum does not lie beyond its boundary
        beyond = [
            (abs(other.arclength - special.arclength), i, other)
            for i, other in enumerate(branch.special, 1)
            if way * (other.arclength - special.arclength) > 0.0
        ]
        if beyond:
            _, number, other = min(beyond)
            return f"the {other.kind} {number}"
        end = branch.ends[-1 if way > 0.0 else 0]
        return f"the end of the branch ({end.kind})"
    return "another change of the branch"


def _next(kind: SpecialKind | None, depth: float, value: float) -> NextPoint | None:
    return None if kind is None else NextPoint(str(kind), *map(_number, (depth, value)))


def _number(value: float) -> float | None:
    return float(value) if isfinite(value) else None


def orbits_found(branch: Branch) -> tuple[OrbitFound, ...]:
    """Of every orbit, in the order of the branch."""
    return tuple(
        OrbitFound(
            value=point.value,
            arclength=point.arclength,
            label=str(point.label),
            unstable=point.unstable,
            leading=float(abs(point.multipliers[0])),
            certificate=str(point.certificate.verdict),
        )
        for point in branch.points
    )


def stretches_found(branch: Branch) -> tuple[StretchFound, ...]:
    """Of a branch, in its order."""
    from gearlash.results.stretches import stretches

    return tuple(
        StretchFound(str(each.label), each.stable, each.low, each.high) for each in stretches(branch)
    )


def ends_found(branch: Branch) -> tuple[BranchEnd, ...]:
    """The first and the last."""
    return tuple(BranchEnd(str(end.kind), end.value, end.note) for end in branch.ends)
