"""Text in NetCDF files as every reader of them takes it.

Texts of any length (NC_STRING) are what h5netcdf writes by itself, but Octave refuses a whole file for one of
them, and MATLAB has read them for a few years only. So variables of text are arrays of characters (NC_CHAR)
with a last dimension, as the classic model has them, and so are attributes; both are UTF-8.
"""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import h5py
    import xarray as xr

TEXT = "OUS"
PACKED_FROM = 1_000


def text_encoding(group: str, dataset: xr.Dataset) -> dict[str, dict[str, object]]:
    """How xarray is to write the variables of text of a group: as characters, packed where they are many.

    Every one has a last dimension of its own, in every group: of coordinates h5netcdf finds no inherited one.
    Of no objects xarray makes numbers.
    """
    found: dict[str, dict[str, object]] = {}
    before = group.strip("/")
    for name, variable in dataset.variables.items():
        if variable.dtype.kind in TEXT and (variable.size or variable.dtype.kind == "U"):
            length = f"{before}_{name}_length" if before else f"{name}_length"
            found[str(name)] = {"dtype": "S1", "char_dim_name": length}
            if variable.size > PACKED_FROM:
                found[str(name)] |= {"zlib": True, "complevel": 4}
    return found


def with_plain_attributes(content: memoryview) -> memoryview:
    """The same file, with attributes of text as characters."""
    import h5py

    held = io.BytesIO(content)
    with h5py.File(held, "r+") as file:
        _make_plain(file)
        file.visititems(lambda _, item: _make_plain(item))
    return held.getbuffer()


def _make_plain(item: h5py.Group | h5py.Dataset) -> None:
    import h5py

    for name in list(item.attrs):
        value = item.attrs[name]
        if isinstance(value, str):
            held = value.encode("utf-8")
            item.attrs.create(name, held, dtype=h5py.string_dtype("utf-8", max(1, len(held))))
