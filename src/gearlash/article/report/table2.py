"""The article's Table 2, filled by the program."""

from __future__ import annotations

from gearlash.article import Reproduction
from gearlash.article.reproduction import Table2Row
from gearlash.plots.regimes import short
from gearlash.report.blocks import Cell, Section, Strong, Table, Text
from gearlash.report.numbers import number

from .words import verdict

HEADINGS = ("Type", "The article", "Computed: where, labels below → above, exponent", "Verdict and remarks")
ZERO_EXPONENT = 1e-9  # an exponent below this is zero


def section(done: Reproduction) -> Section:
    """The table."""
    rows = tuple(_row(row) for row in done.table2)
    caption = "The article’s Table 2; what stands right of “The article” is computed."
    return Section(
        "table2",
        "Types of bifurcation (the article’s Table 2)",
        (
            Text.of(
                "The type of each located point follows from its multipliers alone: at ±1, or inside the "
                "unit circle."
            ),
            Table("table-table2", caption, HEADINGS, rows, widths=(17, 28, 30, 25)),
        ),
    )


def _row(row: Table2Row) -> tuple[Cell, ...]:
    said: Cell = [
        f"condition: {row.condition}",
        f"P: {row.reported_effect_p}",
        f"Q, R: {row.reported_effect_qr}",
        f"where: {row.reported_region}",
    ]
    found: Cell = [
        f"{event}: {' → '.join(short(p) for p in pattern.split(' → '))}, {_exponent(exponent)}"
        for event, pattern, exponent in zip(row.events, row.patterns, row.exponent, strict=True)
    ] or ["none located"]
    return Strong(row.type), said, found, [verdict(row.verdict), row.note]


def _exponent(value: float) -> str:
    return f"λ₁ = {number(value, 3) if abs(value) > ZERO_EXPONENT else 0}"
