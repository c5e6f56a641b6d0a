"""Exit codes, and the frame around every command that turns errors into them."""

from __future__ import annotations

import functools
from collections.abc import Callable
from enum import IntEnum
from typing import Any

import typer

from .terminal import complain, discard_output, tell


class ExitCode(IntEnum):
    """What the exit code of a command says."""

    OK = 0
    BUG = 1
    INPUT = 2
    NOT_OK = 3
    INTERRUPTED = 130


MEANINGS = {
    ExitCode.OK: "the result is there and its status is ok",
    ExitCode.BUG: "a bug in gearlash; the traceback is on standard error",
    ExitCode.INPUT: "the case, an option or the folder cannot be used; standard error lists every problem",
    ExitCode.NOT_OK: "the result is there, but its status is not ok; the output says which and what to do",
    ExitCode.INTERRUPTED: "stopped by Ctrl-C; what was computed is kept in --out and marked incomplete",
}


def command(function: Callable[..., ExitCode]) -> Callable[..., None]:
    """A command that returns its exit code and may raise what gearlash raises on purpose."""

    @functools.wraps(function)
    def framed(*args: Any, **kwargs: Any) -> None:
        from gearlash.system import GearlashError  # late: numpy is not needed to print --help

        try:
            code = function(*args, **kwargs)
        except GearlashError as error:
            report(error, as_json=bool(kwargs.get("as_json")))
            code = ExitCode.INPUT
        except KeyboardInterrupt:
            tell("interrupted")
            code = ExitCode.INTERRUPTED
        except BrokenPipeError:  # the reader has seen enough
            discard_output()
            code = ExitCode.OK
        raise typer.Exit(int(code))

    return framed


def report(error: Exception, as_json: bool = False) -> None:
    """Every problem on standard error; with --json also as an object on standard output."""
    complain(f"gearlash: {error}")
    if as_json:
        from .answers.problem import problem_answer
        from .jsonio import write_stdout

        write_stdout(problem_answer(error))
