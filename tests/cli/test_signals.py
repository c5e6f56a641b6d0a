"""Signals at random moments: what was computed is kept, whole, and nothing is left running."""

from __future__ import annotations

import itertools
import json
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import gearlash as gl
from cli.signalled import (
    CODES,
    COMMANDS,
    KEEPS,
    MARK,
    PATIENCE,
    PROGRAM,
    Ended,
    Sent,
    any_signal,
    check,
    signalled,
    still_running,
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="processes are looked for in /proc"),
]

SIGNALS = 52  # a seed
AT_ONCE = max(2, os.cpu_count() or 1)
LATER = (1.5, 4.0, 10.0, 25.0, 60.0)  # s: a busy machine takes long to begin


@pytest.fixture(scope="module", autouse=True)
def _warm() -> None:
    """Kernels are compiled before, but where the compiling itself is interrupted."""
    program = "import gearlash.flow, gearlash._kernel as kernel; kernel.compile_all(kernel.load_all())"
    subprocess.run([sys.executable, "-c", program], check=True, capture_output=True)


@pytest.mark.parametrize("seed", [0, 1])
def test_a_hundred_signals(tmp_path: Path, seed: int):
    """Over all commands, at any moment from the first import on; those that had ended before do not count."""
    rng = random.Random(seed)
    names = itertools.cycle(sorted(COMMANDS, key=lambda _: rng.random()))
    ended: list[Ended] = []
    with ThreadPoolExecutor(AT_ONCE) as threads:
        while (missing := SIGNALS - len(ended)) > 0:
            sent = [any_signal(rng, next(names)) for _ in range(missing)]
            places = [tmp_path / f"{one.name}-{len(ended)}-{i}" for i, one in enumerate(sent)]
            ended += [each for each in threads.map(signalled, sent, places) if not each.finished]
    for each in ended:
        check(each)
    lost = [(each.lost, each.told) for each in ended if each.lost]
    left = [(each.left, each.told) for each in ended if each.left]
    assert (len(lost), len(left)) == (0, 0), [*lost, *left]
    assert {each.sent.name for each in ended} == set(COMMANDS)


def _kept(name: str, number: int, workers: int, folder: Path) -> Iterator[Ended]:
    """The command, stopped later and later until it has something to keep."""
    for delay in LATER:
        ended = signalled(Sent(name, number, delay, workers), folder / f"after {delay} s")
        check(ended)
        assert (ended.lost, ended.left, ended.finished) == ([], [], False), ended.told
        if KEEPS in ended.said:
            yield ended


@pytest.mark.parametrize(("number", "workers"), [(signal.SIGINT, 1), (signal.SIGTERM, 2)])
@pytest.mark.parametrize("name", ["sweep", "map", "zones", "reproduce"])
def test_what_was_computed_is_kept(tmp_path: Path, name: str, workers: int, number: int):
    stem = {"reproduce": "sweep-omega"}.get(name, name)
    for ended in _kept(name, number, workers, tmp_path):
        if not (ended.out / f"{stem}.nc").exists():
            continue
        assert ended.code == CODES[signal.Signals(number)]
        dataset = gl.load_dataset(ended.out / f"{stem}.nc")
        answer = json.loads((ended.out / f"{stem}.json").read_text(encoding="utf-8"))
        assert (dataset.attrs["complete"], answer["status"]) == (0, "incomplete")
        if (dataset["status"].values != dataset["status"].values.ravel()[-1]).any():
            return
    pytest.fail(f"{name} kept nothing")


@pytest.mark.parametrize(("number", "workers"), [(signal.SIGINT, 1), (signal.SIGTERM, 2)])
def test_a_tolerance_study_says_that_only_a_part_was_tried(tmp_path: Path, workers: int, number: int):
    for ended in _kept("tolerance", number, workers, tmp_path):
        if not (ended.out / "tolerance.json").exists():
            continue
        assert ended.code == CODES[signal.Signals(number)]
        answer = json.loads((ended.out / "tolerance.json").read_text(encoding="utf-8"))
        assert answer["status"] == "incomplete"
        assert (ended.out / "tolerance.csv").exists()
        assert (ended.out / "tolerance.pdf").exists()
        picture = (ended.out / "tolerance.svg").read_text(encoding="utf-8")
        assert f"incomplete: stopped when {answer['tried']} combinations were done" in picture
        return
    pytest.fail("no tolerance study was kept")


@pytest.mark.parametrize(("number", "workers"), [(signal.SIGINT, 1), (signal.SIGTERM, 2)])
def test_a_report_is_made_of_what_was_computed(tmp_path: Path, workers: int, number: int):
    """Once the verdict stands: a page, the answer, and the names of what is not in it."""
    for delay in LATER:
        ended = signalled(Sent("report", number, delay, workers), tmp_path / f"after {delay} s")
        check(ended)
        assert (ended.lost, ended.left, ended.finished) == ([], [], False), ended.told
        assert ended.code == CODES[signal.Signals(number)]
        answer = ended.out / "verdict.json"
        if not answer.exists():
            assert not (ended.out / "report.html").exists()
            continue
        content = json.loads(answer.read_text(encoding="utf-8"))
        stopped = "was stopped" in content["sentence"]  # before all starts at the present speed were tried
        assert (content["status"], content["verdict"]) == ("incomplete", "doubt" if stopped else "good")
        assert "the map over backlash" in content["missing"]
        page = (ended.out / "report.html").read_text(encoding="utf-8")
        assert "The report was stopped early; not computed:" in page
        assert page.rstrip().endswith("</html>")
        return
    pytest.fail("no report was kept")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_while_kernels_are_compiled(tmp_path: Path, number: int):
    ended = signalled(Sent("run", number, 2.5), tmp_path / "out", cache=tmp_path / "cache")
    check(ended)
    assert (ended.lost, ended.left) == ([], [])
    assert ended.code in (CODES[signal.Signals(number)], -number)


def test_a_signal_to_the_whole_group_counts_once(tmp_path: Path):
    """As `timeout` sends it: to the process, and to its group at once."""
    process = subprocess.Popen(
        ["timeout", "-s", "TERM", "6", sys.executable, "-c", PROGRAM,
         *COMMANDS["sweep"], "--workers", "1", "--out", str(tmp_path / "out")],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    said, _ = process.communicate(timeout=60)
    assert process.returncode == 124, said
    assert KEEPS in said
    assert gl.load_dataset(tmp_path / "out" / "sweep.nc").attrs["complete"] == 0


def test_nobody_reads_what_is_shown(tmp_path: Path):
    """The pipe is full: files are there, and the command ends all the same."""
    out = tmp_path / "out"
    process = subprocess.Popen(
        [sys.executable, "-c", PROGRAM, *COMMANDS["sweep"], "--json", "--workers", "1", "--out", str(out)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip
    with process:
        time.sleep(6.0)
        process.send_signal(signal.SIGINT)
        assert process.wait(PATIENCE) == 130
    assert (out / "sweep.json").stat().st_size > 70_000  # more than a pipe holds
    assert gl.load_dataset(out / "sweep.nc").attrs["complete"] == 0


def _workers_of(pid: int) -> list[int]:
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            parent = int((process / "stat").read_text().rpartition(")")[2].split()[1])
            if parent == pid and b"gearlash.jobs.worker" in (process / "cmdline").read_bytes():
                found.append(int(process.name))
        except OSError:
            continue
    return found


@pytest.mark.parametrize("name", ["sweep", "reproduce"])
def test_a_killed_worker_is_no_ctrl_c(tmp_path: Path, name: str):
    """One that is killed while it starts is done without, so there is another one killed after it."""
    process = subprocess.Popen(
        [sys.executable, "-c", PROGRAM, *COMMANDS[name], "--workers", "2", "--out", str(tmp_path / "out")],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    until = time.monotonic() + 60.0
    while process.poll() is None and time.monotonic() < until:
        time.sleep(2.0)
        for worker in _workers_of(process.pid)[:1]:
            os.kill(worker, signal.SIGKILL)
    said, _ = process.communicate(timeout=1.0)
    assert process.returncode == 5, said
    assert "Traceback" not in said
    stem = {"reproduce": "sweep-omega"}.get(name, name)
    if (tmp_path / "out" / f"{stem}.nc").exists():  # else nothing was computed yet
        answer = json.loads((tmp_path / "out" / f"{stem}.json").read_text(encoding="utf-8"))
        assert answer["status"] == "incomplete"
        assert "died" in answer["sweeps"][0]["message"] + answer["sweeps"][1]["message"]


def test_what_is_timed_ends_with_who_times_it(tmp_path: Path):
    program = "from benchmarks.startup import _process; _process('import time; time.sleep(60)')"
    mark = f"{os.getpid()}-timed"
    env = {**os.environ, MARK: mark}
    root = Path(__file__).resolve().parents[2]
    process = subprocess.Popen([sys.executable, "-c", program], env=env, cwd=root)
    until = time.monotonic() + 30.0
    while len(_children(process.pid)) < 1 and time.monotonic() < until:
        time.sleep(0.1)
    assert _children(process.pid)
    process.kill()
    process.wait()
    assert still_running(mark) == []


def _children(pid: int) -> list[str]:
    return (Path("/proc") / str(pid) / "task" / str(pid) / "children").read_text().split()


STUDY = """
import signal
import gearlash as gl
signal.signal(signal.SIGINT, signal.default_int_handler)
case = gl.load_case("kahraman-singh")
told = []

def tell(progress):
    if not told and progress.done > 20:
        told.append(print("begun", flush=True))

with gl.open_workers(case, {workers}) as executor:
    execution = gl.Execution(executor, progress=tell)
    found = gl.zones(case, gl.Axis.even("omega", 0.5, 1.4, 2001), execution=execution)
computed = sum(sweep.computed for sweep in found.sweeps)
print(found.complete, found.message, 20 < computed < 6003)
"""


@pytest.mark.parametrize("workers", [1, 2])
@pytest.mark.parametrize("way", ["script without a guard", "standard input"])
def test_ctrl_c_in_a_script(tmp_path: Path, way: str, workers: int):
    """To every process of the group, as a terminal sends it: the study ends with what it has."""
    script = tmp_path / "study.py"
    script.write_text(STUDY.format(workers=workers), encoding="utf-8")
    with script.open() as source:
        process = subprocess.Popen(
            [sys.executable, "-" if way == "standard input" else str(script)], stdin=source,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
        )  # fmt: skip
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    os.killpg(process.pid, signal.SIGINT)
    said, _ = process.communicate(timeout=PATIENCE)
    assert (process.returncode, said) == (0, "False interrupted True\n")
