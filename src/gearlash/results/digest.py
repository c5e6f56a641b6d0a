"""One number for all that a dataset holds."""

from __future__ import annotations

import hashlib
from typing import TYPE_CHECKING

import numpy as np

from gearlash.system import arguments

if TYPE_CHECKING:
    import xarray as xr


@arguments
def content_hash(dataset: xr.Dataset) -> str:
    """One number for the content of a dataset: the same where all decoded arrays are the same.

    Names, dimensions, kinds and values of all variables and coordinates count. Attributes, compression and
    the order in a file do not; every NaN is the same NaN.

    Parameters
    ----------
    dataset : xarray.Dataset
        As from `sweep_dataset` or `load_dataset`.

    Returns
    -------
    str
        SHA-256, in hexadecimal digits.

    Raises
    ------
    GearlashError
        For what is no dataset.

    Examples
    --------
    >>> import gearlash as gl
    >>> case, axis = gl.load_case("kahraman-singh"), gl.Axis.even("omega", 0.7, 0.8, 2)
    >>> one, two = (gl.sweep_dataset(case, [gl.sweep(case, axis)]) for _ in range(2))
    >>> gl.content_hash(one) == gl.content_hash(two)
    True
    """
    digest = hashlib.sha256()
    for name in sorted(map(str, dataset.variables)):
        variable = dataset.variables[name]
        values = np.asarray(variable.values)
        digest.update(f"{name}{variable.dims}{values.shape}".encode())
        digest.update(_bytes(values))
    return digest.hexdigest()


def _bytes(values: np.ndarray) -> bytes:
    if values.dtype.kind == "f":
        numbers = values.astype(np.float64)
        return np.where(np.isnan(numbers), np.nan, numbers).astype("<f8").tobytes()
    if values.dtype.kind in "iub":
        return values.astype("<i8").tobytes()
    return "\0".join(map(str, values.ravel())).encode()
