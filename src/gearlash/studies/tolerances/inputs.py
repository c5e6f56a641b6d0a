"""The values of a case that have limits, as a caller names them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isfinite, nan
from typing import TypeAlias

import numpy as np

from gearlash.case import Case, CaseError, Problem
from gearlash.case.entries import Entry
from gearlash.case.limits import ends_of
from gearlash.case.quantity import Quantity
from gearlash.case.units import UnitError, unit
from gearlash.results.tolerance import LIMITS_OF_CASE, ToleranceInput
from gearlash.system import GearlashError, given, shown

from .designs import corners

Limits: TypeAlias = Mapping[str, Sequence[float | str] | str]
MOST_INPUTS = 60  # that are stated
STATED = "stated"


def read_inputs(case: Case, limits: Limits | None) -> tuple[ToleranceInput, ...]:
    """Inputs with these limits, or, where none are given, with those that the case states and the ranges of
    what it estimates. Raises `CaseError` with every problem."""
    if limits is None:
        return _of_case(case)
    limits = given.mapping("limits", limits)
    if not limits:
        raise GearlashError('limits: expected at least one, such as {"backlash": ("60 um", "120 um")}')
    if len(limits) > MOST_INPUTS:
        raise GearlashError(f"limits: {len(limits)} of them, at most {MOST_INPUTS} are looked at together")
    found, problems = [], []
    for name, ends in limits.items():
        try:
            found.append(_input(case, name, ends))
        except CaseError as error:
            problems += error.problems
    seen: dict[str, str] = {}
    for one, name in zip(found, limits, strict=False):
        if seen.setdefault(one.path, name) != name:
            problems.append(Problem(name, None, f"one of two that name the same quantity ({seen[one.path]})"))
    problems = problems or _twice(case, {one.path: one.text(one.lower) for one in found})
    if problems:
        raise CaseError("limits", problems)
    return tuple(found)


def _twice(case: Case, stated: Mapping[str, float | str]) -> list[Problem]:
    """One quantity under two names, such as D and the backlash: no combination could have both."""
    return case.content.override(stated)[1]


def inputs_beside(
    case: Case, limits: Limits | None, name: str, value: float | str
) -> tuple[ToleranceInput, ...]:
    """The inputs of a study along the axis of this name, which has this value somewhere: without the quantity
    of the axis itself where the limits are those of the case. Raises `CaseError` and `GearlashError`, also
    where the axis is no parameter, is of whole numbers, or is one of the limits by whatever name."""
    inputs = read_inputs(case, limits)
    short = case.resolve(name, value)[0]
    place = case.content.places.get(short)
    if isinstance(place, Quantity) and place.integer:
        raise GearlashError(
            f"{name} is of whole numbers: ends of bands lie between them; sweep goes over them"
        )
    own = case.entries.get(short)
    path = short if own is None else own.path
    same = [
        one
        for one in inputs
        if one.path == path or _twice(case, {name: value, one.path: one.text(one.lower)})
    ]
    if limits is not None and same:
        raise GearlashError(
            f"{name} is the axis of the study and cannot have limits as well ({same[0].path})"
        )
    left = tuple(one for one in inputs if one not in same)
    if not left:
        raise GearlashError(f"nothing but {name}, the axis of the study, has limits in this case: give some")
    return left


def check_possible(case: Case, inputs: Sequence[ToleranceInput]) -> None:
    """Raises the `GearlashError` of the least values together where no pair can have these, nor the middle
    ones, nor any corner of the limits that the study looks at: it would find combinations alone that do not
    exist."""
    first: GearlashError | None = None
    middle = [0.5 * (one.lower + one.upper) for one in inputs]
    for values in ([one.lower for one in inputs], middle, *corners(tuple(inputs)).tolist()):
        try:
            stated = {one.path: one.text(value) for one, value in zip(inputs, values, strict=True)}
            case.with_overrides(stated).family()
        except GearlashError as error:
            first = first or error
        else:
            return
    if first is not None:
        raise first


def _both(name: str, stated: Sequence[float | str] | str) -> Sequence[float | str]:
    """Two limits, also as one text, ``60:120um``, as a case file may have it."""
    ends: object = stated.tolist() if isinstance(stated, np.ndarray) else stated
    if isinstance(stated, str):
        try:
            found = ends_of(stated)
        except UnitError as error:
            raise CaseError("limits", [Problem(name, shown(stated), f"two limits ({error})")]) from None
        ends = None if found is None else [found.lower, found.upper]
    if not isinstance(ends, list | tuple) or len(ends) != 2:
        expected = 'two limits, such as ("60 um", "120 um") or "60:120um"'
        raise CaseError("limits", [Problem(name, shown(stated), expected)])
    return ends


def _input(case: Case, name: str, stated: Sequence[float | str] | str) -> ToleranceInput:
    ends = _both(name, stated)
    one, other = (_entry(case, name, end) for end in ends)
    place = case.content.places.get(one.path)
    if not isinstance(place, Quantity):
        raise CaseError("limits", [Problem(name, shown(ends), "the name of a quantity, not of an option")])
    if one.path != other.path:
        expected = f"two limits of one quantity ({one.path} and {other.path} are two)"
        raise CaseError("limits", [Problem(name, shown(ends), expected)])
    lower, upper = one.number, other.number
    if place.integer:
        raise CaseError("limits", [Problem(name, shown(ends), "a quantity that may have any value between")])
    if not lower < upper:
        raise CaseError("limits", [Problem(name, shown(ends), "two different limits, the smaller one first")])
    size = unit(place.unit)
    low, high = size.express(lower), size.express(upper)
    nominal = _nominal(case, one.path, place.unit, low, high)
    return ToleranceInput(one.path, place.unit, low, high, nominal, STATED)


def _entry(case: Case, name: str, value: float | str) -> Entry:
    """The entry that a value under this name makes; in the form that the case has it in, where that is
    another one and takes the value. Raises `CaseError`."""
    names = [v.path for v in case.values() if v.short == name and v.path in case.content.places]
    content, problems = case.content, [Problem(name, shown(value), "the name of a quantity")]
    for each in dict.fromkeys([*names, name]):
        content, problems = case.content.override({each: value})
        if not problems:
            break
    if problems:
        raise CaseError("limits", problems)
    changed = [entry for key, entry in content.entries.items() if case.entries.get(key) is not entry]
    if changed[0].limited:
        raise CaseError("limits", [Problem(name, shown(value), "one value as a limit, and no limits of it")])
    return changed[0]


def _nominal(case: Case, path: str, unit: str, lower: float, upper: float) -> float:
    """The present value, also where the case has it in another form; NaN where it has none."""
    for value in case.values():
        if value.path == path and isinstance(value.value, int | float) and isfinite(value.value):
            return float(value.value)
    try:
        (short, first), (_, last) = (case.resolve(path, f"{end!r} {unit}".strip()) for end in (lower, upper))
        share = (case.family()[0].complete({})[short] - first) / (last - first)
    except (GearlashError, KeyError):
        return nan
    return lower + share * (upper - lower)


def ranged_inputs(case: Case) -> tuple[ToleranceInput, ...]:
    """Everything of which a case states limits, then everything that it estimates with a range, or states as
    assumed with limits."""
    values = [v for v in case.values() if v.least is not None and v.path in case.content.places]
    values.sort(key=lambda value: not value.limited)
    found = tuple(
        ToleranceInput(
            value.path,
            value.unit,
            value.least,
            value.greatest,
            float(value.value),
            LIMITS_OF_CASE if value.limited else value.reason,
        )
        for value in values
        if value.least is not None and value.greatest is not None and value.least < value.greatest
    )
    curves: dict[str, list[str]] = {}
    for one in found:
        if not one.of_case:
            curves.setdefault(_first_harmonic(one.path), []).append(one.path)
    return tuple(
        one if one.of_case else replace(one, curve=_curve(curves[_first_harmonic(one.path)])) for one in found
    )


def _first_harmonic(path: str) -> str:
    """Path of the first harmonic of a higher one, such as ``mesh.ripple_4``; of anything else its own."""
    name, _, number = path.rpartition("_")
    return name if number.isdigit() else path


def _curve(harmonics: Sequence[str]) -> str:
    """What stands for all of them together; nothing for a single one."""
    return harmonics[0] if len(harmonics) > 1 else ""


def _of_case(case: Case) -> tuple[ToleranceInput, ...]:
    found = ranged_inputs(case)
    if not found:
        raise GearlashError(
            "nothing in this case is estimated with a range, and it states no limits: give some, such as "
            '{"backlash": ("60 um", "120 um")}'
        )
    return found
