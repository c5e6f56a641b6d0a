"""Chains of tasks. Tasks of one chain are done in order, each with what the one before handed on; chains are
independent.

A cold sweep is many chains of one task; a followed one is one chain, cut into tasks only to show progress and
to answer a cancel. What a task computes depends on its own content and what was handed on, so results are the
same for any executor, any number of workers and any cut.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Hashable, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from .executors import Inline, available_cores
from .progress import Load, Progress, ProgressCallback, remaining
from .stop import Cancel

Carry: TypeAlias = Any
DIED = "a worker process died (killed, or out of memory)"
GUARD = 'a script that starts workers must do so under `if __name__ == "__main__":`'
POLL = 0.2  # s between two looks at a cancel while nothing finishes


@dataclass(frozen=True)
class Part:
    """What a task returns: ``results`` (one per point; fewer than asked where it was stopped) and what the
    next task of its chain gets.
    """

    results: tuple[Any, ...]
    carry: Carry = None


@dataclass(frozen=True)
class Chain:
    """``tasks`` in order; ``sizes`` says how many points each has."""

    name: Hashable
    tasks: tuple[Any, ...]
    sizes: tuple[int, ...]
    first: Carry = None


@dataclass(frozen=True)
class Outcome:
    """Per chain the results of its points in order, as far as it came. ``reason`` is empty where all was
    done.
    """

    results: dict[Hashable, tuple[Any, ...]]
    reason: str = ""

    @property
    def complete(self) -> bool:
        return not self.reason


Work: TypeAlias = Callable[[Any, Carry], Part]


def run(
    work: Work,
    chains: Sequence[Chain],
    executor: Executor | None = None,
    *,
    progress: ProgressCallback | None = None,
    cancel: Cancel | None = None,
) -> Outcome:
    """Does all tasks of all chains: ``work(task, carry)`` is a function that other processes can import.

    A cancel, Ctrl-C or the death of a worker process ends it early; what was done is returned with the
    reason. An exception from ``work`` is a defect and raised.
    """
    executor = Inline() if executor is None else executor
    resume = getattr(executor, "resume", None)
    if resume is not None:
        resume()
    round_ = _Round(work, chains, executor, progress)
    try:
        reason = round_.go(cancel)
    except KeyboardInterrupt:
        reason = "interrupted"
    except BrokenExecutor:
        reason = DIED if any(round_.results) else f"{DIED}; {GUARD}"
    finally:
        round_.end()
    return Outcome(
        {chain.name: tuple(got) for chain, got in zip(chains, round_.results, strict=True)}, reason
    )


@dataclass
class _Round:
    """One call of `run`."""

    work: Work
    chains: Sequence[Chain]
    executor: Executor
    progress: ProgressCallback | None
    began: float = field(default_factory=time.perf_counter)
    flying: dict[Future[Any], tuple[int, int]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.results: list[list[Any]] = [[] for _ in self.chains]
        self.loads = [Load(sum(chain.sizes)) for chain in self.chains]
        self.workers = int(getattr(self.executor, "workers", available_cores()))
        # The longest chain first: it decides when all is done. Of equal ones the first.
        order = sorted(range(len(self.chains)), key=lambda i: (-len(self.chains[i].tasks), i))
        self.ready = [(i, 0, self.chains[i].first) for i in reversed(order) if self.chains[i].tasks]

    def go(self, cancel: Cancel | None) -> str:
        """Until all is done, or the reason why not."""
        ahead = 1 if isinstance(self.executor, Inline) else self.workers + 1
        while self.ready or self.flying:
            if cancel is not None and cancel.is_set():
                return "cancelled"
            while self.ready and len(self.flying) < ahead:
                self.submit(*self.ready.pop())
            done, _ = wait(self.flying, timeout=POLL, return_when=FIRST_COMPLETED)
            for future in done:
                self.collect(future)
        return "" if all(load.left == 0 for load in self.loads) else "stopped"

    def submit(self, index: int, step: int, carry: Carry) -> None:
        future = self.executor.submit(_timed, self.work, self.chains[index].tasks[step], carry)
        self.flying[future] = (index, step)

    def collect(self, future: Future[Any], proceed: bool = True) -> None:
        """Keeps the results of a task; the next of its chain goes ahead of chains not yet begun."""
        index, step = self.flying.pop(future)
        seconds, part = future.result()
        chain, load = self.chains[index], self.loads[index]
        self.results[index].extend(part.results)
        load.done += len(part.results)
        load.seconds += seconds
        whole = len(part.results) == chain.sizes[step]
        if proceed and whole and step + 1 < len(chain.tasks):
            self.ready.append((index, step + 1, part.carry))
        self.tell()

    def tell(self) -> None:
        if self.progress is not None:
            done, total = sum(load.done for load in self.loads), sum(load.total for load in self.loads)
            elapsed = time.perf_counter() - self.began
            self.progress(Progress(done, total, elapsed, remaining(self.loads, self.workers)))

    def end(self) -> None:
        """Takes back what has not begun, asks what is at work to stop, and keeps what that returns."""
        left = [future for future in self.flying if not future.cancel()]
        stop = getattr(self.executor, "stop", None)
        if left and stop is not None:
            stop()
        for future in left:
            if isinstance(future.exception(), BrokenExecutor):
                continue
            self.progress = None
            self.collect(future, proceed=False)


def _timed(work: Work, task: Any, carry: Carry) -> tuple[float, Part]:
    began = time.perf_counter()
    part = work(task, carry)
    return time.perf_counter() - began, part
