"""Of several first runs at once, one compiles: a lock on a file beside the kernels.

The system gives it up when the process that holds it ends, however that is. Where files cannot be locked,
everybody compiles."""

from __future__ import annotations

import contextlib
import os
import time
from collections.abc import Callable, Iterator

from . import cache

LOCK = "compiling.lock"
POLL = 0.1  # s between two tries: Ctrl-C is answered meanwhile


@contextlib.contextmanager
def one_at_a_time(waits: Callable[[], object]) -> Iterator[None]:
    """Around compiling into the cache; ``waits`` is called once where another process is at it."""
    with contextlib.ExitStack() as stack:
        try:
            cache.make_version(cache.version_folder())
            flags = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0)
            file = os.open(cache.version_folder() / LOCK, flags, 0o600)
        except OSError:  # it cannot be written: read-only, or full
            yield
            return
        stack.callback(os.close, file)
        told = False
        while not _taken(file):
            if not told:
                waits()
                told = True
            time.sleep(POLL)
        cache.remove_unfinished(cache.version_folder())
        yield


def _taken(file: int) -> bool:
    """Tries to lock. True too where this system cannot."""
    try:
        import fcntl
    except ImportError:
        return _taken_on_windows(file)
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # a file system without locks
        return True
    return True


def _taken_on_windows(file: int) -> bool:
    try:
        import msvcrt
    except ImportError:
        return True
    try:
        msvcrt.locking(file, msvcrt.LK_NBLCK, 1)  # pyright: ignore[reportAttributeAccessIssue]
    except OSError:
        return False
    return True
