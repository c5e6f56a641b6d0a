"""The point of two parameters behind an event: its picture, its places, what its curves say of the event."""

from __future__ import annotations

from math import isfinite

from gearlash import plots
from gearlash.article import Event
from gearlash.article.reproduction import Centre, CentreLine
from gearlash.plots.regimes import short
from gearlash.report.blocks import Block, Cell, Figure, Table, Text
from gearlash.report.numbers import interval, number, scientific
from gearlash.report.pictures import Picture

from .quantities import Quantities, fixed_words, symbol
from .words import joined

SAME = 1e-9  # relative distance of two values that are one point


def stem(centre: Centre) -> str:
    """Of its figure."""
    return f"point-{centre.claim}"


def picture(centre: Centre, events: tuple[Event, ...], quantities: Quantities) -> Picture | None:
    """Its curves, and where the line of the article cuts them; None where they were not followed."""
    if not centre.lines:
        return None
    place = centre.places[0]
    lines = [plots.PlaneLine(line.values, line.kind, words(line)) for line in centre.lines]
    cuts = {_printed(line.crosses, events): line.crosses for line in reversed(centre.lines)}
    shown = [(value, text) for text, value in cuts.items() if isfinite(value)]
    present = f"{symbol(place.parameters[1])} = {number(place.present)}, as in the case"
    data = (lines, place.values, place.present, shown, place.parameters, present, quantities.units)
    return Picture(stem(centre), plots.around_point, data)


def words(line: CentreLine) -> str:
    """``doubling of 6-6-1``, ``grazing 6-6-1 | 6-6-2``."""
    labels = " | ".join(map(short, line.labels))
    return f"{line.kind} of {labels}" if len(line.labels) == 1 else f"{line.kind} {labels}"


def _printed(value: float, events: tuple[Event, ...]) -> str:
    """As the article prints it, where it has it."""
    near = (each.digits for each in events if abs(each.value - value) <= max(SAME, _half(each)) * abs(value))
    return next(near, number(value, 4))


def _half(event: Event) -> float:
    """Of the last digit printed, relative."""
    return 0.5 * 10.0 ** -len(event.digits.partition(".")[2]) / abs(event.value)


def blocks(centre: Centre, quantities: Quantities) -> list[Block]:
    """What it is, its picture and its places."""
    found: list[Block] = [_what(centre)]
    if centre.lines:
        found += [_figure(centre, quantities), _cuts(centre)]
    return [*found, _places(centre, quantities)]


def _what(centre: Centre) -> Text:
    one, two = map(short, centre.labels)
    seen = joined([f"({', '.join(map(symbol, place.parameters))})" for place in centre.places])
    missed = [name for name in centre.sought if all(name != p.parameters[1] for p in centre.places)]
    said = (
        f"In two parameters there is such a point: an orbit {one} that grazes (beyond it {two}) with a "
        f"multiplier −1, both solved for together. It was met in the planes {seen}, each time on the curve "
        f"along which {one} grazes, followed from where it grazes at {fixed_words(centre.fixed)}."
    )
    if missed:
        said += f" Within the limits looked at it was not met over {', '.join(map(symbol, missed))}."
    return Text.of(said)


def _figure(centre: Centre, quantities: Quantities) -> Figure:
    place = centre.places[0]
    first, last = centre.lines[0], centre.lines[-1]
    caption = (
        f"The point, the curves that leave it, and where the line {symbol(place.parameters[1])} = "
        f"{number(place.present)} cuts them. Right: by how much {symbol(place.parameters[0])} is larger on "
        f"the curve “{words(first)}” than on “{words(last)}”, which lie over each other on the left."
    )
    assumed = quantities.assumed(*(quantities.units.of_parameter(each) for each in place.parameters))
    text = f"Curves of {', '.join(map(words, centre.lines))} from one point"
    return Figure(f"figure-{stem(centre)}", Text.of(caption), text, stem(centre), assumed)


def _cuts(centre: Centre) -> Text:
    """That the values of one parameter are cuts of the curves of one point."""
    place = centre.places[0]
    name = symbol(place.parameters[0])
    cut = [
        f"{words(line)} at {name} = {line.crosses:.10g}" for line in centre.lines if isfinite(line.crosses)
    ]
    line = f"{symbol(place.parameters[1])} = {number(place.present)}"
    return Text.of(
        f"At {line} these curves are cut by: {'; '.join(cut)}. So what is found there over {name} alone "
        "are cuts of curves that leave one point; the point itself lies "
        f"{number(abs(place.values[1] - place.present) / abs(place.present) * 100.0, 3)} % of "
        f"{symbol(place.parameters[1])} away."
    )


def _places(centre: Centre, quantities: Quantities) -> Table:
    """In every plane."""
    rows = []
    for place in centre.places:
        first, second = place.parameters
        where: Cell = [
            quantities.place(first, place.values[0], 12),
            quantities.place(second, place.values[1], 12),
        ]
        rows.append(
            (
                f"({symbol(first)}, {symbol(second)})",
                where,
                f"{symbol(second)} = {number(place.present)}",
                scientific(max(place.errors)),
                scientific(place.multiplier),
                scientific(place.distance),
                interval(*place.limits[1]),
            )
        )
    head = ("plane", "where", "in the case", "error, estimated", "|λ + 1|", "|X ∓ D|", "looked for in")
    caption = (
        f"The orbit {short(centre.labels[0])} that grazes with a multiplier −1, in planes of two parameters."
    )
    return Table(
        f"table-{stem(centre)}",
        caption,
        head,
        tuple(rows),
        frozenset({3, 4, 5}),
        widths=(11, 30, 14, 11, 10, 10, 14),
    )
