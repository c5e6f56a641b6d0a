"""Whether a folder is this user's alone. Machine code is loaded from nowhere else: whoever can write the file
runs what he likes.

What is asked is what was opened, not its name: a name can come to mean something else between question and
use."""

from __future__ import annotations

import os
import re
import stat
from contextlib import ExitStack
from pathlib import Path

LARGEST_FILE = 100_000_000  # bytes; kernels have some 100,000
VERSION = re.compile(r"[0-9a-f]{16}")
"""Names of folders in the cache."""
OTHERS_WRITE = stat.S_IWGRP | stat.S_IWOTH
_FOLDER = getattr(os, "O_DIRECTORY", 0)
_FILE = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
KNOWS_OWNERS = hasattr(os, "geteuid") and os.open in os.supports_dir_fd
"""Not Windows, where the profile of a user is his alone by other means."""


class NotOwnError(OSError):
    """A folder or file that somebody else may have written."""


def why_not_own(status: os.stat_result) -> str:
    """Why somebody else may have written what has this status; empty where nobody can."""
    if not KNOWS_OWNERS:
        return ""
    if status.st_uid != os.geteuid():
        return f"it belongs to another user (number {status.st_uid})"
    if status.st_mode & OTHERS_WRITE:
        return f"others may write to it (mode {stat.S_IMODE(status.st_mode):04o})"
    return ""


def why_not_folder(folder: Path) -> str:
    """The same for the name of a folder, and the link that it may be; empty for one that is not there."""
    if not folder.is_absolute():
        return "it is no absolute path"
    if not KNOWS_OWNERS:
        return ""
    try:
        link, status = folder.lstat(), folder.stat()
    except FileNotFoundError:
        return ""
    if link.st_uid not in (os.geteuid(), 0):
        return f"the link belongs to another user (number {link.st_uid})"
    return why_not_own(status)


def make_own(folder: Path) -> None:
    """The folder, for this user alone. One that was made wider before, and has nothing but versions of
    kernels in it, is closed; whether it could be trusted so far `why_not_folder` says."""
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    wider = KNOWS_OWNERS and stat.S_IMODE(folder.stat().st_mode) & 0o077
    if wider and not why_not_folder(folder) and all(VERSION.fullmatch(name) for name in os.listdir(folder)):  # noqa: PTH208
        folder.chmod(0o700)


def read_own(base: Path, version: str, name: str) -> bytes:
    """A file two folders deep, each of them and the file this user's alone. Raises `NotOwnError`, or another
    `OSError`."""
    if why_not_folder(base):
        raise NotOwnError(f"{base} is not trusted")
    if not KNOWS_OWNERS:
        return (base / version / name).read_bytes()
    with ExitStack() as opened:
        inside = None
        for part, flags in ((base, _FOLDER), (version, _FOLDER | _FILE), (name, _FILE)):
            inside = os.open(part, os.O_RDONLY | flags, dir_fd=inside)
            opened.callback(os.close, inside)
            status = os.fstat(inside)
            if why_not_own(status):
                raise NotOwnError(f"{part} is not trusted")
        if not stat.S_ISREG(status.st_mode) or status.st_size > LARGEST_FILE:
            raise NotOwnError(f"{name} is no file of the cache")
        with open(inside, "rb", closefd=False) as file:
            return file.read(LARGEST_FILE)
