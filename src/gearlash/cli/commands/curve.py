"""gearlash curve"""

from __future__ import annotations

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

    from gearlash.cli.answers.curve import CurveAnswer
    from gearlash.cli.answers.curve_parts import Begun
    from gearlash.cli.curve_inputs import CurveInputs
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.tables import Tables

MOST_FILES = 64  # curves that are kept in a folder

Over = Annotated[
    list[str],
    typer.Option(
        metavar="NAME=FROM:TO",
        help="A parameter and its limits: omega=0.5:1.4, backlash=20:120um. To be given twice.",
    ),
]
From = Annotated[
    list[str] | None,
    typer.Option(
        "--from",
        metavar="POINT",
        help="Special point of the branch over the first parameter: its number, its kind (grazing, fold, "
        "doubling, Neimark-Sacker: the nearest one to the case), a kind with a value (fold=0.708: the "
        "nearest one to it), or all. May be given several times.",
    ),
]
Resume = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE", help="A branch or a curve that --out has kept (branch-1.json, curve-1.json …)."
    ),
]
At = Annotated[
    int | None,
    typer.Option(min=1, metavar="NUMBER", help="With --resume: begins at this special point of the file."),
]
Near = Annotated[
    str | None,
    typer.Option(metavar="VALUE", help="Value of the first parameter to begin at. [default: the case's]"),
]
Kind = Annotated[
    str | None,
    typer.Option(
        metavar="KIND",
        help="Which curve, where several meet in a point of one: grazing, fold, doubling, Neimark-Sacker.",
    ),
]
Touch = Annotated[
    int,
    typer.Option(
        min=1, metavar="NUMBER", help="Where two extrema touch at once: which of them stays in touch."
    ),
]
Doubled = Annotated[
    bool,
    typer.Option(
        "--doubled",
        help="From a grazing with a multiplier -1: the curve on which the orbit of twice its period grazes.",
    ),
]
Step = Annotated[
    float | None,
    typer.Option(
        min=1e-6,
        max=1.0,
        metavar="SHARE",
        help="Longest step, as a share of the limits or of the motion's size. [default: 0.05]",
    ),
]


@command
def curve(
    case: CaseArgument,
    over: Over,
    settings: Settings = None,
    begin: From = None,
    resume: Resume = None,
    at: At = None,
    near: Near = None,
    initial: Initial = None,
    kind: Kind = None,
    touch: Touch = 1,
    doubled: Doubled = False,
    step: Step = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """Along which lines in two parameters do motions graze, fold or double, and where do lines meet?

    A special point of a branch is followed both ways in the plane of two parameters, stable or not, and the
    points on it at which two things happen at once are solved for. Without --resume the branch through the
    motion of the case is followed over the first parameter, for its special points. --out writes curve.json,
    each curve as curve-N.json (which --resume takes), .nc and .csv, special.csv, the branch as branch-1.json,
    and the figure as SVG and PDF. Ctrl-C keeps what was found, marked incomplete.
    """
    from gearlash.cli.branch_inputs import steps_of
    from gearlash.cli.command_tables import curve_tables
    from gearlash.cli.curve_files import file_names, write_curves
    from gearlash.cli.curve_inputs import CurveInputs
    from gearlash.cli.folder import claim_if
    from gearlash.cli.frame import deliver
    from gearlash.cli.notice import load_engine
    from gearlash.cli.settings import search_settings
    from gearlash.cli.slow import tell_if_slow
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    asked = CurveInputs.read(case, settings, over, begin, resume, at, near, initial, kind, touch, doubled)
    steps = steps_of(step)
    search = search_settings(asked.family, periods, max_period, case)
    folder = claim_if(out, file_names(MOST_FILES if len(begin or ()) != 1 or "all" in (begin or ()) else 1))
    load_engine(data=folder is not None)
    tell_if_slow(asked.family, asked.parameters)

    from gearlash.cli.interrupt import expect_results
    from gearlash.cli.progress import progress_bar
    from gearlash.jobs import Execution

    expect_results()
    with progress_bar("orbits") as progress:
        found = asked.followed(search, steps, Execution(progress=progress))
    answer = _answer(asked, found)

    def keep(folder: OutFolder) -> None:
        write_curves(folder, asked, found, answer, csv)

    def tables() -> Tables:
        return curve_tables(asked.case, [each.curve for each in found if each.curve is not None], answer)

    return deliver(answer, as_json, folder, keep, csv.printing(tables))


def _answer(asked: CurveInputs, found: Sequence[Begun]) -> CurveAnswer:
    from gearlash.cli.answers.curve import curve_answer

    return curve_answer(asked.case, asked.parameters, asked.limits, asked.start, found)
