"""Signals that end a command: Ctrl-C, SIGTERM, and SIGHUP of a terminal that closes.

The first one ends the work, and what was computed is kept; one more ends the command at once. What the first
one does depends on what the command is at:

- before it has anything to keep the process ends;
- while a study runs (`expect_results`) the flag is up that `gearlash.jobs` looks at between two points, and
  a point that takes long is broken off;
- what it can do without (`optional`) is broken off;
- while results are written (`keeping`) nothing is;
- when they are written and are shown (`showing`), that ends where nobody reads what is shown.

A thread hears them: the main one may be in a long call of machine code, or wait for a pipe that nobody
reads. Only the thread ends the process, so that files which belong together are not torn apart. The main
thread has a handler of its own for what can be broken off only there.
"""

from __future__ import annotations

import contextlib
import os
import select
import signal
import socket
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import Enum
from time import monotonic
from types import FrameType
from typing import TypeVar

T = TypeVar("T")

SIGNAL_NAMES = ("SIGINT", "SIGTERM", "SIGHUP")
STOPPING = b"\nstopping, with what was computed (once more gives it up)\n"
LOST = b"\ninterrupted\n"
CURSOR = b"\x1b[?25h"  # shows the cursor again that a bar has hidden
ECHO = 0.25  # s in which a second signal is the first one, sent to the process and to its group
AGAIN = 0.02  # s until what was raised in vain is raised once more; within `ECHO`
LOOK = 0.1  # s between two looks at a command that was told to end
PATIENCE = 1.0  # s that a reader may take nothing of what is shown, or that ending may take


class _Phase(Enum):
    NOTHING = "nothing to keep, or all is kept"
    STUDY = "results will be kept"
    OPTIONAL = "can be done without"
    ASKING = "answers, which are told when they end"
    KEEPING = "being kept"
    SHOWING = "kept, and being shown"


class _State:
    """Of this process."""

    def __init__(self) -> None:
        self.number = 0  # of the first signal; 0: none came
        self.heard = 0.0  # when that was
        self.met: _Phase | None = None  # what the main thread was at when it came to its handler
        self.phase = _Phase.NOTHING
        self.moved = 0.0  # when the phase began, or a part of what is shown was taken
        self.told = False  # that the command is stopping
        self.telling = threading.Lock()

    def is_set(self) -> bool:
        """The flag of `gearlash.jobs.stop`."""
        return self.number != 0

    def enter(self, phase: _Phase) -> None:
        self.phase, self.moved = phase, monotonic()


_state = _State()


def end_early() -> None:
    """From now on a signal ends this process at once, without a traceback: while modules are imported."""
    for number in _answered():
        signal.signal(number, lambda number, _frame: _end(number))


def ignore_late() -> None:
    """From now on a signal changes nothing: while Python itself ends, it would take the place of the exit
    code of what is done."""
    for number in _answered():
        signal.signal(number, signal.SIG_IGN)


@contextmanager
def signals_answered() -> Iterator[None]:
    """Around a command. Signals that are ignored stay so (`nohup`), and so do those of who has a use of his
    own for them."""
    _state.__init__()
    numbers = _answered() if threading.current_thread() is threading.main_thread() else []
    before = {number: signal.signal(number, _break_off) for number in numbers}
    try:
        with contextlib.ExitStack() as stack:
            if numbers:
                stack.enter_context(_listening(numbers))
                stack.enter_context(_raised_again())
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

    watch(_state)
    _state.enter(_Phase.STUDY)


def end_if_nothing(computed: bool) -> None:
    """Ends the command where a signal came before anything was computed: no older result is written over."""
    if _state.number and not computed:
        raise KeyboardInterrupt


def nothing_more() -> None:
    """From here on all that there is to keep is kept. Ends the command where a signal came before."""
    _state.enter(_Phase.NOTHING)
    if _state.number:
        raise KeyboardInterrupt


@contextmanager
def all_is_kept() -> Iterator[None]:
    """After the block, however it ends, there is nothing more to keep."""
    try:
        yield
    finally:
        _state.enter(_Phase.NOTHING)


@contextmanager
def keeping() -> Iterator[None]:
    """Around the writing of results: a first signal does not end it."""
    with _during(_Phase.KEEPING):
        yield


@contextmanager
def asking() -> Iterator[None]:
    """Around questions at a terminal: a signal ends them by `KeyboardInterrupt`, and what was answered can be
    told."""
    with _during(_Phase.ASKING):
        yield


@contextmanager
def showing() -> Iterator[Callable[[], None]]:
    """Around what is printed when all is kept. The function is to be called after each part of it: a reader
    who takes nothing for a while is not waited for once a signal has come."""

    def taken() -> None:
        _state.moved = monotonic()

    with _during(_Phase.SHOWING if _state.phase is _Phase.KEEPING else _state.phase):
        yield taken


def optional(work: Callable[[], T]) -> T | None:
    """What can be done without: None once a signal has come, also in the middle of it."""
    before = _state.phase
    try:
        if _state.number:
            return None
        with _during(_Phase.OPTIONAL):
            return work()
    except KeyboardInterrupt:
        _state.enter(before)
        return None


@contextmanager
def _during(phase: _Phase) -> Iterator[None]:
    before = _state.phase
    _state.enter(phase)
    try:
        yield
    finally:
        _state.enter(before)


def _answered() -> list[int]:
    """Those of the signals that nobody ignores or has a handler of his own for."""
    numbers = [getattr(signal, name) for name in SIGNAL_NAMES if hasattr(signal, name)]
    ours = (signal.SIG_DFL, signal.default_int_handler)
    return [
        number
        for number in numbers
        if signal.getsignal(number) in ours or getattr(signal.getsignal(number), "__module__", "") == __name__
    ]


def _break_off(number: int, _frame: FrameType | None) -> None:
    """In the main thread, once: the other one may hear of the signal a little earlier or later."""
    if _state.met is not None:
        return
    _state.met = _state.phase
    _tell_stopping(_state.phase)
    _state.number = _state.number or number
    if _state.phase in (_Phase.OPTIONAL, _Phase.ASKING):
        raise KeyboardInterrupt
    if _state.phase is _Phase.STUDY:
        from gearlash.jobs.stop import may_be_interrupted

        if may_be_interrupted():
            raise KeyboardInterrupt


@contextmanager
def _raised_again() -> Iterator[None]:
    """What breaks off the main thread may be raised where Python lets nothing through, as in the callback of
    a weak reference, and prints it instead. It is not printed here, and raised once more a little later."""
    before, timers = sys.unraisablehook, []

    def hook(lost: sys.UnraisableHookArgs) -> None:
        if not _state.number:
            before(lost)
        if not _state.number or lost.exc_type is not KeyboardInterrupt:
            return  # after a signal: a file that was broken off, and cannot close
        _state.met = None
        timers.append(threading.Timer(AGAIN, signal.raise_signal, (_state.number,)))
        timers[-1].daemon = True
        timers[-1].start()

    sys.unraisablehook = hook
    try:
        yield
    finally:
        sys.unraisablehook = before
        for timer in timers:
            timer.cancel()


@contextmanager
def _listening(numbers: list[int]) -> Iterator[None]:
    """With the thread that hears signals wherever the main one is."""
    heard, wakeup = socket.socketpair()
    wakeup.setblocking(False)
    before = signal.set_wakeup_fd(wakeup.fileno(), warn_on_full_buffer=False)

    def listen() -> None:
        while True:
            if select.select([heard], [], [], LOOK if _state.heard else None)[0]:
                content = heard.recv(1)
                if not content:
                    return
                if content[0] in map(int, numbers):
                    _hear(content[0])
            elif _hangs():
                _end(_state.number)

    thread = threading.Thread(target=listen, name="gearlash signals", daemon=True)
    thread.start()
    try:
        yield
    finally:
        signal.set_wakeup_fd(before)
        wakeup.close()  # ends the thread
        thread.join()
        heard.close()


def _hear(number: int) -> None:
    """What the thread does with a signal."""
    now = monotonic()
    if _state.heard:
        if now - _state.heard > ECHO:
            _end(number)
        return
    _state.heard = now
    phase = _state.met or _state.phase
    _tell_stopping(phase)
    _state.number = _state.number or number
    if phase is _Phase.NOTHING:
        _end(number)


def _tell_stopping(phase: _Phase) -> None:
    """Once, by the thread that comes first, and before the flag is up: what the command tells of its end
    comes after it."""
    if phase not in (_Phase.STUDY, _Phase.OPTIONAL, _Phase.KEEPING):
        return
    with _state.telling:
        if not _state.told:
            _state.told = True
            _say(STOPPING)


def _hangs() -> bool:
    """Whether a command that was told to end, and has nothing to keep any more, comes to no end."""
    done = _state.phase in (_Phase.NOTHING, _Phase.SHOWING)
    return done and monotonic() - max(_state.moved, _state.heard) > PATIENCE


def _end(number: int) -> None:
    """At once. Worker processes end with this one; files that are not whole go."""
    if "gearlash.results.store" in sys.modules:
        from gearlash.results.store import give_up

        give_up()
    _say((CURSOR if os.isatty(2) else b"") + LOST)
    os._exit(128 + number)


def _say(text: bytes) -> None:
    """On standard error, if it is taken there: unbuffered, as the main thread may be in the middle of a
    print."""
    with contextlib.suppress(OSError, ValueError):
        if os.name == "nt" or select.select([], [2], [], 0.0)[1]:
            os.write(2, text)
