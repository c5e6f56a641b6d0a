"""An atlas as a labelled dataset: its map, with all points of its curves."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from gearlash.case import Case
from gearlash.system import Family, given

from .atlas import Atlas
from .plane_dataset import plane_dataset

if TYPE_CHECKING:
    import xarray as xr


def atlas_dataset(model: Case | Family, atlas: Atlas) -> xr.Dataset:
    """The map behind an atlas as a dataset, with the points of all curves and those where two things happen.

    Along ``curve_point`` lie the orbits of all curves, one curve after the other, along ``two`` the points at
    which two things happen at once.

    Parameters
    ----------
    model : Case or Family
        Of which the atlas is.
    atlas : Atlas

    Returns
    -------
    xarray.Dataset
        That of `plane_dataset` with further variables.

    Raises
    ------
    GearlashError
        For axes that the model does not have.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> x, y = gl.Axis.even("omega", 0.81, 0.83, 2), gl.Axis.even("D", 0.9, 1.1, 2)
    >>> dataset = gl.atlas_dataset(case, gl.atlas(case, x, y, lines=1))
    >>> sorted(set(dataset["curve_kind"].values.tolist()))
    ['fold', 'grazing']
    """
    given.instance("atlas", atlas, Atlas, "an atlas, as from gearlash.atlas")
    pairs = [(i, each.curve, point) for i, each in enumerate(atlas.curves, 1) for point in each.curve.points]
    values = np.array([point.values for _, _, point in pairs]).reshape(-1, 2)
    special = [each.special for each in atlas.points]
    places = np.array([each.values for each in special]).reshape(-1, 2)
    point, two = "curve_point", "two"
    found: dict[str, Any] = {
        "curve": (point, np.array([i for i, _, _ in pairs], np.int32), {"long_name": "number of the curve"}),
        "curve_kind": (point, _texts(curve.kind for _, curve, _ in pairs), {"long_name": "its kind"}),
        "curve_label": (point, _texts(p.signature for _, _, p in pairs), {"long_name": "P-Q-R of its orbit"}),
        "curve_unstable": (
            point, np.array([p.unstable for _, _, p in pairs], np.int32),
            {"long_name": "multipliers outside the unit circle"},
        ),
        "curve_admissible": (
            point, np.array([p.admissible for _, _, p in pairs], np.int8),
            {"long_name": "whether it is an orbit of the real system"},
        ),
        "two_kind": (two, _texts(each.kind for each in special), {"long_name": "what two things happen"}),
        "two_label": (two, _texts(each.point.signature for each in special), {"long_name": "P-Q-R there"}),
    }  # fmt: skip
    for axis, name in enumerate(atlas.names):
        about = {"long_name": name, "units": "1"}
        found[f"curve_{'xy'[axis]}"] = (point, values[:, axis], about)
        found[f"two_{'xy'[axis]}"] = (two, places[:, axis], about)
    about = {"title": f"atlas over {atlas.names[0]} and {atlas.names[1]}", "complete": int(atlas.complete)}
    return plane_dataset(model, atlas.plane).assign(found).assign_attrs(about, message=atlas.message)


def _texts(values: Iterable[object]) -> np.ndarray:
    return np.array([str(each) for each in values], dtype=object)
