"""gearlash reproduce: what it does with what the study found. The study itself is tested in its own room."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import xarray

import gearlash.article as article
import gearlash.article.report as report
import gearlash.article.rows as rows
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.article.reproduction import Check, ClaimRow, Diagram, Reproduction, Run
from gearlash.case import Case
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
from gearlash.jobs import DIED
from gearlash.results import load as load_dataset
from gearlash.system import Status

NAN = float("nan")


def found(case: Case, complete: bool = True) -> Reproduction:
    """A small reproduction with one row of each verdict."""
    row = ClaimRow(
        id="omega-1.112",
        sentence="A grazing ends the 1-0 window",
        quantity="omega",
        where="D = 1",
        printed="1.112",
        computed="1.1120",
        value=1.112,
        computed_value=1.11200608,
        unit="",
        reported_labels="1-0 → 1-1",
        computed_labels="1-0-0 → 1-1-0",
        deviation=5.5e-6,
        verdict="reproduced",
        branch="up sweep",
        note="",
        rests_on=("bearings.damping_ratio",),
    )
    lost = replace(row, id="other", verdict="not found", computed="–", computed_value=NAN, deviation=NAN)
    nothing = Diagram("omega", {}, xarray.Dataset(), ())
    return Reproduction(
        case=case,
        frequency=nothing,
        backlash=nothing,
        events=(),
        zones=(),
        window=(),
        table2=(),
        claims=(row, row, lost),
        checks=(Check("largest residual", "1e-13", "≤ 1e-11", True), Check("points", "3", "reported", None)),
        run=Run({"sweeps": 1.0, "total": 75.0}, 2, 2, {}, {Status.OK: 3}, complete),
    )


@pytest.fixture
def study(monkeypatch: pytest.MonkeyPatch) -> Callable[[bool], dict[str, object]]:
    """Replaces the study and the report; returns what the study was asked."""

    def install(complete: bool) -> dict[str, object]:
        asked: dict[str, object] = {}

        def reproduce(case: Case, scope: article.Scope, **options: object) -> Reproduction:
            asked.update(case=case, scope=scope, **options)
            return found(case, complete)

        def render(reproduction: Reproduction, folder: Path, executor: object, **options: object) -> Path:
            (folder / "report.html").write_text("report", encoding="utf-8")
            return folder / "report.html"

        monkeypatch.setattr(article, "reproduce", reproduce)
        monkeypatch.setattr(report, "render", render)
        return asked

    return install


def test_answer_counts_verdicts_and_points_to_the_report(
    gearlash: Gearlash, study: Callable[[bool], dict[str, object]], tmp_path: Path
):
    study(True)
    ran = gearlash("reproduce", "--workers", "1", "--json", "--out", str(tmp_path))
    assert ran.code == 0
    assert problems(ran.answer, answer_schema(answer_kind("reproduce"))) == []
    assert ran.answer["verdicts"] == {"reproduced": 2, "not found": 1}
    assert ran.answer["claims"][2]["computed_value"] is None
    assert ran.answer["report"] == str(tmp_path / "report.html")
    assert json.loads((tmp_path / "reproduce.json").read_text(encoding="utf-8")) == ran.answer


def test_table_of_claims_and_path_are_printed(
    gearlash: Gearlash, study: Callable[[bool], dict[str, object]], tmp_path: Path
):
    study(True)
    ran = gearlash("reproduce", "--workers", "1", "--out", str(tmp_path))
    lines = [" ".join(line.split()) for line in ran.out.splitlines()]
    assert lines[0] == "3 claims of the article: 2 reproduced, 1 not found"
    assert lines.count("reproduced 1.112 1.1120 omega, D = 1; 1-0 → 1-1, computed 1-0-0 → 1-1-0") == 2
    assert "1e-13 ≤ 1e-11 holds largest residual" in lines
    assert "time 1 min 15 s with 2 workers" in lines
    assert str(tmp_path / "report.html") in "".join(ran.out.split())


def test_case_overrides_points_and_workers_reach_the_study(
    gearlash: Gearlash, study: Callable[[bool], dict[str, object]], tmp_path: Path
):
    asked = study(True)
    options = ("--set", "bearing_damping=0.02", "--points", "21", "--workers", "1", "--out", str(tmp_path))
    assert gearlash("reproduce", *options).code == 0
    case, scope = asked["case"], asked["scope"]
    assert isinstance(case, Case)
    assert isinstance(scope, article.Scope)
    assert (case.name, case.family()[0].defaults["bearing_damping"]) == ("article", 0.02)
    assert (scope.omega[2], scope.backlash[2], asked["workers"]) == (21, 21, 1)
    assert scope.omega[:2] == article.Scope().omega[:2]


def test_a_study_that_lost_its_workers_has_exit_code_5(
    gearlash: Gearlash, study: Callable[[bool], dict[str, object]], tmp_path: Path
):
    study(False)
    ran = gearlash("reproduce", "--workers", "1", "--out", str(tmp_path))
    assert ran.code == 5
    assert "incomplete" in ran.out


def test_workers_that_die_are_no_ctrl_c(gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """What was computed without them is kept; the exit code and a sentence say what happened."""
    whole = rows.sweeps

    def without_the_last(*arguments: Any, **options: Any):
        *others, last = whole(*arguments, **options)
        return (*others, replace(last, complete=False, message=DIED))

    monkeypatch.setattr(rows, "sweeps", without_the_last)
    ran = gearlash("reproduce", "--points", "11", "--workers", "1", "--out", str(tmp_path))
    assert ran.code == 5
    assert DIED in " ".join(ran.err.split())
    assert load_dataset(tmp_path / "sweep-omega.nc").attrs["complete"] == 0
    assert not (tmp_path / "report.html").exists()


def test_a_foreign_report_is_not_overwritten(
    gearlash: Gearlash, study: Callable[[bool], dict[str, object]], tmp_path: Path
):
    asked = study(True)
    (tmp_path / "report.html").write_text("mine", encoding="utf-8")
    assert gearlash("reproduce", "--out", str(tmp_path)).code == 2
    assert asked == {}
    assert (tmp_path / "report.html").read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("case", ["kahraman-singh", "shaw-holmes", "geared-rotor"])
def test_another_pair_is_refused_with_what_to_use(
    case: str, gearlash: Gearlash, study: Callable[[bool], dict[str, object]], tmp_path: Path
):
    asked = study(True)
    ran = gearlash("reproduce", case, "--out", str(tmp_path / "out"))
    assert ran.code == 2
    assert asked == {}
    assert not (tmp_path / "out").exists()
    said = " ".join(ran.err.split())
    assert "the article's pair" in said
    assert "gearlash run, sweep, zones, graze or map" in said
