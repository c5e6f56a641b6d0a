"""Where standard error is no terminal, what takes long says how far it is, ever more seldom."""

from __future__ import annotations

import pytest

from gearlash.cli import progress
from gearlash.jobs import Progress


@pytest.fixture
def lines(monkeypatch):
    """What is announced, at times that the test sets."""
    clock, said = [0.0], []
    monkeypatch.setattr(progress, "monotonic", lambda: clock[0])
    monkeypatch.setattr(progress, "announce", said.append)
    return clock, said


def test_what_is_short_says_nothing(lines):
    clock, said = lines
    told = progress.Lines(began=0.0)
    for clock[0] in range(30):
        told.tell("speeds", Progress(clock[0], 100, float(clock[0]), 10.0))
    assert said == []


def test_what_takes_long_says_how_far_it_is_ever_more_seldom(lines):
    clock, said = lines
    told = progress.Lines(began=0.0)
    for clock[0] in range(300):
        told.tell("tolerances", Progress(clock[0], 300, float(clock[0]), 300.0 - clock[0]))
    assert len(said) == 4  # after 30, 60, 120 and 240 s
    assert said[0] == "tolerances: 30/300, about 4 min 30 s left (after 30 s)"
    assert all(line.startswith("tolerances: ") for line in said)


def test_a_stage_that_begins_late_is_named(lines):
    clock, said = lines
    told = progress.Lines(began=0.0)
    clock[0] = 31.0
    told.tell("map over torque", None)
    assert said == ["map over torque: (after 31 s)"]
