"""Searches for zones that were stopped: what is said then, and what is not."""

from __future__ import annotations

import threading
from functools import cache

import pytest

from gearlash import case, studies
from gearlash.cli.answers.zones import zones_answer
from gearlash.cli.show.zones import zones_view
from gearlash.jobs import Execution, Progress
from gearlash.studies import Axis
from studies.classical import CLASSICAL, SPEEDS


def test_a_cancelled_search_knows_that_it_is_incomplete():
    cancel = threading.Event()
    count = 3 * len(SPEEDS)
    found = studies.zones(
        CLASSICAL,
        SPEEDS,
        execution=Execution(progress=lambda p: p.done == count and cancel.set(), cancel=cancel),
    )
    assert (found.complete, found.message) == (False, "cancelled")
    assert found.zones == found.wider == found.branches == ()


def test_a_search_that_was_stopped_before_any_end_says_so():
    """Nothing is known beside a single quiet point: no interval, and no error."""
    axis = Axis.even("omega", 0.79, 1.3, 3)  # quiet, with impacts, quiet
    cancel = threading.Event()
    found = studies.zones(
        CLASSICAL, axis, execution=Execution(progress=lambda p: p.done == 9 and cancel.set(), cancel=cancel)
    )
    assert not found.complete
    assert found.message == "cancelled"
    assert all(zone.width > 0.0 for zone in (*found.zones, *found.wider))


def test_ctrl_c_while_zones_are_swept_begins_nothing_more():
    told = []

    def interrupt(progress: Progress) -> None:
        told.append(progress.total)
        if progress.done == 40:
            raise KeyboardInterrupt

    found = studies.zones(CLASSICAL, SPEEDS, execution=Execution(progress=interrupt))
    assert set(told) == {3 * len(SPEEDS)}  # no end was looked for
    assert (found.complete, found.message) == (False, "interrupted")
    assert sum(sweep.computed for sweep in found.sweeps) == 40
    assert found.zones == found.wider == ()


ARTICLE = case.load("article-first-harmonic")
WINDOW = Axis.even("omega", 1.0, 1.15, 4)  # where 1-0-0 and 2-1-0 live, of two branches


@cache
def stopped_after(branches: int) -> studies.Zones:
    """Zones from known sweeps of which so many branches are followed."""
    cancel = threading.Event()
    if branches == 0:
        cancel.set()

    def look(progress: Progress) -> None:
        if progress.done >= branches:
            cancel.set()

    execution = Execution(progress=look, cancel=cancel)
    return studies.zones(ARTICLE, WINDOW, known=studies.sweeps(ARTICLE, WINDOW), execution=execution)


@pytest.mark.parametrize(("branches", "left"), [(0, 12), (1, 7), (2, 0)])
def test_what_was_not_followed_counts_and_nothing_is_said_of_every_attractor(branches: int, left: int):
    found = stopped_after(branches)
    assert (found.complete, found.message, len(found.branches)) == (False, "cancelled", branches)
    assert found.not_followed == left
    assert found.zones == ()
    if branches == 2:
        (zone,) = found.wider
        assert (zone.upper.kind, zone.upper.inside, zone.upper.outside) == ("grazing", "1-0-0", "1-1-0")


SAID = {
    0: "omega = 1.11 lies in no zone of a motion that was followed before the search was stopped; cancelled: "
    "12 of 12 points were computed, 0 branches were followed, 12 periodic motions were not; where every "
    "attractor is quiet is not known",
    1: "omega = 1.11 lies in no zone of a motion that was followed before the search was stopped; cancelled: "
    "12 of 12 points were computed, 1 branch was followed, 7 periodic motions were not; where every "
    "attractor is quiet is not known",
    2: "omega = 1.11 lies in a zone free of impacts for at least one attractor found before the search was "
    "stopped: omega from 1 to 1.112; cancelled: 12 of 12 points were computed, 2 branches were followed; "
    "where every attractor is quiet is not known",
}


@pytest.mark.parametrize("branches", SAID)
def test_the_answer_begins_with_what_was_done_until_the_stop(branches: int):
    found = stopped_after(branches)
    parameters = ARTICLE.family()[0].complete({"omega": 1.11})
    answer = zones_answer(ARTICLE, parameters, "omega", "", [found])
    assert answer.sentence == SAID[branches]
    assert (answer.status, answer.not_followed) == ("incomplete", found.not_followed)
    shown = " ".join(" ".join(text.plain for text in zones_view(answer, 100)).split())
    assert f"Before the search was stopped {branches} branches were followed, not all of them" in shown
    assert "every attractor found" not in shown
