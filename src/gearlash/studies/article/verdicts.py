"""The table of claims: each claim beside its computed counterpart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gearlash.case import Case
from gearlash.results import Point
from gearlash.studies.transitions import DOUBLING, FOLD

from .claims import Claim
from .judge import NOT_FOUND, REPRODUCED, SHIFTED, deviation, same_label
from .reproduction import NAN, ClaimRow, Event, Zone
from .rows import Row

ZERO_EXPONENT = 1e-3  # |LLE| that counts as "approximately zero", per unit of τ
SAME = 0.01  # relative change of X - D over the zone that counts as insensitive


@dataclass(frozen=True, eq=False)
class Evidence:
    """All that claims are judged by."""

    case: Case
    events: Sequence[Event]
    zones: Sequence[Zone]
    rows: Mapping[str, Sequence[Row]]
    motions: Mapping[str, Sequence[tuple[str, Point]]]  # claim id → (start, what was found)


def judge(claims: Sequence[Claim], evidence: Evidence) -> tuple[ClaimRow, ...]:
    """A row for every claim, in their order."""
    makers = {
        "grazing": _event,
        "codimension-2": _event,
        "exponent": _exponent,
        "zone": _zone,
        "insensitive": _insensitive,
        "routes": _routes,
        "label": _label,
    }
    return tuple(makers[claim.kind](claim, evidence) for claim in claims)


def _row(claim: Claim, evidence: Evidence, **computed) -> ClaimRow:
    where = ", ".join(f"{_symbol(name)} = {value:g}" for name, value in claim.fixed.items())
    blank = {
        "value": claim.value if claim.value is not None else NAN,
        "computed_value": NAN,
        "unit": "",
        "reported_labels": "",
        "computed_labels": "",
        "deviation": NAN,
        "branch": "",
        "note": "",
        "rests_on": rests_on(evidence.case),
    }
    return ClaimRow(
        id=claim.id, sentence=claim.sentence, quantity=claim.quantity, where=where, printed=claim.printed,
        **{**blank, **computed},
    )  # fmt: skip


def rests_on(case: Case) -> tuple[str, ...]:
    """Paths of the values that decide the dimensionless result and were not given."""
    return tuple(v.path for v in case.values() if v.short and str(v.provenance) in ("assumed", "inferred"))


def _symbol(name: str) -> str:
    return {"omega": "ω"}.get(name, name)


def _find(evidence: Evidence, claim_id: str) -> Event:
    return next(event for event in evidence.events if event.claim == claim_id)


def _event(claim: Claim, evidence: Evidence) -> ClaimRow:
    event = _find(evidence, claim.id)
    return _row(
        claim,
        evidence,
        computed=f"{event.value:.10g}" if event.found else "not found",
        computed_value=event.value,
        reported_labels=f"{claim.below} → {claim.above}",
        computed_labels=f"{event.label_below} → {event.label_above}" if event.found else "",
        deviation=event.deviation,
        verdict=event.verdict,
        branch=event.branch,
        note=event.note,
    )


def _exponent(claim: Claim, evidence: Evidence) -> ClaimRow:
    event = _find(evidence, claim.of)
    if not event.found:
        note = f"The event it belongs to ({event.digits}) was not found."
        return _row(claim, evidence, computed="not found", verdict=NOT_FOUND, branch=event.branch, note=note)
    holds = abs(event.exponent) <= ZERO_EXPONENT if claim.sign == 0 else event.exponent < 0.0
    return _row(
        claim,
        evidence,
        computed=f"{event.exponent:.4g}",
        computed_value=event.exponent,
        computed_labels=f"{event.label_below} → {event.label_above}",
        verdict=event.verdict if holds else NOT_FOUND,
        branch=event.branch,
        note=f"At the computed grazing, {_symbol(event.parameter)} = {event.value:.6f}; ln|μ|max/(P T).",
    )


def _zone(claim: Claim, evidence: Evidence) -> ClaimRow:
    mine = [zone for zone in evidence.zones if zone.kind == claim.zone and zone.parameter == claim.parameter]
    zone = next(z for z in mine if z.reported is not None)
    every = next((z for z in mine if z.reported is None), None)
    if zone.verdict == NOT_FOUND and not np.isfinite(zone.lower.value):
        return _row(claim, evidence, computed="not found", verdict=NOT_FOUND, note=zone.note)
    assert claim.interval is not None
    worst = max((deviation(end.value, edge) for end, edge in _ends(zone, claim)), key=abs)
    note = f"Lower end: {zone.lower.how}; upper end: {zone.upper.how}."
    if every is not None:
        narrow = f"[{every.lower.value:.4f}, {every.upper.value:.4f}]"
        note += f" All attractors found agree on this ({claim.zone}) in {narrow} only."
    if zone.coexisting:
        note += " Coexisting in it: " + ", ".join(sorted({c.label for c in zone.coexisting})) + "."
    return _row(
        claim,
        evidence,
        computed=f"[{zone.lower.value:.6g}, {zone.upper.value:.6g}]",
        reported_labels=claim.label or "P-Q-0",
        computed_labels=", ".join(zone.labels),
        deviation=worst,
        verdict=zone.verdict,
        branch="at least one of the up, down and cold sweeps",
        note=note,
    )


def _ends(zone: Zone, claim: Claim):
    assert claim.interval is not None
    return zip((zone.lower, zone.upper), claim.interval, strict=True)


def _insensitive(claim: Claim, evidence: Evidence) -> ClaimRow:
    """How much X - D on σ_t moves with D beyond the last back-side impact, orbit by orbit of one label,
    beside how much it moves below."""
    zone = next(z for z in evidence.zones if z.kind == "drive side only")
    edge = zone.lower.value
    change, labels = 0.0, set()
    for row in evidence.rows[claim.parameter]:
        inside = [p for p in row.sweep.points if p.value > edge and p.drive_side_only]
        for one, two in pairwise(inside):
            labels |= {one.label, two.label}
            if one.label == two.label:
                change = max(change, _moved(one, two))
    holds = bool(labels) and change <= SAME
    return _row(
        claim,
        evidence,
        computed=f"largest step of X − D: {change:.1e}",
        computed_value=change,
        computed_labels=", ".join(sorted(labels)),
        verdict=REPRODUCED if holds else NOT_FOUND,
        branch="all sweeps",
        note=f"For D > {edge:.4f}: X − D of a motion that meets one boundary only does not depend on D at "
        "all (an exact invariance); what is left is rounding. Motions that still meet the back side are left "
        "out.",
    )


def _moved(one: Point, two: Point) -> float:
    """Largest difference of X - D on σ_t, relative to its size; orbits that are shifts of each other are
    aligned."""
    a, b = one.strobes - one.value, two.strobes - two.value
    least = min(float(np.abs(np.roll(b, k) - a).max()) for k in range(len(b)))
    return least / max(float(np.ptp(a)), float(np.abs(a).max()))


def _routes(claim: Claim, evidence: Evidence) -> ClaimRow:
    rows = evidence.rows[claim.parameter]
    found = [t for row in rows for t in row.transitions if t.point is not None and t.kind in (DOUBLING, FOLD)]
    doublings = {round(t.value, 6) for t in found if t.kind == DOUBLING}
    aperiodic = {
        p.value for row in rows for p in row.sweep.points if p.label == "aperiodic" and p.largest_exponent > 0
    }
    share = len(aperiodic) / len(rows[0].sweep.points)
    holds = bool(doublings) and bool(aperiodic)
    places = ", ".join(f"{value:.5f}" for value in sorted(doublings)[:8])
    top = max(
        (p.largest_exponent for row in rows for p in row.sweep.points if p.value in aperiodic), default=NAN
    )
    return _row(
        claim,
        evidence,
        computed=f"{len(doublings)} doublings; aperiodic at {share:.0%} of the values, exponent ≤ {top:.3f}",
        verdict=REPRODUCED if holds else NOT_FOUND,
        branch="all sweeps",
        note=f"Doublings at D = {places}." if doublings else "",
    )


def _label(claim: Claim, evidence: Evidence) -> ClaimRow:
    found = evidence.motions[claim.id]
    cold = found[0][1]
    met = [start for start, point in found if same_label(point.label, claim.label)]
    verdict = REPRODUCED if same_label(cold.label, claim.label) else SHIFTED if met else NOT_FOUND
    note = "" if len({p.label for _, p in found}) == 1 else "Which motion is met depends on the start."
    rpm = (
        evidence.case.scales.pinion_rpm(claim.at).item()
        if evidence.case.scales.physical and claim.at
        else NAN
    )
    if np.isfinite(rpm):
        note = f"{rpm:.0f} rpm with the case's scales (inferred). " + note
    return _row(
        claim,
        evidence,
        computed=cold.label,
        reported_labels=claim.label,
        computed_labels="; ".join(f"{start}: {point.label}" for start, point in found),
        verdict=verdict,
        branch="cold start, and the nearest points of the followed sweeps",
        note=note.strip(),
    )
