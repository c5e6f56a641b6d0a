"""gearlash verify"""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from gearlash.cli.exits import ExitCode, command
from gearlash.cli.options import AsJson, CaseArgument, Out, Settings, Workers

if TYPE_CHECKING:
    from gearlash.case import Case

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
    out: Out = None,
) -> ExitCode:
    """Does a model of bodies in space with real teeth move as the lumped one says?

    Involute flanks, compliance from finite elements and contact that only pushes, in bodies with six degrees
    of freedom; the lumped model gets the stiffness and the error of those teeth, under every contact rule.
    Compares at each --speed, over a window of speeds from both directions, and with one assumption changed at
    a time. Needs the extra: pip install "gearlash[multibody]". --out writes verify.json.
    """
    from gearlash.cli.folder import claim_if
    from gearlash.cli.frame import deliver
    from gearlash.cli.inputs import read_case
    from gearlash.cli.jsonio import write_file
    from gearlash.cli.notice import load_engine
    from gearlash.multibody.extra import require_extra

    require_extra()
    asked = read_case(case, settings)
    omegas = _omegas(asked, speed)
    folder = claim_if(out, ["verify.json"])
    load_engine()

    from gearlash.cli.answers.verify import verify_answer
    from gearlash.cli.interrupt import expect_results
    from gearlash.cli.progress import stage_bar
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies.verification import Plan, sensitivity, verification

    plan = Plan(window_over=(0.0, 0.0, 0)) if quick else Plan(beside=sensitivity())
    expect_results()
    with executor_for(asked, workers, 1_000) as executor, stage_bar() as tell:
        found = verification(asked, speeds=omegas, plan=plan, execution=Execution(executor), tell=tell)
    answer = verify_answer(asked, found)
    return deliver(answer, as_json, lambda: folder and write_file(answer, folder.file("verify.json")))


def _omegas(case: Case, speeds: list[str] | None) -> tuple[float, ...]:
    """The speeds as ω of the case."""
    return tuple(case.resolve("pinion_speed", each)[1] for each in speeds or ())
