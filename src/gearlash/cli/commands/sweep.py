"""gearlash sweep"""

from __future__ import annotations

from typing import Annotated

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


@command
def sweep(
    case: CaseArgument,
    over: Over,
    cold: Annotated[
        bool, typer.Option("--cold", help="Every point from the cold start, or from the state of --initial.")
    ] = False,
    up: Annotated[bool, typer.Option("--up", help="Follows the attractor with rising values.")] = False,
    down: Annotated[bool, typer.Option("--down", help="Follows the attractor with falling values.")] = False,
    settings: Settings = None,
    initial: Initial = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    workers: Workers = None,
    as_json: AsJson = False,
    out: Out = None,
) -> ExitCode:
    """How does the motion change with one parameter?

    One attractor per value; without --cold, --up or --down all three, as where they differ attractors
    coexist. --out writes sweep.nc (everything, NetCDF), sweep.json, and the bifurcation diagram as SVG and
    PDF. Ctrl-C keeps what was computed, marked incomplete.
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
    start = read_start(family, family.complete(), initial) if initial else None
    ways = [name for name, wanted in (("cold", cold), ("up", up), ("down", down)) if wanted] or [
        "cold",
        "up",
        "down",
    ]
    folder = claim_if(out, ["sweep.nc", "sweep.json", "sweep.svg", "sweep.pdf"])
    load_engine(data=folder is not None)
    tell_if_slow(family, *ends(along))
    expect_results()

    from gearlash.cli.answers.sweep import sweep_answer
    from gearlash.cli.progress import progress_bar
    from gearlash.cli.settings import search_settings
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.results import Axis
    from gearlash.studies import sweeps

    axis = Axis(along.short, along.values)
    with executor_for(chosen, workers, len(axis) * len(ways)) as executor, progress_bar("sweep") as progress:
        found = sweeps(
            chosen,
            axis,
            ways,
            start=None if start is None else list(start.values()),
            settings=search_settings(family, periods, max_period, case),
            execution=Execution(executor, progress=progress),
        )
    end_if_nothing(any(point.computed for each in found for point in each.points))
    answer = sweep_answer(chosen, family.complete(), along.named, found, along.unit, start)
    with delivery():
        try:
            if folder:
                from gearlash.cli.files import write_sweep

                write_sweep(folder, chosen, found, answer)
        finally:  # an answer that took long is shown even if it cannot be kept
            if as_json:
                write_stdout(answer)
            else:
                from gearlash.cli.show.sweep import sweep_view

                show(sweep_view, answer)
    return code_of(answer.status)
