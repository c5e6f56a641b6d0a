"""docs/branches.md: every command on it prints what it shows, its lines of Python run."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import pytest

import gearlash as gl
from cli.conftest import Gearlash

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGE = (DOCS / "branches.md").read_text(encoding="utf-8")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder with the case of the page that this one sends its reader to."""
    monkeypatch.chdir(tmp_path)
    own = (DOCS / "own-system.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"```toml\n(.*?)```", own, re.DOTALL)
    Path("rattle.toml").write_text(text, encoding="utf-8")
    return tmp_path


def bare(line: str) -> str:
    """Without estimates of errors, which are rounding and differ from processor to processor."""
    return " ".join(re.sub(r"\b\de-1\d\b", "", line).split())


def test_every_command_prints_what_the_page_shows(gearlash: Gearlash, folder: Path):
    blocks = re.findall(r"```console\n(.*?)```", PAGE, re.DOTALL)
    commands = [
        found
        for block in blocks
        for found in re.findall(r"^\$ gearlash (.*)\n((?:(?!\$ ).*\n)*)", block, re.M)
    ]
    assert len(commands) == 6
    known: dict[str, str] = {}
    for command, shown in commands:
        if command not in known:
            ran = gearlash(*shlex.split(command))
            assert ran.code == 0, command
            known[command] = ran.out
        printed = {bare(line) for line in known[command].splitlines()}
        missing = [line for line in shown.splitlines() if bare(line) not in printed]
        assert missing == [], f"{command}\n{known[command]}"
    names = {path.name for path in (folder / "found").iterdir()}
    assert {
        "branch.json",
        "special.csv",
        "branch-1.csv",
        "branch-1.nc",
        "branch-1.json",
        "branch.svg",
    } <= names


def test_its_python_runs(folder: Path):
    script = "\n".join(re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL))
    names: dict[str, Any] = {}
    exec(compile(script, "branches.md", "exec"), names)  # the point of this test
    assert len(names["branch"].special) == 16
    assert names["doubled"].points[0].period == 2
    assert (folder / "branches.svg").exists()
    assert (folder / "over-a-sweep.svg").exists()
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
