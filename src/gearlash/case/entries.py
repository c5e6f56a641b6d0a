"""Stated values sorted by what they mean: one entry a quantity, however it was named."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from .errors import Problem, nearest_name
from .quantities import BEARINGS, REFERENCE, choices, quantities, two_way
from .quantity import Choice, Quantity
from .stated import Provenance, Stated, ValueRefusedError, read_stated


@dataclass(frozen=True)
class Entry:
    """A quantity (``key``), the ``path`` it was named by, its value in SI, text, provenance and reason."""

    key: str
    path: str
    value: float | str
    text: str
    provenance: Provenance
    reason: str

    @property
    def number(self) -> float:
        return float(self.value)

    @property
    def dimensionless(self) -> bool:
        return self.path.startswith("dimensionless.")


Entries = dict[str, Entry]
BY_OVERRIDE = "set by an override"
"""The reason of a value that an override set without one of its own."""


def collect(kind: str, stated: Mapping[str, Stated]) -> tuple[Entries, list[Problem]]:
    """Entries by key. One quantity named twice is a problem that shows both places and values."""
    entries: Entries = {}
    clashes: dict[tuple[str, str], Problem] = {}
    for path in sorted(stated, key=lambda path: (path.startswith("dimensionless."), path)):
        for entry in entries_of(kind, path, stated[path]):
            other = entries.setdefault(entry.key, entry)
            if other.path != path:
                both = f"{other.path} = {other.text!r} and {path} = {entry.text!r}"
                clashes[other.path, path] = Problem(
                    path, repr(entry.text), f"one of two that name the same quantity: {both}"
                )
    return entries, list(clashes.values())


def entries_of(kind: str, path: str, stated: Stated) -> list[Entry]:
    """The entries that one stated value makes: one, or four for the damping of all bearings."""
    place = quantities(kind).get(path)
    key = place.key if place else path
    keys = [f"bearing_damping_{b}" for b in BEARINGS] if key == "bearing_damping" else [key]
    return [Entry(k, path, stated.value, stated.text, stated.provenance, stated.reason) for k in keys]


def freeze_reference(entries: Entries) -> Entries:
    """With D_c settled: the stated one, else half the backlash of the file. Overrides come after this."""
    gap = entries.get("D")
    if REFERENCE in entries or gap is None or gap.dimensionless or gap.number == 0.0:
        return entries
    half = gap.number / 2.0
    reason = "half the backlash of the case file"
    entry = Entry(REFERENCE, REFERENCE, half, f"{half!r} m", gap.provenance, reason)
    return {**entries, REFERENCE: entry}


def place_of(kind: str, name: str) -> Quantity | Choice | Problem:
    """The quantity or option that a full path, a short name or an unambiguous last name stands for."""
    places: dict[str, Quantity | Choice] = {**quantities(kind), **choices(kind)}
    if name in places:
        return places[name]
    if name in two_way(kind):
        return places[f"dimensionless.{name}"]
    ending = [
        path for path in places if path.rpartition(".")[2] == name and not path.startswith("dimensionless.")
    ]
    if len(ending) == 1:
        return places[ending[0]]
    if ending:
        return Problem(name, None, f"one of {', '.join(ending)}")
    known = {*places, *two_way(kind), *(path.rpartition(".")[2] for path in places)}
    return Problem(name, None, "a path or short name that exists here", nearest_name(name, known))


def override(kind: str, entries: Entries, overrides: Mapping[str, object]) -> tuple[Entries, list[Problem]]:
    """Entries with these replaced, by path or short name; D_c is not to be moved."""
    problems: list[Problem] = []
    stated: dict[str, Stated] = {}
    for name, raw in overrides.items():
        place = place_of(kind, name)
        if isinstance(place, Problem):
            problems.append(place)
        elif place.path == REFERENCE:
            problems.append(Problem(name, repr(raw), "no override: D_c is settled when the file is loaded"))
        elif place.path in stated:
            first = next(n for n in overrides if n != name and _path_of(kind, n) == place.path)
            both = f"{first} = {overrides[first]!r} and {name} = {raw!r}"
            problems.append(Problem(name, repr(raw), f"one of two that name the same quantity: {both}"))
        else:
            try:
                value = read_stated(raw, place)
            except ValueRefusedError as error:
                problems.append(Problem(name, repr(raw), error.expected, error.nearest))
            else:
                stated[place.path] = overridden(value)
    replaced, clashes = collect(kind, stated)
    return {**entries, **replaced}, problems + clashes


def _path_of(kind: str, name: str) -> str | None:
    place = place_of(kind, name)
    return None if isinstance(place, Problem) else place.path


def overridden(stated: Stated) -> Stated:
    """With the reason that an override gives, unless it states its own."""
    if stated.reason:
        return stated
    return Stated(stated.value, stated.text, stated.provenance, BY_OVERRIDE)
