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
    """Writes a report into a folder: the page, its numbers, its figures.

    Parameters
    ----------
    page : Page
    pictures : sequence of Picture
        One for each `Figure` of the page, by its ``stem``.
    numbers : dataclass or mapping
        What ``report.json`` holds; see `as_json`.
    folder : path
        Made if it is not there.
    executor : concurrent.futures.Executor, optional
        Draws figures side by side; without one this process draws them.

    Returns
    -------
    Path
        Of the page: ``report.html``, one file that works offline. ``figures/`` has every figure as SVG and
        PDF.
    """
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    figures = write(pictures, target / FIGURES, executor)
    path = target / PAGE
    write_whole(path, html(page, figures, FIGURES).encode("utf-8"))
    write_whole(target / DATA, as_json(numbers).encode("utf-8"))
    return path
