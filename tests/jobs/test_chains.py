"""Chains of tasks: order, what is handed on, and every way to end early."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from gearlash.jobs import Chain, Execution, Inline, Pool, open_executor, run
from gearlash.system import GearlashError
from jobs.tasks import die, fail, hand_on, running_sum, slow


def chain(name, *tasks, first=None) -> Chain:
    return Chain(name, tuple(tasks), tuple(len(task) for task in tasks), first)


CHAINS = [chain("a", (1, 2), (3,), (4, 5)), chain("b", (10,), first=100), chain("c")]
SUMS = {"a": (1, 3, 6, 10, 15), "b": (110,), "c": ()}


def test_tasks_of_a_chain_get_what_the_one_before_handed_on():
    outcome = run(running_sum, CHAINS)
    assert outcome.results == SUMS
    assert outcome.complete


def test_threads_and_processes_give_the_same():
    with ThreadPoolExecutor(4) as threads:
        assert run(running_sum, CHAINS, Execution(threads)).results == SUMS
    with open_executor(2) as processes:
        assert run(running_sum, CHAINS, Execution(processes)).results == SUMS
        assert run(running_sum, CHAINS, Execution(processes)).results == SUMS


def test_processes_are_others():
    with open_executor(2) as executor:
        outcome = run(hand_on, [chain(i, (1,)) for i in range(6)], Execution(executor))
    assert os.getpid() not in {pid for got in outcome.results.values() for pid in got}
    assert outcome.complete


def test_progress_counts_points_up_to_all():
    seen = []
    run(running_sum, CHAINS, Execution(progress=seen.append))
    assert [p.done for p in seen] == [2, 3, 5, 6]
    assert {p.total for p in seen} == {6}
    assert seen[-1].remaining == 0.0
    assert seen[-1].share == 1.0


def test_a_defect_is_raised_and_nothing_more_begun():
    with pytest.raises(ZeroDivisionError):
        run(fail, CHAINS)
    with ThreadPoolExecutor(1) as threads, pytest.raises(ZeroDivisionError):
        run(fail, CHAINS, Execution(threads))


def test_cancel_before_the_start_computes_nothing():
    cancel = threading.Event()
    cancel.set()
    outcome = run(running_sum, CHAINS, Execution(cancel=cancel))
    assert outcome.results == {"a": (), "b": (), "c": ()}
    assert outcome.reason == "cancelled"


@pytest.mark.parametrize("workers", [1, 2])
def test_cancel_keeps_beginnings_of_chains(workers):
    cancel = threading.Event()
    chains = [chain(name, *(tuple(range(i, i + 5)) for i in range(0, 200, 5))) for name in "ab"]
    with open_executor(workers) as executor:
        execution = Execution(executor, progress=lambda p: p.done >= 10 and cancel.set(), cancel=cancel)
        outcome = run(slow, chains, execution)
    assert outcome.reason == "cancelled"
    got = [outcome.results[name] for name in "ab"]
    assert 10 <= sum(map(len, got)) < 100
    assert all(numbers == tuple(range(len(numbers))) for numbers in got)


def test_a_task_asked_to_stop_returns_its_beginning():
    """200 points of 20 ms are one task; cancelled at once, it ends long before them."""
    cancel = threading.Event()
    chains = [chain("short", (0,)), chain("long", tuple(range(200)))]
    with open_executor(2) as executor:
        outcome = run(slow, chains, Execution(executor, progress=lambda p: cancel.set(), cancel=cancel))
        assert len(outcome.results["long"]) < 200
        again = run(slow, [chain("short", (0, 1))], Execution(executor))
    assert again.results == {"short": (0, 1)}


def test_a_killed_worker_loses_only_what_was_at_work():
    chains = [chain(i, (i,)) for i in range(40)]
    with open_executor(2) as executor:
        outcome = run(die, chains, Execution(executor))
    assert "died" in outcome.reason
    assert outcome.results[13] == ()
    assert all(got in ((), (i,)) for i, got in outcome.results.items())
    assert sum(map(len, outcome.results.values())) >= 8


SCRIPT = """
from gearlash.jobs import Chain, Execution, open_executor, run
from jobs.tasks import slow

if __name__ == "__main__":
    chains = [Chain(i, (tuple(range(50)),), (50,)) for i in range(20)]
    with open_executor(2) as executor:
        outcome = run(slow, chains, Execution(executor, progress=lambda p: print("begun", flush=True)))
    print(outcome.reason, sum(map(len, outcome.results.values())))
"""


@pytest.mark.skipif(os.name == "nt", reason="sends SIGINT to a process group")
def test_ctrl_c_on_the_whole_group_ends_clean_with_what_was_computed(tmp_path):
    """As a terminal does it: every process of the group gets the signal."""
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    tests = str(Path(__file__).parents[1])
    process = subprocess.Popen(
        [sys.executable, str(script)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([tests, os.environ.get("PYTHONPATH", "")])},
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=60)
    reason, points = out.split("\n")[-2].split()
    assert reason == "interrupted"
    assert 50 <= int(points) < 1000
    assert err == ""
    assert process.returncode == 0


def test_who_does_the_work():
    assert isinstance(open_executor(0), Inline)
    assert isinstance(open_executor(1), Inline)
    with open_executor(3) as pool:
        assert isinstance(pool, Pool)
        assert pool.workers == 3
    with pytest.raises(GearlashError, match="expected a whole number, 0 to"):
        open_executor(-1)
