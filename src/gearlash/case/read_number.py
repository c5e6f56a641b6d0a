"""One number with its unit as a file, an option or Python gives it, in SI and in the range of its place."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from math import isfinite

import numpy as np

from .limits import LONGEST
from .quantity import Quantity, ValueRefusedError
from .texts import refused
from .unit_hints import beside, instead, meant, of_diameters, usual_units
from .units import FREQUENCY, LENGTH, NUMBER, SPEED, UnitError, in_si, read, takes
from .written_numbers import NumberError


def read_number(raw: object, place: Quantity) -> float:
    """The number in SI. Raises `ValueRefusedError` with what is expected and what was probably meant."""
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
        raise _refused(
            text, place, f" ({beside(text, place) or of_diameters(text, place) or error})"
        ) from None
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
