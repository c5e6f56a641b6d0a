"""`gearlash branch`: periodic motions along one parameter, stable or not."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case
from gearlash.system import Status

from .asked import Asked
from .branch_parts import (
    BesideFound,
    BranchFound,
    BranchStart,
    LimitsUsed,
    Missed,
    ends_found,
    orbits_found,
    special_found,
    stretches_found,
)
from .branch_words import NOT_LOOKED_FOR, sentence
from .excitation import NOT_EXCITED, nothing_varies
from .outcome import INCOMPLETE, RESUME
from .parts import CaseUsed, case_used, physical_values

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.branches.continuation import Branch, GrazingLaw
    from gearlash.studies.switches import NotSwitched, SwitchedBranch

CUT_SHORT = ("no step is short enough", "as many points as were allowed")
"""Ends at which it is not known how a branch goes on."""
DOUBTFUL = "look at the ends and at unexplained: shorter steps (--step) may help"


@dataclass(frozen=True)
class BranchAnswer:
    """Branches of periodic motions (gearlash branch)."""

    sentence: str
    status: Annotated[
        str,
        "ok; incomplete if it was stopped; uncertain if a step is unexplained, or a branch ends where it is "
        "not known how it goes on; not-found where no motion could be followed; not-excited",
    ]
    message: str
    advice: Annotated[str, "what to do about the status"]
    case: CaseUsed
    parameters: Annotated[
        dict[str, float], "every parameter by short name, with the value that following began at"
    ]
    axis: LimitsUsed
    start: BranchStart
    branches: tuple[BranchFound, ...]
    coexisting: Annotated[tuple[BesideFound, ...], "found on these branches; there may be more"]
    not_switched: Annotated[tuple[Missed, ...], "where it was to be switched, and no branch was followed"]
    not_looked_for: Annotated[tuple[str, ...], "what these branches say nothing about"]
    result: Literal["branch"] = "branch"


def branch_answer(
    case: Case,
    parameters: Mapping[str, float],
    limits: LimitsUsed,
    start: BranchStart,
    found: Sequence[SwitchedBranch],
    missed: Sequence[NotSwitched] = (),
    laws: Mapping[tuple[int, int], GrazingLaw | str] | None = None,
) -> BranchAnswer:
    """The record of branches; ``laws``: those of special points, by branch and point (both from 0), or why
    there is none."""
    laws = {} if laws is None else laws
    names = [gap.name for gap in case.family()[0].system(parameters).clearances]
    rows = tuple(_branch(case, i, each, names, limits.asked, laws) for i, each in enumerate(found))
    beside = _beside([each.branch for each in found], limits)
    status, message, advice = _outcome(case, parameters, start, [each.branch for each in found])
    return BranchAnswer(
        sentence=sentence(limits, start, rows, beside, status, message),
        status=status,
        message=message,
        advice=advice,
        case=case_used(case),
        parameters=dict(parameters),
        axis=limits,
        start=start,
        branches=rows,
        coexisting=beside,
        not_switched=tuple(
            Missed(each.parent + 1, each.at + 1, each.known + 1 or None, each.why) for each in missed
        ),
        not_looked_for=NOT_LOOKED_FOR if found else (),
    )


def limits_used(case: Case, short: str, named: str, unit: str, lower: float, upper: float) -> LimitsUsed:
    """With what its ends mean physically."""
    lows, highs = (physical_values(case, short, end, computed=False) for end in (lower, upper))
    asked, held = Asked.of(case, short, named, unit), case.held(short)
    return LimitsUsed(short, named, lower, upper, lows, highs, asked, held)


def _branch(
    case: Case,
    index: int,
    followed: SwitchedBranch,
    names: Sequence[str],
    asked: Asked,
    laws: Mapping[tuple[int, int], GrazingLaw | str],
) -> BranchFound:
    branch = followed.branch
    return BranchFound(
        number=index + 1,
        parent=followed.parent + 1 or None,
        parent_special=followed.at + 1 or None,
        period=branch.points[0].period,
        labels=tuple(dict.fromkeys(str(point.label) for point in branch.points)),
        special=tuple(
            special_found(case, branch, i + 1, names, asked.factor, laws.get((index, i), ""))
            for i in range(len(branch.special))
        ),
        stretches=stretches_found(branch),
        ends=ends_found(branch),
        unexplained=branch.unexplained,
        certificates=dict(Counter(str(point.certificate.verdict) for point in branch.points)),
        orbits=orbits_found(branch),
    )


def _beside(branches: Sequence[Branch], limits: LimitsUsed) -> tuple[BesideFound, ...]:
    from gearlash.results.stretches import beside_each_other, stretches

    every = [each for branch in branches for each in stretches(branch)]
    found = beside_each_other(every, limits.upper - limits.lower)
    return tuple(BesideFound(each.low, each.high, tuple(map(str, each.labels))) for each in found)


def _outcome(
    case: Case, parameters: Mapping[str, float], start: BranchStart, branches: Sequence[Branch]
) -> tuple[str, str, str]:
    """Status, message and advice."""
    if not branches:
        if not case.family()[0].system(parameters).excited:
            idle = nothing_varies(case)
            return NOT_EXCITED, idle.cause, idle.advice
        what = start.label or start.status
        message = f"{what} there: only a periodic motion can be followed"
        advice = "begin where the motion is periodic (--near), or at a state on a periodic one (--initial)"
        return str(Status.NOT_FOUND), message, advice
    ends = [str(end.kind) for branch in branches for end in branch.ends]
    if "cancelled" in ends:
        return INCOMPLETE, "stopped before all was followed", RESUME
    odd = [f"branch {i}: {kind}" for i, branch in enumerate(branches, 1) for kind in _cut(branch)]
    odd += [f"branch {i}: {each}" for i, branch in enumerate(branches, 1) for each in branch.unexplained]
    if odd:
        return str(Status.UNCERTAIN), "; ".join(odd), DOUBTFUL
    return str(Status.OK), "", Status.OK.advice


def _cut(branch: Branch) -> list[str]:
    return [str(end.kind) for end in branch.ends if str(end.kind) in CUT_SHORT]
