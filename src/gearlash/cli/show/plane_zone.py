"""A zone in a plane of two parameters, in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.edges import at_most
from gearlash.case.units import pretty
from gearlash.cli.answers.plane_zone import WORDS, MarginAlong, PlaneZoneAnswer, how_far, times

from .layout import assumed, facts, headline, note, table
from .numbers import Marks

RANGE_END = "end of the range"


def plane_zone_view(answer: PlaneZoneAnswer, width: int) -> Iterator[Text]:
    """Sentence, margins, the curves of the boundary, and what was looked at."""
    marks, both = Marks({}), [path for each in answer.rests_on for path in each]
    yield from headline(answer.sentence, width)
    if answer.status != "ok" or answer.notes:
        yield from facts("", [("status", answer.status), *(("note", each) for each in answer.notes)], width)
    yield from facts(f"Margins of the operating point, {answer.label}", list(_margins(answer, marks)), width)
    if answer.boundary:
        rows = [
            (
                each.kind,
                *(marks.of(_place(answer, each.values[i]), both) for i in (0, -1)),
                each.event,
            )
            for each in answer.boundary
        ]
        columns = [("kind", "left"), ("from", "left"), ("to", "left"), ("event", "left")]
        yield from table(f"Curves that bound the zone {WORDS[answer.kind]}", columns, rows, width)
    if answer.special:
        rows = [(marks.of(_place(answer, each.values), both), each.kind) for each in answer.special]
        yield from table(
            "Where one takes over from another", [("where", "left"), ("what", "left")], rows, width
        )
    yield from note(_examined(answer), width)
    yield from assumed(answer.held, width)
    footnote = marks.footnote()
    if footnote:
        yield from note(footnote, width)


def _margins(answer: PlaneZoneAnswer, marks: Marks) -> Iterator[tuple[str, str]]:
    for margin in answer.margins:
        asked = answer.asked[answer.names.index(margin.parameter)]
        which = answer.names.index(margin.parameter)
        rests = answer.rests_on[which] if margin.bounded else ()  # the end of the range is as it was typed
        far = marks.of(how_far(margin, asked, answer.at[which]), rests)
        yield asked.title, f"{_event(margin)} {far}{_others(margin, asked.name)}"
    for each in answer.together:
        where = f"{each.event} at {_place(answer, each.values)}" if each.bounded else "the range ends first"
        rests = [path for own in answer.rests_on for path in own] if each.bounded else []
        yield f"tolerances, {each.norm}", marks.of(f"{times(each)} their size: {where}", rests)


def _event(margin: MarginAlong) -> str:
    if margin.bounded:
        return margin.event
    return (
        "nothing within the range, which ends"
        if margin.event == RANGE_END
        else f"{margin.event}, nothing until"
    )


def _others(margin: MarginAlong, name: str) -> str:
    others = [f"{at_most(each.value)} {pretty(each.unit)}" for each in margin.physical if each.name != name]
    return f"; {', '.join(others)}" if others else ""


def _place(answer: PlaneZoneAnswer, values: tuple[float, float]) -> str:
    return ", ".join(asked.text(value) for asked, value in zip(answer.asked, values, strict=True))


def _examined(answer: PlaneZoneAnswer) -> str:
    return (
        f"The motion of the operating point was followed along {answer.lines} straight lines of the plane "
        f"and solved for at {answer.places} places, and so was every point of the curves. That it exists and "
        "is stable between the lines follows by continuity, unless a part of the boundary, such as a closed "
        "curve, meets none of them. Other motions were looked for at the operating point alone."
    )
