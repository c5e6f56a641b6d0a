"""What models and results share: they pickle and copy by their fields, and print in a few lines."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields
from html import escape
from types import MappingProxyType
from typing import Any, ClassVar, TypeVar

from .annotated import hold
from .short_text import brief, cut

LONGEST_REPR = 380  # characters of a repr
Kept = TypeVar("Kept", bound="Record")


class Record:
    """Base of frozen dataclasses (declared with ``repr=False``). What was computed from the fields and kept
    does not travel: it is computed again where it is asked for."""

    _printed: ClassVar[tuple[str, ...]] = ()
    """Names of the attributes that are printed; the fields where there are none."""

    def __post_init__(self) -> None:
        hold(self)

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        return _made, (type(self), {name: _writable(getattr(self, name)) for name in _names(self)})

    def __repr__(self) -> str:
        rows = (f"{name}={_inside(value)}" for name, value in _rows(self))
        return cut(f"{type(self).__name__}({', '.join(rows)})", LONGEST_REPR)

    def _repr_html_(self) -> str:
        """A table, for notebooks."""
        rows = "".join(
            f"<tr><th style='text-align:left'>{escape(name)}</th><td>{escape(_inside(value))}</td></tr>"
            for name, value in _rows(self)
        )
        return f"<table><caption>{escape(type(self).__name__)}</caption>{rows}</table>"


def _made(kind: type[Record], values: Mapping[str, Any]) -> Record:
    return kind(**values)


def changed(record: Kept, **values: Any) -> Kept:
    """A copy with other values that were held to their annotations in another record: where many copies are
    made, nothing is looked at twice."""
    found = object.__new__(type(record))
    for name in _names(record):
        object.__setattr__(found, name, values[name] if name in values else getattr(record, name))
    return found


def _names(record: Record) -> list[str]:
    return [field.name for field in fields(record)]  # pyright: ignore[reportArgumentType]


def _rows(record: Record) -> list[tuple[str, Any]]:
    return [(name, getattr(record, name)) for name in record._printed or _names(record)]


def _inside(value: Any) -> str:
    """A value within a record; other records by their names only."""
    own = type(value).__repr__ is not Record.__repr__  # it is as short as a name
    return type(value).__name__ if isinstance(value, Record) and not own else brief(value)


def _writable(value: Any) -> Any:
    """A read-only view of a mapping does not pickle."""
    return dict(value) if isinstance(value, MappingProxyType) else value
