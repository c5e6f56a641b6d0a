"""What callers hand over: made plain where its meaning is beyond doubt, refused in words where it is not.

One rule for all: a number is a finite real number (of Python, NumPy, `Decimal`, `Fraction`, an array without
dimension), never text, a truth value or complex. A count is a whole number, given as one. An array is
anything of which NumPy makes an array of such numbers. What is kept is a copy, float64, C-contiguous and
read-only, so that no later change of what was handed over reaches it. A choice is named by its member or by
its text.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping
from enum import StrEnum
from math import inf, isfinite
from numbers import Complex, Real
from operator import index
from os import PathLike
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from .short_text import shown
from .status import GearlashError, UnknownNameError

Array = NDArray[np.float64]
Kind = TypeVar("Kind", bound=StrEnum)
Thing = TypeVar("Thing")
LARGEST_COUNT = 2**53
LONG_RANGE = 10_000  # beyond it an upper end is told only to those who passed it
LONGEST_NAME = 200
FEW = 64  # numbers that are gone through in less time than it takes to ask numpy
LARGEST_REAL = 1e150
_KINDS = {"b": "truth values", "c": "complex numbers", "U": "text", "S": "text", "T": "text", "V": "records"}
_KINDS |= {"m": "times", "M": "dates"}


def number(name: str, value: Any, low: float = -inf, high: float = inf) -> float:
    """A finite number from ``low`` to ``high``."""
    found = _real(value)
    if isinstance(found, float) and isfinite(found) and low <= found <= high:
        return found
    limits = "" if (low, high) == (-inf, inf) else f" from {low:g} to {high:g}"
    why = "" if isinstance(found, float) else f", not {found}"
    raise GearlashError(f"{name} = {shown(value)}: expected a finite number{limits}{why}")


def positive(name: str, value: Any) -> float:
    """A finite number above zero."""
    found = _real(value)
    if isinstance(found, float) and 0.0 < found < inf:
        return found
    why = "" if isinstance(found, float) else f", not {found}"
    raise GearlashError(f"{name} = {shown(value)}: expected a positive number{why}")


def limit(name: str, value: Any) -> float:
    """A number that may be infinite, but not NaN."""
    found = _real(value)
    if isinstance(found, float) and found == found:
        return found
    raise GearlashError(f"{name} = {shown(value)}: expected a number, or infinity")


def whole(name: str, value: Any, least: int = 1, most: int = LARGEST_COUNT) -> int:
    """A whole number from ``least`` to ``most``."""
    try:
        found = None if isinstance(value, (bool, np.bool_, np.timedelta64)) else index(value)
    except TypeError:
        found = None
    if found is None or not least <= found <= most:
        closed = most < LONG_RANGE or (found is not None and found > most)
        limits = f"{least} to {most:,}" if closed else f"{least} or more"
        raise GearlashError(f"{name} is {shown(value)}: expected a whole number, {limits}")
    return found


def numbers(name: str, value: Any, shape: tuple[int | str, ...]) -> Array:
    """A fresh array of finite numbers of this shape; a word stands for any length."""
    if type(value) is np.ndarray and value.dtype == np.float64:
        found = value.copy(order="C")
    else:
        found = _converted(name, value, _shape_text(shape))
    if not _has_shape(found, shape):
        raise GearlashError(f"{name} has shape {found.shape}, expected {_shape_text(shape)}")
    finite = all(map(isfinite, found.ravel().tolist())) if found.size <= FEW else np.isfinite(found).all()
    if not finite:
        raise GearlashError(f"{name} holds NaN or infinity")
    return found


def _has_shape(found: Array, shape: tuple[int | str, ...]) -> bool:
    if found.ndim != len(shape):
        return False
    for here, there in zip(found.shape, shape, strict=True):  # no generator: systems are made by thousands
        if here != there and not isinstance(there, str):
            return False
    return True


def _shape_text(shape: tuple[int | str, ...]) -> str:
    return f"({', '.join(map(str, shape))}{',' if len(shape) == 1 else ''})"


def reals(name: str, value: Any) -> Array:
    """Real numbers of any shape, NaN and infinity among them, but none so large that a unit makes it
    infinite."""
    if type(value) is float or (type(value) is np.ndarray and value.dtype == np.float64):
        found = np.asarray(value)
    else:
        plain = _real(value)
        found = np.array(plain) if isinstance(plain, float) else _converted(name, value, "any")
    if (np.abs(found[np.isfinite(found)]) > LARGEST_REAL).any():
        raise GearlashError(f"{name}: expected numbers up to {LARGEST_REAL:g}")
    return found


def row(name: str, value: Any) -> Array:
    """Numbers (m,); one alone is a row of one."""
    several = type(value) is np.ndarray and value.ndim > 0
    return numbers(name, value if several or not isinstance(_real(value), float) else [value], ("m",))


def series(name: str, value: Any) -> Array:
    """A Fourier series [mean, c1, s1, ...]; one number alone is its mean. Read-only."""
    found = row(name, value)
    if len(found) % 2 == 0:
        raise GearlashError(
            f"{name}: a Fourier series has even length ({len(found)}), expected [mean, c1, s1, ...]"
        )
    return kept(found)


def kept(array: Array) -> Array:
    """The same array, never to be written again."""
    array.setflags(write=False)
    return array


def choice(kind: type[Kind], name: str, value: Any) -> Kind:
    """A member, or the text of one."""
    if isinstance(value, kind):
        return value
    if isinstance(value, str) and value in tuple(kind):
        return kind(value)
    raise UnknownNameError(name, value, map(str, kind))


def word(name: str, value: Any) -> str:
    """A name: text in one line that can be printed."""
    if isinstance(value, str) and value.strip() and value.isprintable() and len(value) <= LONGEST_NAME:
        return str(value)
    raise GearlashError(f"{name} = {shown(value)}: expected a name, in one line of text")


def a_text(name: str, value: Any) -> str:
    """Any text."""
    if isinstance(value, str):
        return str(value)
    raise GearlashError(f"{name} = {shown(value)}: expected text")


def truth(name: str, value: Any) -> bool:
    """True or False."""
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    raise GearlashError(f"{name} = {shown(value)}: expected True or False")


def words(name: str, value: Any) -> tuple[str, ...]:
    """Names, each once."""
    found = tuple(word(name, each) for each in items(name, value, "names, such as ('x', 'v')"))
    return unique(name, found)


def unique(name: str, found: tuple[str, ...]) -> tuple[str, ...]:
    """The same names, if each is there once."""
    twice = next((each for i, each in enumerate(found) if each in found[:i]), None)
    if twice is not None:
        raise GearlashError(f"{name}: {twice!r} stands there twice")
    return found


def items(name: str, value: Any, expected: str) -> tuple[Any, ...]:
    """The elements of a list, a tuple or another collection that keeps an order. A set does not: in the next
    process another element may come first. A text does not count as a collection."""
    if isinstance(value, (set, frozenset)):
        raise GearlashError(f"{name}: expected {expected}, in order: a set has none")
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes, Mapping)):
        try:
            return tuple(value)
        except TypeError:  # an array without dimension says that it can be gone through
            pass
    raise GearlashError(f"{name} = {shown(value)}: expected {expected}")


def instance(name: str, value: Any, kind: type[Thing] | tuple[type[Thing], ...], expected: str) -> Thing:
    """An object of this kind; ``expected`` says which and where it is from."""
    if isinstance(value, kind):
        return value
    raise GearlashError(f"{name}: expected {expected}, not {kind_of(value)}")


def instances(name: str, value: Any, kind: type[Thing], expected: str) -> tuple[Thing, ...]:
    """Objects of this kind; one alone is a collection of one."""
    found = (value,) if isinstance(value, kind) else items(name, value, expected)
    return tuple(instance(name, each, kind, expected) for each in found)


def mapping(name: str, value: Any) -> dict[str, Any]:
    """A table of values by name; None is an empty one."""
    if value is None:
        return {}
    if not isinstance(value, Mapping):
        expected = "a mapping of names to values, such as {'omega': 0.9}"
        raise GearlashError(f"{name} = {shown(value)}: expected {expected}")
    wrong = next((key for key in value if not isinstance(key, str)), None)
    if wrong is not None:
        raise GearlashError(f"{name}: {shown(wrong)} is no name: expected text")
    return dict(value)


def function(name: str, value: Any, expected: str) -> Any:
    """Something that can be called."""
    if callable(value):
        return value
    raise GearlashError(f"{name} = {shown(value)}: expected {expected}")


def path(name: str, value: Any) -> Path:
    """A path; `~` and `~user` at its beginning are homes."""
    if not isinstance(value, (str, PathLike)) or "\0" in str(value):
        raise GearlashError(f"{name} = {shown(value)}: expected the path of a file")
    try:
        return Path(value).expanduser()
    except (RuntimeError, TypeError):
        raise GearlashError(f"{name} = {shown(str(value))}: there is no such home") from None


def known(what: str, name: Any, valid: Iterable[str]) -> str:
    """One of these names. Raises `UnknownNameError` with the nearest."""
    valid = tuple(valid)
    if isinstance(name, str) and name in valid:
        return name
    raise UnknownNameError(what, name, valid)


def _real(value: Any) -> float | str:
    """The number, or what it is instead."""
    if type(value) is float or type(value) is int:
        return _float(value)
    if masked(value):
        return "masked"
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value[()]
    if isinstance(value, (str, bytes)):
        return "text: written without quotes"
    if isinstance(value, (bool, np.bool_)):
        return "a truth value"
    if isinstance(value, (np.timedelta64, np.datetime64)):
        return "a time"
    if isinstance(value, Complex) and not isinstance(value, Real):
        return "a complex number"
    if getattr(value, "shape", ()) != () or not hasattr(value, "__float__") or _measured(value):
        return kind_of(value)
    return _float(value)


def _float(value: Any) -> float | str:
    try:
        return float(value)
    except OverflowError:
        return "one beyond double precision"
    except (TypeError, ValueError, ArithmeticError):
        return kind_of(value)


def _converted(name: str, value: Any, expected: str) -> Array:
    """Float64 of whatever can be read as numbers."""
    if masked(value):
        raise GearlashError(f"{name}: expected numbers of shape {expected}, without masked places")
    if _measured(value):
        raise GearlashError(f"{name}: expected plain numbers of shape {expected}, not {kind_of(value)}")
    try:
        raw = np.asarray(value)
    except (TypeError, ValueError, OverflowError):
        raise GearlashError(f"{name}: expected numbers of shape {expected}, not {shown(value)}") from None
    if raw.dtype.kind in _KINDS:
        what = _KINDS[raw.dtype.kind]
        raise GearlashError(f"{name}: expected numbers of shape {expected}, not {shown(value)} ({what})")
    if raw.dtype.kind == "O":
        if raw.ndim == 0:
            raise GearlashError(f"{name}: expected numbers of shape {expected}, not {kind_of(value)}")
        flat = [number(f"{name}[{i}]", each) for i, each in enumerate(raw.ravel().tolist())]
        return np.array(flat, dtype=np.float64).reshape(raw.shape)
    with np.errstate(over="ignore"):  # long doubles become infinite, and are refused as that
        return np.array(raw, dtype=np.float64, order="C", subok=False)


def masked(value: Any) -> bool:
    """An array with masked places; asking for `numpy.ma` itself would load it."""
    numpy_ma = sys.modules.get("numpy.ma")
    return numpy_ma is not None and isinstance(value, numpy_ma.MaskedArray) and bool(np.any(value.mask))


def _measured(value: Any) -> bool:
    """A number with a unit, of a library of such: NumPy would drop the unit."""
    return hasattr(value, "magnitude") and hasattr(value, "units")


def kind_of(value: object) -> str:
    """What it is, in words: its type."""
    if value is None:
        return "None"
    kind = type(value).__name__
    return f"{'an' if kind[0] in 'AEIOUaeiou' else 'a'} {kind}"
