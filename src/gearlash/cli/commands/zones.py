"""gearlash zones"""

from __future__ import annotations

from enum import StrEnum
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
    from collections.abc import Sequence

    from gearlash.cli.folder import OutFolder
    from gearlash.cli.frame import StudyInputs
    from gearlash.cli.tables import Tables
    from gearlash.orbits import Settings as SearchSettings
    from gearlash.studies import Zones
    from gearlash.system import Family

ZONE_TABLES = "zones", "residents", "sweep"
LOOKED_AT = 400  # values at which a back side is looked for, about


class Kind(StrEnum):
    """Kinds of quiet motion."""

    IMPACT_FREE = "impact-free"
    DRIVE_SIDE_ONLY = "drive-side-only"


Overs = Annotated[
    list[str],
    typer.Option(
        metavar="NAME=FROM:TO:COUNT",
        help="Parameter to vary, by short name or path: omega=0.5:1.4:900, "
        "pinion_speed=1000:6000rpm:500, backlash=20:200um:100. Given twice, each as NAME=FROM:TO: the "
        "zone around the operating point in the plane of both.",
    ),
]
KindOption = Annotated[
    Kind | None,
    typer.Option(
        metavar="KIND",
        help="impact-free: no impact at all; drive-side-only: none on the back side. [default: both, "
        "where there is a back side]",
    ),
]
Tolerances = Annotated[
    list[str] | None,
    typer.Option(
        metavar="NAME=VALUE",
        help="With two --over: how far each of the two may lie beside its value (pinion_speed=50rpm). "
        "Says by what both can be multiplied before the zone ends.",
    ),
]


@command
def zones(
    case: CaseArgument,
    over: Overs,
    kind: KindOption = None,
    tolerance: Tolerances = None,
    settings: Settings = None,
    initial: Initial = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    workers: Workers = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """Which intervals are free of impacts, or of impacts on the back side?

    Cold, up and down sweeps; every motion found is followed once along its whole branch, and zones end at
    its grazings, folds, doublings and losses of stability. Says where the present value lies and how far its
    ends are, where every attractor found is quiet, where at least one is, and what coexists. --out writes
    zones.json, the sweeps as zones.nc, and the zones over them as SVG and PDF.

    With two --over the motion of the case is followed through the plane of both, and its zone is bounded by
    the curves along which it grazes, folds, doubles or loses its stability; margins along both, and of all
    --tolerance together. --out writes zone.json, the boundary as zone.csv, and the figure as SVG and PDF.
    """
    from gearlash.cli.frame import StudyInputs, deliver
    from gearlash.cli.inputs import read_over
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    if len(over) != 1 or tolerance:
        from gearlash.cli.zone_in_plane import zone_in_plane

        search = periods, max_period
        return zone_in_plane(case, over, kind, tolerance, settings, initial, search, as_json, csv, out)
    asked = StudyInputs.read(
        case, settings, initial, over, lambda case: (read_over(case, over[0], settings),)
    )
    (along,) = asked.axes
    kinds = _kinds(kind, asked.family, along.short, along.values.tolist())
    folder = asked.made_ready(
        out, ["zones.nc", "zones.json", "zones.svg", "zones.pdf", *csv.files(*ZONE_TABLES)]
    )

    from gearlash.cli.answers.zones import zones_answer
    from gearlash.cli.command_tables import zones_tables

    found = _found(asked, kinds, asked.search(periods, max_period), workers)
    answer = zones_answer(asked.case, asked.parameters, along.named, along.unit, found, asked.named_start)

    def keep(folder: OutFolder) -> None:
        from gearlash.cli.files import write_zones

        write_zones(folder, asked.case, found, answer)
        csv.keep(folder, ZONE_TABLES, tables)

    def tables() -> Tables:
        return zones_tables(asked.case, found, answer)

    return deliver(answer, as_json, folder, keep, csv.printing(tables))


def _found(
    asked: StudyInputs, kinds: Sequence[Kind], search: SearchSettings, workers: int | None
) -> tuple[Zones, ...]:
    """Sweeps in all three directions, and then the ends of the zones."""
    from gearlash.cli.interrupt import end_if_nothing
    from gearlash.cli.progress import progress_bar
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.studies import sweeps
    from gearlash.studies.zones import zones_of_kinds

    (axis,), start = asked.ranges(), asked.start
    with executor_for(asked.case, workers, 3 * len(axis)) as executor:
        with progress_bar("sweeps") as progress:
            execution = Execution(executor, progress=progress)
            ways = sweeps(asked.case, axis, start=start, settings=search, execution=execution)
        end_if_nothing(any(point.computed for each in ways for point in each.points))
        with progress_bar("ends") as progress:
            execution = Execution(executor, progress=progress)
            return zones_of_kinds(
                asked.case, axis, kinds, known=ways, start=start, settings=search, execution=execution
            )


def _kinds(kind: Kind | None, family: Family, name: str, values: Sequence[float]) -> list[Kind]:
    """The kinds to look for: where no back side acts, its impacts are no question. Raises `CaseError` where
    it is asked all the same."""
    from gearlash.case import CaseError, Problem
    from gearlash.system import GearlashError

    def acts(value: float) -> bool:
        try:
            gaps = family.system({name: value}).clearances
        except GearlashError:
            return False
        return any(gap.stops(-1) for gap in gaps)

    if any(acts(value) for value in values[:: max(1, len(values) // LOOKED_AT)]):
        return [kind] if kind else list(Kind)
    if kind is Kind.DRIVE_SIDE_ONLY:
        expected = "impact-free: no clearance of this system has a back side that acts"
        raise CaseError("--kind", [Problem("--kind", repr(str(kind)), expected)])
    return [Kind.IMPACT_FREE]
