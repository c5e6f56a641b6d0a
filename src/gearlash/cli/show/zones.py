"""Zones in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.zones import ZoneEnd, ZoneFound, ZonesAnswer

from .layout import facts, headline, note
from .numbers import Marks, known, number, quantity

TITLES = {"impact-free": "Free of impacts", "drive-side-only": "Free of impacts on the back side"}


def zones_view(answer: ZonesAnswer, width: int) -> Iterator[Text]:
    """Sentence, then every interval with its ends and who lives in it."""
    marks = Marks({})
    yield from headline(answer.sentence, width)
    if answer.status != "ok":
        yield from facts("", [("status", answer.status), ("message", answer.message)], width)
    for zone in answer.zones:
        who = "every attractor found" if zone.every else "some of the attractors found only"
        title = (
            f"{TITLES[zone.kind]}, {who}: {answer.axis.name} {zone.lower.value:.7g} to {zone.upper.value:.7g}"
        )
        yield from facts(title, list(_facts(answer, zone, marks)), width)
    ends = f"{answer.axis.lower:.6g} to {answer.axis.upper:.6g}"
    yield from note(
        f"From cold, up and down sweeps of {answer.axis.count} values of {answer.axis.name} from {ends}; "
        f"intervals narrower than {number(answer.resolution, 2)} may have been missed.",
        width,
    )
    footnote = marks.footnote()
    if footnote:
        yield from note(footnote, width)


def _facts(answer: ZonesAnswer, zone: ZoneFound, marks: Marks) -> Iterator[tuple[str, str]]:
    yield "from", _end(zone.lower, marks)
    yield "to", _end(zone.upper, marks)
    if zone.margin is not None:
        yield "margin", f"{number(zone.margin)} from this case's {answer.axis.name}"
    for i, r in enumerate(zone.residents):
        where = f"{r.lower:.5g}" if r.lower == r.upper else f"{r.lower:.5g} to {r.upper:.5g}"
        noisy = "" if r.quiet else "; not quiet"
        yield "" if i else "motions", f"{r.label} at {where} ({', '.join(r.directions)}){noisy}"


def _end(end: ZoneEnd, marks: Marks) -> str:
    halved = end.uncertainty > 0.0 and not end.solved
    value = f"{known(end.value, end.uncertainty)} ± {end.uncertainty:.0e}" if halved else f"{end.value:.10g}"
    physical = "".join(
        f", {marks.of(quantity(p.value, pretty(p.unit), 6), p.rests_on)}" for p in end.physical
    )
    how = end.kind + (
        f", {end.inside} inside, {end.outside} outside ({end.direction})" if end.outside else ""
    )
    return f"{value}{physical}: {how}"
