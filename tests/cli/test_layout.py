"""Tables in the terminal."""

from __future__ import annotations

import pytest

from gearlash.cli.show.layout import table

REASON = "no step is short enough: " + "steps down to 1e-10 are refused " * 6
PASSED = "grazing at 0.5 (1-0-0 | 1-1-0), " * 3


@pytest.mark.parametrize("width", [80, 120, 140, 240])
def test_one_long_cell_makes_no_table_wider_than_the_terminal(width: int):
    """And no word of it is lost."""
    columns = [("", "left"), ("to", "right"), ("ended by", "left"), ("passed", "left")]
    rows = [("down", "0.1234567", REASON, PASSED), ("up", "1", "end", "nothing")]
    lines = [line.plain for line in table("Followed", columns, rows, width)]  # pyright: ignore
    assert max(map(len, lines)) <= width
    told = sorted(" ".join(lines).split())
    assert told == sorted(f"Followed to ended by passed {' '.join(map(' '.join, rows))}".split())
