"""The folder of a report keeps the report of another command, or of a case of another name."""

from __future__ import annotations

import json
from pathlib import Path

from gearlash.case import Case
from gearlash.case.files import UnreadableError, read_file
from gearlash.system import GearlashError, given, shown

RECORDS = {"report": "verdict.json", "reproduce": "reproduce.json"}
"""Commands that write a report, each with the file of its answer beside the page."""
LARGEST_RECORD = 100_000_000  # bytes


def keep_others(out: Path, command: str, case: Case) -> None:
    """Raises `GearlashError` where another report lies in the folder: who looks at two pairs in turn does not
    mean the second page to take the place of the first.

    Parameters
    ----------
    out : Path
        The folder of --out.
    command : str
        That is going to write, one of `RECORDS`.
    case : Case
        Of the report to come. Cases are told apart by their names.
    """
    folder = given.path("--out", out)
    for other, record in RECORDS.items():
        if not (folder / record).exists():
            continue
        name = _case_in(folder / record)
        if other == command and name in (case.name, None):
            continue
        whose = "" if name is None else f" of {shown(name)}"
        raise GearlashError(
            f"--out {out}: the report{whose} is there, written by gearlash {other}; choose another folder, "
            f"such as --out {case.name}-{command}, or take that one away"
        )


def _case_in(record: Path) -> str | None:
    """Name of the case that an answer tells of; None where it cannot be read."""
    try:
        return str(json.loads(read_file(record, LARGEST_RECORD))["case"]["name"])
    except (UnreadableError, ValueError, KeyError, TypeError, RecursionError):
        return None
