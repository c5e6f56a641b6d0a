"""gearlash reproduce"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from gearlash.cli.exits import ExitCode, code_of, command, delivery
from gearlash.cli.options import AsJson, Settings, Workers


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
    workers: Workers = None,
    as_json: AsJson = False,
    out: Annotated[
        Path,
        typer.Option(
            "--out",
            metavar="DIR",
            help="Folder of the report, made if missing. Files there that gearlash did not write are never "
            "overwritten.",
        ),
    ] = Path("reproduce"),
) -> ExitCode:
    """What of the article holds? Its whole study, reported values beside computed ones, as one report.

    Writes report.html (one file that works offline), report.json (every number) and figures/ (SVG and PDF).
    Takes a few minutes.
    """
    from gearlash.cli.folder import claim
    from gearlash.cli.inputs import read_case
    from gearlash.cli.jsonio import write_file, write_stdout
    from gearlash.cli.notice import load_engine
    from gearlash.cli.terminal import show
    from gearlash.studies.article.pair import check_pair

    chosen = read_case(case, settings)
    check_pair(chosen)
    folder = claim(out, ["report.html", "report.json", "figures", "reproduce.json"])
    load_engine()

    from gearlash import report
    from gearlash.cli.answers.reproduce import reproduce_answer
    from gearlash.cli.progress import stage_bar
    from gearlash.jobs import open_executor
    from gearlash.studies import article

    with stage_bar() as progress:
        found = article.reproduce(chosen, _scope(points), workers=workers, progress=progress)
        progress("report", None)
        with open_executor(workers) as executor, delivery():
            page = report.render(found, folder.path, executor)
    answer = reproduce_answer(found, str(page))
    with delivery():
        write_file(answer, folder.file("reproduce.json"))
        if as_json:
            write_stdout(answer)
        else:
            from gearlash.cli.show.reproduce import reproduce_view

            show(reproduce_view, answer)
    return code_of(answer.status)


def _scope(points: int | None):
    from dataclasses import replace

    from gearlash.studies.article import Scope

    scope = Scope()
    if points is None:
        return scope
    return replace(scope, omega=(*scope.omega[:2], points), backlash=(*scope.backlash[:2], points))
