"""Exit codes, and the frame around every command that turns errors into them."""

from __future__ import annotations

import contextlib
import functools
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import IntEnum
from typing import Any

import typer

from .interrupt import all_is_kept, keeping, signalled, signals_answered
from .question import ask
from .terminal import complain, discard, tell


class ExitCode(IntEnum):
    """What the exit code of a command says."""

    OK = 0
    BUG = 1
    INPUT = 2
    NOT_OK = 3
    UNWRITTEN = 4
    STOPPED = 5
    HUNG_UP = 129
    INTERRUPTED = 130
    TERMINATED = 143


MEANINGS = {
    ExitCode.OK: "the result is there and its status is ok",
    ExitCode.BUG: "a bug in gearlash; the traceback is on standard error",
    ExitCode.INPUT: "the case, an option or the folder cannot be used; standard error lists every problem",
    ExitCode.NOT_OK: "the result is there, but its status is not ok; the output says which and what to do",
    ExitCode.UNWRITTEN: "the result was computed, but standard output or --out could not be written (a full "
    "disk, say); standard error says why",
    ExitCode.STOPPED: "a worker process died (killed, or out of memory); what was computed without it is "
    "kept in --out and marked incomplete",
    ExitCode.HUNG_UP: "as 130, by SIGHUP: the terminal was closed",
    ExitCode.INTERRUPTED: "stopped by Ctrl-C; what was computed is kept in --out and marked incomplete, "
    "unless a complete answer to the same question is there. Ctrl-C once more gives it up: every file is "
    "there whole or not at all",
    ExitCode.TERMINATED: "as 130, by SIGTERM: `kill`, a batch system, `timeout`",
}


def code_of(status: str) -> ExitCode:
    """The exit code of a study by its status."""
    return {"ok": ExitCode.OK, "incomplete": ExitCode.STOPPED}.get(status, ExitCode.NOT_OK)


class NotWrittenError(Exception):
    """A result that could not be written."""

    def __init__(self, cause: OSError):
        self.cause = cause
        super().__init__(str(cause))


@contextmanager
def delivery(breakable: bool = False) -> Iterator[None]:
    """Around the writing of results: what the system refuses there is no bug of gearlash. A first signal does
    not end it, unless it is ``breakable``: all that has to be kept is written already."""
    try:
        with contextlib.nullcontext() if breakable else keeping():
            yield
    except OSError as error:
        raise NotWrittenError(error) from error


def command(function: Callable[..., ExitCode]) -> Callable[..., None]:
    """A command that returns its exit code and may raise what gearlash raises on purpose."""

    @functools.wraps(function)
    def framed(*args: Any, **kwargs: Any) -> None:
        with signals_answered():
            ask(function.__name__, kwargs)
            code = _code(functools.partial(function, *args, **kwargs), bool(kwargs.get("as_json")))
        if signalled() and code not in (ExitCode.INPUT, ExitCode.UNWRITTEN):
            code = ExitCode(128 + signalled())
        raise typer.Exit(int(code))

    return framed


def _code(work: Callable[[], ExitCode], as_json: bool) -> ExitCode:
    """The exit code of a command, with what it raises told."""
    from gearlash.system import GearlashError  # late: numpy is not needed to print --help

    try:
        with all_is_kept():
            return work()
    except _deaths() as error:
        report(error, as_json)
        return ExitCode.STOPPED
    except GearlashError as error:
        report(error, as_json)
        return ExitCode.INPUT
    except KeyboardInterrupt:
        tell("interrupted")
        return ExitCode.INTERRUPTED
    except NotWrittenError as error:
        return not_written(error.cause)
    except BrokenPipeError as error:
        return not_written(error)


def _deaths() -> tuple[type[Exception], ...]:
    """What says that worker processes died."""
    if "gearlash.jobs" not in sys.modules:  # then there are none
        return ()
    from concurrent.futures import BrokenExecutor

    from gearlash.jobs import NoWorkersError, UnfinishedError

    return BrokenExecutor, NoWorkersError, UnfinishedError


def not_written(error: OSError) -> ExitCode:
    """After a failure to write: nothing is wrong if the reader of a pipe has seen enough."""
    discard(sys.stdout)
    if isinstance(error, BrokenPipeError):
        return ExitCode.OK
    place = error.filename2 or error.filename or "standard output"
    complain(f"gearlash: {place} cannot be written ({error.strerror or error})")
    return ExitCode.UNWRITTEN


def report(error: Exception, as_json: bool = False) -> None:
    """Every problem on standard error; with --json also as an object on standard output."""
    complain(f"gearlash: {error}")
    if as_json:
        from .answers.problem import problem_answer
        from .jsonio import write_stdout

        try:
            write_stdout(problem_answer(error))
        except OSError:  # the exit code and standard error say it too
            discard(sys.stdout)
