"""Work for the tests of jobs, where worker processes can import it."""

from __future__ import annotations

import os
import signal
import time

from gearlash.jobs import Part, stopping


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
