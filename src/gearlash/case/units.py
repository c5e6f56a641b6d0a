"""Physical values as engineers type them: ``4 mm``, ``12 N·m``, ``3.2e8 N/m``, ``3600 rpm``, ``18°``.

A value is a number and a product of unit words. The words of gear drawings are known here; any other word
is asked of pint, which is loaded only then (it takes longer than a whole run). Angles are a dimension of
their own, so that 60 Hz is no shaft speed. Numbers are kept as fractions until the end: ``100 um`` is
exactly the float 1e-4.
"""

from __future__ import annotations

import re
from fractions import Fraction
from functools import cache
from math import inf, isfinite, pi
from typing import Any, NamedTuple

from .spelling import plain_unit, plain_value


class Dimension(NamedTuple):
    """Exponents of length, mass, time, angle and temperature."""

    length: int = 0
    mass: int = 0
    time: int = 0
    angle: int = 0
    temperature: int = 0


NUMBER = Dimension()
LENGTH = Dimension(length=1)
MASS = Dimension(mass=1)
ANGLE = Dimension(angle=1)
FREQUENCY = Dimension(time=-1)
SPEED = Dimension(time=-1, angle=1)
FORCE = Dimension(1, 1, -2)
TORQUE = Dimension(2, 1, -2)
POWER = Dimension(2, 1, -3)
STIFFNESS = Dimension(0, 1, -2)
INERTIA = Dimension(2, 1)
TEMPERATURE = Dimension(temperature=1)
"""Read off a thermometer: in °C everywhere, as a drawing counts from 20 °C."""

DIMENSION_NAMES = {
    NUMBER: "a number without unit",
    LENGTH: "a length",
    MASS: "a mass",
    ANGLE: "an angle",
    FREQUENCY: "a frequency in cycles per second",
    SPEED: "a rotational speed",
    FORCE: "a force",
    TORQUE: "a torque",
    POWER: "a power",
    STIFFNESS: "a stiffness",
    INERTIA: "a moment of inertia",
    TEMPERATURE: "a temperature in °C",
}


class Unit(NamedTuple):
    """SI value of one unit: ``ratio`` · π^``pi_power``."""

    ratio: Fraction
    pi_power: int
    dimension: Dimension

    def convert(self, number: Fraction) -> float:
        """This many units in SI, correctly rounded but for the power of π; infinite when too large."""
        try:
            return float(number * self.ratio) * pi**self.pi_power
        except OverflowError:
            return inf

    def express(self, value: float) -> float:
        """A value in SI as a number of these units."""
        return float(Fraction(value) / self.ratio) / pi**self.pi_power


def _unit(ratio: str | int, dimension: Dimension, pi_power: int = 0) -> Unit:
    return Unit(Fraction(ratio), pi_power, dimension)


UNIT_WORDS: dict[str, Unit] = {
    "%": _unit("1/100", NUMBER),
    "m": _unit(1, LENGTH),
    "cm": _unit("1/100", LENGTH),
    "mm": _unit("1/1000", LENGTH),
    "um": _unit("1e-6", LENGTH),
    "micron": _unit("1e-6", LENGTH),
    "nm": _unit("1e-9", LENGTH),
    "kg": _unit(1, MASS),
    "g": _unit("1/1000", MASS),
    "t": _unit(1000, MASS),
    "s": _unit(1, Dimension(time=1)),
    "ms": _unit("1/1000", Dimension(time=1)),
    "min": _unit(60, Dimension(time=1)),
    "rad": _unit(1, ANGLE),
    "mrad": _unit("1/1000", ANGLE),
    "deg": _unit("1/180", ANGLE, pi_power=1),
    "rev": _unit(2, ANGLE, pi_power=1),
    "U": _unit(2, ANGLE, pi_power=1),
    "r": _unit(2, ANGLE, pi_power=1),
    "rpm": _unit("1/30", SPEED, pi_power=1),
    "Hz": _unit(1, FREQUENCY),
    "kHz": _unit(1000, FREQUENCY),
    "N": _unit(1, FORCE),
    "kN": _unit(1000, FORCE),
    "MN": _unit(1_000_000, FORCE),
    "mN": _unit("1/1000", FORCE),
    "W": _unit(1, POWER),
    "kW": _unit(1000, POWER),
    "MW": _unit(1_000_000, POWER),
    "degC": _unit(1, TEMPERATURE),
}
"""Unit words that need no library; a test holds every one against pint."""

PER_MINUTE = _unit("1/60", FREQUENCY)
_NUMBER = re.compile(r"([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)", re.ASCII | re.DOTALL)
_TERM = re.compile(r"([A-Za-z]+|%)(?:\^?(-?\d))?", re.ASCII)
_JOINED = re.compile(r"\b(kN|MN|mN|N)(m|mm|cm)\b|\b(kg)(m)(?=\^?2\b)")
_NO_NUMBER = "nan", "inf", "infinity"


class UnitError(ValueError):
    """The text is no physical value; its message says what is wrong with it."""


def read(text: str) -> tuple[Fraction, Unit]:
    """Number and unit of a text such as ``3.2e8 N/m``; no unit at all is `NUMBER`. Raises `UnitError`."""
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
        raise UnitError("a decimal point is written '.', and thousands are not set apart")
    if re.match(r"\*?\s*10\b", match[2]):
        raise UnitError("a power of ten is written 3.4e8 or 3.4*10^8")
    return _number(match[1]), unit(match[2])


def behind_number(text: str) -> str:
    """What stands behind the number of a text: its unit."""
    match = _NUMBER.fullmatch(plain_value(text))
    return match[2] if match else ""


def in_unit_of(other: str, text: str) -> str:
    """A value as typed; a number alone gets the unit of the other one, as ``60`` in ``60:120um``."""
    try:
        float(text)
    except ValueError:
        return text
    return text + behind_number(other)


def unit(text: str) -> Unit:
    """The unit of a text such as ``N·m`` or ``kg m^2``. Raises `UnitError` naming the part that is no
    unit."""
    words = _JOINED.sub(lambda m: f"{m[1] or m[3]}*{m[2] or m[4]}", plain_unit(text))
    result = Unit(Fraction(1), 0, NUMBER)
    if not words:
        return result
    for sign, part in _terms(words):
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
        word, exponent = _word(match[1]), sign * int(match[2] or 1)
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
    if word in UNIT_WORDS:
        return UNIT_WORDS[word]
    found = ask_pint(word)
    if found is None:
        same = [known for known in UNIT_WORDS if known.lower() == word.lower()]
        raise UnitError(f"{word!r} is no unit" + (f" ({same[0]!r} is)" if same else ""))
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


PRETTY = {"um": "µm", "N*m": "N·m", "kg*m^2": "kg·m²", "deg": "°", "degC": "°C", "N/mm/um": "N/(mm·µm)"}


def pretty(unit: str) -> str:
    """A unit as it is printed: ``um`` → ``µm``, ``N*m`` → ``N·m``."""
    return PRETTY.get(unit, unit)
