"""Datasets on disk: NetCDF through h5netcdf. A file is there whole or not at all."""

from __future__ import annotations

import contextlib
import errno
import os
import threading
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

import numpy as np

from gearlash.case.files import UnreadableError, check_file
from gearlash.system import GearlashError, given
from gearlash.system.short_text import cut

from .groups import join, split
from .text_types import text_encoding, with_plain_attributes

if TYPE_CHECKING:
    import xarray as xr

FORMAT = "gearlash_format"
LARGEST_FILE = 4_000_000_000
"""Bytes of a file that is read; a map of a million pixels has less than a tenth of it."""
DAMAGED = (
    OSError, ValueError, KeyError, IndexError, TypeError, AttributeError, RuntimeError, OverflowError,
    MemoryError,
)  # fmt: skip
"""What readers of NetCDF raise on files that are none, or whose parts contradict each other."""
IMPOSSIBLE = (errno.ENAMETOOLONG, errno.ENOTDIR, errno.EEXIST, errno.EINVAL)
"""What says that a path cannot be one, whatever disk it is on."""


def save(dataset: xr.Dataset, path: str | Path) -> Path:
    """Writes a dataset to a NetCDF file, which is there whole or not at all.

    It is written beside its place, then moved there in one step. Folders are made; an older file is replaced.
    The root group of the file has what is one number a point, every further dimension a group of its name.

    Parameters
    ----------
    dataset : xarray.Dataset
        As from `sweep_dataset` or `plane_dataset`.
    path : str or Path
        Of the file; `~` is home.

    Returns
    -------
    Path
        Where it lies.

    Raises
    ------
    OSError
        Where the file cannot be written.
    GearlashError
        For what is no dataset, and no path of a file.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> found = gl.sweep_dataset(case, [gl.sweep(case, gl.Axis.even("omega", 0.7, 0.8, 2))])
    >>> with TemporaryDirectory() as folder:
    ...     path = gl.save_dataset(found, f"{folder}/sweep.nc")
    ...     path.name, gl.load_dataset(path).identical(found)
    ('sweep.nc', True)
    """
    content = netcdf(dataset)
    path = new_file(path)
    write_whole(path, content)
    return path


def netcdf(dataset: xr.Dataset) -> memoryview:
    """The content of the file of a dataset."""
    import xarray as xr

    given.instance("dataset", dataset, xr.Dataset, "a dataset, as from gearlash.sweep_dataset")
    # Made in memory: a disk that fills up while HDF5 writes to it can bring the whole process down.
    groups = split(dataset)
    encoding = {name: _encoding(group) | text_encoding(name, group) for name, group in groups.items()}
    content = xr.DataTree.from_dict(groups).to_netcdf(
        None, engine="h5netcdf", encoding=encoding, write_inherited_coords=True
    )
    assert isinstance(content, memoryview)
    return with_plain_attributes(content)


def new_file(path: object) -> Path:
    """A path at which a file can be made, its folder made. Raises `GearlashError` for one that names none."""
    found = given.path("path", path)
    _make_folder(found)
    return found


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


def unfinished(name: str) -> str:
    """The pattern of names beside the place of a file of which not all is written."""
    return f".{name}.{'?' * 12}.part"


def write_whole(path: Path, content: bytes | memoryview) -> None:
    """A file with this content; where that cannot be written (`OSError`), none, and an older one is kept."""
    write_together({path: content})


def write_together(contents: Mapping[Path, bytes | memoryview], instead_of: Iterable[Path] = ()) -> None:
    """Files that belong together: all are written beside their places, then moved there one right after the
    other, and those that they stand ``instead_of`` go. Where one cannot be written (`OSError`), nothing
    changes; a command that ends at once waits until all are moved (`give_up`)."""
    parts = {path: path.with_name(f".{path.name}.{os.urandom(6).hex()}.part") for path in contents}
    try:
        _unfinished.update(parts.values())
        for path, part in parts.items():
            with _naming(path), _begun(part) as file:
                file.write(contents[path])
                file.flush()
                os.fsync(file.fileno())
        with _changing:
            for path, part in parts.items():
                with _naming(path):
                    part.replace(path)
            for path in instead_of:
                path.unlink(missing_ok=True)
    finally:
        for part in parts.values():
            part.unlink(missing_ok=True)
        _unfinished.difference_update(parts.values())


_changing = threading.Lock()
"""Held while names in a folder change. Who gives up keeps it, so that no file is begun any more."""
_unfinished: set[Path] = set()
MOVED = 1.0  # s that files may take to be moved, before that is not waited for


def give_up() -> None:
    """For a thread that is about to end the process: files that are being moved are waited for, and those
    that are not whole go."""
    _changing.acquire(timeout=MOVED)
    for part in list(_unfinished):
        with contextlib.suppress(OSError):
            part.unlink(missing_ok=True)


def _begun(part: Path) -> BinaryIO:
    with _changing:
        return part.open("xb")


@contextlib.contextmanager
def _naming(path: Path) -> Iterator[None]:
    """An error of the operating system names the file that was wanted."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from None


def load(path: str | Path) -> xr.Dataset:
    """The dataset of a file that `save_dataset` wrote; it is in memory, and the file is closed.

    Parameters
    ----------
    path : str or Path
        Of the file; `~` is home.

    Returns
    -------
    xarray.Dataset

    Raises
    ------
    GearlashError
        For a file that gearlash did not write, that is no regular one, or larger than 4 GB, packed or
        unpacked.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> found = gl.sweep_dataset(case, [gl.sweep(case, gl.Axis.even("omega", 0.7, 0.8, 2))])
    >>> with TemporaryDirectory() as folder:
    ...     again = gl.load_dataset(gl.save_dataset(found, f"{folder}/sweep.nc"))
    >>> gl.content_hash(again) == gl.content_hash(found)
    True
    """
    import xarray as xr

    path = given.path("path", path)
    name = cut(str(path), 200)
    try:
        check_file(path, LARGEST_FILE)
        groups = xr.open_groups(path, engine="h5netcdf", decode_times=False)
        try:
            if (
                sum(group.nbytes for group in groups.values()) > LARGEST_FILE
            ):  # a small file may unpack to terabytes
                raise GearlashError(f"{name}: holds more than {LARGEST_FILE / 1e9:g} GB of data")
            dataset = join({where: group.load() for where, group in groups.items()})
        finally:
            for group in groups.values():
                group.close()
    except UnreadableError as error:
        raise GearlashError(f"{name}: {error}") from None
    except DAMAGED as error:
        reason = cut(str(error) or type(error).__name__, 300)
        raise GearlashError(f"{name}: not a NetCDF file of gearlash ({reason})") from None
    if FORMAT not in dataset.attrs:
        raise GearlashError(f"{name}: a NetCDF file, but not one of gearlash")
    return dataset


def _encoding(dataset: xr.Dataset) -> dict[str, dict[str, object]]:
    """Padded arrays are mostly NaN: packed without loss they take little room."""
    packed = {"zlib": True, "complevel": 4, "shuffle": True}
    large = (name for name, array in dataset.data_vars.items() if array.dtype.kind == "f" and array.ndim > 2)
    return {str(name): dict(packed) for name in large if np.prod(dataset[name].shape)}
