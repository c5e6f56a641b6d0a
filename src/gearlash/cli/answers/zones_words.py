"""The sentence that zones begin with: where the present value lies first, then the other zones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gearlash.results.zone_words import percent

from .asked import Asked
from .zones_parts import MarginFound, ZoneEnd, ZoneFound

QUIET = {"impact-free": "free of impacts", "drive-side-only": "free of impacts on the back side"}
WHO = {True: "every attractor found", False: "at least one attractor found, but not everywhere for all"}
ASSUMED_MARK = "†"  # behind a physical number that rests on an assumed value
MOST_ZONES = 4  # further zones that are named
NO_END = ("end of the range", "not computed beyond")


IMPACT_FREE, DRIVE_SIDE_ONLY = QUIET


def headline(
    asked: Asked,
    ends: tuple[float, float],
    here: float,
    zones: Sequence[ZoneFound],
    kinds: Sequence[str] = tuple(QUIET),
) -> str:
    """``ends`` of the range that was examined and the present value ``here``, all dimensionless; ``kinds`` of
    zones that were looked for."""
    at = asked.text(here)
    holding = [zone for zone in zones if zone.lower.inner(1) <= here <= zone.upper.inner(-1)]
    own = min(holding, key=_rank, default=None)
    loud = own is not None and own.kind == DRIVE_SIDE_ONLY and IMPACT_FREE in kinds
    if not ends[0] <= here <= ends[1]:
        reach = asked.between(*(f"{asked.value(end):.6g}" for end in ends))
        first = [f"{at} lies outside the range that was examined, {reach}"]
    elif own is None:
        first = [f"{at} lies in no zone that was found"]
    else:
        span = _span(asked, own, here)
        where = f"no zone {QUIET[IMPACT_FREE]} that was found, only in one" if loud else "a zone"
        first = [f"{at} lies in {where} {QUIET[own.kind]} for {WHO[own.every]}: {span}"]
        if not own.every:
            first.append(_loud(own, here))
        first.append(_margins(asked, own, here))
    quiet = None if loud else own
    kind = quiet.kind if quiet is not None else IMPACT_FREE if loud else _first_kind(zones)
    others = [zone for zone in zones if zone is not own and zone.every and zone.kind == kind]
    if quiet is not None and quiet.every and not others:
        return "; ".join(first)
    return "; ".join([*first, _further(asked, others, kind, here, quiet)])


def _loud(own: ZoneFound, here: float) -> str:
    """What is not quiet at the present value, in a zone of only some motions."""
    at = [
        one.label
        for one in own.residents
        if not one.quiet and one.stable is not None and one.stable.lower <= here <= one.stable.upper
    ]
    if not at:
        return "what is not quiet was found elsewhere in it"
    return f"at this value {', '.join(dict.fromkeys(at))} was found as well, which is not"


@dataclass(frozen=True)
class Done:
    """How far a search came that was stopped: points computed of all, branches followed, and periodic motions
    whose branches were not."""

    reason: str
    computed: int
    points: int
    branches: int
    left: int


def until_stop(asked: Asked, here: float, zones: Sequence[ZoneFound], done: Done) -> str:
    """The sentence of a search that was stopped: where some motion is quiet, of those that were followed.
    Where every motion found is quiet is not known."""
    holding = [zone for zone in zones if zone.lower.inner(1) <= here <= zone.upper.inner(-1)]
    own = min(holding, key=_rank, default=None)
    if own is None:
        first = (
            f"{asked.text(here)} lies in no zone of a motion that was followed before the search was stopped"
        )
    else:
        first = (
            f"{asked.text(here)} lies in a zone {QUIET[own.kind]} for at least one attractor found before "
            f"the search was stopped: {_span(asked, own, here)}"
        )
    computed = f"{done.computed} of {done.points} points were computed"
    followed = f"{done.branches} {'branch was' if done.branches == 1 else 'branches were'} followed"
    left = f", {done.left} periodic motions were not" if done.left else ""
    told = f"{done.reason}: {computed}, {followed}{left}; where every attractor is quiet is not known"
    return f"{first}; {told}"


def _rank(zone: ZoneFound) -> tuple[bool, bool]:
    """What says most comes first."""
    return zone.kind != IMPACT_FREE, not zone.every


def _first_kind(zones: Sequence[ZoneFound]) -> str:
    kinds = [zone.kind for zone in zones if zone.every]
    return IMPACT_FREE if IMPACT_FREE in kinds or not kinds else kinds[0]


def _span(asked: Asked, zone: ZoneFound, here: float) -> str:
    low, high = asked.edge(zone.lower.inner(1), 1, here), asked.edge(zone.upper.inner(-1), -1, here)
    return asked.between(low, high) + (f" {ASSUMED_MARK}" if _marked(asked, zone) else "")


def _marked(asked: Asked, zone: ZoneFound) -> bool:
    """Whether an end that was computed rests on assumed values in this unit; what was typed rests on none."""
    ends = [end for end in (zone.lower, zone.upper) if end.kind not in NO_END]
    return bool(asked.unit) and any(p.rests_on for end in ends for p in end.physical)


def _margins(asked: Asked, zone: ZoneFound, here: float) -> str:
    """The events at its ends, where something happens there, and how far they are: the nearer one first."""
    ends: list[tuple[float, str]] = []
    for margin, end, inwards in ((zone.margin_below, zone.lower, 1), (zone.margin_above, zone.upper, -1)):
        if margin is not None:
            ends.append((margin.distance, f"{margin.event} {how_far(asked, margin, end, here, inwards)}"))
    if not ends:
        return "no end of it was met within the range"
    return "; ".join(text for _, text in sorted(ends))


def how_far(asked: Asked, margin: MarginFound, end: ZoneEnd, here: float, inwards: int) -> str:
    """Such as ``at 4114.1 rpm, 85.9 rpm (2.0 %) below``; ``inwards`` is +1 at a lower end, -1 at an upper."""
    share = "" if margin.percent is None else f" ({percent(margin.percent)} %)"
    side = "below" if (inwards > 0) == (asked.factor > 0.0) else "above"
    at = asked.with_unit(asked.edge(end.inner(inwards), inwards, here))
    return f"at {at}, {_apart(asked, here, end, inwards)}{share} {side}"


def _apart(asked: Asked, here: float, end: ZoneEnd, inwards: int) -> str:
    return asked.distance(here, end.inner(inwards), inwards)


def _further(asked: Asked, zones: Sequence[ZoneFound], kind: str, here: float, own: ZoneFound | None) -> str:
    """The other zones of the same kind for every attractor, the nearest first where the present value lies in
    none."""
    if not zones:
        return f"no interval was found in which {WHO[True]} is {QUIET[kind]}"
    spans = [_span(asked, zone, here) for zone in zones]
    if own is None:
        near = min(zones, key=lambda zone: max(zone.lower.value - here, here - zone.upper.value))
        at = zones.index(near)
        above = near.lower.value > here
        end, inwards = (near.lower, 1) if above else (near.upper, -1)
        apart = f"{_apart(asked, here, end, inwards)} {'above' if above else 'below'}"
        spans = [f"{spans[at]}, {apart}", *spans[:at], *spans[at + 1 :]]
        head, rest = f"nearest zone {QUIET[kind]} for {WHO[True]}: {spans[0]}", spans[1:]
        return f"{head}; others: {_listed(rest)}" if rest else head
    many = "zones" if len(spans) > 1 else "zone"
    also = "other " if own.every else ""
    return f"{also}{many} {QUIET[kind]} for {WHO[True]}: {_listed(spans)}"


def _listed(spans: Sequence[str]) -> str:
    left = len(spans) - MOST_ZONES
    return ", ".join(spans[:MOST_ZONES]) + (f" and {left} more" if left > 0 else "")
