"""Maps in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.asked import Asked
from gearlash.cli.answers.map import MapAnswer
from gearlash.cli.answers.sweep import AxisUsed
from gearlash.system import Status

from .layout import assumed, facts, headline, table
from .numbers import number

MOST_LINES = 25  # of labels; all of them are in --json


def map_view(answer: MapAnswer, width: int) -> Iterator[Text]:
    """Sentence, statuses, and the motions that take most of the plane."""
    yield from headline(answer.sentence, width)
    yield from facts("", list(_facts(answer)), width)
    shown, x, y = answer.labels[:MOST_LINES], answer.x.asked, answer.y.asked
    rows = [
        [str(row.label), str(row.pixels), f"{100.0 * row.share:.1f} %", _span(row.x, x), _span(row.y, y)]
        for row in shown
    ]
    columns = [
        ("", "left"),
        ("pixels", "right"),
        ("share", "right"),
        (_heading(x), "right"),
        (_heading(y), "right"),
    ]
    left = len(answer.labels) - len(shown)
    title = "Motions, and the least and largest values at which each occurs" + (
        f"; the {len(shown)} most frequent of {len(answer.labels)} (--json has all)" if left else ""
    )
    yield from table(title if not answer.message else f"{title}; {answer.message}", columns, rows, width)
    yield from assumed((answer.x.held, answer.y.held), width)


def _facts(answer: MapAnswer) -> Iterator[tuple[str, str]]:
    if answer.status != "ok":
        yield "status", answer.status
    yield "pixels", ", ".join(f"{count} {status}" for status, count in answer.statuses.items())
    yield (
        "certificates",
        ", ".join(f"{count} {verdict}" for verdict, count in answer.certificates.items()) or "–",
    )
    for axis in (answer.x, answer.y):
        yield from _physical(axis)
    for status in Status:
        if status in answer.statuses and status.computed and not status.ok:  # such pixels are called flagged
            yield status, status.advice
    if answer.failed:
        first = answer.failed[0]
        yield (
            "first failure",
            f"{answer.x.asked.text(first.x)}, {answer.y.asked.text(first.y)}: {first.reason}",
        )


def _physical(axis: AxisUsed) -> Iterator[tuple[str, str]]:
    for low, high in zip(axis.physical_lower, axis.physical_upper, strict=True):
        yield (
            low.name.replace("_", " "),
            f"{number(low.value, 6)} to {number(high.value, 6)} {pretty(low.unit)}",
        )


def _heading(asked: Asked) -> str:
    return f"{asked.title}, {pretty(asked.unit)}" if asked.unit else asked.title


def _span(ends: tuple[float, float], asked: Asked) -> str:
    low, high = (number(asked.value(end), 4) for end in ends)
    return f"{low} to {high}" if low != high else low
