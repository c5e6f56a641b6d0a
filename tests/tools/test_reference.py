"""Pages of docs that are made from the program are those of this program."""

from __future__ import annotations

from pathlib import Path

import pytest

from tools.reference import write

DOCS = Path(__file__).resolve().parents[2] / "docs"


@pytest.mark.parametrize("page", ["cli.md", "results.md"])
def test_page_is_up_to_date(page: str, tmp_path: Path):
    """Renew it with `python -m tools.reference docs`."""
    write(tmp_path)
    assert (DOCS / page).read_text(encoding="utf-8") == (tmp_path / page).read_text(encoding="utf-8")


def test_every_option_has_a_name_for_its_value_and_one_default(tmp_path: Path):
    write(tmp_path)
    rows = [row for row in (tmp_path / "cli.md").read_text(encoding="utf-8").splitlines() if row[:3] == "| `"]
    assert len(rows) > 100
    assert [
        row for row in rows if row.count("[default: ") > 1 or "[default: ]" in row or " None`" in row
    ] == []
