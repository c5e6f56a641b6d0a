"""gearlash report"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearlash.cli.exits import ExitCode, code_of, command, delivery
from gearlash.cli.options import (
    AsCsv,
    AsJson,
    CaseArgument,
    DecimalComma,
    MaxPeriod,
    Periods,
    ReportOut,
    Settings,
    Workers,
)

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from gearlash.case import Case
    from gearlash.cli.frame import StudyInputs
    from gearlash.cli.inputs import Over
    from gearlash.orbits import Settings as SearchSettings
    from gearlash.report.pair import Contents
    from gearlash.studies.assessment import Assessment


Speeds = Annotated[
    str | None,
    typer.Option(
        metavar="SPEED=FROM:TO:COUNT",
        help="Speeds to examine, such as pinion_speed=1000:6000rpm:201. [default: from least_speed to "
        "greatest_speed of the case, else from half its own to half more, 201]",
    ),
]


@command
def report(
    case: CaseArgument,
    over: Speeds = None,
    settings: Settings = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    workers: Workers = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: ReportOut = Path("report"),
) -> ExitCode:
    """May this pair run where it is meant to? A verdict first, then one page with what it rests on.

    The verdict is printed as soon as it stands. report.html (one file that works offline and prints) has it
    with forces of mesh and bearings, transmission error and impacts over speed, motions, spectra and maps;
    figures/ has them as SVG and PDF, and curves, histories and spectra lie beside as CSV and NetCDF. Ctrl-C
    keeps what there is by then. It is an analysis, and no approval.
    """
    from gearlash.cli.frame import StudyInputs
    from gearlash.cli.tables import CsvAsked
    from gearlash.results.pair_question import check_pair

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    asked = StudyInputs.read(case, settings, None, [over] if over else [], lambda case: (_over(case, over),))
    check_pair(asked.case)
    from gearlash.cli.answers.report import FILES

    place = asked.made_ready(out, FILES)
    assert place is not None  # there is a default

    from gearlash.cli.answers.report import report_answer
    from gearlash.cli.frame import show_answer
    from gearlash.cli.jsonio import write_file
    from gearlash.cli.show.report import done_view
    from gearlash.cli.terminal import show
    from gearlash.cli.workers import executor_for
    from gearlash.cli.worth import file_of, keep_answer
    from gearlash.report.folder import PAGE
    from gearlash.report.pair import render

    search = asked.search(periods, max_period)
    with executor_for(asked.case, workers, len(asked.axes[0].values)) as executor:
        found = _assessed(asked, search, executor)
        if not as_json:
            show_answer(report_answer(found), False)
        contents = _measured(asked, found, search, executor, over is None)
        answer = report_answer(found, contents, str(place.file(PAGE)))

        def write() -> None:
            render(contents, place.path, None if contents.missing else executor, csv.style)
            write_file(answer, place.file(file_of(answer)))

        with delivery():
            if not keep_answer(place, answer, write):
                answer = replace(answer, report="")
            if as_json:
                show_answer(answer, True)
            else:
                show(done_view, answer)
    return code_of(answer.status)


def _over(case: Case, over: str | None) -> Over:
    """The speeds as typed, or the case's range, or those around its own, which may lie anywhere."""
    from gearlash.cli.inputs import Over, read_over
    from gearlash.report.pair.whole import POINTS
    from gearlash.results.pair_question import SPEED, check_pair, speeds_around
    from gearlash.system import GearlashError

    if over is None:
        check_pair(case)
        return Over(SPEED, SPEED, speeds_around(case, POINTS).values)
    found = read_over(case, over)
    if found.short != SPEED:
        raise GearlashError(f"--over {found.named}: a report goes over speed, such as pinion_speed or omega")
    return found


def _assessed(asked: StudyInputs, search: SearchSettings, executor: Executor) -> Assessment:
    """The verdict's numbers."""
    from gearlash.cli.interrupt import end_if_nothing
    from gearlash.cli.progress import stage_bar
    from gearlash.jobs import Execution
    from gearlash.report.pair.whole import assessed

    (axis,) = asked.ranges()
    with stage_bar() as tell:
        found = assessed(asked.case, axis, search, Execution(executor), tell)
    end_if_nothing(found.signals is not None)
    return found


def _measured(
    asked: StudyInputs, found: Assessment, search: SearchSettings, executor: Executor, usual: bool
) -> Contents:
    """All else, as far as no signal comes; ``usual``: nobody said at how many speeds."""
    from gearlash.cli.interrupt import signalled
    from gearlash.cli.progress import stage_bar
    from gearlash.jobs import Execution
    from gearlash.report.pair.whole import measured

    (axis,) = asked.ranges()
    with stage_bar() as tell:
        execution = Execution(executor)
        contents = measured(found, axis, search, execution, tell, lambda: bool(signalled()), usual=usual)
        tell("report", None)
    return contents
