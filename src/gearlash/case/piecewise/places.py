"""What of a piecewise-linear case may be replaced: its parameters, and every contact rule."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf
from typing import Any

from gearlash.case.entries import Entries, Entry, overridden
from gearlash.case.errors import CaseError, Problem, nearest_name, shown
from gearlash.case.quantities import LARGEST
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.stated import ValueRefusedError, read_stated
from gearlash.case.units import NUMBER
from gearlash.system import ContactRule, UnknownNameError

CONTACT = "when the damping of this contact acts"


def parameter_place(name: str, about: Mapping[str, Any]) -> Quantity:
    """The place of a parameter: a number in its stated range; omega is above 0 in any case."""
    lower = about.get("lower", -inf)
    upper = about.get("upper", LARGEST if name == "omega" else inf)
    positive = name == "omega" and lower <= 0.0
    what = about.get("description", "")
    return Quantity(
        f"parameters.{name}", NUMBER, "", "0.05", what, 0.0 if positive else lower, upper, positive,
        bare=True, key=name,
    )  # fmt: skip


def contact_place(path: str) -> Choice:
    """The place of a contact rule."""
    return Choice(path, tuple(rule.value for rule in ContactRule), ContactRule.ALWAYS.value, CONTACT)


def places(structure: Mapping[str, Any]) -> dict[str, Quantity | Choice]:
    """Every place by its path, parameters first."""
    own = [parameter_place(name, about) for name, about in structure["parameters"].items()]
    rules = [contact_place(f"clearance.{c['name']}.contact") for c in structure["clearance"]]
    return {place.path: place for place in (*own, *rules)}


def find(structure: Mapping[str, Any], name: str) -> Quantity | Choice | None:
    """The place of a path or of a parameter's name."""
    known = places(structure)
    return known.get(name) or known.get(f"parameters.{name}")


def override(
    structure: Mapping[str, Any], entries: Mapping[str, Entry], overrides: Mapping[str, object]
) -> tuple[Entries, list[Problem]]:
    """Entries with these replaced, by path or by a parameter's name."""
    replaced: Entries = {}
    first: dict[str, str] = {}
    problems: list[Problem] = []
    for name, raw in overrides.items():
        place = find(structure, name)
        if place is None:
            valid = [*structure["parameters"], *places(structure)]
            expected = "a parameter or path that exists here"
            problems.append(Problem(name, None, expected, nearest_name(name, valid)))
            continue
        if place.path in first:
            both = f"{first[place.path]} = {shown(overrides[first[place.path]])} and {name} = {shown(raw)}"
            problems.append(Problem(name, shown(raw), f"one of two that name the same quantity: {both}"))
            continue
        first[place.path] = name
        try:
            stated = overridden(read_stated(raw, place))
        except ValueRefusedError as error:
            problems.append(Problem(name, shown(raw), error.expected, error.nearest))
            continue
        key = place.key if isinstance(place, Quantity) else place.path
        replaced[key] = Entry(key, place.path, stated.value, stated.text, stated.provenance, stated.reason)
    return {**entries, **replaced}, problems


def resolve(structure: Mapping[str, Any], label: str, name: str, value: object) -> tuple[str, float]:
    """Name and value of a parameter named by path or by its name. Raises `CaseError` for a bad value and
    `UnknownNameError` for a name that is no parameter."""
    place = find(structure, name)
    if not isinstance(place, Quantity):
        raise UnknownNameError("parameter to vary", name, structure["parameters"])
    try:
        return place.key, float(read_stated(value, place).value)
    except ValueRefusedError as error:
        raise CaseError(label, [Problem(name, shown(value), error.expected, error.nearest)]) from None
