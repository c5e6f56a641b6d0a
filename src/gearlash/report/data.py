"""All numbers of a report as JSON: dataclasses as objects, arrays as lists, what is not a number as null."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Mapping
from math import isfinite
from typing import Any

import numpy as np
import xarray as xr

from gearlash.branches.continuation import Branch, Extremum
from gearlash.case import Case
from gearlash.studies.motion import Motion
from gearlash.studies.plane_zone import PlaneZone
from gearlash.system import GearlashError, Signature

FORMAT = 1
MOST_SAMPLES = 400  # of a curve; the whole of it is in the figures
DIGITS = 10  # of samples of curves; results keep all theirs
MARGIN = ("name", "upward", "distance", "percent", "value", "event", "bounded", "physical")
PADDED = ("strobe", "drive_hit", "back_hit", "back_release")


def as_json(result: Any) -> str:
    """A result as JSON text.

    Parameters
    ----------
    result : dataclass or mapping
        Of dataclasses, mappings, sequences, arrays, datasets, cases, motions, numbers and texts. Complex
        numbers become ``{"re", "im"}``; NaN and infinities become null; curves of motions are thinned to 400
        samples.

    Returns
    -------
    str

    Raises
    ------
    GearlashError
        For anything else.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.report import as_json
    >>> print(as_json({"values": np.array([0.5, np.nan])}))
    {
     "format": 1,
     "values": [
      0.5,
      null
     ]
    }
    <BLANKLINE>
    """
    return (
        json.dumps({"format": FORMAT, **plain_data(result)}, ensure_ascii=False, indent=1, allow_nan=False)
        + "\n"
    )


def plain_data(thing: Any) -> Any:
    """A result in lists, dicts, numbers and texts. Complex numbers become ``{"re", "im"}``, NaN and
    infinities null.
    """
    match thing:
        case None | bool():
            return thing
        case str() | Signature():
            return str(thing)
        case int() | np.integer():
            return int(thing)
        case float() | np.floating():
            return float(thing) if isfinite(thing) else None
        case complex() | np.complexfloating():
            return {"re": plain_data(float(thing.real)), "im": plain_data(float(thing.imag))}
        case np.ndarray():
            return [plain_data(x) for x in thing.tolist()]
        case Case():
            return _case(thing)
        case Motion():
            return _motion(thing)
        case xr.Dataset():
            return _dataset(thing)
        case Branch():
            return _branch(thing)
        case PlaneZone():
            return _plane_zone(thing)
        case Mapping():
            return {str(key): plain_data(value) for key, value in thing.items()}
        case Extremum():
            return plain_data(thing._asdict())
        case list() | tuple() | set() | frozenset():
            return [plain_data(each) for each in thing]
    if dataclasses.is_dataclass(thing) and not isinstance(thing, type):
        return {f.name: plain_data(getattr(thing, f.name)) for f in dataclasses.fields(thing)}
    raise GearlashError(f"{type(thing).__name__} has no form in JSON")


def _case(case: Case) -> dict[str, Any]:
    about = {"name": case.name, "kind": case.kind, "hash": case.hash}
    values = [plain_data(value) for value in case.values()]
    return {**about, "values": values, "notes": [plain_data(note) for note in case.notes()]}


def _motion(motion: Motion) -> dict[str, Any]:
    """Curves thinned evenly; points on sections whole."""
    chosen = np.unique(np.linspace(0, len(motion.phase) - 1, MOST_SAMPLES).round().astype(int))
    curves = ("phase", "displacement", "velocity", "force", "region")
    out: dict[str, Any] = {}
    for field in dataclasses.fields(motion):
        value = getattr(motion, field.name)
        out[field.name] = _short(value[chosen]) if field.name in curves else plain_data(value)
    return out


def _branch(branch: Branch) -> dict[str, Any]:
    """Its special points and ends whole, of all others what draws and what restarts the branch there."""
    names = ("value", "arclength", "label", "period", "unstable", "stable", "state", "error")
    kept = ("name", "values", "lower", "upper", "special", "ends", "unexplained")
    columns = {name: [plain_data(getattr(point, name)) for point in branch.points] for name in names}
    return {**{name: plain_data(getattr(branch, name)) for name in kept}, "points": columns}


def _plane_zone(zone: PlaneZone) -> dict[str, Any]:
    """Without its orbits: values of the parameters tell where its boundary lies."""
    kept = (
        "names",
        "at",
        "lower",
        "upper",
        "quiet",
        "label",
        "outline",
        "holes",
        "lines",
        "complete",
        "notes",
    )
    margins = [{name: plain_data(getattr(margin, name)) for name in MARGIN} for margin in zone.margins]
    parts = [{"kind": str(p.kind), "event": p.event, "values": plain_data(p.values)} for p in zone.parts]
    return {**{name: plain_data(getattr(zone, name)) for name in kept}, "margins": margins, "boundary": parts}


def _short(values: np.ndarray) -> list[Any]:
    return [
        plain_data(float(f"{x:.{DIGITS}g}")) if isinstance(x, float) else plain_data(x)
        for x in values.tolist()
    ]


def _dataset(dataset: xr.Dataset) -> dict[str, Any]:
    """What there is per point of a sweep; the points on sections are in the dataset itself (NetCDF)."""
    names = [
        str(n) for n, v in dataset.data_vars.items() if not set(map(str, v.dims)) & {*PADDED, "state_name"}
    ]
    return {
        "dimensions": {str(name): size for name, size in dataset.sizes.items() if str(name) not in PADDED},
        "coordinates": {str(name): plain_data(c.values) for name, c in dataset.coords.items()},
        "variables": {name: plain_data(dataset[name].values) for name in names},
        "units": {name: str(dataset[name].attrs.get("units", "")) for name in names},
    }
