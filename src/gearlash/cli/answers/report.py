"""`gearlash report`: may a pair run where it is meant to."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.system import label_text

from .outcome import POINTS, study_status
from .parts import CaseUsed, case_used

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.report.pair import Contents
    from gearlash.studies.assessment import Assessment
    from gearlash.studies.bands import Band

_STEMS = ("speed", "history-nominal", "spectrum-nominal", "history-hardest", "spectrum-hardest")
FILES = (
    "report.html", "report.json", "figures", "verdict.json",
    *(f"{stem}{ending}" for stem in _STEMS for ending in (".csv", ".nc")),
)  # fmt: skip
"""What a report may write into its folder."""


@dataclass(frozen=True)
class ReportLine:
    """A titled sentence of the verdict."""

    title: str
    text: str


@dataclass(frozen=True)
class ReportBand:
    """A band of speed in which a motion that was found does what is named."""

    lower: Annotated[float, "ω"]
    upper: Annotated[float, "ω"]
    lower_kind: Annotated[str, "what ends it there: a special point that was solved for, or the range"]
    upper_kind: str
    every: Annotated[bool, "every motion found in it does; false: another one was found beside"]
    labels: Annotated[tuple[str, ...], "of those motions"]


@dataclass(frozen=True)
class ReportPart:
    """A part of the range of which no motion tells whether teeth separate."""

    lower: Annotated[float, "ω"]
    upper: Annotated[float, "ω"]


@dataclass(frozen=True)
class ReportAnswer:
    """A verdict on a gear pair at its speed and torque (gearlash report)."""

    sentence: str
    status: Annotated[str, POINTS]
    case: CaseUsed
    verdict: Annotated[
        Literal["good", "doubt", "bad"],
        "good: no impacts were found at this speed, nor across the ranges of estimates and stated limits; "
        "doubt: in some motions, or somewhere in those ranges, or nothing settled; bad: in all",
    ]
    parameters: Annotated[dict[str, float], "every parameter by short name"]
    lines: Annotated[tuple[ReportLine, ...], "the first lines of the report, after its sentence"]
    separating: Annotated[tuple[ReportBand, ...], "where teeth separate"]
    not_told: Annotated[
        tuple[ReportPart, ...],
        "neither free of impacts nor where teeth separate: no motion was followed through it, and no sweep "
        "shows teeth that separate",
    ]
    back_side: Annotated[tuple[ReportBand, ...], "where the back side is met"]
    report: Annotated[str, "path of the page; empty where it was not made"]
    missing: Annotated[tuple[str, ...], "what was not computed, as the report was stopped"]
    result: Literal["report"] = "report"


def report_answer(found: Assessment, contents: Contents | None = None, page: str = "") -> ReportAnswer:
    """The record of a report, or of its verdict alone."""
    from gearlash.report.pair import verdict

    said = verdict(found)
    missing = () if contents is None else contents.missing
    statuses = Counter(point.status for sweep in found.impact_free.sweeps for point in sweep.points)
    return ReportAnswer(
        sentence=said.lines[0].text,
        status=study_status(found.complete and not missing, statuses),
        case=case_used(found.case),
        verdict=said.kind,
        parameters=dict(found.values),
        lines=tuple(ReportLine(line.title, line.text) for line in said.lines[1:]),
        separating=tuple(map(_band, found.separating)),
        not_told=tuple(ReportPart(one.lower.value, one.upper.value) for one in found.not_told),
        back_side=tuple(map(_band, found.back_side)),
        report=page,
        missing=missing,
    )


def _band(band: Band) -> ReportBand:
    return ReportBand(
        band.lower.value,
        band.upper.value,
        band.lower.kind,
        band.upper.kind,
        band.every,
        tuple(map(label_text, band.labels)),
    )
