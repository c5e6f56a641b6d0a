"""The article's five events: portraits and histories before, at and after each, and the conditions of
grazing.
"""

from __future__ import annotations

from gearlash import plots
from gearlash.article import Event, Reproduction
from gearlash.article.force import FORCE
from gearlash.article.reproduction import Coincidence, Part
from gearlash.plots.regimes import short
from gearlash.report.blocks import Block, Cell, Figure, Note, Section, Strong, Table, Text
from gearlash.report.numbers import complex_number, number, percent, scientific
from gearlash.report.pictures import Picture

from . import centre
from .quantities import Quantities, fixed_words, symbol
from .words import verdict, yes_or_no

BOUNDARY = {1: "Σ₁ (drive side)", -1: "Σ₂ (back side)", 0: "none"}


def section(done: Reproduction) -> tuple[Section, list[Picture]]:
    """One part an event, in the order of the article."""
    quantities = Quantities.of(done.case)
    pictures = [picture for event in done.events for picture in _pictures(event, quantities)]
    drawn = [centre.picture(each, done.events, quantities) for each in done.centres]
    pictures += [each for each in drawn if each is not None]
    intro = Text.of(
        "At a grazing the motion touches a boundary of the gap without speed. Each event is shown before, "
        "at and after it; the lower row of a portrait enlarges the place of the touch. Where an event was "
        "not found, the motions at and beside the reported value are shown instead."
    )
    notes = {row.id: row.parts for row in done.claims}
    parts = tuple(_part(event, quantities, notes.get(event.claim, ()), done) for event in done.events)
    return Section("events", "The article’s events", (intro,), parts), pictures


def slug(event: Event) -> str:
    """The event's name as part of an id or a file name."""
    return "".join(c if c.isalnum() or c in "-." else "-" for c in event.name)


def _pictures(event: Event, quantities: Quantities) -> list[Picture]:
    name, motions, units = slug(event), event.motions, quantities.units
    found = [
        Picture(
            f"portrait-{name}",
            plots.portrait_triple if event.found else plots.gallery,
            (motions, units, event.parameter),
        ),
        Picture(f"history-{name}", plots.history_triple, (motions, units, event.parameter)),
    ]
    if _has_sections(event):
        ends = (motions[0], motions[-1])
        found.append(Picture(f"sections-{name}", plots.sections, (ends, event.parameter, FORCE)))
    return found


def _has_sections(event: Event) -> bool:
    """Sections of a motion of period one are single points: not worth a picture."""
    return any(m.period > 1 or not m.periodic for m in event.motions)


def _part(event: Event, quantities: Quantities, said: tuple[Part, ...], done: Reproduction) -> Section:
    blocks: list[Block] = [_opening(event, quantities)]
    if event.note:
        blocks.append(Note(Text.of(event.note), "Note" if event.found else "What was found instead"))
    blocks.append(_facts(event, quantities))
    if event.coincidence is not None:
        blocks += [*(_judged(part) for part in said), _opening_table(event, event.coincidence)]
        blocks.append(_others(done.coincidences))
        for each in done.centres:
            blocks += centre.blocks(each, quantities) if each.claim == event.claim else []
    blocks += _figures(event, quantities)
    if event.conditions:
        blocks.append(_conditions(event))
    title = f"{event.title}, {symbol(event.parameter)} ≈ {event.digits}"
    return Section(f"event-{slug(event)}", title, tuple(blocks), (), verdict(event.verdict))


def _judged(part: Part) -> Text:
    return Text.of(
        Strong(f"{part.what[:1].upper()}{part.what[1:]}: "), verdict(part.verdict), f" {part.note}"
    )


def _others(pairs: tuple[Coincidence, ...]) -> Text:
    """That nothing was picked: every doubling was asked the same."""
    shown = "; ".join(
        f"{symbol(p.doubling.name)} = {number(p.doubling.value, 6)}, {scientific(p.apart)} apart, "
        f"{short(p.labels[0])} → {short(p.labels[1])}"
        for p in pairs
    )
    return Text.of(
        "Every doubling that the sweeps met was asked the same. Those whose doubled orbit touches a boundary "
        f"before anything else happens to it, within 2 % of the parameter: {shown}."
    )


def _opening_table(event: Event, both: Coincidence) -> Table:
    """The square root, measured."""
    rows = tuple(
        (
            scientific(o.distance, 2),
            scientific(o.amplitude, 2),
            number(o.amplitude / o.distance**0.5, 4),
            number(o.clearance, 4),
        )
        for o in both.opening
    )
    at = (f"{scientific(both.apart, 2)} (grazing)", "", "", "0")
    return Table(
        f"table-opening-{slug(event)}",
        f"How the doubled orbit {short(both.doubled)} opens below or above its doubling: an amplitude like "
        "the "
        "square root of the distance takes the next extremum to the boundary.",
        (
            f"distance from the doubling, in {symbol(event.parameter)}",
            "amplitude a",
            "a over the root of the distance",
            "clearance of the extremum",
        ),
        (("0 (doubling)", "0", "", number(both.clearance, 4)), *rows, at),
        frozenset({0, 1, 2, 3}),
    )


def _figures(event: Event, quantities: Quantities) -> list[Figure]:
    """Portraits, histories, and sections where they are more than single points."""
    change, labels = (
        f"{symbol(event.parameter)} ≈ {event.digits}",
        ", ".join(short(m.label) for m in event.motions),
    )
    units, where = quantities.units, fixed_words(event.fixed)
    portraits = (
        f"Phase portraits before, at and after the event at {change} ({where}): {labels}. Below: the "
        f"outlined "
        "places enlarged."
        if event.found
        else f"Phase portraits at and beside {change} ({where}), from the cold start: {labels}."
    )
    histories = (
        "The same motions over one period, or over 12 mesh cycles where there is none: displacement X with "
        "the "
        "boundaries ±D, and mesh force Φ."
    )
    sections = (
        "Poincaré sections of the first and the last of these motions; F in the article’s sign, F = −Φ."
    )
    found = [
        (
            "portrait",
            portraits,
            f"Phase portraits around {change}: {labels}",
            quantities.assumed(units.length),
        ),
        (
            "history",
            histories,
            f"Histories of displacement and force around {change}",
            quantities.assumed(units.length, units.force),
        ),
    ]
    if _has_sections(event):
        found.append(("sections", sections, f"Poincaré sections of two motions around {change}", False))
    return [
        Figure(f"figure-{kind}-{slug(event)}", Text.of(caption), words, f"{kind}-{slug(event)}", assumed)
        for kind, caption, words, assumed in found
    ]


def _opening(event: Event, quantities: Quantities) -> Text:
    mark = symbol(event.parameter)
    change = f"{event.reported_before} → {event.reported_after}"
    said = f"The article reports {mark} ≈ {event.digits} with {change} as {mark} rises. "
    if not event.found:
        return Text.of(said, Strong("No such event was found in the sweeps."))
    change = f"{short(event.label_below)} → {short(event.label_above)}"
    place = quantities.place(event.parameter, event.value, 8)
    return Text.of(said, "Computed: ", *place, f", {change}, {percent(event.deviation)} from the article.")


def _facts(event: Event, quantities: Quantities) -> Table:
    rows: list[tuple[Cell, ...]] = [("reported value", f"{symbol(event.parameter)} ≈ {event.digits}")]
    if event.found:
        rows += [
            ("computed value", quantities.place(event.parameter, event.value, 12)),
            ("deviation", percent(event.deviation, 3)),
            ("labels below → above", f"{short(event.label_below)} → {short(event.label_above)}"),
            ("kind", event.kind),
            ("boundary", BOUNDARY[event.boundary]),
            ("type, as in Table 2 of the article", event.type),
            ("phase of the touch", f"{number(event.phase)} mesh cycles"),
            (
                "largest multiplier below; above",
                "; ".join(map(complex_number, (event.leading_below, event.leading_above))),
            ),
            ("largest Lyapunov exponent there", number(event.exponent, 4)),
            (
                "distances |λ − 1|, |λ + 1|",
                f"{number(event.distance_to_fold, 4)}, {number(event.distance_to_doubling, 4)}",
            ),
            *_law(event),
            ("residual", scientific(event.residual)),
        ]
    else:
        labels = ", ".join(f"{number(m.value)}: {short(m.label)}" for m in event.motions)
        rows += [
            ("labels reported", f"{event.reported_before} → {event.reported_after}"),
            ("motions shown", labels),
        ]
    rows += [("how", event.method), ("branch, direction, start", event.branch)]
    caption = f"{event.title}: reported and computed."
    return Table(f"table-event-{slug(event)}", caption, ("", ""), tuple(rows))


def _law(event: Event) -> list[tuple[Cell, ...]]:
    """What the touch does to the multipliers: by the field alone, and what the branch then meets."""
    law = event.law
    if law is None:
        return []
    if law.missing:
        return [("square-root law of the touch", f"does not hold: {'; '.join(law.missing)}")]
    change = f"{complex_number(law.multipliers[0])} + ({complex_number(law.coefficients[0])}) √d"
    name, by_law = symbol(event.parameter), "no multiplier comes to 1 or −1"
    if law.predicted_kind is not None:
        by_law = (
            f"{law.predicted_kind} at d = {number(law.predicted_depth, 3)}, "
            f"{name} = {number(law.predicted_value, 5)}"
        )
    on_branch = "no fold or doubling before the next touch"
    if law.computed_kind is not None:
        on_branch = (
            f"{law.computed_kind} at d = {number(law.computed_depth, 3)}, "
            f"{name} = {number(law.computed_value, 5)}"
        )
    return [
        ("largest multiplier at a small depth d beyond the touch, from the field", change),
        ("what comes next: by that law; on the branch", [by_law, on_branch]),
    ]


def _conditions(event: Event) -> Table:
    rows = tuple(
        (text, scientific(value) if abs(value) < 1e-3 else number(value), yes_or_no(holds))
        for text, value, holds in event.conditions
    )
    return Table(
        f"table-conditions-{slug(event)}",
        "The article’s four conditions of grazing, evaluated at the touch.",
        ("condition", "value", "holds"),
        rows,
        frozenset({1}),
    )
