"""What a value that cannot be read probably means: the same number with a unit that fits."""

from __future__ import annotations

import re

from .quantity import Quantity
from .spelling import plain_value
from .unit_words import PITCH, POWER, PRESSURE, STIFFNESS, TEMPERATURE, TORQUE, USUAL, Dimension
from .units import DIMENSION_NAMES, NUMBER, UnitError, behind_number, pretty, read, takes

_BEFORE = re.compile(r"[^\d+\-−.,]*(?:[.,](?!\d))?[^\d+\-−.,]*")
_RANGE = re.compile(r"\d\s*(?:\.\.+|…|:|~|-|–|to\b|/)\s*[-+]?[\d.]")
_DEVIATIONS = re.compile(r"±|[\s\d]\+\s?[\d/]")
_WORD = re.compile(r"(?<!\w)[A-Za-zµμ°\"]+(?:[/*·^][A-Za-zµμ]+)*(?!\w)")
_ASIDE = re.compile(r"\s*(?!x)[A-Za-z]{1,2}\d{1,2}\s|[^(\d]*\([^)]*\)$")
"""A tolerance zone before the unit, or another unit in brackets behind it."""
_ZONE = re.compile(r"\s*[A-Za-z]{1,2}\d{1,2}\s*")
_OTHERS = {
    POWER: {"metrichp": "PS", "hpm": "PS", "metrichorsepower": "PS", "pk": "PS", "hpi": "hp"},
    TORQUE: {"kgm": "kgf m", "kpm": "kgf m", "tm": "", "joule": "N m"},
}
"""Other spellings by what `_look` leaves of them."""


def meant(text: str, place: Quantity) -> str | None:
    """The value that this text would be with a unit that it probably means."""
    short = text.strip()
    between = _RANGE.search(short) and not _DEVIATIONS.search(short)
    if place.dimension == NUMBER or not short or between:
        return None
    begin = _BEFORE.match(short)
    try:
        short = plain_value(short[begin.end() if begin else 0 :])
    except UnitError:
        return None
    unit = behind_number(short)
    number = short.removesuffix(unit).strip() if unit else short
    if _fitting(f"{number} {place.unit}", place) is None:
        return None
    if not unit or _ZONE.fullmatch(unit):
        return f"{number} {place.unit}"
    if place.dimension == TEMPERATURE:
        return _in_celsius(float(number), _look(unit))
    alike = [known for known in USUAL.get(place.dimension, ()) if _look(known) == _look(unit)]
    other = _OTHERS.get(place.dimension, {}).get(_look(unit))
    beside = not re.search(r"\d", unit) or _DEVIATIONS.search(short) or _ASIDE.match(unit)
    words = [other] if other is not None else [*alike, *(_WORD.findall(unit) if beside else ())]
    return next((found for word in words if (found := _fitting(f"{number} {word}", place))), None)


def usual_units(place: Quantity) -> str:
    """Units that drawings have for it."""
    return ", ".join(pretty(unit).replace(" ", "·") for unit in USUAL.get(place.dimension, ()))


def instead(found: Dimension, place: Quantity) -> str:
    """What a unit of another dimension says; empty where there are no words for it."""
    if found == PITCH and "module" in place.path:
        return "that is a diametral pitch, which stands at diametral_pitch"
    if found == POWER and place.path == "operation.torque":
        return "that is a power, which stands at operation.power"
    if found == PRESSURE and place.dimension == STIFFNESS:
        return "that is a stiffness over the face width: its product with b stands here"
    return f"that is {DIMENSION_NAMES[found]}" if found in DIMENSION_NAMES and found != NUMBER else ""


def _fitting(text: str, place: Quantity) -> str | None:
    try:
        return text if takes(place.dimension, read(text, place.dimension)[1]) else None
    except UnitError:
        return None


def _in_celsius(number: float, unit: str) -> str | None:
    if unit in ("f", "degf", "fahrenheit"):
        return f"{(number - 32.0) / 1.8:.4g} degC"
    return f"{number - 273.15:.4g} degC" if unit in ("k", "kelvin") else None


def _look(unit: str) -> str:
    """Letters and digits alone: ``N·m``, ``NM`` and ``n-m`` look alike, and ``rev per min`` like rev/min."""
    return re.sub(r"[\W_]", "", re.sub(r"\bper\b", "", unit.casefold()))
