"""A report as a folder: the page, its figures, its numbers."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from pathlib import Path

from gearlash.results.store import write_whole

from .blocks import Page
from .data import as_json
from .page import html
from .pictures import Picture, write

PAGE, DATA, FIGURES = "report.html", "report.json", "figures"


def write_report(
    page: Page,
    pictures: Sequence[Picture],
    numbers: object,
    folder: Path | str,
    executor: Executor | None = None,
) -> Path:
    """Writes ``report.html`` (one file that works offline), ``report.json`` (all ``numbers``) and
    ``figures/*.svg|pdf`` into ``folder``; returns the path of the page. An ``executor`` draws figures side by
    side; without one this process does.
    """
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    figures = write(pictures, target / FIGURES, executor)
    path = target / PAGE
    write_whole(path, html(page, figures, FIGURES).encode("utf-8"))
    write_whole(target / DATA, as_json(numbers).encode("utf-8"))
    return path
