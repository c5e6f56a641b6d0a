"""Sweeps in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.asked import Asked, is_quantity
from gearlash.cli.answers.sweep import Regime, SweepAnswer, SweepWay

from .layout import assumed, facts, headline, table
from .numbers import number

MOST_LINES = 30  # of regimes in one direction; all of them are in --json


def sweep_view(answer: SweepAnswer, width: int) -> Iterator[Text]:
    """Sentence, statuses, and regimes along the axis for every direction."""
    yield from headline(answer.sentence, width)
    yield from facts("", list(_facts(answer)), width)
    for way in answer.sweeps:
        yield from _regimes(answer, way, width)
    yield from assumed((answer.axis.held,), width)


def _facts(answer: SweepAnswer) -> Iterator[tuple[str, str]]:
    if answer.status != "ok":
        yield "status", answer.status
    yield "points", ", ".join(f"{count} {status}" for status, count in answer.statuses.items())
    yield (
        "certificates",
        ", ".join(f"{count} {verdict}" for verdict, count in answer.certificates.items()) or "–",
    )
    for low, high in zip(answer.axis.physical_lower, answer.axis.physical_upper, strict=True):
        yield (
            low.name.replace("_", " "),
            f"{number(low.value, 6)} to {number(high.value, 6)} {pretty(low.unit)}",
        )
    if answer.coexisting:
        shown = ", ".join(_values(answer.axis.asked, *ends) for ends in answer.coexisting[:12])
        more = len(answer.coexisting) - 12
        yield (
            "coexistence",
            f"{answer.axis.asked.title} {shown}{f' and {more} more intervals' if more > 0 else ''}",
        )


def _regimes(answer: SweepAnswer, way: SweepWay, width: int) -> Iterator[Text]:
    factor, unit = _physical(answer)
    own = [(f"from, {answer.axis.name}", "right"), ("to", "right")]
    told = [(f"from, {pretty(unit)}", "right"), ("to", "right")] if factor is not None else []
    first = bool(answer.axis.asked.unit)
    alone = first and is_quantity(answer.axis.name)
    own = [] if alone else own
    columns = [("", "left"), *(told + own if first else own + told), ("points", "right")]
    shown = sorted(_longest(way.regimes), key=lambda r: r.first)
    rows = []
    for r in shown:
        plain = [] if alone else [number(r.first, 6), number(r.last, 6)]
        scaled = [] if factor is None else [number(r.first * factor, 5), number(r.last * factor, 5)]
        rows.append([r.label or "–", *(scaled + plain if first else plain + scaled), str(r.points)])
    left = len(way.regimes) - len(shown)
    cold = "From cold starts" if answer.start is None else "From the state that was given, at every value"
    words = {"cold": cold, "up": "Followed upwards", "down": "Followed downwards"}[way.direction]
    title = words + (
        f", the {len(shown)} longest of {len(way.regimes)} stretches (--json has all)" if left else ""
    )
    yield from table(title if way.complete else f"{title}; {way.message}", columns, rows, width)


def _physical(answer: SweepAnswer) -> tuple[float | None, str]:
    """What dimensionless values are multiplied with for the physical columns, and their unit: the one that
    was asked for, else the first that the case has."""
    if answer.axis.asked.unit:
        return answer.axis.asked.factor, answer.axis.asked.unit
    physical = [p for p in answer.axis.physical_upper if p.value]
    return (physical[0].value / answer.axis.upper, physical[0].unit) if physical else (None, "")


def _values(asked: Asked, low: float, high: float) -> str:
    """The values of an interval in the unit that was asked for, without its name."""
    shown = f"{asked.value(low):.5g}" + (f"–{asked.value(high):.5g}" if low < high else "")
    return f"{shown} {pretty(asked.unit)}" if asked.unit else shown


def _longest(regimes: tuple[Regime, ...]) -> list[Regime]:
    return sorted(regimes, key=lambda r: -r.points)[:MOST_LINES]
