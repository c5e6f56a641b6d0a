"""The operating point of the case in the plane of speed and load: its zone, and how far that reaches."""

from __future__ import annotations

from gearlash import AxisMargin, PlaneZone, plots
from gearlash.article import Reproduction
from gearlash.case.edges import at_most
from gearlash.plots.regimes import short
from gearlash.report.blocks import Cell, Figure, Inline, Section, Table, Text
from gearlash.report.pictures import Picture

from .quantities import Quantities, symbol

STEM = "window-plane"


def section(done: Reproduction, zone: PlaneZone, quantities: Quantities) -> tuple[Section, Picture]:
    """Its figure, and a table of margins."""
    one, two = zone.names
    at = (*quantities.place(one, zone.at[0]), ", ", *quantities.place(two, zone.at[1]))
    assumed = quantities.assumed(*(quantities.units.of_parameter(each) for each in zone.names))
    text = Text.of(
        "At its own speed and load, ",
        *at,
        f", the pair runs in {short(zone.label)}. Along the curves that bound the zone in the figure that "
        "motion grazes, or loses its stability; every point of them is solved for. It was followed along "
        f"{zone.lines} straight lines, at {len(zone.followed)} places. Other motions may coexist in it: "
        "what was found of them over speed stands above.",
        *(f" {note}." for note in zone.notes),
    )
    figure = Figure(
        f"figure-{STEM}",
        Text.of(
            f"The zone of {short(zone.label)} over speed and load, and the margins of the operating point."
        ),
        f"Zone without impacts over {one} and {two}, with margins",
        STEM,
        assumed,
    )
    head = ("along", "direction", "margin", "per cent", "the zone ends at", "what happens there")
    here = dict(zip(zone.names, zone.at, strict=True))
    rows = tuple(_row(margin, here[margin.name], quantities) for margin in zone.margins)
    caption = "How far the operating point lies from the ends of its zone, the other parameter kept."
    table = Table(f"table-{STEM}", caption, head, rows, frozenset({3}), widths=(10, 10, 20, 9, 21, 30))
    picture = Picture(STEM, plots.zone_in_plane, (zone, done.case), {"title": "Window without impacts"})
    return Section(
        f"section-{STEM}", "The operating point in it, over speed and load", (text, figure, table)
    ), picture


def _row(margin: AxisMargin, here: float, quantities: Quantities) -> tuple[Cell, ...]:
    """Rounded towards safety: no margin is shown larger than it is, no end beyond where it lies."""
    least = "" if margin.bounded else "at least "
    shown = quantities.at_most(margin.name, margin.distance)
    distance: tuple[Inline, ...] = (f"{least}{at_most(margin.distance)}",)
    if shown is not None:
        distance = (*distance, " (", shown, ")")
    return (
        symbol(margin.name),
        "upwards" if margin.upward else "downwards",
        distance,
        at_most(margin.percent, 3),
        quantities.edge(margin.name, margin.value, -1 if margin.upward else 1, here),
        margin.event if margin.bounded else "nothing: only the range looked at ends",
    )
