"""Who does the work: this process, or processes of their own. Any other `concurrent.futures.Executor` is
taken as well.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from typing import Any

from gearlash._kernel import keep_silent, started_safely
from gearlash.system import GearlashError

from .stop import Cancel, watch


class Inline(Executor):
    """Does each task at once, in the calling thread."""

    workers = 1

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """The result of the call as a finished future. What it raises, Ctrl-C too, goes straight to the
        caller.
        """
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


class Pool(ProcessPoolExecutor):
    """Worker processes, started afresh (spawn: the same on every system, safe beside threads and compiled
    kernels).

    ``prepare(*arguments)`` runs once in each before its first task. Workers leave Ctrl-C to the process that
    started them, which asks them through `stop`.
    """

    def __init__(
        self, workers: int, prepare: Callable[..., None] | None = None, arguments: tuple[Any, ...] = ()
    ):
        context = multiprocessing.get_context("spawn")
        self.workers = workers
        with started_safely():  # the process that looks after semaphores
            self._stop = context.Event()
        super().__init__(workers, context, _start, (self._stop, prepare, arguments))

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """The future of a task. Workers started for it never see Ctrl-C, not even while they are starting."""
        with _ctrl_c_held_back(), started_safely():
            return super().submit(fn, *args, **kwargs)

    def stop(self) -> None:
        """Asks tasks at work to return what they have (see `stopping`)."""
        self._stop.set()

    def resume(self) -> None:
        """Takes `stop` back, before new work."""
        self._stop.clear()

    def __exit__(self, *error: object) -> None:
        self.shutdown(wait=True, cancel_futures=True)


def open_executor(
    workers: int | None = None, prepare: Callable[..., None] | None = None, arguments: tuple[Any, ...] = ()
) -> Executor:
    """An executor for ``workers`` processes: 0 or 1 is this process itself, None one per processor core that
    may be used. ``prepare`` is for the workers of a pool. To be used in a ``with`` statement.
    """
    if workers is None:
        workers = available_cores()
    if workers < 0:
        raise GearlashError(f"workers = {workers}: expected 0 or more")
    return Pool(workers, prepare, arguments) if workers > 1 else Inline()


def available_cores() -> int:
    """Processor cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def _ctrl_c_held_back() -> Iterator[None]:
    """Ctrl-C waits until the block ends; processes started in it inherit that it waits, for ever."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _start(flag: Cancel, prepare: Callable[..., None] | None, arguments: tuple[Any, ...]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    watch(flag)
    keep_silent()
    if prepare is not None:
        prepare(*arguments)
