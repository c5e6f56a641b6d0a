"""The article's pair with real teeth, kept for its report: ``python -m tools.verified [WORKERS]``."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import gearlash as gl
from gearlash.article.verifying import check_numbers, plan_of_article
from gearlash.cli.answers.verify import verify_answer
from gearlash.cli.verified_data import verified_data
from gearlash.studies.verification import verification

KEPT = Path(__file__).resolve().parents[1] / "src" / "gearlash" / "article" / "verified.json"
COMMAND = "make verified"
NUMBERS = re.compile(r"\[[^\[\]{}\"]+\]")


def main(workers: int = 2) -> None:
    """Computes and writes."""
    case = gl.load_case("article")
    with gl.open_workers(case, workers) as executor:
        found = verification(case, plan=plan_of_article(), execution=gl.Execution(executor), tell=_tell)
    data = verified_data(found, verify_answer(case, found), computed(COMMAND))
    write(data | {"check": check_numbers(case)})


def write(data: dict[str, Any]) -> None:
    """Keeps what the report shows."""
    text = json.dumps(data, indent=1, ensure_ascii=False)
    KEPT.write_text(NUMBERS.sub(_on_one_line, text) + "\n", encoding="utf-8")


def computed(command: str) -> dict[str, str]:
    """Which state of the code computes: its commit, and the day of that; and with which command."""
    asked = "git", "-C", str(KEPT.parent), "log", "-1", "--format=%h %cs"
    commit, day = subprocess.run(asked, check=True, capture_output=True, text=True).stdout.split()
    return {"commit": commit, "day": day, "command": command}


def _tell(stage: str, progress: Any) -> None:
    done = "" if progress is None else f" {progress.done}/{progress.total}"
    print(f"{stage}{done}", file=sys.stderr)


def _on_one_line(found: re.Match[str]) -> str:
    return " ".join(found[0].split())


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
