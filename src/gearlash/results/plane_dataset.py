"""A map as a labelled dataset."""

from __future__ import annotations

import json
from collections.abc import Callable
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from gearlash.case import Case
from gearlash.system import Family, GearlashError, given

from .axis import Axis
from .dataset import FORMAT_VERSION, family_of
from .physical import physical_axis, physical_unit
from .plane import CERTIFICATES, NO_LABEL, STATUSES, PlaneMap
from .provenance import held_along, provenance
from .variables import Variable, dimension

if TYPE_CHECKING:
    import xarray as xr

CODES = "flag_values"  # with flag_meanings: the names of codes, as the CF conventions (sect. 3.5) have them
VARIABLES = {
    "label": Variable("label", f"index into label_name, {NO_LABEL} without a motion", attrgetter("label")),
    "period": Variable(
        "period", "least period P, 0 where none was proved", attrgetter("period"), units="cycles"
    ),
    "drive": Variable(
        "drive", "impacts Q on the drive side per period (first clearance)", attrgetter("drive")
    ),
    "back": Variable("back", "impacts R on the back side per period (first clearance)", attrgetter("back")),
    "other_impacts": Variable(
        "other_impacts", "impacts in all further clearances per period", attrgetter("others")
    ),
    "largest_exponent": Variable(
        "largest_exponent", "largest Lyapunov exponent", attrgetter("exponent"), quantity="rate"
    ),
    "periods_used": Variable(
        "periods_used", "base periods marched", attrgetter("periods"), units="base periods"
    ),
    "status": Variable("status", "outcome of the computation", attrgetter("status")),
    "certificate": Variable("certificate", "verdict of the certificate", attrgetter("certificate")),
}


def plane_dataset(model: Case | Family, plane: PlaneMap) -> xr.Dataset:
    """A map as a dataset over its two axes, with units and provenance.

    ``label``, ``status`` and ``certificate`` are codes: of ``label_name``, and of the attributes
    ``flag_values`` and ``flag_meanings``. The axes are dimensionless; their physical counterparts (rpm, Hz,
    µm, N·m) are further coordinates where the case has scales. Attributes hold case, versions, what was not
    given, and the reasons of failed pixels.

    Parameters
    ----------
    model : Case or Family
        Of which the map is.
    plane : PlaneMap
        As from `map_plane`.

    Returns
    -------
    xarray.Dataset
        Rows are those of ``plane.y``, columns those of ``plane.x``.

    Raises
    ------
    GearlashError
        For axes that the model does not have.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> speeds, loads = gl.Axis.even("omega", 0.7, 0.9, 3), gl.Axis.even("load", 0.1, 0.3, 2)
    >>> dataset = gl.plane_dataset(case, gl.map_plane(case, speeds, loads))
    >>> dict(dataset.sizes)
    {'load': 2, 'omega': 3, 'label_name': 2}
    """
    import xarray as xr

    given.instance("plane", plane, PlaneMap, "a map, as from gearlash.map_plane")
    family = family_of(model)
    for axis in (plane.x, plane.y):
        if axis.name not in family.defaults:
            raise GearlashError(f"the map goes over {axis.name}, which the model does not have")
    data = {name: _array(model, variable, plane) for name, variable in VARIABLES.items()}
    data["status"][2].update(_flags(STATUSES))
    data["certificate"][2].update(_flags(CERTIFICATES))
    about = {"long_name": "P-Q-R (and /Q-R of every further clearance), or aperiodic, neutral or unresolved"}
    coords: dict[str, Any] = {"label_name": ("label_name", list(map(str, plane.labels)) or [""], about)}
    for axis in (plane.x, plane.y):
        coords |= _coordinates(model, family, axis)
    return xr.Dataset(data, coords, _attributes(model, family, plane))


def _array(model: Case | Family, variable: Variable, plane: PlaneMap) -> tuple[Any, Any, dict[str, Any]]:
    about = {"long_name": variable.long_name, "units": variable.units} | physical_unit(model, variable)
    read: Callable[[Any], Any] = variable.read  # of the map, where others read points
    return (dimension(plane.y.name), dimension(plane.x.name)), read(plane), about


def _flags(names: tuple[str, ...]) -> dict[str, Any]:
    return {CODES: list(range(len(names))), "flag_meanings": " ".join(name or "none" for name in names)}


def _coordinates(model: Case | Family, family: Family, axis: Axis) -> dict[str, Any]:
    description = next((p.description for p in family.parameters if p.name == axis.name), "")
    about = {"long_name": description or axis.name, "units": "1"}
    dim = dimension(axis.name)
    found: dict[str, Any] = {dim: (dim, axis.values, about)}
    for name, values, unit in physical_axis(model, axis):
        found[name] = (dim, values, {"long_name": name.replace("_", " "), "units": unit})
    return found


def _attributes(model: Case | Family, family: Family, plane: PlaneMap) -> dict[str, Any]:
    axes = (plane.x.name, plane.y.name)
    parameters = {name: value for name, value in family.complete(plane.fixed).items() if name not in axes}
    return {
        "gearlash_format": FORMAT_VERSION,
        "title": f"map over {plane.x.name} and {plane.y.name}",
        "x": dimension(plane.x.name),
        "y": dimension(plane.y.name),
        "parameters": json.dumps(parameters),
        "fixed": json.dumps(dict(plane.fixed)),
        "complete": int(plane.complete),
        "message": plane.message,
        "reasons": json.dumps([[*place, text] for place, text in plane.reasons.items()], ensure_ascii=False),
        **provenance(model),
        **held_along(model, axes),
    }
