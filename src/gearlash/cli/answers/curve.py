"""`gearlash curve`: special orbits along curves in two parameters."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

from gearlash.case import Case
from gearlash.system import Status

from .branch_parts import LimitsUsed
from .curve_parts import Begun, CurveFound, CurveStart, NotBegun, curve_found
from .excitation import NOT_EXCITED, nothing_varies
from .outcome import INCOMPLETE, RESUME
from .parts import CaseUsed, case_used, rests_in

CUT_SHORT = (
    "no step is short enough",
    "as many points as were allowed",
    "touch beyond which no continuation was found",
)
"""Ends at which it is not known how a curve goes on."""
DOUBTFUL = "look at the ends: shorter steps (--step), or a curve begun on the other side, may help"
NOT_LOOKED_FOR = (
    "special orbits through which none of these curves goes",
    "curves that begin at the points of the table (--resume with --at follows one)",
)
NO_POINT = "no point at which two things happen at once"
MOST_NAMED = 3


@dataclass(frozen=True)
class CurveAnswer:
    """Curves of special orbits in two parameters (gearlash curve)."""

    sentence: str
    status: Annotated[
        str,
        "ok; incomplete if it was stopped; uncertain if a curve ends where it is not known how it goes on, "
        "or a point of a table is not ok; not-found where no curve could be followed; not-excited",
    ]
    message: str
    advice: Annotated[str, "what to do about the status"]
    case: CaseUsed
    parameters: Annotated[
        dict[str, float], "every parameter by short name, where the source of the special points begins"
    ]
    axes: Annotated[tuple[LimitsUsed, ...], "the two parameters"]
    rests_on: Annotated[
        tuple[tuple[str, ...], ...], "assumed values behind computed values of either, in the unit asked for"
    ]
    start: CurveStart
    curves: tuple[CurveFound, ...]
    not_begun: Annotated[tuple[NotBegun, ...], "special points through which no curve was followed"]
    not_looked_for: Annotated[tuple[str, ...], "what these curves say nothing about"]
    result: Literal["curve"] = "curve"


def curve_answer(
    case: Case,
    parameters: Mapping[str, float],
    limits: Sequence[LimitsUsed],
    start: CurveStart | None,
    begun: Sequence[Begun],
) -> CurveAnswer:
    """The record of curves, in the order in which they were followed."""
    start = start or CurveStart("motion", "", INCOMPLETE, "stopped before any point was found", ())
    gaps = [gap.name for gap in case.family()[0].system(parameters).clearances]
    made = [each for each in begun if each.curve is not None]
    rows = tuple(
        curve_found(case, i, each.number, each.curve, limits, gaps)
        for i, each in enumerate(made, 1)
        if each.curve is not None
    )
    missed = tuple(
        NotBegun(each.number, str(each.special.kind), each.why) for each in begun if each.curve is None
    )
    status, message, advice = _outcome(case, parameters, start, rows, missed)
    return CurveAnswer(
        sentence=_sentence(limits, start, rows, status, message),
        status=status,
        message=message,
        advice=advice,
        case=case_used(case),
        parameters=dict(parameters),
        axes=tuple(limits),
        rests_on=tuple(rests_in(case, each.name, each.asked.name, each.asked.unit) for each in limits),
        start=start,
        curves=rows,
        not_begun=missed,
        not_looked_for=NOT_LOOKED_FOR if rows else (),
    )


def _outcome(
    case: Case,
    parameters: Mapping[str, float],
    start: CurveStart,
    curves: Sequence[CurveFound],
    missed: Sequence[NotBegun],
) -> tuple[str, str, str]:
    """Status, message and advice."""
    if start.status == INCOMPLETE or any(end.kind == "cancelled" for each in curves for end in each.ends):
        return INCOMPLETE, "stopped before all was followed", RESUME
    if not curves and start.source == "motion":
        if not case.family()[0].system(parameters).excited:
            idle = nothing_varies(case)
            return NOT_EXCITED, idle.cause, idle.advice
        message = f"{start.label or start.status} there: only a periodic motion has a branch to begin at"
        return str(Status.NOT_FOUND), message, "begin where the motion is periodic (--near, --initial)"
    if not curves:
        message = missed[0].why if missed else f"the {start.source} has no special point"
        return str(Status.NOT_FOUND), message, "begin at another point (--from), or choose wider limits"
    odd = [
        f"curve {each.number}: {end.kind}" for each in curves for end in each.ends if end.kind in CUT_SHORT
    ]
    odd += [
        f"point {point.number} of curve {each.number} is {point.status}"
        for each in curves
        for point in each.special
        if point.status != Status.OK
    ]
    if odd:
        return str(Status.UNCERTAIN), "; ".join(odd), DOUBTFUL
    return str(Status.OK), "", Status.OK.advice


def _sentence(
    limits: Sequence[LimitsUsed],
    start: CurveStart,
    curves: Sequence[CurveFound],
    status: str,
    message: str,
) -> str:
    """Such as ``pinion speed from 3000 to 4500 rpm and backlash from 20 to 120 µm: fold of 1-1-0; 1 cusp
    found; all 93 orbits are admissible``."""
    here = " and ".join(limit.asked.span(limit.lower, limit.upper) for limit in limits)
    if not curves:
        return f"{here}, from {start.label or start.status}: no curve was followed, {message}"
    what = ", ".join(_named(each) for each in curves[:MOST_NAMED])
    if len(curves) > MOST_NAMED:
        what += f" and {len(curves) - MOST_NAMED} more"
    many = f"{len(curves)} curves, " if len(curves) > 1 else ""
    kinds = Counter(point.kind for each in curves for point in each.special)
    points = ", ".join(f"{count} {kind}" for kind, count in kinds.items()) or NO_POINT
    orbits = [orbit for each in curves for orbit in each.orbits]
    real = sum(orbit.admissible for orbit in orbits)
    share = f"all {real}" if real == len(orbits) else f"{real} of {len(orbits)}"
    text = f"{here}: {many}{what}; {points} found; {share} orbits are admissible"
    return f"{text}; {status}, {message}" if message else text


def _named(curve: CurveFound) -> str:
    return f"{curve.kind} of {curve.labels[0]}"
