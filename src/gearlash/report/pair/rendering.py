"""A report of a pair as files: page, figures, numbers and data."""

from __future__ import annotations

from concurrent.futures import Executor
from pathlib import Path

from gearlash.report.folder import write_report
from gearlash.results.columns import POINTS, CsvStyle
from gearlash.results.store import write_whole

from .contents import Contents
from .document import document
from .files import VERDICT, data_files, file_names
from .verdict import verdict


def render(
    contents: Contents, folder: Path | str, executor: Executor | None = None, style: CsvStyle = POINTS
) -> Path:
    """Writes page, figures, numbers and data into a folder; returns the path of the page. Of a report that
    is there already nothing stays beside it."""
    page, pictures = document(contents)
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    data = data_files(contents, style)
    for name, content in data.items():
        write_whole(target / name, content)
    found = contents.found
    numbers = {
        "case": found.case,
        "verdict": verdict(found),
        "values": dict(found.values),
        "signals": found.signals,
        "separating": found.separating,
        "not_told": found.not_told,
        "back_side": found.back_side,
        "ranges": found.ranges,
        "missing": contents.missing,
    }
    earlier = {VERDICT, *file_names()} - data.keys()
    return write_report(page, pictures, numbers, target, executor, instead_of=earlier)
