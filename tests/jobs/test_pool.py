"""Worker processes: how they begin, how they end, and that they hold nothing of the caller's."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from gearlash.jobs import Chain, Execution, NoWorkersError, Pool, open_executor, run
from gearlash.jobs.pool import WorkerDiedError
from jobs.tasks import (
    broken_beginning,
    deadly_beginning,
    deaf,
    die,
    fail,
    hand_on,
    nested,
    running_sum,
    slow,
    stubborn,
    talkative,
)

TESTS = str(Path(__file__).parents[1])
POSIX = pytest.mark.skipif(os.name == "nt", reason="sends signals")


def chain(name, *tasks) -> Chain:
    return Chain(name, tuple(tasks), tuple(len(task) for task in tasks), None)


def python(*arguments: str, text: str | None = None, cwd: Path | None = None, timeout: float = 60.0):
    """A Python of its own; its exit code, standard output and error."""
    path = os.pathsep.join([TESTS, os.environ.get("PYTHONPATH", "")])
    return subprocess.run(
        [sys.executable, *arguments],
        input=text,
        capture_output=True,
        text=True,
        cwd=cwd,
        timeout=timeout,
        env={**os.environ, "PYTHONPATH": path},
        check=False,
    )


def alive(pid: int) -> bool:
    """Is there such a process (one that only waits to be reaped is not)?"""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def test_what_a_worker_prints_goes_nowhere(capfd: pytest.CaptureFixture[str]):
    with open_executor(2) as executor:
        outcome = run(talkative, [chain(i, (i,)) for i in range(4)], Execution(executor))
    assert outcome.results == {i: (i,) for i in range(4)}
    assert capfd.readouterr() == ("", "")


def test_a_defect_says_where_it_was():
    with open_executor(2) as executor, pytest.raises(ZeroDivisionError) as caught:
        run(fail, [chain("a", (1,))], Execution(executor))
    assert "in fail" in caught.value.__notes__[0]


def test_results_for_one_waiting_executor_in_the_usual_way():
    with open_executor(2) as executor:
        assert list(executor.map(pow, range(6), [2] * 6)) == [0, 1, 4, 9, 16, 25]
        futures = [executor.submit(divmod, 7, 2), executor.submit(divmod, 7, 0)]
        assert futures[0].result() == (3, 1)
        with pytest.raises(ZeroDivisionError):
            futures[1].result()
    with pytest.raises(RuntimeError, match="shutdown"):
        executor.submit(divmod, 7, 2)


@pytest.mark.parametrize(("begin", "why"), [(broken_beginning, "no beginning"), (deadly_beginning, "died")])
def test_workers_that_cannot_begin_are_not_started_for_ever(begin, why: str):
    with Pool(2, begin) as executor, pytest.raises(NoWorkersError, match=why):
        run(running_sum, [chain(i, (i,)) for i in range(20)], Execution(executor))


def test_workers_that_die_before_anything_was_computed_raise():
    with open_executor(2) as executor, pytest.raises(NoWorkersError, match="died"):
        run(die, [chain(0, (13,))], Execution(executor))


def test_a_pool_of_which_one_worker_was_killed_goes_on_with_others():
    with open_executor(2) as executor:
        assert "died" in run(die, [chain(i, (i,)) for i in range(20)], Execution(executor)).reason
        assert run(running_sum, [chain("a", (1, 2))], Execution(executor)).results == {"a": (1, 3)}


def test_points_before_one_that_takes_long_are_kept():
    """The long one is interrupted soon after the stop."""
    cancel = threading.Event()
    with open_executor(2) as executor:
        run(running_sum, [chain("warm", (1,))], Execution(executor))
        threading.Timer(0.2, cancel.set).start()
        outcome = run(stubborn, [chain("a", (0, 1, 2))], Execution(executor, cancel=cancel))
    assert outcome.results == {"a": (0, 1)}
    assert outcome.reason == "cancelled"


def test_a_study_within_a_task_hands_a_stop_on():
    """What rests on an incomplete one would be wrong: the task has nothing."""
    cancel = threading.Event()
    with open_executor(2) as executor:
        run(running_sum, [chain("warm", (1,))], Execution(executor))
        threading.Timer(0.2, cancel.set).start()
        outcome = run(nested, [chain("a", (0,))], Execution(executor, cancel=cancel))
    assert outcome.results == {"a": ()}
    assert outcome.reason == "cancelled"


def test_a_task_that_hears_nothing_is_given_up():
    cancel = threading.Event()
    chains = [chain("deaf", (1,)), chain("quick", (2,))]
    with open_executor(2) as executor:
        run(running_sum, chains, Execution(executor))
        outcome = run(deaf, chains, Execution(executor, progress=lambda p: cancel.set(), cancel=cancel))
        assert outcome.results == {"deaf": (), "quick": (2,)}
        assert run(running_sum, [chain("after", (1,))], Execution(executor)).complete


HASTY = """
import time
from gearlash.jobs import Chain, Execution, Pool, run
from jobs.tasks import deaf

class Hasty(Pool):
    def submit(self, fn, /, *args, **kwargs):
        future = super().submit(fn, *args, **kwargs)
        if fn is pow:
            return future
        time.sleep(0.3)
        raise KeyboardInterrupt

with Hasty(1) as executor:
    executor.submit(pow, 2, 2).result()
    outcome = run(deaf, [Chain("a", ((1,),), (1,))], Execution(executor))
print(outcome)
"""


def test_a_stop_that_comes_while_a_task_is_handed_over_ends_it_too():
    """When the task was taken, and its future is not yet known to who waits for it."""
    assert python("-c", HASTY, timeout=60.0).stdout == "Outcome(results={'a': ()}, reason='interrupted')\n"


WITHIN_A_LOCK = """
import signal, sys, threading
from gearlash.jobs import Chain, Execution, open_executor, run
from jobs.tasks import deaf

enter, left = threading.Condition.__enter__, [-1]

def entered(condition):
    taken = enter(condition)
    if threading.get_ident() == threading.main_thread().ident and left[0] >= 0:
        left[0] -= 1
        if left[0] < 0:
            signal.raise_signal(signal.SIGINT)
    return taken

with open_executor(2) as executor:
    run(deaf, [Chain(i, ((2,),), (1,)) for i in range(4)], Execution(executor))
    threading.Condition.__enter__ = entered
    threading.Timer(0.5, left.__setitem__, (0, int(sys.argv[1]))).start()
    print(run(deaf, [Chain(i, ((1,),), (1,)) for i in range(2)], Execution(executor)).reason)
"""


@POSIX
@pytest.mark.parametrize("lock", range(4))
def test_ctrl_c_in_the_middle_of_a_wait_for_threads_leaves_no_lock_taken(lock: int):
    """Python's `wait` takes a lock for each future, and that of an event, ever again."""
    ran = python("-c", WITHIN_A_LOCK, str(lock))
    assert ran.stdout == "interrupted\n", ran.stderr


def test_what_is_given_up_while_a_worker_takes_it_is_not_begun(monkeypatch: pytest.MonkeyPatch):
    begin = Future.set_running_or_notify_cancel
    with Pool(1) as executor:
        assert executor.submit(pow, 2, 2).result() == 4

        def given_up(future):
            executor.abandon()
            return begin(future)

        monkeypatch.setattr(Future, "set_running_or_notify_cancel", given_up)
        with pytest.raises(WorkerDiedError, match="given up"):
            executor.submit(pow, 2, 3).result(timeout=20.0)
        monkeypatch.undo()
        assert executor.submit(pow, 2, 4).result() == 16


PARENT = """
import sys
from gearlash.jobs import Chain, Execution, open_executor, run
from jobs.tasks import {work}, hand_on

with open_executor(2) as executor:
    found = run(hand_on, [Chain(i, (tuple(range(3)),), (3,)) for i in range(6)], Execution(executor))
    print(*{{pid for got in found.results.values() for pid in got}}, flush=True)
    run({work}, [Chain(i, (tuple(range(3000)),), (3000,)) for i in range(2)], Execution(executor))
"""


@POSIX
@pytest.mark.parametrize("work", ["slow", "deaf"])
@pytest.mark.parametrize("ending", ["SIGKILL", "SIGTERM", "SIGINT"])
def test_workers_end_with_the_process_that_started_them(ending: str, work: str):
    """Whatever ends it and whatever they are at; and its reader sees the end of the pipe with it."""
    process = subprocess.Popen(
        [sys.executable, "-c", PARENT.format(work=work)],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([TESTS, os.environ.get("PYTHONPATH", "")])},
    )
    assert process.stdout is not None
    workers = [int(pid) for pid in process.stdout.readline().split()]
    assert workers
    time.sleep(0.2)
    process.send_signal(getattr(signal, ending))
    try:
        assert process.communicate(timeout=20.0) == ("", None)
    finally:  # no other test is to meet what this one left
        process.kill()
        process.stdout.close()
        process.wait()
    until = time.monotonic() + 10.0
    while any(map(alive, workers)) and time.monotonic() < until:
        time.sleep(0.02)
    assert not any(map(alive, workers))


FAMILY = """
import numpy as np

import gearlash as gl


def build(p):
    matrix = np.array([[0.0, 1.0], [-1.0, -2.0 * 0.05]])
    forcing = np.array([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    h, g = np.array([1.0, 0.0]), np.array([0.0, -1.0])
    rule = gl.ContactRule.ALWAYS
    stop = gl.Clearance(h, g, p["gap"], 100.0, np.array([8.0]), np.array([0.0]), contact=rule)
    return gl.System(0.8, matrix, forcing, (stop,))


def cold_start(p):
    return np.zeros(2)


family = gl.Family((gl.Parameter("gap", 0.2),), ("x", "v"), build, cold_start=cold_start)
axis = gl.Axis.even("gap", 0.0, 3.0, 9)
"""
SWEEP = """
with gl.open_workers(family, 2) as workers:
    print([point.label for point in gl.sweep(family, axis, execution=gl.Execution(workers)).points])
"""
GUARDED = "\nif __name__ == '__main__':" + SWEEP.replace("\n", "\n    ")
CASE = """
import gearlash as gl
with gl.open_workers(gl.load_case("article"), 2) as workers:
    axis = gl.Axis.even("omega", 1.0, 1.1, 5)
    found = gl.sweep(gl.load_case("article"), axis, execution=gl.Execution(workers))
print([point.label for point in found.points])
"""


@pytest.mark.parametrize("way", ["script without a guard", "standard input", "-c", "lambda"])
def test_a_family_that_workers_cannot_get_is_refused_in_words(way: str, tmp_path: Path):
    script = tmp_path / "study.py"
    script.write_text(FAMILY + SWEEP, encoding="utf-8")
    if way == "standard input":
        ran = python("-", text=FAMILY + SWEEP)
    elif way == "-c":
        ran = python("-c", FAMILY + SWEEP)
    elif way == "lambda":
        script.write_text(
            FAMILY.replace("cold_start=cold_start", "cold_start=lambda p: np.zeros(2)") + GUARDED
        )
        ran = python(str(script))
    else:
        ran = python(str(script))
    assert ran.returncode == 1
    assert ran.stdout == ""
    assert ran.stderr.count("Traceback") == 1
    last = ran.stderr.splitlines()[-1]
    assert "GearlashError: this family cannot be sent to worker processes" in last
    assert "workers=1" in last


def test_a_family_of_a_script_with_a_guard_is_computed_by_workers(tmp_path: Path):
    (tmp_path / "study.py").write_text(FAMILY + GUARDED, encoding="utf-8")
    (tmp_path / "alone.py").write_text(FAMILY + GUARDED.replace("family, 2", "family, 1"), encoding="utf-8")
    ran = python(str(tmp_path / "study.py"))
    assert (ran.returncode, ran.stderr) == (0, "")
    assert ran.stdout == python(str(tmp_path / "alone.py")).stdout
    module = python("-m", "study", cwd=tmp_path)
    assert (module.stdout, module.stderr) == (ran.stdout, "")


@pytest.mark.parametrize("way", ["script without a guard", "standard input", "-c"])
def test_a_case_needs_no_guard(way: str, tmp_path: Path):
    script = tmp_path / "study.py"
    script.write_text(CASE, encoding="utf-8")
    arguments = {"standard input": ["-"], "-c": ["-c", CASE]}.get(way, [str(script)])
    ran = python(*arguments, text=CASE if arguments == ["-"] else None)
    assert (ran.returncode, ran.stderr) == (0, "")
    assert ran.stdout.count("-") == 10


def test_a_family_of_a_module_in_the_current_folder_is_found(tmp_path: Path):
    (tmp_path / "model.py").write_text(FAMILY, encoding="utf-8")
    (tmp_path / "pickle.py").write_text("raise RuntimeError('code of the current folder')", encoding="utf-8")
    ran = python("-c", "from model import *" + SWEEP, cwd=tmp_path)
    assert "code of the current folder" in ran.stderr  # Python itself looks there first, for the caller
    (tmp_path / "pickle.py").unlink()
    ran = python("-c", "from model import *" + SWEEP, cwd=tmp_path)
    assert (ran.returncode, ran.stderr) == (0, "")


def test_a_script_that_only_seems_guarded_starts_no_workers_of_workers(tmp_path: Path):
    text = FAMILY + "print(__name__)\n" + SWEEP
    (tmp_path / "study.py").write_text(text, encoding="utf-8")
    ran = python(str(tmp_path / "study.py"))
    assert ran.returncode == 1
    assert ran.stdout == "__main__\n"
    assert "a worker process starts no workers" in ran.stderr.splitlines()[-1]


def test_threads_of_one_pool_do_not_mix_up_answers():
    with open_executor(2) as executor:
        numbers = list(range(200))
        assert list(executor.map(abs, numbers)) == numbers
        found = run(hand_on, [chain(i, (0,)) for i in range(40)], Execution(executor)).results
        assert len({pid for got in found.values() for pid in got}) <= 2


def test_a_stop_is_taken_back_before_new_work():
    cancel = threading.Event()
    with open_executor(2) as executor:
        run(slow, [chain(i, tuple(range(100))) for i in range(3)], Execution(
            executor, cancel=cancel, progress=lambda p: cancel.set()))  # fmt: skip
        assert run(slow, [chain("a", (1, 2, 3))], Execution(executor)).results == {"a": (1, 2, 3)}


def test_executors_of_others_are_refused_in_words():
    """A family that does not pickle for processes of the standard library; executors that were shut down."""
    family = gl.Family((gl.Parameter("omega", 0.8),), ("x", "v"), lambda p: None, lambda p: None)  # pyright: ignore[reportArgumentType]
    axis = gl.Axis("omega", np.array([0.8]))
    with ProcessPoolExecutor(1) as executor, pytest.raises(gl.GearlashError, match="cannot be sent"):
        gl.sweep(family, axis, execution=gl.Execution(executor))
    ended: tuple[Executor, ...] = (ThreadPoolExecutor(1), Pool(2))
    for executor in ended:
        executor.shutdown()
        with pytest.raises(NoWorkersError, match="open another one"):
            gl.sweep(gl.load_case("kahraman-singh"), axis, execution=gl.Execution(executor))


def test_workers_take_warnings_as_their_parent_does():
    script = (
        "import warnings, sys\nfrom gearlash.jobs import open_executor\n"
        "with open_executor(2) as workers:\n"
        "    print(workers.submit(eval, '__debug__').result())\n"
        "    print(workers.submit(warnings.warn, 'w').exception())"
    )
    ran = python("-O", "-W", "error::UserWarning", "-c", script)
    assert (ran.stdout, ran.stderr) == ("False\nw\n", "")
