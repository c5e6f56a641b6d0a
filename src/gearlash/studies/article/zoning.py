"""The article's two stable zones, computed from the same sweeps."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor

from gearlash.case import Case
from gearlash.results import Axis
from gearlash.studies.zones import Tenant, Zones, zones
from gearlash.studies.zones import Zone as Found

from .claims import Claim
from .judge import NOT_FOUND, deviation, verdict
from .reproduction import NAN, Coexisting, End, Zone
from .rows import SETTINGS, Row

KINDS = {"impact-free": "impact-free", "drive side only": "drive-side-only"}


def article_zones(
    case: Case, claim: Claim, axis: Axis, rows: Sequence[Row], executor: Executor
) -> tuple[Zone, ...]:
    """The zone that the claim means, in two readings: where some attractor found is quiet (a branch followed
    by hand would show it), and where every one is (an operator may rely on it). The first is compared with
    the article."""
    sweeps = [row.sweep for row in rows]
    found = zones(
        case, axis, KINDS[claim.zone], fixed=claim.fixed, known=sweeps, settings=SETTINGS, executor=executor
    )
    some, every = _nearest(found.wider or found.zones, claim), _nearest(found.zones, claim)
    readings = []
    if some is not None:
        readings.append(_zone(claim, some, found, rows, "at least one attractor found", claim.interval))
    if every is not None and every is not some:
        readings.append(_zone(claim, every, found, rows, "every attractor found", None))
    return tuple(readings) or (_none(claim),)


def _nearest(candidates: Sequence[Found], claim: Claim) -> Found | None:
    """The zone that shares most with the reported interval."""
    assert claim.interval is not None
    low, high = claim.interval

    def shared(zone: Found) -> float:
        return min(zone.upper.value, high) - max(zone.lower.value, low)

    best = max(candidates, key=shared, default=None)
    return best if best is not None and shared(best) > 0.0 else None


def _zone(claim: Claim, zone: Found, found: Zones, rows: Sequence[Row], who: str, reported) -> Zone:
    ends = [
        _deviation(end, edge)
        for end, edge in zip((zone.lower, zone.upper), claim.interval or (), strict=True)
    ]
    judged = verdict(ends, labels_equal=True) if reported else ""
    quiet = [t for t in zone.tenants if t.quiet]
    return Zone(
        name=f"{claim.title}: {claim.zone} for {who}",
        parameter=claim.parameter,
        fixed=dict(claim.fixed),
        kind=claim.zone,
        reported=reported,
        lower=End(zone.lower.value, zone.lower.kind, zone.lower.outside, zone.lower.uncertainty),
        upper=End(zone.upper.value, zone.upper.kind, zone.upper.outside, zone.upper.uncertainty),
        labels=tuple(dict.fromkeys(t.label for t in quiet)),
        margin=_margin(claim, zone, rows),
        coexisting=tuple(_coexisting(t, rows) for t in zone.tenants if not t.quiet),
        verdict=judged,
        note=_note(zone, found),
    )


def _deviation(end, edge: float) -> float:
    """Of an end from the article's. A zone that reaches the end of the studied range agrees with an edge
    there."""
    return deviation(end.value, edge)


def _margin(claim: Claim, zone: Found, rows: Sequence[Row]) -> float:
    """Least distance of X to the boundary that ends the quiet, in the middle of the zone, over all rows quiet
    there."""
    middle = 0.5 * (zone.lower.value + zone.upper.value)
    margins = []
    for row in rows:
        point = min(row.sweep.points, key=lambda p: abs(p.value - middle))
        gap = point.value if claim.parameter == "D" else float(claim.fixed.get("D", 1.0))
        if zone.quiet.holds(point):
            margins.append(point.minimum - gap if claim.zone == "impact-free" else point.minimum + gap)
    return min(margins, default=NAN)


def _coexisting(tenant: Tenant, rows: Sequence[Row]) -> Coexisting:
    exponents = [
        p.largest_exponent
        for row in rows
        for p in row.sweep.points
        if p.label == tenant.label and tenant.lower <= p.value <= tenant.upper
    ]
    start = ", ".join(tenant.directions)
    return Coexisting(tenant.label, (tenant.lower, tenant.upper), start, max(exponents, default=NAN))


def _note(zone: Found, found: Zones) -> str:
    text = f"Changes narrower than the step of the sweeps ({found.resolution:.2g}) may lie inside unseen."
    if not found.complete:
        text += f" Not complete: {found.message}."
    return text


def _none(claim: Claim) -> Zone:
    nowhere = End(NAN, "none", "", NAN)
    return Zone(
        name=f"{claim.title}: {claim.zone}",
        parameter=claim.parameter,
        fixed=dict(claim.fixed),
        kind=claim.zone,
        reported=claim.interval,
        lower=nowhere,
        upper=nowhere,
        labels=(),
        margin=NAN,
        coexisting=(),
        verdict=NOT_FOUND,
        note="No quiet interval overlaps the reported one in any sweep.",
    )
