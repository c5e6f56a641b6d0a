"""A case file of kind ``piecewise-linear``: its tables read into one plain form, with every problem.

The plain form (`Structure`) is made of what JSON knows: tables by the names of states, floats, and texts of
expressions. Values of parameters and contact rules are not in it: they are entries, which overrides replace.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple, TypeAlias

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.case.stated import Provenance, ValueRefusedError, read_stated
from gearlash.case.texts import refused
from gearlash.system import ContactRule
from gearlash.system.piecewise import MOST_CLEARANCES

from .expressions import is_name
from .places import contact_place, parameter_place
from .reading import Reading, finite

Structure: TypeAlias = Mapping[str, Any]

HEAD_KEYS = ("kind", "name", "description", "source")
TOP = (
    *HEAD_KEYS,
    "states",
    "cycles",
    "parameters",
    "definitions",
    "matrix",
    "forcing",
    "initial",
    "clearance",
)
MOST_STATES = 40
MOST_CYCLES = 1000
PARAMETER_KEYS = ("value", "provenance", "reason", "description", "lower", "upper")
CLEARANCE_KEYS = (
    "name", "h", "g", "gap_plus", "gap_minus", "stiffness_plus", "stiffness_minus",
    "damping", "damping_minus", "offset", "contact",
)  # fmt: skip
NAME = "a name of letters, digits and _ that starts with a letter and is no word of the expressions"


class Content(NamedTuple):
    """What a file holds: the structure, entries by key, and every problem found so far."""

    structure: Structure
    entries: dict[str, Entry]
    problems: list[Problem]


def read(raw: Mapping[str, Any]) -> Content:
    """A parsed file, its head (`HEAD_KEYS`) aside."""
    reading = Reading()
    for key in raw:
        if key not in TOP:
            reading.wrong(key, raw[key], "a name that exists here", reading.near(key, TOP))
    states = _states(raw, reading)
    parameters, entries = _parameters(raw, reading)
    rest = Reading(set(parameters), states)
    definitions = _definitions(raw, rest)
    clearances, contacts = _clearances(raw, rest)
    structure = {
        "states": states or [],
        "cycles": _cycles(raw, reading),
        "parameters": parameters,
        "definitions": definitions,
        "matrix": _matrix(raw, rest),
        "forcing": rest.by_state(raw.get("forcing", {}), "forcing", rest.series),
        "initial": rest.by_state(raw.get("initial", {}), "initial", rest.number),
        "clearance": clearances,
    }
    return Content(structure, {**entries, **contacts}, [*reading.problems, *rest.problems])


def _states(raw: Mapping[str, Any], reading: Reading) -> list[str] | None:
    expected = f'an array of 1 to {MOST_STATES} names, such as ["x", "v"]'
    if "states" not in raw:
        reading.missing("states", expected)
        return None
    names = raw["states"]
    if not isinstance(names, list) or not 1 <= len(names) <= MOST_STATES:
        reading.wrong("states", names, expected)
        return None
    before = len(reading.problems)
    found = [reading.label(name, f"states[{i}]") for i, name in enumerate(names)]
    for i, name in enumerate(found):
        if name is not None and name in found[:i]:
            reading.wrong(f"states[{i}]", name, "each state once")
    return None if len(reading.problems) > before else [name for name in found if name]


def _cycles(raw: Mapping[str, Any], reading: Reading) -> int:
    cycles = raw.get("cycles", 1)
    if isinstance(cycles, int) and not isinstance(cycles, bool) and 1 <= cycles <= MOST_CYCLES:
        return cycles
    reading.wrong("cycles", cycles, f"a whole number from 1 to {MOST_CYCLES}: cycles of ω in the base period")
    return 1


def _parameters(
    raw: Mapping[str, Any], reading: Reading
) -> tuple[dict[str, dict[str, Any]], dict[str, Entry]]:
    """Description and range of every parameter, and the entry of its value."""
    found: dict[str, dict[str, Any]] = {}
    entries: dict[str, Entry] = {}
    for name, stated in reading.table(raw.get("parameters", {}), "parameters").items():
        path = f"parameters.{name}"
        if not is_name(name):
            reading.wrong(path, stated, NAME)
            continue
        table = (
            reading.table(stated, path, PARAMETER_KEYS) if isinstance(stated, Mapping) else {"value": stated}
        )
        found[name] = _about(table, path, reading)
        value = {key: table[key] for key in ("value", "provenance", "reason") if key in table}
        try:
            read_value = read_stated(value, parameter_place(name, found[name]))
        except ValueRefusedError as error:
            reading.wrong(path, stated, error.expected, error.nearest)
        else:
            entries[name] = Entry(name, path, *_parts(read_value))
    if "omega" not in found:
        expected = "the frequency dθ/dτ of the forcing, a number above 0"
        reading.missing("parameters.omega", expected)
        found["omega"] = {}
    return found, entries


def _parts(stated: Any) -> tuple[Any, str, Provenance, str]:
    return stated.value, stated.text, stated.provenance, stated.reason


def _about(table: Mapping[str, Any], path: str, reading: Reading) -> dict[str, Any]:
    """Description, lower and upper bound, where stated."""
    found: dict[str, Any] = {}
    description = table.get("description", "")
    if not isinstance(description, str) or len(description) > 1000:
        reading.wrong(f"{path}.description", description, "a text of at most 1,000 characters")
    elif expected := refused(description):
        reading.wrong(f"{path}.description", description, expected)
    elif description:
        found["description"] = description
    for key in ("lower", "upper"):
        if key in table:
            bound = finite(table[key])
            if bound is None:
                reading.wrong(f"{path}.{key}", table[key], "a finite number")
            else:
                found[key] = bound
    if found.get("lower", 0.0) > found.get("upper", found.get("lower", 0.0)):
        reading.wrong(f"{path}.lower", found.pop("lower"), f"a bound of at most upper = {found['upper']:g}")
    return found


def _definitions(raw: Mapping[str, Any], reading: Reading) -> dict[str, Any]:
    """Named expressions, each of parameters and of the definitions before it; from then on known."""
    found: dict[str, Any] = {}
    for name, stated in reading.table(raw.get("definitions", {}), "definitions").items():
        path = f"definitions.{name}"
        if not is_name(name):
            reading.wrong(path, stated, NAME)
        elif name in reading.known:
            reading.wrong(path, stated, "a name that no parameter has")
        else:
            found[name] = reading.number(stated, path)
            reading.known = {*reading.known, name}
    return found


def _matrix(raw: Mapping[str, Any], reading: Reading) -> dict[str, dict[str, Any]]:
    expected = "the rows of M in z' = M z + …: a table with a table a state, or an array of arrays"
    if "matrix" not in raw:
        reading.missing("matrix", expected)
        return {}
    return reading.by_state(raw["matrix"], "matrix", reading.vector)


def _clearances(raw: Mapping[str, Any], reading: Reading) -> tuple[list[Structure], dict[str, Entry]]:
    expected = f"1 to {MOST_CLEARANCES} tables [[clearance]]"
    stated = raw.get("clearance")
    if stated is None:
        reading.missing("clearance", expected)
        return [], {}
    if not isinstance(stated, list) or not 1 <= len(stated) <= MOST_CLEARANCES:
        reading.wrong("clearance", stated, expected)
        return [], {}
    found, entries = [], {}
    for i, item in enumerate(stated):
        table = reading.table(item, f"clearance[{i}]")
        name = _clearance_name(table, i, [c["name"] for c in found], reading)
        path = f"clearance.{name}" if name else f"clearance[{i}]"
        table = reading.table(item, path, CLEARANCE_KEYS) if isinstance(item, Mapping) else {}
        found.append({"name": name or f"[{i}]", **_clearance(table, path, reading)})
        entry = _contact(table, path, reading)
        if entry:
            entries[entry.key] = entry
    return found, entries


def _clearance_name(table: Mapping[str, Any], i: int, taken: list[str], reading: Reading) -> str | None:
    path = f"clearance[{i}].name"
    if "name" not in table:
        reading.missing(path, 'the name of this clearance, such as "stop"')
        return None
    name = reading.label(table["name"], path)
    if name in taken:
        reading.wrong(path, name, "a name that no other clearance has")
        return None
    return name


def _clearance(table: Mapping[str, Any], path: str, reading: Reading) -> Structure:
    """Everything of a clearance but its name and contact rule; what must be there and is not is a problem."""
    found: dict[str, Any] = {}
    required = {
        "h": (reading.vector, "what of the states the gap coordinate X = h·z - offset reads"),
        "g": (reading.vector, "how the contact force Φ enters the equations: z' = … + g Φ"),
        "gap_plus": (reading.number, "where side + begins: contact is X > gap_plus"),
        "gap_minus": (reading.number, "where side - begins: contact is X < -gap_minus"),
        "stiffness_plus": (reading.series, "the stiffness of side +"),
        "stiffness_minus": (reading.series, "the stiffness of side -; 0 where none acts"),
    }
    for key, (reads, what) in required.items():
        if key in table:
            found[key] = reads(table[key], f"{path}.{key}")
        else:
            reading.missing(f"{path}.{key}", what)
    found["damping"] = reading.number(table.get("damping", 0.0), f"{path}.damping")
    if "damping_minus" in table:
        found["damping_minus"] = reading.number(table["damping_minus"], f"{path}.damping_minus")
    found["offset"] = reading.series(table.get("offset", 0.0), f"{path}.offset")
    return found


def _contact(table: Mapping[str, Any], path: str, reading: Reading) -> Entry | None:
    """The entry of a contact rule; none where it is not stated (`ContactRule.ALWAYS` then)."""
    if "contact" not in table:
        return None
    place = contact_place(f"{path}.contact")
    try:
        stated = read_stated(table["contact"], place)
    except ValueRefusedError as error:
        reading.wrong(place.path, table["contact"], error.expected, error.nearest)
        return None
    return Entry(place.path, place.path, ContactRule(str(stated.value)).value, *_parts(stated)[1:])
