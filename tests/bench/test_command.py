"""`gearlash bench --quick`: structure and accuracy; what the times are is nobody's promise here."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from cli.conftest import Ran
from cli.schema_check import problems
from gearlash.bench import OWN, Curve
from gearlash.bench.explained import WORDS, sizes_explained
from gearlash.bench.peers import MISSING, installed
from gearlash.bench.sizes import AXES
from gearlash.cli.app import app
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def ran(tmp_path_factory: pytest.TempPathFactory) -> tuple[Ran, Path]:
    folder = tmp_path_factory.mktemp("bench")
    found = CliRunner().invoke(app, ["bench", "--quick", "--json", "--out", str(folder)])
    if found.exception is not None and not isinstance(found.exception, SystemExit):
        raise found.exception
    return Ran(found.exit_code, found.stdout, found.stderr), folder


@pytest.fixture(scope="module")
def found(ran: tuple[Ran, Path]) -> dict[str, Any]:
    return ran[0].answer["benchmark"]


def test_answer_is_as_documented(ran: tuple[Ran, Path]):
    assert ran[0].code == 0
    assert problems(ran[0].answer, answer_schema(answer_kind("bench"))) == []
    assert json.loads((ran[1] / "bench.json").read_text(encoding="utf-8")) == ran[0].answer


def test_every_row_was_timed_or_says_why_not(found: dict[str, Any]):
    assert all(row["seconds"] or row["note"] == MISSING for row in found["rows"])
    tasks = {row["task"] for row in found["rows"]}
    assert {"one trajectory", "many trajectories", "map pixels", "a grazing located", "start-up"} <= tasks


@pytest.mark.skipif(installed("heyoka") == MISSING, reason="the reference is heyoka's")
def test_gearlash_is_exact_on_every_row(found: dict[str, Any]):
    errors = [
        row[name]
        for row in found["rows"]
        if row["solver"] == OWN and row["task"] not in ("start-up", "map pixels")
        for name in ("error", "time_error")
    ]
    assert len([e for e in errors if e is not None]) > 8
    assert max(e for e in errors if e is not None) < 1e-11


def test_two_threads_give_the_same_bytes(found: dict[str, Any]):
    assert found["threads"]["bytes that differ"] == 0.0


def test_curves_reach_what_the_engine_takes(found: dict[str, Any]):
    assert [curve["axis"] for curve in found["curves"]] == list(AXES)
    assert all(len(curve["sizes"]) == 2 or curve["note"] for curve in found["curves"])
    shares = [limit["share"] for limit in found["limits"]]
    assert all(0.0 < share < 1.0 for share in shares)


def test_the_page_is_whole(ran: tuple[Ran, Path]):
    text = (ran[1] / "benchmarks.md").read_text(encoding="utf-8")
    assert "A quick run" in text
    for target in re.findall(r"\]\(([^)#\s]+)\)", text):
        assert (ran[1] / target).exists()
    for row in ran[0].answer["benchmark"]["rows"]:
        assert row["work"] in text
        assert row["solver"] in text


def test_no_curve_is_left_unexplained():
    assert set(WORDS) == set(AXES)
    ended = Curve("clearances", (1.0,), (1.0,), (1.0,), (4,), (0.0,), "from 2 on: no")
    assert list(sizes_explained([ended])) == ["**Clearances.** The curve ends: from 2 on: no."]
