"""A comparison with a measurement in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.compare import WORDS, CompareAnswer, EventNear

from .layout import facts, headline, note, table

SHOWN = 24  # rows
WAYS = {"up": "up", "down": "down", "": "?"}


def compare_view(answer: CompareAnswer, width: int) -> Iterator[Text]:
    """Sentence, jumps with their events, then the speeds."""
    yield from headline(answer.sentence, width)
    if answer.status != "ok":
        yield from facts("", [("status", answer.status), ("message", answer.message)], width)
    unit = f" {pretty(answer.unit)}" if answer.unit else ""
    speed = f" {pretty(answer.speed_unit)}" if answer.speed_unit else ""
    if answer.jumps:
        rows = [
            (
                f"{jump.lower:.6g} to {jump.upper:.6g}{speed}",
                f"{jump.change:+.3g}{unit}{_way(jump.direction)}: "
                + ("; ".join(_event(e, speed) for e in jump.events) or "no event near"),
            )
            for jump in answer.jumps
        ]
        yield from facts("Measured jumps, upwards in speed", rows, width)
    numbers = ("measured", "rising", "falling", "residual")
    columns = [(answer.speed_unit or "omega", "right"), ("way", "left")]
    columns += [*((name, "right") for name in numbers), ("motions", "left")]
    step = max(1, -(-len(answer.points) // SHOWN))
    rows_ = [
        [
            f"{p.speed:.6g}",
            WAYS[p.direction],
            f"{p.measured:.4g}",
            _number(p.up),
            _number(p.down),
            _number(p.residual),
            p.label_up if p.label_up == p.label_down else f"{p.label_up} | {p.label_down}",
        ]
        for p in answer.points[::step]
    ]
    order = f" {answer.order:g}" if answer.order is not None else ""
    title = f"{answer.quantity}, {answer.figure}{order}{f' [{pretty(answer.unit)}]' if answer.unit else ''}"
    if step > 1:
        title += f": {len(rows_)} of {len(answer.points)} rows (--csv has all)"
    yield from table(title, columns, rows_, width)
    if any(answer.columns):
        yield from note(f"Columns taken: {answer.columns[0]} (speed) and {answer.columns[1]}.", width)
    yield from note(
        "Residuals are to the motion computed with speed going the way of the row, where the rows say it. A "
        "jump is a change of the measurement of more than five times its median change, a tenth of its span "
        "and twice the changes beside it (more over missing rows); events are changes of the computed motion "
        "within two usual steps of it. That an event made a jump is not shown by that.",
        width,
    )


def _way(direction: str) -> str:
    return f", {WORDS[direction]}" if direction else ""


def _event(event: EventNear, speed: str) -> str:
    return (
        f"{event.kind} at {event.lower:.6g}{speed}, {event.below} | {event.above}, {WORDS[event.direction]}"
    )


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"
