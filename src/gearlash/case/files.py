"""Files that a user named, read: regular ones only, and never more of them than is stated.

A device or a pipe has no end and may never answer; a file may be larger than memory."""

from __future__ import annotations

import os
import stat
from pathlib import Path

_FLAGS = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0) | getattr(os, "O_BINARY", 0)


class UnreadableError(Exception):
    """Why a file is not read, in words."""


def read_file(path: Path, largest: int, *, follow: bool = True) -> bytes:
    """All of a regular file of at most ``largest`` bytes; without ``follow`` it may be no link. Raises
    `UnreadableError`."""
    try:
        _check(os.stat(path, follow_symlinks=follow), largest)  # noqa: PTH116
        handle = os.open(path, _FLAGS | (0 if follow else getattr(os, "O_NOFOLLOW", 0)))
        with os.fdopen(handle, "rb") as stream:
            _check(os.fstat(handle), largest)  # of what was opened: names can be exchanged meanwhile
            data = stream.read(largest + 1) or b""
    except OSError as error:
        raise UnreadableError(error.strerror or str(error)) from None
    except ValueError as error:  # a null character in the name
        raise UnreadableError(str(error)) from None
    if len(data) > largest:  # one without a size, such as those of /proc
        raise UnreadableError(_too_large(largest))
    return data


def check_file(path: Path, largest: int) -> None:
    """Raises `UnreadableError` for what is no regular file of at most ``largest`` bytes."""
    try:
        _check(path.stat(), largest)
    except OSError as error:
        raise UnreadableError(error.strerror or str(error)) from None
    except ValueError as error:  # a null character in the name
        raise UnreadableError(str(error)) from None


def _check(status: os.stat_result, largest: int) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise UnreadableError("it is a directory")
    if not stat.S_ISREG(status.st_mode):
        raise UnreadableError("it is no regular file")
    if status.st_size > largest:
        raise UnreadableError(_too_large(largest))


def _too_large(largest: int) -> str:
    return f"it is larger than {largest / 1e6:g} MB"
