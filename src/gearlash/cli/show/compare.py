"""A comparison with a measurement in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.compare import WORDS, CompareAnswer, ComparedPeak, ComparedSpeed, EventNear

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
    ways = {each.curve for each in answer.peaks} - {"measured"}
    alike = len(ways) == 1  # the largest value of one way is that of the other, too, or it has none
    yield from facts("Largest", [_peak(each, unit, speed, alike) for each in answer.peaks], width)
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
    shown = rows_shown(answer)
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
        for p in shown
    ]
    order = f" {answer.order:g}" if answer.order is not None else ""
    title = f"{answer.quantity}, {answer.figure}{order}{f' [{pretty(answer.unit)}]' if answer.unit else ''}"
    if len(shown) < len(answer.points):
        title += f": {len(rows_)} of {len(answer.points)} rows, the largest among them (--csv has all)"
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


def _peak(peak: ComparedPeak, unit: str, speed: str, alike: bool) -> tuple[str, str]:
    """Where a curve is largest, and what the others have at that speed; ``alike`` where the computed curves
    are not largest at two."""
    at = f"{peak.speed:.6g}{speed}"
    if peak.mesh_frequency is not None and "Hz" not in speed:
        at += f" ({peak.mesh_frequency:.5g} Hz of the mesh)"
    computed = _both(peak, unit)
    if peak.curve == "measured":
        return "measured", f"{peak.measured:.4g}{unit} at {at}; computed there: {computed}"
    own = peak.up if peak.curve == "up" else peak.down
    both = alike and _number(peak.up) == _number(peak.down)
    name = "computed" if both else f"computed, {WORDS[peak.curve]}"
    return name, f"{_number(own)}{unit} at {at}; measured there: {peak.measured:.4g}{unit}"


def _both(peak: ComparedPeak, unit: str) -> str:
    """What is computed at a speed, once where both ways of speed have it."""
    known = [(value, way) for value, way in ((peak.up, "up"), (peak.down, "down")) if value is not None]
    if not known:
        return "nothing was found"
    if len({_number(value) for value, _ in known}) == 1:
        return f"{_number(known[0][0])}{unit}"
    return ", ".join(f"{_number(value)}{unit} with {WORDS[way]}" for value, way in known)


def rows_shown(answer: CompareAnswer) -> list[ComparedSpeed]:
    """All rows where they are few; else even ones, and those that even ones may miss: the largest measured
    and computed values and the largest residual, and both ends of every jump."""
    points = answer.points
    step = max(1, -(-len(points) // SHOWN))
    kept = set(range(0, len(points), step)) | {len(points) - 1}
    for read in (_measured, _up, _down, _off):
        sizes = [(value, at) for at, point in enumerate(points) if (value := read(point)) is not None]
        kept |= {max(sizes)[1]} if sizes else set()
    ends = {end for jump in answer.jumps for end in (jump.lower, jump.upper)}
    kept |= {at for at, point in enumerate(points) if point.speed in ends}
    return [points[at] for at in sorted(kept)]


def _measured(point: ComparedSpeed) -> float | None:
    return point.measured


def _up(point: ComparedSpeed) -> float | None:
    return point.up


def _down(point: ComparedSpeed) -> float | None:
    return point.down


def _off(point: ComparedSpeed) -> float | None:
    return None if point.residual is None else abs(point.residual)


def _way(direction: str) -> str:
    return f", {WORDS[direction]}" if direction else ""


def _event(event: EventNear, speed: str) -> str:
    return (
        f"{event.kind} at {event.lower:.6g}{speed}, {event.below} | {event.above}, {WORDS[event.direction]}"
    )


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"
