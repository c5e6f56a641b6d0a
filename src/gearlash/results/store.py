"""Datasets on disk: NetCDF through h5netcdf. A file is there whole or not at all."""

from __future__ import annotations

import errno
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from gearlash.system import GearlashError, given
from gearlash.system.told import cut

from .groups import join, split

if TYPE_CHECKING:
    import xarray as xr

FORMAT = "gearlash_format"
UNFINISHED: set[str] = set()
"""Files that are being written beside their places, for a command that ends at once."""
IMPOSSIBLE = (errno.ENAMETOOLONG, errno.ENOTDIR, errno.EEXIST, errno.EINVAL)
"""What says that a path cannot be one, whatever disk it is on."""


def save(dataset: xr.Dataset, path: str | Path) -> Path:
    """Writes a dataset beside its place, then moves it there in one step. Folders are made; an older file is
    replaced; `~` is home. The root group of the file has what is one number a point, every further dimension
    a group of its name. Raises `OSError` where that cannot be written.
    """
    import xarray as xr

    given.instance("dataset", dataset, xr.Dataset, "a dataset, as from gearlash.sweep_dataset")
    path = given.path("path", path)
    _make_folder(path)
    # Made in memory: a disk that fills up while HDF5 writes to it can bring the whole process down.
    groups = split(dataset)
    encoding = {name: _encoding(group) for name, group in groups.items()}
    content = xr.DataTree.from_dict(groups).to_netcdf(
        None, engine="h5netcdf", encoding=encoding, write_inherited_coords=True
    )
    assert isinstance(content, memoryview)
    write_whole(path, content)
    return path


def _make_folder(path: Path) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        folder = path.is_dir()
    except OSError as error:
        if error.errno not in IMPOSSIBLE:
            raise
        raise GearlashError(f"{cut(str(path), 200)}: no path of a file ({error.strerror})") from None
    if folder:
        raise GearlashError(f"{path}: a folder, expected the path of a file")


def write_whole(path: Path, content: bytes | memoryview) -> None:
    """A file with this content; where that cannot be written (`OSError`), none, and an older one is kept."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".part")
    part = Path(name)
    UNFINISHED.add(name)
    try:
        with open(handle, "wb") as file:  # noqa: PTH123
            file.write(content)
            file.flush()
            os.fsync(handle)
        part.chmod(0o666 & ~_umask())
        part.replace(path)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from None
    finally:
        part.unlink(missing_ok=True)
        UNFINISHED.discard(name)


def load(path: str | Path) -> xr.Dataset:
    """The dataset of a file, in memory and closed. Raises `GearlashError` for a file that `save` did not
    write.
    """
    import xarray as xr

    path = given.path("path", path)
    try:
        if not path.is_file():
            raise GearlashError(f"{cut(str(path), 200)}: no such file")
        groups = xr.open_groups(path, engine="h5netcdf")
        dataset = join({name: group.load() for name, group in groups.items()})
        for group in groups.values():
            group.close()
    except (OSError, ValueError) as error:
        raise GearlashError(f"{cut(str(path), 200)}: not a NetCDF file of gearlash ({error})") from None
    if FORMAT not in dataset.attrs:
        raise GearlashError(f"{path}: a NetCDF file, but not one of gearlash")
    return dataset


def _encoding(dataset: xr.Dataset) -> dict[str, dict[str, object]]:
    """Padded arrays are mostly NaN: packed without loss they take little room."""
    packed = {"zlib": True, "complevel": 4, "shuffle": True}
    large = (name for name, array in dataset.data_vars.items() if array.dtype.kind == "f" and array.ndim > 2)
    return {str(name): dict(packed) for name in large if np.prod(dataset[name].shape)}


def _umask() -> int:
    """The mask that new files of this process get; it can only be read by setting it."""
    mask = os.umask(0)
    os.umask(mask)
    return mask
