"""What a user waits for: new processes, from the start of Python to its end."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from .results import OWN, Row
from .timing import Runner, in_turns, seconds

TASK = "start-up"
IMPORT, RUN, FRESH, STUDY = (
    "import gearlash",
    "gearlash run article",
    "gearlash run article, kernels not yet compiled",
    "gearlash reproduce",
)
TIED = """
import _thread, os
def end_with_input():
    os.read(0, 1)
    os._exit(1)
_thread.start_new_thread(end_with_input, ())
"""
"""What such a process does first. Only the one that started it holds the other end of its input: however that
ends, killed included, this one ends with it."""


def start_rows(repeats: int) -> list[Row]:
    """With compiled kernels in the cache, and bytecode as installed packages have it: where a shell forbids
    Python to write it, every process compiles an editable package anew."""
    codes = {"python alone": "pass", IMPORT: "import gearlash", RUN: _command("run", "article")}
    with TemporaryDirectory() as folder:
        kept = {"PYTHONPYCACHEPREFIX": folder, "PYTHONDONTWRITEBYTECODE": ""}
        runners = [Runner(name, lambda c=code: _process(c, kept)) for name, code in codes.items()]
        times = in_turns(runners, repeats)
    return [Row(TASK, name, OWN, "process", times[name].median, times[name].best) for name in codes]


def long_rows() -> list[Row]:
    """A first run on a new machine, and the whole study on all cores: once each, as they take long."""
    with TemporaryDirectory() as folder:
        empty = {"GEARLASH_CACHE_DIR": str(Path(folder) / "cache")}
        study = _command("reproduce", "--out", str(Path(folder) / "study"))
        spent = {
            FRESH: seconds(lambda: _process(_command("run", "article"), empty)),
            STUDY: seconds(lambda: _process(study)),
        }
    return [Row(TASK, name, OWN, "process", each, each) for name, each in spent.items()]


def _command(*arguments: str) -> str:
    return f"import sys; sys.argv = ['gearlash', *{list(arguments)!r}]; from gearlash.cli import main; main()"


def _process(code: str, more: dict[str, str] | None = None) -> None:
    process = subprocess.Popen(
        [sys.executable, "-P", "-c", TIED + code],
        env={**os.environ, **(more or {})},
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    with process:
        ended = process.wait()  # its input stays open until then
    if ended:
        raise subprocess.CalledProcessError(ended, process.args)
