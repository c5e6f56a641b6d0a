"""gearlash branch"""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
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
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    import xarray as xr

    from gearlash.branches.continuation import ContinuationSettings, GrazingLaw
    from gearlash.case import Case
    from gearlash.cli.answers.branch import BranchAnswer
    from gearlash.cli.branch_inputs import BranchInputs
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.tables import Tables
    from gearlash.orbits import Settings as SearchSettings
    from gearlash.studies.switches import SwitchedBranch
    from gearlash.system import Family

MOST_FILES = 32  # branches that are kept in a folder


class Measure(StrEnum):
    """What the figure shows over the parameter."""

    EXTREMES = "extremes"
    AMPLITUDE = "amplitude"
    STROBES = "strobes"
    FORCE_MAX = "force_max"
    FORCE_RMS = "force_rms"


Over = Annotated[
    str | None,
    typer.Option(
        metavar="NAME=FROM:TO",
        help="Parameter to follow in, and its limits: omega=0.5:1.4, pinion_speed=3000:4500rpm. With "
        "--resume it may be left out: that of the file.",
    ),
]
Near = Annotated[
    str | None,
    typer.Option(metavar="VALUE", help="Value of that parameter to begin at. [default: the case's]"),
]
Switch = Annotated[
    list[str] | None,
    typer.Option(
        metavar="NUMBER",
        help="Also follows the branches that begin at this special point, by its number in the table, or "
        "at 'all'. May be given several times.",
    ),
]
Depth = Annotated[
    int, typer.Option(min=1, max=8, metavar="N", help="How many switches deep: 2 goes on to 1 → 2 → 4.")
]
Law = Annotated[
    bool,
    typer.Option("--law", help="How the multipliers move at every touch, predicted from the field."),
]
Resume = Annotated[
    Path | None,
    typer.Option(metavar="FILE", help="Begins with a branch that --out has kept (branch-1.json …)."),
]
At = Annotated[
    int | None,
    typer.Option(min=1, metavar="NUMBER", help="With --resume: begins at this special point of it."),
]
Step = Annotated[
    float | None,
    typer.Option(
        min=1e-6,
        max=1.0,
        metavar="SHARE",
        help="Longest step, as a share of the interval or of the motion's size. [default: 0.05]",
    ),
]
Zoom = Annotated[
    str | None,
    typer.Option(
        metavar="FROM:TO",
        help="Part of the interval that the figure shows, in the unit of --over. [default: all of it]",
    ),
]
Shown = Annotated[Measure, typer.Option(metavar="NAME", help=f"What the figure shows: {', '.join(Measure)}.")]


@command
def branch(
    case: CaseArgument,
    over: Over = None,
    settings: Settings = None,
    near: Near = None,
    initial: Initial = None,
    switch: Switch = None,
    depth: Depth = 1,
    law: Law = False,
    resume: Resume = None,
    at: At = None,
    step: Step = None,
    measure: Shown = Measure.EXTREMES,
    zoom: Zoom = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """Which motions, stable or not, lie on the branch through this one, and what bounds them?

    The periodic motion is followed both ways between the limits, round folds and through grazing; folds,
    doublings, Neimark-Sacker points, branch points and grazings are solved for. Motions on other branches are
    not looked for unless --switch leads there. --out writes branch.json, each branch as branch-N.json (which
    --resume takes), .nc and .csv, special.csv, and the figure as SVG and PDF. Ctrl-C keeps what was found,
    marked incomplete.
    """
    from gearlash.cli.branch_files import check_nothing_is_lost, write_branches
    from gearlash.cli.branch_inputs import BranchInputs, check_switches, read_switches, read_zoom, steps_of
    from gearlash.cli.command_tables import branch_tables
    from gearlash.cli.folder import claim_if
    from gearlash.cli.frame import deliver
    from gearlash.cli.notice import load_engine
    from gearlash.cli.settings import search_settings
    from gearlash.cli.slow import tell_if_slow
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    asked = BranchInputs.read(case, settings, over, near, initial, resume, at)
    points, steps = read_switches(switch), steps_of(step)
    if asked.kept is not None and asked.point is None:
        check_switches(asked.kept, points)
    span = () if zoom is None else read_zoom(asked.case, asked.between, zoom)
    search = search_settings(asked.family, periods, max_period, case)
    check_nothing_is_lost(out, resume, whole=asked.point is None)
    folder = claim_if(out, _file_names(MOST_FILES if switch else 1))
    load_engine(data=folder is not None)
    tell_if_slow(asked.family, asked.parameters)

    from gearlash.results.branch_dataset import branch_dataset

    answer, found = _followed(asked, search, points, depth, law, steps)
    datasets = _datasets(asked.case, found) if folder else None

    def keep(folder: OutFolder) -> None:
        write_branches(folder, asked.case, found, datasets, answer, csv, str(measure), span)

    def tables() -> Tables:
        made = [branch_dataset(asked.case, each.branch) for each in found]
        return branch_tables(asked.case, made, answer.axis)

    return deliver(answer, as_json, folder, keep, csv.printing(tables))


def _file_names(count: int) -> list[str]:
    kept = [f"branch-{i}.{form}" for i in range(1, count + 1) for form in ("json", "nc", "csv")]
    return ["branch.json", "special.csv", "branch.svg", "branch.pdf", *kept]


def _followed(
    asked: BranchInputs,
    search: SearchSettings,
    points: Sequence[int] | None,
    depth: int,
    law: bool,
    steps: ContinuationSettings,
) -> tuple[BranchAnswer, Sequence[SwitchedBranch]]:
    """The branch through the motion to begin with, those that were to be switched to, and what is told."""
    from gearlash.cli.answers.branch import branch_answer
    from gearlash.cli.branch_inputs import check_switches
    from gearlash.cli.interrupt import expect_results
    from gearlash.cli.progress import progress_bar
    from gearlash.jobs import Execution
    from gearlash.studies import continue_branch
    from gearlash.studies.switches import with_switches

    begin = asked.begin(search)
    said = asked.case, begin.parameters, asked.limits, begin.told
    if begin.start is None and begin.branch is None:
        return branch_answer(*said, ()), ()
    expect_results()
    with progress_bar("orbits") as progress:
        execution = Execution(progress=progress)
        first = begin.branch
        if first is None:
            over = asked.between
            limits = {"lower": over.lower, "upper": over.upper, "values": begin.parameters}
            first = continue_branch(
                asked.family, over.short, begin.start, **limits, steps=steps, execution=execution
            )
            check_switches(first, points)
        found, missed = with_switches(asked.family, first, points, depth, steps, execution)
    laws = _laws(asked.family, found) if law else {}
    return branch_answer(*said, found, missed, laws), found


def _laws(family: Family, found: Sequence[SwitchedBranch]) -> dict[tuple[int, int], GrazingLaw | str]:
    """Of every touch, or why there is none."""
    from gearlash.studies import grazing_law
    from gearlash.system import GearlashError

    laws: dict[tuple[int, int], GrazingLaw | str] = {}
    for i, each in enumerate(found):
        for j, special in enumerate(each.branch.special):
            if special.extremum is not None:
                try:
                    laws[i, j] = grazing_law(family, each.branch, special)
                except GearlashError as error:
                    laws[i, j] = str(error)
    return laws


def _datasets(case: Case, found: Sequence[SwitchedBranch]) -> list[xr.Dataset] | None:
    """With the extremes of every motion, unless a signal comes before they are computed."""
    from gearlash.cli.interrupt import optional
    from gearlash.results.branch_dataset import branch_dataset

    return optional(lambda: [branch_dataset(case, each.branch) for each in found])
