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
    """SHA-256 of the decoded arrays: names, dimensions, kinds and values of all variables and coordinates, in
    the order of their names. Attributes, compression and the order in a file do not count; every NaN is the
    same NaN.
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
