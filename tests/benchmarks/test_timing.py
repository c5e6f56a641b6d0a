"""Turns and ratios."""

from __future__ import annotations

import pytest

from benchmarks.timing import Runner, Times, in_turns


def test_everybody_takes_turns_after_one_call_to_warm_up():
    calls: list[str] = []
    runners = [Runner(name, lambda n=name: calls.append(n), 2) for name in "ab"]
    times = in_turns(runners, 3)
    assert "".join(calls) == "ab" + "ababab"
    assert [len(t.each) for t in times.values()] == [3, 3]


def test_without_warming_up():
    calls: list[str] = []
    in_turns([Runner("a", lambda: calls.append("a"))], 2, warm=False)
    assert calls == ["a", "a"]


def test_a_slow_spell_that_meets_both_leaves_the_ratio():
    ours, theirs = Times((1.0, 2.0, 1.1)), Times((10.0, 20.0, 11.0))
    assert theirs.over(ours) == pytest.approx(10.0)
    assert (ours.median, ours.best) == (1.1, 1.0)
