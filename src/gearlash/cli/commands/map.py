"""gearlash map"""

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
    Periods,
    Settings,
    Workers,
)

if TYPE_CHECKING:
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.tables import Tables


@command
def map(
    case: CaseArgument,
    over: Annotated[
        list[str],
        typer.Option(
            metavar="NAME=FROM:TO:COUNT",
            help="Parameter of an axis, by short name or path: omega=0.5:1.4:200, backlash=20um:120um:200. "
            "To be given twice: first for the horizontal axis, then for the vertical one.",
        ),
    ],
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
    """Which motion belongs to which pair of values of two parameters?

    One attractor per pixel of the plane of two parameters, each from the cold start, or from the state of
    --initial. --out writes map.nc
    (everything, NetCDF), map.json, and the map as SVG and PDF. Ctrl-C keeps what was computed, marked
    incomplete.
    """
    from gearlash.cli.frame import StudyInputs, deliver
    from gearlash.cli.inputs import read_plane
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    asked = StudyInputs.read(case, settings, initial, over, lambda case: read_plane(case, over, settings))
    folder = asked.made_ready(out, ["map.nc", "map.json", "map.svg", "map.pdf", *csv.files("map")])

    from gearlash.cli.answers.map import map_answer
    from gearlash.cli.command_tables import map_tables
    from gearlash.cli.interrupt import end_if_nothing
    from gearlash.cli.progress import progress_bar
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies import map_plane
    from gearlash.system import Status

    ((x, y), search, (across, up)) = asked.ranges(), asked.search(periods, max_period), asked.axes
    with executor_for(asked.case, workers, len(x) * len(y)) as executor, progress_bar("map") as progress:
        execution = Execution(executor, progress=progress)
        found = map_plane(asked.case, x, y, start=asked.start, settings=search, execution=execution)
    end_if_nothing(set(found.statuses) != {Status.NOT_COMPUTED})
    named, units = (across.named, up.named), (across.unit, up.unit)
    answer = map_answer(asked.case, asked.parameters, named, found, units, asked.named_start)

    def keep(folder: OutFolder) -> None:
        from gearlash.cli.files import write_map

        write_map(folder, asked.case, found, answer)
        csv.keep(folder, ["map"], tables)

    def tables() -> Tables:
        return map_tables(asked.case, found, (answer.x, answer.y))

    return deliver(answer, as_json, folder, keep, csv.printing(tables))
