"""What a folder of --out keeps: an answer to a question, until there is one that is worth as much."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .answers.outcome import INCOMPLETE
from .folder import OutFolder
from .interrupt import signalled
from .marker import Worth
from .terminal import tell

_FILES = {"plane_zone": "zone.json", "report": "verdict.json"}


def file_of(answer: Any) -> str:
    """The name of the file that an answer is kept in."""
    return _FILES.get(answer.result, f"{answer.result}.json")


def keep_answer(folder: OutFolder, answer: Any, write: Callable[[], object], name: str = "") -> bool:
    """Writes an answer and what belongs to it, unless the folder has one to the same question that is worth
    more: that stays, and is told of. Returns whether it was written. ``name``: of its file, if not the usual
    one."""
    name, worth = name or file_of(answer), worth_of(answer.status)
    earlier = folder.make_room()
    if worth < earlier.get(name, worth):
        stays = f"{folder.path} has more of the answer to this question, which stays"
        tell(f"{stays}; this one, which ended early, is not kept")
        return False
    write()
    earlier[name] = worth_of(answer.status)  # a signal may have come meanwhile, and figures were given up
    folder.note()
    return True


def worth_of(status: str) -> Worth:
    """Of an answer with this status, as far as a signal left it."""
    if status == INCOMPLETE:
        return Worth.PART
    return Worth.BARE if signalled() else Worth.WHOLE
