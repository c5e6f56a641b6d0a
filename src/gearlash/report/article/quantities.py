"""Numbers of a case in words: dimensionless first, physical beside it, marked where it rests on an
assumption.
"""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.case import Case
from gearlash.plots import Units
from gearlash.plots.units import SYMBOLS, Twin
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
        """``3715 rpm``, ``44.8 µm``, or an interval of them; None where the case has no such scale."""
        twin = self.units.of_parameter(parameter)
        return None if twin is None else _said(twin, values)

    def assumed(self, *scales: Twin | None) -> bool:
        """Does any of these scales rest on an assumed value?"""
        return any(scale.assumed for scale in scales if scale is not None)

    def length(self, displacement: float) -> Inline | None:
        """A distance in µm."""
        return None if self.units.length is None else _said(self.units.length, (displacement,))

    def place(self, parameter: str, value: float, digits: int = 6) -> tuple[Inline, ...]:
        """``ω = 0.972484 (3715 rpm)``."""
        words = f"{symbol(parameter)} = {number(value, digits)}"
        physical = self.physical(parameter, value)
        return (words,) if physical is None else (f"{words} (", physical, ")")


def symbol(parameter: str) -> str:
    """ω, D, ..."""
    return SYMBOLS.get(parameter, parameter)


def fixed_words(fixed: object) -> str:
    """``D = 1, ω = 0.78``."""
    pairs = dict(fixed) if isinstance(fixed, dict) else dict(getattr(fixed, "items", dict)())
    return ", ".join(f"{symbol(name)} = {number(value)}" for name, value in pairs.items())


def _said(twin: Twin, values: tuple[float, ...]) -> Inline:
    scaled = [float(twin(value)) for value in values]
    places = 0 if twin.unit == "rpm" else max(0, 2 - len(str(int(max(abs(v) for v in scaled)))) + 1)
    text = " to ".join(f"{value:.{places}f}" for value in scaled) + f" {twin.unit}"
    return Marked(text) if twin.assumed else text
