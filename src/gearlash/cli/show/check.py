"""A case in the terminal."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from rich.text import Text

from gearlash.case.units import pretty
from gearlash.cli.answers.check import CheckAnswer, CheckValue

from .layout import facts, headline, note, remarks, table, wrapped
from .numbers import Marks, number

RESONANCE = re.compile(r"derived\.(natural_frequency|critical_speed)_(\d+)(_hz)?")
OF_TEETH = re.compile(
    r"derived\.(\w+_diameter|tip_clearance|\w+_thickness|span|span_teeth|over_balls)_(pinion|gear)"
)
GEARS = ("pinion", "gear")


def check_view(answer: CheckAnswer, width: int) -> Iterator[Text]:
    """Stated values, derived numbers, remarks."""
    yield from headline(f"{answer.name}: {answer.kind}, nothing to correct", width)
    if answer.description:
        yield from map(Text, wrapped(answer.description, width))
    if answer.source:
        rows = [
            (n, ", ".join(t) if isinstance(t, tuple) else " ".join(t.split()))
            for n, t in answer.source.items()
        ]
        yield from facts("Source", rows, width)
    marks = Marks({})
    stated = [v for v in answer.values if v.provenance != "derived"]
    derived = [v for v in answer.values if v.provenance == "derived" and not _in_a_table(v.path)]
    open_ = [v for v in stated if v.provenance != "given"]
    yield from remarks("Given", [_row(v, marks) for v in stated if v.provenance == "given"], width)
    if open_:
        yield from remarks("Not given", open_rows(open_, marks), width)
    yield from remarks("Derived", [_row(v, marks) for v in derived], width)
    yield from _teeth(answer.values, marks, width)
    yield from _resonances(answer.values, marks, width)
    if answer.dynamic_factor:
        yield from note(answer.dynamic_factor, width)
    for remark in answer.notes:
        yield from note(f"{remark.path}: {remark.text}", width, style="yellow")
    yield from note(f"States for --initial: {', '.join(answer.states)}", width)
    footnote = marks.footnote("above")
    if footnote:
        yield from note(footnote, width)


def open_rows(values: Iterable[CheckValue], marks: Marks) -> list[tuple[str, str, str, str]]:
    """Rows of values that are not given; a reason stands once for those that share it."""
    rows: list[tuple[str, str, str, str]] = []
    last = ""
    for value in values:
        path, short, shown, what = _row(value, marks)
        if value.reason and value.reason == last:
            what = what.partition(": ")[0] + ": the same"
        last = value.reason
        rows.append((path, short, shown, what))
    return rows


def _row(value: CheckValue, marks: Marks) -> tuple[str, str, str, str]:
    shown, what = _shown(value), value.description
    if value.provenance == "derived":
        shown = marks.of(shown, value.rests_on)
        what = f"{what} ({value.reason})" if what else value.reason
    elif value.provenance != "given":
        what = f"{value.provenance}{_range(value)}: {value.reason}"
    else:
        what = "; ".join(filter(None, (what, _limits(value), value.reason)))
    return value.path, value.short or "", shown, what


def _range(value: CheckValue) -> str:
    """The range of an estimate; stated limits as they are."""
    if value.least is None:
        return ""
    return f", {_limits(value)}" if value.text else f", {_ends(value, 3)}"


def _limits(value: CheckValue) -> str:
    return "" if value.least is None else f"limits {_ends(value, 7)}"


def _ends(value: CheckValue, digits: int) -> str:
    assert value.least is not None
    assert value.greatest is not None
    blank = "" if value.unit in ("", "deg") else " "
    return f"{number(value.least, digits)} to {number(value.greatest, digits)}{blank}{pretty(value.unit)}"


def _shown(value: CheckValue) -> str:
    if isinstance(value.value, str):
        return value.value
    blank = "" if value.unit in ("", "deg") else " "
    return f"{number(float(value.value), 7)}{blank}{pretty(value.unit)}"


def _in_a_table(path: str) -> bool:
    """Is it told beside its like, and not in a line of its own?"""
    return bool(RESONANCE.fullmatch(path) or OF_TEETH.fullmatch(path))


def _teeth(values: Sequence[CheckValue], marks: Marks, width: int) -> Iterator[Text]:
    """Dimensions of both gears side by side."""
    rows: dict[str, dict[str, str]] = {}
    for v in values:
        match = OF_TEETH.fullmatch(v.path)
        if match:
            told = v.description.removesuffix(f" of the {match[2]}")
            unit = f", {v.unit}" if v.unit else ""
            rows.setdefault(f"{told}{unit}", {})[match[2]] = marks.of(number(float(v.value), 7), v.rests_on)
    if rows:
        columns = [("", "left"), *((gear, "right") for gear in GEARS)]
        cells = [[name, *(found.get(gear, "") for gear in GEARS)] for name, found in rows.items()]
        yield from table("Teeth, at 20 °C", columns, cells, width)


def _resonances(values: Sequence[CheckValue], marks: Marks, width: int) -> Iterator[Text]:
    """Natural frequencies in one table: over ω_n, in Hz, and as a pinion speed."""
    by_order: dict[int, dict[str, str]] = {}
    for v in values:
        match = RESONANCE.fullmatch(v.path)
        if match:
            kind = "rpm" if match[1] == "critical_speed" else "Hz" if match[3] else "ω/ω_n"
            by_order.setdefault(int(match[2]), {})[kind] = marks.of(_shown(v), v.rests_on)
    if not by_order:
        return
    kinds = list(by_order[1])
    heads = {"ω/ω_n": "over ω_n", "Hz": "mesh frequency", "rpm": "pinion speed"}
    rows = [[str(order), *(found.get(kind, "") for kind in kinds)] for order, found in by_order.items()]
    columns = [("", "right"), *((heads[kind], "right") for kind in kinds)]
    yield from table("Natural frequencies, undamped, mesh closed at mean stiffness", columns, rows, width)
