"""Several first runs at once: one compiles, the others say that they wait, and take what it made."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from gearlash._kernel import cache as kept
from gearlash._kernel.waiting import LOCK, one_at_a_time
from kernel.tiny import PROGRAM, write

pytestmark = pytest.mark.skipif(os.name != "posix", reason="locks and signals of POSIX")


Start = Callable[..., subprocess.Popen[str]]


@pytest.fixture
def start(tmp_path: Path) -> Iterator[Start]:
    """Starts programs with the tiny package and one cache; what is left of them is ended."""
    folder, processes = write(tmp_path), []

    def started(program: str = PROGRAM) -> subprocess.Popen[str]:
        env = {"PYTHONPATH": str(folder), "GEARLASH_CACHE_DIR": str(folder / "cache"), "GEARLASH_QUIET": ""}
        process = subprocess.Popen(
            [sys.executable, "-c", program],
            env={**os.environ, **env, "NUMBA_DISABLE_JIT": "0"},
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        )  # fmt: skip
        processes.append(process)
        return process

    yield started
    for process in processes:
        if process.poll() is None:
            process.kill()
            process.communicate()


HOLDING = """
import sys, time
import tiny._caller
from tiny._kernel.waiting import one_at_a_time
with one_at_a_time(print):
    print("held", flush=True)
    {then}
"""


def test_of_three_first_runs_one_compiles(start: Start):
    held = start(HOLDING.format(then="sys.stdin.readline()"))
    assert held.stdout is not None
    assert held.stdout.readline() == "held\n"
    runs = [start() for _ in range(3)]
    for run in runs:
        assert run.stderr is not None
        assert run.stderr.readline() == "gearlash: another run is compiling the kernels; waiting for it\n"
    assert held.communicate("compiled nothing\n", timeout=60)[1] == ""
    said = [run.communicate(timeout=120) for run in runs]
    assert [out.split()[0] for out, _ in said] == ["21.0"] * 3
    assert "".join(error for _, error in said).count("compiled in") == 1


def test_a_run_that_was_killed_holds_nobody_up(start: Start):
    held = start(HOLDING.format(then="time.sleep(600)"))
    assert held.stdout is not None
    assert held.stdout.readline() == "held\n"
    held.send_signal(signal.SIGKILL)
    held.communicate(timeout=60)
    out, error = start().communicate(timeout=120)
    assert out.split()[0] == "21.0"
    assert "waiting" not in error


def test_who_waits_can_be_interrupted(start: Start):
    held = start(HOLDING.format(then="time.sleep(600)"))
    assert held.stdout is not None
    assert held.stdout.readline() == "held\n"
    run = start()
    assert run.stderr is not None
    assert "waiting" in run.stderr.readline()
    time.sleep(0.2)
    run.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in run.communicate(timeout=60)[1]


def test_what_a_killed_run_left_is_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(tmp_path / "cache"))
    folder = kept.version_folder()
    kept.make_version(folder)
    (folder / "unfinished-0123.kernel").touch()
    (folder / "unfinished-4567" / "tiny").mkdir(parents=True)
    (folder / "unfinished-4567" / "tiny" / "some.nbi").touch()
    (folder / "some.kernel").touch()
    with one_at_a_time(lambda: pytest.fail("nobody else is there")):
        assert {file.name for file in folder.iterdir()} == {LOCK, "some.kernel"}


def test_no_lock_where_nothing_can_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(tmp_path / "cache"))
    with one_at_a_time(lambda: pytest.fail("nobody else is there")):
        assert (kept.version_folder() / LOCK).stat().st_mode & 0o777 == 0o600
    (tmp_path / "file").touch()
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(tmp_path / "file" / "cache"))
    with one_at_a_time(lambda: pytest.fail("nobody can hold it")):
        pass
