"""A curve of special orbits in two parameters as one labelled dataset."""

from __future__ import annotations

import json
from collections.abc import Sequence
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from gearlash.case import Case
from gearlash.system import Family, given

from .dataset import FORMAT_VERSION, family_of
from .physical import physical_values
from .provenance import held_along, provenance
from .variables import Variable, dimension

if TYPE_CHECKING:
    import xarray as xr

    from gearlash.branches.curves import Curve, CurvePoint


def _same(name: str, long_name: str, dtype: str = "f8", units: str = "1") -> Variable:
    return Variable(name, long_name, attrgetter(name), dtype, units)


POINTWISE = (
    _same("arclength", "from the first orbit, in scaled unknowns"),
    Variable("label", "signature P-Q-R; what touches is not counted", lambda p: str(p.signature), "U"),
    _same("period", "least period P", "i4", "cycles"),
    _same("unstable", "multipliers outside the unit circle", "i4"),
    _same("admissible", "whether it is an orbit of the real system", "?"),
    _same("residual", "of all equations of the curve, relative to the sizes of the motion"),
    Variable("status", "outcome of the computation", lambda p: str(p.status), "U"),
)
SPECIAL = (
    Variable("kind", "what two things happen at once", lambda s: str(s.kind), "U"),
    _same("note", "what else there is to tell", "U"),
    Variable("label_before", "label of the orbits before it", lambda s: str(s.label_before), "U"),
    Variable("label_after", "label of the orbits after it", lambda s: str(s.label_after), "U"),
    _same("solved", "whether both conditions were solved for together", "?"),
    _same("arclength", "from the first orbit, in scaled unknowns"),
    Variable("status", "outcome of the computation", lambda s: str(s.status), "U"),
)
TAKEN = frozenset(
    [
        *(v.name for v in POINTWISE), *(f"special_{v.name}" for v in SPECIAL), "point", "special",
        "end", "state",
        "state_name", "multiplier", "multiplier_real", "multiplier_imag", "multiplier_modulus",
        "special_multiplier", "special_state", "end_kind", "end_note",
    ]
)  # fmt: skip
"""Names in this dataset that no parameter can have there."""


def curve_dataset(model: Case | Family, curve: Curve) -> xr.Dataset:
    """A curve as a dataset, with units and provenance.

    Dimensions: ``point`` (the orbits in their order along the curve; both parameters are coordinates on it),
    ``state_name``, ``multiplier``, ``special`` and ``end``.

    Parameters
    ----------
    model : Case or Family
        That of the curve.
    curve : Curve

    Returns
    -------
    xarray.Dataset

    Raises
    ------
    GearlashError
        For a curve in parameters that the model does not have.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> fold = branch.of_kind("fold")[-1]
    >>> curve = gl.continue_curve(case, ("omega", "D"), fold, lower=(0.6, 0.13), upper=(0.8, 1.1))
    >>> dataset = gl.curve_dataset(case, curve)
    >>> dataset["special_kind"].values.tolist(), dataset.attrs["kind"]
    (['grazing with a multiplier 1'], 'fold')
    """
    import xarray as xr

    from gearlash.branches.curves import Curve

    family = family_of(model)
    given.instance("curve", curve, Curve, "a Curve, as from gearlash.continue_curve")
    for name in curve.names:
        given.known("parameter", name, family.defaults)
    data = _table(POINTWISE, curve.points, "point") | _orbits(curve.points, "point")
    data |= _table(SPECIAL, curve.special, "special", "special_")
    data |= _orbits([special.point for special in curve.special], "special", "special_")
    data |= _values(model, curve) | _ends(curve)
    return xr.Dataset(data, _coordinates(model, family, curve), _attributes(model, curve))


def _table(variables: Sequence[Variable], rows: Sequence[Any], along: str, of: str = "") -> dict[str, Any]:
    return {
        f"{of}{each.name}": (
            (along,),
            np.array([each.read(row) for row in rows], each.dtype),
            {"long_name": each.long_name, "units": each.units},
        )
        for each in variables
    }


def _orbits(points: Sequence[CurvePoint], along: str, of: str = "") -> dict[str, Any]:
    """States and multipliers."""
    width = max((len(point.multipliers) for point in points), default=1)
    table = np.full((len(points), width), np.nan, dtype=np.complex128)
    states = np.array([point.state for point in points], dtype=np.float64)
    for row, point in zip(table, points, strict=True):
        row[:] = point.multipliers
    found: dict[str, Any] = {}
    for part, read in (("real", np.real), ("imag", np.imag), ("modulus", np.abs)):
        about = {"long_name": f"Floquet multipliers, {part}, by modulus, descending", "units": "1"}
        found[f"{of}multiplier_{part}"] = ((along, f"{of}multiplier"), read(table), about)
    if len(points):
        about = {"long_name": "state at phase zero", "units": "1"}
        found[f"{of}state"] = ((along, "state_name"), states, about)
    return found


def _values(model: Case | Family, curve: Curve) -> dict[str, Any]:
    """Both parameters at special points and ends, and estimates of their errors."""
    found: dict[str, Any] = {}
    for i, name in enumerate(curve.names):
        values = np.array([special.values[i] for special in curve.special], dtype=np.float64)
        errors = np.array([special.errors[i] for special in curve.special], dtype=np.float64)
        about = {"units": "1"}
        own = dimension(f"special_{name}", TAKEN)
        found[own] = (("special",), values, {**about, "long_name": f"{name} there"})
        found[f"{own}_error"] = (("special",), errors, {**about, "long_name": f"error of {name}"})
        for other, numbers, unit in physical_values(model, name, values):
            about = {"long_name": f"{other.replace('_', ' ')} there", "units": unit}
            found[dimension(f"special_{other}", TAKEN)] = (("special",), numbers, about)
        ends = np.array([end.values[i] for end in curve.ends], dtype=np.float64)
        found[dimension(f"end_{name}", TAKEN)] = (
            ("end",),
            ends,
            {"long_name": f"{name} there", "units": "1"},
        )
    return found


def _ends(curve: Curve) -> dict[str, Any]:
    about = {"long_name": "why the curve was not followed farther", "units": "1"}
    kinds, notes = [str(end.kind) for end in curve.ends], [end.note for end in curve.ends]
    return {
        "end_kind": (("end",), kinds, about),
        "end_note": (("end",), notes, {"long_name": "evidence in words", "units": "1"}),
    }


def _coordinates(model: Case | Family, family: Family, curve: Curve) -> dict[str, Any]:
    words = {each.name: each.description for each in family.parameters}
    names = list(family.states)
    found: dict[str, Any] = {"state_name": ("state_name", names, {"long_name": "names of the states"})}
    for i, name in enumerate(curve.names):
        values = curve.parameters[:, i]
        about = {"long_name": words.get(name) or name, "units": "1"}
        found[dimension(name, TAKEN)] = (("point",), values, about)
        for other, numbers, unit in physical_values(model, name, values):
            found[other] = (("point",), numbers, {"long_name": other.replace("_", " "), "units": unit})
    return found


def _attributes(model: Case | Family, curve: Curve) -> dict[str, Any]:
    fixed = {name: value for name, value in curve.values.items() if name not in curve.names}
    x, y = curve.names
    return {
        "gearlash_format": FORMAT_VERSION,
        "title": f"curve over {x} and {y}",
        "kind": str(curve.kind),
        "x": x,
        "y": y,
        "lower": list(curve.lower),
        "upper": list(curve.upper),
        "parameters": json.dumps(fixed),
        "complete": int(all(str(end.kind) != "cancelled" for end in curve.ends)),
        **provenance(model),
        **held_along(model, curve.names),
    }
