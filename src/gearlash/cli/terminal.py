"""What is printed, wherever it goes: a terminal, a file, a pipe that closes early."""

from __future__ import annotations

import codecs
import io
import os
import sys
import textwrap
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, TextIO, TypeVar

from .interrupt import showing
from .spelling import spelled

if TYPE_CHECKING:
    from rich.console import Console
    from rich.text import Text

T = TypeVar("T")

PIPED_WIDTH = 120  # columns of what goes to a file or another program

# Names of files, keys and texts can hold what steers a terminal: each such character is shown as a sign.
_SIGNS = {code: 0x2400 + code for code in range(0x20) if chr(code) not in "\t\n"} | {0x7F: 0x2421}
_SIGNS |= dict.fromkeys(
    [*range(0x80, 0xA0), *range(0x2028, 0x202F), *range(0x2066, 0x206A), *range(0xD800, 0xE000)], 0xFFFD
)


def harmless(text: str) -> str:
    """The same text, as long, with a sign for every control character, direction override and surrogate."""
    return text.translate(_SIGNS)


def prepare_streams() -> None:
    """Lets standard output and error spell what their encoding lacks, and stand in for a stream that is
    closed.
    """
    codecs.register_error("gearlash", _spell)
    codecs.register(_spelled_ascii)
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:  # started with the stream closed
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: PTH123, SIM115
        elif isinstance(stream, io.TextIOWrapper):
            bare = codecs.lookup(stream.encoding).name == "ascii"
            stream.reconfigure(encoding=_ASCII if bare else None, errors="gearlash")


_ASCII = "gearlash_ascii"


def _spelled_ascii(name: str) -> codecs.CodecInfo | None:
    """ASCII by another name: what prints help takes plain ASCII for a mistake and would write UTF-8."""
    if name != _ASCII:
        return None
    known = codecs.lookup("ascii")
    return codecs.CodecInfo(
        known.encode,
        known.decode,
        incrementalencoder=known.incrementalencoder,
        incrementaldecoder=known.incrementaldecoder,
        name=_ASCII,
    )


def _spell(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    left = error.object[error.start : error.end]
    return "".join(map(spelled, left)), error.end


def output() -> Console:
    """Standard output as rich sees it."""
    return _console(stderr=False)


def errors() -> Console:
    """Standard error as rich sees it."""
    return _console(stderr=True)


def show(view: Callable[[T, int], Iterable[Text]], answer: T) -> None:
    """Prints an answer on standard output, as wide as that is."""
    console = output()
    with showing() as taken:
        for line in view(answer, console.width):
            line.plain = harmless(line.plain)
            console.print(line, soft_wrap=True)
            taken()


def tell(message: str) -> None:
    """One notice on standard error, if that can be written."""
    with _best_effort():
        errors().print(harmless(message), style="dim")


def complain(text: str) -> None:
    """A problem on standard error, if that can be written: every line of it wrapped at blanks with what
    follows indented.
    """
    with _best_effort():
        console = errors()
        for line in harmless(text).splitlines():
            indent = " " * (len(line) - len(line.lstrip()) + 2)
            wrapper = textwrap.TextWrapper(
                console.width, subsequent_indent=indent, break_on_hyphens=False, break_long_words=False
            )
            for row in wrapper.wrap(line) or [""]:
                console.print(row, style="red", soft_wrap=True)


def discard(stream: TextIO) -> None:
    """After a stream has failed, its reader gone or its disk full: whatever is still buffered goes nowhere,
    without complaint.
    """
    with open(os.devnull, "wb") as nothing:  # noqa: PTH123
        os.dup2(nothing.fileno(), stream.fileno())


@contextmanager
def _best_effort() -> Iterator[None]:
    """What cannot be told on standard error changes nothing: the exit code says it too."""
    try:
        yield
    except OSError:
        discard(sys.stderr)


def _console(stderr: bool) -> Console:
    from rich.console import Console

    class Unbroken(Console):
        """Leaves a closed pipe to the command, which ends quietly; rich would end the process."""

        def on_broken_pipe(self) -> None:
            raise BrokenPipeError

    stream = sys.stderr if stderr else sys.stdout
    wanted = os.environ.get("COLUMNS", "")
    if wanted.isascii() and wanted.isdigit():
        width = int(wanted) or PIPED_WIDTH
    else:
        width = None if stream.isatty() else PIPED_WIDTH
    return Unbroken(stderr=stderr, highlight=False, markup=False, emoji=False, width=width)
