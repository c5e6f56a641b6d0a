"""Quantities of a gear pair from SI to parameters of its family, and back."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.case.scales import Scales


def to_dimensionless(scales: Scales, path: str, value: float) -> float:
    """The parameter value of a quantity in SI that stands at this path."""
    table, _, leaf = path.partition(".")
    if leaf == "pinion_speed":
        return float(scales.omega_from_pinion_speed(value))
    if leaf == "mesh_frequency":
        return float(scales.omega_from_hz(value))
    if leaf in ("backlash", "backlash_at_work"):
        return float(scales.half_backlash_from_m(value))
    if leaf == "torque":
        return float(scales.load_from_torque(value))
    if _is_length(table, leaf):
        return float(scales.displacement_from_m(value))
    return value


def to_physical(scales: Scales, path: str, value: ArrayLike) -> NDArray[np.float64]:
    """The quantity in SI at this path of a parameter's value(s): the inverse of `to_dimensionless`."""
    table, _, leaf = path.partition(".")
    if leaf == "pinion_speed":
        return scales.pinion_speed(value)
    if leaf == "mesh_frequency":
        return scales.mesh_hz(value)
    if leaf in ("backlash", "backlash_at_work"):
        return scales.backlash_m(value)
    if leaf == "torque":
        return scales.torque(value)
    if _is_length(table, leaf):
        return scales.length_m(value)
    return np.asarray(value, float)


def _is_length(table: str, leaf: str) -> bool:
    """Errors and run-out, which count in D_c; their phases do not."""
    return (table == "mesh" and leaf.startswith("error") and "phase" not in leaf) or leaf == "runout"
