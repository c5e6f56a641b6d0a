"""What a worker process does: tasks from standard input, answers to what was standard output.

Only the process that started it holds the other end of its input. However that process ends, killed
included, the input ends with it, and so does the worker, whatever it is at. It holds no stream of the
caller's: what a task prints goes nowhere.
"""

from __future__ import annotations

import _thread
import io
import os
import pickle
import queue
import signal
import sys
import threading
import traceback
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from types import ModuleType
from typing import IO, Any

from gearlash._kernel import keep_silent

from . import frames
from .stop import interruptible, may_be_interrupted, stopping, watch

GRACE = 0.3  # s that a task at work has to come to its next point after a stop; then it is interrupted
IGNORED = ("SIGTERM", "SIGHUP")  # sent to a whole group: the process that started this one answers them


@dataclass(frozen=True)
class Beginning:
    """What a worker is given first: where ``__main__`` of the other process is (module name, file), and
    what to call before the first task."""

    main: tuple[str, str]
    prepare: bytes


@dataclass
class _State:
    flag: threading.Event = field(default_factory=threading.Event)
    tasks: queue.SimpleQueue[tuple[bytes, bytes]] = field(default_factory=queue.SimpleQueue)
    count: int = 0
    main: tuple[str, str] = ("", "")
    main_loaded: bool = False


_state = _State()
_at_work = False


def in_worker() -> bool:
    """Whether this process is a worker, which starts no workers of its own."""
    return _at_work


def main() -> None:
    """The whole life of a worker."""
    global _at_work
    _at_work = True
    orders, answers = _streams()
    signal.signal(signal.SIGINT, _cut)
    for name in IGNORED:
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    watch(_state.flag)
    keep_silent()
    threading.Thread(target=_listen, args=(orders,), daemon=True).start()
    while True:
        kind, content = _state.tasks.get()
        reply = _begin(content) if kind == frames.START else _answer(content)
        try:
            frames.send(answers, *reply)
        except OSError:  # nobody waits any more
            os._exit(1)


def _streams() -> tuple[IO[bytes], IO[bytes]]:
    """The two ends of the pipes, moved to where no print and no input reaches them."""
    orders, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    nothing = os.open(os.devnull, os.O_RDWR)
    for standard in (0, 1, 2):
        os.dup2(nothing, standard)
    return orders, answers


def _listen(orders: IO[bytes]) -> None:
    """Reads all the time, so that the end of the other process is noticed at once."""
    while True:
        try:
            kind, content = frames.receive(orders)
        except (EOFError, OSError):
            os._exit(0)
        if kind == frames.STOP:
            _state.flag.set()
            cut = threading.Timer(GRACE, _cut_late, (_state.count,))
            cut.daemon = True
            cut.start()
        elif kind == frames.RESUME:
            _state.flag.clear()
        else:
            _state.tasks.put((kind, content))


def _cut_late(count: int) -> None:
    """Interrupts the task that was at work when the stop came, if it still is."""
    if count == _state.count and may_be_interrupted():
        _thread.interrupt_main()


def _cut(_number: int, _frame: object) -> None:
    """Of Ctrl-C: a worker leaves it to the process that started it, which asks for a stop."""
    if stopping() and may_be_interrupted():
        raise KeyboardInterrupt


def _begin(content: bytes) -> tuple[bytes, bytes]:
    beginning: Beginning = pickle.loads(content)
    _state.main = beginning.main
    return _done(beginning.prepare, frames.READY, nullcontext())


def _answer(content: bytes) -> tuple[bytes, bytes]:
    _state.count += 1
    return _done(content, frames.DONE, interruptible())


def _done(content: bytes, kind: bytes, around: AbstractContextManager[None]) -> tuple[bytes, bytes]:
    """What a call comes to: its result, or what it raised, whatever that is."""
    try:
        function, args, kwargs = _Unpickler(io.BytesIO(content)).load()
        with around:
            result = function(*args, **kwargs)
        return kind, pickle.dumps(result)
    except BaseException as error:  # noqa: BLE001  (it is raised again where the answer is waited for)
        return frames.RAISED, _packed(error)


def _packed(error: BaseException) -> bytes:
    """An exception as it travels, with where it was raised."""
    if isinstance(error, Exception):
        error.add_note("in a worker process:\n" + "".join(traceback.format_exception(error)))
    try:
        packed = pickle.dumps(error)
        pickle.loads(packed)
    except Exception:  # noqa: BLE001  (an exception of any kind may be one that does not travel)
        return pickle.dumps(RuntimeError("".join(traceback.format_exception(error))))
    return packed


class _Unpickler(pickle.Unpickler):
    """Finds what is defined in ``__main__`` of the other process, which is loaded only if something is."""

    def find_class(self, module_name: str, global_name: str, /) -> Any:
        if module_name == "__main__" and not _state.main_loaded:
            _load_main(*_state.main)
            _state.main_loaded = True
        return super().find_class(module_name, global_name)


def _load_main(name: str, file: str) -> None:
    """As `multiprocessing` does: its name tells a guarded script not to start its work again."""
    import runpy

    module = ModuleType("__mp_main__")
    if name:
        content = runpy.run_module(name, run_name="__mp_main__", alter_sys=True)
    else:
        content = runpy.run_path(file, run_name="__mp_main__")
    module.__dict__.update(content)
    sys.modules["__main__"] = sys.modules["__mp_main__"] = module
