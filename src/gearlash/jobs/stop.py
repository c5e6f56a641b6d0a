"""Asking work to end early, across threads and processes.

There are two ways, one after the other: a flag that tasks look at between two points (`stopping`), and
KeyboardInterrupt for a point that takes long. A handler of signals raises KeyboardInterrupt only while a task
runs that can be ended anywhere (`interruptible`). A task that has results by then passes them on with the
exception (`handing_on`). Nor may it end a wait for other threads, which would leave their locks taken
(`held_back`).
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any, Protocol


class Cancel(Protocol):
    """What a study asks whether it is to stop; a `threading.Event` is one."""

    def is_set(self) -> bool:
        """Whether it is to stop.

        Returns
        -------
        bool
        """
        ...


class _Never:
    def is_set(self) -> bool:
        return False


class Interrupted(KeyboardInterrupt):
    """Ctrl-C came in the middle of a task; ``part`` is what the task had by then."""

    def __init__(self, part: Any):
        self.part = part
        super().__init__(part)


NEVER: Cancel = _Never()
_flag: Cancel = NEVER
_inside = 0


def watch(flag: Cancel) -> None:
    """Makes this process listen to ``flag``: workers do so when they start, the command line while a study
    runs.
    """
    global _flag
    _flag = flag


def stopping() -> bool:
    """Whether the work in this process was asked to stop. Long tasks look between two points, and return what
    they have.
    """
    return _flag.is_set()


@contextmanager
def interruptible() -> Iterator[None]:
    """Around work of the main thread that KeyboardInterrupt may end anywhere."""
    global _inside
    _inside += 1
    try:
        if stopping():
            raise KeyboardInterrupt
        yield
    finally:
        _inside -= 1


def may_be_interrupted() -> bool:
    """Whether the main thread is at such work."""
    return _inside > 0


@contextmanager
def handing_on(part: Callable[[], Any]) -> Iterator[None]:
    """Around the loop of a task: if Ctrl-C ends it, ``part()`` is not lost."""
    try:
        yield
    except KeyboardInterrupt:
        raise Interrupted(part()) from None


class _Pressed:
    """Whether Ctrl-C came. A second one is Python's own again."""

    def __init__(self) -> None:
        self.once = False

    def is_set(self) -> bool:
        return self.once

    def note(self, number: int, frame: FrameType | None) -> None:
        if self.once:
            signal.default_int_handler(number, frame)
        self.once = True


@contextmanager
def held_back() -> Iterator[Cancel]:
    """Around a wait for other threads, where nobody else answers Ctrl-C: it sets what this yields, and raises
    nothing. A KeyboardInterrupt in the middle of Python's own locks leaves them taken, and the threads that
    need them would wait for ever."""
    main = threading.current_thread() is threading.main_thread()
    if not main or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        yield NEVER
        return
    pressed = _Pressed()
    signal.signal(signal.SIGINT, pressed.note)
    try:
        yield pressed
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
