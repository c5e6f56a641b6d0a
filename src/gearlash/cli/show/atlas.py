"""Atlases in the terminal."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.asked import Asked
from gearlash.cli.answers.atlas import AtlasAnswer, CurveFound, StraightFound
from gearlash.results.contact_words import sided

from .layout import assumed, facts, headline, note, table
from .numbers import Marks, number

MOST_CURVES, MOST_POINTS, MOST_LEFT = 60, 60, 20  # lines; all of them are in --json
KEY = (
    "motion: P-Q-R of the orbits of a curve in order, each once: P cycles with Q impacts on the drive side, "
    "R on the back side; what touches is not counted. attracts: share of the orbits with no multiplier "
    "outside the unit circle."
)
SAME = 1e-9  # of an axis: so near to its end is there
DIGITS = 8  # of what was solved for
MEANING = {
    "curve": "a curve of these motions lies between the two pixels",
    "coexistence": "both attract at one of the two pixels, certified",
    "special point without a curve": "special points were solved for between them that have no curve here",
    "aperiodic": "on one side nothing periodic was proved",
    "unexplained": "nothing that was found says why",
    "not looked at": "not looked at: it was stopped before",
}


def atlas_view(answer: AtlasAnswer, width: int) -> Iterator[Text]:
    """Sentence, curves, points, the check, and what was left undone."""
    marks = Marks({})
    yield from headline(answer.sentence, width)
    if answer.status != "ok":
        rows = [("status", answer.status), ("message", answer.message), ("done", ", ".join(answer.done))]
        yield from facts("", [row for row in rows if row[1]], width)
    yield from _curves(answer, marks, width)
    yield from _points(answer, marks, width)
    yield from _check(answer, width)
    yield from _undone(answer, marks, width)
    yield from note(f"Not looked for: {'; '.join(answer.not_looked_for)}.", width)
    yield from assumed((answer.x.held, answer.y.held), width)
    footnote = marks.footnote()
    if footnote:
        yield from note(footnote, width)


def _curves(answer: AtlasAnswer, marks: Marks, width: int) -> Iterator[Text]:
    if not answer.curves:
        return
    shown = answer.curves[:MOST_CURVES]
    columns = [("", "right"), ("kind", "left"), ("motion", "left"), ("attracts", "right"), ("ends", "left")]
    rows = [
        [
            str(curve.number),
            str(curve.kind),
            _labels(curve),
            f"{100.0 * curve.attracting / curve.points:.0f} %",
            "; ".join(
                [*_ends(answer, curve, marks), *(_straight(answer, each, marks) for each in curve.straight)]
            ),
        ]
        for curve in shown
    ]
    yield from table(_title("Curves", len(shown), len(answer.curves)), columns, rows, width)
    yield from note(KEY, width)


def _labels(curve: CurveFound) -> str:
    first = ", ".join(map(str, curve.labels[:2]))
    left = len(curve.labels) - 2
    return f"{first} and {left} more" if left > 0 else first


def _ends(answer: AtlasAnswer, curve: CurveFound, marks: Marks) -> list[str]:
    kinds = dict.fromkeys(str(end.kind) for end in curve.ends)
    if list(kinds) == ["limit of a parameter"]:
        return ["from limit to limit"]
    if len(kinds) == 1 and next(iter(kinds)).startswith("closed"):
        return ["closed loop"]
    return [f"{end.kind} at {_place(answer, end.values, marks)}" for end in curve.ends]


def _straight(answer: AtlasAnswer, piece: StraightFound, marks: Marks) -> str:
    one, other = answer.x.asked, answer.y.asked
    rests = answer.rests_on
    free, held = (other, one) if piece.name == answer.y.name else (one, other)
    on_free, on_held = (rests[1], rests[0]) if piece.name == answer.y.name else rests
    axis = answer.y if piece.name == answer.y.name else answer.x
    near = SAME * (axis.upper - axis.lower)
    if abs(piece.lower - axis.lower) <= near and abs(piece.upper - axis.upper) <= near:  # as it was asked for
        on_free = ()
    value, span = held.text(piece.value, DIGITS), free.span(piece.lower, piece.upper)
    return f"straight: {marks.of(value, on_held)} for {marks.of(span, on_free)}"


def _points(answer: AtlasAnswer, marks: Marks, width: int) -> Iterator[Text]:
    if not answer.points:
        return
    shown = answer.points[:MOST_POINTS]
    x, y = answer.x.asked, answer.y.asked
    heads = [marks.of(_heading(a), on) for a, on in zip((x, y), answer.rests_on, strict=True)]
    columns = [
        ("", "right"), *((head, "right") for head in heads), ("motion", "left"),
        ("curves", "left"), ("kind", "left"),
    ]  # fmt: skip
    rows = [
        [
            each.number,
            number(x.value(each.values[0]), DIGITS),
            number(y.value(each.values[1]), DIGITS),
            str(each.label),
            ", ".join(map(str, each.curves)),
            str(each.kind),
        ]
        for each in shown
    ]
    title = _title("Points where two things happen at once", len(shown), len(answer.points))
    yield from table(title, columns, rows, width)


def _check(answer: AtlasAnswer, width: int) -> Iterator[Text]:
    rows = [(str(count), MEANING[kind]) for kind, count in answer.changes.items() if count]
    if not rows:
        return
    yield from facts("Changes of motion between neighbouring pixels of the map", rows, width)
    shown = answer.not_explained[:MOST_LEFT]
    if shown:
        lines = [
            [
                f"{_place(answer, each.values[0])} to {_place(answer, each.values[1])}",
                f"{each.labels[0]} | {each.labels[1]}",
                sided(each.note, answer.case.between_teeth),
            ]
            for each in shown
        ]
        title = _title("Not explained", len(shown), len(answer.not_explained))
        yield from table(title, [("between", "left"), ("motions", "left"), ("", "left")], lines, width)


def _undone(answer: AtlasAnswer, marks: Marks, width: int) -> Iterator[Text]:
    """What was left undone, what is alike together."""
    alike = Counter((each.what, each.why) for each in answer.undone)
    if not alike:
        return
    first = {(each.what, each.why): each for each in reversed(answer.undone)}
    shown = list(alike.items())[:MOST_LEFT]
    rows = [
        [str(count), what, first[what, why].label, _place(answer, first[what, why].values, marks), why]
        for (what, why), count in shown
    ]
    columns = [("count", "right"), ("what", "left"), ("the first", "left"), ("at", "left"), ("why", "left")]
    yield from table(_title("Left undone", len(shown), len(alike)), columns, rows, width)


def _place(answer: AtlasAnswer, values: tuple[float, float], marks: Marks | None = None) -> str:
    """Of a pixel, which is as it was asked for, without ``marks``."""
    texts = answer.x.asked.text(values[0]), answer.y.asked.text(values[1])
    if marks is None:
        return ", ".join(texts)
    return ", ".join(marks.of(text, on) for text, on in zip(texts, answer.rests_on, strict=True))


def _heading(asked: Asked) -> str:
    return f"{asked.title}, {pretty(asked.unit)}" if asked.unit else asked.title


def _title(what: str, shown: int, every: int) -> str:
    return what if shown == every else f"{what}; the first {shown} of {every} (--json has all)"
