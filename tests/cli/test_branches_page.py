"""docs/branches.md: every command on it prints what it shows, its lines of Python run."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.pages import follow, page, run_python

PAGE = page("branches.md")


@pytest.mark.slow
def test_every_command_prints_what_the_page_shows(gearlash: Gearlash, rattle: Path):
    assert follow(PAGE, gearlash) == 6
    names = {path.name for path in (rattle / "found").iterdir()}
    assert {
        "branch.json",
        "special.csv",
        "branch-1.csv",
        "branch-1.nc",
        "branch-1.json",
        "branch.svg",
    } <= names


@pytest.mark.slow
def test_its_python_runs(rattle: Path):
    names = run_python(PAGE, "branches.md")
    assert len(names["branch"].special) == 16
    assert names["doubled"].points[0].period == 2
    assert (rattle / "branches.svg").exists()
    assert (rattle / "over-a-sweep.svg").exists()
    assert names["over_omega"].values == names["fold"].values
    assert names["from_point"].values == names["values"]
    assert len(names["rows"]) == len(names["again"].points) == len(names["branch"].points)
    assert set(re.findall(r"`gl\.(\w+)", PAGE)) <= set(gl.__all__)


def test_every_kind_of_point_is_explained():
    rows = " ".join(re.findall(r"^\| ([^|]+) \|", PAGE, re.MULTILINE))
    kinds = {
        str(kind).partition(" ")[0] if str(kind).startswith("joins") else str(kind) for kind in gl.SpecialKind
    }
    assert [kind for kind in kinds if kind not in rows] == []
