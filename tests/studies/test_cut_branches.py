"""Branches that are cut as the work is limited: what is counted, and what is kept."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import gearlash as gl
from gearlash.branches.continuation import EndKind
from gearlash.jobs import Execution
from gearlash.orbits import Settings
from gearlash.studies import follow_tasks
from gearlash.studies.follow_tasks import Cut, Follow, Question, Seed, follow_branch
from gearlash.studies.followed import Followed
from gearlash.studies.model import Source
from gearlash.studies.work import Work


def _question() -> Question:
    source = Source.of(gl.load_case("kahraman-singh"))
    return Question(source, (), "omega", 0.5, 1.1, Settings())


def _seed(value: float) -> Seed:
    point = gl.point(gl.load_case("kahraman-singh"), values={"omega": value})
    return Seed(value, point.state, point.period, "cold")


def test_orbits_of_an_attempt_that_led_past_a_cut_are_counted(monkeypatch: pytest.MonkeyPatch):
    """The cut is of no orbit of the branch, so that it is followed again without it."""
    computed = []

    def counted(*given, **named):
        branch = continued(*given, **named)
        computed.append(len(branch.points))
        return branch

    continued = follow_tasks.continue_orbit
    monkeypatch.setattr(follow_tasks, "continue_orbit", counted)
    seed = _seed(0.55)
    elsewhere = Cut(0.6, np.full((1, len(seed.state)), 7.0), False)
    traced = follow_branch(Follow(_question(), seed, 40, None, elsewhere), None).results[0]
    assert len(computed) == 2
    assert traced.orbits == sum(computed) > len(traced.branch.points)
    work = Work(10_000)
    work.followed(traced.branch, traced.orbits)
    assert work.spent == 9 * sum(computed)


def test_of_a_branch_that_is_known_in_part_the_rest_counts():
    """The first one was cut in the middle of its way; the second one goes on there."""
    question = _question()
    short, whole = (follow_branch(Follow(question, _seed(0.55), n), None).results[0] for n in (20, 1000))
    assert EndKind.POINTS in {end.kind for end in short.branch.ends}
    followed = Followed(question, Execution())
    followed.take(short)
    known = len(followed.stable)
    followed.take(whole)
    reach = max(arc.upper.value for arc in followed.stable)
    assert len(followed.branches) == 2
    assert len(followed.stable) > known
    assert reach == question.upper
    followed.take(whole)
    assert len(followed.branches) == 2  # all of it is known now


def test_motions_without_impacts_come_first_where_work_is_limited():
    """A long motion with impacts waits until each of them lies on a branch."""
    quiet = gl.point(gl.load_case("kahraman-singh"), values={"omega": 0.55})
    long = replace(quiet, period=22, drive=18)
    assert quiet.impact_free
    assert not long.impact_free
    limited, free = (Followed(_question(), Execution(), work=Work(most)) for most in (9000, None))
    assert limited.longest_first([long, quiet]) == 1
    assert limited.longest_first([long]) == free.longest_first([long, quiet]) == np.inf
