"""What a user typed, read: cases with overrides, starting states, swept parameters. Every failure is a
`CaseError` or another `GearlashError` that says what to type instead.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING

from gearlash.case import Case, CaseError, Problem, load
from gearlash.case.files import UnreadableError, read_file
from gearlash.case.limits import ends_of
from gearlash.case.units import UnitError, behind_number
from gearlash.case.words import nearest_name
from gearlash.system import Family, GearlashError, UnknownNameError, given

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

MOST_POINTS = 1_000_000
LARGEST_RUN = 20_000_000  # bytes of run.json


@dataclass(frozen=True)
class Over:
    """A parameter to vary: as it was named, its short name, dimensionless values, ascending, and the unit
    that its ends were typed in (empty: none)."""

    named: str
    short: str
    values: NDArray[np.float64]
    unit: str = ""


def read_case(name: str, settings: Iterable[str] | None = None, over: Iterable[str] = ()) -> Case:
    """The case in a file or the bundled one, with every ``NAME=VALUE`` of --set; all problems at once. What
    ``over`` names (``NAME=…``, or a name) varies in its family, where it can."""
    overrides, problems = assignments(settings or (), "--set")
    try:
        case = load(name, overrides)
    except CaseError as error:
        raise CaseError(name, [*problems, *error.problems]) from None
    if problems:
        raise CaseError(name, problems)
    for text in over:
        with suppress(UnknownNameError, CaseError):  # told, with what is valid, where its values are read
            case = case.varying(text.partition("=")[0].strip())
    return case


def assignments(texts: Iterable[str], option: str) -> tuple[dict[str, str], list[Problem]]:
    """Texts ``NAME=VALUE`` as a mapping, and what is wrong with them."""
    found: dict[str, str] = {}
    problems = []
    for text in texts:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not (name and equals and value):
            problems.append(Problem(option, repr(text), "NAME=VALUE, such as omega=0.942"))
        elif name in found:
            both = f"{name} = {found[name]!r} and {name} = {value!r}"
            problems.append(Problem(option, repr(text), f"each name once, not {both}"))
        else:
            found[name] = value
    return found, problems


def read_start(
    family: Family, parameters: Mapping[str, float], texts: Iterable[str] | None
) -> dict[str, float]:
    """The starting state by name: the cold start, with every ``STATE=VALUE`` of --initial, or the state in
    the JSON of an earlier run (a file name).
    """
    cold = family.start(parameters)
    start = dict(zip(family.states, (float(x) for x in cold), strict=True))
    texts = list(texts or ())
    for text in (t for t in texts if "=" not in t):
        start |= _state_of_file(text, family.states)
    named, problems = assignments((t for t in texts if "=" in t), "--initial")
    for name, text in named.items():
        value = _number(text)
        if name not in start:
            problems.append(
                Problem(f"--initial {name}", None, f"a state out of {', '.join(start)}", _near(name, start))
            )
        elif value is None:
            problems.append(Problem(f"--initial {name}", repr(text), "a finite number, dimensionless"))
        else:
            start[name] = value
    if problems:
        raise CaseError("--initial", problems)
    return start


def read_over(case: Case, text: str, settings: Iterable[str] | None = None, hint: str = "") -> Over:
    """``NAME=FROM:TO:COUNT``, ends as they would stand in the case: ``pinion_speed=1000rpm:6000rpm:500``; a
    unit behind TO holds for FROM too. ``hint``: what the command has for a falling interval."""
    from gearlash.results.axis import evenly

    general = "omega=0.5:1.4:900 or pinion_speed=1000rpm:6000rpm:500"
    name, parts = parts_of(text, 3, f"NAME=FROM:TO:COUNT, such as {_example(case, text, ':500') or general}")
    short, first, last = _ends(case, name, parts)
    problems, here = [], f"--over {name}"
    digits = parts[2].isascii() and parts[2].isdigit() and len(parts[2]) < 20
    count = int(parts[2]) if digits else 0
    if not 2 <= count <= MOST_POINTS:
        expected = f"a number of points from 2 to {MOST_POINTS:,}, in digits, such as 200"
        problems.append(Problem(here, repr(parts[2]), expected))
    if not first < last:
        expected = "a rising interval FROM < TO" + hint
        problems.append(Problem(here, repr(f"{parts[0]}:{parts[1]}"), expected))
    problems += twice_named(case, name, short, settings)
    if problems:
        raise CaseError("--over", problems)
    return Over(case.named(name, parts[1]), short, evenly(first, last, count), behind_number(parts[1]))


@dataclass(frozen=True)
class TypedLimits:
    """A parameter and two limits of it: as it was named, its short name, dimensionless limits, and the unit
    that they were typed in (empty: none)."""

    named: str
    short: str
    lower: float
    upper: float
    unit: str = ""


def read_between(case: Case, text: str) -> TypedLimits:
    """``NAME=FROM:TO``, ends as they would stand in the case; a unit behind TO holds for FROM too."""
    general = "omega=0.5:1.4 or pinion_speed=3000:4500rpm"
    example = f"NAME=FROM:TO, such as {_example(case, text) or general}, without a number of points"
    name, parts = parts_of(text, 2, example)
    short, first, last = _ends(case, name, parts)
    if not first < last:
        expected = "a rising interval FROM < TO (it is followed both ways)"
        raise CaseError("--over", [Problem(f"--over {name}", repr(f"{parts[0]}:{parts[1]}"), expected)])
    return TypedLimits(case.named(name, parts[1]), short, first, last, behind_number(parts[1]))


def parts_of(text: str, count: int, example: str) -> tuple[str, list[str]]:
    """The name and the ``count`` parts behind it."""
    name, equals, span = (part.strip() for part in text.partition("="))
    parts = [part.strip() for part in span.split(":")]
    if not equals or len(parts) != count:
        raise CaseError("--over", [Problem("--over", repr(text), example)])
    return name, parts


def _example(case: Case, text: str, count: str = "") -> str:
    """An interval about the value that the named quantity has in the case, in its unit; empty where the text
    names none."""
    name = text.partition("=")[0].strip()
    known = case.family()[0].defaults
    found = [(known[name], "")] if name in known else []
    found += [
        (v.value, v.unit)
        for v in case.values()
        if name in (v.path, v.path.rpartition(".")[2]) and not isinstance(v.value, str)
    ]
    if not found or not isinstance(found[0][0], float | int) or not found[0][0] > 0.0:
        return ""
    value, unit = float(found[0][0]), found[0][1]
    low, high = (f"{float(f'{factor * value:.3g}'):g}" for factor in (0.5, 1.5))
    try:
        for end in (low, high):
            case.resolve(name, f"{end}{unit}")
    except GearlashError:
        return ""  # nothing that can be varied so: told once the form is right
    return f"{name}={low}:{high}{unit}{count}"


def _ends(case: Case, name: str, parts: list[str]) -> tuple[str, float, float]:
    """Short name and both ends, dimensionless."""
    short, last = case.resolve(name, parts[1])
    if _number(parts[0]) is not None:
        parts[0] += behind_number(parts[1])
    return short, case.resolve(name, parts[0])[1], last


def read_plane(case: Case, texts: Sequence[str], settings: Iterable[str] | None = None) -> tuple[Over, Over]:
    """The two axes of a map, each as `read_over` takes it; all problems at once."""
    from gearlash.results.plane import MOST_PIXELS

    problems, axes = [], []
    for text in texts:
        try:
            axes.append(read_over(case, text, settings))
        except CaseError as error:
            problems += error.problems
    if len(texts) != 2:
        expected = "two of them, such as --over omega=0.5:1.4:200 --over D=0.2:1.2:200"
        problems.append(Problem("--over", f"{len(texts)} given", expected))
    elif not problems and axes[0].short == axes[1].short:
        both = f"{axes[0].named} and {axes[1].named}"
        problems.append(Problem("--over", repr(both), "two that do not name the same quantity"))
    elif not problems and len(axes[0].values) * len(axes[1].values) > MOST_PIXELS:
        pixels = f"{len(axes[0].values)} × {len(axes[1].values)}"
        problems.append(Problem("--over", repr(pixels), f"{MOST_PIXELS:,} pixels at the most"))
    if problems:
        raise CaseError("--over", problems)
    return axes[0], axes[1]


def read_near(
    case: Case, name: str, value: str | None, settings: Iterable[str] | None
) -> tuple[str, dict[str, float]]:
    """Short name of a parameter named by path or short name, and its value if one is given."""
    if "=" in name:
        expected = "the name of a parameter alone, such as pinion_speed (--near has the value to begin at)"
        raise CaseError("--over", [Problem("--over", repr(name), expected)])
    if value is None:
        return _short_name(case, name), {}
    short, number = case.resolve(name, value)
    problems = twice_named(case, name, short, settings)
    if problems:
        raise CaseError("--near", problems)
    return short, {short: number}


def named_near(case: Case, name: str, value: str | None) -> tuple[str, str]:
    """The quantity that is meant by a name and the value typed with it, and that value's unit."""
    return (name, "") if value is None else (case.named(name, value), behind_number(value))


def _short_name(case: Case, name: str) -> str:
    """Raises `GearlashError` with the nearest valid name."""
    known = case.family()[0].defaults
    if name in known:
        return name
    for short, value in known.items():
        if any(name in (path, path.rpartition(".")[2]) for path, _, _ in case.physical(short, value)):
            return short
    return case.resolve(name, "1")[0]  # raises, and names what is valid


def twice_named(case: Case, name: str, short: str, settings: Iterable[str] | None) -> list[Problem]:
    """A parameter that is varied and set too."""
    problems = []
    for setting, value in assignments(settings or (), "--set")[0].items():
        if _short(case, setting, value) == short:
            both = f"--over {name} and --set {setting}={value}"
            problems.append(Problem("--over", name, f"one of two that name the same quantity: {both}"))
    return problems


def _short(case: Case, name: str, value: str) -> str | None:
    """The parameter that is set; None for what is none: it cannot be the one varied."""
    for text in (value, _greater(value)):
        with suppress(GearlashError):
            return case.resolve(name, text)[0]
    return None


def _greater(text: str) -> str:
    """Of two limits; a value without such as it is."""
    try:
        ends = ends_of(text)
    except UnitError:
        return text
    return text if ends is None else ends.upper


def _state_of_file(name: str, states: Iterable[str]) -> dict[str, float]:
    expected = f"STATE=VALUE or the JSON of an earlier run with the states {', '.join(states)}"
    try:
        data = json.loads(read_file(given.path("--initial", name), LARGEST_RUN))
        state = {str(k): float(v) for k, v in data["state"].items()}
    except UnreadableError as error:
        raise CaseError("--initial", [Problem("--initial", repr(name), f"{expected} ({error})")]) from None
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError):
        raise CaseError("--initial", [Problem("--initial", repr(name), expected)]) from None
    if set(state) != set(states) or not all(isfinite(x) for x in state.values()):
        raise CaseError("--initial", [Problem("--initial", repr(name), expected)])
    return state


def _number(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if isfinite(value) else None


def _near(name: str, valid: Iterable[str]) -> str | None:
    return nearest_name(name, valid)
