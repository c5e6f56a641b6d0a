"""What is wrong with a case: every problem of a file at once."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass

from gearlash.system import GearlashError

_LONGEST_VALUE = 60


@dataclass(frozen=True)
class Problem:
    """One thing to correct: where (``path``), what stands there (``value``, if anything) and what is
    expected."""

    path: str
    value: str | None
    expected: str
    nearest: str | None = None
    missing: bool = False

    def __str__(self) -> str:
        path = self.path or "''"
        head = path if self.value is None else f"{path} = {self.value}"
        head += " is missing" if self.missing else ""
        hint = f"; did you mean {self.nearest!r}?" if self.nearest else ""
        return f"{head}: expected {self.expected}{hint}"


class CaseError(GearlashError):
    """A case that cannot be used. ``problems`` holds all of them; ``exit_code`` is what a command returns."""

    exit_code = 2

    def __init__(self, source: str, problems: Iterable[Problem]):
        self.source = source
        self.problems = tuple(problems)
        count = "1 problem" if len(self.problems) == 1 else f"{len(self.problems)} problems"
        super().__init__("\n  ".join([f"{source}: {count}", *map(str, self.problems)]))


def nearest_name(name: str, valid: Iterable[str]) -> str | None:
    """The valid name that looks most like this one, large letters or small, if any does."""
    by_look = {each.casefold(): each for each in valid}
    look = name.casefold()
    if look.removesuffix("_1") in by_look:  # ripple_1: the first harmonic carries no number
        return by_look[look.removesuffix("_1")]
    found = difflib.get_close_matches(look, list(by_look), n=1, cutoff=0.5)
    return by_look[found[0]] if found else None


def shown(value: object) -> str:
    """A value as it appears in a problem: its repr, cut to a readable length."""
    text = repr(value)
    return text if len(text) <= _LONGEST_VALUE else text[: _LONGEST_VALUE - 1] + "…"
