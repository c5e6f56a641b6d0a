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
