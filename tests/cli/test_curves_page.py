"""docs/curves.md: every command on it prints what it shows, its lines of Python run."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.pages import follow, page, run_python

PAGE = page("curves.md")


@pytest.mark.slow
def test_every_command_prints_what_the_page_shows(gearlash: Gearlash, rattle: Path):
    assert follow(PAGE, gearlash) == 4
    names = {path.name for path in (rattle / "corner").iterdir()}
    assert {
        "curve.json",
        "special.csv",
        "branch-1.json",
        "curve-1.csv",
        "curve-1.nc",
        "curve-1.json",
        "curve.svg",
    } <= names


@pytest.mark.slow
def test_its_python_runs(rattle: Path):
    names = run_python(PAGE, "curves.md")
    assert [str(point.kind) for point in names["folds"].special] == ["grazing with a multiplier 1", "cusp"]
    met = names["grazings"].of_kind("grazing with a multiplier 1")[0]
    assert met.values == pytest.approx(names["meeting"].values, abs=1e-9)
    assert (rattle / "curves.svg").exists()
    assert len(names["rows"]) == len(names["again"].points) == len(names["folds"].points)
    assert set(re.findall(r"`gl\.(\w+)", PAGE)) <= set(gl.__all__)


def test_every_kind_of_point_is_explained():
    rows = " ".join(re.findall(r"^\| ([^|]+) \|", PAGE, re.MULTILINE))
    assert [str(kind) for kind in gl.CodimTwoKind if str(kind) not in rows] == []
