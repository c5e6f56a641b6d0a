"""`python -m recorded.compare` (in `tests`): runs the commands again and lists what is not as recorded.

Equal to the last digit: labels, statuses, states, multipliers, exponents and all else that is computed.
Equal to `SOLVED_WITHIN`: what is solved for (events, edges of zones), with the same kinds and labels.
Passed over: prose, and what tells of the run (versions, hashes, seconds).

The recording was made on one machine. Another processor, or other versions of numpy and scipy, can change
last digits and what follows from them in aperiodic motion: there, record at the commit that made the
recording (`git log` of the data) and compare on one machine.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from typing import Any

from gearlash.system import Status

from .commands import COMMANDS
from .record import kept, record

NEW_NAMES: dict[str, str] = {}
"""Old name → new name of a field or of a value that is a word: the one table of what was renamed since."""

ADVICE = {status.advice for status in Status}
"""What stood behind the reasons of some certificates: since then advice is told beside a reason only."""

PROSE = {"sentence", "message", "advice", "ended", "reason", "note", "notes", "beyond", "expected", "remark"}
OF_THE_RUN = {"gearlash", "hash", "seconds", "duration", "created", "workers", "process", "python", "numpy"}
OF_THE_RUN |= {"report"}  # where it was written to
SOLVED = {
    "value",
    "lower",
    "upper",
    "margin",
    "margin_asked",
    "below",
    "above",
    "uncertainty",
    "nearest",
    "lower_rpm",
    "upper_rpm",
}
SOLVED |= {"deviation"}  # of what is solved for from what an article printed
SOLVED_WITHIN = 1e-10


def differences(old: Any, new: Any, at: str = "", *, loose: float = 0.0) -> Iterator[str]:
    """What of a recording is not met, one line each. `loose`: relative tolerance of numbers that are not
    solved for.
    """
    if isinstance(old, dict) and isinstance(new, dict):
        yield from _of_fields(old, new, at, loose)
    elif isinstance(old, list) and isinstance(new, list):
        if len(old) != len(new):
            yield f"{at}: {len(new)} entries, recorded {len(old)}"
        for place, (left, right) in enumerate(zip(old, new, strict=False)):
            yield from differences(left, right, f"{at}/{place}", loose=loose)
    elif not _equal(old, new, at, loose):
        yield f"{at}: {new!r}, recorded {old!r}"


def _of_fields(old: dict[str, Any], new: dict[str, Any], at: str, loose: float) -> Iterator[str]:
    for name, value in old.items():
        if name in PROSE | OF_THE_RUN:
            continue
        now = NEW_NAMES.get(name, name)
        if now not in new:
            yield f"{at}/{now}: missing"
        else:
            yield from differences(value, new[now], f"{at}/{now}", loose=loose)


def _equal(old: Any, new: Any, at: str, loose: float) -> bool:
    if isinstance(old, str):
        return NEW_NAMES.get(old, old) == new or any(old == f"{new}: {advice}" for advice in ADVICE)
    if isinstance(old, bool) or not (isinstance(old, float) and isinstance(new, float)):
        return old == new
    solved = SOLVED & set(at.split("/")[-2:])
    within = max(loose, SOLVED_WITHIN if solved else 0.0)
    return (
        old == new or (math.isnan(old) and math.isnan(new)) or abs(old - new) <= within * max(1.0, abs(old))
    )


def main(names: list[str]) -> int:
    """Compares the commands of these names, or all. Returns 1 where something differs."""
    bad = 0
    for command in COMMANDS:
        if names and command.name not in names:
            continue
        found = list(differences(kept(command.name), record(command)))
        bad += bool(found)
        print(command.name, "equal" if not found else f"{len(found)} differ", flush=True)
        for line in found[:20]:
            print("   ", line)
    return int(bad > 0)


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
