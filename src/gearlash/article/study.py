"""The article's whole study, from a case to data."""

from __future__ import annotations

import os
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, field
from functools import partial

from gearlash.case import Case
from gearlash.flow import propagators
from gearlash.jobs import Progress
from gearlash.orbits import orbit_at
from gearlash.results import Axis, Direction, Point, Sweep, provenance, sweep_dataset
from gearlash.studies.model import open_workers
from gearlash.studies.motion import Motion, motion
from gearlash.studies.point import point
from gearlash.studies.transition import Transition
from gearlash.system import Family, GearlashError, Label, MotionKind, given

from . import plane
from .bearing import bearing_modes
from .branching import Following
from .centre import centres
from .claims import Claim, load
from .events import EventSearch
from .opening import Beside, coincidences
from .pair import check_pair
from .reproduction import (
    BearingMode,
    Check,
    Diagram,
    DiagramMark,
    Event,
    ReportedZone,
    Reproduction,
    Run,
    Scan,
)
from .rows import STUDY_SETTINGS, Found, Row, distinct, rows
from .rules import effects
from .table2 import fill
from .verdicts import Evidence, judge
from .zoning import SOME, article_zones

STAGES = ("sweeps over ω", "sweeps over D", "zones", "events", "verdicts", "contact rules", "branches")
StageProgress = Callable[[str, Progress | None], object]
Keep = Callable[[str, Sequence[Sweep]], None]


@dataclass(frozen=True)
class Scope:
    """How far and how finely the study looks.

    Parameters
    ----------
    omega, backlash : (float, float, int)
        Lower end, upper end and number of points of the sweeps over ω and over D, both dimensionless.
    fixed_backlash : float
        D of everything but the sweep over D.
    fixed_omega : float
        ω of the sweep over D.
    rules_backlash : tuple of float
        Values of D at which the contact rules are compared, followed down.

    Examples
    --------
    >>> from gearlash.article import Scope
    >>> Scope(omega=(0.9, 1.2, 31)).backlash
    (0.1, 1.0, 361)
    """

    omega: tuple[float, float, int] = (0.5, 1.4, 451)
    backlash: tuple[float, float, int] = (0.1, 1.0, 361)
    fixed_backlash: float = 1.0
    fixed_omega: float = 0.78
    rules_backlash: tuple[float, ...] = (
        *(round(0.34 + 0.01 * i, 2) for i in range(17)),
        0.6,
        0.7,
        0.8,
        0.9,
        1.0,
    )


@dataclass
class _Clock:
    """Seconds per stage."""

    began: float = field(default_factory=time.perf_counter)
    seconds: dict[str, float] = field(default_factory=dict)

    def lap(self, stage: str) -> None:
        self.seconds[stage] = time.perf_counter() - self.began - sum(self.seconds.values())


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
    tell = progress or (lambda stage, state: None)
    clock = _Clock()
    with open_workers(case, workers) as executor:
        omega, frequency = _axis_rows(case, "omega", scope, executor, tell, clock, keep)
        gap, backlash = _axis_rows(case, "D", scope, executor, tell, clock, keep)
        found = {"omega": distinct(frequency), "D": distinct(backlash)}
        at = {"omega": scope.fixed_omega, "D": scope.fixed_backlash}
        followed = (
            Following.begun(case, "omega", {"D": at["D"]}, frequency, executor),
            Following.begun(case, "D", {"omega": at["omega"]}, backlash, executor),
        )
        in_plane = plane.begun(case, scope.omega[:2], {"D": scope.fixed_backlash}, executor)
        by_axis = {"omega": (omega, frequency), "D": (gap, backlash)}
        tell(STAGES[2], None)
        zones = tuple(
            article_zones(
                case, claim, *by_axis[claim.parameter], executor, lambda state: tell(STAGES[2], state)
            )
            for claim in claims
            if claim.kind == "zone"
        )
        clock.lap(STAGES[2])
        tell(STAGES[5], None)
        compared = effects(case, scope.rules_backlash, at, executor)
        clock.lap(STAGES[5])
        tell(STAGES[6], None)
        scans = {each.name: each.scan(found[each.name], executor) for each in followed}
        beside = {name: coincidences(case, scan, executor) for name, scan in scans.items()}
        points = tuple(
            point
            for name, scan in scans.items()
            for point in centres(case, claims, scan, beside[name], executor)
        )
        window_plane = in_plane.result()
        clock.lap(STAGES[6])
    tell(STAGES[3], None)
    family, _ = case.family()
    values = family.complete()
    events = tuple(
        _search(family, {**values, **claim.fixed}, scans[claim.parameter], beside[claim.parameter]).event(
            claim
        )
        for claim in claims
        if claim.portrait
    )
    window = _window(case, frequency, zones, {**values, "D": scope.fixed_backlash})
    clock.lap(STAGES[3])
    tell(STAGES[4], None)
    evidence = Evidence(
        case,
        events,
        zones,
        {"omega": frequency, "D": backlash},
        {name: scan.events for name, scan in scans.items()},
        _motions(case, claims, {"omega": frequency, "D": backlash}),
    )
    judged = judge(claims, evidence)
    table = fill(tuple(scans.values()), events, points)
    clock.lap(STAGES[4])
    all_rows = (*frequency, *backlash)
    return Reproduction(
        case=case,
        frequency=_diagram(case, "omega", {"D": scope.fixed_backlash}, frequency, found["omega"], events),
        backlash=_diagram(case, "D", {"omega": scope.fixed_omega}, backlash, found["D"], events),
        events=events,
        zones=zones,
        window=window,
        table2=table,
        claims=judged,
        checks=_checks(case, all_rows, found),
        run=_run(case, clock, workers, all_rows),
        rules=compared,
        bearings=_bearings(case, frequency, zones, {"D": scope.fixed_backlash}),
        coincidences=tuple(both for pairs in beside.values() for both, _ in pairs),
        scans=tuple(scans.values()),
        centres=points,
        window_plane=window_plane,
    )


def _search(family: Family, values: dict[str, float], scan: Scan, beside: Sequence[Beside]) -> EventSearch:
    return EventSearch(family, values, scan.events, beside, scan.branches)


def _axis_rows(
    case: Case,
    name: str,
    scope: Scope,
    executor: Executor,
    tell: StageProgress,
    clock: _Clock,
    keep: Keep | None,
) -> tuple[Axis, tuple[Row, ...]]:
    omega = name == "omega"
    low, high, count = scope.omega if omega else scope.backlash
    fixed = {"D": scope.fixed_backlash} if omega else {"omega": scope.fixed_omega}
    stage = STAGES[0] if omega else STAGES[1]
    axis = Axis.even(name, low, high, count)
    tell(stage, None)
    kept = None if keep is None else partial(keep, name)
    done = rows(case, axis, fixed, executor, lambda state: tell(stage, state), kept)
    clock.lap(stage)
    return axis, done


def _diagram(
    case: Case,
    name: str,
    fixed: Mapping[str, float],
    done: Sequence[Row],
    found: Sequence[Found],
    events: Sequence[Event],
) -> Diagram:
    special = {event.value for event in events if event.found}
    marks = tuple(_mark(t, directions, t.value in special) for t, directions in found)
    return Diagram(name, dict(fixed), sweep_dataset(case, [row.sweep for row in done]), marks)


def _mark(transition: Transition, directions: Sequence[Direction], article: bool) -> DiagramMark:
    point = transition.point
    boundary = point.touch.boundary if point is not None and point.is_grazing else 0
    where = "all" if len(directions) == 3 else ",".join(str(d) for d in directions)
    return DiagramMark(
        transition.value,
        transition.kind,
        boundary,
        transition.label_below,
        transition.label_above,
        where,
        article,
    )


def _window(
    case: Case, done: Sequence[Row], zones: Sequence[ReportedZone], values: Mapping[str, float]
) -> tuple[Motion, ...]:
    """Every motion found at one ω of the impact-free zone: where most of them coexist, else in its middle."""
    wide = next((z.reading(SOME) for z in zones if z.kind == "impact-free"), None)
    if wide is None or not wide.found:
        return ()
    inside = [i for i, p in enumerate(done[0].sweep.points) if wide.lower.value < p.value < wide.upper.value]
    if not inside:
        return ()

    def labels(i: int) -> set[Label | None]:
        return {row.sweep.points[i].label for row in done}

    most = max(len(labels(i)) for i in inside)
    crowded = [i for i in inside if len(labels(i)) == most]
    chosen = crowded[len(crowded) // 2]
    family, _ = case.family()
    seen, motions = set(), []
    for row in done:
        sampled = row.sweep.points[chosen]
        if sampled.label in seen or not sampled.periodic:
            continue
        seen.add(sampled.label)
        props = propagators(family.system({**values, "omega": sampled.value}))
        orbit = orbit_at(props, sampled.state, sampled.period // props.system.cycles)
        if orbit is None:  # a point of the sweep was proved to be one
            raise GearlashError(f"no orbit closes at omega = {sampled.value:.10g}, {sampled.label}")
        motions.append(motion(orbit, value=sampled.value))
    return tuple(motions)


def _bearings(
    case: Case, done: Sequence[Row], zones: Sequence[ReportedZone], fixed: Mapping[str, float]
) -> tuple[BearingMode, ...]:
    """Bearings in resonance inside the impact-free window, with the motion there."""
    wide = next((z.reading(SOME) for z in zones if z.kind == "impact-free"), None)
    quiet = next((p for row in done for p in row.sweep.points if p.impact_free), None)
    return () if wide is None or quiet is None else bearing_modes(case, wide, quiet.state, fixed)


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


def _checks(case: Case, done: Sequence[Row], found: Mapping[str, Sequence[Found]]) -> tuple[Check, ...]:
    """Bounds that this run can measure on itself."""
    points = [p for row in done for p in row.sweep.points if p.periodic]
    worst = max((p.residual for p in points), default=float("nan"))
    solved = [t for pairs in found.values() for t, _ in pairs]
    graze = max((t.point.residual for t in solved if t.point is not None), default=float("nan"))
    error = max((t.point.error / abs(t.value) for t in solved if t.point is not None), default=float("nan"))
    leading = max((abs(p.leading) for p in points), default=float("nan"))
    unresolved = sum(p.label is MotionKind.UNRESOLVED for row in done for p in row.sweep.points)
    total = sum(len(row.sweep.points) for row in done)
    return (
        Check(
            f"largest residual of {len(points)} periodic orbits", f"{worst:.1e}", "≤ 1e-11", worst <= 1e-11
        ),
        Check(
            "largest |multiplier| of an orbit reported as attractor", f"{leading:.6f}", "< 1", leading < 1.0
        ),
        Check(f"largest residual of {len(solved)} located points", f"{graze:.1e}", "≤ 1e-10", graze <= 1e-10),
        Check(
            "largest relative error estimate of a located value", f"{error:.1e}", "≤ 1e-10", error <= 1e-10
        ),
        Check(
            "points neither proved periodic nor shown aperiodic", f"{unresolved} of {total}", "reported", None
        ),
    )


def _run(case: Case, clock: _Clock, workers: int | None, done: Sequence[Row]) -> Run:
    statuses = Counter(p.status for row in done for p in row.sweep.points)
    cores = os.cpu_count() or 1
    seconds = {**clock.seconds, "total": sum(clock.seconds.values())}
    about = provenance(case)
    versions = {name: text for name, text in about.items() if "version" in name}
    certificates = Counter(p.certificate for row in done for p in row.sweep.points if p.certificate)
    complete = all(row.sweep.complete for row in done)
    return Run(seconds, workers or cores, cores, versions, dict(statuses), complete, dict(certificates))
