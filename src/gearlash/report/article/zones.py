"""The stable zones, dimensionless and in rpm and µm, and what coexists in the window without impacts."""

from __future__ import annotations

from math import isfinite

from gearlash import plots
from gearlash.plots.regimes import short
from gearlash.report.blocks import Block, Cell, Figure, Inline, Section, Strong, Table, Text
from gearlash.report.numbers import NOTHING, interval, number, uncertainty
from gearlash.report.pictures import Picture
from gearlash.studies.article import Reproduction, Zone
from gearlash.studies.article.reproduction import Coexisting, End

from .quantities import Quantities, fixed_words, symbol
from .words import verdict

MOST_BARS = 6  # of coexisting motions in the chart of one zone


def section(done: Reproduction) -> tuple[Section, list[Picture]]:
    """Chart and table of the zones, and the motions that coexist in the window."""
    quantities = Quantities.of(done.case)
    panels = [panel(group) for group in _grouped(done.zones)]
    pictures, blocks = [], [_intro()]
    if panels:
        pictures.append(Picture("zones", plots.zones, (tuple(panels), quantities.units)))
        blocks.append(
            Figure(
                "figure-zones",
                Text.of("Stable zones: reported (hatched), computed, and other motions found inside them."),
                f"Chart of {len(done.zones)} intervals, reported and computed",
                "zones",
                quantities.assumed(*(quantities.units.of_parameter(p.parameter) for p in panels)),
            )
        )
    blocks.append(_table(done.zones, quantities))
    notes = dict.fromkeys(f"In {symbol(zone.parameter)}: {zone.note}" for zone in done.zones if zone.note)
    blocks += [Text.of(note) for note in notes]
    inner: tuple[Section, ...] = ()
    if done.window:
        made, picture = _window(done, quantities)
        inner, pictures = (made,), [*pictures, picture]
    return Section("zones", "Stable zones", tuple(blocks), inner), pictures


def _intro() -> Block:
    return Text.of(
        "A zone is shown in two readings. In the wider one at least one motion found stays clear of the "
        "impacts in question; whoever follows that motion by hand sees this interval. In the narrower one "
        "every motion found does, whatever the start: this is what an operator can rely on."
    )


def _grouped(zones: tuple[Zone, ...]) -> list[list[Zone]]:
    """Readings of one zone together, without those that were not found."""
    groups: dict[tuple[str, str], list[Zone]] = {}
    for zone in zones:
        groups.setdefault((zone.parameter, zone.kind), []).append(zone)
    return list(groups.values())


def panel(readings: list[Zone]) -> plots.Panel:
    """The chart of one zone in all its readings."""
    first = readings[0]
    bars = []
    for zone in readings:
        if zone.reported is not None:
            low, high = zone.reported
            bars.append(plots.Bar("article", low, high, "reported", "", number(low), number(high)))
        if isfinite(zone.lower.value) and isfinite(zone.upper.value):
            reading = "computed: some motion" if zone.reported is not None else "computed: every motion"
            label = short(zone.labels[0]) if len(zone.labels) == 1 else f"{len(zone.labels)} labels"
            bars.append(
                plots.Bar(
                    reading,
                    zone.lower.value,
                    zone.upper.value,
                    "computed",
                    label,
                    _end(zone.lower),
                    _end(zone.upper),
                )
            )
    others = _together(max((z.coexisting for z in readings), key=len))
    bars += [
        plots.Bar(
            f"coexists: {short(label)}", low, high, "coexisting", label, number(low, 5), number(high, 5)
        )
        for label, low, high in others[:MOST_BARS]
    ]
    title = f"{first.kind}, at {fixed_words(first.fixed)}"
    if len(others) > MOST_BARS:
        title += f"  ({len(others) - MOST_BARS} more coexisting motions are in the table)"
    return plots.Panel(first.parameter, title, tuple(bars))


def _together(found: tuple[Coexisting, ...]) -> list[tuple[str, float, float]]:
    """(label, lower, upper), the intervals of one label as one: which direction found which part is in the
    table."""
    spans: dict[str, tuple[float, float]] = {}
    for each in found:
        low, high = spans.get(each.label, each.interval)
        spans[each.label] = min(low, each.interval[0]), max(high, each.interval[1])
    return [(label, low, high) for label, (low, high) in spans.items()]


def _end(end: End) -> str:
    return f"{number(end.value, 5)}  {end.how}"


def _table(zones: tuple[Zone, ...], quantities: Quantities) -> Table:
    """Zones side by side, a property a row."""
    columns = [_column(zone, quantities) for zone in zones]
    rows = tuple((name, *(column[name] for column in columns)) for name in (columns[0] if columns else ()))
    share = 84 // max(1, len(zones))
    caption = "Stable zones, reported and computed."
    return Table(
        "table-zones", caption, ("", *(z.name for z in zones)), rows, widths=(16, *[share] * len(zones))
    )


def _column(zone: Zone, quantities: Quantities) -> dict[str, Cell]:
    found = isfinite(zone.lower.value) and isfinite(zone.upper.value)
    physical = quantities.physical(zone.parameter, zone.lower.value, zone.upper.value) if found else None
    name = symbol(zone.parameter)
    others: Cell = [f"{short(c.label)} in {interval(*c.interval, 5)} ({c.start})" for c in zone.coexisting]
    return {
        "where": f"at {fixed_words(zone.fixed)}",
        "article": NOTHING if zone.reported is None else f"{name} ∈ {interval(*zone.reported)}",
        "computed": Strong(
            f"{name} ∈ {interval(zone.lower.value, zone.upper.value)}" if found else "not found"
        ),
        "physical": physical or NOTHING,
        "lower end": _edge(zone.lower) if found else NOTHING,
        "upper end": _edge(zone.upper) if found else NOTHING,
        "motions": ", ".join(short(label) for label in zone.labels) or NOTHING,
        "least distance to the boundary, in the middle": _distance(zone.margin, quantities),
        "coexisting in it": others or "none found",
        "verdict": verdict(zone.verdict),
    }


def _edge(end: End) -> Cell:
    beyond = f"beyond it: {short(end.next_label)}" if end.next_label else "beyond it: not computed"
    return [end.how, beyond, uncertainty(end.uncertainty)]


def _distance(margin: float, quantities: Quantities) -> Cell:
    if not isfinite(margin):
        return NOTHING
    length = quantities.length(margin)
    said: tuple[Inline, ...] = (number(margin, 3),)
    return said if length is None else (*said, " (", length, ")")


def _window(done: Reproduction, quantities: Quantities) -> tuple[Section, Picture]:
    motions = done.window
    omega = motions[0].value
    labels = " and ".join(short(m.label) for m in motions)
    where = quantities.place("omega", omega)
    figure = Figure(
        "figure-window",
        Text.of("Motions at ", *where, f" inside the window: {labels}."),
        f"Phase portraits of {len(motions)} motions at one speed inside the window without impacts",
        "window",
        quantities.assumed(quantities.units.length),
    )
    if len(motions) > 1:
        text = Text.of(
            "At ",
            *where,
            f" {len(motions)} motions exist side by side: {labels}. Which of them the pair runs in depends "
            "on how it came there: the window is quiet only for the motion that was followed into it, and "
            "a disturbance can throw the pair into the other.",
        )
    else:
        text = Text.of("No sweep found another motion inside the window than ", labels, ".")
    picture = Picture("window", plots.gallery, (motions, quantities.units, "omega"))
    return Section("window", "The window without impacts, and what coexists in it", (text, figure)), picture
