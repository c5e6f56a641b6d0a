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
import sys
import time
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from .trust import VERSION, make_own, read_own, why_not_folder

UNUSED_DAYS = 30.0
"""After so many days without use the folder of another version may go."""

SETTINGS = ("CPU_NAME", "CPU_FEATURES", "OPT", "LOOP_VECTORIZE", "SLP_VECTORIZE", "ENABLE_AVX")
"""Of numba, NUMBA_…, that change its machine code."""


@dataclass(frozen=True)
class Code:
    """The machine code of one kernel: an object file, the name of the entry in it, and the names that it
    needs from elsewhere."""

    object_file: bytes
    entry: str
    needs: tuple[str, ...]


def read(kernel: str) -> Code | None:
    """The code of the kernel with this name, or None where there is none for this machine, or a damaged one.
    (Machine code with one wrong bit would run.)"""
    try:
        data = read_own(cache_folder(), version_folder().name, _file_of(kernel).name)
        head, _, object_file = _unsealed(data).partition(b"\n")
    except OSError:
        return None
    entry, *needs = json.loads(head)
    return Code(object_file, entry, tuple(needs))


def write(kernel: str, code: Code) -> None:
    """Keeps a kernel, where that is possible: a full disk or a folder that cannot be written is no reason to
    stop."""
    if trouble(cache_folder()):
        return
    content = json.dumps([code.entry, *code.needs]).encode() + b"\n" + code.object_file
    file = _file_of(kernel)
    with contextlib.suppress(OSError):
        if not file.parent.is_dir():
            make_own(file.parent)
            prune(file.parent)
        _replace(file, content + hashlib.sha256(content).digest())


def _replace(file: Path, content: bytes) -> None:
    """Readers find the whole file or none."""
    unfinished = file.with_name(f"unfinished-{os.urandom(8).hex()}.kernel")
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


def _remove(folder: Path) -> None:
    """The kernels in a folder, and the folder if nothing else is in it."""
    with contextlib.suppress(OSError):
        for file in folder.glob("*.kernel"):
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
    from llvmlite import binding

    parts = (
        binding.get_process_triple(),
        binding.get_host_cpu_name(),
        binding.get_host_cpu_features().flatten(),
        sys.implementation.cache_tag,
        object.__basicsize__,  # another one in a Python without the interpreter's lock
        llvmlite.__version__,
        _numba_version(),
        *(os.environ.get(f"NUMBA_{name}") for name in SETTINGS),
    )
    return hashlib.sha256(repr(parts).encode()).hexdigest()


def _numba_version() -> str:
    """From its own file where that can be found: a tenth of the time of asking for the package's metadata."""
    numba = find_spec("numba")
    if numba is not None and numba.origin is not None:
        with contextlib.suppress(OSError):
            return Path(numba.origin).with_name("_version.py").read_text(encoding="utf-8")
    from importlib.metadata import version

    return version("numba")


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


@functools.cache
def trouble(folder: Path) -> str:
    """What is wrong with a cache folder, so that kernels are compiled in memory; empty where nothing is. One
    that is missing is made."""
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
