"""The report of a pair in one call: the same steps for the command and from Python."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from gearlash.case import Case
from gearlash.jobs import Execution, Progress
from gearlash.orbits import Settings
from gearlash.results import Axis
from gearlash.results.pair_question import check_pair, speeds_around
from gearlash.studies.assessment import Assessment, Tell, assess, speed_axis
from gearlash.studies.bands import Band
from gearlash.studies.grids import Grids
from gearlash.studies.speed_run import histories, speed_run
from gearlash.studies.zone_end import Interval
from gearlash.system import Record, given

from .contents import Contents
from .planes import STAGES, plane_over
from .rendering import render
from .verdict import verdict

POINTS = 201
"""Speeds at which quantities are measured."""


@dataclass(frozen=True, eq=False, repr=False)
class PairReport(Record):
    """What a report says of a pair at its speed and torque.

    Parameters
    ----------
    verdict : {"good", "doubt", "bad"}
        No impacts were found at this speed, nor across the ranges of estimates and stated limits; in some
        motions, or somewhere in those ranges, or nothing settled; in all.
    sentence : str
        The first line of the report.
    lines : tuple of (str, str)
        Its other lines: title and text.
    separating, beside : tuple of Interval
        Bands of speed ω in which teeth separate: in every motion found, and in one but not in another.
    not_told : tuple of Interval
        Parts of which no motion tells whether teeth separate.
    back_side : tuple of Interval
        Bands in which the back side is met.
    page : Path or None
        The page that was written.
    missing : tuple of str
        What was not computed, as the report was stopped.

    Examples
    --------
    >>> from gearlash import PairReport
    >>> PairReport("good", "No impacts were found.", (), (), (), (), (), None, ()).verdict
    'good'
    """

    verdict: str
    sentence: str
    lines: tuple[tuple[str, str], ...]
    separating: tuple[Interval, ...]
    beside: tuple[Interval, ...]
    not_told: tuple[Interval, ...]
    back_side: tuple[Interval, ...]
    page: Path | None
    missing: tuple[str, ...]


def pair_report(
    case: Case,
    folder: Path | str | None = None,
    *,
    speeds: Axis | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> PairReport:
    """May a gear pair run at its speed and torque? The verdict of `gearlash report`, and its page.

    Parameters
    ----------
    case : Case
        A gear pair under load.
    folder : path, optional
        Where the page goes, with its figures and numbers; made if it is not there. A report in it is
        written over, and no file of it stays. Without one there is the verdict alone, within seconds.
    speeds : Axis, optional
        Speeds to examine, as ω or by another name of the speed (``pinion_speed``, with its unit); else the
        range of the case, or from half its speed to half more. Curves over speed go over all of them, the
        verdict and the maps over as many as they can afford at equal distances between both ends.
    settings : Settings, optional
        How attractors are looked for.
    execution : Execution, optional
        Who does the work, who hears how far it is, and who may stop it.

    Returns
    -------
    PairReport

    Raises
    ------
    GearlashError
        For a case that is no gear pair under load, and speeds of another parameter.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh", {"omega": 0.55})
    >>> found = gl.pair_report(case, speeds=gl.Axis.even("omega", 0.5, 0.6, 5))
    >>> found.verdict, found.separating
    ('good', ())
    """
    check_pair(given.instance("case", case, Case, "a case, as from gearlash.load_case"))
    place = None if folder is None else given.path("folder", folder)
    if speeds is not None:
        speeds = speed_axis(case, given.instance("speeds", speeds, Axis, "an Axis of pinion_speed or omega"))
    if settings is not None:
        given.instance("settings", settings, Settings, "gearlash.Settings")
    if execution is not None:
        given.instance("execution", execution, Execution, "gearlash.Execution")
    how, search = execution or Execution(), settings or Settings()

    def tell(_stage: str, progress: Progress | None) -> None:
        if how.progress is not None and progress is not None:
            how.progress(progress)

    def stopped() -> bool:
        return how.cancel is not None and how.cancel.is_set()

    axis = speeds_around(case, POINTS) if speeds is None else speeds
    found = assessed(case, axis, search, how, tell)
    if place is None:
        return _report(
            found, None, () if found.complete else ("part of the bands of speed and of the ranges",)
        )
    contents = measured(found, axis, search, how, tell, stopped, usual=speeds is None)
    page = render(contents, place, None if contents.missing else how.executor)
    return _report(found, page, contents.missing)


def assessed(case: Case, axis: Axis, search: Settings, execution: Execution, tell: Tell) -> Assessment:
    """The verdict's numbers, from as many of the speeds as are affordable."""
    low, high = float(axis.values[0]), float(axis.values[-1])
    coarse = Axis.even(axis.name, low, high, min(Grids.of_case(case).speeds, len(axis)))
    return assess(case, coarse, settings=search, execution=execution, tell=tell)


def measured(
    found: Assessment,
    axis: Axis,
    search: Settings,
    execution: Execution,
    tell: Tell,
    stopped: Callable[[], bool],
    *,
    usual: bool,
) -> Contents:
    """All else, as far as nobody stops it; ``usual``: nobody said at how many speeds."""
    run, missing, maps = None, [], {}
    if usual:
        axis = Grids.of(found.attractor.propagators).fewer(axis)
    if not stopped() and found.searched:
        run = speed_run(found.case, axis, settings=search, execution=execution, tell=tell)
    if run is None or not run.complete:
        missing.append("curves over speed" if run is None else "part of the curves over speed")
    for name in (each for each in STAGES if found.values[each] != 0.0):  # of zero there are no multiples
        if not stopped() and not missing:
            done = plane_over(found, name, search, execution, tell)
            if done is not None:
                maps[name] = done
        if name not in maps:
            missing.append(f"the {STAGES[name]}")
    return Contents(found, run, histories(found, run), maps, tuple(missing))


def _report(found: Assessment, page: Path | None, missing: tuple[str, ...]) -> PairReport:
    said = verdict(found)
    first, *rest = said.lines
    return PairReport(
        said.kind,
        first.text,
        tuple((line.title, line.text) for line in rest),
        _intervals(band for band in found.separating if band.every),
        _intervals(band for band in found.separating if not band.every),
        found.not_told,
        _intervals(found.back_side),
        page,
        missing,
    )


def _intervals(bands: Iterable[Band]) -> tuple[Interval, ...]:
    return tuple(Interval(band.lower, band.upper) for band in bands)
