"""docs/first-case.md: its case, every command in it, every line it shows, its Python."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from cli.conftest import Gearlash

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "first-case.md").read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE, re.DOTALL)


def transcripts() -> list[tuple[str, list[str]]]:
    """Commands in the order of the page, each with the lines shown of its output."""
    found: list[tuple[str, list[str]]] = []
    for line in "".join(blocks("console")).splitlines():
        if line.startswith("$ "):
            found.append((line.removeprefix("$ "), []))
        else:
            found[-1][1].append(line)
    return found


def test_every_command_prints_what_the_page_shows(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    (case,) = blocks("toml")
    Path("pair.toml").write_text(case, encoding="utf-8")
    commands = transcripts()
    assert len(commands) == 7
    for command, shown in commands:
        program, *arguments = shlex.split(command)
        assert program == "gearlash"
        ran = gearlash(*arguments)
        assert ran.code == 0, command
        printed = ran.out.splitlines()
        missing = [line for line in shown if line not in printed]
        assert missing == [], f"{command}\n{ran.out}"
    for file in ("high/run.json", "high/portrait.svg", "study/sweep.svg", "study/sweep.nc"):
        assert Path(file).exists()


def test_the_python_of_the_page_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    Path("pair.toml").write_text(blocks("toml")[0], encoding="utf-8")
    (script,) = blocks("python")
    exec(compile(script, "first-case.md", "exec"), {})  # the point of this test
