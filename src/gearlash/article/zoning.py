"""The article's two stable zones: as each way of scanning shows them, and as an operator can rely on them."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor

import numpy as np

from gearlash.case import Case
from gearlash.jobs import Execution, ProgressCallback
from gearlash.results import Axis, Direction, Sweep
from gearlash.studies.scanned import scanned_zones
from gearlash.studies.sweep import sweep
from gearlash.studies.zone import Zone as Found
from gearlash.studies.zone import ZoneMotion, Zones

from .claims import Claim
from .judge import NOT_FOUND, deviation, verdict
from .reproduction import NAN, Coexisting, End, Reading, ReportedZone
from .rows import STUDY_SETTINGS, Row
from .starts import STARTS, starting

ZONE_KINDS = {"impact-free": "impact-free", "drive side only": "drive-side-only"}
SOME, EVERY = "some", "every"
EVERY_FEW = 3  # of the values of an axis: from a simple start
READING_NAMES = {
    str(Direction.COLD): "cold start at every value (at rest under the load)",
    str(Direction.UP): "motion followed upwards",
    str(Direction.DOWN): "motion followed downwards",
    SOME: "at least one of these attractors",
    EVERY: "every one of these attractors",
}
NOWHERE = End(NAN, "none", "", NAN)


def article_zones(
    case: Case,
    claim: Claim,
    axis: Axis,
    rows: Sequence[Row],
    executor: Executor,
    progress: ProgressCallback | None = None,
) -> ReportedZone:
    """The zone that the claim means, in each reading: cold, up, down, for some and for every attractor that
    these find, and from each of the simple starts. The one nearest to the article is named; `some` is no way
    of scanning, so it is not compared."""
    sweeps = [row.sweep for row in rows]
    together = _zones(case, claim, axis, sweeps, executor)
    readings = [
        _reading(claim, str(s.direction), _zones(case, claim, axis, [s], executor), rows) for s in sweeps
    ]
    readings.append(_reading(claim, EVERY, together, rows))
    readings.append(_reading(claim, SOME, together, rows))
    readings += [_from_start(case, claim, axis, name, executor, progress) for name in STARTS]
    compared = [r for r in readings if r.found and r.way != SOME]
    nearest = min(compared, key=lambda r: abs(r.deviation), default=None)
    assert claim.interval is not None
    return ReportedZone(
        name=f"{claim.title}: {claim.zone}",
        parameter=claim.parameter,
        fixed=dict(claim.fixed),
        kind=claim.zone,
        reported=claim.interval,
        readings=tuple(readings),
        nearest=nearest.way if nearest is not None else "",
        verdict=nearest.verdict if nearest is not None else NOT_FOUND,
        note=_note(together) if nearest is not None else "No way of scanning shows such an interval there.",
    )


def _zones(case: Case, claim: Claim, axis: Axis, known: Sequence[Sweep], executor: Executor) -> Zones:
    return scanned_zones(
        case,
        axis,
        ZONE_KINDS[claim.zone],
        known,
        values=claim.fixed,
        settings=STUDY_SETTINGS,
        execution=Execution(executor),
    )


def _from_start(
    case: Case,
    claim: Claim,
    axis: Axis,
    name: str,
    executor: Executor,
    progress: ProgressCallback | None,
) -> Reading:
    """Every few values from one simple start; the ends are halved to as fine as all others."""
    family = starting(case, name)
    axis = Axis(axis.name, np.union1d(axis.values[::EVERY_FEW], axis.values[-1:]))
    done = sweep(
        family,
        axis,
        values=claim.fixed,
        settings=STUDY_SETTINGS,
        execution=Execution(executor, progress=progress),
    )
    found = scanned_zones(
        family,
        axis,
        ZONE_KINDS[claim.zone],
        [done],
        values=claim.fixed,
        settings=STUDY_SETTINGS,
        execution=Execution(executor),
    )
    return _reading(claim, name, found, (Row(done, ()),))


def _reading(claim: Claim, way: str, found: Zones, rows: Sequence[Row]) -> Reading:
    name = READING_NAMES.get(way, f"fixed start {way}")
    zone = _nearest((found.wider or found.zones) if way == SOME else found.zones, claim)
    if zone is None:
        return Reading(way, name, NOWHERE, NOWHERE, (), NAN, (), (NAN, NAN), NOT_FOUND)
    assert claim.interval is not None
    low, high = claim.interval
    ends = deviation(zone.lower.value, low), deviation(zone.upper.value, high)
    mine = [row for row in rows if way in (SOME, EVERY) or row.direction == way or way in STARTS]
    return Reading(
        way=way,
        name=name,
        lower=End(zone.lower.value, zone.lower.kind, zone.lower.beyond, zone.lower.uncertainty),
        upper=End(zone.upper.value, zone.upper.kind, zone.upper.beyond, zone.upper.uncertainty),
        labels=tuple(dict.fromkeys(t.label for t in zone.motions if t.quiet)),
        margin=_margin(claim, zone, mine),
        coexisting=tuple(_coexisting(t, mine) for t in zone.motions if not t.quiet),
        deviations=ends,
        verdict=verdict(list(ends), labels_equal=True),
    )


def _nearest(candidates: Sequence[Found], claim: Claim) -> Found | None:
    """The zone that shares most with the reported interval."""
    assert claim.interval is not None
    low, high = claim.interval

    def shared(zone: Found) -> float:
        return min(zone.upper.value, high) - max(zone.lower.value, low)

    best = max(candidates, key=shared, default=None)
    return best if best is not None and shared(best) > 0.0 else None


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


def _coexisting(motion: ZoneMotion, rows: Sequence[Row]) -> Coexisting:
    exponents = [
        p.largest_exponent
        for row in rows
        for p in row.sweep.points
        if p.label == motion.label and motion.lower <= p.value <= motion.upper
    ]
    start = ", ".join(motion.directions)
    return Coexisting(motion.label, (motion.lower, motion.upper), start, max(exponents, default=NAN))


def _note(found: Zones) -> str:
    text = (
        f"Changes narrower than the step of the sweeps ({found.resolution:.2g}; from simple starts "
        f"{EVERY_FEW * found.resolution:.2g}) may lie inside unseen."
    )
    if not found.complete:
        text += f" Not complete: {found.message}."
    return text
