"""Parameters as a caller names them: short names with dimensionless numbers, and for a case every other name
and unit of the quantity, as in its file."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.results import Axis
from gearlash.results.axis import evenly
from gearlash.system import Family, GearlashError, given
from gearlash.system.model import plain_value

from .model import Model


def plain_axis(model: Model, family: Family, axis: Axis) -> Axis:
    """The axis by its short name, in dimensionless values. Raises `GearlashError` for what the model does not
    have."""
    expected = f"an Axis, such as Axis.even({family.parameters[0].name!r}, 0.5, 1.4, 200)"
    given.instance("axis", axis, Axis, expected)
    if not axis.unit and (axis.name in family.defaults or not isinstance(model, Case)):
        given.known("parameter", axis.name, family.defaults)
        return axis
    if not isinstance(model, Case):
        raise GearlashError(f"axis {axis.name} in {axis.unit}: a Family has no units; expected plain numbers")
    plain = [plain_value(model, axis.name, _stated(value, axis.unit)) for value in _asked(axis)]
    short, numbers = plain[0][0], np.array([number for _, number in plain])
    return Axis(short, evenly(numbers[0], numbers[-1], len(axis)) if _is_even(axis) else numbers)


def _asked(axis: Axis) -> NDArray[np.float64]:
    """The values that are converted one by one: both ends where the others lie evenly between them."""
    return axis.values[[0, -1]] if _is_even(axis) else axis.values


def _is_even(axis: Axis) -> bool:
    values = axis.values
    return len(axis) > 1 and np.array_equal(values, evenly(values[0], values[-1], len(axis)))


def _stated(value: float, unit: str) -> float | str:
    """As it would stand in a case file."""
    return f"{float(value)!r} {unit}" if unit else float(value)
