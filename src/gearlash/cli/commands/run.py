"""gearlash run"""

from __future__ import annotations

from typing import TYPE_CHECKING

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
    from gearlash.case import Case
    from gearlash.cli.answers.run import RunAnswer
    from gearlash.cli.folder import OutFolder
    from gearlash.cli.tables import Tables
    from gearlash.orbits import Attractor
    from gearlash.orbits import Settings as SearchSettings
    from gearlash.system import Family

TABLES = "history", "spectrum", "events"


@command
def run(
    case: CaseArgument,
    settings: Settings = None,
    initial: Initial = None,
    periods: Periods = None,
    max_period: MaxPeriod = None,
    as_json: AsJson = False,
    as_csv: AsCsv = False,
    decimal_comma: DecimalComma = False,
    out: Out = None,
) -> ExitCode:
    """How does this pair move here? One attractor, with a plain sentence first.

    The motion that the pair settles into: its signature P-Q-R (mesh cycles in a period, impacts on the drive
    side, impacts on the back side), multipliers, contact events, forces and displacement. --out writes
    run.json, and the phase portrait and history as SVG and PDF.
    """
    from gearlash.cli.folder import MOTION_FILES, claim_if
    from gearlash.cli.frame import deliver
    from gearlash.cli.inputs import read_case, read_start
    from gearlash.cli.interrupt import expect_results
    from gearlash.cli.slow import tell_if_slow
    from gearlash.cli.tables import CsvAsked

    csv = CsvAsked.read(as_csv, decimal_comma, as_json, out)
    chosen = read_case(case, settings)
    family, _ = chosen.family()
    parameters = family.complete()
    start = read_start(family, parameters, initial)
    folder = claim_if(out, ["run.json", *MOTION_FILES, *csv.files(*TABLES)])

    from gearlash.cli.notice import load_engine

    load_engine()
    tell_if_slow(family, parameters)

    from gearlash.cli.settings import search_settings
    from gearlash.orbits import attractor

    search = search_settings(family, periods, max_period, case)
    found = attractor(family.system(parameters), list(start.values()), search)
    expect_results()
    answer = _answer(chosen, family, parameters, start, found, search)

    def keep(folder: OutFolder) -> None:
        from gearlash.cli.files import write_motion

        write_motion(folder, chosen, found, answer)
        csv.keep(folder, TABLES, tables)

    def tables() -> Tables:
        from gearlash.cli.command_tables import run_tables

        return run_tables(chosen, parameters, found, answer)

    return deliver(answer, as_json, folder, keep, csv.printing(tables))


def _answer(
    case: Case,
    family: Family,
    parameters: dict[str, float],
    start: dict[str, float],
    found: Attractor,
    search: SearchSettings,
) -> RunAnswer:
    """What is to be said of a motion, as far as a signal leaves time to look."""
    from gearlash.cli.answers.excitation import unexcited
    from gearlash.cli.answers.run import numbers_of, run_answer
    from gearlash.cli.interrupt import optional, signalled
    from gearlash.cli.late import late_bar
    from gearlash.studies.beside import motions_beside
    from gearlash.studies.impact_free import impact_free_speeds

    def other_starts():
        with late_bar("other starts") as tell:
            return motions_beside(found, start, family.start(parameters), settings=search, tell=tell)

    def quiet_speeds():
        with late_bar("speeds free of impacts") as tell:
            return impact_free_speeds(case, parameters, tell=tell)

    asked = unexcited(case, found) is None
    speeds_asked = asked and case.between_teeth
    numbers = optional(lambda: numbers_of(found, case, parameters))
    beside = optional(other_starts) if asked else None
    quiet = optional(quiet_speeds) if speeds_asked else None
    looked = (
        ("its numbers", True, numbers),
        ("other starts", asked, beside),
        ("speeds free of impacts", speeds_asked, quiet),
    )
    left_out = [what for what, wanted, got in looked if wanted and got is None and signalled()]
    return run_answer(case, parameters, start, found, numbers, quiet, beside, left_out)
