"""gearlash tolerance"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from gearlash.cli.exits import ExitCode, command
from gearlash.cli.options import (
    AsCsv,
    AsJson,
    CaseArgument,
    DecimalComma,
    Out,
    Over,
    Settings,
    Workers,
)

if TYPE_CHECKING:
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.tables import Tables

TABLES = "tolerance", "profile", "bands", "inputs"
Limits = Annotated[
    list[str] | None,
    typer.Option(
        "--limits",
        metavar="NAME=FROM:TO",
        help="Limits of a value of the case, by short name or path: backlash=60:120um, "
        "torque=50:250Nm. May be given several times. [default: the limits that the case states and "
        "the ranges of all that it estimates]",
    ),
]
Samples = Annotated[
    int, typer.Option(min=2, max=65_536, metavar="N", help="Points of one set of samples, a power of 2.")
]
Replicates = Annotated[
    int,
    typer.Option(min=2, max=1_000, metavar="N", help="Independent sets: errors come from their spread."),
]


@command
def tolerance(
    case: CaseArgument,
    over: Over,
    limits: Limits = None,
    settings: Settings = None,
    samples: Samples = 32,
    replicates: Replicates = 8,
    workers: Workers = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """Where do teeth stay in contact in spite of tolerances, and which of them matters?

    Bands of --over in which the motion of teeth that never part exists and is stable: in all combinations of
    values that were tried, in none, and with which probability between; every value between its limits as
    likely as any other. Names the worst combination, as settings to run. --out writes tolerance.json,
    tolerance.csv, and the probability over the bands as SVG and PDF. Ctrl-C keeps what was tried, with its
    figure, marked incomplete.
    """
    from gearlash.cli.frame import deliver
    from gearlash.cli.inputs import read_case
    from gearlash.cli.limits import read_axis, read_limits
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    asked = read_case(case, settings, (over,))
    axis, ranges = read_axis(over), read_limits(limits)

    from gearlash.cli.folder import claim_if
    from gearlash.cli.notice import load_engine

    files = [f"tolerance.{ending}" for ending in ("json", "csv", "svg", "pdf")]
    folder = claim_if(out, [*files, *csv.files(*TABLES)])
    load_engine(data=folder is not None)

    from gearlash.cli.answers.tolerance import tolerance_answer
    from gearlash.cli.command_tables import tolerance_tables
    from gearlash.cli.interrupt import expect_results
    from gearlash.cli.progress import progress_bar
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies.tolerances import tolerance as study

    expect_results()
    with (
        executor_for(asked, workers, samples * replicates) as executor,
        progress_bar("tolerances") as progress,
    ):
        execution = Execution(executor, progress=progress)
        found = study(asked, axis, ranges, samples=samples, replicates=replicates, execution=execution)
    answer = tolerance_answer(asked, found)

    def keep(folder: OutFolder) -> None:
        from gearlash.cli.tolerance_files import write_tolerance

        table = csv.content(tables()["tolerance"])
        write_tolerance(folder, asked, found, answer, table)
        csv.keep(folder, TABLES[1:], tables)

    def tables() -> Tables:
        return tolerance_tables(answer)

    return deliver(answer, as_json, folder, keep, csv.printing(tables))
