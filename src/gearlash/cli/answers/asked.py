"""A parameter in the unit that it was asked for in."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from gearlash.case import Case
from gearlash.case.edges import shown_distance, shown_edge, shown_interval
from gearlash.case.units import UnitError, pretty, read

SMALL = 1e-3  # of a unit: a value that is in range wherever it is converted
DIGITS = 15
"""Significant ones of values that are converted from dimensionless ones: 3000 rpm are not
3000.0000000000005."""
INTERVAL_DIGITS = 6  # significant ones of the ends of an interval that is told beside others


@dataclass(frozen=True)
class Asked:
    """How values of the varied parameter are told: its dimensionless values times ``factor``."""

    name: Annotated[str, "as it was typed"]
    unit: Annotated[str, "that it was typed in; empty where values are dimensionless"]
    factor: Annotated[float, "what dimensionless values are multiplied with"]
    gear: Annotated[str, "pinion or gear, where the name is that of one of them; else empty"] = ""

    @staticmethod
    def of(case: Case, short: str, named: str, unit: str) -> Asked:
        """``named`` is the name as typed, ``unit`` the one typed with it (empty: none)."""
        table, _, leaf = named.rpartition(".")
        gear = table if table in ("pinion", "gear") else ""
        for path, values, own in case.physical(short, 1.0):
            if path.rpartition(".")[2] == leaf and (unit or named != short or path == short):
                return Asked(leaf, *_converted(float(values), own, unit), gear)
        at_gear = case.at_gear(short)
        if at_gear is not None and at_gear[0].rpartition(".")[2] == leaf:
            return Asked(leaf, *_converted(at_gear[1], at_gear[2], unit))
        if unit and leaf != short:  # what says the parameter in other words, as a power does
            return Asked(leaf, unit, SMALL / case.resolve(named, f"{SMALL} {unit}")[1], gear)
        return Asked(short if leaf == short else leaf, "", 1.0, gear)

    def value(self, dimensionless: float) -> float:
        return self.factor * dimensionless

    def text(self, value: float, digits: int = 6) -> str:
        """A value as it stands in the case: ``4200 rpm``, ``omega = 0.55``."""
        return self.with_unit(f"{self.value(value):.{digits}g}")

    def span(self, low: float, high: float, digits: int = 6) -> str:
        """Two values with the name: ``pinion speed from 1000 to 3850 rpm``, ``omega from 0.13 to 0.5``."""
        ends = f"from {self.value(low):.{digits}g} to {self.value(high):.{digits}g}"
        return f"{self.title} {ends} {pretty(self.unit)}".rstrip()

    def reach(self, low: float, high: float, digits: int = 6) -> str:
        """How far was looked: ``from 1000 to 3850 rpm``, ``from omega = 0.13 to 0.5``."""
        before = "" if self.unit else f"{self.title} = "
        ends = f"from {before}{self.value(low):.{digits}g} to {self.value(high):.{digits}g}"
        return f"{ends} {self._unit}" if self.unit else ends

    @property
    def title(self) -> str:
        """The name as it is written for people."""
        name = self.name.replace("_", " ") if self.unit else self.name
        return f"{self.gear} {name}" if self.gear else name

    @property
    def _unit(self) -> str:
        return unit_of(self.name, self.unit)

    @property
    def of_gear(self) -> bool:
        """Whether values are those of the gear in place of the pinion."""
        return is_of_gear(self.name)

    def edge(self, value: float, inwards: int, beside: float) -> str:
        """The end of an interval, rounded into it; only the number."""
        inwards = inwards if self.factor > 0.0 else -inwards
        return shown_edge(self.value(value), inwards, self.value(beside))

    def inner(self, low: float, high: float) -> tuple[str, str]:
        """Both ends of an interval in their order, rounded into it; only the numbers."""
        if self.factor > 0.0:
            return shown_interval(self.value(low), self.value(high), INTERVAL_DIGITS)
        least, most = shown_interval(self.value(high), self.value(low), INTERVAL_DIGITS)
        return most, least

    def distance(self, here: float, edge: float, inwards: int) -> str:
        """Between a value and an end, as both are shown: ``86 rpm``."""
        inwards = inwards if self.factor > 0.0 else -inwards
        shown = shown_distance(self.value(here), self.value(edge), inwards)
        return f"{shown} {pretty(self.unit)}" if self.unit else shown

    def with_unit(self, shown: str) -> str:
        return f"{shown} {self._unit}" if self.unit else f"{self.title} = {shown}"

    def between(self, low: str, high: str) -> str:
        """Two numbers as an interval: ``1000 to 3850 rpm``, ``omega from 0.13 to 0.5``."""
        return f"{low} to {high} {self._unit}" if self.unit else f"{self.title} from {low} to {high}"


def is_quantity(short: str) -> bool:
    """Whether a parameter, by its short name, is a quantity of the case itself (``mesh.backlash``): its
    values are in SI, and a table that has them in the unit asked for has no need of them."""
    return "." in short


def as_typed(value: float) -> float:
    """A converted value as it was typed: without what conversion there and back has rounded."""
    return float(f"{value:.{DIGITS}g}")


def is_of_gear(name: str) -> bool:
    """Whether a name is that of a quantity of the gear which the pinion has, too."""
    return name.rpartition(".")[2] in ("gear_speed", "gear_torque")


def unit_of(name: str, unit: str) -> str:
    """A unit as it is written, with the shaft where that is not the pinion."""
    return f"{pretty(unit)} of the gear" if is_of_gear(name) else pretty(unit)


def _converted(value: float, own: str, asked: str) -> tuple[str, float]:
    """A value in its own unit, in the asked one where that measures the same."""
    try:
        (_, here), (_, there) = read(f"1 {own}"), read(f"1 {asked}")
    except UnitError:
        return own, value
    if not asked or here.dimension != there.dimension:
        return own, value
    factor = float(here.ratio / there.ratio) * 3.141592653589793 ** (here.pi_power - there.pi_power)
    return asked, value * factor
