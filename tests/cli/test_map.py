"""gearlash map."""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema

PLANE = ("kahraman-singh", "--over", "omega=0.6:0.9:4", "--over", "D=0.5:1.5:3")


def test_json_is_the_map_of_the_study(gearlash: Gearlash):
    ran = gearlash(
        "map", "article", "--over", "pinion_speed=3600rpm:4400rpm:5", "--over", "D=0.6:1:3", "--json"
    )
    answer = ran.answer
    assert ran.code == 0
    assert problems(answer, answer_schema(answer_kind("map"))) == []
    case = gl.load_case("article")
    speeds = gl.Axis("omega", case.scales.omega_from_rpm(np.linspace(3600.0, 4400.0, 5)))
    expected = gl.map_plane(case, speeds, gl.Axis.even("D", 0.6, 1.0, 3))
    named = {row["code"]: row["label"] for row in answer["labels"]}
    found = [[named[code] for code in row] for row in answer["codes"]]
    assert found == [[expected.label_at(row, column) for column in range(5)] for row in range(3)]
    assert answer["impact_free"] == int(expected.impact_free.sum()) > 0
    assert sum(row["pixels"] for row in answer["labels"]) == 15
    ends = {p["name"]: p["value"] for p in answer["x"]["physical_upper"]}
    assert ends["pinion_speed"] == pytest.approx(4400.0, rel=1e-13)
    assert {p["name"] for p in answer["y"]["physical_upper"]} == {"backlash"}
    assert not {"omega", "D"} & set(answer["parameters"])


def test_in_words(gearlash: Gearlash):
    ran = gearlash("map", *PLANE)
    assert (ran.code, ran.err) == (0, "")
    words = " ".join(ran.out.split())
    assert words.startswith("omega from 0.6 to 0.9 and D from 0.5 to 1.5, 4 × 3 pixels, one start each: ")
    assert "12 ok" in words
    assert "1-1-0" in words


def test_motions_are_told_in_the_units_that_were_typed(gearlash: Gearlash):
    """A unit behind the second end holds for the first one too."""
    ran = gearlash("map", "article", "--over", "pinion_speed=3600:4400 rpm:3", "--over", "D=0.6:1:2")
    words = " ".join(ran.out.split())
    assert ran.code == 0
    assert "pinion speed 3600 to 4400 rpm" in words
    assert "share pinion speed, rpm D" in words
    assert "1-0-0 2 33.3 % 4000 0.6 to 1" in words
    assert gearlash("map", *PLANE).out.split("each occurs")[1].split()[:4] == [
        "pixels",
        "share",
        "omega",
        "D",
    ]


def test_statuses_that_are_not_ok_come_with_advice(gearlash: Gearlash):
    ran = gearlash(
        "map", "article", "--over", "omega=0.6:0.62:2", "--over", "D=0.3:0.32:2", "--periods", "120"
    )
    assert "unresolved no periodic motion was proved" in " ".join(ran.out.split())


def test_out_is_netcdf_json_and_figures(gearlash: Gearlash, tmp_path: Path):
    ran = gearlash("map", *PLANE, "--out", str(tmp_path), "--json")
    dataset = gl.load_dataset(tmp_path / "map.nc")
    assert dataset["label"].values.tolist() == ran.answer["codes"]
    assert json.loads((tmp_path / "map.json").read_text(encoding="utf-8")) == ran.answer
    assert (tmp_path / "map.svg").read_bytes().startswith(b"<?xml")
    assert (tmp_path / "map.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize("again", [False, True], ids=["once", "and once more while it is kept"])
def test_ctrl_c_keeps_what_was_computed(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, again: bool
):
    import gearlash.cli.files as files
    import gearlash.cli.progress as progress

    @contextmanager
    def interrupting(title: str) -> Iterator[object]:
        def callback(state: gl.jobs.Progress) -> None:
            if state.done == 6:  # a line of 3 pixels is one task
                os.kill(os.getpid(), signal.SIGINT)

        yield callback

    def written_late(*arguments: Any) -> memoryview:
        os.kill(os.getpid(), signal.SIGINT)
        return written(*arguments)

    monkeypatch.setattr(progress, "progress_bar", interrupting)
    if again:
        written = files.netcdf
        monkeypatch.setattr(files, "netcdf", written_late)
    ran = gearlash("map", *PLANE, "--workers", "1", "--out", str(tmp_path))
    assert ran.code == 130
    assert "incomplete, 6 pixels missing" in ran.out
    assert gl.load_dataset(tmp_path / "map.nc").attrs["complete"] == 0
    assert (tmp_path / "map.json").exists()
    assert not (tmp_path / "map.svg").exists()


def test_pixels_that_fail_are_named(gearlash: Gearlash):
    """A frequency too far below the natural ones fails, the pixels beside it do not."""
    typed = ("kahraman-singh", "--over", "omega=1e-6:0.9:2", "--over", "D=0.5:1.5:2")
    ran = gearlash("map", *typed, "--json")
    answer = ran.answer
    assert (ran.code, answer["status"]) == (3, "partly-failed")
    assert answer["statuses"] == {"failed": 2, "ok": 2}
    assert [(pixel["x"], pixel["y"]) for pixel in answer["failed"]] == [(1e-6, 0.5), (1e-6, 1.5)]
    assert "cells a period would be needed" in answer["failed"][0]["reason"]
    assert [row[0] for row in answer["codes"]] == [-1, -1]
    words = " ".join(gearlash("map", *typed).out.split())
    assert "2 of 4 pixels failed, the first: omega = 1e-06, D = 0.5, " in words
    assert "omega = 1e-06, D = 0.5: " in words


ONE = ("--over", "omega=0.5:1.4:9")
BAD = {
    "one axis": (ONE, "1 given"),
    "three axes": ((*ONE, "--over", "D=0.5:1:3", "--over", "load=0.1:0.2:3"), "3 given"),
    "the same twice": ((*ONE, "--over", "omega=0.5:1.4:9"), "do not name the same quantity"),
    "the same by two names": ((*ONE, "--over", "pinion_speed=3600rpm:4400rpm:9"), "do not name the same"),
    "too many": (("--over", "omega=0.5:1.4:2000", "--over", "D=0.5:1:2000"), "1,000,000 pixels"),
    "set too": ((*ONE, "--over", "D=0.5:1:3", "--set", "D=1"), "one of two that name the same"),
    "both wrong": (("--over", "omga=0.5:1.4:9", "--over", "D=1:0.5:3"), "omega"),
}


@pytest.mark.parametrize("kind", BAD)
def test_bad_axes_are_named(gearlash: Gearlash, kind: str):
    typed, part = BAD[kind]
    ran = gearlash("map", "article", *typed)
    assert ran.code == 2
    assert part in ran.complaint
    assert "Traceback" not in ran.err
