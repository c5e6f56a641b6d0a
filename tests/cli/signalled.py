"""Commands as processes that get signals, and what is left of them."""

from __future__ import annotations

import json
import os
import random
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import gearlash as gl

PATIENCE = 8.0  # s, on a machine that does other things too; a quiet one takes less than 2
DRAWING = 30.0  # s: a report or a tolerance study draws what it has before it ends
MARK = "GEARLASH_TEST_MARK"
PROGRAM = """
import _signal
_signal.signal(_signal.SIGINT, _signal.default_int_handler)  # which who started the tests may have ignored
_signal.signal(_signal.SIGHUP, _signal.SIG_DFL)
from gearlash.cli import main
main()
"""
DRIVE = Path(__file__).parents[1] / "cases/drive.toml"
OVER = "omega=0.5:1.4:20001"
LONG = ("--over", "D=0.3:0.5", "--step", "0.002")
COMMANDS = {
    "run": ("run", "article"),
    "run-long": ("run", "article", "--set", "omega=0.003"),
    "check": ("check", "article"),
    "sweep": ("sweep", "kahraman-singh", "--over", OVER),
    "sweep-short": ("sweep", "kahraman-singh", "--over", "omega=0.5:1.4:31"),
    "map": ("map", "kahraman-singh", "--over", "omega=0.5:1.4:200", "--over", "D=0.2:1.2:100"),
    "atlas": ("atlas", "kahraman-singh", "--over", "omega=0.5:1.4:41", "--over", "D=0.1:1.2:41"),
    "branch": ("branch", "article", *("--set", "omega=0.78", "--near", "0.37"), *LONG),
    "graze": ("graze", "article"),
    "graze-far": ("graze", "kahraman-singh", "--set", "omega=0.5"),
    "zones": ("zones", "kahraman-singh", "--over", "omega=0.5:1.4:3001"),
    "zones-short": ("zones", "kahraman-singh", "--over", "omega=0.5:1.4:15"),
    "reproduce": ("reproduce", "--points", "1001"),
    "report": ("report", "kahraman-singh"),
    "tolerance": ("tolerance", str(DRIVE), "--over", "omega=0.5:1.4:61", "--limits", "backlash=60:120um"),
    "compare": ("compare", str(DRIVE), str(DRIVE.with_name("measured.csv"))),
    "schema": ("schema",),
}
PARALLEL = (
    "atlas",
    "compare",
    "report",
    "tolerance",
    "sweep",
    "sweep-short",
    "map",
    "zones",
    "zones-short",
    "reproduce",
)
WITHOUT_DATASET = ("run", "graze", "branch", "report", "tolerance", "compare")
WITHOUT_FILES = ("check", "schema")
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129, signal.SIGKILL: -9}
KEEPS = "stopping, with what was computed"


@dataclass(frozen=True)
class Sent:
    """What is sent to a command: a signal some time after its start, perhaps another one after that."""

    name: str
    number: int
    delay: float
    workers: int = 0
    again: float | None = None

    @property
    def arguments(self) -> list[str]:
        if self.workers and self.name in PARALLEL:
            return [*COMMANDS[self.name], "--workers", str(self.workers)]
        return [*COMMANDS[self.name]]


@dataclass
class Ended:
    """How a command ended: its code, how long that took after the last signal, what it said, and what of it
    was still running a while later."""

    sent: Sent
    code: int
    seconds: float
    said: str
    out: Path
    left: list[str]
    finished: bool
    lost: list[str] = field(default_factory=list)

    @property
    def told(self) -> str:
        return f"{self.sent}: code {self.code} after {self.seconds:.1f} s: {self.said[-400:]}"


def signalled(sent: Sent, out: Path, cache: Path | None = None) -> Ended:
    """Starts a command with --out, and sends what is to be sent."""
    arguments = sent.arguments if sent.name in WITHOUT_FILES else [*sent.arguments, "--out", str(out)]
    mark = f"{os.getpid()}-{out.name}"
    env = {**os.environ, MARK: mark}
    if cache is not None:
        env["GEARLASH_CACHE_DIR"] = str(cache)
    process = subprocess.Popen(
        [sys.executable, "-c", PROGRAM, *arguments],
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=env, text=True,
        start_new_session=True,
    )  # fmt: skip
    time.sleep(sent.delay)
    finished = process.poll() is not None
    began = time.monotonic()
    process.send_signal(sent.number)
    if sent.again is not None:
        time.sleep(sent.again)
        began = time.monotonic()
        process.send_signal(sent.number)
    said, _ = process.communicate(timeout=60)  # the pipe ends, or this fails: nobody else holds it
    seconds = time.monotonic() - began
    ended = Ended(sent, process.returncode, seconds, said, out, still_running(mark), finished)
    ended.lost.extend(_lost(ended))
    return ended


def still_running(mark: str) -> list[str]:
    """Command lines of processes that carry the mark, and do not end."""
    deadline = time.monotonic() + PATIENCE
    while (left := marked(mark)) and time.monotonic() < deadline:
        time.sleep(0.1)
    return left


def marked(mark: str) -> list[str]:
    """Command lines of processes that carry the mark."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            if f"{MARK}={mark}".encode() in (process / "environ").read_bytes():
                found.append((process / "cmdline").read_bytes().replace(b"\0", b" ").decode()[:200])
        except OSError:
            continue
    return found


def check(ended: Ended) -> None:
    """Whatever the signal and its moment."""
    number, told = ended.sent.number, ended.told
    assert ended.seconds < (DRAWING if ended.sent.name in ("report", "tolerance") else PATIENCE), told
    # before Python reads the first line of gearlash, the signal does what it does to any process
    assert not re.search("Traceback.*gearlash", ended.said.replace(str(ended.out), ""), re.DOTALL), told
    if not ended.finished:
        assert ended.code in (CODES[signal.Signals(number)], -number, 0, 3), told


def _lost(ended: Ended) -> Iterator[str]:
    """What should be in the folder and is not, or not whole, or not what belongs to the rest of it."""
    stems = _stems(ended.sent.name)
    names = {path.name for path in ended.out.iterdir()} if ended.out.exists() else set()
    killed = ended.sent.number == signal.SIGKILL
    if not killed:
        yield from (f"{name}: half of a file" for name in names if name.endswith(".part"))
        # "interrupted" is said where nothing is computed yet, or where all is kept before
        if KEEPS in ended.said and ended.sent.again is None and "\ninterrupted" not in ended.said:
            yield from (f"{stem}.json" for stem in stems[:1] if f"{stem}.json" not in names)
    for stem in stems:
        data, answer = f"{stem}.nc" in names, f"{stem}.json" in names
        if answer:
            content = json.loads((ended.out / f"{stem}.json").read_text(encoding="utf-8"))
            if data:
                yield from _apart(content, ended.out / f"{stem}.nc")
        if data != answer and stem not in WITHOUT_DATASET and not killed:
            yield f"{stem}: one of data and answer without the other"


def _apart(answer: dict, file: Path) -> Iterator[str]:
    """Whether data and answer are of two commands."""
    dataset = gl.load_dataset(file)
    if answer["result"] == "sweep":
        computed = int((dataset["status"].values != "not-computed").sum())
        if computed != sum(len(way["points"]) for way in answer["sweeps"]):
            yield f"{file}: not the points of the answer beside it"
    if answer["status"] == "ok" and not dataset.attrs["complete"]:
        yield f"{file}: incomplete beside an answer that is ok"


def _stems(name: str) -> Sequence[str]:
    """Names of the results of a command, without their endings; first the one that comes first."""
    if name == "reproduce":
        return "sweep-omega", "sweep-D"
    return () if name in WITHOUT_FILES else (name.partition("-")[0],)


def any_signal(rng: random.Random, name: str) -> Sent:
    """One at any moment from the first import on; every fourth comes twice."""
    number = rng.choice([signal.SIGINT, signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL])
    again = rng.uniform(0.3, 1.2) if number != signal.SIGKILL and rng.random() < 0.25 else None
    longest = 0.4 if name in WITHOUT_FILES else 2.2
    return Sent(name, number, rng.uniform(0.02, longest), rng.choice([1, 1, 2]), again)
