"""Zones in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.edges import shown_edge
from gearlash.case.units import pretty
from gearlash.cli.answers.zones import ZonesAnswer
from gearlash.cli.answers.zones_parts import ZoneEnd, ZoneFound

from .layout import facts, headline, note
from .numbers import Marks, at_least, known

TITLES = {"impact-free": "Free of impacts", "drive-side-only": "Free of impacts on the back side"}


def zones_view(answer: ZonesAnswer, width: int) -> Iterator[Text]:
    """Sentence, then every interval with its ends and who lives in it, then what was looked at."""
    marks = Marks({})
    yield from headline(answer.sentence, width)
    if answer.status != "ok":
        rows = [("status", answer.status), ("message", answer.message)]
        yield from facts("", [row for row in rows if row[1]], width)
    for zone in answer.zones:
        who = "every attractor found" if zone.every else "at least one attractor found"
        ends = answer.asked.between(*_edges(answer, zone))
        yield from facts(f"{TITLES[zone.kind]}, {who}: {ends}", list(_facts(answer, zone, marks)), width)
    yield from note(_examined(answer), width)
    footnote = marks.footnote()
    if footnote:
        yield from note(footnote, width)


def _examined(answer: ZonesAnswer) -> str:
    """What was looked at, and so what may have been missed."""
    asked, unit = answer.asked, answer.asked.unit
    ends = asked.between(*(f"{asked.value(end):.6g}" for end in (answer.axis.lower, answer.axis.upper)))

    def length(step: float) -> str:
        text = at_least(abs(asked.value(step)), 3)
        return f"{text} {pretty(unit)}" if unit else text

    cold = "cold" if answer.start is None else "the state that was given at every value"
    said = (
        f"From {cold}, up and down sweeps of {answer.axis.count} values, {ends}: a zone narrower than "
        f"{length(answer.resolution)}, or a motion that lives between two of the values only, may have been "
        "missed."
    )
    if answer.step > 0.0:
        said += (
            f" Inside the zones quiet motion was followed in steps of {length(answer.step)} at the most: an "
            "interruption narrower than that may have been missed."
        )
    return said


def _edges(answer: ZonesAnswer, zone: ZoneFound) -> tuple[str, str]:
    asked, here = answer.asked, answer.present
    return asked.edge(zone.lower.inner(1), 1, here), asked.edge(zone.upper.inner(-1), -1, here)


def _facts(answer: ZonesAnswer, zone: ZoneFound, marks: Marks) -> Iterator[tuple[str, str]]:
    yield "from", _end(answer, zone.lower, 1, marks)
    yield "to", _end(answer, zone.upper, -1, marks)
    asked, here = answer.asked, answer.present
    if zone.margin is not None:
        lower = abs(here - zone.margin - zone.lower.uncertainty - zone.lower.value)
        upper = abs(here + zone.margin + zone.upper.uncertainty - zone.upper.value)
        end, inwards = (zone.lower, 1) if lower < upper else (zone.upper, -1)
        yield (
            "margin",
            f"{asked.distance(here, end.inner(inwards), inwards)}, from the present {asked.text(here)}",
        )
    for i, r in enumerate(zone.residents):
        low, high = (asked.value(value) for value in (r.lower, r.upper))
        where = f"{low:.5g}" if r.lower == r.upper else f"{low:.5g} to {high:.5g}"
        noisy = "" if r.quiet else "; not quiet"
        unit = f" {pretty(asked.unit)}" if asked.unit else ""
        yield "" if i else "motions", f"{r.label} at {where}{unit} ({', '.join(r.directions)}){noisy}"


def _end(answer: ZonesAnswer, end: ZoneEnd, inwards: int, marks: Marks) -> str:
    """The end as everywhere (see `shown_edge`) in its physical units, and the value with all its digits."""
    halved = end.uncertainty > 0.0 and not end.solved
    value = f"{known(end.value, end.uncertainty)} ± {end.uncertainty:.0e}" if halved else f"{end.value:.10g}"
    shown = [f"{answer.axis.name} {value}"]
    for p in end.physical:
        factor = p.value / end.value if end.value else 0.0
        text = shown_edge(
            factor * end.inner(inwards), inwards if factor >= 0.0 else -inwards, answer.present * factor
        )
        shown.append(marks.of(f"{text} {pretty(p.unit)}", p.rests_on))
    how = end.kind + (
        f", {end.inside} inside, {end.outside} outside ({end.direction})" if end.outside else ""
    )
    return f"{', '.join(shown)}: {how}"
