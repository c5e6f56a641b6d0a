"""The answer that says why there is none."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from gearlash.case import CaseError
from gearlash.case.errors import MOST_SHOWN


@dataclass(frozen=True)
class ProblemRow:
    """One thing to correct."""

    path: Annotated[str, "where: a path in the case, a short name or an option"]
    value: Annotated[str | None, "what stands there"]
    expected: Annotated[str, "what is expected"]
    nearest: Annotated[str | None, "nearest valid name"]


@dataclass(frozen=True)
class ProblemAnswer:
    """Input that cannot be used (exit code 2)."""

    message: Annotated[str, "all of it in words, as on standard error"]
    problems: Annotated[
        tuple[ProblemRow, ...], "every problem of a case, the first 20 of many; empty for other errors"
    ]
    result: Literal["problem"] = "problem"


def problem_answer(error: Exception) -> ProblemAnswer:
    """The answer for an error that gearlash raised on purpose."""
    found = error.problems if isinstance(error, CaseError) else ()
    rows = (
        ProblemRow(p.path, p.value, f"{p.expected} (missing)" if p.missing else p.expected, p.nearest)
        for p in found[:MOST_SHOWN]
    )
    return ProblemAnswer(str(error), tuple(rows))
