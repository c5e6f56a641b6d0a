"""Arrays that take long to make, as files in the user's cache folder.

A file is named by a hash of all that its arrays depend on, in a folder named by a hash of what makes them. It
is trusted as compiled kernels are: nothing is read from, or written to, a folder that others may write to. A
file that is damaged, or not written by this module, is as good as none. Folders unused for a month go when a
new one is made.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import time
import zipfile
from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from gearlash._kernel import cache
from gearlash._kernel.trust import VERSION, make_own, read_own

SUFFIX = ".flanks"
Arrays = dict[str, NDArray[np.float64]]


def digest(parts: Iterable[bytes]) -> str:
    """Name for what depends on these bytes, in this order.

    Parameters
    ----------
    parts : iterable of bytes

    Returns
    -------
    str
        64 hexadecimal digits.

    Examples
    --------
    >>> from gearlash.multibody.kept import digest
    >>> digest([b"ab", b"c"]) == digest([b"a", b"bc"])
    False
    """
    whole = hashlib.sha256()
    for part in parts:
        whole.update(len(part).to_bytes(8, "big"))
        whole.update(part)
    return whole.hexdigest()


def read(makers: str, key: str) -> Arrays | None:
    """What was kept.

    Parameters
    ----------
    makers, key : str
        Hashes, as `digest` gives them: of what makes the arrays, and of what they depend on.

    Returns
    -------
    dict of str to ndarray, or None
        None where there is nothing, or nothing that can be trusted.
    """
    folder = cache.cache_folder()
    if cache.trouble(folder):
        return None
    try:
        data = read_own(folder, makers[:16], key + SUFFIX)
        content, seal = data[:-32], data[-32:]
        if hashlib.sha256(content).digest() != seal:
            return None
        with np.load(io.BytesIO(content), allow_pickle=False) as file:
            arrays = {name: np.asarray(file[name], dtype=np.float64) for name in file.files}
    except (OSError, ValueError, zipfile.BadZipFile):
        return None
    with contextlib.suppress(OSError):
        os.utime(folder / makers[:16])
    return arrays


def write(makers: str, key: str, arrays: Mapping[str, NDArray[np.float64]]) -> None:
    """Keeps arrays where that is possible: a full disk, or a folder that cannot be written, stops nothing.

    Parameters
    ----------
    makers, key : str
        As of `read`.
    arrays : mapping of str to ndarray
    """
    folder = cache.cache_folder()
    if cache.trouble(folder):
        return
    buffer = io.BytesIO()
    np.savez(buffer, **dict(arrays))  # pyright: ignore[reportArgumentType] (names are never its options)
    content = buffer.getvalue()
    with contextlib.suppress(OSError):
        own = folder / makers[:16]
        if not own.is_dir():
            make_own(own)
            _prune(own)
        _replace(own / (key + SUFFIX), content + hashlib.sha256(content).digest())


def _replace(file: Path, content: bytes) -> None:
    """Readers find the whole file or none."""
    unfinished = file.with_name(f"{cache.UNFINISHED}{os.urandom(8).hex()}{SUFFIX}")
    try:
        unfinished.touch(mode=0o600, exist_ok=False)
        unfinished.write_bytes(content)
        unfinished.replace(file)
    finally:
        unfinished.unlink(missing_ok=True)


def _prune(folder: Path) -> None:
    """Removes what other versions of the makers have left and nobody has used for long."""
    oldest = time.time() - 86400.0 * cache.UNUSED_DAYS
    for other in folder.parent.iterdir():
        if other == folder or not VERSION.fullmatch(other.name) or other.stat().st_mtime >= oldest:
            continue
        for file in other.glob(f"*{SUFFIX}"):
            file.unlink(missing_ok=True)
        with contextlib.suppress(OSError):  # it holds something else, too
            other.rmdir()
