"""Grazing points in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.asked import Asked, is_quantity
from gearlash.cli.answers.graze import HOLDS, GrazeAnswer, TouchFound
from gearlash.results.contact_words import sided

from .layout import assumed, facts, headline, note, table
from .numbers import Marks, number, polar, quantity
from .words import cycles

EXAMINED = (
    "This motion was followed from orbit to orbit: two touches within one step, of which the second undoes "
    "the first, may have been missed. Motions that coexist with it were not looked at (gearlash branch and "
    "gearlash sweep look at more of them)."
)


def graze_view(answer: GrazeAnswer, width: int) -> Iterator[Text]:
    """Sentence, every point found, and how the motion was followed."""
    marks = Marks({})
    yield from headline(answer.sentence, width)
    if not answer.points:
        yield from facts("", [("status", answer.status), ("what to do", answer.advice)], width)
    for touch in answer.points:
        yield from facts(_title(answer, touch), list(_facts(answer, touch, marks)), width)
    yield from _paths(answer, width)
    yield from assumed((answer.held,), width)
    footnote = marks.footnote()
    if footnote:
        yield from note(footnote, width)


def _title(answer: GrazeAnswer, touch: TouchFound) -> str:
    plain = f"{answer.over} = {touch.value:.13g}"
    if answer.asked.unit and is_quantity(answer.over):
        return answer.asked.text(touch.value, 10)
    return f"{answer.asked.text(touch.value, 10)}, {plain}" if answer.asked.unit else plain


def _facts(answer: GrazeAnswer, touch: TouchFound, marks: Marks) -> Iterator[tuple[str, str]]:
    if touch.physical:
        shown = (marks.of(quantity(p.value, pretty(p.unit), 8), p.rests_on) for p in touch.physical)
        yield "physical", ", ".join(shown)
    yield "kind", sided(touch.kind, answer.case.between_teeth)
    yield "gap", touch.clearance
    yield "type", touch.type
    sides = (touch.label_below, touch.stable_below), (touch.label_above, touch.stable_above)
    below, above = (label if stable is not False else f"{label} (unstable)" for label, stable in sides)
    yield "labels", f"{below} below, {above} above"
    yield "margin", _margin(answer, touch)
    yield "touch", f"phase {touch.phase:.6f} of {cycles(touch.period, answer.case.between_teeth)}"
    yield (
        "multipliers",
        ", ".join(polar(m.re, m.im, m.modulus) for m in touch.multipliers if m.im >= 0.0),
    )
    yield "distances", f"least |λ + 1| {number(touch.to_doubling)}, least |λ − 1| {number(touch.to_fold)}"
    yield "exponent", f"{number(touch.largest_exponent)} per unit of τ (the largest)"
    for i, c in enumerate(touch.conditions):
        verdict = "holds" if c.holds else f"does not hold to {HOLDS:.0e}"
        yield "" if i else "conditions", f"{i + 1}  {c.condition}: {number(c.value, 3)}, {verdict}"
    yield "accuracy", f"error of the value about {touch.error:.0e}, residual {touch.residual:.0e}"
    if touch.note:
        yield "to note", touch.note


def _margin(answer: GrazeAnswer, touch: TouchFound) -> str:
    """From where it was begun: ``247.8 rpm above the start (6.195 %)``."""
    asked = answer.asked
    far = f"{abs(touch.margin_asked):.4g}" + (f" {pretty(asked.unit)}" if asked.unit else "")
    side = "above" if touch.margin > 0.0 else "below"
    start = asked.value(answer.near)
    share = f" ({100.0 * abs(touch.margin_asked / start):.4g} %)" if start else ""
    return f"{far} {side} the start{share}"


def _paths(answer: GrazeAnswer, width: int) -> Iterator[Text]:
    if not answer.paths:
        yield from note(answer.message, width)
        return
    told = answer.asked if answer.asked.unit and is_quantity(answer.over) else None
    rows = []
    for path in answer.paths:
        passed = (
            f"{p.kind} at {_plain(told, p.value)} ({p.label_below} | {p.label_above})" for p in path.passed
        )
        ended = path.ended + (f"; beyond it {path.beyond}" if path.beyond else "")
        rows.append((path.direction, _plain(told, path.reached), ended, ", ".join(passed) or "nothing"))
    columns = [("", "left"), ("to", "right"), ("ended by", "left"), ("passed", "left")]
    start = f"{answer.over} = {answer.near:.7g}" if told is None else _plain(told, answer.near)
    yield from table(f"Followed from {start} ({answer.label})", columns, rows, width)
    yield from note(EXAMINED, width)


def _plain(asked: Asked | None, value: float) -> str:
    """A value of the parameter; of a quantity in the unit that it was asked for in."""
    return f"{value:.7g}" if asked is None else asked.text(value, 7)
