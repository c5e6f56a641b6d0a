"""A report as a folder: the page, its figures, its numbers."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from concurrent.futures import Executor
from pathlib import Path

from gearlash.results.store import write_whole

from .blocks import Page
from .data import as_json
from .page import html
from .pictures import Picture, write

PAGE, DATA, FIGURES = "report.html", "report.json", "figures"
_LINKED = re.compile(rb'href="' + FIGURES.encode() + rb'/([\w-]+\.(?:svg|pdf))"')


def write_report(
    page: Page,
    pictures: Sequence[Picture],
    numbers: object,
    folder: Path | str,
    executor: Executor | None = None,
    instead_of: Iterable[str] = (),
) -> Path:
    """Writes a report into a folder: the page, its numbers, its figures. Where a report is there already, it
    takes its place: of figures of that page those go that the new one does not have.

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
    instead_of : iterable of str, optional
        Names of other files of an earlier report, which go with it.

    Returns
    -------
    Path
        Of the page: ``report.html``, one file that works offline. ``figures/`` has every figure as SVG and
        PDF.
    """
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    path = target / PAGE
    earlier = _parts(path, instead_of)
    figures = write(pictures, target / FIGURES, executor)
    write_whole(path, html(page, figures, FIGURES).encode("utf-8"))
    write_whole(target / DATA, as_json(numbers).encode("utf-8"))
    for name in earlier - _parts(path):  # last: where something cannot be written, nothing is lost
        (target / name).unlink(missing_ok=True)
    return path


def _parts(page: Path, others: Iterable[str] = ()) -> set[str]:
    """Figures that a page links to, and other names; none where there is no page."""
    if not page.is_file():
        return set()
    names = _LINKED.findall(page.read_bytes())
    return {*others, *(f"{FIGURES}/{name.decode()}" for name in names)}
