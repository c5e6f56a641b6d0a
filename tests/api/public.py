"""What a user may call: the names of the package, and those of the rooms that are namespaces of their own."""

from __future__ import annotations

import inspect
from enum import Enum
from functools import cached_property
from types import ModuleType
from typing import Any, Protocol, get_origin

import gearlash
from gearlash import article, gears, plots
from gearlash.case import kinds

NAMESPACES: dict[str, ModuleType] = {"": gearlash, "plots.": plots, "gears.": gears}
"""Their names have docstrings in full."""
GUESTS: dict[str, ModuleType] = {"article.": article, "case.kinds.": kinds}
"""Their names are public, too: the article's own, and what somebody needs who writes a kind of case."""


def names(namespaces: dict[str, ModuleType]) -> dict[str, Any]:
    """Everything public of them that can be called, by name."""
    found = {f"{at}{name}": getattr(room, name) for at, room in namespaces.items() for name in room.__all__}
    return {name: value for name, value in found.items() if callable(value) and get_origin(value) is None}


def members(kind: type) -> dict[str, Any]:
    """Public methods and properties that a class of gearlash defines itself or inherits from another one."""
    found: dict[str, Any] = {}
    for base in reversed(kind.__mro__):
        if base.__module__.startswith("gearlash"):
            found |= {name: value for name, value in vars(base).items() if not name.startswith("_")}
    return {name: value for name, value in found.items() if function_of(value) is not None}


def function_of(member: Any) -> Any:
    """The function behind a method, a property, a class method; None for what is none."""
    if isinstance(member, property):
        return member.fget
    if isinstance(member, cached_property):
        return member.func
    member = inspect.unwrap(getattr(member, "__func__", member))
    return member if inspect.isfunction(member) else None


def is_a_property(member: Any) -> bool:
    """Whether a member of a class is read, not called."""
    return isinstance(member, property | cached_property)


def is_made_by_its_arguments(value: Any) -> bool:
    """Whether a call has arguments to speak of: not so of choices, errors and protocols."""
    if not inspect.isclass(value):
        return True
    return not issubclass(value, Enum | Exception) and Protocol not in value.__bases__
