"""docs/own-system.md: its case, every command and message in it, its twenty lines of Python."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import pytest

from cli.conftest import Gearlash
from gearlash.case import bundled, load

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "own-system.md").read_text(encoding="utf-8")
LINES = 20


def block(language: str) -> str:
    (found,) = re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)
    return found


@pytest.fixture
def case(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    path = Path("rattle.toml")
    path.write_text(block("toml"), encoding="utf-8")
    return path


def test_every_command_prints_what_the_page_shows(gearlash: Gearlash, case: Path):
    commands = re.findall(r"^\$ gearlash (.*)\n((?:(?!\$ ).*\n)*)", block("console"), re.MULTILINE)
    assert [shlex.split(command)[0] for command, _ in commands] == ["check", "run", "sweep", "graze"]
    for command, shown in commands:
        ran = gearlash(*shlex.split(command))
        assert ran.code == 0, command
        missing = [line for line in shown.splitlines() if line not in ran.out.splitlines()]
        assert missing == [], f"{command}\n{ran.out}"


def test_mistakes_are_told_as_the_page_shows(gearlash: Gearlash, case: Path):
    text = block("toml").replace("*kappa", "*kapa").replace("gap_minus", "gap_mins")
    case.write_text(text, encoding="utf-8")
    ran = gearlash("check", str(case))
    assert ran.code == 2
    assert ran.err.split() == block("text").split()  # lines break as wide as the terminal is


def test_the_family_takes_twenty_lines_and_moves():
    script = block("python")
    readme = (Path(__file__).resolve().parents[2] / "README.md").read_text(encoding="utf-8")
    assert f"```python\n{script}```" in readme.replace("\r", "")
    lines = [line for line in script.splitlines() if line.strip()]
    assert len(lines) <= LINES
    names: dict[str, Any] = {}
    exec(compile(script, "own-system.md", "exec"), names)  # the point of this test
    assert names["orbit"].status == "ok"
    labels = [point.label for point in names["sweep"].points]
    assert labels[-1] == "1-0-0"  # the stop lies beyond the response of amplitude 1/|1 - ω² + 2iζω| = 2.71
    assert labels[0] == "1-1-0"


def test_the_page_lists_the_systems_that_come_along():
    listed = set(re.findall(r"^\| `([a-z-]+)` \|", PAGE, re.MULTILINE))
    assert listed <= set(bundled())
    assert {name for name in bundled() if load(name).kind == "piecewise-linear"} <= listed
