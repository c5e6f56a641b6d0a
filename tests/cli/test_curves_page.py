"""docs/curves.md: every command on it prints what it shows, its lines of Python run."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import pytest

import gearlash as gl
from cli.conftest import Gearlash

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGE = (DOCS / "curves.md").read_text(encoding="utf-8")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder with the case of the page that this one sends its reader to."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "120")
    own = (DOCS / "own-system.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"```toml\n(.*?)```", own, re.DOTALL)
    Path("rattle.toml").write_text(text, encoding="utf-8")
    return tmp_path


def bare(line: str) -> str:
    """Without estimates of errors, which differ from processor to processor."""
    return " ".join(re.sub(r"\b\de-\d\d\b", "", line).split())


def test_every_command_prints_what_the_page_shows(gearlash: Gearlash, folder: Path):
    blocks = re.findall(r"```console\n(.*?)```", PAGE, re.DOTALL)
    commands = [
        found
        for block in blocks
        for found in re.findall(r"^\$ gearlash (.*)\n((?:(?!\$ ).*\n)*)", block, re.M)
    ]
    assert len(commands) == 3
    for command, shown in commands:
        ran = gearlash(*shlex.split(command))
        assert ran.code == 0, command
        printed = {bare(line) for line in ran.out.splitlines()}
        missing = [line for line in shown.splitlines() if bare(line) not in printed]
        assert missing == [], f"{command}\n{ran.out}"
    names = {path.name for path in (folder / "corner").iterdir()}
    assert {
        "curve.json",
        "special.csv",
        "branch-1.json",
        "curve-1.csv",
        "curve-1.nc",
        "curve-1.json",
        "curve.svg",
    } <= names


def test_its_python_runs(folder: Path):
    script = "\n".join(re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL))
    names: dict[str, Any] = {}
    exec(compile(script, "curves.md", "exec"), names)  # the point of this test
    assert [str(point.kind) for point in names["folds"].special] == ["grazing with a multiplier 1", "cusp"]
    met = names["grazings"].of_kind("grazing with a multiplier 1")[0]
    assert met.values == pytest.approx(names["meeting"].values, abs=1e-9)
    assert (folder / "curves.svg").exists()
    assert len(names["rows"]) == len(names["again"].points) == len(names["folds"].points)
    assert set(re.findall(r"`gl\.(\w+)", PAGE)) <= set(gl.__all__)


def test_every_kind_of_point_is_explained():
    rows = " ".join(re.findall(r"^\| ([^|]+) \|", PAGE, re.MULTILINE))
    assert [str(kind) for kind in gl.CodimTwoKind if str(kind) not in rows] == []
