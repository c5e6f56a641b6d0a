"""The stable zones, dimensionless and in rpm and µm, and what coexists in the window without impacts."""

from __future__ import annotations

from math import isfinite

from gearlash import plots
from gearlash.article import ReportedZone, Reproduction
from gearlash.article.reproduction import BearingMode, Coexisting, End, Reading, Scan
from gearlash.article.zoning import EVERY, SOME
from gearlash.plots.regimes import short
from gearlash.report.blocks import Block, Cell, Figure, Inline, Note, Ref, Section, Strong, Table, Text
from gearlash.report.numbers import NOTHING, interval, number, percent, uncertainty
from gearlash.report.pictures import Picture
from gearlash.system import Label

from . import margins
from .quantities import Quantities, fixed_words, symbol
from .words import plural, verdict

BARS = {"cold": "cold start", "up": "followed up", "down": "followed down", EVERY: "every attractor"}
MOST_BARS = 6  # of coexisting motions in the chart of one zone


def section(done: Reproduction) -> tuple[Section, list[Picture]]:
    """Chart and tables of the zones, and the motions that coexist in the window."""
    quantities = Quantities.of(done.case)
    panels = [panel(zone) for zone in done.zones]
    pictures, blocks = [], [_intro()]
    if panels:
        pictures.append(Picture("zones", plots.zones, (tuple(panels), quantities.units)))
        blocks.append(
            Figure(
                "figure-zones",
                Text.of(
                    "Stable zones: reported (hatched), computed in each reading, and other motions found "
                    "inside "
                    "them."
                ),
                f"Chart of {plural(len(done.zones), 'zone')}, reported and computed in each reading",
                "zones",
                quantities.assumed(*(quantities.units.of_parameter(p.parameter) for p in panels)),
            )
        )
    for zone in done.zones:
        scan = next((scan for scan in done.scans if scan.parameter == zone.parameter), None)
        blocks += [_table(zone, quantities, scan), *_inside(zone, quantities)]
    inner: tuple[Section, ...] = ()
    if done.window:
        made, picture = _window(done, quantities)
        inner, pictures = (made,), [*pictures, picture]
    if done.window_plane is not None:
        made, picture = margins.section(done, done.window_plane, quantities)
        inner, pictures = (*inner, made), [*pictures, picture]
    return Section("zones", "Stable zones", tuple(blocks), inner), pictures


def _intro() -> Block:
    return Text.of(
        "Where motions coexist, the start decides which of them is seen, and so does the way of scanning. "
        "Each "
        "zone is therefore shown in every reading: from the cold start at every value, following the "
        "motion up "
        "and down, and where every attractor that these three find is quiet, whatever the start, which is "
        "what "
        "an operator can rely on. The article does not say how it scanned; three simple starts, with every "
        "other "
        "state at zero, show what it would have seen from them. The reading nearest to its numbers is in "
        "bold."
    )


def panel(zone: ReportedZone) -> plots.Panel:
    """The chart of one zone in all its readings."""
    low, high = zone.reported
    bars = [plots.Bar("article", low, high, "reported", "", number(low), number(high))]
    bars += [
        plots.Bar(
            BARS.get(r.way, f"start {r.way.partition(',')[0]}"),
            r.lower.value,
            r.upper.value,
            "computed",
            r.labels[0] if len(r.labels) == 1 else f"{len(r.labels)} labels",
            _end(r.lower),
            _end(r.upper),
        )
        for r in zone.readings
        if r.found and r.way != SOME
    ]
    others = _together(zone.reading(SOME).coexisting)
    bars += [
        plots.Bar(f"coexists: {short(each)}", low, high, "coexisting", each, number(low, 5), number(high, 5))
        for each, low, high in others[:MOST_BARS]
    ]
    title = f"{zone.kind}, at {fixed_words(zone.fixed)}"
    if len(others) > MOST_BARS:
        title += f"  ({len(others) - MOST_BARS} more coexisting motions are in the text)"
    return plots.Panel(zone.parameter, title, tuple(bars))


def _together(found: tuple[Coexisting, ...]) -> list[tuple[Label, float, float]]:
    """(label, lower, upper), the intervals of one label as one."""
    spans: dict[Label, tuple[float, float]] = {}
    for each in found:
        low, high = spans.get(each.label, each.interval)
        spans[each.label] = min(low, each.interval[0]), max(high, each.interval[1])
    return [(label, low, high) for label, (low, high) in spans.items()]


def _end(end: End) -> str:
    return f"{number(end.value, 5)}  {end.how}"


def _table(zone: ReportedZone, quantities: Quantities, scan: Scan | None) -> Table:
    """A reading a row."""
    name = symbol(zone.parameter)
    reported: tuple[Cell, ...] = ("the article", interval(*zone.reported), "", "", "", "", "")
    head = (
        "reading",
        f"{name} from, to",
        "lower end",
        "upper end",
        "motions",
        "deviation of the ends",
        "verdict",
    )
    caption = f"{zone.name} at {fixed_words(zone.fixed)}, reported and in each reading."
    rows = tuple(_row(zone, reading, quantities, scan) for reading in zone.readings)
    return Table(
        f"table-zone-{zone.parameter}", caption, head, (reported, *rows), widths=(19, 17, 15, 15, 9, 11, 14)
    )


def _row(zone: ReportedZone, reading: Reading, quantities: Quantities, scan: Scan | None) -> tuple[Cell, ...]:
    name: Inline = Strong(reading.name) if reading.way == zone.nearest else reading.name
    if not reading.found:
        return name, "not found", NOTHING, NOTHING, NOTHING, NOTHING, verdict(reading.verdict)
    low, high = reading.lower.value, reading.upper.value
    shown = interval(low, high)
    physical = quantities.physical(zone.parameter, low, high)
    where: Cell = [Strong(shown) if reading.way == zone.nearest else shown, physical or ""]
    compared = reading.way != SOME
    return (
        name,
        where,
        _edge(reading.lower, scan),
        _edge(reading.upper, scan),
        ", ".join(short(label) for label in reading.labels) or NOTHING,
        [percent(d) for d in reading.deviations] if compared else NOTHING,
        verdict(reading.verdict) if compared else NOTHING,
    )


def _edge(end: End, scan: Scan | None) -> Cell:
    """What the zone ends at, and which special point of a branch that is."""
    if not end.next_label:
        return end.how
    said: list[Inline | tuple[Inline, ...]] = [
        end.how, f"beyond: {short(end.next_label)}", uncertainty(end.uncertainty)
    ]  # fmt: skip
    found = None if scan is None else scan.special_at(end.value)
    if found is not None:
        number, special = found
        labels = dict.fromkeys((short(special.label_before), short(special.label_after)))
        said.append(f"{special.kind} of {', '.join(labels)} (branch {number + 1})")
    return said


def _inside(zone: ReportedZone, quantities: Quantities) -> list[Block]:
    """What coexists in the widest reading, how far from the boundary its middle is, and what may be
    missed."""
    some, name = zone.reading(SOME), symbol(zone.parameter)
    said: list[Inline] = []
    if some.coexisting:
        others = "; ".join(
            f"{short(c.label)} in {interval(*c.interval, 5)} ({c.start})" for c in some.coexisting
        )
        said.append(f"Coexisting in {name} {interval(some.lower.value, some.upper.value, 5)}: {others}. ")
    if isfinite(some.margin):
        said += ["Least distance to the boundary in its middle: ", *_distance(some.margin, quantities), ". "]
    return [Text.of(*said, zone.note)] if said or zone.note else []


def _distance(margin: float, quantities: Quantities) -> list[Inline]:
    length = quantities.length(margin)
    return [number(margin, 3)] if length is None else [number(margin, 3), " (", length, ")"]


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
    blocks = (text, figure, *_resonances(done.bearings, quantities))
    picture = Picture("window", plots.gallery, (motions, quantities.units, "omega"))
    return Section("window", "The window without impacts, and what coexists in it", blocks), picture


def _resonances(found: tuple[BearingMode, ...], quantities: Quantities) -> list[Note]:
    """Impact-free is not quiet."""
    return [
        Note(
            Text.of(
                f"On its bearing alone ({mode.bearing}) the body would swing at ",
                *quantities.place("omega", mode.frequency),
                ", inside the window; the frequencies of the whole pair with closed teeth are in ",
                Ref("table-derived"),
                f". At that speed, without any impact, the body moves there by {number(mode.motion, 3)} "
                "D_c peak "
                "to peak",
                *_beside(quantities.length(mode.motion)),
                f", and its bearing carries {number(mode.force / mode.mesh_force, 2)} times the "
                "peak-to-peak mesh "
                f"force, {number(mode.force / mode.mesh_mean, 2)} times the mean one.",
            ),
            "Without impacts is not without vibration",
        )
        for mode in found
    ]


def _beside(length: Inline | None) -> list[Inline]:
    return [] if length is None else [" (", length, ")"]
