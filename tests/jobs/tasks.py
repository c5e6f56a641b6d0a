"""Work for the tests of jobs, where worker processes can import it."""

from __future__ import annotations

import os
import signal
import sys
import time

from gearlash.jobs import Chain, Part, handing_on, run, stopping


def running_sum(task, carry) -> Part:
    """Adds the numbers of a task to what was handed on."""
    total, found = carry or 0, []
    for number in task:
        total += number
        found.append(total)
    return Part(tuple(found), total)


def slow(task, carry) -> Part:
    """A point per 20 ms, until asked to stop."""
    found = []
    for number in task:
        if stopping():
            break
        time.sleep(0.02)
        found.append(number)
    return Part(tuple(found), None)


def die(task, carry) -> Part:
    """A worker that is killed at the number 13."""
    if 13 in task:
        os.kill(os.getpid(), signal.SIGKILL)
    return Part(tuple(task), None)


def fail(task, carry) -> Part:
    """A defect."""
    raise ZeroDivisionError("a defect")


def hand_on(task, carry) -> Part:
    """The process id, to see who worked."""
    return Part(tuple(os.getpid() for _ in task), None)


def stubborn(task, carry) -> Part:
    """Two points quickly, then one that takes a minute and never looks up."""
    found = []
    with handing_on(lambda: Part(tuple(found))):
        for number in task:
            if number == 2:
                until = time.monotonic() + 60.0
                while time.monotonic() < until:
                    sum(range(1000))
            found.append(number)
    return Part(tuple(found))


def deaf(task, carry) -> Part:
    """One long call that nothing interrupts but the end of the process."""
    for number in task:
        while number == 1:
            try:
                time.sleep(60.0)
            except KeyboardInterrupt:
                continue
    return Part(tuple(task))


def nested(task, carry) -> Part:
    """Work that rests on a study of its own, which takes a minute."""
    within = run(stubborn, [Chain("within", (tuple(range(4)),), (4,))])
    return Part(tuple(len(within.results["within"]) for _ in task))


def talkative(task, carry) -> Part:
    """Prints, and writes past Python."""
    print("a word on standard output", flush=True)
    print("a word on standard error", file=sys.stderr, flush=True)
    os.write(1, b"a word past Python\n")
    os.write(2, b"a word past Python\n")
    return Part(tuple(task))


def broken_beginning() -> None:
    """A preparation that fails."""
    raise ValueError("no beginning")


def deadly_beginning() -> None:
    """A preparation in which the worker is killed."""
    os.kill(os.getpid(), signal.SIGKILL)
