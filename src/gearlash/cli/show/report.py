"""A report's verdict in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.cli.answers.report import ReportAnswer

from .layout import facts, headline


def report_view(answer: ReportAnswer, width: int) -> Iterator[Text]:
    """The sentence, then the lines."""
    yield from headline(answer.sentence, width)
    yield from facts("", [(line.title.lower(), line.text) for line in answer.lines], width)


def done_view(answer: ReportAnswer, width: int) -> Iterator[Text]:
    """Where the page is, and what is not in it."""
    rows = [("report", answer.report)] if answer.report else []
    if answer.missing:
        rows.append(("not computed", ", ".join(answer.missing)))
    yield from facts("", rows, width)
