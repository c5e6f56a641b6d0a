"""Estimates of the time left, from what was measured and nothing else."""

from __future__ import annotations

import pytest

from gearlash.jobs import Progress, seconds_as_text
from gearlash.jobs.progress import Load, remaining


def test_nothing_measured_gives_no_estimate():
    assert remaining([Load(10), Load(5)], 2) is None


def test_work_is_shared_by_the_workers():
    assert remaining([Load(10, 5, 10.0), Load(10, 5, 10.0)], 1) == pytest.approx(20.0)
    assert remaining([Load(10, 5, 10.0), Load(10, 5, 10.0)], 2) == pytest.approx(10.0)


def test_a_long_chain_cannot_be_shared():
    assert remaining([Load(100, 10, 10.0), Load(2, 2, 2.0)], 8) == pytest.approx(90.0)


def test_each_chain_keeps_its_own_pace_and_new_ones_take_that_of_all():
    loads = [Load(4, 2, 2.0), Load(4, 2, 6.0), Load(3)]
    assert remaining(loads, 1) == pytest.approx(2 * 1.0 + 2 * 3.0 + 3 * 2.0)


def test_done_is_zero_left():
    assert remaining([Load(4, 4, 2.0)], 2) == 0.0


@pytest.mark.parametrize(
    ("seconds", "text"),
    [
        (0.04, "0.0 s"),
        (9.94, "9.9 s"),
        (59.4, "59 s"),
        (59.6, "1 min 00 s"),
        (200.0, "3 min 20 s"),
        (7500, "2 h 05 min"),
    ],
)
def test_seconds_as_a_person_says_them(seconds, text):
    assert seconds_as_text(seconds) == text


def test_progress_as_text():
    assert str(Progress(3, 12, 4.0, None)) == "3/12 after 4.0 s"
    assert str(Progress(3, 12, 4.0, 12.0)) == "3/12 after 4.0 s, about 12 s left"
    assert Progress(0, 0, 0.0, None).share == 1.0
