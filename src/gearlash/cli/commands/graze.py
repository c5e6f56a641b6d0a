"""gearlash graze"""

from __future__ import annotations

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
    from collections.abc import Mapping

    from gearlash.branches.continuation import SpecialPoint
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.tables import Tables
    from gearlash.orbits import Settings as SearchSettings
    from gearlash.results import Point
    from gearlash.results.followed import FollowedPath
    from gearlash.system import Family


@command
def graze(
    case: CaseArgument,
    over: Annotated[
        str,
        typer.Option(metavar="NAME", help="Parameter to solve for: omega, D, load, pinion_speed, backlash …"),
    ] = "omega",
    settings: Settings = None,
    near: Annotated[
        str | None,
        typer.Option(
            metavar="VALUE", help="Value of that parameter to start from, as it would stand in the case."
        ),
    ] = None,
    initial: Initial = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """At which value does the motion just touch a boundary of the gap, and what kind of point is that?

    The periodic motion at the given parameters is followed down and up, through doublings, until a contact is
    born or dies; the touch is solved for together with the orbit. Motions that coexist with it are not
    looked at. Prints value, kind, labels on both sides, multipliers and the article's four conditions. Ctrl-C
    keeps what was found, marked incomplete.
    """
    from gearlash.cli.folder import claim_if
    from gearlash.cli.frame import deliver
    from gearlash.cli.inputs import named_near, read_case, read_near, read_start
    from gearlash.cli.jsonio import write_file
    from gearlash.cli.notice import load_engine
    from gearlash.cli.slow import tell_if_slow
    from gearlash.cli.tables import CsvAsked, table_of

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    chosen = read_case(case, settings, [over])
    short, changed = read_near(chosen, over, near, settings)
    named, unit = named_near(chosen, over, near)
    family, _ = chosen.family()
    parameters = family.complete(changed)
    start = read_start(family, parameters, initial)
    folder = claim_if(out, ["graze.json", *csv.files("graze")])
    load_engine()
    tell_if_slow(family, parameters)

    from gearlash.cli.answers.graze import TouchFound, graze_answer
    from gearlash.cli.asked_columns import told_as_asked
    from gearlash.cli.settings import search_settings

    search = search_settings(family, periods, max_period, case)
    first, walks = _followed(family, parameters, short, list(start.values()), search)
    found = [touch for _, touch in walks if touch is not None]
    answer = graze_answer(
        chosen, family, parameters, short, named, unit, first, tuple(path for path, _ in walks), found
    )

    def keep(folder: OutFolder) -> None:
        write_file(answer, folder.file("graze.json"))
        csv.keep(folder, ["graze"], tables)

    def tables() -> Tables:
        return {"graze": told_as_asked(table_of(answer.points, TouchFound), answer.asked, ("value",))}

    code = deliver(answer, as_json, folder, keep, csv.printing(tables))
    return ExitCode.OK if answer.points else code


def _followed(
    family: Family, parameters: Mapping[str, float], over: str, start: list[float], search: SearchSettings
) -> tuple[Point, list[tuple[FollowedPath, SpecialPoint | None]]]:
    """The motion to begin with, and, of a periodic one, the ways down and up with the touches they end at."""
    from gearlash.cli.interrupt import expect_results
    from gearlash.cli.late import late_bar
    from gearlash.studies import first_grazing, point

    first = point(family, parameters, name=over, start=start, settings=search)
    expect_results()
    if not first.periodic:
        return first, []
    others = {each: value for each, value in parameters.items() if each != over}
    with late_bar("following the motion", steady=False) as tell:
        return first, [
            first_grazing(family, over, first, way, values=others, settings=search, tell=tell)
            for way in ("down", "up")
        ]
