"""Values as a case states them: a number in SI with the text it was written as, where it is from, and why."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from enum import StrEnum
from fractions import Fraction
from math import isfinite

import numpy as np

from .errors import shown
from .quantity import Choice, Quantity
from .quantity import ValueRefusedError as ValueRefusedError
from .texts import refused
from .unit_hints import beside, instead, meant, usual_units
from .units import FREQUENCY, LENGTH, NUMBER, SPEED, UnitError, in_si, read, takes
from .words import nearest_name
from .written_numbers import NumberError


class Provenance(StrEnum):
    """Where a value is from. What a file does not say is ``given``.

    ``given`` is stated by the source of the case, ``inferred`` follows from what it states, ``assumed`` was
    chosen by whoever wrote the case, ``calibrated`` was fitted to measurements or results.
    """

    GIVEN = "given"
    INFERRED = "inferred"
    ASSUMED = "assumed"
    CALIBRATED = "calibrated"


@dataclass(frozen=True)
class Stated:
    """A value in SI (or the name of an option) with the text it was written as, its provenance and reason."""

    value: float | str
    text: str
    provenance: Provenance = Provenance.GIVEN
    reason: str = ""


RANGE = "here stands one value; two ends go to gearlash tolerance with --limits, or to a sweep with --over"
_TWO_VALUES = re.compile(r"\d[^\d]*?(?:\.\.+|…|:|~| to |\+/?-|±|/|(?<![eE^])-)\s*[-+]?[.\d]")
LONGEST = 200
"""Characters of a number with its unit."""
_KEYS = ("value", "provenance", "reason")


def read_stated(raw: object, place: Quantity | Choice) -> Stated:
    """A raw TOML value, plain or ``{value = …, provenance = …, reason = …}``. Raises `ValueRefusedError`."""
    if not isinstance(raw, Mapping):
        return Stated(_read(raw, place), _text_of(raw))
    for key in raw:
        if key not in _KEYS:
            raise ValueRefusedError(
                f"a table of value, provenance and reason, without {key!r}", nearest_name(key, _KEYS)
            )
    if "value" not in raw:
        raise ValueRefusedError(
            'a table with a value, such as {value = …, provenance = "inferred", reason = "…"}'
        )
    provenance, reason = raw.get("provenance", "given"), raw.get("reason", "")
    if provenance not in tuple(Provenance):
        names = ", ".join(Provenance)
        raise ValueRefusedError(
            f"a provenance out of {names}, not {shown(provenance)}", _nearest(provenance, Provenance)
        )
    if not isinstance(reason, str):
        raise ValueRefusedError(f"a reason in words, not {shown(reason)}")
    if expected := refused(reason):
        raise ValueRefusedError(f"{expected} as its reason")
    value = raw["value"]
    return Stated(_read(value, place), _text_of(value), Provenance(str(provenance)), reason)


def _text_of(raw: object) -> str:
    """As it was written, of a value that was read."""
    return raw if isinstance(raw, str) else str(raw)


def _read(raw: object, place: Quantity | Choice) -> float | str:
    return _choice(raw, place) if isinstance(place, Choice) else _number(raw, place)


def _choice(raw: object, place: Choice) -> str:
    if isinstance(raw, str) and place.takes(raw):
        return str(raw)
    if isinstance(raw, str) and place.reader is not None and len(raw) <= LONGEST:
        return place.reader(raw)
    raise ValueRefusedError(f"one of {', '.join(place.choices)}", _nearest(raw, place.choices))


def _number(raw: object, place: Quantity) -> float:
    raw = _plain(raw)
    if isinstance(raw, bool) or not isinstance(raw, int | float | str):
        raise ValueRefusedError(place.expected)
    if isinstance(raw, str) and len(raw) > LONGEST:
        raise ValueRefusedError(f"{place.expected} of at most {LONGEST} characters")
    if isinstance(raw, str) and refused(raw):
        raise ValueRefusedError(f"{place.expected} (a control character stands there)")
    value = _from_text(raw, place) if isinstance(raw, str) else _from_number(raw, place)
    if place.integer and value != int(value):
        raise ValueRefusedError(place.expected)
    if not place.accepts(value):
        least = place.lower if place.integer else min(place.lower, 0.0)
        more = f"; {place.below}" if place.below and value < least else ""
        raise ValueRefusedError(f"{place.expected_in_range}{more}")
    return value


def _plain(raw: object) -> object:
    """Numbers of NumPy, decimals and fractions as Python's own."""
    if isinstance(raw, np.generic) or (isinstance(raw, np.ndarray) and raw.ndim == 0):
        raw = raw.item()
    if isinstance(raw, Decimal | Fraction):
        try:
            return float(raw)
        except (OverflowError, ValueError):
            return None
    return raw


def _from_number(raw: float, place: Quantity) -> float:
    if not place.bare:
        raise ValueRefusedError(place.expected)
    try:
        value = float(raw)
    except OverflowError:
        raise ValueRefusedError(place.expected) from None
    if not isfinite(value):
        raise ValueRefusedError(f"{place.expected} (it is not finite)")
    return value


def _from_text(raw: str, place: Quantity) -> float:
    text = raw if place.reader is None else place.reader(raw)
    if place.dimension == LENGTH:
        text = text.strip().removeprefix("Ø").removeprefix("ø").removeprefix("⌀")
    try:
        number, unit = read(text, place.dimension)
    except UnitError as error:
        if isinstance(error, NumberError):
            raise ValueRefusedError(f"{place.expected} ({error})") from None
        if _TWO_VALUES.search(raw):
            raise ValueRefusedError(f"{place.expected} ({error}; {RANGE})", meant(text, place)) from None
        raise _refused(text, place, f" ({beside(text, place) or error})") from None
    if takes(place.dimension, unit):
        return _in_si(number, in_si(place.dimension, number, unit))
    if place.bare and unit.dimension == NUMBER and unit.ratio == 1:
        return _in_si(number, float(number))
    if place.dimension == SPEED and unit.dimension == FREQUENCY:
        turns = " (1/s and Hz may mean turns or radians: write rev/s, rad/s or rpm)"
        raise ValueRefusedError(place.expected + turns)
    other = instead(unit.dimension, place)
    raise _refused(text, place, f" ({other})" if other else "")


def _refused(text: str, place: Quantity, why: str) -> ValueRefusedError:
    """With what was probably meant, else with the units that there are."""
    near, units = meant(text, place), usual_units(place)
    others = f"; units are {units}" if units and near is None and not why.startswith(" (that is") else ""
    return ValueRefusedError(f"{place.expected}{why}{others}", near)


def _in_si(number: Fraction, value: float) -> float:
    if not isfinite(value) or (value == 0.0) != (number == 0):
        raise ValueRefusedError("a number that fits double precision")
    return value


def _nearest(raw: object, valid: Iterable[str]) -> str | None:
    return nearest_name(raw, [str(name) for name in valid]) if isinstance(raw, str) else None
