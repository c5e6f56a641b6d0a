"""gearlash compare"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from gearlash.cli.exits import ExitCode, command
from gearlash.cli.options import AsCsv, AsJson, CaseArgument, DecimalComma, Out, Settings, Workers

if TYPE_CHECKING:
    from gearlash.case import Case
    from gearlash.case.measurement import Measurement
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.tables import Tables
    from gearlash.studies.comparison import Comparison

TABLES = "compare", "jumps"
Data = Annotated[
    str,
    typer.Argument(
        metavar="DATA",
        help="Text file of columns, as instruments and spreadsheets write them (semicolons, tabs, commas or "
        "blanks; decimal points or commas): names above the numbers, units in brackets behind them or in a "
        "line below (speed [rpm]; error [um]). Rows that rise or fall in speed say how it was measured.",
    ),
]
QuantityName = Annotated[
    str,
    typer.Option(
        metavar="NAME",
        help="What was measured: transmission_error, mesh_force, gap, bearing_force_yp, _zp, _yg, _zg, "
        "acceleration_yp, _zp, _yg, _zg (pinion and gear, lateral and axial).",
    ),
]
FigureName = Annotated[
    str,
    typer.Option(
        metavar="FIGURE",
        help="peak, peak-to-peak, rms (about the mean), mean, or order: the rms of one line. "
        "[default: as the column is named (TE rms [um]), else peak-to-peak]",
    ),
]
Order = Annotated[
    float,
    typer.Option(metavar="ORDER", min=1e-6, max=1e4, help="Of the mesh frequency, for --figure order."),
]
SpeedColumn = Annotated[
    str,
    typer.Option(
        metavar="COLUMN",
        help="Name or number of the column of speeds. [default: the first with a unit of speed, "
        "or the first]",
    ),
]
ValueColumn = Annotated[
    str,
    typer.Option(
        metavar="COLUMN",
        help="Of the measured values. [default: the next with a unit that fits, or the next]",
    ),
]
SpeedUnit = Annotated[
    str,
    typer.Option(
        metavar="UNIT", help="Of the speeds, where the file does not say it: rpm, or Hz of the mesh."
    ),
]
ValueUnit = Annotated[
    str, typer.Option(metavar="UNIT", help="Of the values, where the file does not say it; dB for levels.")
]
Reference = Annotated[
    str, typer.Option(metavar="VALUE", help="What levels in dB refer to: '1 um', '1e-6 m/s^2'.")
]


@command
def compare(
    case: CaseArgument,
    data: Data,
    quantity: QuantityName = "transmission_error",
    figure: FigureName = "",
    order: Order = 1.0,
    speed: SpeedColumn = "",
    value: ValueColumn = "",
    speed_unit: SpeedUnit = "",
    unit: ValueUnit = "",
    reference: Reference = "",
    settings: Settings = None,
    workers: Workers = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """How does a measurement over speed agree with this pair?

    Computes the same figure at the measured speeds, with speed rising and falling, and tells residuals and
    which measured jumps lie at which events of the computed motion. --out writes compare.json, compare.csv
    and the overlay as SVG and PDF.
    """
    from gearlash.cli.frame import deliver
    from gearlash.cli.inputs import read_case
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    asked = read_case(case, settings)

    from gearlash.cli.folder import claim_if
    from gearlash.cli.notice import load_engine

    files = [f"compare.{ending}" for ending in ("json", "csv", "svg", "pdf")]
    folder = claim_if(out, [*files, *csv.files(*TABLES)])
    load_engine(data=folder is not None)

    from gearlash.case.column_figures import figure_in
    from gearlash.case.measurement import load_measurement
    from gearlash.cli.answers.compare import compare_answer
    from gearlash.cli.command_tables import compare_tables
    from gearlash.studies.comparison import known_quantity

    known_quantity(asked, quantity)  # before a file is read
    given = load_measurement(
        asked, data, quantity,
        speed=speed, value=value, speed_unit=speed_unit, unit=unit, reference=reference,
    )  # fmt: skip
    figure = figure or figure_in(given.columns[1]) or "peak-to-peak"
    found = _found(asked, given, figure, order, workers)
    answer = compare_answer(asked, found)

    def keep(folder: OutFolder) -> None:
        from gearlash.cli.compare_files import write_compare

        table = csv.content(tables()["compare"])
        write_compare(folder, asked, found, answer, table)
        csv.keep(folder, TABLES[1:], tables)

    def tables() -> Tables:
        return compare_tables(answer)

    return deliver(answer, as_json, folder, keep, csv.printing(tables))


def _found(case: Case, given: Measurement, figure: str, order: float, workers: int | None) -> Comparison:
    """The same figure of the computed motion, as far as no signal comes."""
    import numpy as np

    from gearlash.cli.interrupt import end_if_nothing, expect_results
    from gearlash.cli.progress import progress_bar
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies.comparison import compare as study

    expect_results()
    with executor_for(case, workers, 2 * len(given.omega)) as executor, progress_bar("speeds") as progress:
        execution = Execution(executor, progress=progress)
        found = study(case, given, figure, order=order, execution=execution)
    end_if_nothing(bool(np.isfinite([found.up, found.down]).any()))
    return found
