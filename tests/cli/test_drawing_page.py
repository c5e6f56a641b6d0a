"""docs/drawing.md: every command in it prints what it shows, its Python runs, its words exist."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import pytest

from cli.conftest import Gearlash
from gearlash.case.kinds import kind_named

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "drawing.md").read_text(encoding="utf-8")


def test_every_command_prints_what_the_page_shows_and_its_python_runs(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    text = "".join(re.findall(r"```console\n(.*?)```", PAGE, re.DOTALL))
    commands = re.findall(r"^\$ gearlash (.*)\n((?:(?!\$ ).*\n)*)", text, re.M)
    assert len(commands) == 7
    for command, shown in commands:
        ran = gearlash(*shlex.split(command))
        assert ran.code == 0, command
        printed = ran.out.splitlines()
        missing = [line for line in shown.splitlines() if line not in printed]
        assert missing == [], f"{command}\n{ran.out}"
    assert Path("drawn/teeth.svg").exists()
    (script,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    names: dict[str, Any] = {}
    exec(compile(script, "drawing.md", "exec"), names)  # the point of this test
    assert names["stiffness"].least < names["stiffness"].value < names["stiffness"].greatest


def test_words_of_the_table_are_places_of_a_file():
    leaves = {path.partition(".")[2] for path in kind_named("helical-pair").places} | {"module"}
    table = PAGE.partition("| the drawing says")[2].partition("\n\n")[0]
    words = set(re.findall(r"`(\w+)`", table))
    assert len(words) > 25
    assert words <= leaves
