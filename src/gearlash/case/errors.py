"""What is wrong with a case: every problem of a file at once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from gearlash.system import GearlashError, short_text
from gearlash.system.short_text import cut

_LONGEST = {"path": 120, "value": 120, "expected": 600, "nearest": 60}
MOST_SHOWN = 20
"""Problems of a case that are told; of a thousand of one kind the first tell as much."""


@dataclass(frozen=True)
class Problem:
    """One thing to correct in a case.

    Attributes
    ----------
    path : str
        Where it stands.
    value : str or None
        What stands there, cut to a readable length; None where nothing does.
    expected : str
        What is expected there, in words.
    nearest : str or None
        The valid name that looks most like the one that is there.
    missing : bool
        Whether something has to be stated and is not.

    Examples
    --------
    >>> from gearlash.case import Problem
    >>> print(Problem("mesh.backlach", "'100 um'", "a name that exists here", "mesh.backlash"))
    mesh.backlach = '100 um': expected a name that exists here; did you mean 'mesh.backlash'?
    """

    path: str
    value: str | None
    expected: str
    nearest: str | None = None
    missing: bool = False

    def __post_init__(self) -> None:
        for name, length in _LONGEST.items():
            text = getattr(self, name)
            if text is not None:
                object.__setattr__(self, name, cut(text, length))

    def __str__(self) -> str:
        path = self.path or "''"
        head = path if self.value is None else f"{path} = {self.value}"
        head += " is missing" if self.missing else ""
        hint = f"; did you mean {self.nearest!r}?" if self.nearest else ""
        return f"{head}: expected {self.expected}{hint}"


class CaseError(GearlashError):
    """A case that cannot be used.

    Parameters
    ----------
    source : str
        The file, or what stands for it.
    problems : iterable of Problem
        All of them; the message shows the first twenty.

    Attributes
    ----------
    problems : tuple of Problem
    exit_code : int
        What a command returns: 2.

    Examples
    --------
    >>> from gearlash.case import CaseError, load
    >>> try:
    ...     load("article", {"backlach": "100 um", "load": "1 kg"})
    ... except CaseError as error:
    ...     for problem in error.problems:
    ...         print(problem.path, problem.nearest)
    backlach backlash
    load None
    """

    exit_code = 2

    def __init__(self, source: str, problems: Iterable[Problem]):
        self.problems = tuple(problems)
        self.source, many = cut(source, 200), len(self.problems)
        count = "1 problem" if many == 1 else f"{many:,} problems"
        lines = [f"{self.source}: {count}", *map(str, self.problems[:MOST_SHOWN])]
        if many > MOST_SHOWN:
            lines.append(f"and {many - MOST_SHOWN:,} more")
        super().__init__("\n  ".join(lines))


def shown(value: object) -> str:
    """A value as it appears in a problem: texts and numbers as they stand, cut to a readable length."""
    if isinstance(value, str):
        return cut(repr(value[: short_text.LONGEST_TEXT]))
    if isinstance(value, int) and value.bit_length() < 10_000:  # Python turns no longer ones into digits
        return cut(repr(value))
    return short_text.shown(value)
