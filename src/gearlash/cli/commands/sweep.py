"""gearlash sweep"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from gearlash.cli.exits import ExitCode, command
from gearlash.cli.options import (
    AsCsv,
    AsJson,
    CaseArgument,
    DecimalComma,
    Initial,
    MaxPeriod,
    Out,
    Over,
    Periods,
    Settings,
    Workers,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from gearlash.case import Case
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.frame import StudyInputs
    from gearlash.cli.tables import Tables
    from gearlash.orbits import Settings as SearchSettings
    from gearlash.results import Point, Sweep
    from gearlash.studies.transition import Transition

SWEEP_TABLES = "sweep", "regimes"
FALLING = " (--down follows it downwards)"  # what to do instead of typing a falling interval


@command
def sweep(
    case: CaseArgument,
    over: Over,
    cold: Annotated[
        bool, typer.Option("--cold", help="Every point from the cold start, or from the state of --initial.")
    ] = False,
    up: Annotated[bool, typer.Option("--up", help="Follows the attractor with rising values.")] = False,
    down: Annotated[bool, typer.Option("--down", help="Follows the attractor with falling values.")] = False,
    settings: Settings = None,
    initial: Initial = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    workers: Workers = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """How does the motion change with one parameter?

    One attractor per value; without --cold, --up or --down all three, as where they differ attractors
    coexist. --out writes sweep.nc (everything, NetCDF), sweep.json, and the bifurcation diagram as SVG and
    PDF. Ctrl-C keeps what was computed, marked incomplete.
    """
    from gearlash.cli.frame import StudyInputs, deliver
    from gearlash.cli.inputs import read_over
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    asked = StudyInputs.read(
        case, settings, initial, [over], lambda case: (read_over(case, over, settings, FALLING),)
    )
    chosen = {"cold": cold, "up": up, "down": down}
    ways = [name for name, wanted in chosen.items() if wanted] or list(chosen)
    folder = asked.made_ready(
        out, ["sweep.nc", "sweep.json", "sweep.svg", "sweep.pdf", *csv.files(*SWEEP_TABLES)]
    )

    from gearlash.cli.answers.sweep import sweep_answer
    from gearlash.cli.command_tables import sweep_tables

    found = _found(asked, ways, asked.search(periods, max_period), workers)
    (along,) = asked.axes
    answer = sweep_answer(asked.case, asked.parameters, along.named, found, along.unit, asked.named_start)

    changes = _changes(asked.case, found) if folder else ()

    def keep(folder: OutFolder) -> None:
        from gearlash.cli.files import write_sweep

        write_sweep(folder, asked.case, found, answer, changes)
        csv.keep(folder, SWEEP_TABLES, tables)

    def tables() -> Tables:
        return sweep_tables(asked.case, found, answer)

    return deliver(answer, as_json, folder, keep, csv.printing(tables))


def _found(
    asked: StudyInputs, ways: Sequence[str], search: SearchSettings, workers: int | None
) -> tuple[Sweep, ...]:
    """A sweep in each of these directions."""
    from gearlash.cli.interrupt import end_if_nothing
    from gearlash.cli.progress import progress_bar
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies import sweeps

    (axis,) = asked.ranges()
    with (
        executor_for(asked.case, workers, len(axis) * len(ways)) as executor,
        progress_bar("sweep") as progress,
    ):
        execution = Execution(executor, progress=progress)
        found = sweeps(asked.case, axis, ways, start=asked.start, settings=search, execution=execution)
    end_if_nothing(any(point.computed for each in found for point in each.points))
    return found


def _changes(case: Case, found: Sequence[Sweep]) -> tuple[Transition, ...]:
    """Special points at which the motions of a complete sweep change, solved for; for its figure."""
    from gearlash.cli.interrupt import optional

    name, family = found[0].axis.name, case.family()[0]
    if name not in family.defaults or not all(way.complete for way in found):
        return ()
    several = [(way, part) for way in found for part in _periodic(way) if len({p.label for p in part}) > 1]
    return (optional(lambda: _followed(case, name, several)) if several else None) or ()


def _periodic(way: Sweep) -> list[tuple[Point, ...]]:
    """Stretches of periodic motion: no point is solved for beside another motion, such as the neutral one of
    a pair without load."""
    from itertools import groupby

    return [tuple(part) for periodic, part in groupby(way.points, lambda p: p.period > 0) if periodic]


def _followed(
    case: Case, name: str, several: Sequence[tuple[Sweep, tuple[Point, ...]]]
) -> tuple[Transition, ...]:
    """The changes of each of these stretches that a point was solved for; it is told how far this is."""
    from time import monotonic

    from gearlash.cli.progress import progress_bar
    from gearlash.jobs import Progress
    from gearlash.studies.transitions import by_step

    changes: list[Transition] = []
    began, done = monotonic(), 0
    total = sum(len(part) - 1 for _, part in several)
    with progress_bar("changes of the motion, for the figure") as progress:
        for way, part in several:
            for _, some in by_step(case, name, part, rising=way.direction != "down"):
                changes += [change for change in some if change.point is not None]
                done += 1
                elapsed = monotonic() - began
                progress(Progress(done, total, elapsed, elapsed / done * (total - done)))
    return tuple(changes)
