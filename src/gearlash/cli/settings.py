"""How far the search for an attractor goes, from what was typed."""

from __future__ import annotations

from dataclasses import replace

from gearlash.case import CaseError, Problem
from gearlash.orbits import Settings
from gearlash.system import Family


def search_settings(family: Family, periods: int | None, max_period: int | None, case: str) -> Settings:
    """The defaults, with what was given. The command line counts cycles of ω, a search counts base periods:
    of a system whose base period is several cycles, as many as are whole."""
    cycles, settings, problems = family.system().cycles, Settings(), []
    for option, field, given in (
        ("--periods", "budget", periods),
        ("--max-period", "max_period", max_period),
    ):
        if given is None:
            continue
        if given < cycles:
            expected = f"{cycles} or more: one base period of this system is {cycles} cycles of ω"
            problems.append(Problem(option, repr(given), expected))
        settings = replace(settings, **{field: max(1, given // cycles)})
    if problems:
        raise CaseError(case, problems)
    return settings
