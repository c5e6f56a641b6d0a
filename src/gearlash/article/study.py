"""The article's whole study, from a case to data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearlash.case import Case
from gearlash.results import Direction, Point
from gearlash.studies.model import open_workers
from gearlash.studies.point import point
from gearlash.system import given

from . import diagrams, self_checks, stages, window
from .claims import Claim, load
from .computed import Computed, Keep, compute
from .events import EventSearch
from .pair import check_pair
from .reproduction import Diagram, Event, Reproduction
from .rows import STUDY_SETTINGS, Row
from .scope import Scope
from .stages import StageProgress, Stages
from .table2 import fill
from .verdicts import Evidence, judge


def reproduce(
    case: Case,
    scope: Scope | None = None,
    *,
    workers: int | None = None,
    claims: Sequence[Claim] | None = None,
    progress: StageProgress | None = None,
    keep: Keep | None = None,
) -> Reproduction:
    """The article's whole study but its multibody section, and a verdict for every claim.

    Parameters
    ----------
    case : Case
        The article's pair, or a variation of it: ``gearlash.load_case("article")``.
    scope : Scope, optional
        How far and how finely to look; the default takes minutes.
    workers : int, optional
        Processes; 0 for this one, as many as there are cores where nothing is given.
    claims : sequence of Claim, optional
        Those of the package where nothing is given. They say what is compared and around which values
        pictures are centred; no computation reads a claimed value.
    progress : callable, optional
        Called with the name of a stage (one of `STAGES`) and how far it is (`Progress`, or None).
    keep : callable, optional
        Called with the name of an axis and its sweeps as soon as they are there, also where they were ended
        early.

    Returns
    -------
    Reproduction

    Raises
    ------
    CaseError
        For a case that is not the article's pair.
    UnfinishedError
        Where workers died. Ctrl-C raises `KeyboardInterrupt`.

    Examples
    --------
    Four points, and no claims to judge; without arguments it is the whole study.

    >>> import gearlash as gl
    >>> from gearlash.article import Scope
    >>> scope = Scope((1.0, 1.01, 2), (0.98, 1.0, 2), rules_backlash=(1.0,))
    >>> done = gl.reproduce(gl.load_case("article"), scope, workers=0, claims=())
    >>> done.frequency.dataset["label"].sel(direction="cold").values.tolist()
    ['1-0-0', '1-0-0']
    """
    check_pair(given.instance("case", case, Case, "a case, as from gearlash.load_case"))
    scope, claims = scope or Scope(), load() if claims is None else tuple(claims)
    steps = Stages(progress)
    with open_workers(case, workers) as executor:
        computed = compute(case, scope, claims, executor, steps, keep)
    with steps.stage(stages.EVENTS):
        events = _events(case, claims, computed)
        speeds, quiet = computed.rows["omega"], scope.beside("omega")
        motions = window.motions_inside(case, speeds, computed.zones, quiet)
    with steps.stage(stages.VERDICTS):
        judged = judge(claims, _evidence(case, claims, computed, events))
        table = fill(tuple(computed.scans.values()), events, computed.centres)
    every_row = [row for rows in computed.rows.values() for row in rows]
    return Reproduction(
        case=case,
        frequency=_diagram(case, "omega", scope, computed, events),
        backlash=_diagram(case, "D", scope, computed, events),
        events=events,
        zones=computed.zones,
        window=motions,
        table2=table,
        claims=judged,
        checks=self_checks.checks(every_row, computed.found),
        run=self_checks.how_it_ran(case, steps.seconds, workers, every_row),
        rules=computed.rules,
        bearings=window.bearings_inside(case, speeds, computed.zones, quiet),
        coincidences=tuple(both for pairs in computed.beside.values() for both, _ in pairs),
        scans=tuple(computed.scans.values()),
        centres=computed.centres,
        window_plane=computed.window_plane,
    )


def _events(case: Case, claims: Sequence[Claim], computed: Computed) -> tuple[Event, ...]:
    """Those of which the article shows portraits."""
    family, _ = case.family()
    values = family.complete()
    found = []
    for claim in claims:
        if claim.portrait:
            scan, beside = computed.scans[claim.parameter], computed.beside[claim.parameter]
            search = EventSearch(family, {**values, **claim.fixed}, scan.events, beside, scan.branches)
            found.append(search.event(claim))
    return tuple(found)


def _evidence(case: Case, claims: Sequence[Claim], computed: Computed, events: tuple[Event, ...]) -> Evidence:
    met = {name: scan.events for name, scan in computed.scans.items()}
    motions = _motions(case, claims, computed.rows)
    return Evidence(case, events, computed.zones, computed.rows, met, motions)


def _diagram(case: Case, name: str, scope: Scope, computed: Computed, events: Sequence[Event]) -> Diagram:
    rows, found = computed.rows[name], computed.found[name]
    return diagrams.diagram(case, name, scope.beside(name), rows, found, events)


def _motions(
    case: Case, claims: Sequence[Claim], done: Mapping[str, Sequence[Row]]
) -> dict[str, list[tuple[str, Point]]]:
    """For claims about one place: the motion from the cold start there, and the followed ones at the nearest
    points."""
    family, _ = case.family()
    found = {}
    for claim in claims:
        if claim.kind != "label" or claim.at is None:
            continue
        cold = point(family, {**claim.fixed, claim.parameter: claim.at}, settings=STUDY_SETTINGS)
        place, near = claim.at, [("cold start", cold)]
        for row in done[claim.parameter]:
            if row.direction is not Direction.COLD:
                near.append(
                    (f"{row.direction} sweep", min(row.sweep.points, key=lambda p: abs(p.value - place)))
                )
        found[claim.id] = near
    return found
