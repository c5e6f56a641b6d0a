"""docs/drawing.md: every command in it prints what it shows, its Python runs, its words exist."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from cli.conftest import Gearlash
from cli.pages import follow, page, run_python
from gearlash.case.kinds import kind_named

PAGE = page("drawing.md")


@pytest.mark.slow
def test_every_command_prints_what_the_page_shows_and_its_python_runs(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    assert follow(PAGE, gearlash) == 7
    assert Path("drawn/teeth.svg").exists()
    names = run_python(PAGE, "drawing.md")
    assert names["stiffness"].least < names["stiffness"].value < names["stiffness"].greatest


def test_words_of_the_table_are_places_of_a_file():
    leaves = {path.partition(".")[2] for path in kind_named("helical-pair").places} | {"module"}
    table = PAGE.partition("| the drawing says")[2].partition("\n\n")[0]
    words = set(re.findall(r"`(\w+)`", table))
    assert len(words) > 25
    assert words <= leaves
