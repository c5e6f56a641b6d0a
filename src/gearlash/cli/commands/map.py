"""gearlash map"""

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
    Periods,
    Settings,
    Workers,
)


@command
def map(
    case: CaseArgument,
    over: Annotated[
        list[str],
        typer.Option(
            metavar="NAME=FROM:TO:COUNT",
            help="Parameter of an axis, by short name or path: omega=0.5:1.4:200, backlash=20um:120um:200. "
            "To be given twice: first for the horizontal axis, then for the vertical one.",
        ),
    ],
    settings: Settings = None,
    initial: Initial = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    workers: Workers = None,
    as_json: AsJson = False,
    out: Out = None,
) -> ExitCode:
    """Which motion belongs to which pair of values of two parameters?

    One attractor per pixel of the plane of two parameters, each from the cold start, or from the state of
    --initial. --out writes map.nc
    (everything, NetCDF), map.json, and the map as SVG and PDF. Ctrl-C keeps what was computed, marked
    incomplete.
    """
    from gearlash.cli.folder import claim_if
    from gearlash.cli.inputs import read_case, read_plane, read_start
    from gearlash.cli.interrupt import end_if_nothing, expect_results
    from gearlash.cli.jsonio import write_stdout
    from gearlash.cli.notice import load_engine
    from gearlash.cli.slow import ends, tell_if_slow
    from gearlash.cli.terminal import show

    chosen = read_case(case, settings)
    across, up = read_plane(chosen, over, settings)
    family, _ = chosen.family()
    start = read_start(family, family.complete(), initial) if initial else None
    folder = claim_if(out, ["map.nc", "map.json", "map.svg", "map.pdf"])
    load_engine(data=folder is not None)
    tell_if_slow(family, *ends(across, up))
    expect_results()

    from gearlash.cli.answers.map import map_answer
    from gearlash.cli.progress import progress_bar
    from gearlash.cli.settings import search_settings
    from gearlash.cli.workers import executor_for
    from gearlash.jobs import Execution
    from gearlash.results import Axis
    from gearlash.studies import map_plane
    from gearlash.system import Status

    x, y = (Axis(over.short, over.values) for over in (across, up))
    with executor_for(chosen, workers, len(x) * len(y)) as executor, progress_bar("map") as progress:
        found = map_plane(
            chosen,
            x,
            y,
            start=None if start is None else list(start.values()),
            settings=search_settings(family, periods, max_period, case),
            execution=Execution(executor, progress=progress),
        )
    end_if_nothing(set(found.statuses) != {Status.NOT_COMPUTED})
    named, units = (across.named, up.named), (across.unit, up.unit)
    answer = map_answer(chosen, family.complete(), named, found, units, start)
    with delivery():
        try:
            if folder:
                from gearlash.cli.files import write_map

                write_map(folder, chosen, found, answer)
        finally:  # an answer that took long is shown even if it cannot be kept
            if as_json:
                write_stdout(answer)
            else:
                from gearlash.cli.show.map import map_view

                show(map_view, answer)
    return code_of(answer.status)
