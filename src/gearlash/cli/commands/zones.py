"""gearlash zones"""

from __future__ import annotations

from enum import StrEnum
from typing import TYPE_CHECKING, Annotated

import typer

from gearlash.cli.exits import ExitCode, code_of, command, delivery
from gearlash.cli.options import (
    AsJson,
    CaseArgument,
    Initial,
    MaxPeriod,
    Out,
    Over,
    Periods,
    Settings,
    Workers,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from gearlash.system import Family

LOOKED_AT = 400  # values at which a back side is looked for, about


class Kind(StrEnum):
    """Kinds of quiet motion."""

    IMPACT_FREE = "impact-free"
    DRIVE_SIDE_ONLY = "drive-side-only"


@command
def zones(
    case: CaseArgument,
    over: Over,
    kind: Annotated[
        Kind | None,
        typer.Option(
            metavar="KIND",
            help="impact-free: no impact at all; drive-side-only: none on the back side. [default: both, "
            "where there is a back side]",
        ),
    ] = None,
    settings: Settings = None,
    initial: Initial = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    workers: Workers = None,
    as_json: AsJson = False,
    out: Out = None,
) -> ExitCode:
    """Which intervals are free of impacts, or of impacts on the back side?

    Cold, up and down sweeps, then every end located: solved for where it is a grazing or fold, else halved.
    Between quiet points motion is followed in small steps. Says where the present value lies, where every
    attractor found is quiet, where at least one is, and what coexists. --out writes zones.json, the
    sweeps as zones.nc, and the zones over them as SVG and PDF.
    """
    from gearlash.cli.folder import claim_if
    from gearlash.cli.inputs import read_case, read_over, read_start
    from gearlash.cli.interrupt import end_if_nothing, expect_results
    from gearlash.cli.jsonio import write_stdout
    from gearlash.cli.notice import load_engine
    from gearlash.cli.slow import ends, tell_if_slow
    from gearlash.cli.terminal import show

    chosen = read_case(case, settings)
    along = read_over(chosen, over, settings)
    family, _ = chosen.family()
    named = read_start(family, family.complete(), initial) if initial else None
    start = None if named is None else list(named.values())
    kinds = _kinds(kind, family, along.short, along.values.tolist())
    folder = claim_if(out, ["zones.nc", "zones.json", "zones.svg", "zones.pdf"])
    load_engine(data=folder is not None)
    tell_if_slow(family, *ends(along))
    expect_results()

    from gearlash.cli.answers.zones import zones_answer
    from gearlash.cli.progress import progress_bar
    from gearlash.cli.settings import search_settings
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.results import Axis
    from gearlash.studies import sweeps
    from gearlash.studies.zones import zones_of_kinds

    axis, search = Axis(along.short, along.values), search_settings(family, periods, max_period, case)
    with executor_for(chosen, workers, 3 * len(axis)) as executor:
        with progress_bar("sweeps") as progress:
            execution = Execution(executor, progress=progress)
            ways = sweeps(chosen, axis, start=start, settings=search, execution=execution)
        end_if_nothing(any(point.computed for each in ways for point in each.points))
        with progress_bar("ends") as progress:
            found = zones_of_kinds(
                chosen,
                axis,
                kinds,
                known=ways,
                start=start,
                settings=search,
                execution=Execution(executor, progress=progress),
            )
    answer = zones_answer(chosen, family.complete(), along.named, along.unit, found, named)
    with delivery():
        try:
            if folder:
                from gearlash.cli.files import write_zones

                write_zones(folder, chosen, found, answer)
        finally:  # an answer that took long is shown even if it cannot be kept
            if as_json:
                write_stdout(answer)
            else:
                from gearlash.cli.show.zones import zones_view

                show(zones_view, answer)
    return code_of(answer.status)


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
