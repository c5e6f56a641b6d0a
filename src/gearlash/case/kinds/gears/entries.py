"""Stated values of a gear pair sorted by what they mean: one entry a quantity, however it was named."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from gearlash.case.entries import Entries, Entry, entry_of, overridden
from gearlash.case.errors import Problem, shown
from gearlash.case.limits import ends_of
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.stated import Stated, ValueRefusedError, read_stated
from gearlash.case.units import ANGLE, NUMBER, Unit, UnitError, read, takes
from gearlash.case.words import nearest_name

from .drawn import GEOMETRY, contradicted, rivals
from .keys import REFERENCE
from .places import Places
from .supports import no_bearings


def collect(places: Places, stated: Mapping[str, Stated]) -> tuple[Entries, list[Problem]]:
    """Entries by key. One quantity named twice is a problem that shows both places and values."""
    entries: Entries = {}
    clashes: dict[tuple[str, str], Problem] = {}
    for path in sorted(stated, key=lambda path: (path.startswith("dimensionless."), path)):
        for entry in entries_of(places, path, stated[path]):
            other = entries.setdefault(entry.key, entry)
            if other.path != path:
                both = f"{other.path} = {other.text!r} and {path} = {entry.text!r}"
                clashes[other.path, path] = Problem(
                    path, repr(entry.text), f"one of two that name the same quantity: {both}"
                )
    both = [*clashes.values()]
    for one, other in contradicted(entries):
        first, second = entries[one], entries[other]
        named = f"{first.path} = {first.text!r} and {second.path} = {second.text!r}"
        expected = f"one of two that name the same quantity: {named}"
        both.append(Problem(second.path, repr(second.text), expected))
    return entries, both


def entries_of(places: Places, path: str, stated: Stated) -> list[Entry]:
    """The entries that one stated value makes: one, or several (the damping of all bearings)."""
    keys = places.keys(places.all[path])
    return [entry_of(key, path, stated) for key in keys]


def freeze_reference(entries: Entries, completed: Mapping[str, Entry]) -> Entries:
    """With D_c settled: the stated one, else half the backlash of the file, which may be an estimate in
    ``completed``, or of a drawing without backlash a hundredth of its module. Overrides come after this."""
    gap = completed.get("D")
    if REFERENCE in entries or gap is None or gap.dimensionless:
        return entries
    half = gap.number / 2.0
    reason = "half the backlash of the case file" + ("" if "D" in entries else ", as estimated")
    if half == 0.0:
        module = completed.get("mesh.normal_module", completed.get("mesh.module"))
        if module is None or GEOMETRY.isdisjoint(entries):
            return entries
        half = module.number / 100.0
        reason = "a hundredth of the module, as there is no backlash to take half of"
    entry = Entry(REFERENCE, REFERENCE, half, f"{half!r} m", gap.provenance, reason)
    return {**entries, REFERENCE: entry}


def place_of(places: Places, name: str) -> Quantity | Choice | Problem:
    """The quantity or option that a full path, a short name or an unambiguous last name stands for."""
    known = places.all
    if name in known:
        return known[name]
    if name in places.two_way:
        return known[f"dimensionless.{name}"]
    ending = [
        path for path in known if path.rpartition(".")[2] == name and not path.startswith("dimensionless.")
    ]
    if len(ending) == 1:
        return known[ending[0]]
    if ending:
        return Problem(name, None, f"one of {', '.join(ending)}")
    why = no_bearings(places, name)
    if why is not None:
        return Problem(name, None, why)
    names = {*known, *places.two_way, *(path.rpartition(".")[2] for path in known)}
    return Problem(name, None, "a path or short name that exists here", nearest_name(name, names))


def place_for(places: Places, name: str, raw: object, physical: bool) -> Quantity | Choice | Problem:
    """The same, with the value that is to stand there: the short name of a number without unit, given with
    one, is the physical quantity that has such a unit (``error = 6 um`` is mesh.error). ``physical``: does
    the case know units?"""
    place, ways = place_of(places, name), places.two_way.get(name.removeprefix("dimensionless."), ())[:-1]
    found = _unit_of(raw)
    if found is None or not ways or not isinstance(place, Quantity) or takes(place.dimension, found):
        return place
    if not physical:
        expected = f"{place.expected}, as this case is given in dimensionless numbers only"
        return Problem(name, shown(raw), expected)
    fitting = [path for path in ways if takes(places.quantities[path].dimension, found)]
    if fitting == ["mesh.backlash"]:
        expected = (
            "a number without unit, as D is half the backlash over D_c; with a unit the whole of it is "
            f"stated: mesh.backlash={raw} if that is the whole, twice as much if it is one of two sides"
        )
        return Problem(name, shown(raw), expected)
    if len(fitting) > 1 or (fitting and name == "omega" and not _of_one_rotation(raw, found)):
        both = " or ".join(quantity for quantity in ways)
        return Problem(name, shown(raw), f"{both} by its name, as this unit may mean either")
    if not fitting or name.startswith("dimensionless."):
        return Problem(name, shown(raw), f"{place.expected}, or {_with_units(places, ways)}")
    return places.quantities[fitting[0]]


def _has_units(places: Places, entries: Mapping[str, Entry]) -> bool:
    """Is a quantity stated that has a unit?"""
    stated = (places.quantities.get(entry.path) for entry in entries.values())
    return any(place is not None and place.dimension not in (NUMBER, ANGLE) for place in stated)


def _of_one_rotation(raw: object, found: Unit) -> bool:
    """Whether a unit is one of shafts only (rpm), or of meshes only (Hz): 1/s and rad/s are of both."""
    return found.pi_power == 1 or "Hz" in str(raw)


def _unit_of(raw: object) -> Unit | None:
    """The unit of a text, if it has one that can be read; of two limits that of the greater one."""
    value = raw.get("value", raw.get("range")) if isinstance(raw, Mapping) else raw
    if isinstance(value, list | tuple):
        value = value[-1] if value else None
    if not isinstance(value, str):
        return None
    try:
        ends = None if _reads(value) else ends_of(value)
        found = read(value if ends is None else ends.upper)[1]
    except UnitError:
        return None
    return None if found.dimension == NUMBER else found


def _reads(text: str) -> bool:
    """Is it one value?"""
    try:
        read(text)
    except UnitError:
        return False
    return True


def _with_units(places: Places, ways: Iterable[str]) -> str:
    """Physical quantities with an example each."""
    return " or ".join(f'{path}="{places.quantities[path].example}"' for path in ways)


def override(
    places: Places, entries: Mapping[str, Entry], overrides: Mapping[str, object]
) -> tuple[Entries, list[Problem]]:
    """Entries with these replaced, by path or short name; D_c is not to be moved."""
    problems: list[Problem] = []
    stated: dict[str, Stated] = {}
    physical = _has_units(places, entries)
    for name, raw in overrides.items():
        place = place_for(places, name, raw, physical)
        if isinstance(place, Problem):
            problems.append(place)
        elif place.path == REFERENCE:
            problems.append(Problem(name, shown(raw), "no override: D_c is settled when the file is loaded"))
        elif place.path in stated:
            first = next(
                n
                for n, v in overrides.items()
                if n != name and _path_of(places, n, v, physical) == place.path
            )
            both = f"{first} = {shown(overrides[first])} and {name} = {shown(raw)}"
            problems.append(Problem(name, shown(raw), f"one of two that name the same quantity: {both}"))
        else:
            try:
                value = read_stated(raw, place)
            except ValueRefusedError as error:
                problems.append(Problem(name, shown(raw), error.expected, error.nearest))
            else:
                stated[place.path] = overridden(value)
    _, clashes = collect(places, stated)
    return replaced(places, entries, stated), problems + clashes


def replaced(places: Places, entries: Mapping[str, Entry], stated: Mapping[str, Stated]) -> Entries:
    """Entries with values stated at these paths instead of their own, and of what says the same."""
    new, _ = collect(places, stated)
    kept = {key: e for key, e in entries.items() if new.keys().isdisjoint(rivals(key))}
    return ordered(places, {**kept, **new})


def ordered(places: Places, entries: Mapping[str, Entry]) -> Entries:
    """Entries in the order of their places."""
    order = {place.key: i for i, place in enumerate(places.quantities.values())}
    return dict(sorted(entries.items(), key=lambda item: (order.get(item[0], len(order)), item[0])))


def _path_of(places: Places, name: str, raw: object, physical: bool) -> str | None:
    place = place_for(places, name, raw, physical)
    return None if isinstance(place, Problem) else place.path
