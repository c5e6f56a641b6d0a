"""A folder for one process at a time, so that two commands with one --out do not mix their files.

The system gives the lock back when the process ends, however it does: none is ever left behind."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path
from typing import Any
from weakref import WeakValueDictionary

try:
    import fcntl
except ImportError:  # Windows
    fcntl: Any = None

LOCK = ".gearlash.lock"
"""The file that is locked where a folder cannot be: on Windows, and on some network file systems."""


class HeldError(OSError):
    """Another process has the folder."""


class Hold:
    """A lock that is kept as long as this object."""

    def __init__(self, handle: int):
        self.handle = handle

    def __del__(self) -> None:
        with suppress(OSError):
            os.close(self.handle)


_HELD: WeakValueDictionary[tuple[int, int], Hold] = WeakValueDictionary()


def hold(folder: Path) -> Hold:
    """The lock of a folder; within one process it may be asked for several times. Raises `HeldError`."""
    status = folder.stat()
    key = status.st_dev, status.st_ino
    found = _HELD.get(key)
    if found is None:
        found = _HELD[key] = Hold(_locked_folder(folder) if fcntl else _locked_file(folder))
    return found


def _locked_folder(folder: Path) -> int:
    handle = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        os.close(handle)
        raise HeldError(*error.args) from None
    except OSError:
        os.close(handle)
        return _locked_file(folder)
    return handle


def _locked_file(folder: Path) -> int:
    handle = os.open(folder / LOCK, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
    try:
        if fcntl:
            fcntl.lockf(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        else:
            import msvcrt

            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)  # pyright: ignore[reportAttributeAccessIssue]
    except OSError as error:
        os.close(handle)
        raise HeldError(*error.args) from None
    return handle
