"""The table of claims: each claim beside its computed counterpart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from gearlash import SpecialKind
from gearlash.case import Case
from gearlash.results import Point
from gearlash.system import MotionKind, label_text

from .claims import Claim
from .judge import NOT_FOUND, REPRODUCED, SHIFTED, coincides, same_label, verdict
from .pair import FITTED, is_bundled
from .reproduction import NAN, ClaimRow, Coincidence, Event, Explained, Part, Reading, ReportedZone
from .rows import Row
from .table2 import exponent_at
from .zoning import SOME


@dataclass(frozen=True, eq=False)
class Evidence:
    """All that claims are judged by."""

    case: Case
    events: Sequence[Event]
    zones: Sequence[ReportedZone]
    rows: Mapping[str, Sequence[Row]]
    met: Mapping[str, Sequence[Explained]]  # changes along the sweeps, as special points
    motions: Mapping[str, Sequence[tuple[str, Point]]]  # claim id → (start, what was found)


def judge(claims: Sequence[Claim], evidence: Evidence) -> tuple[ClaimRow, ...]:
    """A row for every claim, in their order."""
    makers = {
        "grazing": _event,
        "codimension-2": _coincidence,
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
        "fitted": claim.id in FITTED and is_bundled(evidence.case),
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
        needs=_needed(event),
        note=event.note,
    )


def _needed(event: Event) -> str:
    """The only scans in which an event was met, where it was not met in all three."""
    return "" if not event.found or event.everywhere else event.branch.replace("met in: ", "")


def _coincidence(claim: Claim, evidence: Evidence) -> ClaimRow:
    """Value and labels, and the coincidence itself, each judged."""
    row, event = _event(claim, evidence), _find(evidence, claim.id)
    both = event.coincidence
    if both is None:
        return row
    value = Part(
        "value and labels",
        f"{claim.printed}, {claim.below} → {claim.above}",
        f"{event.value:.10g}, {event.label_below} → {event.label_above}",
        verdict([event.deviation], labels_equal=True),
        f"The doubling of {both.single}; {both.doubled} lies between the two for {both.apart:.1e} of "
        f"{claim.parameter} only.",
    )
    one = Part(
        "doubling and grazing coincide",
        "one point",
        f"{both.apart:.2e} apart",
        coincides(both.apart, event.value, claim.printed),
        _why_close(both, claim),
    )
    return replace(row, parts=(value, one))


def _why_close(both: Coincidence, claim: Claim) -> str:
    clear = f"{both.clearance:.3g}"
    return (
        f"Doubling at {both.doubling.value:.8f}, grazing at {both.grazing.value:.8f}: one event to the "
        f"digits of {claim.printed}, not one point. They lie so close because the doubled orbit opens like a "
        f"square root (measured: amplitude ∼ distance to the power {both.power:.2f}): at the distance s its "
        f"amplitude is a = √(s/c), c = {both.opens:.3g}, and the extremum that passes the boundary at h = "
        f"{clear} in the doubling itself comes nearer by b a, b = {both.approaches:.3g}. It touches at "
        f"s = c (h/b)² = {both.predicted:.1e} by these two alone, at {both.corrected:.2e} with the next "
        f"terms of both, at {both.apart:.2e} as solved for. The exponent of the touching orbit is "
        f"{exponent_at(both.grazing):.1e}. In one true point h = {clear} would vanish as well, "
        "which takes a second parameter; that is not claimed."
    )


def _exponent(claim: Claim, evidence: Evidence) -> ClaimRow:
    """A claim about a sign is judged by the sign; where its event lies is judged with the event."""
    event = _find(evidence, claim.of)
    if not event.found:
        note = f"The event it belongs to ({event.digits}) was not found."
        return _row(claim, evidence, computed="not found", verdict=NOT_FOUND, branch=event.branch, note=note)
    about_zero = abs(event.exponent) <= 1e-3  # per unit of τ
    holds = about_zero if claim.sign == 0 else event.exponent < 0.0
    place = f"{_symbol(event.parameter)} = {event.value:.6f}"
    note = f"At the computed grazing, {place}; ln|μ|max/(P T)."
    if event.coincidence is not None:
        touch = event.coincidence.grazing
        note = (
            f"At the doubling, {place}, where a multiplier is −1: zero but for rounding. At the grazing "
            f"{event.coincidence.apart:.1e} beside it: {exponent_at(touch):.1e}."
        )
    return _row(
        claim,
        evidence,
        computed=f"{event.exponent:.4g}" if abs(event.exponent) > 1e-9 else "0",  # rounding
        computed_value=event.exponent,
        computed_labels=f"{event.label_below} → {event.label_above}",
        verdict=REPRODUCED if holds else NOT_FOUND,
        branch=event.branch,
        needs=_needed(event),
        note=note,
    )


def _zone(claim: Claim, evidence: Evidence) -> ClaimRow:
    """The reading nearest to the article, by its name, and what the others show."""
    zone = _found(evidence, claim)
    if not zone.nearest:
        return _row(claim, evidence, computed="not found", verdict=NOT_FOUND, note=zone.note)
    best = zone.reading(zone.nearest)
    others = "; ".join(
        f"{r.name}: {_interval(r)}" for r in zone.readings if r.way not in (zone.nearest, SOME)
    )
    note = f"Lower end: {best.lower.how}; upper end: {best.upper.how}. Other readings: {others}."
    return _row(
        claim,
        evidence,
        computed=f"[{best.lower.value:.6g}, {best.upper.value:.6g}]",
        reported_labels=claim.label or "P-Q-0",
        computed_labels=", ".join(map(str, best.labels)),
        deviation=best.deviation,
        verdict=zone.verdict,
        branch=f"nearest reading: {best.name}",
        needs=_needed_reading(zone),
        note=note,
    )


def _found(evidence: Evidence, claim: Claim) -> ReportedZone:
    return next(z for z in evidence.zones if (z.kind, z.parameter) == (claim.zone, claim.parameter))


def _interval(reading: Reading) -> str:
    return f"[{reading.lower.value:.4f}, {reading.upper.value:.4f}]" if reading.found else "none"


def _needed_reading(zone: ReportedZone) -> str:
    """The readings that reach the verdict, where not all of them do."""
    compared = [r for r in zone.readings if r.way != SOME]
    alike = [r.name for r in compared if r.verdict == zone.verdict]
    return "" if len(alike) == len(compared) else "; ".join(alike)


def _insensitive(claim: Claim, evidence: Evidence) -> ClaimRow:
    """How much X - D on σ_t moves with D beyond the last back-side impact, orbit by orbit of one label,
    beside how much it moves below."""
    zone = next(z for z in evidence.zones if z.kind == "drive side only")
    edge = zone.reading(SOME).lower.value
    change, labels = 0.0, set()
    for row in evidence.rows[claim.parameter]:
        inside = [p for p in row.sweep.points if p.value > edge and p.drive_side_only]
        for one, two in pairwise(inside):
            labels |= {one.label, two.label}
            if one.label == two.label:
                change = max(change, _moved(one, two))
    holds = bool(labels) and change <= 0.01  # counts as insensitive
    return _row(
        claim,
        evidence,
        computed=f"largest step of X − D: {change:.1e}",
        computed_value=change,
        computed_labels=", ".join(sorted(map(label_text, labels))),
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
    met = (each.point for each in evidence.met[claim.parameter] if each.kind == SpecialKind.DOUBLING)
    doublings = {round(special.value, 6) for special in met}
    aperiodic = {
        p.value
        for row in rows
        for p in row.sweep.points
        if p.label is MotionKind.APERIODIC and p.largest_exponent > 0
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
    judged = REPRODUCED if same_label(cold.label, claim.label) else SHIFTED if met else NOT_FOUND
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
        computed=label_text(cold.label),
        reported_labels=claim.label,
        computed_labels="; ".join(f"{start}: {label_text(point.label)}" for start, point in found),
        verdict=judged,
        branch="cold start, and the nearest points of the followed sweeps",
        note=note.strip(),
    )
