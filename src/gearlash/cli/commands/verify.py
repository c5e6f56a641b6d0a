"""gearlash verify"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from gearlash.cli.exits import ExitCode, command
from gearlash.cli.options import AsCsv, AsJson, CaseArgument, DecimalComma, Out, Settings, Workers

if TYPE_CHECKING:
    from gearlash.case import Case
    from gearlash.cli.tables import Tables

FIGURES = "force", "orders", "lines", "frames"
FILES = ("verify.json", *(f"{name}.{form}" for name in FIGURES for form in ("svg", "pdf")))
TABLES = "verify", "forces", "orders", "window", "breathing", "meshes"
Speeds = Annotated[
    list[str] | None,
    typer.Option(
        "--speed",
        metavar="VALUE",
        help="Speed of the pinion to compare at (3600rpm). May be given several times. [default: that of "
        "the case, and nine tenths of it]",
    ),
]
Quick = Annotated[
    bool,
    typer.Option("--quick", help="The speeds alone: no window from both directions, no settings beside."),
]


@command
def verify(
    case: CaseArgument,
    speed: Speeds = None,
    settings: Settings = None,
    quick: Quick = False,
    workers: Workers = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """Does a model of bodies in space with real teeth move as the lumped one says?

    Involute flanks, compliance from finite elements and contact that only pushes, in bodies with six degrees
    of freedom; the lumped model gets the stiffness and the error of those teeth, under every contact rule.
    Compares at each --speed, over a window of speeds from both directions, and with one assumption changed at
    a time. Needs the extra: pip install "gearlash[multibody]". --out writes verify.json and, as SVG and PDF,
    the force over time and its order spectrum beside the lumped model, lines of contact on a tooth, and
    frames of a motion.
    """
    from gearlash.cli.folder import claim_if
    from gearlash.cli.frame import deliver
    from gearlash.cli.inputs import read_case
    from gearlash.cli.notice import load_engine
    from gearlash.cli.tables import CsvAsked
    from gearlash.multibody.extra import require_extra

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    require_extra()
    asked = read_case(case, settings)
    omegas = _omegas(asked, speed)
    folder = claim_if(out, [*FILES, *csv.files(*TABLES)])
    load_engine()

    from gearlash.cli.answers.verify import verify_answer
    from gearlash.cli.interrupt import expect_results
    from gearlash.cli.progress import stage_bar
    from gearlash.cli.verify_tables import verify_tables
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies.verification import Plan, sensitivity, verification

    plan = Plan(window_over=(0.0, 0.0, 0)) if quick else Plan(beside=sensitivity())
    expect_results()
    with executor_for(asked, workers, 1_000) as executor, stage_bar() as tell:
        found = verification(asked, speeds=omegas, plan=plan, execution=Execution(executor), tell=tell)
    answer = verify_answer(asked, found)

    def keep() -> None:
        if folder:
            from gearlash.cli.verify_files import write_verification

            write_verification(folder, found, answer)
            csv.keep(folder, TABLES, tables)

    def tables() -> Tables:
        return verify_tables(answer)

    return deliver(answer, as_json, keep, csv.printing(tables))


def _omegas(case: Case, speeds: list[str] | None) -> tuple[float, ...]:
    """The speeds as ω of the case."""
    return tuple(case.resolve("pinion_speed", each)[1] for each in speeds or ())
