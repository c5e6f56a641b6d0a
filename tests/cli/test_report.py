"""gearlash report: the verdict, the page, the data beside it."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from cli.signalled import MARK, still_running
from gearlash.cli.answers.report import FILES
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
from gearlash.report.pair import file_names
from gearlash.results.beside import Beside
from gearlash.studies.beside import motions_beside
from report.reading import Reading
from tools.look import size

DRIVE = Path(__file__).resolve().parents[1] / "cases" / "drive.toml"
COMMAND = [sys.executable, "-c", "from gearlash.cli import main; main()"]
NARROW = ("--over", "pinion_speed=3700:4300rpm:13", "--workers", "1")


@pytest.fixture(autouse=True)
def small_maps(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("gearlash.studies.grids.PIXELS", (4, 3))


def test_the_report_of_a_drive(gearlash: Gearlash, tmp_path: Path):
    ran = gearlash("report", str(DRIVE), *NARROW, "--out", str(tmp_path), "--json")
    answer = ran.answer
    assert ran.code == 0
    assert problems(answer, answer_schema(answer_kind("report"))) == []
    assert answer["verdict"] == "good"
    lines = {line["title"]: line["text"] for line in answer["lines"]}
    assert lines["Margin"] == "teeth begin to separate (grazing) at 4114.1 rpm, 85.9 rpm (2.0 %) below."
    assert lines["Teeth separate"].startswith("3850 to 4114.1 rpm (1-1)")
    assert lines["Back side"] == "It is met by no motion that was found in that range."
    assert "bearing force, pinion, lateral, up to 13110 N" in lines["Forces there"]
    assert "no approval" in lines["What this rests on"]
    low, high = ([b[end] for b in answer["separating"]] for end in ("lower", "upper"))
    scales = gl.load_case(DRIVE).scales
    assert scales.pinion_rpm([low[0], high[-1]]) == pytest.approx([3850.0547, 4114.0811], abs=1e-3)
    assert {path.name for path in tmp_path.iterdir()} - {".gearlash.json"} <= set(FILES)
    assert set(file_names()) <= {path.name for path in tmp_path.iterdir()}
    _page(tmp_path)
    _files(tmp_path, answer)


@pytest.mark.parametrize("record", ["reproduce.json", "verdict.json"])
def test_a_folder_keeps_a_report_that_is_not_of_this_question(
    gearlash: Gearlash, tmp_path: Path, record: str
):
    """Of another command, or of a version that noted no question."""
    (tmp_path / record).write_text("{", encoding="utf-8")
    marker = {"process": 1, "files": [record, "report.html"], "asked": {record: "1", "report.html": "1"}}
    (tmp_path / ".gearlash.json").write_text(json.dumps(marker), encoding="utf-8")
    (tmp_path / "report.html").write_text("of the other", encoding="utf-8")
    ran = gearlash("report", str(DRIVE), *NARROW, "--out", str(tmp_path))
    assert ran.code == 0
    assert "is kept in" in " ".join(ran.complaint.split())
    kept = tmp_path / "earlier-1"
    assert {path.name for path in kept.iterdir()} == {record, "report.html"}
    assert (kept / "report.html").read_text(encoding="utf-8") == "of the other"
    assert "drive" in (tmp_path / "report.html").read_text(encoding="utf-8")


def _page(folder: Path) -> None:
    text = (folder / "report.html").read_text(encoding="utf-8")
    page = Reading(text)
    assert page.problems == []
    words = " ".join(" ".join(page.words).split())
    for said in (
        "May it run there?",
        "The backlash does not matter for the motions found",
        "This is an analysis of a model",
        "refer to 1 µN and 1 pm (ISO 1683)",
        "model.body",
        "25/57 teeth, normal module 3 mm",
        "What the case states, in its units.",
    ):
        assert said in words
    links = [value for tag, name, value in page.attributes if name in ("src", "href") and tag != "a"]
    assert not [link for link in links if link.startswith(("http", "//"))]


def _files(folder: Path, answer: dict) -> None:
    table = pd.read_csv(folder / "speed.csv")
    assert len(table) == 26
    at = table[(table.direction == "up") & np.isclose(table.speed_rpm, 4200.0)].iloc[0]
    assert at.mesh_force_largest_N == pytest.approx(5944.4, abs=0.1)
    assert at.motion == "1-0-0"
    kept = gl.load_dataset(folder / "speed.nc")
    assert kept["mesh_force_largest_N"].values == pytest.approx(table.mesh_force_largest_N.values, rel=1e-9)
    history = pd.read_csv(folder / "history-nominal.csv")
    spectrum = xr.open_dataset(folder / "spectrum-nominal.nc", engine="h5netcdf").load()
    assert float(np.sqrt((spectrum.mesh_force_rms_N[1:] ** 2).sum())) == pytest.approx(
        history.mesh_force_N.std(ddof=0), rel=1e-6
    )
    one = spectrum.sel(line=1)
    assert float(one.mesh_force_dB_re_1uN) == pytest.approx(
        20.0 * np.log10(float(one.mesh_force_rms_N) / 1e-6)
    )
    numbers = json.loads((folder / "report.json").read_text(encoding="utf-8"))
    assert numbers["verdict"]["kind"] == answer["verdict"]


def test_where_teeth_never_part_there_is_no_empty_picture(gearlash: Gearlash, tmp_path: Path):
    """Neither panels of what never happens nor a map of one colour: a sentence each, and no file."""
    narrow = ("--over", "pinion_speed=4200:4300rpm:4", "--workers", "1")
    ran = gearlash("report", str(DRIVE), *narrow, "--out", str(tmp_path), "--json")
    assert ran.answer["separating"] == []
    figures = {path.stem for path in (tmp_path / "figures").iterdir()}
    assert "map-backlash" not in figures
    page = Reading((tmp_path / "report.html").read_text(encoding="utf-8"))
    assert page.problems == []
    said = " ".join(" ".join(page.words).split())
    assert "In no motion of these sweeps do teeth part" in said
    (told,) = re.findall(
        r"at \d+ speeds, 4200 to 4300 rpm, and 3 values of backlash, .*? to .*?, (.*?)[.] ", said
    )
    assert told == "the motion is 1-0: teeth stay in contact"
    drawn = (tmp_path / "figures" / "speed-errors.svg").read_text(encoding="utf-8")
    parted = tmp_path / "parted"
    gearlash("report", str(DRIVE), *NARROW, "--out", str(parted))
    tall = (parted / "figures" / "speed-errors.svg").read_text(encoding="utf-8")
    assert size(drawn)[1] < size(tall)[1]
    assert "DTE" in said


def test_a_pair_without_units_is_told_in_its_own_numbers(gearlash: Gearlash, tmp_path: Path):
    over = ("--over", "omega=0.7:0.9:5", "--set", "omega=0.85", "--workers", "1")
    ran = gearlash("report", "kahraman-singh", *over, "--out", str(tmp_path))
    assert ran.code == 0
    assert "At omega = 0.85 and load = 0.1" in " ".join(ran.out.split())
    assert "speed" in pd.read_csv(tmp_path / "speed.csv").columns
    assert "its bearings" not in ran.out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("geared-rotor",), "a report is made of a gear pair"),
        (("article", "--set", "torque=0 N*m"), "a report needs a torque"),
        (("article", "--set", "torque=-50 N*m", "--set", "back_gap=0.8"), "needs both sides alike"),
        (("article", "--over", "D=0.5:1:5"), "a report goes over speed"),
        (("kahraman-singh", "--set", "error=0"), "nothing excites this pair"),
    ],
)
def test_what_no_report_is_made_of(arguments: tuple[str, ...], said: str, gearlash: Gearlash, tmp_path: Path):
    ran = gearlash("report", *arguments, "--out", str(tmp_path / "none"))
    assert ran.code == 2
    assert said in ran.complaint
    assert not (tmp_path / "none").exists()


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="processes are looked for in /proc")
@pytest.mark.parametrize("again", [False, True])
def test_stopped_after_its_verdict_it_keeps_that_and_leaves_nothing_running(tmp_path: Path, again: bool):
    """One Ctrl-C: the page is made of what is there, and says what is missing. Two: it ends at once."""
    out, mark = tmp_path / "out", f"{os.getpid()}-report-{again}"
    speeds = "pinion_speed=3700:4300rpm:201"
    process = subprocess.Popen(
        [*COMMAND, "report", str(DRIVE), "--over", speeds, "--workers", "2", "--out", str(out)],
        env={**os.environ, MARK: mark}, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True, start_new_session=True,
    )  # fmt: skip
    assert process.stdout is not None
    assert process.stdout.readline().startswith("At 4200 rpm and 150 N·m no impacts were found")
    process.send_signal(signal.SIGINT)
    if again:
        time.sleep(0.6)
        process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=120)
    assert process.returncode == 130
    assert "Traceback" not in errors
    assert still_running(mark) == []
    if again:
        assert not (out / "report.html").exists()
        return
    answer = json.loads((out / "verdict.json").read_text(encoding="utf-8"))
    assert (answer["status"], answer["verdict"]) == ("incomplete", "good")
    assert "the map over torque" in answer["missing"]
    page = Reading((out / "report.html").read_text(encoding="utf-8"))
    assert page.problems == []
    said = " ".join(" ".join(page.words).split())
    assert f"The report was stopped early; not computed: {', '.join(answer['missing'])}." in said


@pytest.mark.skipif(os.name == "nt", reason="sends a signal to this process")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_stopped_before_its_verdict_it_tells_no_band(
    number: signal.Signals, gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    """What was not looked for to the end is no band in which teeth separate, in words or as a picture."""

    def stopped(*given: object, **named: object) -> Beside | None:
        os.kill(os.getpid(), number)
        return motions_beside(*given, **named)  # type: ignore[arg-type]

    monkeypatch.setattr("gearlash.studies.assessment.motions_beside", stopped)
    ran = gearlash("report", str(DRIVE), *NARROW, "--out", str(tmp_path / "out"), "--json")
    answer = ran.answer
    assert ran.code == 128 + number
    assert (answer["status"], answer["verdict"]) == ("incomplete", "doubt")
    assert answer["sentence"] == (
        "At 4200 rpm and 150 N·m teeth stay in contact in the motion from the cold start (1-0); the search "
        "for other motions was stopped (interrupted)."
    )
    assert answer["separating"] == answer["not_told"] == answer["back_side"] == []
    lines = {line["title"]: line["text"] for line in answer["lines"]}
    for title in ("Teeth separate", "Back side", "Margin"):
        assert lines[title].startswith("Not looked for to the end")
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "not computed: curves over speed, the map over torque, the map over backlash" in page
