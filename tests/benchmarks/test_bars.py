"""Bars against rows made up for the purpose."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import pytest

from benchmarks import OWN, Bar, Row
from benchmarks.bars import bars
from benchmarks.branches import ASKED
from benchmarks.branches import TASK as BRANCH
from benchmarks.pixels import TASK
from benchmarks.questions import DIFFERENT, LOOP, MARCH, TOUCH
from benchmarks.special_curves import ASKED as CURVES
from benchmarks.special_curves import TASK as CURVE
from benchmarks.trajectories import MANY, ONE


@dataclass(frozen=True)
class Work:
    name: str
    crossings: float


WORKS: Any = [Work("quiet", 0.0), Work("hit", 2.0), Work("harder", 3.0)]
ROWS = [
    Row(ONE, "quiet", OWN, "period", 1.0, error=1e-15),
    Row(ONE, "hit", OWN, "period", 1.0, error=3e-12, time_error=2e-11),
    Row(ONE, "quiet", "heyoka", "period", 25.0, ratio=25.0, error=1.0),
    Row(ONE, "hit", "heyoka", "period", 12.0, ratio=12.0),
    Row(ONE, "harder", "heyoka", "period", 9.0, ratio=9.0),
    Row(ONE, "hit", "RK4", "period", 1.0, ratio=1.0),
    Row(MANY, "hit", "heyoka, 4 lanes", "period", 8.0, ratio=8.0),
    Row(MANY, "hit", "heyoka, 8 lanes", "period", 7.0, ratio=7.0),
    Row(TASK, "map", "heyoka", "pixel", 40.0, ratio=40.0),
    Row(TASK, "map", "heyoka, 8 lanes", "pixel", 20.0, ratio=20.0),
    Row(TOUCH, "article", "heyoka", "point", 1.2e-3, ratio=1.2),
    Row(BRANCH, ASKED[0].work, OWN, "point", 3e-3),
    Row(BRANCH, ASKED[0].work, "heyoka", "point", 6e-3, ratio=2.0),
    Row(BRANCH, ASKED[1].work, OWN, "point", 2e-2),
    Row(BRANCH, ASKED[1].work, "heyoka", "point", 8e-2, ratio=4.0),
    Row(CURVE, CURVES[0].work, OWN, "point", 1.2e-2),
    Row(CURVE, CURVES[1].work, OWN, "point", 2.5e-2),
    Row("start-up", "import gearlash", OWN, "process", 0.1),
]


THREADS = {MARCH: 1.95, LOOP: 2.0, DIFFERENT: 0.0}


@pytest.fixture
def found() -> dict[str, Bar]:
    return {bar.sentence: bar for bar in bars(ROWS, WORKS, THREADS)}


def test_the_worst_work_counts_and_is_named(found: dict[str, Bar]):
    bar = found["one trajectory with impacts: times heyoka"]
    assert (bar.measured, bar.met, bar.where) == (9.0, False, "harder")
    assert found["one trajectory without impacts: times heyoka"].met


def test_of_the_batches_the_faster_counts(found: dict[str, Bar]):
    assert found["many trajectories with impacts: times heyoka's batch mode"].measured == 7.0
    assert found["map pixels: times 500 brute-force periods of heyoka"].measured == 40.0


def test_a_branch_is_told_in_seconds_and_against_a_loop(found: dict[str, Bar]):
    one = found["300 points of a branch of the article, P = 1, seconds"]
    six = found["300 points of a branch of the article, P = 6, seconds"]
    assert (one.measured, one.met, six.measured, six.met) == (pytest.approx(0.9), True, 6.0, False)
    against = found["a branch: times an arclength loop on heyoka"]
    assert (against.measured, against.met, against.where) == (2.0, False, ASKED[0].work)
    assert found["a grazing located: times a secant on heyoka"].met


def test_curves_are_told_in_seconds(found: dict[str, Bar]):
    one = found["200 points of a curve of the article, P = 1, seconds"]
    six = found["200 points of a curve of the article, P = 6, seconds"]
    assert (one.measured, one.met) == (pytest.approx(2.4), False)
    assert (six.measured, six.met) == (pytest.approx(5.0), True)


def test_what_was_not_measured_is_neither_met_nor_missed(found: dict[str, Bar]):
    bar = found["many trajectories without impacts: times heyoka's batch mode"]
    assert (bar.measured, bar.met) == (None, None)
    assert found["gearlash run, warm, seconds"].met is None


def test_errors_are_those_of_gearlash_and_of_crossing_times_too(found: dict[str, Bar]):
    bar = found["largest error of any row of gearlash"]
    assert (bar.measured, bar.met, bar.where) == (2e-11, False, "hit")
    assert found["import gearlash, warm, seconds"].met
    assert found["bytes that differ between one thread and two"].met


@pytest.mark.parametrize(("march", "loop", "met"), [(1.95, 2.0, True), (1.5, 2.0, False), (1.1, 1.2, None)])
def test_threads_are_judged_only_where_a_core_is_free(march: float, loop: float, met: bool | None):
    judged = bars(ROWS, WORKS, {MARCH: march, LOOP: loop, DIFFERENT: 0.0})
    assert next(bar for bar in judged if bar.sentence == "two threads: times one").met is met
