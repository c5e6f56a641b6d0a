"""A reproduction as a folder: the report, its figures, its numbers."""

from __future__ import annotations

from concurrent.futures import Executor
from pathlib import Path

from gearlash.studies.article import Reproduction

from .article import document
from .data import as_json
from .page import html
from .pictures import write

PAGE, DATA, FIGURES = "report.html", "report.json", "figures"


def render(reproduction: Reproduction, folder: Path | str, executor: Executor | None = None) -> Path:
    """Writes ``report.html`` (one file that works offline), ``report.json`` and ``figures/*.svg|pdf`` into
    ``folder``; returns the path of the page. An ``executor`` draws figures side by side; without one this
    process does."""
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    page, pictures = document(reproduction)
    figures = write(pictures, target / FIGURES, executor)
    path = target / PAGE
    path.write_text(html(page, figures, FIGURES), encoding="utf-8")
    (target / DATA).write_text(as_json(reproduction), encoding="utf-8")
    return path
