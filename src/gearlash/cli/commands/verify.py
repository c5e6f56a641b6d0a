"""gearlash verify"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from gearlash.cli.exits import ExitCode, command
from gearlash.cli.options import AsCsv, AsJson, CaseArgument, DecimalComma, Out, Settings, Workers

if TYPE_CHECKING:
    from collections.abc import Sequence

    from gearlash.case import Case
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.tables import Tables
    from gearlash.jobs import Progress
    from gearlash.multibody.topography import Relief
    from gearlash.studies.verification import Plan, Verification

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
FlexiblePinion = Annotated[
    bool,
    typer.Option(
        "--flexible-pinion",
        help="The body of the pinion bends, too, with a shaft whose ends lie in the bearings; as it is, that "
        "is one of the settings beside.",
    ),
]
TipRelief = Annotated[
    str | None,
    typer.Option(
        metavar="LENGTH",
        help="One more way to hold the inputs: flanks of the case's width relieved at all tips by so much "
        "(20um), normal to the flank.",
    ),
]
ReliefLength = Annotated[
    str, typer.Option(metavar="LENGTH", help="Roll length over which that relief grows, linearly.")
]
Crowning = Annotated[
    str | None,
    typer.Option(
        metavar="LENGTH", help="Of the same flanks: off at both ends of the face (10um), both gears together."
    ),
]
Unmodified = Annotated[
    bool,
    typer.Option(
        "--unmodified",
        help="One more way to hold the inputs: without the relief and crowning that the case states, which "
        "all others have.",
    ),
]


@command
def verify(
    case: CaseArgument,
    speed: Speeds = None,
    settings: Settings = None,
    quick: Quick = False,
    flexible_pinion: FlexiblePinion = False,
    tip_relief: TipRelief = None,
    relief_length: ReliefLength = "2mm",
    crowning: Crowning = None,
    unmodified: Unmodified = False,
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
    relief = _relief(tip_relief, relief_length, crowning)
    omegas = _omegas(asked, speed)
    folder = claim_if(out, [*FILES, *csv.files(*TABLES)])
    load_engine()

    from gearlash.cli.answers.verify import verify_answer
    from gearlash.cli.verify_tables import verify_tables
    from gearlash.studies.verification import planned

    plan = planned(quick, flexible_pinion, relief, unmodified)
    found = _found(asked, omegas, plan, workers)
    answer = verify_answer(asked, found)

    def keep(folder: OutFolder) -> None:
        from gearlash.cli.verify_files import write_verification

        write_verification(folder, found, answer)
        csv.keep(folder, TABLES, tables)

    def tables() -> Tables:
        return verify_tables(answer)

    return deliver(answer, as_json, folder, keep, csv.printing(tables))


def _found(case: Case, omegas: Sequence[float], plan: Plan, workers: int | None) -> Verification:
    """The comparison, as far as no signal comes."""
    from gearlash.cli.interrupt import end_if_nothing, expect_results
    from gearlash.cli.progress import stage_bar
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies.verification import MOTIONS, verification

    with executor_for(case, workers, 1_000) as executor, stage_bar() as bar:
        found_some: list[str] = []

        def tell(stage: str, progress: Progress | None) -> None:
            # finite elements are kept as they are found; from the first motion on there is an answer to keep
            if progress is not None and stage == MOTIONS and not found_some:
                found_some.append(stage)
                expect_results()
            bar(stage, progress)

        found = verification(case, speeds=omegas, plan=plan, execution=Execution(executor), tell=tell)
    end_if_nothing(any(one.points or one.beside or one.up or one.down for one in found.compared))
    return found


def _omegas(case: Case, speeds: list[str] | None) -> tuple[float, ...]:
    """The speeds as ω of the case."""
    return tuple(case.resolve("pinion_speed", each)[1] for each in speeds or ())


def _relief(tip: str | None, length: str, crowning: str | None) -> Relief | None:
    """Modified flanks; None where nothing of them is asked for."""
    from gearlash.multibody.topography import Relief

    if tip is None and crowning is None:
        return None
    off, over = _metres("--tip-relief", tip or "0 um"), _metres("--relief-length", length)
    crowned = _metres("--crowning", crowning or "0 um")
    if not over > 0.0:
        raise typer.BadParameter(f"--relief-length {length}: a length above 0")
    return Relief(off, off, over, over, crowning=crowned)


def _metres(option: str, text: str) -> float:
    """A length of one of the options, m; at least 0."""
    from gearlash.case.units import LENGTH, UnitError, in_si, read, takes

    try:
        number, written = read(text)
    except UnitError:
        number, written = None, None
    if number is None or written is None or not takes(LENGTH, written) or number < 0:
        raise typer.BadParameter(f"{option} {text}: a length with its unit, not below 0, such as 20um")
    return in_si(LENGTH, number, written)
