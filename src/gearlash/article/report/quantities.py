"""Numbers of a case in words: dimensionless first, physical beside it, marked where it rests on an
assumption.
"""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.case import Case
from gearlash.case.edges import at_most, shown_edge
from gearlash.plots import Units
from gearlash.plots.units import Twin
from gearlash.plots.words import GEARS
from gearlash.report.blocks import Inline, Marked
from gearlash.report.numbers import number


@dataclass(frozen=True)
class Quantities:
    """How this case's numbers are said."""

    units: Units

    @staticmethod
    def of(case: Case) -> Quantities:
        return Quantities(Units.of(case))

    def physical(self, parameter: str, *values: float) -> Inline | None:
        """``3714.9 rpm``, ``44.8 µm``, or an interval of them, its ends rounded into it as everywhere; None
        where the case has no such scale."""
        twin = self.units.of_parameter(parameter)
        return None if twin is None else _said(twin, values)

    def assumed(self, *scales: Twin | None) -> bool:
        """Does any of these scales rest on an assumed value?"""
        return any(scale.assumed for scale in scales if scale is not None)

    def length(self, displacement: float) -> Inline | None:
        """A distance in µm."""
        return None if self.units.length is None else _said(self.units.length, (displacement,))

    def at_most(self, parameter: str, distance: float) -> Inline | None:
        """A distance from where the case stands, in physical units: never more than it is."""
        twin = self.units.of_parameter(parameter)
        return None if twin is None else _marked(at_most(float(twin(distance))), twin)

    def edge(self, parameter: str, value: float, inwards: int, here: float) -> tuple[Inline, ...]:
        """The end of an interval around a value, in both units, rounded into it."""
        words = f"{symbol(parameter)} = {shown_edge(value, inwards, here)}"
        twin = self.units.of_parameter(parameter)
        if twin is None:
            return (words,)
        physical = shown_edge(float(twin(value)), inwards, float(twin(here)))
        return (f"{words} (", _marked(physical, twin), ")")

    def place(self, parameter: str, value: float, digits: int = 6) -> tuple[Inline, ...]:
        """``ω = 0.972484 (3714.9 rpm)``."""
        words = f"{symbol(parameter)} = {number(value, digits)}"
        physical = self.physical(parameter, value)
        return (words,) if physical is None else (f"{words} (", physical, ")")


def symbol(parameter: str) -> str:
    """ω, D, ..."""
    return GEARS.symbols.get(parameter, parameter)


def fixed_words(fixed: object) -> str:
    """``D = 1, ω = 0.78``."""
    pairs = dict(fixed) if isinstance(fixed, dict) else dict(getattr(fixed, "items", dict)())
    return ", ".join(f"{symbol(name)} = {number(value)}" for name, value in pairs.items())


def _said(twin: Twin, values: tuple[float, ...]) -> Inline:
    scaled = [float(twin(value)) for value in values]
    if len(scaled) > 1:
        inwards = [1, *[0] * (len(scaled) - 2), -1]
        said = [shown_edge(value, way) for value, way in zip(scaled, inwards, strict=True)]
    else:
        places = 1 if twin.unit == "rpm" else max(0, 2 - len(str(int(abs(scaled[0])))) + 1)
        said = [f"{scaled[0]:.{places}f}"]
    return _marked(" to ".join(said), twin)


def _marked(number: str, twin: Twin) -> Inline:
    text = f"{number} {twin.unit}"
    return Marked(text) if twin.assumed else text
