"""`gearlash reproduce`: the article's claims, reported beside computed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.system import Status

from .outcome import FAILED, PARTLY_FAILED, POINTS, study_status, troubles
from .parts import CaseUsed, case_used

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash import article


@dataclass(frozen=True)
class Part:
    """One of several things that a claim says."""

    what: str
    reported: str
    computed: str
    verdict: Annotated[str, "as of a claim"]
    note: str


@dataclass(frozen=True)
class Claim:
    """One claim of the article."""

    id: str
    sentence: Annotated[str, "the claim in the words of the article"]
    quantity: Annotated[str, "what was reported and computed"]
    where: Annotated[str, "parameters it was made at"]
    reported: Annotated[str, "as printed in the article"]
    computed: Annotated[str, "ready to print"]
    reported_value: float | None
    computed_value: float | None
    deviation: Annotated[float | None, "computed minus reported, over reported"]
    reported_labels: str
    computed_labels: str
    verdict: Annotated[str, "reproduced (labels equal, within 0.5 %), shifted (within 10 %), or not found"]
    branch: Annotated[str, "branch, direction and start of what was computed"]
    note: str
    rests_on: Annotated[tuple[str, ...], "paths of the values that it rests on and the article does not give"]
    needs: Annotated[str, "the ways of scanning that give this verdict; empty if each does"]
    fitted: Annotated[bool, "open values of the case were chosen to meet this number: it tests nothing"]
    parts: Annotated[tuple[Part, ...], "what it says, where it says several things; the verdict is the worst"]


@dataclass(frozen=True)
class Measured:
    """A bound that this run measured on itself."""

    what: str
    value: str
    bound: str
    holds: Annotated[bool | None, "null: reported only"]


@dataclass(frozen=True)
class ReproduceAnswer:
    """The article's claims, judged (gearlash reproduce)."""

    sentence: str
    status: Annotated[str, POINTS]
    case: CaseUsed
    report: Annotated[str, "path of the report; report.json beside it has every number, curves included"]
    verdicts: Annotated[dict[str, int], "number of claims by verdict"]
    claims: tuple[Claim, ...]
    checks: tuple[Measured, ...]
    statuses: Annotated[dict[Status, int], "number of points of all sweeps by status"]
    certificates: Annotated[dict[str, int], "number of points certified, uncertain, failed"]
    seconds: Annotated[dict[str, float], "by stage"]
    workers: int
    result: Literal["reproduce"] = "reproduce"


def reproduce_answer(found: article.Reproduction, report: str) -> ReproduceAnswer:
    """The record of a reproduction whose report stands at this path."""
    from collections import Counter

    verdicts = Counter(row.verdict for row in found.claims)
    special = Counter(row.verdict for row in found.claims if row.needs)
    counted = ", ".join(
        f"{count} {verdict}"
        + (f" ({special[verdict]} of them only with the scan named)" if special[verdict] else "")
        for verdict, count in verdicts.items()
    )
    sentence = f"{len(found.claims)} claims of the article: {counted}"
    status = study_status(found.run.complete, found.run.statuses)
    if status in (FAILED, PARTLY_FAILED):
        sentence += f"; {troubles(found.run.statuses, '')}"
    return ReproduceAnswer(
        sentence=sentence,
        status=status,
        case=case_used(found.case),
        report=report,
        verdicts=dict(verdicts),
        claims=tuple(_claim(row) for row in found.claims),
        checks=tuple(Measured(c.what, c.value, c.bound, c.holds) for c in found.checks),
        statuses=dict(found.run.statuses),
        certificates=dict(found.run.certificates),
        seconds=dict(found.run.seconds),
        workers=found.run.workers,
    )


def _claim(row: article.ClaimRow) -> Claim:
    return Claim(
        id=row.id,
        sentence=row.sentence,
        quantity=row.quantity,
        where=row.where,
        reported=row.printed,
        computed=row.computed,
        reported_value=row.value,
        computed_value=row.computed_value,
        deviation=row.deviation,
        reported_labels=row.reported_labels,
        computed_labels=row.computed_labels,
        verdict=row.verdict,
        branch=row.branch,
        note=row.note,
        rests_on=row.rests_on,
        needs=row.needs,
        fitted=row.fitted,
        parts=tuple(Part(p.what, p.reported, p.computed, p.verdict, p.note) for p in row.parts),
    )
