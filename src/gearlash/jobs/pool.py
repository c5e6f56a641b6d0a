"""Worker processes as a `concurrent.futures.Executor`.

Each is a fresh Python that talks through two pipes (`worker`), served by a thread of this process. Nothing
else ties them together: no semaphore, no helper process, no stream of the caller's. So workers end with this
process whatever ends it, and one that is killed takes only its own task with it.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor, Future
from typing import Any

from gearlash._kernel import children
from gearlash.current_folder import path_without_it
from gearlash.system import GearlashError

from . import frames
from .travel import main_module
from .worker import Beginning, in_worker

PROGRAM = "import sys; sys.path[:] = sys.argv[1:]; from gearlash.jobs.worker import main; main()"
HELD_BACK = ("SIGINT", "SIGTERM", "SIGHUP")
WORKER_PATIENCE = 5.0  # s for a worker to end after its input has


class WorkerDiedError(BrokenExecutor):
    """A worker process ended in the middle of a task."""


class UnfinishedError(GearlashError):
    """What a study rests on was stopped before it was complete, as by the death of a worker."""


class NoWorkersError(GearlashError):
    """Worker processes died before anything was computed, or did not even start."""


class Pool(Executor):
    """At most so many ``workers`` processes, started when there is work for them.

    ``prepare(*arguments)`` runs once in each before its first task. Workers leave Ctrl-C to this process,
    which asks them through `stop`.
    """

    def __init__(
        self, workers: int, prepare: Callable[..., None] | None = None, arguments: tuple[Any, ...] = ()
    ):
        if in_worker():
            raise GearlashError(
                "a worker process starts no workers of its own: a script that starts some must do so "
                'under `if __name__ == "__main__":`'
            )
        self.workers = self._most = workers
        self._beginning = pickle.dumps(
            Beginning(main_module(), pickle.dumps((prepare or _nothing, arguments, {})))
        )
        self._tasks: queue.SimpleQueue[tuple[Future[Any], bytes, int] | None] = queue.SimpleQueue()
        self._lock = threading.RLock()
        self._members: list[_Member] = []
        self._unfinished = 0
        self._stopping = self._closed = self._hurried = False
        self._given_up = 0  # how often work was abandoned
        self._failure: NoWorkersError | None = None

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Gives a task to the workers. Raises what `pickle` raises where the task cannot be sent."""
        content = pickle.dumps((fn, args, kwargs))
        future: Future[Any] = Future()
        with self._lock:
            if self._closed:
                raise RuntimeError("cannot schedule new futures after shutdown")
            if self._failure is not None:
                raise self._failure
            self._unfinished += 1
            self._tasks.put((future, content, self._given_up))
            if self._unfinished > len(self._members):
                self._start_one()
        return future

    def stop(self) -> None:
        """Asks tasks at work to return what they have (see `stopping`)."""
        self._tell(True)

    def resume(self) -> None:
        """Ends a stop, so that new work can be done."""
        self._tell(False)

    def abandon(self) -> None:
        """Ends the workers that are at a task: their futures have `WorkerDiedError`. What waits is cancelled,
        and what a worker is just about to begin is not begun."""
        with self._lock:
            self._given_up += 1
            if not self._closed:
                self._drain(None)
            for member in self._members:
                member.kill_at_work()

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Ends the workers when they have done what was submitted; what was not begun can be cancelled."""
        with self._lock:
            self._closed = True
            members = list(self._members)
            if cancel_futures:
                self._hurried = True
                self._drain(None)
                for member in members:
                    member.kill_beginning()
            for _ in members:
                self._tasks.put(None)
        if wait:
            for member in members:
                member.join()

    def __exit__(self, kind: object, *error: object) -> None:
        if kind is not None:
            self.abandon()
        self.shutdown(wait=True, cancel_futures=True)

    def _start_one(self) -> None:
        if len(self._members) < self._most:
            self._members.append(_Member(self))
            self._members[-1].start()

    def _tell(self, stop: bool) -> None:
        with self._lock:
            self._stopping = stop
            members = list(self._members)
        for member in members:
            member.tell(stop)

    def _drain(self, error: Exception | None) -> None:
        """Empties the queue: the tasks that wait are cancelled, or fail with this error."""
        while not self._tasks.empty():
            task = self._tasks.get()
            if task is None:
                continue
            self._unfinished -= 1
            if error is None:
                task[0].cancel()
                task[0].set_running_or_notify_cancel()
            elif task[0].set_running_or_notify_cancel():
                task[0].set_exception(error)

    def _ended(self, member: _Member, failure: NoWorkersError | None) -> None:
        """A worker has ended. One that did not even start is not replaced, as the next one would fail in the
        same way; the other workers, if there are any, do its work."""
        with self._lock:
            self._members.remove(member)
            if failure is not None:
                self._most = len(self._members)
            if self._most == 0:
                self._failure = failure
                self._drain(failure)
            elif not self._closed and not self._tasks.empty():
                self._start_one()


class _Member(threading.Thread):
    """One worker process, and the thread that serves it."""

    def __init__(self, pool: Pool):
        super().__init__(name="gearlash worker", daemon=True)
        self.pool = pool
        self.process: subprocess.Popen[bytes] | None = None
        self.begun = self.at_work = self.stop_sent = False
        self.writing = threading.Lock()

    def run(self) -> None:
        failure: NoWorkersError | None = None
        try:
            self.begin()
            while (task := self.pool._tasks.get()) is not None:
                self.do(*task)
        except NoWorkersError as error:
            failure = error
        except WorkerDiedError:
            pass
        finally:
            self.end()
            self.pool._ended(self, failure)

    def begin(self) -> None:
        """Starts the process and prepares it. Raises `NoWorkersError` if it ends before its first task."""
        _hold_back_signals()
        try:
            self.process = start()
            if self.pool._hurried:
                self.kill_beginning()
            kind, content = self.asked(frames.START, self.pool._beginning)
        except OSError as error:
            raise NoWorkersError(f"no worker process can be started ({error.strerror or error})") from None
        except EOFError:
            assert self.process is not None
            code = self.process.wait()
            raise NoWorkersError(f"a worker process died while it started (exit code {code})") from None
        if kind == frames.RAISED:
            error = pickle.loads(content)
            raise NoWorkersError(
                f"worker processes cannot begin ({type(error).__name__}: {error}); workers=1 needs none"
            )
        self.begun = True

    def do(self, future: Future[Any], content: bytes, given_up: int) -> None:
        """One task, unless work was ``given_up`` since it was submitted. Raises `WorkerDiedError` if the
        process ends in it.
        """
        if not future.set_running_or_notify_cancel():
            self.finished()
            return
        self.at_work = True
        if given_up != self.pool._given_up:  # looked at after `at_work` is set: one of the two is always seen
            self.finished()
            future.set_exception(WorkerDiedError("the work was given up"))
            return
        try:
            self.tell(self.pool._stopping)
            kind, answer = self.asked(frames.TASK, content)
        except (OSError, EOFError):
            error = WorkerDiedError("a worker process died")
            self.finished()
            future.set_exception(error)
            raise error from None
        self.finished()
        try:
            result = pickle.loads(answer)
        except Exception as error:  # noqa: BLE001  (what does not come back whole is told where it is missed)
            future.set_exception(error)
            return
        if kind == frames.RAISED:
            future.set_exception(result)
        else:
            future.set_result(result)

    def asked(self, kind: bytes, content: bytes) -> tuple[bytes, bytes]:
        """The answer to a message."""
        process = self.process
        assert process is not None
        assert process.stdin is not None
        assert process.stdout is not None
        with self.writing:
            frames.send(process.stdin, kind, content)
        return frames.receive(process.stdout)

    def tell(self, stop: bool) -> None:
        """Tells the process that a stop begins or ends, unless it was told before."""
        with self.writing:
            if self.process is None or self.process.stdin is None or self.stop_sent == stop:
                return
            self.stop_sent = stop
            try:
                frames.send(self.process.stdin, frames.STOP if stop else frames.RESUME)
            except (OSError, ValueError):  # it has ended, which its task will say
                return

    def finished(self) -> None:
        self.at_work = False
        with self.pool._lock:
            self.pool._unfinished -= 1

    def kill_beginning(self) -> None:
        if not self.begun and self.process is not None:
            self.process.kill()

    def kill_at_work(self) -> None:
        if self.at_work and self.process is not None:
            self.process.kill()

    def end(self) -> None:
        """Closes the input of the process, which ends it."""
        process = self.process
        if process is None:
            return
        with self.writing:
            for stream in (process.stdin, process.stdout):
                if stream is not None:
                    with contextlib.suppress(OSError):  # what was not sent will not be
                        stream.close()
        try:
            process.wait(WORKER_PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


def start() -> subprocess.Popen[bytes]:
    """A worker process. It finds modules where this one does, but in the current folder last of all, and
    takes assertions and warnings as this one does."""
    here = [os.getcwd()] if "" in sys.path else []  # noqa: PTH109
    return subprocess.Popen(
        [sys.executable, children.SAFE, *_manner(), "-c", PROGRAM, *path_without_it(), *here],
        env=children.environment(),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )


def _manner() -> list[str]:
    """Options of Python that change what a user's function does: `-O`, `-W`."""
    return ["-O"] * sys.flags.optimize + [f"-W{each}" for each in sys.warnoptions]


def _hold_back_signals() -> None:
    """Blocks signals in this thread, and so in the processes that it starts, from their beginning."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_BLOCK, {getattr(signal, name) for name in HELD_BACK})


def _nothing() -> None:
    """In place of a preparation."""
