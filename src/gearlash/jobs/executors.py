"""Who does the work: this process, or processes of their own. Any other `concurrent.futures.Executor` is
taken as well.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import Executor, Future
from typing import Any

from gearlash.system import given

from .pool import Pool

MOST_WORKERS = 1024


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


def open_executor(
    workers: int | None = None, prepare: Callable[..., None] | None = None, arguments: tuple[Any, ...] = ()
) -> Executor:
    """An executor for ``workers`` processes: 0 or 1 is this process itself, None one per processor core that
    may be used. ``prepare`` is for the workers of a pool. To be used in a ``with`` statement.
    """
    workers = available_cores() if workers is None else given.whole("workers", workers, 0, MOST_WORKERS)
    return Pool(workers, prepare, arguments) if workers > 1 else Inline()


def available_cores() -> int:
    """Processor cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
