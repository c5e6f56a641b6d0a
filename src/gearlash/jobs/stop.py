"""Asking work to end early, across threads and processes."""

from __future__ import annotations

from typing import Protocol


class Cancel(Protocol):
    """What a study asks whether it is to stop; a `threading.Event` is one."""

    def is_set(self) -> bool: ...


class _Never:
    def is_set(self) -> bool:
        return False


_flag: Cancel = _Never()


def watch(flag: Cancel) -> None:
    """Makes this process listen to ``flag``; workers do so when they start."""
    global _flag
    _flag = flag


def stopping() -> bool:
    """Whether the work in this process was asked to stop. Long tasks look between two points, and return what
    they have.
    """
    return _flag.is_set()
