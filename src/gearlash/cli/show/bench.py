"""A benchmark in the terminal."""

from __future__ import annotations

from collections.abc import Iterator

from rich.text import Text

from gearlash.bench import Row
from gearlash.bench.words import aim, error, measured, ratio, time, verdict
from gearlash.cli.answers.bench import BenchAnswer

from .layout import facts, headline, table

COLUMNS = [
    ("solver", "left"), ("time", "right"), ("× gearlash", "right"), ("error", "right"),
    ("error of times", "right"), ("", "left"),
]  # fmt: skip


def bench_view(answer: BenchAnswer, width: int) -> Iterator[Text]:
    """Bars, then a table for every piece of work, then what was not about other solvers."""
    found = answer.benchmark
    yield from headline(answer.sentence, width)
    bars = [
        (
            verdict(bar),
            measured(bar),
            aim(bar),
            bar.sentence + (f" ({bar.where})" if bar.where else ""),
        )
        for bar in found.bars
    ]
    yield from table("Bars", [("", "left"), ("here", "right"), ("aim", "right"), ("", "left")], bars, width)
    groups = dict.fromkeys((row.task, row.work) for row in found.rows if row.task != "start-up")
    for task, work in groups:
        rows = [row for row in found.rows if (row.task, row.work) == (task, work)]
        yield from table(f"{task}: {work}, per {rows[0].unit}", COLUMNS, [_cells(r) for r in rows], width)
    starts = [(row.work, time(row.seconds)) for row in found.rows if row.task == "start-up"]
    yield from facts("Start-up", starts, width)
    yield from facts("The map", [(name, f"{value:.4g}") for name, value in found.pixels.items()], width)
    yield from facts("Two threads", [(name, f"{value:.4g}") for name, value in found.threads.items()], width)
    limits = [
        (x.work, f"{100 * x.share:.1f} % of the core's peak, {x.seconds / x.least:.1f} × the least time")
        for x in found.limits
    ]
    yield from facts("The limit", limits, width)
    machine = found.machine
    versions = ", ".join(f"{name} {version}" for name, version in machine.versions.items())
    where = f"{machine.processor}, {machine.cores} cores, {machine.system}, Python {machine.python}"
    yield from facts(
        "", [("machine", where), ("versions", versions), ("took", f"{found.seconds:.0f} s")], width
    )


def _cells(row: Row) -> tuple[str, ...]:
    return row.solver, time(row.seconds), ratio(row.ratio), error(row.error), error(row.time_error), row.note
