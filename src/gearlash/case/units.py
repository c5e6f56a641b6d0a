"""Physical values as engineers type them: ``4 mm``, ``12 N·m``, ``3.2e8 N/m``, ``3600 rpm``, ``18°``.

A value is a number and a product of unit words. The words of gear drawings are known here; any other word
is asked of pint, which is loaded only then (it takes longer than a whole run). Angles are a dimension of
their own, so that 60 Hz is no shaft speed. Numbers are kept as fractions until the end: ``100 um`` is
exactly the float 1e-4.
"""

from __future__ import annotations

import re
from fractions import Fraction
from functools import cache, lru_cache
from math import isfinite, nan
from typing import Any

from .spelling import plain_unit, plain_value
from .unit_words import ANGLE as ANGLE
from .unit_words import DENSITY as DENSITY
from .unit_words import DIMENSION_NAMES as DIMENSION_NAMES
from .unit_words import EXPANSION as EXPANSION
from .unit_words import FORCE as FORCE
from .unit_words import FREQUENCY as FREQUENCY
from .unit_words import INERTIA as INERTIA
from .unit_words import LENGTH as LENGTH
from .unit_words import MASS as MASS
from .unit_words import NUMBER as NUMBER
from .unit_words import OTHER_WORDS, PER_DEGREE, UNIT_WORDS, Dimension, Unit
from .unit_words import PITCH as PITCH
from .unit_words import POWER as POWER
from .unit_words import PRESSURE as PRESSURE
from .unit_words import SPEED as SPEED
from .unit_words import STIFFNESS as STIFFNESS
from .unit_words import TEMPERATURE as TEMPERATURE
from .unit_words import TORQUE as TORQUE
from .written_numbers import UnitError as UnitError

PER_MINUTE = Unit(Fraction(1, 60), 0, FREQUENCY)
_NUMBER = re.compile(r"([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)", re.ASCII | re.DOTALL)
_TERM = re.compile(r"([A-Za-z]+|%)(?:\^?(-?\d))?", re.ASCII)
_JOINED = re.compile(
    r"\b(kN|MN|mN|cN|daN|N|kgf|kp)(m|mm|cm)\b"  # Nm
    r"|\b(kg|g)(mm|cm|m)(?=\^?2\b)"  # kgm², gcm²
    r"|\b(lbf|lb|ozf|oz)(in|ft)\b|\b(in|ft)(lbfs?|lbs?|ozf?)\b"  # lbft, inlb
)
_WEIGHED = re.compile(r"\b(lbs?|oz|pounds?)\b", re.IGNORECASE)
_NO_NUMBER = "nan", "inf", "infinity"


@lru_cache(maxsize=64)
def read(text: str, dimension: Dimension = NUMBER) -> tuple[Fraction, Unit]:
    """Number and unit of a text such as ``3.2e8 N/m``; no unit at all is `NUMBER`. Where a dimension is told,
    ``lb ft`` is the weight of a pound. Raises `UnitError`."""
    stripped = plain_value(text)
    if not stripped:
        raise UnitError("nothing stands there")
    match = _NUMBER.fullmatch(stripped)
    if match is None:
        first = stripped.split()[0].lstrip("+-").lower()
        raise UnitError(
            "it is not a finite number" if first in _NO_NUMBER else "it does not start with a number"
        )
    if match[2].startswith(","):
        raise UnitError("there are several commas, and no digits between them in threes")
    if re.match(r"\*?\s*10\b", match[2]):
        raise UnitError("a power of ten is written 3.4e8 or 3.4*10^8")
    return _number(match[1]), unit_for(dimension, match[2])


def behind_number(text: str) -> str:
    """What stands behind the number of a text: its unit."""
    return number_and_unit(text)[1]


def number_and_unit(text: str) -> tuple[float, str]:
    """A number and what stands behind it: NaN where it is none or not finite, nothing where there is none."""
    try:
        match = _NUMBER.fullmatch(plain_value(text))
    except UnitError:
        match = None
    if match is None:
        return nan, ""
    found = float(match[1])
    return (found if isfinite(found) else nan), match[2]


def in_unit_of(other: str, text: str) -> str:
    """A value as typed; a number alone gets the unit of the other one, as ``60`` in ``60:120um``."""
    behind = behind_number(other.strip().lstrip("øØ⌀"))
    try:
        number = text.strip().lstrip("øØ⌀")
        bare = not behind_number(number) and read(number)[1].dimension == NUMBER
        unit(behind)
    except UnitError:
        return text
    return f"{text} {behind}".rstrip() if bare else text


@lru_cache(maxsize=256)
def unit(text: str) -> Unit:
    """The unit of a text such as ``N·m`` or ``kg m^2``. Raises `UnitError` naming the part that is no
    unit."""
    words = _parted(text)
    result = Unit(Fraction(1), 0, NUMBER)
    if not words:
        return result
    below = False
    for sign, part in _terms(words):
        below = below or sign < 0
        if part == "1" and sign == 1:
            continue
        match = _TERM.fullmatch(part)
        if not part:
            raise UnitError("a unit is missing before or after '*' or '/'; powers of ten are written 4e-3")
        if match is None:
            grouped = (
                "; digits are written without anything between them" if re.match(r"['_]?\d", part) else ""
            )
            raise UnitError(f"{part!r} is no unit{grouped}")
        exponent = sign * int(match[2] or 1)
        if match[1] in PER_DEGREE and (below or exponent < 0):  # µm/m·K: below the stroke all the same
            word, exponent = PER_DEGREE[match[1]], -abs(exponent)
        else:
            word = _word(match[1])
        result = Unit(
            result.ratio * word.ratio**exponent,
            result.pi_power + word.pi_power * exponent,
            Dimension(*(a + b * exponent for a, b in zip(result.dimension, word.dimension, strict=True))),
        )
    return result


def _terms(words: str) -> list[tuple[int, str]]:
    """(±1, word with exponent) of a product; a slash divides by the next word only."""
    spaced = re.sub(r"\s*([*/^])\s*", r"\1", words)
    parts = re.split(r"([*/]|\s+)", spaced)
    signs = [1, *(-1 if separator == "/" else 1 for separator in parts[1::2])]
    return list(zip(signs, parts[::2], strict=True))


def takes(dimension: Dimension, found: Unit) -> bool:
    """Whether a quantity of this dimension may be given in a unit: in one of its own, and shaft speeds, as
    drawings do, in 1/min. (1/s and Hz are refused for them: turns and radians may be meant.)"""
    return found.dimension == dimension or (dimension == SPEED and found == PER_MINUTE)


def _parted(text: str) -> str:
    """Words of a unit apart: ``N*m`` of Nm."""
    return _JOINED.sub(lambda m: "*".join(filter(None, m.groups())), plain_unit(text))


def unit_for(dimension: Dimension, text: str) -> Unit:
    """The unit of a text where a quantity of this dimension is to stand: pounds and ounces are masses or,
    where only that fits, their weights, as in lb ft. Raises `UnitError`."""
    found = unit(text)
    if takes(dimension, found):
        return found
    words = _parted(text)
    weights = _WEIGHED.sub(lambda m: "ozf" if m[0].lower() == "oz" else "lbf", words)
    if weights != words and takes(dimension, weighed := unit(weights)):
        return weighed
    return found


def in_si(dimension: Dimension, number: Fraction, found: Unit) -> float:
    """A number of such units in SI."""
    return (UNIT_WORDS["rpm"] if dimension == SPEED and found == PER_MINUTE else found).convert(number)


def _number(text: str) -> Fraction:
    value = float(text)
    if not isfinite(value):
        raise UnitError("it is too large to be a number")
    # An absurd exponent would make an absurdly long fraction; the float is all that can matter.
    mantissa, _, exponent = text.lower().partition("e")
    return Fraction(text) if len(exponent) <= 4 and len(mantissa) <= 400 else Fraction(value)


def _word(word: str) -> Unit:
    word = OTHER_WORDS.get(word, word)
    if word in UNIT_WORDS:
        return UNIT_WORDS[word]
    found = ask_pint(word)
    if found is None:
        raise UnitError(f"{word!r} is no unit")
    return found


@cache
def ask_pint(word: str) -> Unit | None:
    """What pint makes of one word, or None when it is no unit of length, mass, time and angle."""
    import pint  # late: loading it takes longer than a whole run

    try:
        one = _registry().Quantity(1.0, word).to_base_units()
    except (pint.PintError, AttributeError, TypeError, ValueError):
        return None
    factor: Any = one.magnitude
    exponents: dict[str, Any] = dict(one.unit_items())
    known = {"meter": 0, "kilogram": 1, "second": 2, "radian": 3}
    if not exponents or not set(exponents) <= set(known) or not isinstance(factor, int | float):
        return None
    dimension = [0, 0, 0, 0]
    for name, exponent in exponents.items():
        if exponent != int(exponent):
            return None
        dimension[known[name]] = int(exponent)
    return Unit(Fraction(repr(float(factor))), 0, Dimension(*dimension))


@cache
def _registry():
    import pint

    return pint.UnitRegistry(cache_folder=None)


PRETTY = {
    "um": "µm",
    "uN": "µN",
    "m/s^2": "m/s²",
    "mm/s^2": "mm/s²",
    "um/s^2": "µm/s²",
    "N*m": "N·m",
    "kg*m^2": "kg·m²",
    "deg": "°",
    "degC": "°C",
    "N/mm/um": "N/(mm·µm)",
    "um/(m*K)": "µm/(m·K)",
}


def pretty(unit: str) -> str:
    """A unit as it is printed: ``um`` → ``µm``, ``N*m`` → ``N·m``."""
    return PRETTY.get(unit, unit)
