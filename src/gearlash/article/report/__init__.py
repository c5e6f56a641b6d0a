"""The report of the article's study: its parts, in the order they are read."""

from __future__ import annotations

from concurrent.futures import Executor
from pathlib import Path

from gearlash.article.reproduction import Reproduction
from gearlash.article.verified import Verified
from gearlash.report import write_report

from .document import document

__all__ = ["document", "render"]


def render(
    reproduction: Reproduction,
    folder: Path | str,
    executor: Executor | None = None,
    *,
    real: Verified | None = None,
    checked: str = "",
) -> Path:
    """Writes the report into ``folder`` (`gearlash.report.write_report`); returns the path of the page.

    ``real`` is what a run found of the pair with real teeth; without it what is kept is shown, and
    ``checked`` is what a check said of that (`gearlash.article.verifying.checked`).
    """
    page, pictures = document(reproduction, real, checked)
    return write_report(page, pictures, reproduction, folder, executor)
