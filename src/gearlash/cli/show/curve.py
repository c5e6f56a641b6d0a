"""Curves in the terminal."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.branch_parts import LimitsUsed
from gearlash.cli.answers.curve import CurveAnswer
from gearlash.cli.answers.curve_parts import CodimTwoFound, CurveEnd, CurveFound
from gearlash.results.contact_words import sided

from .layout import Column, assumed, facts, headline, note, table
from .numbers import Marks, number

MOST_LINES = 40  # special points of one curve; all of them are in --json
MOST_LABELS = 8
DIGITS = 10  # of a value that was solved for


def curve_view(answer: CurveAnswer, width: int) -> Iterator[Text]:
    """Sentence, every curve with its points and ends, and what was not looked for."""
    marks = Marks({})
    yield from headline(answer.sentence, width)
    if answer.status != "ok":
        rows = [("status", answer.status), ("message", answer.message), ("what to do", answer.advice)]
        yield from facts("", [row for row in rows if row[1]], width)
    for curve in answer.curves:
        yield from _curve(answer, curve, marks, width)
    if answer.not_begun:
        rows = [(f"{each.number}, {each.kind}", each.why) for each in answer.not_begun]
        yield from facts("No curve from", rows, width)
    if answer.not_looked_for:
        yield from note(f"Not looked for: {'; '.join(answer.not_looked_for)}.", width)
    yield from assumed((limit.held for limit in answer.axes), width)
    footnote = marks.footnote()
    if footnote:
        yield from note(footnote, width)


def _curve(answer: CurveAnswer, curve: CurveFound, marks: Marks, width: int) -> Iterator[Text]:
    labels = ", ".join(curve.labels[:MOST_LABELS])
    if len(curve.labels) > MOST_LABELS:
        labels += f" and {len(curve.labels) - MOST_LABELS} more labels"
    title = (
        f"Curve {curve.number}, from {curve.begun_at} of the {answer.start.source}: {curve.kind} of {labels}"
    )
    columns: list[Column] = [("", "right")]
    for limit in answer.axes:
        columns += [(_head(limit), "right"), ("error", "right")]
    columns += [("before | after", "left"), ("kind", "left")]
    shown = curve.special[:MOST_LINES]
    if shown:
        yield from table(title, columns, [_row(each, answer.axes, marks) for each in shown], width)
    else:
        yield from facts(title, [("points", "none at which two things happen at once found")], width)
    left = len(curve.special) - len(shown)
    if left:
        yield from note(f"and {left} more points (--json has all)", width)
    yield from facts("", list(_facts(answer, curve, marks)), width)


def _head(limit: LimitsUsed) -> str:
    return f"{limit.asked.title} [{pretty(limit.asked.unit)}]" if limit.asked.unit else limit.asked.title


def _row(point: CodimTwoFound, axes: tuple[LimitsUsed, ...], marks: Marks) -> list[str]:
    cells = [str(point.number)]
    for i, limit in enumerate(axes):
        asked, error = limit.asked, point.errors[i]
        own = [each for each in point.physical[i] if each.name == asked.name]
        rests = own[0].rests_on if own and asked.unit else ()
        cells.append(marks.of(f"{point.values_asked[i]:.{DIGITS}g}", rests))
        cells.append("–" if error is None else f"{abs(error * asked.factor):.0e}")
    kind = point.kind if point.solved else f"{point.kind} (a zero along the curve)"
    return [*cells, f"{point.label_before} | {point.label_after}", kind]


def _facts(answer: CurveAnswer, curve: CurveFound, marks: Marks) -> Iterator[tuple[str, str]]:
    if curve.fixed:
        parts = ", ".join(f"{name} = {value:.10g}" for name, value in curve.fixed.items())
        yield "where", f"{parts}, as at the point that it begins at"
    if curve.touches:
        yield "touches", sided(curve.touches, answer.case.between_teeth)
    if curve.throughout:
        yield "all along", f"{', '.join(curve.throughout)}; so no single point of that is told"
    stable = sum(orbit.unstable == 0 for orbit in curve.orbits)
    yield (
        "orbits",
        f"{len(curve.orbits)}, {stable} with no multiplier outside the unit circle, residual at most "
        + (number(curve.residual, 2)),
    )
    yield "admissible", _admissible(answer, curve, marks)
    for end, name in zip(curve.ends, ("begins", "ends"), strict=True):
        yield name, f"{_marked(answer, end.values, marks)}: {_why(answer, end)}"
    noted = [each for each in curve.special if each.note and each.note != each.kind]
    for i, each in enumerate(noted):
        yield "" if i else "to note", f"at {each.number}: {sided(each.note, answer.case.between_teeth)}"


def _why(answer: CurveAnswer, end: CurveEnd) -> str:
    """A limit is one of the parameters that were asked for, by its name."""
    limit = next((each for each in answer.axes if end.note.startswith(f"{each.name} = ")), None)
    if limit is not None:
        return f"limit of {limit.asked.title}"
    return f"{end.kind} ({sided(end.note, answer.case.between_teeth)})" if end.note else end.kind


def _admissible(answer: CurveAnswer, curve: CurveFound, marks: Marks) -> str:
    """Which of its orbits are ones of the real system."""
    real = sum(orbit.admissible for orbit in curve.orbits)
    if real == len(curve.orbits):
        return "all: orbits of the real system"
    if not real:
        return "none: no orbit of the real system on it"
    runs = [list(run) for ok, run in groupby(curve.orbits, key=lambda orbit: orbit.admissible) if ok]
    parts = [" to ".join(_marked(answer, run[i].values, marks) for i in (0, -1)) for run in runs]
    return f"{real} of {len(curve.orbits)}, orbits of the real system: {'; '.join(parts)}"


def _marked(answer: CurveAnswer, values: tuple[float, float], marks: Marks) -> str:
    return marks.of(_place(answer, values), [path for each in answer.rests_on for path in each])


def _place(answer: CurveAnswer, values: tuple[float, float]) -> str:
    return ", ".join(
        f"{limit.asked.title} {limit.asked.text(value, 8)}"
        if limit.asked.unit
        else limit.asked.text(value, 8)
        for limit, value in zip(answer.axes, values, strict=True)
    )
