"""A quick run of everything: structure and accuracy; what the times are is nobody's promise here."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from benchmarks.__main__ import write
from benchmarks.explained import WORDS, sizes_explained
from benchmarks.peers import MISSING, installed
from benchmarks.results import OWN, Benchmark, Curve
from benchmarks.run import benchmark
from benchmarks.sizes import AXES

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def found() -> Benchmark:
    return benchmark(quick=True)


def test_every_row_was_timed_or_says_why_not(found: Benchmark):
    assert all(row.seconds or row.note == MISSING for row in found.rows)
    tasks = {row.task for row in found.rows}
    assert {
        "one trajectory",
        "many trajectories",
        "map pixels",
        "a grazing located",
        "a branch",
        "a curve",
        "contact of teeth in space",
        "start-up",
    } <= tasks


@pytest.mark.skipif(installed("heyoka") == MISSING, reason="the reference is heyoka's")
def test_gearlash_is_exact_on_every_row(found: Benchmark):
    errors = [
        getattr(row, name)
        for row in found.rows
        if row.solver == OWN and row.task not in ("start-up", "map pixels")
        for name in ("error", "time_error")
    ]
    assert len([e for e in errors if e is not None]) > 8
    assert max(e for e in errors if e is not None) < 1e-11


def test_two_threads_give_the_same_bytes(found: Benchmark):
    assert found.threads["bytes that differ"] == 0.0


def test_curves_reach_what_the_engine_takes(found: Benchmark):
    assert [curve.axis for curve in found.curves] == list(AXES)
    assert all(len(curve.sizes) == 2 or curve.note for curve in found.curves)
    shares = [limit.share for limit in found.limits]
    assert all(0.0 < share < 1.0 for share in shares)


def test_the_page_is_whole(found: Benchmark, tmp_path: Path):
    write(found, tmp_path)
    text = (tmp_path / "benchmarks.md").read_text(encoding="utf-8")
    assert "A quick run" in text
    for target in re.findall(r"\]\(([^)#\s]+)\)", text):
        assert (tmp_path / target).exists()
    for row in found.rows:
        assert row.work in text
        assert row.solver in text


def test_no_curve_is_left_unexplained():
    assert set(WORDS) == set(AXES)
    ended = Curve("clearances", (1.0,), (1.0,), (1.0,), (4,), (0.0,), "from 2 on: no")
    assert list(sizes_explained([ended])) == ["**Clearances.** The curve ends: from 2 on: no."]
