"""Physical counterparts of dimensionless numbers, where a case has scales."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.system import Family

from .axis import Axis

if TYPE_CHECKING:
    from .variables import Variable


def backlash_words(case: Case) -> str:
    """What D is in lengths: the stated backlash, or, where temperatures or the deviation of the centre
    distance change it, that at work."""
    return "backlash at work" if case.numbers is not None and case.numbers.play_added else "backlash"


def physical_axis(model: Case | Family, axis: Axis) -> list[tuple[str, NDArray[np.float64], str]]:
    """What the values of an axis mean physically: (name, values, unit) for every way to name it."""
    return physical_values(model, axis.name, axis.values)


def physical_values(
    model: Case | Family, name: str, values: NDArray[np.float64]
) -> list[tuple[str, NDArray[np.float64], str]]:
    """The same of values of the parameter with this name."""
    if isinstance(model, Family):
        return []
    found = [(path.rpartition(".")[2], numbers, unit) for path, numbers, unit in model.physical(name, values)]
    return [each for each in found if each[0] != name]


def physical_unit(model: Case | Family, variable: Variable) -> dict[str, Any]:
    """Attributes that turn a dimensionless variable into a physical one: its unit and the factor."""
    if isinstance(model, Family) or not model.scales.physical:
        return {}
    scales = model.scales
    if variable.quantity == "length":
        return {"physical_units": "um", "physical_factor": float(scales.length_um(1.0))}
    if variable.quantity == "force":
        return {"physical_units": "N", "physical_factor": float(scales.force_N(1.0))}
    if variable.quantity == "rate":
        return {"physical_units": "1/s", "physical_factor": float(scales.tau_from_s(1.0))}
    return {}
