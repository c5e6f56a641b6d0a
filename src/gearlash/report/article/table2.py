"""The article's Table 2, filled by the program."""

from __future__ import annotations

from gearlash.plots.regimes import short
from gearlash.report.blocks import Cell, Section, Table, Text
from gearlash.report.numbers import number
from gearlash.studies.article import Reproduction

from .words import verdict

HEAD = (
    "Bifurcation type",
    "Condition (article)",
    "Effect on P (article)",
    "Effect on Q, R (article)",
    "Region (article)",
    "Computed: where, labels below → above, exponent",
    "Verdict",
    "Remarks",
)


def section(done: Reproduction) -> Section:
    """The table."""
    rows = tuple(_row(row) for row in done.table2)
    caption = "The article’s Table 2; the last three columns are computed."
    return Section(
        "table2",
        "Types of bifurcation (the article’s Table 2)",
        (
            Text.of(
                "The type of each located point follows from its multipliers alone: at ±1, or inside the "
                "unit circle."
            ),
            Table("table-table2", caption, HEAD, rows, wide=True),
        ),
    )


def _row(row) -> tuple[Cell, ...]:
    found: Cell = [
        f"{event}: {' → '.join(short(p) for p in pattern.split(' → '))}, λ₁ = {number(exponent, 3)}"
        for event, pattern, exponent in zip(row.events, row.patterns, row.exponent, strict=True)
    ] or ["none located"]
    return (
        row.type,
        row.condition,
        row.reported_effect_p,
        row.reported_effect_qr,
        row.reported_region,
        found,
        verdict(row.verdict),
        row.note,
    )
