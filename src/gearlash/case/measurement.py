"""A measurement over speed: speeds and values in their units, as dimensionless numbers of a case."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from math import isfinite
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import GearlashError, Record, given

from .case import Case
from .column_units import ACCELERATIONS, NO_UNIT, acceleration_in
from .columns import Columns, read_columns
from .errors import CaseError, Problem
from .files import UnreadableError
from .units import FORCE, LENGTH, Dimension, UnitError, in_si, number_and_unit, plain_unit, read, takes
from .words import nearest_name

_LEVEL = re.compile(r"dB\W*(?:re\.?|ref\.?|rel\.?|bez\.?)?\W*(?P<reference>\d.*)$", re.IGNORECASE)
Array = NDArray[np.float64]
EXAMPLES = {"force": "N", "length": "um", "acceleration": "m/s^2"}
QUANTITIES = {"force": "mesh_force", "length": "transmission_error", "acceleration": "acceleration_yp"}
"""One of each kind."""
OF_TEETH = ("transmission_error", "mesh_force", "gap")
OF_BEARINGS = tuple(
    f"{what}_{at}" for what in ("bearing_force", "acceleration") for at in ("yp", "zp", "yg", "zg")
)


@dataclass(frozen=True, eq=False, repr=False)
class Measurement(Record):
    """Measured values of one quantity over speed, as `load_measurement` and `measurement` make it.

    Parameters
    ----------
    quantity : str
        What was measured: ``transmission_error``, ``gap``, ``mesh_force``, ``bearing_force_yp`` … or
        ``acceleration_yp`` ….
    omega, values : ndarray of shape (m,)
        Dimensionless, in the order of the rows: speeds that rise from row to row say that the speed rose.
    speed_unit, unit : str
        Of the physical numbers; levels in dB are told in the unit of their reference.
    speed_factor, factor : float
        Physical over dimensionless numbers, in these units.
    columns : tuple of (str, str)
        Names of the columns of speeds and values in a file.
    left_out : int
        Rows of a file without speed or value.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("article")
    >>> found = gl.measurement(case, [3600, 3700], [12.5, 14.0], "gap", speed_unit="rpm", unit="um")
    >>> found.omega * found.speed_factor
    array([3600., 3700.])
    """

    quantity: str
    omega: NDArray[np.float64]
    values: NDArray[np.float64]
    speed_unit: str = ""
    unit: str = ""
    speed_factor: float = 1.0
    factor: float = 1.0
    columns: tuple[str, str] = ("", "")
    left_out: int = 0


def measurement(
    case: Case,
    speeds: ArrayLike,
    values: ArrayLike,
    quantity: str,
    *,
    speed_unit: str = "",
    unit: str = "",
    reference: str = "",
) -> Measurement:
    """A measurement over speed as numbers of a case.

    Parameters
    ----------
    case : Case
        A gear pair.
    speeds, values : array_like of shape (m,)
        A speed may be measured several times. Speeds that rise from row to row mean that the speed rose.
    quantity : str
        What was measured: ``transmission_error``, ``gap``, ``mesh_force``, ``bearing_force_yp`` … or
        ``acceleration_yp`` … (p: pinion, g: gear).
    speed_unit : str
        rpm, or Hz of the mesh frequency; empty for ω.
    unit : str
        Of the values, ``dB`` for levels; empty for dimensionless ones.
    reference : str
        What levels refer to: ``"1 um"``, ``"1e-6 m/s^2"``; amplitudes, 20 dB a factor of 10.

    Returns
    -------
    Measurement

    Raises
    ------
    CaseError
        For units that do not fit.
    UnknownNameError
        For a quantity that this pair does not have.
    GearlashError
        For arrays that do not go together.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> gl.measurement(case, [0.7, 0.8], [0.3, 0.5], "mesh_force").values.tolist()
    [0.3, 0.5]
    """
    given.instance("case", case, Case, "a case, as from gearlash.load_case")
    speed_unit, unit = given.a_text("speed_unit", speed_unit), given.a_text("unit", unit)
    quantity = _known(case, quantity)
    omega, rows = given.row("speeds", speeds), given.row("values", values)
    if len(omega) != len(rows):
        raise GearlashError(f"{len(omega)} speeds and {len(rows)} values: expected as many of both")
    return _measurement(case, omega, rows, quantity, speed_unit, unit, reference, "unit")


def _measurement(
    case: Case,
    speeds: Array,
    rows: Array,
    quantity: str,
    speed_unit: str,
    unit: str,
    reference: str,
    where: str,
) -> Measurement:
    """Numbers in units that stand ``where`` as those of a case."""
    kind = kind_of(quantity)
    if not np.all(speeds > 0.0):
        expected = "speeds above zero (without a sign that says the sense of rotation)"
        raise CaseError("speeds", [Problem("speeds", f"{float(speeds.min()):g}", expected)])
    speed_factor = _speed_factor(case, speed_unit)
    number, told = _reference(case, reference, unit, kind) if is_level(unit) else (1.0, unit)
    amplitudes = number * 10.0 ** (rows / 20.0) if is_level(unit) else rows
    factor = _value_factor(case, kind, told, where)
    return Measurement(quantity, speeds / speed_factor, amplitudes / factor, speed_unit, told, speed_factor,
                       factor)  # fmt: skip


def load_measurement(
    case: Case,
    path: str | Path,
    quantity: str,
    *,
    speed: str = "",
    value: str = "",
    speed_unit: str = "",
    unit: str = "",
    reference: str = "",
) -> Measurement:
    """A measurement over speed from a text file of columns, as instruments and spreadsheets write them.

    Columns are parted by semicolons, tabs, commas or blanks, decimals by points or commas; units stand in
    brackets behind the names of columns or in a line below. Rows without speed or value are left out.

    Parameters
    ----------
    case : Case
        A gear pair.
    path : str or Path
        Of the file; `~` is home.
    quantity : str
        As of `measurement`.
    speed, value : str
        Name or number of a column. Without: the first one with a unit of speed, else the first; the next one
        with a unit that fits, else the next.
    speed_unit, unit, reference : str
        Where the file does not say them, as of `measurement`.

    Returns
    -------
    Measurement

    Raises
    ------
    CaseError
        For a file that cannot be read, columns that are not there, and units that do not fit.
    UnknownNameError
        For a quantity that this pair does not have.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import gearlash as gl
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder) / "te.csv"
    ...     _ = file.write_text("n [rpm];DTE [um]\\n3600;12,5\\n3700;14,0\\n")
    ...     found = gl.load_measurement(gl.load_case("article"), file, "gap")
    >>> found.columns, found.unit, len(found.omega)
    (('n', 'DTE'), 'um', 2)
    """
    given.instance("case", case, Case, "a case, as from gearlash.load_case")
    name, kind = str(path), kind_of(_known(case, quantity))
    try:
        found = read_columns(given.path("data", path))
        if len(found.names) < 2:
            raise UnreadableError("it has one column only")
        at = _column(found, speed, "--speed", _speed_place(case, found))
        other = _column(found, value, "--value", _value_place(case, found, kind, at))
        table = found.without_footer(at, other)
        rows = list(zip(table.column(at), table.column(other), strict=True))
    except (UnreadableError, GearlashError) as error:
        if isinstance(error, CaseError):
            raise
        expected = f"a text file of columns, speed and value at least ({error})"
        raise CaseError(name, [Problem("data", repr(name), expected)]) from None
    kept = [row for row in rows if all(map(isfinite, row))]
    if not kept:
        raise CaseError(name, [Problem("data", repr(name), "a row with both a speed and a value")])
    units = speed_unit or found.units[at], unit or found.units[other]
    _required(case, *units, kind)
    names = found.names[at], found.names[other]
    omega, values = np.array(kept).T
    where = "--unit" if unit else f"column {names[1]}"
    told = _measurement(case, omega, values, quantity, *units, reference, where)
    return replace(told, columns=names, left_out=len(found.cells) - len(kept))


def _known(case: Case, quantity: str) -> str:
    """A quantity that can be measured on this pair."""
    has_bearings = case.between_teeth and case.numbers.pair is not None
    return given.known("quantity", quantity, OF_TEETH + OF_BEARINGS * has_bearings)


def kind_of(quantity: str) -> str:
    """What the unit of a quantity is: ``force``, ``length`` or ``acceleration``."""
    if quantity.startswith("acceleration"):
        return "acceleration"
    return "force" if "force" in quantity else "length"


def is_level(unit: str) -> bool:
    """Whether it says dB, with or without a reference behind it."""
    return unit.strip().lower().startswith("db")


def _speed_place(case: Case, found: Columns) -> int:
    """The first column with a unit of speed; without units the first."""
    fits = (i for i, unit in enumerate(found.units) if unit and _reads(_speed_factor, case, unit))
    return next(fits, 0)


def _value_place(case: Case, found: Columns, kind: str, speed: int) -> int:
    """The first other column with a unit that fits; without units the next one."""
    others = [i for i in range(len(found.names)) if i != speed]
    units = {i: found.units[i] for i in others if found.units[i]}
    fits = (i for i, unit in units.items() if _fits(case, kind, unit))
    return next(fits, next((i for i in others if i > speed), others[0]))


def _fits(case: Case, kind: str, unit: str) -> bool:
    """Whether a quantity may have a unit, or a level that says nothing else."""
    behind = _LEVEL.match(unit)
    if behind:
        unit = number_and_unit(behind["reference"])[1]
    return (is_level(unit) and not behind) or _reads(_value_factor, case, kind, unit, "")


def _reads(function: Callable[..., float], *arguments: object) -> bool:
    try:
        function(*arguments)
    except CaseError:
        return False
    return True


def _column(found: Columns, name: str, option: str, default: int) -> int:
    if not name:
        return default
    if name in found.names:
        return found.names.index(name)
    if name.isdigit() and 1 <= int(name) <= len(found.names):
        return int(name) - 1
    expected = f"the name or number of a column: {', '.join(found.names)}"
    raise CaseError(option, [Problem(option, repr(name), expected, nearest_name(name, found.names))])


def _required(case: Case, speed_unit: str, unit: str, kind: str) -> None:
    """Raises `CaseError` where a file leaves open what its numbers are."""
    if not case.scales.physical:
        return
    if not speed_unit:
        expected = "the unit of the speeds, such as rpm, as the file does not say it (1: ω itself)"
        raise CaseError("--speed-unit", [Problem("--speed-unit", None, expected, missing=True)])
    if not unit:
        expected = f"the unit of the values, such as {EXAMPLES[kind]}, as the file does not say it"
        raise CaseError("--unit", [Problem("--unit", None, expected, missing=True)])


def _speed_factor(case: Case, unit: str) -> float:
    """Speeds in this unit over ω."""
    if unit in NO_UNIT:
        return 1.0
    try:
        name = "mesh_frequency" if "hz" in unit.lower() else "pinion_speed"
        return 1.0 / case.resolve(name, f"1 {unit}")[1]
    except GearlashError as error:
        raise CaseError(
            "--speed-unit", [Problem("--speed-unit", repr(unit), f"a unit of speed ({error})")]
        ) from None


def _reference(case: Case, text: str, unit: str, kind: str) -> tuple[float, str]:
    """Number and unit that levels in dB refer to, of the option or behind the dB. Raises `CaseError` where a
    case in units leaves open which one the number is in."""
    behind = _LEVEL.match(unit)
    told = text.strip() or (behind["reference"].strip() if behind else "")
    expected = f'what the levels refer to, such as "1 {EXAMPLES[kind]}"'
    size, unit_of_it = number_and_unit(told)
    if not size > 0.0:
        raise CaseError("--reference", [Problem("--reference", repr(told) if told else None, expected)])
    if case.scales.physical and unit_of_it.strip() in NO_UNIT:
        expected = f'a number with its unit, such as "{told} {EXAMPLES[kind]}"'
        raise CaseError("--reference", [Problem("--reference", repr(told), expected)])
    return size, unit_of_it


def _value_factor(case: Case, quantity: str, unit: str, where: str) -> float:
    """Values in this unit over dimensionless ones."""
    scales = case.scales
    if unit.strip() in NO_UNIT:
        return 1.0
    if not scales.physical:
        raise CaseError(where, [Problem(where, repr(unit), "no unit: this case has numbers only")])
    if quantity == "acceleration":
        one = acceleration_in(unit)
        if one is None:
            expected = f"a unit of acceleration: {', '.join(ACCELERATIONS)}{_that_of_another(unit)}"
            raise CaseError(where, [Problem(where, repr(unit), expected)])
        size = float(scales.length_m(1.0)) * float(scales.omega_n or 1.0) ** 2
        return size / one
    dimension, one = (FORCE, scales.force_N(1.0)) if quantity == "force" else (LENGTH, scales.length_m(1.0))
    return float(one) / _si(unit, dimension, quantity, where)


def _si(unit: str, dimension: Dimension, quantity: str, where: str) -> float:
    """SI value of one of these units."""
    expected = f"a unit of it, such as {EXAMPLES[quantity]}"
    try:
        number, found = read(f"1 {plain_unit(unit)}")
    except UnitError as error:
        told = _that_of_another(unit) or f" ({error})"
        raise CaseError(where, [Problem(where, repr(unit), expected + told)]) from None
    if not takes(dimension, found):
        raise CaseError(where, [Problem(where, repr(unit), expected + _that_of_another(unit))])
    return float(in_si(dimension, number, found))


def _that_of_another(unit: str) -> str:
    """Which quantity has this unit; nothing where none has."""
    kinds = {"force": FORCE, "length": LENGTH}
    try:
        found = read(f"1 {plain_unit(unit)}")[1]
        kind = next((kind for kind, dimension in kinds.items() if takes(dimension, found)), "")
    except UnitError:
        kind = ""
    kind = kind or ("acceleration" if acceleration_in(unit) else "")
    return f"; {unit.strip()} is a unit of {kind}: --quantity {QUANTITIES[kind]} has it" if kind else ""
