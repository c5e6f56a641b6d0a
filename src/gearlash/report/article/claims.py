"""The table of claims: what the article says, what was computed, and the verdict."""

from __future__ import annotations

from gearlash.plots.regimes import short
from gearlash.report.blocks import Cell, Section, Strong, Table, Text
from gearlash.report.numbers import percent
from gearlash.studies.article import NOT_FOUND, REPRODUCED, SHIFTED, ClaimRow, Reproduction

from .words import verdict

HEAD = (
    "Claim of the article",
    "Printed",
    "Computed",
    "Deviation",
    "Verdict",
    "Where it was found, and remarks",
)


def section(done: Reproduction) -> Section:
    """Every claim, one row each."""
    table = Table(
        "table-claims",
        "Every claim of the article except those of its multibody section, with its computed counterpart.",
        HEAD,
        tuple(_row(claim) for claim in done.claims),
        frozenset({3}),
        widths=(29, 11, 14, 10, 14, 22),
    )
    intro = Text.of(
        f"“{REPRODUCED}”: the labels are equal and the value lies within 0.5 % of the printed one. "
        f"“{SHIFTED}”: the labels are equal and the value lies within 10 %. “{NOT_FOUND}”: anything else. "
        "What the article prints is never read by what computes the other column; it only says around "
        "which value a picture is centred. Labels P-Q-R count mesh cycles, drive-side impacts and "
        "back-side impacts of one period."
    )
    return Section("claims", "Claims of the article", (intro, table))


def counts(done: Reproduction) -> dict[str, int]:
    """How many claims have which verdict."""
    return {kind: sum(c.verdict == kind for c in done.claims) for kind in (REPRODUCED, SHIFTED, NOT_FOUND)}


def _row(claim: ClaimRow) -> tuple[Cell, ...]:
    what: Cell = [Strong(claim.quantity), f"at {claim.where}" if claim.where else "", f"“{claim.sentence}”"]
    printed: Cell = [_with_unit(claim.printed, claim.unit), claim.reported_labels]
    computed: Cell = [_with_unit(claim.computed, claim.unit), _labels(claim.computed_labels)]
    remarks: Cell = [line for line in (claim.branch, claim.note) if line] or [""]
    return what, printed, computed, percent(claim.deviation), verdict(claim.verdict), remarks


def _labels(text: str) -> str:
    return " → ".join(short(part) for part in text.split(" → "))


def _with_unit(text: str, unit: str) -> str:
    return f"{text} {unit}".strip()
