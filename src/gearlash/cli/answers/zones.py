"""`gearlash zones`: intervals of a parameter with quiet motion."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case

from .parts import CaseUsed, PhysicalValue, case_used, physical_values
from .sweep import AxisUsed, axis_used

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.studies.zone import End, Tenant, Zone, Zones


QUIET = re.compile(r"\d+-\d+-0")  # label of a motion that never meets the back side


@dataclass(frozen=True)
class ZoneEnd:
    """Where an interval ends."""

    value: float
    uncertainty: Annotated[float, "the value is known within plus or minus this"]
    physical: tuple[PhysicalValue, ...]
    kind: Annotated[
        str, "grazing, doubling, fold, jump, onset of aperiodic motion, change of basin, end of the range"
    ]
    solved: Annotated[bool, "solved for together with the orbit; else found by halving"]
    inside: Annotated[str, "label just inside"]
    outside: Annotated[str, "label just outside"]
    direction: Annotated[str, "sweep whose attractor changes here"]


@dataclass(frozen=True)
class Resident:
    """A motion that was seen inside."""

    label: str
    directions: Annotated[tuple[str, ...], "sweeps that found it"]
    lower: float
    upper: float
    quiet: bool
    coexisting: Annotated[bool, "seen beside another motion at the same value"]


@dataclass(frozen=True)
class ZoneFound:
    """One interval."""

    kind: Annotated[Literal["impact-free", "drive-side-only"], "no impact at all, or none on the back side"]
    every: Annotated[bool, "every attractor found is quiet; false: only some are"]
    lower: ZoneEnd
    upper: ZoneEnd
    margin: Annotated[
        float | None, "from the case's own value to the nearer end, less its uncertainty; null outside"
    ]
    residents: tuple[Resident, ...]


@dataclass(frozen=True)
class ZonesAnswer:
    """Intervals with quiet motion (gearlash zones)."""

    sentence: str
    status: Annotated[str, "ok, or incomplete if it was stopped"]
    message: str
    case: CaseUsed
    parameters: Annotated[
        dict[str, float], "every parameter by short name, with the case's own value of the varied one"
    ]
    axis: AxisUsed
    resolution: Annotated[float, "step of the axis: what is narrower may have been missed"]
    zones: Annotated[tuple[ZoneFound, ...], "where every attractor found is quiet, then where only some are"]
    result: Literal["zones"] = "zones"


def zones_answer(
    case: Case, parameters: Mapping[str, float], named: str, found: Sequence[Zones]
) -> ZonesAnswer:
    """The record of zones of one or both kinds, from the same sweeps."""
    axis, here = found[0].axis, parameters[found[0].axis.name]
    listed = tuple(_zone(case, z, here) for zones in found for z in (*zones.zones, *zones.wider))
    message = "; ".join(dict.fromkeys(zones.message for zones in found if zones.message))
    return ZonesAnswer(
        sentence=_sentence(axis.name, listed),
        status="ok" if all(zones.complete for zones in found) else "incomplete",
        message=message,
        case=case_used(case),
        parameters=dict(parameters),
        axis=axis_used(case, axis, named),
        resolution=found[0].resolution,
        zones=listed,
    )


def _zone(case: Case, zone: Zone, here: float) -> ZoneFound:
    margin, beside, back_met = zone.margin(here), zone.coexisting, _meets_back(zone)
    return ZoneFound(
        kind=zone.quiet.value,
        every=zone.every,
        lower=_end(case, zone.name, zone.lower, back_met),
        upper=_end(case, zone.name, zone.upper, back_met),
        margin=margin if zone.contains(here) and isfinite(margin) else None,
        residents=tuple(_resident(tenant, tenant in beside) for tenant in zone.tenants),
    )


def _end(case: Case, name: str, end: End, back_met: bool) -> ZoneEnd:
    return ZoneEnd(
        value=end.value,
        uncertainty=end.uncertainty,
        physical=physical_values(case, name, end.value, computed=end.bounded, back_side_met=back_met),
        kind=end.kind,
        solved=end.point is not None,
        inside=end.inside,
        outside=end.outside,
        direction=end.direction,
    )


def _meets_back(zone: Zone) -> bool:
    """Whether any motion inside or just outside meets the back side, or may."""
    ends = (end.outside for end in (zone.lower, zone.upper) if end.bounded)
    return any(not QUIET.fullmatch(label) for label in (*ends, *(tenant.label for tenant in zone.tenants)))


def _resident(tenant: Tenant, coexisting: bool) -> Resident:
    return Resident(
        tenant.label, tuple(map(str, tenant.directions)), tenant.lower, tenant.upper, tenant.quiet, coexisting
    )


def _sentence(name: str, zones: Sequence[ZoneFound]) -> str:
    sure = [zone for zone in zones if zone.every]
    free = [zone for zone in sure if zone.kind == "impact-free"] or sure
    if not free:
        return f"{name}: no interval was found in which every attractor is quiet"
    widest = max(free, key=lambda zone: zone.upper.value - zone.lower.value)
    ends = f"{name} from {widest.lower.value:.6g} to {widest.upper.value:.6g}"
    if widest.lower.physical:
        low, high = widest.lower.physical[0], widest.upper.physical[0]
        unit = {"um": "µm", "N*m": "N·m"}.get(high.unit, high.unit)
        ends += f" ({low.value:.5g} to {high.value:.5g} {unit}{' †' if high.rests_on else ''})"
    words = {"impact-free": "free of impacts", "drive-side-only": "free of impacts on the back side"}[
        widest.kind
    ]
    return f"every attractor found is {words} for {ends}"
