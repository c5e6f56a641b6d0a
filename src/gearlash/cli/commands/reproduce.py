"""gearlash reproduce"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from gearlash.cli.exits import ExitCode, command, delivery
from gearlash.cli.interrupt import end_if_nothing, expect_results, nothing_more
from gearlash.cli.options import AsCsv, AsJson, DecimalComma, ReportOut, Settings, Workers

if TYPE_CHECKING:
    from gearlash.article.verified import Verified
    from gearlash.case import Case
    from gearlash.cli.answers.reproduce import ReproduceAnswer
    from gearlash.cli.answers.sweep import SweepAnswer
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.progress import StageCallback
    from gearlash.jobs import Progress
    from gearlash.results import Sweep

TABLES = "claims", "parts", "checks"


@command
def reproduce(
    case: Annotated[
        str,
        typer.Argument(
            metavar="CASE", help="The article's pair, or a variation of it: Table 1 as in the article."
        ),
    ] = "article",
    settings: Settings = None,
    points: Annotated[
        int | None,
        typer.Option(
            min=11,
            max=100_000,
            metavar="N",
            help="Points on each of the two axes. [default: 451 over omega, 361 over D]",
        ),
    ] = None,
    verify: Annotated[
        bool,
        typer.Option(
            "--verify",
            help="Computes the pair with real teeth in this run, too (some 15 minutes more on two cores; "
            "needs the extra). Otherwise the report shows numbers that are kept, and says so.",
        ),
    ] = False,
    workers: Workers = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: ReportOut = Path("reproduce"),
) -> ExitCode:
    """What of the article holds? Its whole study, reported values beside computed ones, as one report.

    Writes report.html (one file that works offline), report.json (every number), figures/ (SVG and PDF), and
    the sweeps of both axes as they are done (sweep-omega, sweep-D; .nc and .json), which stay if it is
    stopped. Takes a few minutes.
    """
    from gearlash.article.pair import check_pair
    from gearlash.cli.folder import claim
    from gearlash.cli.frame import deliver
    from gearlash.cli.inputs import read_case
    from gearlash.cli.jsonio import write_file
    from gearlash.cli.notice import load_engine
    from gearlash.cli.record_tables import reproduce_tables
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    chosen = read_case(case, settings)
    check_pair(chosen)
    if verify:
        _check_teeth(chosen)
    sweeps = [f"sweep-{name}{ending}" for name in ("omega", "D") for ending in (".nc", ".json")]
    folder = claim(
        out, ["report.html", "report.json", "figures", "reproduce.json", *sweeps, *csv.files(*TABLES)]
    )
    load_engine(data=True)

    answer = _answer(chosen, points, workers, folder, verify)

    def keep(folder: OutFolder) -> None:
        write_file(answer, folder.file("reproduce.json"))
        csv.keep(folder, TABLES, lambda: reproduce_tables(answer))

    return deliver(answer, as_json, folder, keep)


def _check_teeth(case: Case) -> None:
    """Refuses what the section of real teeth is not made for: another case, or no extra."""
    import gearlash as gl
    from gearlash.multibody.extra import require_extra

    require_extra()
    if case.hash != gl.load_case("article").hash:
        raise typer.BadParameter(
            "--verify is for the article's pair as it comes, beside what the article reports of it; for "
            "other values there is gearlash verify"
        )


def _answer(
    case: Case, points: int | None, workers: int | None, folder: OutFolder, verify: bool
) -> ReproduceAnswer:
    """The study, and its report in the folder."""
    from gearlash import article
    from gearlash.article import report
    from gearlash.cli.answers.reproduce import reproduce_answer
    from gearlash.cli.progress import stage_bar
    from gearlash.jobs import open_executor

    with stage_bar() as progress:
        keep, show_stage = _keeper(case, folder), _expecting_results(progress)
        found = article.reproduce(case, _scope(points), workers=workers, progress=show_stage, keep=keep)
        real, checked = _teeth(case, verify, workers, progress)
        progress("report", None)
        folder.make_room()
        with open_executor(workers) as executor, delivery(breakable=True):
            page = report.render(found, folder.path, executor, real=real, checked=checked)
    return reproduce_answer(found, str(page))


def _teeth(
    case: Case, verify: bool, workers: int | None, progress: StageCallback
) -> tuple[Verified | None, str]:
    """The pair with real teeth, computed now; or what a short computation says of what is kept of it."""
    from gearlash.article.verified import from_data, verified
    from gearlash.article.verifying import checked, plan_of_article

    if not verify:
        kept = verified(case)
        progress("check of what is kept", None)
        return None, "" if kept is None else checked(case, kept.check)
    from gearlash.cli.answers.verify import verify_answer
    from gearlash.cli.verified_data import verified_data
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies.verification import verification

    with executor_for(case, workers, 1_000) as executor:
        found = verification(case, plan=plan_of_article(), execution=Execution(executor), tell=progress)
    if found.reason:
        raise KeyboardInterrupt  # sweeps are kept; a section of some of the points would not be one
    return from_data(verified_data(found, verify_answer(case, found), {}), in_run=True), ""


def _keeper(case: Case, folder: OutFolder) -> Callable[[str, Sequence[Sweep]], None]:
    """Writes the sweeps of an axis as soon as they are there, if anything of them is."""
    from gearlash.cli.answers.sweep import sweep_answer
    from gearlash.cli.files import write_data
    from gearlash.cli.worth import keep_answer
    from gearlash.results import sweep_dataset

    parameters = case.family()[0].complete()

    def write(answer: SweepAnswer, name: str, sweeps: Sequence[Sweep]) -> None:
        write_data(folder, f"sweep-{name}", sweep_dataset(case, sweeps), answer)

    def keep(name: str, sweeps: Sequence[Sweep]) -> None:
        end_if_nothing(any(point.computed for sweep in sweeps for point in sweep.points))
        with delivery():
            answer = sweep_answer(case, parameters, name, sweeps)
            keep_answer(folder, answer, partial(write, answer, name, sweeps), f"sweep-{name}.json")
        nothing_more()  # what is not swept is soon done again

    return keep


def _expecting_results(progress: StageCallback) -> StageCallback:
    """Shows the same progress. When the sweeps begin, it also says that from now on there is something that
    is worth keeping."""
    from gearlash.article.stages import STAGES

    def tell(stage: str, state: Progress | None) -> None:
        if state is None and stage in STAGES[:2]:
            expect_results()
        progress(stage, state)

    return tell


def _scope(points: int | None):
    from dataclasses import replace

    from gearlash.article import Scope

    scope = Scope()
    if points is None:
        return scope
    return replace(scope, omega=(*scope.omega[:2], points), backlash=(*scope.backlash[:2], points))
