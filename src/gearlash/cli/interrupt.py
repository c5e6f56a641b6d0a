"""Signals that end a command: Ctrl-C, SIGTERM, and SIGHUP of a terminal that closes.

The first one ends the work, and what was computed is kept; one more ends the command at once. What the first
one does depends on what the command is at:

- before it has anything to keep, and in what it can do without (`optional`), the work ends where it is;
- while a study runs (`expect_results`) a flag is set, which `gearlash.jobs` looks at between two points, and
  a point that takes long is broken off;
- while results are written (`keeping`) nothing is broken off.

A signal that Python cannot answer, as it is inside a long call of machine code, is answered by a thread: it
says that results will be kept as soon as the call returns, or ends the process where there are none, or where
a second signal comes.
"""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum
from types import FrameType
from typing import TypeVar

T = TypeVar("T")

NAMES = ("SIGINT", "SIGTERM", "SIGHUP")
KEPT = b"\nstopping, and keeping what was computed (once more gives it up)\n"
LOST = b"\ninterrupted\n"
CURSOR = b"\x1b[?25h"  # shows the cursor again that a bar has hidden
ECHO = 0.25  # s in which a second signal is the first one, sent to the process and to its group
LATEST = 1.5  # s after which a signal that machine code holds up is answered without it
SOON = 0.2  # the same of a second one


class _Phase(Enum):
    NOTHING = "nothing to keep"
    STUDY = "results will be kept"
    OPTIONAL = "can be done without"
    KEEPING = "being kept"


class _State:
    """Of this process."""

    def __init__(self) -> None:
        self.number = 0  # of the first signal; 0: none came
        self.at = 0.0
        self.phase = _Phase.NOTHING
        self.flag = threading.Event()


_state = _State()


def end_early() -> None:
    """From now on a signal ends this process at once, without a traceback: while modules are imported."""
    for number in _answered():
        signal.signal(number, lambda number, _frame: _end(number))


@contextmanager
def signals_answered() -> Iterator[None]:
    """Around a command. Signals that are ignored stay so (`nohup`), and so do those of who has a use of his
    own for them."""
    _state.__init__()
    numbers = _answered() if threading.current_thread() is threading.main_thread() else []
    before = {number: signal.signal(number, _answer) for number in numbers}
    try:
        with _watched(numbers) if numbers else contextlib.nullcontext():
            yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        if "gearlash.jobs.stop" in sys.modules:
            from gearlash.jobs.stop import NEVER, watch

            watch(NEVER)


def signalled() -> int:
    """The number of the signal that came; 0 if none did."""
    return _state.number


def expect_results() -> None:
    """From here on there is something to keep."""
    from gearlash.jobs.stop import watch

    watch(_state.flag)
    _state.phase = _Phase.STUDY


def end_if_nothing(computed: bool) -> None:
    """Ends the command where a signal came before anything was computed: no older result is written over."""
    if _state.number and not computed:
        raise KeyboardInterrupt


def nothing_more() -> None:
    """From here on all that there is to keep is kept. Ends the command where a signal came before."""
    _state.phase = _Phase.NOTHING
    if _state.number:
        raise KeyboardInterrupt


@contextmanager
def keeping() -> Iterator[None]:
    """Around the writing of results: a first signal does not end it."""
    before, _state.phase = _state.phase, _Phase.KEEPING
    try:
        yield
    finally:
        _state.phase = before


def optional(work: Callable[[], T]) -> T | None:
    """What can be done without: None once a signal has come, also in the middle of it."""
    if _state.number:
        return None
    before, _state.phase = _state.phase, _Phase.OPTIONAL
    try:
        return work()
    except KeyboardInterrupt:
        return None
    finally:
        _state.phase = before


def _answered() -> list[int]:
    """Those of the signals that nobody ignores or has a handler of his own for."""
    numbers = [getattr(signal, name) for name in NAMES if hasattr(signal, name)]
    ours = (signal.SIG_DFL, signal.default_int_handler)
    return [
        number
        for number in numbers
        if signal.getsignal(number) in ours or getattr(signal.getsignal(number), "__module__", "") == __name__
    ]


def _answer(number: int, _frame: FrameType | None) -> None:
    now = time.monotonic()
    if _state.number:
        if now - _state.at > ECHO:
            _end(number)
        return
    _state.number, _state.at = number, now
    _state.flag.set()
    if _state.phase is _Phase.NOTHING:
        _end(number)
    with contextlib.suppress(OSError):
        os.write(2, KEPT)  # unbuffered: the signal may have come in the middle of a print
    if _state.phase is _Phase.OPTIONAL:
        raise KeyboardInterrupt
    if _state.phase is _Phase.STUDY:
        from gearlash.jobs.stop import may_be_interrupted

        if may_be_interrupted():
            raise KeyboardInterrupt


def _end(number: int) -> None:
    """At once. Worker processes end with this one; files that are not whole go."""
    if "gearlash.results.store" in sys.modules:
        from gearlash.results.store import UNFINISHED

        for part in list(UNFINISHED):
            with contextlib.suppress(OSError):
                os.unlink(part)  # noqa: PTH108
    with contextlib.suppress(OSError):
        os.write(2, (CURSOR if os.isatty(2) else b"") + LOST)
    os._exit(128 + number)


@contextmanager
def _watched(numbers: list[int]) -> Iterator[None]:
    """A thread that answers where the main one does not come to it."""
    heard, told = socket.socketpair()
    told.setblocking(False)
    before = signal.set_wakeup_fd(told.fileno(), warn_on_full_buffer=False)

    def listen() -> None:
        first = 0.0
        while number := int.from_bytes(heard.recv(1), "big"):
            if number not in map(int, numbers):
                continue
            again = first > 0.0 and time.monotonic() - first > ECHO
            first = first or time.monotonic()
            deadline = time.monotonic() + (SOON if again else LATEST)
            while time.monotonic() < deadline and (again or not _state.number):
                time.sleep(0.05)
            if again or (not _state.number and _state.phase in (_Phase.NOTHING, _Phase.OPTIONAL)):
                _end(number)
            if not _state.number:
                with contextlib.suppress(OSError):
                    os.write(2, KEPT)

    thread = threading.Thread(target=listen, name="gearlash signals", daemon=True)
    thread.start()
    try:
        yield
    finally:
        signal.set_wakeup_fd(before)
        told.close()  # ends the thread
        thread.join()
        heard.close()
