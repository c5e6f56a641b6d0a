"""Two limits of a parameter, as a caller names them, and refused in the words and the unit of the caller."""

from __future__ import annotations

from dataclasses import dataclass, field

from gearlash.case import Case
from gearlash.case.units import behind_number, pretty
from gearlash.system import Family, GearlashError, plain_values

from .model import Model

SMALL = 1e-3
"""Of a unit: a value that is in range wherever it is converted."""


@dataclass(frozen=True)
class Limits:
    """Of the parameter ``short``, dimensionless; ``told``: its name as it was asked for, the unit that goes
    with it (empty: none), and what dimensionless values are multiplied with."""

    short: str
    lower: float
    upper: float
    told: tuple[str, str, float] = field(default=("", "", 1.0))

    @staticmethod
    def read(model: Model, family: Family, name: str, lower: float | str, upper: float | str) -> Limits:
        """Raises `GearlashError` for what are no limits."""
        found = []
        for side, limit in (("lower", lower), ("upper", upper)):
            try:
                ((short, number),) = plain_values(model, family, {name: limit}).items()
                family.complete({short: number})
            except GearlashError as error:
                raise GearlashError(f"{side} limit of {name}: {error}") from None
            found.append(number)
        limits = Limits(short, *found, told=_told(model, short, name, upper))
        if not limits.lower < limits.upper:
            ends = f"{limits.text(limits.lower)} is not below {limits.text(limits.upper)}"
            raise GearlashError(f"limits of {name}: {ends}")
        return limits

    def text(self, value: float) -> str:
        """A value as it was asked for: ``4200 rpm``."""
        _, unit, factor = self.told
        return f"{value * factor:.10g}" + (f" {pretty(unit)}" if unit else "")

    def check(self, start: float) -> None:
        """Raises `GearlashError` where a start lies outside."""
        if not self.lower <= start <= self.upper:
            raise GearlashError(
                f"{self.told[0] or self.short} = {self.text(start)} of the start lies outside the interval "
                f"from {self.text(self.lower)} to {self.text(self.upper)} in which it is to be followed"
            )


def _told(model: Model, short: str, name: str, limit: float | str) -> tuple[str, str, float]:
    if isinstance(model, Case):
        leaf = model.named(name, limit).rpartition(".")[2]
        for path, factor, unit in model.physical(short, 1.0):
            if path.rpartition(".")[2] == leaf and (isinstance(limit, str) or leaf != short):
                return leaf, unit, float(factor)
        unit = behind_number(limit) if isinstance(limit, str) else ""
        if unit and name not in model.family()[0].defaults:  # in other words, as a power says a torque
            return leaf, unit, SMALL / model.resolve(name, f"{SMALL} {unit}")[1]
    return name, "", 1.0
