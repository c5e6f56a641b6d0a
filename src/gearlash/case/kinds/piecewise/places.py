"""What of a piecewise-linear case may be replaced: its parameters, and every contact rule."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf
from typing import Any

from gearlash.case.quantity import LARGEST_VALUE, Choice, Quantity
from gearlash.case.units import NUMBER
from gearlash.system import ContactRule

CONTACT = "when the damping of this contact acts"


def parameter_place(name: str, about: Mapping[str, Any]) -> Quantity:
    """The place of a parameter: a number in its stated range; omega is above 0 in any case."""
    lower = about.get("lower", -inf)
    upper = about.get("upper", LARGEST_VALUE if name == "omega" else inf)
    positive = name == "omega" and lower <= 0.0
    what = about.get("description", "")
    return Quantity(
        f"parameters.{name}", NUMBER, "", "0.05", what, 0.0 if positive else lower, upper, positive,
        bare=True, key=name, alone="limits are looked at of gear pairs alone",
    )  # fmt: skip


def contact_place(path: str) -> Choice:
    """The place of a contact rule."""
    return Choice(path, tuple(rule.value for rule in ContactRule), ContactRule.ALWAYS.value, CONTACT)


def places(structure: Mapping[str, Any]) -> dict[str, Quantity | Choice]:
    """Every place by its path, parameters first."""
    own = [parameter_place(name, about) for name, about in structure["parameters"].items()]
    rules = [contact_place(f"clearance.{c['name']}.contact") for c in structure["clearance"]]
    return {place.path: place for place in (*own, *rules)}
