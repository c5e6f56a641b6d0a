"""Limits and axes as typed, in the units that they were typed in."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from gearlash.case import CaseError, Problem
from gearlash.case.limits import ends_of
from gearlash.case.units import UnitError, behind_number, in_unit_of

from .inputs import parts_of

if TYPE_CHECKING:
    from gearlash.results import Axis

MOST_VALUES = 10_000


def read_limits(texts: Iterable[str] | None) -> dict[str, tuple[str, str]] | None:
    """``NAME=FROM:TO`` as names with both ends, which may be written as in a case file. None without any."""
    found: dict[str, tuple[str, str]] = {}
    problems = []
    for text in texts or ():
        name, equals, span = (part.strip() for part in text.partition("="))
        try:
            ends, why = ends_of(span), ""
        except UnitError as error:
            ends, why = None, f" ({error})"
        if not (name and equals) or ends is None:
            problems.append(Problem("--limits", repr(text), f"NAME=FROM:TO, such as backlash=60:120um{why}"))
        elif name in found:
            problems.append(Problem("--limits", repr(text), f"each name once ({name} is given twice)"))
        else:
            found[name] = ends.lower, ends.upper
    if problems:
        raise CaseError("--limits", problems)
    return found or None


def read_axis(text: str) -> Axis:
    """``NAME=FROM:TO:COUNT`` as an axis in the unit typed."""
    from gearlash.results import Axis

    example = "NAME=FROM:TO:COUNT, such as omega=0.5:1.4:90 or pinion_speed=1000:6000rpm:90"
    name, parts = parts_of(text, 3, example)
    if not (parts[2].isascii() and parts[2].isdigit() and 2 <= int(parts[2][:9]) <= MOST_VALUES):
        expected = f"a number of values from 2 to {MOST_VALUES:,}, in digits, such as 90"
        raise CaseError("--over", [Problem(f"--over {name}", repr(parts[2]), expected)])
    lower, upper = _with_unit(*parts[:2])
    plain = not behind_number(upper)
    ends = (float(lower), float(upper)) if plain and _number(lower) and _number(upper) else (lower, upper)
    return Axis.even(name, *ends, int(parts[2]))


def _with_unit(lower: str, upper: str) -> tuple[str, str]:
    return in_unit_of(upper, lower), upper


def _number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
