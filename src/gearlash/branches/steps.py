"""How far Newton's method may move a parameter in one step."""

from __future__ import annotations

from gearlash.system import Family

PART = 0.05  # of the parameter
SIGNED = 1.0  # a parameter that may change its sign (a load, a phase) is taken for this large at least


def longest_step(family: Family, name: str, value: float) -> float:
    """The longest step from ``value`` of the parameter ``name``: 5 % of it. One that may be negative would
    never leave zero so; it may move by 0.05."""
    parameter = next(p for p in family.parameters if p.name == name)
    return PART * max(abs(value), SIGNED if parameter.lower < 0.0 else 0.0)
