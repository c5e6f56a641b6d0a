"""A dataset as a table, one row a point."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gearlash.system import GearlashError, given
from gearlash.system.short_text import cut

from .groups import POINTWISE, split
from .plane_dataset import CODES

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


def table(dataset: xr.Dataset) -> pd.DataFrame:
    """A dataset as a table, with one row for every point of a sweep or pixel of a map.

    What is several numbers a point (states, points on sections) is not in it.

    Parameters
    ----------
    dataset : xarray.Dataset
        As from `sweep_dataset`, `plane_dataset` or `load_dataset`.

    Returns
    -------
    pandas.DataFrame
        Indexed by the values of the axes; codes are written out as what they mean.

    Raises
    ------
    GearlashError
        For another dataset.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> found = gl.sweep(case, gl.Axis.even("omega", 0.7, 0.9, 3))
    >>> gl.table(gl.sweep_dataset(case, [found]))["label"].tolist()
    ['1-0-0', '1-0-0', '1-1-0']
    """
    import xarray as xr

    given.instance("dataset", dataset, xr.Dataset, "a dataset, as from gearlash.sweep_dataset")
    if POINTWISE not in dataset:
        raise GearlashError("a table is made of a dataset of sweeps or of a map: this one has no labels")
    frame = split(dataset)["/"].to_dataframe()
    try:
        for name, meaning in _codes(dataset).items():
            frame[name] = [meaning.get(int(code), "") for code in frame[name]]
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        reason = cut(repr(error), 200)
        raise GearlashError(
            f"a dataset with codes that say nothing: not one of gearlash ({reason})"
        ) from None
    return frame


def _codes(dataset: xr.Dataset) -> dict[str, dict[int, str]]:
    """Variables that hold codes, and what the codes mean."""
    found: dict[str, dict[int, str]] = {}
    for name, variable in dataset.data_vars.items():
        about: dict[str, Any] = variable.attrs
        if CODES in about:
            values = [int(code) for code in about[CODES]]
            found[str(name)] = dict(zip(values, about["flag_meanings"].split(), strict=True))
    if "label_name" in dataset:
        found[POINTWISE] = dict(enumerate(map(str, dataset["label_name"].values)))
    return found
