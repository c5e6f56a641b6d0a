"""The report of the article's study: its parts, in the order they are read."""

from __future__ import annotations

from concurrent.futures import Executor
from pathlib import Path

from gearlash.article.reproduction import Reproduction
from gearlash.report import write_report

from .document import document

__all__ = ["document", "render"]


def render(reproduction: Reproduction, folder: Path | str, executor: Executor | None = None) -> Path:
    """Writes the report into ``folder`` (`gearlash.report.write_report`); returns the path of the page."""
    page, pictures = document(reproduction)
    return write_report(page, pictures, reproduction, folder, executor)
