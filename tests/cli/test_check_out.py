"""`gearlash check --out`: the answer and, of known teeth, their drawing."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from cli.conftest import Gearlash

CASES = Path(__file__).parents[1] / "cases"


@pytest.mark.parametrize(
    ("case", "drawn"), [(str(CASES / "drawing.toml"), True), ("article", True), ("kahraman-singh", False)]
)
def test_teeth_that_are_known_are_drawn(gearlash: Gearlash, tmp_path: Path, case: str, drawn: bool):
    ran = gearlash("check", case, "--out", str(tmp_path / "out"), "--json")
    assert ran.code == 0
    kept = json.loads((tmp_path / "out" / "check.json").read_text(encoding="utf-8"))
    assert kept == ran.answer
    for name in ("teeth.svg", "teeth.pdf"):
        assert (tmp_path / "out" / name).exists() == drawn


def test_a_foreign_file_is_not_written_over(gearlash: Gearlash, tmp_path: Path):
    (tmp_path / "teeth.svg").write_text("mine", encoding="utf-8")
    ran = gearlash("check", "article", "--out", str(tmp_path))
    assert ran.code == 2
    assert (tmp_path / "teeth.svg").read_text(encoding="utf-8") == "mine"
