"""Tables of what is told by records alone: a case, and the article's claims."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from .tables import table_of

if TYPE_CHECKING:
    from gearlash.results.columns import Column

    from .answers.check import CheckAnswer
    from .answers.reproduce import ReproduceAnswer


def check_tables(answer: CheckAnswer) -> dict[str, Sequence[Column]]:
    """A row a value: name, value (a number, or a word in the column behind it), unit, where it is from and
    the range of an estimate; and the remarks."""
    from gearlash.results.columns import Column

    from .answers.check import CheckNote

    rows = answer.values
    numbers = [None if isinstance(v.value, str) else float(v.value) for v in rows]
    words = [v.value if isinstance(v.value, str) else "" for v in rows]
    values = [
        Column("path", [v.path for v in rows]),
        Column("symbol", [v.short or "" for v in rows]),
        Column("value", numbers),
        Column("word", words),
        Column("unit", [v.unit for v in rows]),
        Column("origin", [v.provenance for v in rows]),
        Column("least", [v.least for v in rows]),
        Column("greatest", [v.greatest for v in rows]),
        Column("as_written", [v.text for v in rows]),
        Column("description", [v.description for v in rows]),
        Column("reason", [v.reason for v in rows]),
        Column("rests_on", [" ".join(v.rests_on) for v in rows]),
    ]
    return {"check": values, "notes": table_of(answer.notes, CheckNote)}


def reproduce_tables(answer: ReproduceAnswer) -> dict[str, Sequence[Column]]:
    """A row a claim, one for every part of those that say several things, and what the run measured."""
    from gearlash.results.columns import Column

    from .answers.reproduce import Claim, Measured, Part

    parts = [(claim.id, part) for claim in answer.claims for part in claim.parts]
    return {
        "claims": table_of(answer.claims, Claim),
        "parts": [Column("claim", [name for name, _ in parts]), *table_of([p for _, p in parts], Part)],
        "checks": table_of(answer.checks, Measured),
    }
