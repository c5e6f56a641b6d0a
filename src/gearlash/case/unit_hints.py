"""What a value that cannot be read probably means: the same number with a unit that fits."""

from __future__ import annotations

import re

from .quantity import Quantity
from .spelling import plain_value
from .unit_words import (
    ANGLE,
    DENSITY,
    INERTIA,
    LENGTH,
    PITCH,
    POWER,
    PRESSURE,
    STIFFNESS,
    TEMPERATURE,
    TORQUE,
    USUAL,
    Dimension,
)
from .units import DIMENSION_NAMES, NUMBER, UnitError, behind_number, in_si, pretty, read, takes

_BEFORE = re.compile(r"[^\d+\-−–—‐‑.,]*(?:[.,](?!\d))?[^\d+\-−–—‐‑.,]*")
_RANGE = re.compile(r"\d\s*(?:\.\.+|…|:|~|-|–|to\b|/)\s*[-+]?[\d.]")
_DEVIATIONS = re.compile(r"±|[\s\d]\+\s?[\d/]")
_WORD = re.compile(r"(?<!\w)[A-Za-zµμ°\"]+(?:[/*·^][A-Za-zµμ]+)*(?!\w)")
_ASIDE = re.compile(r"\s*(?!x)[A-Za-z]{1,2}\d{1,2}\s|[^(\d]*\([^)]*\)$")
"""A tolerance zone before the unit, or another unit in brackets behind it."""
_ZONE = re.compile(r"\s*[A-Za-z]{1,2}\d{1,2}\s*")
_BEHIND = re.compile(
    r"\d\s*(?P<zone>(?![xX]|(?<=\d)[eE]\d|(?:[µμu]m|[mcdk]m|in|ft)\d)[A-Za-z]{1,2}(?P<grade>[4-9]|1[0-8]))\s*(?:[µμu]m|mm|m|in)?\s*$"
)
"""A tolerance zone behind a size: no power of a unit or of ten, and no hexadecimal number."""
_GYRATION = re.compile(r"\W*(?<!\w)(?:[GP]\s?D\s?(?:²|\^?2|\*\*2)?|Schwungmoment)(?!\w)\W*", re.IGNORECASE)
"""GD², the flywheel effect of weight and diameter squared: 4 J, in kgf·m² or kg·m²."""
_OTHERS = {
    POWER: {"metrichp": "PS", "hpm": "PS", "metrichorsepower": "PS", "pk": "PS", "hpi": "hp"},
    TORQUE: {
        **{f"{weight}{arm}": f"kgf {arm}" for weight in ("kg", "kp") for arm in ("m", "cm")},
        "tm": "",
        "joule": "N m",
    },
}
"""Other spellings by what `_look` leaves of them."""
_OTHER_SENSE = re.compile(
    r"\b(?:minus|neg\w*|radi(?:us|al)|half|halb\w*|each|je|per\s+(?:side|flank|gear|tooth|wheel))\b"
    r"|\bs?r(?:ad(?:ius)?)?\W*\d",
    re.IGNORECASE,
)
"""A sign in words, a radius where diameters stand, a half: the number alone would be another value."""
_OF_ANGLES = re.compile(r"(?:helix|pressure|angle|alpha|beta|[αβ][a-z]?|deg(?:ree)?s?|rad|[\W\d_])*")
"""All that may stand beside an angle and says nothing of its sign, as the hand of a helix does."""
_OWN_FACTOR = {ANGLE: 20.0, DENSITY: 10.0}
_USUAL_FACTOR, _OTHER_FACTOR, _FAR_OFF, _CLOSE = 100.0, 10.0, 300.0, 3.0
"""How far from its example a value may be in the unit of its place, where `_OWN_FACTOR` has nothing for its
dimension; how far in another one; from where on another one is tried; and how close it is as good a guess."""


def meant(text: str, place: Quantity) -> str | None:
    """The value that this text would be with a unit that it probably means."""
    short = text.strip()
    if place.dimension == INERTIA and _GYRATION.search(short):
        alone = _GYRATION.sub(" ", short).strip()
        return _quarter(meant(alone, place) or alone, place)
    between = _RANGE.search(short) and not _DEVIATIONS.search(short)
    if place.dimension == NUMBER or not short or between or _says_more(short, place):
        return None
    begin = _BEFORE.match(short)
    try:
        short = plain_value(short[begin.end() if begin else 0 :])
    except UnitError:
        return None
    unit = behind_number(short)
    number = short.removesuffix(unit).strip() if unit else short
    if _value(f"{number} {place.unit}", place) is None:
        return None
    if not unit or _ZONE.fullmatch(unit):
        return _sized(number, place)
    if place.dimension == TEMPERATURE:
        return _in_celsius(float(number), _look(unit), place)
    alike = [known for known in USUAL.get(place.dimension, ()) if _look(known) == _look(unit)]
    other = _OTHERS.get(place.dimension, {}).get(_look(unit))
    beside = not re.search(r"\d", unit) or _DEVIATIONS.search(short) or _ASIDE.match(unit)
    words = [other] if other is not None else [*alike, *(_WORD.findall(unit) if beside else ())]
    return next((found for word in words if (found := _fitting(f"{number} {word}", place))), None)


def _quarter(text: str, place: Quantity) -> str | None:
    """The moment of inertia that is J of this GD²."""
    size = _value(text.replace("kgf", "kg"), place)
    return None if size is None else _fitting(f"{0.25 * size:.6g} {place.unit}", place)


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


def beside(text: str, place: Quantity) -> str:
    """Where a tolerance zone stands that is written behind a length, as ``js7``; empty where none is."""
    zone = _BEHIND.search(text)
    if zone is None or place.dimension != LENGTH:
        return ""
    if place.path == "mesh.centre_distance":
        return f"the {zone['grade']} of {zone['zone']} stands at distance_grade"
    return f"{zone['zone']} is a tolerance zone: the size alone stands here"


def of_diameters(text: str, place: Quantity) -> str:
    """What GD² is, where it stands for a moment of inertia; empty where it does not."""
    return "GD² is 4 J" if place.dimension == INERTIA and _GYRATION.search(text) else ""


def _says_more(text: str, place: Quantity) -> bool:
    """Whether words stand there that make another value of the number."""
    if place.dimension == ANGLE:
        return _OF_ANGLES.fullmatch(text.casefold()) is None
    return _OTHER_SENSE.search(text) is not None and "radius" not in place.path


def _sized(number: str, place: Quantity) -> str | None:
    """A bare number with the unit that makes a usual size of it: the place's own, or the only other one that
    drawings have. Where several do, or none does, nobody can tell."""
    example = _value(place.example, place)
    own = _value(f"{number} {place.unit}", place)
    if not example or not own or place.dimension == TEMPERATURE:
        return _fitting(f"{number} {place.unit}", place)
    off = _factor(own, example)
    others: dict[float, str] = {}
    for unit in USUAL.get(place.dimension, ()):
        value = _value(text := f"{number} {unit}", place)
        if unit == "cm" or not value or value == own or not place.accepts(value):
            continue  # no drawing of gears means centimetres where it leaves the unit out
        if _factor(value, example) <= _OTHER_FACTOR:
            others.setdefault(value, text)
    if off <= _OWN_FACTOR.get(place.dimension, _USUAL_FACTOR):
        doubt = off > _OTHER_FACTOR and any(_factor(value, example) <= _CLOSE for value in others)
        return None if doubt else _fitting(f"{number} {place.unit}", place)
    return next(iter(others.values())) if off >= _FAR_OFF and len(others) == 1 else None


def _factor(value: float, example: float) -> float:
    """How many times the greater one is the smaller one, signs apart."""
    ratio = abs(value / example)
    return max(ratio, 1.0 / ratio)


def _value(text: str, place: Quantity) -> float | None:
    """In SI, of a text with a unit that is taken here."""
    try:
        number, unit = read(text, place.dimension)
    except UnitError:
        return None
    return in_si(place.dimension, number, unit) if takes(place.dimension, unit) else None


def _fitting(text: str, place: Quantity) -> str | None:
    """The text, where it is a value that is taken here."""
    value = _value(text, place)
    return text if value is not None and place.accepts(value) else None


def _in_celsius(number: float, unit: str, place: Quantity) -> str | None:
    if unit in ("f", "degf", "fahrenheit"):
        return _fitting(f"{(number - 32.0) / 1.8:.4g} degC", place)
    return _fitting(f"{number - 273.15:.4g} degC", place) if unit in ("k", "kelvin") else None


def _look(unit: str) -> str:
    """Letters and digits alone: ``N·m``, ``NM`` and ``n-m`` look alike, and ``rev per min`` like rev/min."""
    return re.sub(r"[\W_]", "", re.sub(r"\bper\b", "", unit.casefold()))
