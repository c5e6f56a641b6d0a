"""`gearlash zones`: intervals of a parameter with quiet motion."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import isfinite
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case
from gearlash.results.zone_words import event
from gearlash.system import Signature, Status, label_text

from .asked import Asked
from .excitation import idle_study
from .outcome import POINTS, study_status, troubles
from .parts import CaseUsed, case_used, physical_values
from .sweep import START, AxisUsed, axis_used, first_failure
from .zones_parts import Assured, EndPoint, MarginFound, Resident, Stay, ZoneEnd, ZoneFound
from .zones_words import Done, headline, until_stop

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.studies.zone import Zone, ZoneMotion, Zones
    from gearlash.studies.zone_end import Interval, Margin
    from gearlash.studies.zone_end import ZoneEnd as FoundEnd


RANGE_END = "end of the range"


@dataclass(frozen=True)
class ZonesAnswer:
    """Intervals with quiet motion (gearlash zones)."""

    sentence: Annotated[str, "where the present value lies first, then the other zones"]
    status: Annotated[str, POINTS]
    message: str
    case: CaseUsed
    parameters: Annotated[
        dict[str, float], "every parameter by short name, with the case's own value of the varied one"
    ]
    present: Annotated[float, "the case's own value of the varied parameter"]
    axis: AxisUsed
    asked: Annotated[Asked, "the unit that the sentence and the table tell values in"]
    start: Annotated[dict[str, float] | None, START]
    statuses: Annotated[dict[Status, int], "number of points of the three sweeps by status"]
    resolution: Annotated[
        float,
        "step of the axis: other motions that live between two of its values only may have been missed, "
        "where no branch of another one leads to them",
    ]
    step: Annotated[
        float, "widest step between neighbouring orbits of the branches inside the zones of every motion"
    ]
    starts: Annotated[int, "starts from which motions were looked for; what none leads to may exist"]
    branches: Annotated[int, "branches that were followed"]
    not_followed: Annotated[
        int,
        "periodic motions of these starts whose branches were not followed, as the work was stopped; then no "
        "zone of every attractor is told",
    ]
    zones: Annotated[
        tuple[ZoneFound, ...], "where every attractor found is quiet, then where at least one is"
    ]
    result: Literal["zones"] = "zones"


def zones_answer(
    case: Case,
    parameters: Mapping[str, float],
    named: str,
    unit: str,
    found: Sequence[Zones],
    start: Mapping[str, float] | None = None,
) -> ZonesAnswer:
    """The record of zones of one or both kinds, from the same sweeps; ``named`` is the parameter as typed,
    ``unit`` what it was typed in, ``start`` the state that was given to start from, by name."""
    axis, here = found[0].axis, parameters[found[0].axis.name]
    asked = Asked.of(case, axis.name, named, unit)
    listed = tuple(_zone(case, z, here, asked) for zones in found for z in (*zones.zones, *zones.wider))
    message = "; ".join(dict.fromkeys(zones.message for zones in found if zones.message))
    statuses = dict(Counter(point.status for sweep in found[0].sweeps for point in sweep.points))
    ends = float(axis.values[0]), float(axis.values[-1])
    idle = idle_study(case, parameters, [axis])
    complete = all(zones.complete for zones in found)
    first = (
        headline(asked, ends, here, listed, [zones.quiet.value for zones in found])
        if complete
        else until_stop(asked, here, listed, done(found[0]))
    )
    said = (first, troubles(statuses, first_failure(asked, found[0].sweeps)))
    return ZonesAnswer(
        sentence="; ".join(filter(None, said)) if idle is None else f"{idle.cause}; {idle.advice}",
        status=study_status(complete, statuses, idle),
        message=message,
        case=case_used(case),
        parameters=dict(parameters),
        present=here,
        axis=axis_used(case, axis, named, unit),
        asked=asked,
        start=None if start is None else dict(start),
        statuses=statuses,
        resolution=found[0].resolution,
        step=max(zones.step for zones in found),
        starts=found[0].starts,
        branches=len(found[0].branches),
        not_followed=found[0].not_followed,
        zones=listed,
    )


def done(found: Zones) -> Done:
    """How far a search came that was stopped."""
    points = [point for sweep in found.sweeps for point in sweep.points]
    computed = sum(point.computed for point in points)
    return Done(found.message, computed, len(points), len(found.branches), found.not_followed)


def _zone(case: Case, zone: Zone, here: float, asked: Asked) -> ZoneFound:
    beside, back_met = zone.coexisting, _meets_back(zone)
    margin = zone.margin(here) if zone.contains(here) and isfinite(zone.margin(here)) else None
    below, above = zone.margins(here)
    lower = _end(case, zone.name, zone.lower, back_met, asked)
    upper = _end(case, zone.name, zone.upper, back_met, asked)
    return ZoneFound(
        kind=zone.quiet.value,
        every=zone.every,
        lower=lower,
        upper=upper,
        margin=margin,
        margin_asked=None if margin is None else abs(asked.value(margin)),
        residents=tuple(_resident(motion, motion in beside) for motion in zone.motions),
        margin_below=_margin(case, zone.name, below, here, lower, asked),
        margin_above=_margin(case, zone.name, above, here, upper, asked),
        unique=zone.unique,
    )


def _margin(
    case: Case, name: str, margin: Margin | None, here: float, end: ZoneEnd, asked: Asked
) -> MarginFound | None:
    if margin is None:
        return None
    own = {value.name: value.value for value in physical_values(case, name, here)}
    sign = 1.0 if end.value > here else -1.0
    there = physical_values(case, name, here + sign * margin.distance)
    rests = {value.name: value.rests_on for value in end.physical}
    return MarginFound(
        distance=margin.distance,
        asked=abs(asked.value(here + sign * margin.distance) - asked.value(here)),
        physical=tuple(
            replace(each, value=abs(each.value - own[each.name]), rests_on=rests.get(each.name, ()))
            for each in there
        ),
        percent=margin.percent if isfinite(margin.percent) else None,
        event=event(end, case.between_teeth),
    )


def _end(case: Case, name: str, end: FoundEnd, back_met: bool, asked: Asked) -> ZoneEnd:
    physical = physical_values(case, name, end.value, computed=end.bounded, back_side_met=back_met)
    if end.kind == RANGE_END:  # as it was typed: it rests on nothing
        physical = tuple(replace(p, rests_on=()) if p.name == asked.name else p for p in physical)
    return ZoneEnd(
        value=end.value,
        uncertainty=end.uncertainty,
        physical=physical,
        kind=end.kind,
        solved=end.point is not None,
        inside=label_text(end.inside),
        outside=end.beyond,
        direction=end.direction,
        point=_point(end),
    )


def _point(end: FoundEnd) -> EndPoint | None:
    from gearlash.branches.continuation import SpecialPoint

    point = end.point
    if not isinstance(point, SpecialPoint):
        return None
    return EndPoint(
        branch_kind=str(point.kind),
        note=point.note,
        label_before=label_text(point.label_before),
        label_after=label_text(point.label_after),
        unstable_before=point.unstable_before,
        unstable_after=point.unstable_after,
    )


def _meets_back(zone: Zone) -> bool:
    """Whether any motion inside or just outside meets the back side, or may."""
    ends = (end.outside for end in (zone.lower, zone.upper) if end.bounded)
    labels = (*ends, *(motion.label for motion in zone.motions))
    return not all(isinstance(one, Signature) and one.back == 0 and not one.others for one in labels)


def _resident(motion: ZoneMotion, coexisting: bool) -> Resident:
    return Resident(
        label_text(motion.label),
        tuple(map(str, motion.directions)),
        motion.lower,
        motion.upper,
        motion.quiet,
        coexisting,
        _stay(motion.stable),
        _stay(motion.exists),
        None if motion.assured is None else Assured(*motion.assured),
    )


def _stay(interval: Interval | None) -> Stay | None:
    if interval is None:
        return None
    lower, upper = interval.lower, interval.upper
    return Stay(lower.value, upper.value, lower.kind, upper.kind)
