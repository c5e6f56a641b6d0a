"""The folder that a process happens to be in: no code is imported from there.

`python -c` puts it before the standard library, and so do empty and relative parts of PYTHONPATH: a `json.py`
there would run. This module needs nothing but what Python has loaded before it reads a line of ours."""

from __future__ import annotations

import os
import sys

_PACKAGE = os.path.dirname(os.path.dirname(__file__))  # noqa: PTH120
"""The folder that this package was imported from: it stays, even if it is the current one."""
_left_out: list[bool] = []


def leave_out() -> None:
    """From now on this process imports nothing from the current folder: where Python itself has put it first,
    or PYTHONPATH names it, it goes from `sys.path`."""
    _left_out.append(True)
    named = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    suspects = {*map(os.path.abspath, named), "" if sys.flags.safe_path or not sys.path else sys.path[0]}
    sys.path[:] = [
        entry
        for entry in sys.path
        if _same(entry, _PACKAGE) or not (_is_relative(entry) or (entry in suspects and is_here(entry)))
    ]


class elsewhere:  # noqa: N801 - a context manager; contextlib may not be imported yet
    """Around what would read settings from the current folder (numba): where that folder is left out, and in
    the processes that such a one starts, another folder is the current one meanwhile."""

    def __enter__(self) -> None:
        self.here = -1
        if _left_out or sys.flags.safe_path:
            try:
                self.here = os.open(os.curdir, os.O_RDONLY)
            except OSError:  # a folder that is not there, or, on Windows, any: it stays
                return
            os.chdir(os.sep)

    def __exit__(self, *raised: object) -> None:
        if self.here >= 0:
            os.fchdir(self.here)
            os.close(self.here)


def path_without_it() -> list[str]:
    """`sys.path` for another process that is to import this package and what that needs."""
    return [entry for entry in sys.path if _same(entry, _PACKAGE) or not _is_relative(entry)]


def is_here(entry: str) -> bool:
    """Whether an entry of a search path is the current folder, or depends on it."""
    return _is_relative(entry) or _same(entry, os.curdir)


def _is_relative(entry: str) -> bool:
    return not os.path.isabs(entry)  # noqa: PTH117


def _same(one: str, other: str) -> bool:
    try:
        return os.path.samefile(one or os.curdir, other)  # noqa: PTH121
    except OSError:  # a folder that is not there, the current one too
        return False
