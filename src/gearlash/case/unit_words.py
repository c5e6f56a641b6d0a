"""Unit words of gear drawings, each with its dimension and its value in SI."""

from __future__ import annotations

from fractions import Fraction
from math import inf, pi
from typing import NamedTuple


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
PRESSURE = Dimension(-1, 1, -2)
DENSITY = Dimension(-3, 1)
PITCH = Dimension(length=-1)
TEMPERATURE = Dimension(temperature=1)
"""Read off a thermometer: in °C everywhere, as a drawing counts from 20 °C."""
EXPANSION = Dimension(temperature=-1)
"""Per degree of a difference, which is as large in K as in °C."""

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
    PRESSURE: "a modulus",
    DENSITY: "a density",
    PITCH: "teeth per length",
    TEMPERATURE: "a temperature in °C",
    EXPANSION: "a thermal expansion",
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


_POUND, _GRAVITY, _INCH = Fraction("0.45359237"), Fraction("9.80665"), Fraction("0.0254")

UNIT_WORDS: dict[str, Unit] = {
    "%": _unit("1/100", NUMBER),
    "ppm": _unit("1e-6", NUMBER),
    "m": _unit(1, LENGTH),
    "cm": _unit("1/100", LENGTH),
    "mm": _unit("1/1000", LENGTH),
    "um": _unit("1e-6", LENGTH),
    "micron": _unit("1e-6", LENGTH),
    "nm": _unit("1e-9", LENGTH),
    "in": Unit(_INCH, 0, LENGTH),
    "ft": Unit(12 * _INCH, 0, LENGTH),
    "mil": Unit(_INCH / 1000, 0, LENGTH),
    "thou": Unit(_INCH / 1000, 0, LENGTH),
    "kg": _unit(1, MASS),
    "g": _unit("1/1000", MASS),
    "t": _unit(1000, MASS),
    "lb": Unit(_POUND, 0, MASS),
    "oz": Unit(_POUND / 16, 0, MASS),
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
    "cN": _unit("1/100", FORCE),
    "daN": _unit(10, FORCE),
    "lbf": Unit(_POUND * _GRAVITY, 0, FORCE),
    "ozf": Unit(_POUND * _GRAVITY / 16, 0, FORCE),
    "kgf": Unit(_GRAVITY, 0, FORCE),
    "W": _unit(1, POWER),
    "kW": _unit(1000, POWER),
    "MW": _unit(1_000_000, POWER),
    "hp": Unit(550 * 12 * _INCH * _POUND * _GRAVITY, 0, POWER),
    "PS": Unit(75 * _GRAVITY, 0, POWER),
    "MPa": _unit(1_000_000, PRESSURE),
    "GPa": _unit(1_000_000_000, PRESSURE),
    "DP": Unit(1 / _INCH, 0, PITCH),
    "degC": _unit(1, TEMPERATURE),
}
"""Unit words that need no library; a test holds every one against pint."""

PER_DEGREE = {
    **dict.fromkeys(("K", "degC"), _unit(1, TEMPERATURE)),
    **dict.fromkeys(("degF", "F"), _unit("5/9", TEMPERATURE)),
}
"""Words that say how large a degree is, and may stand below a stroke: 333 K is no temperature in °C."""

OTHER_WORDS = {
    **{word.upper(): word for word in ("mm", "cm", "kg", "rpm", "deg", "rad", "in", "ft", "mil", "thou")},
    **{word.upper(): word for word in ("lb", "lbf", "oz", "ozf", "hp")},
    **dict.fromkeys(("inch", "inches", "INCH", "INCHES"), "in"),
    **dict.fromkeys(("lbs", "LBS", "lbm", "pound", "pounds"), "lb"),
    **dict.fromkeys(("mils", "MILS"), "mil"),
    **dict.fromkeys(("bhp", "BHP"), "hp"),
    **dict.fromkeys(("CV", "ch"), "PS"),
    **dict.fromkeys(("Rpm", "Upm", "UPM"), "rpm"),
    **dict.fromkeys(("Umdr", "tr", "turn", "turns"), "rev"),
    **dict.fromkeys(("C", "Celsius"), "degC"),
    **dict.fromkeys(("Deg", "degree", "degrees"), "deg"),
    "KW": "kW",
    "Kg": "kg",
    "kp": "kgf",
    "lbfs": "lbf",
}
"""The same in capitals, as drawings of the USA are lettered, or in another language."""

USUAL: dict[Dimension, tuple[str, ...]] = {
    LENGTH: ("mm", "um", "m", "cm", "in", "mil"),
    MASS: ("kg", "g", "t", "lb"),
    ANGLE: ("deg", "rad"),
    SPEED: ("rpm", "rev/min", "U/min", "1/min", "min^-1", "rev/s", "rad/s"),
    FREQUENCY: ("Hz", "1/s"),
    FORCE: ("N", "kN", "lbf", "kgf"),
    TORQUE: ("N m", "kN m", "N mm", "lbf in", "lbf ft", "kgf m"),
    POWER: ("kW", "W", "MW", "hp", "PS"),
    STIFFNESS: ("N/m", "N/um", "N/mm", "lbf/in"),
    INERTIA: ("kg m^2", "kg cm^2", "g cm^2", "lb in^2", "lbf in s^2"),
    PRESSURE: ("GPa", "MPa", "N/mm^2", "psi"),
    DENSITY: ("kg/m^3", "g/cm^3", "lb/in^3"),
    PITCH: ("1/in", "DP"),
    TEMPERATURE: ("degC",),
    EXPANSION: ("um/(m*K)", "1/K", "ppm/K", "1/degC"),
}
"""Units that drawings have for a dimension, to be told where another one stands there."""
