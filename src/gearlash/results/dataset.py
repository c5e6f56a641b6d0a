"""Sweeps as one labelled dataset."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from gearlash.case import Case
from gearlash.system import Family, GearlashError

from .compare import coexisting
from .physical import physical_axis, physical_unit
from .point import Point
from .provenance import provenance
from .sweep import Sweep
from .variables import PADDED, SCALARS, Variable

if TYPE_CHECKING:
    import xarray as xr

FORMAT_VERSION = 1


def sweep_dataset(model: Case | Family, sweeps: Sequence[Sweep]) -> xr.Dataset:
    """Sweeps over one axis, one per direction, as a dataset.

    Dimensions: ``direction``, the name of the axis, ``state_name``, and for points on sections ``strobe``,
    ``drive_hit``, ``back_hit``, ``back_release`` (padded with NaN). The axis is dimensionless; its physical
    counterparts (rpm, Hz, µm, N·m) are further coordinates where the case has scales. Every variable has
    ``long_name`` and ``units``; dimensionless ones also ``physical_units`` and ``physical_factor`` where
    there are scales. Attributes hold case, versions and what was not given. Raises `GearlashError` for sweeps
    that do not belong together.
    """
    import xarray as xr

    axis = _common_axis(sweeps)
    rows = [sweep.points for sweep in sweeps]
    dims = ("direction", axis.name)
    data: dict[str, Any] = {}
    for variable in SCALARS:
        data[variable.name] = _array(model, variable, dims, _table(rows, variable.read, variable.dtype))
    for variable, dim in PADDED:
        data[variable.name] = _array(model, variable, (*dims, dim), _padded(rows, variable.read))
    about = {"units": "1", "long_name": "did the sweeps find different attractors at this value"}
    data["coexisting"] = ((axis.name,), coexisting(sweeps), about)
    coords = _coordinates(model, sweeps, data["state"][1].shape[-1])
    return xr.Dataset(data, coords, _attributes(model, sweeps))


def _common_axis(sweeps: Sequence[Sweep]):
    if not sweeps:
        raise GearlashError("no sweep to make a dataset of")
    first = sweeps[0]
    for sweep in sweeps[1:]:
        if sweep.axis.name != first.axis.name or not np.array_equal(sweep.axis.values, first.axis.values):
            raise GearlashError("sweeps over different axes do not go into one dataset")
        if dict(sweep.fixed) != dict(first.fixed):
            raise GearlashError("sweeps with different fixed parameters do not go into one dataset")
    if len({sweep.direction for sweep in sweeps}) < len(sweeps):
        raise GearlashError("two sweeps of the same direction do not go into one dataset")
    return first.axis


def _table(rows: list[tuple[Point, ...]], read: Callable[[Point], Any], dtype: str) -> np.ndarray:
    return np.array([[read(point) for point in row] for row in rows], dtype=dtype)


def _padded(rows: list[tuple[Point, ...]], read: Callable[[Point], np.ndarray]) -> np.ndarray:
    """(directions, m, longest): short ones are filled up with NaN."""
    parts = [[read(point) for point in row] for row in rows]
    longest = max(len(part) for row in parts for part in row)
    out = np.full((len(rows), len(rows[0]), longest), np.nan)
    for i, row in enumerate(parts):
        for j, part in enumerate(row):
            out[i, j, : len(part)] = part
    return out


def _array(model: Case | Family, variable: Variable, dims: tuple[str, ...], values: np.ndarray):
    about: dict[str, Any] = {"long_name": variable.long_name, "units": variable.units}
    about |= physical_unit(model, variable)
    return dims, values, about


def _coordinates(model: Case | Family, sweeps: Sequence[Sweep], states: int) -> dict[str, Any]:
    axis = sweeps[0].axis
    family = model if isinstance(model, Family) else model.family()[0]
    description = next((p.description for p in family.parameters if p.name == axis.name), "")
    about = {"long_name": description or axis.name, "units": "1"}
    found: dict[str, Any] = {
        "direction": (
            "direction",
            [str(s.direction) for s in sweeps],
            {"long_name": "where each point starts"},
        ),
        axis.name: (axis.name, axis.values, about),
        "state_name": ("state_name", list(family.states[:states]), {"long_name": "names of the states"}),
    }
    for name, values, unit in physical_axis(model, axis):
        found[name] = (axis.name, values, {"long_name": name.replace("_", " "), "units": unit})
    return found


def _attributes(model: Case | Family, sweeps: Sequence[Sweep]) -> dict[str, Any]:
    family = model if isinstance(model, Family) else model.family()[0]
    fixed = {
        name: value for name, value in family.complete(sweeps[0].fixed).items() if name != sweeps[0].axis.name
    }
    return {
        "gearlash_format": FORMAT_VERSION,
        "title": f"sweep over {sweeps[0].axis.name}",
        "axis": sweeps[0].axis.name,
        "parameters": json.dumps(fixed),
        "fixed": json.dumps(dict(sweeps[0].fixed)),
        "complete": int(all(sweep.complete for sweep in sweeps)),
        "message": "; ".join(dict.fromkeys(s.message for s in sweeps if s.message)),
        **provenance(model),
    }
