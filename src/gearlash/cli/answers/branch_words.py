"""The sentence that branches are told in."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from .asked import Asked

if TYPE_CHECKING:
    from .branch_parts import BesideFound, BranchFound, BranchStart, LimitsUsed, StretchFound

MOST_NAMED = 2  # intervals in the sentence, and labels in each: the tables have all
LONGEST_MESSAGE = 60  # characters of it in the sentence
NOT_LOOKED_FOR = (
    "motions on branches that no special point here leads to",
    "quasi-periodic and chaotic motions",
    "two changes of one kind within one step that undo each other",
)
PLURALS = {"branch point": "branch points", "end of existence": "ends of existence"}


def sentence(
    limits: LimitsUsed,
    start: BranchStart,
    branches: Sequence[BranchFound],
    beside: Sequence[BesideFound],
    status: str,
    message: str,
) -> str:
    """Such as ``pinion speed from 3000 to 4500 rpm, through 1-0 at 4000 rpm: 2 grazings and 1 doubling found;
    stable from 3521 to 4301 rpm``."""
    asked = limits.asked
    here = f"{asked.span(limits.lower, limits.upper)}, from {start.label or start.status} at " + asked.text(
        start.value
    )
    if not branches:
        return f"{here}: no branch was followed, {message}"
    many = f"{len(branches)} branches, " if len(branches) > 1 else ""
    text = f"{here}: {many}{_counted(branches)}; {_stable(asked, start, branches)}"
    if beside:
        shown = [f"{' beside '.join(each.labels)} {_interval(asked, each.low, each.high)}" for each in beside]
        text += f"; stable motions coexist: {_several(shown, 1)}"
    if not message:
        return text
    return f"{text}; {status}, {message if len(message) <= LONGEST_MESSAGE else 'see the message'}"


def _counted(branches: Sequence[BranchFound]) -> str:
    kinds = Counter(
        "joins" if special.kind.startswith("joins") else special.kind
        for branch in branches
        for special in branch.special
    )
    if not kinds:
        return "no special point found"
    return f"{_listed([_many(kind, count) for kind, count in kinds.items()])} found"


def _many(kind: str, count: int) -> str:
    if kind.startswith("joins"):
        return f"{count} point{'s' if count > 1 else ''} of joining"
    if kind == "Neimark-Sacker":
        return f"{count} Neimark-Sacker point{'s' if count > 1 else ''}"
    return f"{count} {kind if count == 1 else PLURALS.get(kind, kind + 's')}"


def _stable(asked: Asked, start: BranchStart, branches: Sequence[BranchFound]) -> str:
    """Where the orbits of the first branch are stable, the interval of the start first. Stretches that follow
    each other are one interval."""
    runs: list[list[StretchFound]] = []
    before = None
    for each in branches[0].stretches:
        if each.stable and before is not None and before.stable and _meet(before, each):
            runs[-1].append(each)
        elif each.stable:
            runs.append([each])
        before = each
    one = "branch 1" if len(branches) > 1 else "it"
    if not runs:
        return f"no stable orbit on {one}"
    runs.sort(key=lambda run: not any(_holds(each, start) for each in run))
    shown = [
        f"{_few([*dict.fromkeys(each.label for each in run)])} "
        f"{_interval(asked, min(each.low for each in run), max(each.high for each in run))}"
        for run in runs
    ]
    return f"stable{' on branch 1' if len(branches) > 1 else ''}: {_several(shown)}"


def _holds(stretch: StretchFound, start: BranchStart) -> bool:
    return stretch.label == start.label and stretch.low <= start.value <= stretch.high


def _few(labels: Sequence[str]) -> str:
    left = len(labels) - MOST_NAMED
    return f"{', '.join(labels[:MOST_NAMED])} and {left} more labels" if left > 1 else _listed(labels)


def _meet(one: StretchFound, other: StretchFound) -> bool:
    """Whether the parameter goes on in its direction."""
    return one.high == other.low or one.low == other.high


def _interval(asked: Asked, low: float, high: float) -> str:
    """Rounded into it."""
    ends = asked.inner(low, high)
    return f"from {asked.between(*ends) if asked.unit else f'{ends[0]} to {ends[1]}'}"


def _several(shown: Sequence[str], most: int = MOST_NAMED) -> str:
    left = len(shown) - most
    return ", ".join(shown[:most]) + (f" and {left} more" if left > 0 else "")


def _listed(words: Sequence[str]) -> str:
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
