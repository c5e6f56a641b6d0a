"""gearlash report: the verdict, the page, the data beside it."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.cli.answers.report import FILES
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
from gearlash.report.pair import file_names
from report.reading import Reading

DRIVE = Path(__file__).resolve().parents[1] / "cases" / "drive.toml"
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
