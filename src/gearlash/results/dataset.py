"""Sweeps as one labelled dataset."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.system import Family, GearlashError, Status, given

from .compare import coexisting
from .physical import physical_axis, physical_unit
from .point import Point
from .provenance import held_along, provenance
from .sweep import Sweep
from .variables import PADDED, SCALARS, Variable, dimension

if TYPE_CHECKING:
    import xarray as xr

FORMAT_VERSION = 2
STATE_NAME = "state_name"


def sweep_dataset(model: Case | Family, sweeps: Sequence[Sweep]) -> xr.Dataset:
    """Sweeps of one axis as a dataset, with units and provenance.

    Dimensions: ``direction``, the name of the axis, ``state_name``, and for points on sections ``strobe``,
    ``drive_hit``, ``back_hit``, ``back_release`` (padded with NaN). The axis is dimensionless; its physical
    counterparts (rpm, Hz, µm, N·m) are further coordinates where the case has scales. Every variable has
    ``long_name`` and ``units``; dimensionless ones also ``physical_units`` and ``physical_factor`` where
    there are scales. Attributes hold case, versions and what was not given.

    Parameters
    ----------
    model : Case or Family
        Of which the sweeps are.
    sweeps : sequence of Sweep
        As from `sweeps`: of one axis and with the same fixed parameters, each direction once.

    Returns
    -------
    xarray.Dataset

    Raises
    ------
    GearlashError
        For sweeps that do not go together, and an axis that the model does not have.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> dataset = gl.sweep_dataset(case, gl.sweeps(case, gl.Axis.even("omega", 0.7, 0.9, 3), ["up", "down"]))
    >>> dataset["label"].sel(direction="up").values.tolist()
    ['1-0-0', '1-0-0', '1-1-0']
    """
    import xarray as xr

    family = family_of(model)
    sweeps = given.instances("sweeps", sweeps, Sweep, "sweeps, as from gearlash.sweeps")
    axis = _common_axis(sweeps)
    given.known("parameter", axis.name, family.defaults)
    _check_states(model, sweeps)
    rows = [_Row.of(sweep.points) for sweep in sweeps]
    dims = ("direction", dimension(axis.name))
    data: dict[str, Any] = {}
    for variable in SCALARS:
        data[variable.name] = _array(model, variable, dims, _table(rows, variable.read, variable.dtype))
    for variable, dim in PADDED:
        least = len(family.states) if dim == STATE_NAME else 1  # a dimension of none empties tables
        data[variable.name] = _array(model, variable, (*dims, dim), _padded(rows, variable.read, least))
    about = {"units": "1", "long_name": "did the sweeps find different attractors at this value"}
    data["coexisting"] = ((dims[1],), coexisting(sweeps), about)
    coords = _coordinates(model, sweeps)
    return xr.Dataset(data, coords, _attributes(model, sweeps))


def _check_states(model: Case | Family, sweeps: Sequence[Sweep]) -> None:
    """Raises `GearlashError` for motions that have another number of states than those of the model."""
    own = len(family_of(model).states)
    for sweep in sweeps:
        for point in sweep.points:
            if len(point.state) not in (0, own):
                raise GearlashError(
                    f"sweeps: their motions have {len(point.state)} states, those of the model {own}; "
                    "give the case or family that they were computed of"
                )


def family_of(model: Case | Family) -> Family:
    """The family of a model."""
    given.instance("model", model, (Case, Family), "a case, as from gearlash.load_case, or a Family")
    return model if isinstance(model, Family) else model.family()[0]


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


@dataclass(frozen=True, eq=False)
class _Row:
    """The points of a sweep, those that were not computed for one reason only once, as nothing but that is
    known of them: there may be a hundred thousand, and whoever stopped a study waits for its file. ``places``
    (m,): which of them is at each value."""

    points: list[Point]
    places: NDArray[np.int64]

    @staticmethod
    def of(points: Sequence[Point]) -> _Row:
        found, blanks, places = [], {}, []
        for point in points:
            place = len(found)
            if point.status is Status.NOT_COMPUTED:
                place = blanks.setdefault(point.message, place)
            if place == len(found):
                found.append(point)
            places.append(place)
        return _Row(found, np.array(places, dtype=np.int64))


def _table(rows: list[_Row], read: Callable[[Point], Any], dtype: str) -> np.ndarray:
    parts = [np.array([read(point) for point in row.points], dtype=dtype)[row.places] for row in rows]
    return np.array(parts)


def _padded(rows: list[_Row], read: Callable[[Point], np.ndarray], least: int) -> np.ndarray:
    """(directions, m, longest, at least so many): short ones are filled up with NaN."""
    parts = [[read(point) for point in row.points] for row in rows]
    longest = max(least, *(len(part) for some in parts for part in some))
    out = []
    for some, row in zip(parts, rows, strict=True):
        wide = np.full((len(some), longest), np.nan)
        for j, part in enumerate(some):
            wide[j, : len(part)] = part
        out.append(wide[row.places])
    return np.array(out)


def _array(model: Case | Family, variable: Variable, dims: tuple[str, ...], values: np.ndarray):
    about: dict[str, Any] = {"long_name": variable.long_name, "units": variable.units}
    about |= physical_unit(model, variable)
    return dims, values, about


def _coordinates(model: Case | Family, sweeps: Sequence[Sweep]) -> dict[str, Any]:
    axis, dim = sweeps[0].axis, dimension(sweeps[0].axis.name)
    family = family_of(model)
    description = next((p.description for p in family.parameters if p.name == axis.name), "")
    about = {"long_name": description or axis.name, "units": "1"}
    found: dict[str, Any] = {
        "direction": (
            "direction",
            [str(s.direction) for s in sweeps],
            {"long_name": "where each point starts"},
        ),
        dim: (dim, axis.values, about),
        STATE_NAME: (STATE_NAME, list(family.states), {"long_name": "names of the states"}),
    }
    for name, values, unit in physical_axis(model, axis):
        found[name] = (dim, values, {"long_name": name.replace("_", " "), "units": unit})
    return found


def _attributes(model: Case | Family, sweeps: Sequence[Sweep]) -> dict[str, Any]:
    family = family_of(model)
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
        **held_along(model, [sweeps[0].axis.name]),
    }
