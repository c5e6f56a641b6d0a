"""The rooms below `article` know neither the article nor its tables and figures."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[1] / "src" / "gearlash"
GUESTS = {"article", "cli"}  # the article's own room, and what shows it to a user
WORDS = re.compile(r"article|table[\s_-]*2(?!\d)|\bfig\.\s*\d", re.IGNORECASE)
ALLOWED = re.compile(
    r"""
    "article(-first-harmonic)?"     # bundled cases, in examples
    | [`"]article-literal[`"]+      # a value in case files
    | gearlash\.article | from\ \.article\ import  # the list of public names
    """,
    re.VERBOSE,
)
LOWER = sorted(
    path
    for path in PACKAGE.rglob("*")
    if path.suffix in {".py", ".toml", ".j2", ".css"}
    and path.relative_to(PACKAGE).parts[0] not in GUESTS
    and path.relative_to(PACKAGE).parts[:2] != ("case", "data")
)


def named(text: str) -> list[str]:
    """Lines that name the article."""
    return [line.strip() for line in text.splitlines() if WORDS.search(ALLOWED.sub("", line))]


def test_no_room_below_names_the_article():
    found = {str(path.relative_to(PACKAGE)): named(path.read_text(encoding="utf-8")) for path in LOWER}
    assert len(found) > 200, "the rooms are looked into"
    assert {path: lines for path, lines in found.items() if lines} == {}


@pytest.mark.parametrize(
    "line",
    ["the article's sign", "as in Table 2", "def table2_type(", "see Fig. 4", "ARTICLE_FORCE = 1"],
)
def test_a_line_that_names_the_article_is_found(line: str):
    assert named(f"first\n{line}\nlast") == [line]


def test_a_bundled_case_may_be_named():
    assert named('>>> case = gl.load_case("article")') == []
