"""Signals at random moments: what was computed is kept, whole, and nothing is left running."""

from __future__ import annotations

import json
import os
import random
import re
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import pytest

import gearlash as gl

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="processes are looked for in /proc"),
]

ANSWERED = 8.0  # s, on a machine that does other things too; a quiet one takes less than 2
MARK = "GEARLASH_TEST_MARK"
OVER = "omega=0.5:1.4:20001"
COMMANDS = {
    "run": ("run", "article"),
    "run-long": ("run", "article", "--set", "omega=0.003"),
    "check": ("check", "article"),
    "sweep": ("sweep", "kahraman-singh", "--over", OVER),
    "map": ("map", "kahraman-singh", "--over", "omega=0.5:1.4:200", "--over", "D=0.2:1.2:100"),
    "graze": ("graze", "article"),
    "zones": ("zones", "kahraman-singh", "--over", "omega=0.5:1.4:3001"),
    "reproduce": ("reproduce", "--points", "1001"),
    "bench": ("bench", "--quick"),
    "schema": ("schema",),
}
PARALLEL = ("sweep", "map", "zones", "reproduce")
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129, signal.SIGKILL: -9}


@dataclass
class Ended:
    """A command that got a signal: its code, how long the end took, what it said, and where its files are."""

    code: int
    seconds: float
    said: str
    out: Path
    left: list[str]
    finished: bool


@pytest.fixture(scope="module", autouse=True)
def _warm() -> None:
    """Kernels are compiled before, but where the compiling itself is interrupted."""
    program = "import gearlash.flow, gearlash._kernel as kernel; kernel.compile_all(kernel.load_all())"
    subprocess.run([sys.executable, "-c", program], check=True, capture_output=True)


def _left(mark: str) -> list[str]:
    """Command lines of processes that carry the mark."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            if f"{MARK}={mark}".encode() in (process / "environ").read_bytes():
                found.append((process / "cmdline").read_bytes().replace(b"\0", b" ").decode()[:200])
        except OSError:
            continue
    return found


def _signalled(
    name: str,
    number: int,
    delay: float,
    out: Path,
    workers: int = 0,
    again: bool = False,
    cache: Path | None = None,
) -> Ended:
    mark = f"{os.getpid()}-{out.name}"
    arguments = [*COMMANDS[name]]
    if name not in ("check", "schema"):
        arguments += ["--out", str(out)]
    if workers and name in PARALLEL:
        arguments += ["--workers", str(workers)]
    env = {**os.environ, MARK: mark}
    if cache is not None:
        env["GEARLASH_CACHE_DIR"] = str(cache)
    process = subprocess.Popen(
        [sys.executable, "-c", "from gearlash.cli import main; main()", *arguments],
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=env, text=True,
        start_new_session=True,
    )  # fmt: skip
    time.sleep(delay)
    finished = process.poll() is not None
    began = time.monotonic()
    process.send_signal(number)
    if again:
        time.sleep(0.4)
        process.send_signal(number)
    said, _ = process.communicate(timeout=60)  # the pipe ends, or this fails: nobody else holds it
    seconds = time.monotonic() - began
    deadline = time.monotonic() + ANSWERED
    while (left := _left(mark)) and time.monotonic() < deadline:
        time.sleep(0.1)
    return Ended(process.returncode, seconds, said, out, left, finished)


def _check(name: str, number: int, ended: Ended, again: bool) -> None:
    told = f"{name}: code {ended.code} after {ended.seconds:.1f} s: {ended.said[-300:]}"
    assert ended.left == [], told
    assert ended.seconds < ANSWERED, told
    assert "Traceback" not in ended.said, told
    if not ended.finished:
        # before Python reads the first line of gearlash, the signal does what it does to any process
        assert ended.code in (CODES[signal.Signals(number)], -number, 0, 3), told
    if not ended.out.exists():
        return
    assert not list(ended.out.glob("*.part")) or number == signal.SIGKILL, told
    names = {path.name for path in ended.out.iterdir()}
    for path in ended.out.glob("*.json"):
        json.loads(path.read_text(encoding="utf-8"))
    for path in ended.out.glob("*.nc"):
        gl.load_dataset(path)
    if not again and number != signal.SIGKILL:
        pairs = {stem: {f"{stem}.nc" in names, f"{stem}.json" in names} for stem in ("sweep", "map", "zones")}
        assert all(len(both) == 1 for both in pairs.values()), (told, names)


@pytest.mark.parametrize("seed", range(4))
def test_a_hundred_signals(tmp_path: Path, seed: int):
    """Over all commands, at any moment from the first import on."""
    rng = random.Random(seed)
    for turn in range(26):
        name = list(COMMANDS)[(turn + 3 * seed) % len(COMMANDS)]
        number = rng.choice(
            [signal.SIGINT, signal.SIGTERM, signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL]
        )
        again = number in (signal.SIGINT, signal.SIGTERM) and rng.random() < 0.25
        delay = rng.uniform(0.02, 2.5)
        ended = _signalled(name, number, delay, tmp_path / f"{name}-{turn}", rng.choice([1, 2]), again)
        _check(name, number, ended, again)


@pytest.mark.parametrize("workers", [1, 2])
@pytest.mark.parametrize("name", ["sweep", "map", "zones", "reproduce"])
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["SIGINT", "SIGTERM"])
def test_what_was_computed_is_kept(tmp_path: Path, name: str, workers: int, number: int):
    stem = {"reproduce": "sweep-omega"}.get(name, name)
    for delay in (2.5, 8.0, 25.0):  # a busy machine takes long to begin
        out = tmp_path / f"after {delay} s"
        ended = _signalled(name, number, delay, out, workers)
        _check(name, number, ended, again=False)
        assert not ended.finished
        if not (out / f"{stem}.nc").exists():
            continue
        assert ended.code == CODES[signal.Signals(number)]
        dataset = gl.load_dataset(out / f"{stem}.nc")
        assert dataset.attrs["complete"] == 0
        if (dataset["status"].values != dataset["status"].values.ravel()[-1]).any():
            break
    else:
        pytest.fail(f"{name} kept nothing in 25 s")
    answer = json.loads((ended.out / f"{stem}.json").read_text(encoding="utf-8"))
    assert answer["status"] == "incomplete"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_while_kernels_are_compiled(tmp_path: Path, number: int):
    ended = _signalled("run", number, 3.0, tmp_path / "out", cache=tmp_path / "cache")
    _check("run", number, ended, again=False)
    assert ended.code in (CODES[signal.Signals(number)], -number)


def test_a_signal_to_the_whole_group_counts_once(tmp_path: Path):
    """As `timeout` sends it: to the process, and to its group at once."""
    process = subprocess.Popen(
        ["timeout", "-s", "TERM", "6", sys.executable, "-c", "from gearlash.cli import main; main()",
         *COMMANDS["sweep"], "--out", str(tmp_path / "out")],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    said, _ = process.communicate(timeout=60)
    assert process.returncode == 124, said
    assert re.search("keeping what was computed", said)
    assert gl.load_dataset(tmp_path / "out" / "sweep.nc").attrs["complete"] == 0
