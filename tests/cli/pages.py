"""A page of the documentation as a reader follows it: its commands, what it shows of them, its Python."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

from cli.conftest import Gearlash

DOCS = Path(__file__).resolve().parents[2] / "docs"


def page(name: str) -> str:
    """The text of a page."""
    return (DOCS / name).read_text(encoding="utf-8")


def follow(text: str, gearlash: Gearlash) -> int:
    """Runs every command of a page once and looks for the lines that the page shows of it; how many there
    are."""
    blocks = "".join(re.findall(r"```console\n(.*?)```", text, re.DOTALL))
    commands = re.findall(r"^\$ gearlash (.*)\n((?:(?!\$ ).*\n)*)", blocks, re.M)
    known: dict[str, str] = {}
    for command, shown in commands:
        if command not in known:
            ran = gearlash(*shlex.split(command))
            assert ran.code == 0, command
            known[command] = ran.out
        printed = {bare(line) for line in known[command].splitlines()}
        missing = [line for line in shown.splitlines() if bare(line) not in printed]
        assert missing == [], f"{command}\n{known[command]}"
    return len(commands)


def bare(line: str) -> str:
    """Without estimates of errors, which are rounding and differ from processor to processor."""
    return " ".join(re.sub(r"\b\de-1\d\b", "", line).split())


def run_python(text: str, name: str) -> dict[str, Any]:
    """What the Python of a page leaves behind by name."""
    script = "\n".join(re.findall(r"```python\n(.*?)```", text, re.DOTALL))
    names: dict[str, Any] = {}
    exec(compile(script, name, "exec"), names)  # the point of these tests
    return names
