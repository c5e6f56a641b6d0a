"""A measurement in a file: speeds and values in their units, as dimensionless numbers of a case."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case, CaseError, Problem
from gearlash.case.columns import Columns, read_columns
from gearlash.case.files import UnreadableError
from gearlash.case.units import FORCE, LENGTH, Dimension, UnitError, in_si, plain_unit, read, takes
from gearlash.case.words import nearest_name
from gearlash.system import GearlashError, given

STANDARD_GRAVITY = 9.80665
ACCELERATIONS = {"m/s^2": 1.0, "m/s²": 1.0, "m/s2": 1.0, "mm/s^2": 1e-3, "mm/s²": 1e-3, "g": STANDARD_GRAVITY}
EXAMPLES = {"force": "N", "length": "um", "acceleration": "m/s^2"}


@dataclass(frozen=True)
class Measurement:
    """What a file holds, as dimensionless numbers, and the units that it is told in.

    Parameters
    ----------
    omega, values : ndarray of shape (m,)
    speed, speed_unit, value, value_unit : str
        Names of the columns and units.
    speed_factor, value_factor : float
        Physical over dimensionless numbers, in these units.
    """

    omega: NDArray[np.float64]
    values: NDArray[np.float64]
    speed: str
    speed_unit: str
    value: str
    value_unit: str
    speed_factor: float
    value_factor: float


@dataclass(frozen=True)
class Asked:
    """Options that say what the columns are; empty where the file says it."""

    speed: str = ""
    value: str = ""
    speed_unit: str = ""
    unit: str = ""
    reference: str = ""


def read_measurement(case: Case, name: str, quantity: str, asked: Asked) -> Measurement:
    """The measurement in a file. Raises `CaseError` naming what is to be typed instead."""
    try:
        found = read_columns(given.path("data", name))
    except (UnreadableError, GearlashError) as error:
        raise CaseError(name, [Problem("data", repr(name), f"a text file of columns ({error})")]) from None
    if len(found.names) < 2:
        raise CaseError(name, [Problem("data", repr(name), "two columns at least: speed and value")])
    at = _column(found, asked.speed, "--speed", 0)
    other = _column(found, asked.value, "--value", 1 if at == 0 else 0)
    speed_unit = asked.speed_unit or found.units[at]
    unit = asked.unit or found.units[other]
    rows = np.array(found.rows)
    speed_factor = _speed_factor(case, speed_unit)
    level = unit.strip().lower().startswith("db")
    shown = _reference(asked.reference, quantity) if level else (1.0, unit)
    values = 10.0 ** (rows[:, other] / 20.0) * shown[0] if level else rows[:, other]
    where = "--unit" if asked.unit else f"column {found.names[other]}"
    factor = _value_factor(case, quantity, shown[1], where)
    return Measurement(
        rows[:, at] / speed_factor, values / factor, found.names[at], speed_unit, found.names[other],
        shown[1], speed_factor, factor,
    )  # fmt: skip


def _column(found: Columns, name: str, option: str, default: int) -> int:
    if not name:
        return default
    if name in found.names:
        return found.names.index(name)
    if name.isdigit() and 1 <= int(name) <= len(found.names):
        return int(name) - 1
    expected = f"the name or number of a column: {', '.join(found.names)}"
    raise CaseError(option, [Problem(option, repr(name), expected, nearest_name(name, found.names))])


def _speed_factor(case: Case, unit: str) -> float:
    """Speeds in this unit over ω."""
    if not unit:
        if not case.scales.physical:
            return 1.0
        expected = "the unit of the speeds, such as rpm, as the file does not say it in brackets"
        raise CaseError("--speed-unit", [Problem("--speed-unit", None, expected, missing=True)])
    try:
        name = "mesh_frequency" if "hz" in unit.lower() else "pinion_speed"
        return 1.0 / case.resolve(name, f"1 {unit}")[1]
    except GearlashError as error:
        raise CaseError(
            "--speed-unit", [Problem("--speed-unit", repr(unit), f"a unit of speed ({error})")]
        ) from None


def _reference(text: str, quantity: str) -> tuple[float, str]:
    """Number and unit that levels in dB refer to."""
    expected = f'what the levels refer to, such as "1 {EXAMPLES[quantity]}"'
    number, _, unit = text.strip().partition(" ")
    try:
        size = float(number)
    except ValueError:
        raise CaseError(
            "--reference", [Problem("--reference", repr(text) if text else None, expected)]
        ) from None
    return size, unit.strip()


def _value_factor(case: Case, quantity: str, unit: str, where: str) -> float:
    """Values in this unit over dimensionless ones."""
    scales = case.scales
    if not unit.strip():
        if not scales.physical:
            return 1.0
        expected = f"the unit of the values, such as {EXAMPLES[quantity]}, as the file does not say it"
        raise CaseError("--unit", [Problem("--unit", None, expected, missing=True)])
    if not scales.physical:
        raise CaseError(where, [Problem(where, repr(unit), "no unit: this case has numbers only")])
    if quantity == "acceleration":
        plain = unit.strip()
        if plain not in ACCELERATIONS:
            expected = f"a unit of acceleration: {', '.join(ACCELERATIONS)}"
            raise CaseError(where, [Problem(where, repr(unit), expected)])
        size = float(scales.length_m(1.0)) * float(scales.omega_n or 1.0) ** 2
        return size / ACCELERATIONS[plain]
    dimension, one = (FORCE, scales.force_N(1.0)) if quantity == "force" else (LENGTH, scales.length_m(1.0))
    return float(one) / _si(unit, dimension, quantity, where)


def _si(unit: str, dimension: Dimension, quantity: str, where: str) -> float:
    """SI value of one of these units."""
    expected = f"a unit of it, such as {EXAMPLES[quantity]}"
    try:
        number, found = read(f"1 {plain_unit(unit)}")
    except UnitError as error:
        raise CaseError(where, [Problem(where, repr(unit), f"{expected} ({error})")]) from None
    if not takes(dimension, found):
        raise CaseError(where, [Problem(where, repr(unit), expected)])
    return float(in_si(dimension, number, found))
