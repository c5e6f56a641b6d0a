"""`gearlash verify` from a case to its files, with coarse finite elements and short motions."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

import gearlash as gl
import gearlash.studies.verification as study
import tools.verified
from cli import short_verify
from cli.conftest import Gearlash
from cli.signalled import MARK, marked, still_running
from gearlash.article.verified import from_data
from gearlash.cli.commands.reproduce import _teeth

FILES = {f"{name}.{form}" for name in ("force", "orders", "lines", "frames") for form in ("svg", "pdf")}
TABLES = {f"{name}.csv" for name in ("verify", "forces", "orders", "window", "breathing", "meshes")}
CASES = Path(__file__).parents[1] / "cases"
WAYS = ["stiffness", "dimensionless", "absolute"]


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    short_verify.shorten(monkeypatch.setattr)


@pytest.mark.slow
@pytest.mark.usefixtures("short")
def test_helical_case_as_json_with_figures_and_tables(gearlash: Gearlash, tmp_path: Path):
    out = tmp_path / "out"
    quick = ("--speed", "3600rpm", "--quick", "--workers", "1", "--tip-relief", "20um", "--flexible-pinion")
    ran = gearlash("verify", "article", *quick, "--json", "--csv", "--out", str(out))
    assert ran.code == 0, ran.complaint
    answer = ran.answer
    assert answer == json.loads((out / "verify.json").read_text(encoding="utf-8"))
    ways = answer["configurations"]
    assert [way["name"] for way in ways] == [*WAYS, "modified"]
    assert {one["flexible_pinion"] for one in answer["settings"] if one["name"] != "window"} >= {"True"}
    for way in ways:
        scaled = way["name"] == "dimensionless"
        assert [len(way[name]) for name in ("points", "beside", "breathing", "lumped")] == [
            1,
            1 + scaled,
            1,
            3,
        ]
        assert [frame["phase"] for frame in way["points"][0]["frames"]] == sorted(
            frame["phase"] for frame in way["points"][0]["frames"]
        )
    assert {path.name for path in out.iterdir()} == {*FILES, *TABLES, "verify.json", ".gearlash.json"}
    rows = list(csv.DictReader((out / "verify.csv").read_text(encoding="utf-8").splitlines()))
    assert [row["model"] for row in rows] == [
        model for teeth in (2, 3, 2, 2) for model in ["real teeth"] * teeth + ["lumped model"] * 3
    ]
    assert float(rows[0]["mean_force [N]"]) == ways[0]["points"][0]["mean_force"]
    assert rows[0]["settled"] == str(ways[0]["points"][0]["settled"])
    meshes = list(csv.DictReader((out / "meshes.csv").read_text(encoding="utf-8").splitlines()))
    for row, mesh in zip(meshes, answer["meshes"], strict=True):
        assert float(row["errors_under_load_2 [um]"]) == mesh["errors_under_load"][1]
    _, wide, _, relieved = answer["meshes"]
    assert all(wide[name] == relieved[name] for name in ("face_width", "torque"))
    assert relieved["errors_under_load"][0] > 2.0 * wide["errors_under_load"][0]
    assert "dB re its mean" in (out / "orders.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("asked", "why"),
    [
        (("--tip-relief", "20"), "a length with its unit"),
        (("--crowning", "-3um"), "not below 0"),
        (("--tip-relief", "20um", "--relief-length", "0mm"), "a length above 0"),
    ],
)
def test_flanks_that_cannot_be_are_refused(gearlash: Gearlash, asked: tuple[str, ...], why: str):
    ran = gearlash("verify", "article", *asked)
    assert ran.code == 2
    assert why in " ".join(ran.complaint.split())


def test_real_teeth_are_computed_for_the_article_alone(gearlash: Gearlash, tmp_path: Path):
    ran = gearlash("reproduce", "article", "--set", "backlash=90um", "--verify", "--out", str(tmp_path / "r"))
    assert ran.code == 2
    assert "gearlash verify" in ran.complaint


@pytest.mark.slow
@pytest.mark.usefixtures("short")
def test_reproduce_computes_real_teeth_as_what_is_kept_was(monkeypatch: pytest.MonkeyPatch):
    """One plan of one case, and one file of data; the command tells each stage before it works on it."""
    asked, kept, stages = [], [], []

    def short_plan(**named: Any) -> study.Plan:
        return replace(short_verify.short_plan(**named), beside=(), window_over=(0.0, 0.0, 0))

    @cache
    def found(case: gl.Case, plan: study.Plan) -> study.Verification:
        return study.verification(case, plan=plan, tell=lambda stage, _: stages.append(stage))

    def once(case: gl.Case, *, plan: study.Plan, **_: Any) -> study.Verification:
        asked.append((case, plan))
        return found(case, plan)

    monkeypatch.setattr("gearlash.article.verifying.planned", short_plan)
    monkeypatch.setattr(tools.verified, "verification", once)
    monkeypatch.setattr(tools.verified, "check_numbers", lambda _: {})
    monkeypatch.setattr(tools.verified, "write", kept.append)
    tools.verified.main(1)
    with monkeypatch.context() as patch:
        patch.setattr("gearlash.studies.verification.verification", once)
        shown, said = _teeth(gl.load_case("article"), True, 1, lambda *_: None)
    assert asked[0] == asked[1]
    assert shown is not None
    assert (shown.in_run, said) == (True, "")
    [data] = kept
    assert from_data(data, in_run=True) == replace(shown, computed=data["computed"])
    assert list(dict.fromkeys(stages)) == [
        "compliance of the teeth (finite elements)",
        "bodies in space",
        "lumped model",
    ]


@pytest.mark.slow
@pytest.mark.usefixtures("short")
@pytest.mark.parametrize("kind", ["spur-1dof", "helical-pair"])
def test_spur_cases(gearlash: Gearlash, tmp_path: Path, kind: str):
    """With rotations alone, where nothing breathes, and with bearings, where it does."""
    case, text = tmp_path / "spurs.toml", (CASES / "spurs.toml").read_text(encoding="utf-8")
    if kind == "helical-pair":
        text = text.replace("spur-1dof", kind).replace("[operation]", 'helix_angle = "0 deg"\n[operation]')
    case.write_text(text, encoding="utf-8")
    ran = gearlash("verify", str(case), "--speed", "4200rpm", "--quick", "--workers", "1", "--json")
    assert ran.code == 0, ran.complaint
    assert {mesh["overlap_ratio"] for mesh in ran.answer["meshes"]} == {0.0}
    for way in ran.answer["configurations"]:
        assert len(way["breathing"]) == (kind == "helical-pair")
        point = way["points"][0]
        assert 0.5 * point["mean_force"] < point["greatest_force"]
        assert point["apart"] < 1.0


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="processes are looked for in /proc")
def test_interrupted_it_keeps_what_was_found_and_leaves_nothing_running(tmp_path: Path):
    out, mark = tmp_path / "out", f"{os.getpid()}-verify"
    command = [sys.executable, "-m", "cli.short_verify", "verify", "article", "--workers", "2"]
    process = subprocess.Popen(
        [*command, "--out", str(out)],
        env={**os.environ, MARK: mark, "PYTHONPATH": str(Path(__file__).parents[1])},
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        start_new_session=True,
    )  # fmt: skip
    while process.poll() is None and len(marked(mark)) < 3:  # both workers have begun
        time.sleep(0.1)
    time.sleep(3.0)
    process.send_signal(signal.SIGINT)
    said, _ = process.communicate(timeout=60)
    assert process.returncode == 130, said
    assert "Traceback" not in said
    assert still_running(mark) == []
    if "stopping, with what was computed" in said:  # a busy machine may still be at the finite elements
        answer = json.loads((out / "verify.json").read_text(encoding="utf-8"))
        assert answer["status"] == "incomplete"
        assert not FILES & {path.name for path in out.iterdir()}
