"""gearlash sweep."""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.branches.continuation import walk
from gearlash.cli import progress
from gearlash.cli.commands import sweep as command
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema

WINDOW = ("article", "--over", "pinion_speed=3600rpm:4400rpm:9")


def test_json_is_the_sweep_of_the_study(gearlash: Gearlash):
    ran = gearlash("sweep", *WINDOW, "--cold", "--down", "--json")
    answer = ran.answer
    assert ran.code == 0
    assert problems(answer, answer_schema(answer_kind("sweep"))) == []
    case = gl.load_case("article")
    axis = gl.Axis("omega", case.scales.omega_from_rpm(np.linspace(3600.0, 4400.0, 9)))
    for found, expected in zip(answer["sweeps"], gl.sweeps(case, axis, ("cold", "down")), strict=True):
        assert found["direction"] == expected.direction
        assert [p["label"] for p in found["points"]] == [p.label for p in expected.points]
        values = [p["value"] for p in found["points"]]
        assert np.allclose(values, axis.values, rtol=1e-14, atol=0.0)
        exponents = [p["largest_exponent"] for p in found["points"]]
        assert np.allclose(exponents, [p.largest_exponent for p in expected.points], rtol=1e-6)
    ends = {p["name"]: p["value"] for p in answer["axis"]["physical_upper"]}
    assert ends["pinion_speed"] == pytest.approx(4400.0, rel=1e-13)


def test_regimes_are_listed_in_both_units(gearlash: Gearlash):
    ran = gearlash("sweep", *WINDOW, "--up")
    assert ran.err == ""
    lines = [line.split() for line in ran.out.splitlines()]
    regimes = [line for line in lines if line and line[0] in ("1-0-0", "1-1-0", "2-1-0")]
    assert regimes[0][:5] == ["1-1-0", "3600", "3700", "0.942415", "0.968594"]
    assert regimes[1][0] == "1-0-0"


def test_out_is_netcdf_json_and_figures(gearlash: Gearlash, tmp_path: Path):
    ran = gearlash("sweep", *WINDOW, "--cold", "--out", str(tmp_path), "--json")
    dataset = gl.load_dataset(tmp_path / "sweep.nc")
    labels = [p["label"] for p in ran.answer["sweeps"][0]["points"]]
    assert [str(x) for x in dataset["label"].values[0]] == labels
    assert np.allclose(dataset["pinion_speed"], np.linspace(3600.0, 4400.0, 9), rtol=1e-13)
    assert dataset.attrs["case_hash"] == ran.answer["case"]["hash"]
    assert json.loads((tmp_path / "sweep.json").read_text(encoding="utf-8")) == ran.answer
    assert (tmp_path / "sweep.svg").read_bytes().startswith(b"<?xml")
    assert (tmp_path / "sweep.pdf").read_bytes().startswith(b"%PDF")


def test_ctrl_c_keeps_what_was_computed(gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    import gearlash.cli.progress as progress

    @contextmanager
    def interrupting(title: str) -> Iterator[object]:
        def callback(state: gl.jobs.Progress) -> None:
            if state.done == 4:
                os.kill(os.getpid(), signal.SIGINT)

        yield callback

    monkeypatch.setattr(progress, "progress_bar", interrupting)
    ran = gearlash("sweep", *WINDOW, "--cold", "--workers", "1", "--out", str(tmp_path))
    assert ran.code == 130
    assert "incomplete, 5 points missing" in " ".join(ran.out.split())
    dataset = gl.load_dataset(tmp_path / "sweep.nc")
    assert dataset.attrs["complete"] == 0
    assert [str(s) for s in dataset["status"].values[0]] == ["ok"] * 4 + ["not-computed"] * 5
    assert not (tmp_path / "sweep.svg").exists()


def test_ctrl_c_before_the_first_point_keeps_an_older_result(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    import gearlash.cli.progress as progress

    whole = ("sweep", *WINDOW, "--cold", "--workers", "1", "--out", str(tmp_path))
    assert gearlash(*whole).code == 0
    before = {path.name: path.read_bytes() for path in tmp_path.glob("sweep.*")}
    assert len(before) == 4

    @contextmanager
    def interrupting(title: str) -> Iterator[object]:
        os.kill(os.getpid(), signal.SIGINT)
        yield None

    monkeypatch.setattr(progress, "progress_bar", interrupting)
    ran = gearlash(*whole)
    assert ran.code == 130
    assert {path.name: path.read_bytes() for path in tmp_path.glob("sweep.*")} == before


def test_values_are_told_in_the_unit_that_was_asked_for(gearlash: Gearlash):
    ran = gearlash("sweep", "article", "--over", "mesh_frequency=1.7kHz:1.9kHz:2", "--cold")
    assert ran.out.startswith("mesh frequency from 1.7 to 1.9 kHz, 2 values, cold: ")
    assert "from, kHz" in ran.out
    failed = gearlash("sweep", "article", "--over", "pinion_speed=0.001rpm:4000rpm:2", "--cold")
    assert "1 of 2 points failed: 0.001 rpm, " in " ".join(failed.out.split())


def test_a_state_that_was_given_is_not_called_a_cold_start(gearlash: Gearlash):
    ran = gearlash("sweep", "kahraman-singh", "--over", "omega=0.5:0.6:2", "--cold", "--initial", "X=1.2")
    assert "cold starts" not in ran.out
    assert "From the state that was given, at every value" in ran.out


@pytest.mark.parametrize("command", ["sweep", "zones"])
def test_of_a_study_without_a_motion_nothing_is_drawn(gearlash: Gearlash, tmp_path: Path, command: str):
    """All points fail: data and answer are there."""
    ran = gearlash(command, "kahraman-singh", "--over", "omega=1e-6:2e-6:3", "--out", str(tmp_path))
    assert ran.code == 3
    assert "9 of 9 points failed" in ran.out
    assert sorted(path.suffix for path in tmp_path.glob(f"{command}.*")) == [".json", ".nc"]


def test_a_sweep_through_no_load_follows_nothing_beside_the_neutral_motion(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    """The neutral point between two motions of one label is no change: nothing is followed for a mark there.
    Where the label of one side changes, that side alone is followed, and it is told how far that is."""
    case = gl.load_case("article", {"omega": "0.94"})
    (found,) = gl.sweeps(case, gl.Axis("load", [-0.4, -0.3, 0.0, 0.1, 0.3]), ["cold"])
    labels = [str(point.label) for point in found.points]
    assert labels == ["1-0-0", "1-0-0", "neutral", "1-1-0", "1-0-0"]
    asked = []

    def walked(*arguments: Any, **settings: Any) -> Iterator[Any]:
        asked.append(arguments[1]["load"])
        return walk(*arguments, **settings)

    monkeypatch.setattr(import_module("gearlash.studies.transitions"), "walk", walked)
    monkeypatch.setattr(progress.Lines, "__init__", lambda lines: vars(lines).update(began=0.0, next=0.0))
    changes = command._changes(case, [found])
    assert [change.kind for change in changes] == ["grazing"]
    assert asked == [0.1]
    assert "changes of the motion, for the figure: 1/1" in capsys.readouterr().err
