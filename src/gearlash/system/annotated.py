"""Fields of records and arguments of functions are what their annotations say, or are refused in words.

Results are made by the program, but anyone may make one: with a text for a number it would go wrong far from
there. Numbers of results may be NaN or infinite."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import fields
from functools import wraps
from inspect import Parameter, signature
from operator import index
from typing import Any, TypeVar

import numpy as np

from .given import masked
from .short_text import shown
from .status import GearlashError, Status, UnknownNameError

Check = Callable[[Any], Any]
ARRAYS = "Array", "Vector", "Fourier", "Complex"  # names that the rooms give to arrays
_checks: dict[type, tuple[tuple[str, str, str, Check, type | None], ...]] = {}
_EXACT: dict[str, type] = {"float": float, "int": int, "complex": complex, "bool": bool, "str": str}


MEANING = {  # names that stand for several kinds
    "Attractor": "Orbit | Aperiodic",
    "Label": "Signature | MotionKind",
    "Model": "Case | Family",
}
Called = TypeVar("Called", bound=Callable[..., Any])


class _WrongError(Exception):
    """The value is not what the annotation says."""


def hold(record: Any) -> None:
    """Makes the fields of a frozen dataclass what their annotations say. Raises `GearlashError`."""
    kind = type(record)
    if kind not in _checks:
        _checks[kind] = tuple(
            (
                f.name,
                f"{f.name} of {kind.__name__}",
                str(f.type),
                _check(str(f.type)),
                _EXACT.get(str(f.type)),
            )
            for f in fields(kind)
        )
    for name, told, annotation, check, exact in _checks[kind]:
        value = getattr(record, name)
        if type(value) is exact:
            continue
        try:
            found = check(value)
        except (_WrongError, UnknownNameError, TypeError, ValueError, OverflowError):
            raise _refused(told, annotation, value) from None
        if found is not value:
            object.__setattr__(record, name, found)


def arguments(function: Called) -> Called:
    """The function, with its arguments held to their annotations."""
    known = signature(function)
    parameters = {
        name: (str(each.annotation), _check(str(each.annotation)))
        for name, each in known.parameters.items()
        if each.annotation is not Parameter.empty
    }

    @wraps(function)
    def held(*positional: Any, **named: Any) -> Any:
        bound = known.bind(*positional, **named)
        for name, value in bound.arguments.items():
            if name in parameters:
                bound.arguments[name] = found = _held(name, *parameters[name], value)
                empty = isinstance(found, tuple) and not found
                if empty and known.parameters[name].default is Parameter.empty:
                    raise GearlashError(f"{name}: expected at least one")
        return function(*bound.args, **bound.kwargs)

    return held  # pyright: ignore[reportReturnType]


def _held(name: str, annotation: str, check: Check, value: Any) -> Any:
    try:
        return check(value)
    except (_WrongError, UnknownNameError, TypeError, ValueError, OverflowError):
        raise _refused(name, annotation, value) from None


def _refused(name: str, annotation: str, value: Any) -> GearlashError:
    return GearlashError(f"{name} = {shown(value)}: expected {annotation}")


def _check(annotation: str) -> Check:
    inside = re.fullmatch(r"Sequence\[(.*)\]", annotation)
    if inside:
        return _several(_check(inside[1]))
    parts = " | ".join(MEANING.get(part, part) for part in annotation.split(" | ")).split(" | ")
    checks = [_PLAIN.get(part.partition("[")[0], _of_kind(part)) for part in parts if part != "None"]
    if "None" in parts:
        return lambda value: None if value is None else _first(checks, value)
    return checks[0] if len(checks) == 1 else lambda value: _first(checks, value)


def _several(check: Check) -> Check:
    def all_of(value: Any) -> tuple[Any, ...]:
        if isinstance(value, (str, bytes, Mapping)):
            raise _WrongError
        return tuple(check(each) for each in value)

    return all_of


def _first(checks: list[Check], value: Any) -> Any:
    for check in checks:
        try:
            return check(value)
        except (_WrongError, UnknownNameError, TypeError, ValueError, OverflowError):
            pass
    raise _WrongError


def _of_kind(annotation: str) -> Check:
    """An instance of a class of this name, which need not be imported here."""

    name = annotation.rpartition(".")[2].casefold()
    known: set[type] = set()

    def check(value: Any) -> Any:
        kind = type(value)
        if kind in known:
            return value
        if any(base.__name__.casefold() == name for base in kind.__mro__):
            known.add(kind)
            return value
        raise _WrongError

    return check


def _float(value: Any) -> Any:
    if type(value) is float:
        return value
    if isinstance(value, (str, bytes, bool, np.bool_, complex)) or getattr(value, "shape", ()) != ():
        raise _WrongError
    if masked(value):
        raise _WrongError
    return float(value.item() if isinstance(value, np.generic | np.ndarray) else value)


def _int(value: Any) -> int:
    if isinstance(value, (bool, np.bool_)):
        raise _WrongError
    return index(value)


def _complex(value: Any) -> complex:
    if isinstance(value, (str, bytes, bool, np.bool_)) or getattr(value, "shape", ()) != ():
        raise _WrongError
    return complex(value)


def _array(value: Any) -> np.ndarray:
    found = value if isinstance(value, np.ndarray) else np.asarray(value)
    if found.dtype.kind not in "biufc":
        raise _WrongError
    return found


def _tuple(value: Any) -> Any:
    if isinstance(value, list):
        return tuple(value)
    return _kept(value, tuple)


def _kept(value: Any, kind: type | tuple[type, ...]) -> Any:
    if isinstance(value, kind):
        return value
    raise _WrongError


def _bool(value: Any) -> bool:
    return bool(_kept(value, (bool, np.bool_)))


_PLAIN: dict[str, Check] = {
    "float": _float,
    "int": _int,
    "complex": _complex,
    "bool": _bool,
    "str": lambda value: _kept(value, str),
    "tuple": _tuple,
    "dict": lambda value: _kept(value, Mapping),
    "Mapping": lambda value: _kept(value, Mapping),
    "Literal": lambda value: _kept(value, str),
    "Status": Status,
    "Surface": lambda value: _kept(value, str),
    "Any": lambda value: value,
    "ArrayLike": lambda value: value,
    "object": lambda value: value,
    "NDArray": _array,
    **dict.fromkeys(ARRAYS, _array),
}
