"""What tests of the command line share."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from gearlash.cli.app import app


@dataclass(frozen=True)
class Ran:
    """What one call of gearlash left behind."""

    code: int
    out: str
    err: str

    @property
    def complaint(self) -> str:
        """Standard error without its line breaks."""
        return " ".join(self.err.split())

    @property
    def answer(self) -> dict[str, Any]:
        """Standard output as one JSON object, strictly."""

        def refuse(constant: str) -> None:
            raise AssertionError(f"{constant} is not JSON")

        return json.loads(self.out, parse_constant=refuse)


Gearlash = Callable[..., Ran]


@pytest.fixture
def gearlash(monkeypatch: pytest.MonkeyPatch) -> Gearlash:
    """`gearlash("run", "article")` in this process, 100 columns wide."""
    monkeypatch.setenv("COLUMNS", "100")

    def call(*arguments: str) -> Ran:
        found = CliRunner().invoke(app, list(arguments))
        if found.exception is not None and not isinstance(found.exception, SystemExit):
            raise found.exception
        return Ran(found.exit_code, found.stdout, found.stderr)

    return call


@pytest.fixture
def rattle(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder, which is the current one, with the case of the page on systems of one's own."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "120")
    page = Path(__file__).resolve().parents[2] / "docs" / "own-system.md"
    (text,) = re.findall(r"```toml\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    Path("rattle.toml").write_text(text, encoding="utf-8")
    return tmp_path
