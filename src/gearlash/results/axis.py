"""The parameter that a study goes along."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.case.units import UnitError, behind_number, read
from gearlash.case.units import unit as as_unit
from gearlash.system import GearlashError, Record, given, shown

MOST_VALUES = 100_000_000
ROUNDING = 1e-15  # of the larger end: values between two ends are rounded by as much


@dataclass(frozen=True, eq=False, repr=False)
class Axis(Record):
    """Values of one parameter, ascending, each once.

    Parameters
    ----------
    name : str
        Short name of a parameter (``omega``, ``D``, ``load`` …), or, for a case, any other name of the
        quantity (``pinion_speed``, ``mesh.backlash`` …).
    values : array_like of shape (m,)
        Without ``unit`` dimensionless, else in it. Or texts as in a case file: ``["900 rpm", "950 rpm"]``.
    unit : str, optional
        What a case file would have behind the number: ``rpm``, ``um``, ``N m`` …

    Raises
    ------
    GearlashError
        For anything else. Whether a model has such a parameter is asked when a study begins.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.Axis("omega", [0.5, 0.75, 1.25]).step
    0.5
    >>> speeds = gl.Axis.even("pinion_speed", "1000 rpm", "6000 rpm", 6)
    >>> speeds.values.tolist(), speeds.unit
    ([1000.0, 2000.0, 3000.0, 4000.0, 5000.0, 6000.0], 'rpm')
    """

    name: str
    values: NDArray[np.float64]
    unit: str = ""

    if TYPE_CHECKING:  # a checker of types is told what is taken; what is kept is an array

        def __init__(self, name: str, values: ArrayLike, unit: str = "") -> None: ...

    def __post_init__(self) -> None:
        name = given.word("name of an axis", self.name)
        values, unit = _plain(name, self.values, given.a_text(f"axis {name}: unit", self.unit).strip())
        values = given.row(f"axis {name}: values", values)
        if not len(values):
            raise GearlashError(f"axis {name}: expected at least one value")
        if not (np.diff(values) > 0.0).all():
            raise GearlashError(f"axis {self.name}: values must ascend, each once")
        object.__setattr__(self, "name", name)
        object.__setattr__(self, "values", given.kept(values))
        object.__setattr__(self, "unit", unit)

    @classmethod
    def even(cls, name: str, lower: float | str, upper: float | str, count: int) -> Axis:
        """``count`` values at equal distances, both ends included.

        Parameters
        ----------
        name : str
            As of `Axis`.
        lower, upper : float or str
            Numbers, or texts as a case file has them: ``"1000 rpm"``. A unit behind one holds for both.
        count : int
            From 2 to 100,000,000; or 1, where both ends are one value.

        Returns
        -------
        Axis
            With the unit of the ends.

        Raises
        ------
        GearlashError
            For ends and counts that do not fit.
        """
        said = f"axis {shown(name)}"
        (low, one), (high, two) = (_end(said, end) for end in (lower, upper))
        if one and two and not _same(one, two):
            raise GearlashError(f"{said}: ends {shown(lower)} and {shown(upper)}: expected one unit for both")
        low, high = sorted((low, high))
        count = given.whole(f"{said}: count", count, 1, MOST_VALUES)
        if (count == 1) != (low == high):
            raise GearlashError(f"{said}: expected two different ends and at least two values between them")
        return cls(name, evenly(low, high, count), two or one)

    @property
    def step(self) -> float:
        """The widest distance between neighbours: what is narrower may lie between two values, unseen."""
        return float(np.diff(self.values).max()) if len(self) > 1 else 0.0

    def __len__(self) -> int:
        return len(self.values)


def evenly(low: float, high: float, count: int) -> NDArray[np.float64]:
    """``count`` values at equal distances from ``low`` to ``high``; what is zero within rounding is zero."""
    values = np.linspace(low, high, count)
    return np.where(np.abs(values) <= ROUNDING * max(abs(low), abs(high)), 0.0, values)


def _plain(name: str, values: object, unit: str) -> tuple[object, str]:
    """Values that are texts as numbers, and the unit that all of them have; other values as they are."""
    if (
        not isinstance(values, list | tuple)
        or not all(isinstance(each, str) for each in values)
        or not values
    ):
        return values, unit
    said = f"axis {shown(name)}"
    read_ones = [_number_of(said, "value", each) for each in values]
    units = [*filter(None, [unit, *(behind for _, behind in read_ones)])]
    if any(not _same(units[0], other) for other in units):
        told = " and ".join(dict.fromkeys(units))
        raise GearlashError(f"{said}: values in {told}: expected one unit for all")
    return [number for number, _ in read_ones], units[0] if units else ""


def _same(one: str, two: str) -> bool:
    """Whether two texts are one unit: ``N·m`` is ``Nm``."""
    try:
        return one == two or as_unit(one) == as_unit(two)
    except UnitError:
        return False


def _number_of(said: str, what: str, text: str) -> tuple[float, str]:
    try:
        return float(read(text)[0]), behind_number(text)
    except UnitError as error:
        raise GearlashError(
            f"{said}: {what} {shown(text)}: expected a number with its unit ({error})"
        ) from None


def _end(said: str, end: float | str) -> tuple[float, str]:
    """Number and unit of one end."""
    if not isinstance(end, str):
        expected = f"{said}: end (of Axis.even(name, lower, upper, count))"
        return given.number(expected, end), ""
    return _number_of(said, "end", end)
