"""`gearlash zones`: intervals of a parameter with quiet motion."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import isfinite
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case
from gearlash.system import Signature, Status, label_text

from .asked import Asked
from .excitation import idle_study
from .outcome import POINTS, study_status, troubles
from .parts import CaseUsed, case_used, physical_values
from .sweep import START, AxisUsed, axis_used, first_failure
from .zones_parts import Resident, ZoneEnd, ZoneFound
from .zones_words import headline

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.studies.zone import Zone, ZoneMotion, Zones
    from gearlash.studies.zone import ZoneEnd as FoundEnd


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
        "step of the axis: a zone narrower than that may have been missed, and so may other motions that "
        "live between two of its values only",
    ]
    step: Annotated[
        float,
        "inside the zones quiet motion was followed in steps of this at the most: an interruption narrower "
        "than that may have been missed",
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
    said = (headline(asked, ends, here, listed), troubles(statuses, first_failure(asked, found[0].sweeps)))
    return ZonesAnswer(
        sentence="; ".join(filter(None, said)) if idle is None else f"{idle.cause}; {idle.advice}",
        status=study_status(all(zones.complete for zones in found), statuses, idle),
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
        zones=listed,
    )


def _zone(case: Case, zone: Zone, here: float, asked: Asked) -> ZoneFound:
    beside, back_met = zone.coexisting, _meets_back(zone)
    margin = zone.margin(here) if zone.contains(here) and isfinite(zone.margin(here)) else None
    return ZoneFound(
        kind=zone.quiet.value,
        every=zone.every,
        lower=_end(case, zone.name, zone.lower, back_met, asked),
        upper=_end(case, zone.name, zone.upper, back_met, asked),
        margin=margin,
        margin_asked=None if margin is None else abs(asked.value(margin)),
        residents=tuple(_resident(motion, motion in beside) for motion in zone.motions),
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
    )
