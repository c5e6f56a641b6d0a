"""Compiled kernels as files.

Every version of the kernel sources has a folder of its own, named by a hash of *all* of them: numba alone
would look at the file of the function only and keep a caller whose callee has changed. A kernel is one file
in it, named also by what its machine code depends on: processor and its features, Python, numba. So one
folder may serve several machines. Folders unused for a month go when a new one is made.
`GEARLASH_CACHE_DIR` names another place, an absolute one. Nothing is read from, or written to, a folder that
others may write to (`trust`)."""

from __future__ import annotations

import contextlib
import functools
import hashlib
import json
import os
import shutil
import sys
import time
from pathlib import Path

from .trust import VERSION, make_own, read_own, why_not_folder

UNUSED_DAYS = 30.0
"""After so many days without use the folder of another version may go."""

IN_CODE = ("CPU_NAME", "CPU_FEATURES", "OPT", "LOOP_VECTORIZE", "SLP_VECTORIZE", "ENABLE_AVX")
"""Of numba.config, that change its machine code."""


UNFINISHED = "unfinished-"
"""Names of what is being made begin so."""

Files = dict[str, bytes]
"""What numba keeps of one kernel: names and contents of its files."""


def read(kernel: str) -> Files | None:
    """What was kept of the kernel with this name, or None where there is nothing for this machine, or a
    damaged file. (Machine code with one wrong bit would run.)"""
    if _GIVEN_UP:
        return None
    try:
        data = read_own(cache_folder(), version_folder().name, _file_of(kernel).name)
        head, _, rest = _unsealed(data).partition(b"\n")
    except OSError:
        return None
    files, at = {}, 0
    for name, size in json.loads(head).items():
        files[name], at = rest[at : at + size], at + size
    return files


def write(kernel: str, files: Files) -> None:
    """Keeps a kernel, where that is possible: a full disk or a folder that cannot be written is no reason to
    stop."""
    if not files or trouble(cache_folder()):
        return
    sizes = {name: len(content) for name, content in files.items()}
    content = json.dumps(sizes).encode() + b"\n" + b"".join(files.values())
    file = _file_of(kernel)
    with contextlib.suppress(OSError):
        make_version(file.parent)
        _replace(file, content + hashlib.sha256(content).digest())


def make_version(folder: Path) -> None:
    """The folder of these sources; where it is new, what is long unused goes."""
    if not folder.is_dir():
        make_own(folder)
        prune(folder)


def _replace(file: Path, content: bytes) -> None:
    """Readers find the whole file or none."""
    unfinished = file.with_name(f"{UNFINISHED}{os.urandom(8).hex()}.kernel")
    try:
        unfinished.touch(mode=0o600, exist_ok=False)
        unfinished.write_bytes(content)
        unfinished.replace(file)
    except BaseException:
        unfinished.unlink(missing_ok=True)
        raise


def _unsealed(data: bytes) -> bytes:
    """What a file holds before the digest at its end. Raises `OSError` where it is not as it was written."""
    content, digest = data[:-32], data[-32:]
    if hashlib.sha256(content).digest() != digest:
        raise OSError("a damaged file")
    return content


def _file_of(kernel: str) -> Path:
    return version_folder() / f"{kernel}-{machine_hash()[:16]}.kernel"


def version_folder() -> Path:
    """Where the kernels of these sources are."""
    return cache_folder() / sources_hash()[:16]


@functools.cache
def mark_used(folder: Path) -> None:
    """The time of a folder says when its kernels were last asked for."""
    with contextlib.suppress(OSError):
        os.utime(folder)


def prune(folder: Path) -> None:
    """Removes the kernels of other versions beside this folder that nothing has used for `UNUSED_DAYS`."""
    oldest = time.time() - 86400.0 * UNUSED_DAYS
    with contextlib.suppress(OSError):
        for other in folder.parent.iterdir():
            if (
                VERSION.fullmatch(other.name)
                and other != folder
                and other.is_dir()
                and other.stat().st_mtime < oldest
            ):
                _remove(other)


def remove_unfinished(folder: Path) -> None:
    """What processes that were killed have left. For who has made sure that nobody else compiles."""
    with contextlib.suppress(OSError):
        for left in folder.glob(f"{UNFINISHED}*"):
            if left.is_dir() and not left.is_symlink():
                shutil.rmtree(left, ignore_errors=True)
            else:
                left.unlink(missing_ok=True)


def _remove(folder: Path) -> None:
    """The kernels in a folder, and the folder if nothing else is in it."""
    remove_unfinished(folder)
    with contextlib.suppress(OSError):
        for pattern in ("*.kernel", "*.lock"):
            for file in folder.glob(pattern):
                file.unlink(missing_ok=True)
        folder.rmdir()


@functools.cache
def sources_hash() -> str:
    """SHA-256 of every file of the package that holds kernels (their names start with an underscore) and of
    those that compile them, in order."""
    here = Path(__file__).parent
    digest = hashlib.sha256()
    kernels = (path for path in here.parent.rglob("_*.py") if path.name != "__init__.py")
    for path in sorted([*here.glob("*.py"), *kernels]):
        digest.update(path.relative_to(here.parent).as_posix().encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()


@functools.cache
def machine_hash() -> str:
    """SHA-256 of what machine code depends on beside its sources."""
    import llvmlite
    import numba
    import numpy
    from llvmlite import binding

    from .jit import NUMBA_SETTINGS

    parts = (
        binding.get_process_triple(),
        binding.get_host_cpu_name(),
        binding.get_host_cpu_features().flatten(),
        sys.implementation.cache_tag,
        object.__basicsize__,  # another one in a Python without the interpreter's lock
        llvmlite.__version__,
        numba.__version__,
        numpy.__version__,
        *(getattr(NUMBA_SETTINGS, name, None) for name in IN_CODE),
    )
    return hashlib.sha256(repr(parts).encode()).hexdigest()


def cache_folder() -> Path:
    """Where compiled kernels are kept: `GEARLASH_CACHE_DIR`, else the user's cache folder."""
    named = os.environ.get("GEARLASH_CACHE_DIR")
    if named:
        return Path(named)
    base = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA")
    if not base or not Path(base).is_absolute():
        try:
            base = Path.home() / ".cache"
        except RuntimeError:  # a user without a home
            base = os.devnull
    return Path(base) / "gearlash"


_GIVEN_UP: list[str] = []


def give_up(why: str) -> None:
    """From now on this process keeps, and loads, nothing."""
    _GIVEN_UP.append(why)
    trouble.cache_clear()


@functools.cache
def trouble(folder: Path) -> str:
    """What is wrong with a cache folder, so that kernels are compiled in memory; empty where nothing is. One
    that is missing is made."""
    if _GIVEN_UP:
        return _GIVEN_UP[0]
    try:
        why = why_not_folder(folder)
        if not why:
            make_own(folder)
            why = why_not_folder(folder) or why_not_folder(folder / sources_hash()[:16])
        if why:
            return f"is not used, as {why}"
        probe = folder / f".probe-{os.getpid()}"
        probe.touch(mode=0o600)
        probe.unlink()
    except OSError:
        return "cannot be written"
    return ""
