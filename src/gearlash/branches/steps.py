"""The parameter that is solved for: its name, and how far Newton's method may move it in one step."""

from __future__ import annotations

from gearlash.system import Family, UnknownNameError

PART = 0.05  # of the parameter
SIGNED = 1.0  # a parameter that may change its sign (a load, a phase) is taken for this large at least


def check_name(family: Family, name: str) -> None:
    """Raises `UnknownNameError` for a name that is no parameter of the family."""
    names = [p.name for p in family.parameters]
    if name not in names:
        raise UnknownNameError("parameter", name, names)


def longest_step(family: Family, name: str, value: float) -> float:
    """The longest step from ``value`` of the parameter ``name``: 5 % of it. One that may be negative would
    never leave zero so; it may move by 0.05."""
    parameter = next(p for p in family.parameters if p.name == name)
    return PART * max(abs(value), SIGNED if parameter.lower < 0.0 else 0.0)
