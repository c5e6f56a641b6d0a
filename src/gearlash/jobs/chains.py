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
from contextlib import nullcontext
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from .execution import Execution
from .executors import Inline, available_cores
from .pool import NoWorkersError, Pool
from .progress import Load, Progress, ProgressCallback, remaining
from .stop import NEVER, Cancel, Interrupted, held_back, interruptible, may_be_interrupted, stopping
from .travel import GUARD

Carry: TypeAlias = Any
INTERRUPTED, CANCELLED = "interrupted", "cancelled"
DIED = "a worker process died (killed, or out of memory)"
DEFECT = "defect"
NEEDS_NONE = f"workers=1 needs none ({GUARD})"
POLL = 0.2  # s between two looks at a cancel while nothing finishes
TASK_PATIENCE = 1.0  # s that tasks at work have to return what they have; what comes later is given up
MANY, SELDOM = 1_000, 0.1  # chains from which progress is told no more often than so (s): it looks at all


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
DEFAULT = Execution()


def run(
    work: Work,
    chains: Sequence[Chain],
    execution: Execution = DEFAULT,
) -> Outcome:
    """Does all tasks of all chains: ``work(task, carry)`` is a function that other processes can import.

    A cancel, Ctrl-C or the death of a worker process ends it early; what was done is returned with the
    reason. Within a task of another call, which cannot use what is incomplete, Ctrl-C goes on to that. Raises
    `NoWorkersError` where workers died before anything was done, and what ``work`` raises, which is a defect.
    """
    executor = Inline() if execution.executor is None else execution.executor
    within = may_be_interrupted()
    if isinstance(executor, Pool):
        executor.resume()
    round_ = _Round(work, chains, executor, execution.progress)
    reason, none = DEFECT, NoWorkersError(f"{DIED} before anything was computed; {NEEDS_NONE}")
    with nullcontext(NEVER) if round_.inline else held_back() as pressed:
        try:
            reason = round_.go(NEVER if execution.cancel is None else execution.cancel, pressed)
        except KeyboardInterrupt:
            reason = INTERRUPTED
        except BrokenExecutor:
            reason = DIED
        except NoWorkersError as error:
            reason, none = DIED, error
        finally:
            round_.end(reason)
        if pressed.is_set():
            reason = INTERRUPTED
    if reason == INTERRUPTED and within:
        raise KeyboardInterrupt
    results = round_.results()
    if reason == DIED and not any(results.values()):
        raise none
    return Outcome(results, reason)


@dataclass
class _Round:
    """One call of `run`."""

    work: Work
    chains: Sequence[Chain]
    executor: Executor
    progress: ProgressCallback | None
    began: float = field(default_factory=time.perf_counter)
    told: float = 0.0
    flying: dict[Future[Any], tuple[int, int]] = field(default_factory=dict)
    handing_over: bool = False

    def __post_init__(self) -> None:
        self.parts: list[dict[int, tuple[Any, ...]]] = [{} for _ in self.chains]
        self.loads = [Load(sum(chain.sizes)) for chain in self.chains]
        self.inline = isinstance(self.executor, Inline)
        self.workers = int(getattr(self.executor, "workers", available_cores()))
        # The longest chain first: it decides when all is done. Of equal ones the first.
        order = sorted(range(len(self.chains)), key=lambda i: (-len(self.chains[i].tasks), i))
        self.ready = [(i, 0, self.chains[i].first) for i in reversed(order) if self.chains[i].tasks]

    def go(self, cancel: Cancel, pressed: Cancel) -> str:
        """Until all is done, or the reason why not."""
        ahead = 1 if self.inline else self.workers + 1
        while self.ready or self.flying:
            if cancel.is_set():
                return CANCELLED
            if stopping() or pressed.is_set():
                return INTERRUPTED
            while self.ready and len(self.flying) < ahead:
                self.submit(*self.ready.pop())
            done, _ = wait(self.flying, timeout=POLL, return_when=FIRST_COMPLETED)
            for future in done:
                self.collect(future)
        if all(load.left == 0 for load in self.loads):
            return ""
        return INTERRUPTED if stopping() else "stopped"

    def submit(self, index: int, step: int, carry: Carry) -> None:
        """Begins a task. Where this process does the work it is done at once, and a signal may end it."""
        arguments = (_timed, self.work, self.chains[index].tasks[step], carry)
        if not self.inline:
            self.handing_over = True  # and it stays so if Ctrl-C comes before we know the task by its future
            self.flying[self.taken(*arguments)] = (index, step)
            self.handing_over = False
            return
        try:
            with interruptible():
                future = self.executor.submit(*arguments)
        except Interrupted as error:
            self.parts[index][step] = error.part.results
            raise
        self.flying[future] = (index, step)

    def taken(self, *arguments: Any) -> Future[Any]:
        """Gives a task to the executor. Raises `NoWorkersError` if the executor was shut down before."""
        try:
            return self.executor.submit(*arguments)
        except BrokenExecutor:
            raise
        except RuntimeError as error:
            raise NoWorkersError(f"the executor takes no work ({error}): open another one") from None

    def collect(self, future: Future[Any], proceed: bool = True) -> None:
        """Keeps the results of a task; the next of its chain goes ahead of chains not yet begun."""
        index, step = self.flying[future]
        try:
            seconds, part = future.result()
        except Interrupted as error:
            seconds, part = 0.0, error.part
        chain, load = self.chains[index], self.loads[index]
        self.parts[index][step] = part.results
        del self.flying[future]
        load.done += len(part.results)
        load.seconds += seconds
        whole = len(part.results) == chain.sizes[step]
        if proceed and whole and step + 1 < len(chain.tasks):
            self.ready.append((index, step + 1, part.carry))
        self.tell()

    def tell(self) -> None:
        now, last = time.perf_counter(), not (self.ready or self.flying)
        seldom = len(self.chains) > MANY and now - self.told < SELDOM and not last
        if self.progress is None or seldom:
            return
        self.told = now
        done, total = sum(load.done for load in self.loads), sum(load.total for load in self.loads)
        self.progress(Progress(done, total, now - self.began, remaining(self.loads, self.workers)))

    def end(self, reason: str) -> None:
        """Cancels what has not begun, asks the tasks at work to stop, and keeps what they return. A task that
        was being handed over may be at work though nobody waits for it: it is given up."""
        left = [future for future in self.flying if not future.cancel()]
        if isinstance(self.executor, Pool):
            if left or self.handing_over:
                self.executor.stop()
            if reason and (wait(left, TASK_PATIENCE).not_done or self.handing_over):
                self.executor.abandon()
        self.progress = None
        for future in left:
            if not isinstance(future.exception(), BrokenExecutor | NoWorkersError) and _kept(future):
                self.collect(future, proceed=False)

    def results(self) -> dict[Hashable, tuple[Any, ...]]:
        """Per chain, in order."""
        return {
            chain.name: tuple(result for step in sorted(parts) for result in parts[step])
            for chain, parts in zip(self.chains, self.parts, strict=True)
        }


def _kept(future: Future[Any]) -> bool:
    """Whether a task has results: it has none where a stop ended it before the first."""
    error = future.exception()
    return isinstance(error, Interrupted) or not isinstance(error, KeyboardInterrupt)


def _timed(work: Work, task: Any, carry: Carry) -> tuple[float, Part]:
    began = time.perf_counter()
    part = work(task, carry)
    return time.perf_counter() - began, part
