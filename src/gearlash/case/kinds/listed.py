"""Values at listed places, each named by its path or by its key (its short name)."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TypeAlias

from gearlash.case.entries import Entries, Entry, entry_of, overridden
from gearlash.case.errors import CaseError, Problem, shown
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.stated import Stated, ValueRefusedError, read_one, read_stated
from gearlash.case.units import unit
from gearlash.case.value import Value
from gearlash.case.words import nearest_name
from gearlash.system import UnknownNameError

Place: TypeAlias = Quantity | Choice
Places: TypeAlias = Mapping[str, Place]


def key_of(place: Place) -> str:
    """The short name of a quantity, else its path."""
    return (place.key if isinstance(place, Quantity) else "") or place.path


def find(places: Places, name: str) -> Place | None:
    """The place of a path or of a key."""
    return places.get(name) or next((p for p in places.values() if key_of(p) == name), None)


def entry(place: Place, stated: Stated) -> Entry:
    """The entry of a value stated at a place."""
    return entry_of(key_of(place), place.path, stated)


def entries(places: Places, stated: Mapping[str, Stated]) -> Entries:
    """Stated values by key, in the order of their places."""
    found = (entry(place, stated[path]) for path, place in places.items() if path in stated)
    return {each.key: each for each in found}


def ordered(places: Places, entries: Mapping[str, Entry]) -> Entries:
    """Entries in the order of their places."""
    return {key: entries[key] for key in map(key_of, places.values()) if key in entries}


def missing(places: Places, entries: Mapping[str, Entry], present: Collection[str]) -> list[Problem]:
    """Quantities that are not stated; ``present`` are paths of those that are, if wrongly."""
    return [
        Problem(path, None, place.expected, missing=True)
        for path, place in places.items()
        if isinstance(place, Quantity) and key_of(place) not in entries and path not in present
    ]


def override(
    places: Places, entries: Mapping[str, Entry], overrides: Mapping[str, object]
) -> tuple[Entries, list[Problem]]:
    """Entries with these replaced, by path or key."""
    replaced: Entries = {}
    first: dict[str, str] = {}
    problems: list[Problem] = []
    for name, raw in overrides.items():
        place = find(places, name)
        if place is None:
            keys = [key_of(each) for each in places.values() if isinstance(each, Quantity)]
            expected = "a parameter or path that exists here"
            problems.append(Problem(name, None, expected, nearest_name(name, [*keys, *places])))
            continue
        if place.path in first:
            both = f"{first[place.path]} = {shown(overrides[first[place.path]])} and {name} = {shown(raw)}"
            problems.append(Problem(name, shown(raw), f"one of two that name the same quantity: {both}"))
            continue
        first[place.path] = name
        try:
            found = entry(place, overridden(read_stated(raw, place)))
        except ValueRefusedError as error:
            problems.append(Problem(name, shown(raw), error.expected, error.nearest))
            continue
        replaced[found.key] = found
    return ordered(places, {**entries, **replaced}), problems


def resolve(
    places: Places, parameters: Collection[str], label: str, name: str, value: object
) -> tuple[str, float]:
    """Name and value (SI) of a parameter named by path or key. Raises `CaseError` for a bad value and
    `UnknownNameError` for a name that is no parameter."""
    place = find(places, name)
    if not isinstance(place, Quantity) or key_of(place) not in parameters:
        raise UnknownNameError("parameter to vary", name, parameters)
    try:
        return key_of(place), float(read_one(value, place).value)
    except ValueRefusedError as error:
        raise CaseError(label, [Problem(name, shown(value), error.expected, error.nearest)]) from None


def values(places: Places, entries: Mapping[str, Entry]) -> list[Value]:
    """Every stated value as shown to a person."""
    found = []
    for e in entries.values():
        place = places[e.path]
        value, its_unit = (
            (displayed(e.number, place), place.unit) if isinstance(place, Quantity) else (e.value, "")
        )
        short = e.key if e.key != e.path else None
        ends = limits(e, place)
        found.append(
            Value(
                e.path, value, its_unit, e.provenance, e.reason, short, place.description, (), e.text, *ends
            )
        )
    return found


def limits(entry: Entry, place: Place | None) -> tuple[float | None, float | None]:
    """Range of an estimate, or stated limits, in the display unit."""
    if not isinstance(place, Quantity) or entry.least is None or entry.greatest is None:
        return None, None
    return displayed(entry.least, place), displayed(entry.greatest, place)


def displayed(value: float, place: Quantity) -> float:
    """A value in SI in its display unit, to the 15 digits that survive going there and back."""
    return int(value) if place.integer else float(f"{unit(place.unit).express(value):.15g}")
