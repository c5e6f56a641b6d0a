"""Zones in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.edges import shown_edge
from gearlash.case.units import pretty
from gearlash.cli.answers.asked import is_quantity
from gearlash.cli.answers.outcome import INCOMPLETE
from gearlash.cli.answers.zones import ZonesAnswer
from gearlash.cli.answers.zones_parts import Resident, Stay, ZoneEnd, ZoneFound
from gearlash.cli.answers.zones_words import how_far

from .layout import assumed, facts, headline, note
from .numbers import Marks, at_least, known

NEAR = 1e-9  # relative: what lies so near to each other is told as one interval
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
    yield from assumed((answer.axis.held,), width)
    footnote = marks.footnote()
    if footnote:
        yield from note(footnote, width)


def _examined(answer: ZonesAnswer) -> str:
    """What was looked at, and so what may have been missed."""
    asked, unit = answer.asked, answer.asked.unit
    reach = asked.between(*(f"{asked.value(end):.6g}" for end in (answer.axis.lower, answer.axis.upper)))

    def length(step: float) -> str:
        text = at_least(abs(asked.value(step)), 3)
        return f"{text} {pretty(unit)}" if unit else text

    cold = "cold" if answer.start is None else "the state that was given at every value"
    said = (
        f"From {cold}, up and down sweeps of {answer.axis.count} values, {reach}, and from beyond the "
        f"ends of the motions found: {answer.starts} starts. {_followed(answer)} "
        f"That no other motion exists is not claimed: one to which "
        f"none of these starts leads, such as one that lives within {length(answer.resolution)} between two "
        "of the values, may have been missed."
    )
    if answer.step > 0.0:
        said += (
            f" Inside the zones neighbouring orbits of a branch lie {length(answer.step)} apart at the most; "
            "multipliers and extrema were followed one by one from each to the next. Assured means: a stable "
            "orbit exists at every value, provided that between two neighbours the monodromy strays from the "
            "straight line by no more than twice as much as it does in the middle: that is not proved."
        )
    return said


def _followed(answer: ZonesAnswer) -> str:
    if answer.status != INCOMPLETE:
        return f"Every periodic motion was followed along its whole branch ({answer.branches} in all)."
    return f"Before the search was stopped {answer.branches} branches were followed, not all of them."


def _edges(answer: ZonesAnswer, zone: ZoneFound) -> tuple[str, str]:
    asked, here = answer.asked, answer.present
    return asked.edge(zone.lower.inner(1), 1, here), asked.edge(zone.upper.inner(-1), -1, here)


def _facts(answer: ZonesAnswer, zone: ZoneFound, marks: Marks) -> Iterator[tuple[str, str]]:
    yield "from", _end(answer, zone.lower, 1, marks)
    yield "to", _end(answer, zone.upper, -1, marks)
    first = "margin"
    for margin, end, inwards in ((zone.margin_below, zone.lower, 1), (zone.margin_above, zone.upper, -1)):
        if margin is not None:
            yield first, f"{margin.event} {how_far(answer.asked, margin, end, answer.present, inwards)}"
            first = ""
    if zone.unique:
        yield (
            "proved",
            "at every value of the axis inside all motions come together (contraction): there is no other",
        )
    yield from _assured(answer, zone)
    for i, resident in enumerate(zone.residents):
        yield "" if i else "motions", _motion(answer, resident)


def _assured(answer: ZonesAnswer, zone: ZoneFound) -> Iterator[tuple[str, str]]:
    """Between which values a stable orbit is assured, whatever its label."""
    found: list[tuple[float, float]] = []
    for low, high in sorted((r.assured.lower, r.assured.upper) for r in zone.residents if r.assured):
        if found and low <= found[-1][1] + NEAR * abs(low):
            found[-1] = found[-1][0], max(high, found[-1][1])
        else:
            found.append((low, high))
    if found:
        yield (
            "assured",
            "a stable orbit at every value, "
            + ", ".join(answer.asked.between(*answer.asked.inner(*part)) for part in found),
        )


def _motion(answer: ZonesAnswer, r: Resident) -> str:
    """Where a motion is stable, and where its whole branch exists."""
    noisy = "" if r.quiet else "; not quiet"
    found = f"({', '.join(r.directions)}){noisy}"
    if r.stable is None or r.exists is None:
        where = _reach(answer, r.lower, r.upper)
        return f"{r.label} seen at {where} {found}; it has no branch that could be followed"
    stable, exists = r.stable, r.exists
    told = f"{r.label} stable {_stay(answer, stable)} {found}"
    if (stable.lower, stable.upper) == (exists.lower, exists.upper):
        return f"{told}; so far its branch exists"
    return f"{told}; its branch exists {_stay(answer, exists)}"


def _stay(answer: ZonesAnswer, stay: Stay) -> str:
    """From where to where, rounded into it, and what happens at both ends."""
    unit = f" {pretty(answer.asked.unit)}" if answer.asked.unit else ""
    kinds = (
        "limit of the scan" if kind == "end of the range" else kind
        for kind in (stay.lower_kind, stay.upper_kind)
    )
    ends = zip(answer.asked.inner(stay.lower, stay.upper), kinds, strict=True)
    low, high = (f"{shown}{unit} ({kind})" for shown, kind in ends)
    return f"from {low} to {high}"


def _reach(answer: ZonesAnswer, lower: float, upper: float) -> str:
    asked, unit = answer.asked, f" {pretty(answer.asked.unit)}" if answer.asked.unit else ""
    if lower == upper:
        return f"{asked.value(lower):.6g}{unit}"
    return " to ".join(asked.inner(lower, upper)) + unit


def _end(answer: ZonesAnswer, end: ZoneEnd, inwards: int, marks: Marks) -> str:
    """The end as everywhere (see `shown_edge`) in its physical units, that asked for first, and the value
    with all its digits."""
    halved = end.uncertainty > 0.0 and not end.solved
    value = f"{known(end.value, end.uncertainty)} ± {end.uncertainty:.0e}" if halved else f"{end.value:.10g}"
    shown: list[str] = []
    for p in sorted(end.physical, key=lambda p: p.name != answer.asked.name):
        factor = p.value / end.value if end.value else 0.0
        text = shown_edge(
            factor * end.inner(inwards), inwards if factor >= 0.0 else -inwards, answer.present * factor
        )
        of = " of the pinion" if answer.asked.of_gear and p.name in ("pinion_speed", "torque") else ""
        shown.append(marks.of(f"{text} {pretty(p.unit)}{of}", p.rests_on))
    if answer.asked.of_gear and end.physical:
        edge = answer.asked.edge(end.inner(inwards), inwards, answer.present)
        shown.insert(0, marks.of(answer.asked.with_unit(edge), end.physical[0].rests_on))
    if not (answer.asked.unit and shown and is_quantity(answer.axis.name)):
        shown.insert(1 if answer.asked.unit and shown else 0, f"{answer.axis.name} {value}")
    how = end.kind + (
        f", {end.inside} inside, {end.outside} outside ({end.direction})" if end.outside else ""
    )
    return f"{', '.join(shown)}: {how}"
