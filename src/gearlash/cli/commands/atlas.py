"""gearlash atlas"""

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

TABLES = "curves", "points", "map"
MOST_CURVES = 400
COUNTS = 41, 21  # of the coarse map, along either axis, unless they are said

Over = Annotated[
    list[str],
    typer.Option(
        metavar="NAME=FROM:TO[:COUNT]",
        help="Parameter of an axis, by short name or path: omega=0.5:1.4, backlash=20:120um. To be given "
        "twice: first for the horizontal axis, then for the vertical one. COUNT: points of the coarse map "
        f"[default: {COUNTS[0]} and {COUNTS[1]}]",
    ),
]
Curves = Annotated[
    int,
    typer.Option(
        min=0,
        max=MOST_CURVES,
        metavar="N",
        help="Budget: curves that are followed at the most. It counts work, so that the answer is the same "
        "on any machine.",
    ),
]
Lines = Annotated[
    int,
    typer.Option(
        min=0, max=64, metavar="N", help="Lines along either axis on which motions are swept and followed."
    ),
]
Depth = Annotated[
    int,
    typer.Option(
        min=0,
        max=8,
        metavar="N",
        help="How many times curves are begun anew from what the check and the points of the curves show.",
    ),
]
Longest = Annotated[
    int,
    typer.Option(
        min=1, max=64, metavar="P", help="Period of the longest motion that is followed, in cycles."
    ),
]
Seconds = Annotated[
    float | None,
    typer.Option(
        min=1.0,
        metavar="S",
        help="Budget of time: what is not done by then is left. The answer then depends on the machine.",
    ),
]


@command
def atlas(
    case: CaseArgument,
    over: Over,
    settings: Settings = None,
    initial: Initial = None,
    curves: Curves = 60,
    lines: Lines = 3,
    depth: Depth = 2,
    longest: Longest = 12,
    seconds: Seconds = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    workers: Workers = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """Along which curves do motions begin, end and change in a plane of two parameters, and where do they
    meet?

    Motions are looked for by a coarse map and by sweeps both ways along a few lines, and followed along their
    branches; the curves of their grazings, folds, doublings and Neimark-Sacker points are followed through
    the rectangle. The map then is a check: which changes between neighbouring pixels the curves explain, and
    which not. --out writes atlas.nc (NetCDF), atlas.json, every curve as curve-N.json, and the figure as SVG
    and PDF. Ctrl-C keeps what was found, marked incomplete.
    """
    from gearlash.cli.frame import StudyInputs, deliver
    from gearlash.cli.inputs import read_plane
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    texts = [_counted(text, count) for text, count in zip(over, (*COUNTS, *over), strict=False)]
    asked = StudyInputs.read(case, settings, initial, texts, lambda case: read_plane(case, texts, settings))
    files = [f"curve-{i}.json" for i in range(1, curves + 1)]
    folder = asked.made_ready(
        out, ["atlas.nc", "atlas.json", "atlas.svg", "atlas.pdf", *files, *csv.files(*TABLES)]
    )

    from gearlash.cli.answers.atlas import atlas_answer
    from gearlash.cli.command_tables import atlas_tables
    from gearlash.cli.interrupt import end_if_nothing
    from gearlash.cli.progress import progress_bar
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies.atlas import atlas as make_atlas
    from gearlash.system import Status

    ((x, y), search, (across, up)) = asked.ranges(), asked.search(periods, max_period), asked.axes
    with executor_for(asked.case, workers, len(x) * len(y)) as executor, progress_bar("atlas") as progress:
        found = make_atlas(
            asked.case, x, y, curves=curves, lines=lines, depth=depth, longest=longest, seconds=seconds,
            start=asked.start, settings=search, execution=Execution(executor, progress=progress),
        )  # fmt: skip
    end_if_nothing(set(found.plane.statuses) != {Status.NOT_COMPUTED})
    told = (across.named, up.named), (across.unit, up.unit)
    answer = atlas_answer(asked.case, asked.parameters, *told, found, curves, asked.named_start)

    def keep(folder: OutFolder) -> None:
        from gearlash.cli.atlas_files import write_atlas

        write_atlas(folder, asked.case, found, answer)
        csv.keep(folder, TABLES, tables)

    def tables() -> Tables:
        return atlas_tables(asked.case, found, answer)

    return deliver(answer, as_json, folder, keep, csv.printing(tables))


def _counted(text: str, count: int | str) -> str:
    """With the number of points, where none was typed."""
    return f"{text}:{count}" if text.count(":") == 1 and isinstance(count, int) else text
