"""`gearlash zones` over two parameters: the zone around the operating point, bounded by curves."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import isfinite
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case
from gearlash.case.edges import at_most
from gearlash.results.beside import Beside
from gearlash.system import Signature

from .asked import Asked
from .parts import CaseUsed, case_used, rests_in
from .sentence import coexisting

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.studies.plane_zone import AxisMargin, PlaneZone, ToleranceMargin

WORDS = {"impact-free": "free of impacts", "drive-side-only": "free of impacts on the back side"}
MARK = " †"  # behind a number in a physical unit that rests on an assumed value
STATUS = (
    "ok; incomplete if it was stopped; open if its border could not be closed everywhere: the notes say where"
)
Place = tuple[float, float]


@dataclass(frozen=True)
class PhysicalDistance:
    """A distance of a parameter in a physical unit."""

    name: str
    value: float
    unit: str


@dataclass(frozen=True)
class MarginAlong:
    """How far the operating point lies from where the zone ends along one parameter."""

    parameter: Annotated[str, "short name"]
    upward: bool
    distance: Annotated[float, "dimensionless"]
    asked: Annotated[float, "in the unit that was asked for"]
    percent: Annotated[float | None, "of the value; null where that is zero"]
    physical: tuple[PhysicalDistance, ...]
    value: Annotated[float, "of the parameter where the zone ends, dimensionless"]
    event: Annotated[str, "what happens there"]
    bounded: Annotated[bool, "false where only the range ends: the margin is at least this"]


@dataclass(frozen=True)
class MarginTogether:
    """By what all tolerances can be multiplied before the boundary is touched."""

    norm: Annotated[
        str, "box: each parameter anywhere within its tolerance; ellipse: root of the sum of squares"
    ]
    multiple: float
    values: Annotated[tuple[float, float], "of the two parameters where it is touched, dimensionless"]
    asked: Annotated[tuple[float, float], "the same in the units that were asked for"]
    event: str
    bounded: Annotated[bool, "false where the range ends first: the multiple is at least this"]


@dataclass(frozen=True)
class Boundary:
    """A piece of a curve that bounds the zone."""

    kind: str
    event: str
    values: Annotated[tuple[tuple[float, float], ...], "of the orbits that were solved for, dimensionless"]


@dataclass(frozen=True)
class TakingOver:
    """Where one curve of the boundary takes over from another."""

    kind: str
    values: tuple[float, float]


@dataclass(frozen=True)
class PlaneZoneAnswer:
    """The zone around an operating point in a plane (gearlash zones with two --over)."""

    sentence: str
    status: Annotated[str, STATUS]
    notes: Annotated[tuple[str, ...], "what is missing, and why"]
    case: CaseUsed
    parameters: Annotated[dict[str, float], "every parameter by short name, at the operating point"]
    names: Annotated[tuple[str, str], "short names of the two parameters"]
    asked: Annotated[tuple[Asked, Asked], "the units in which they are told"]
    rests_on: Annotated[tuple[tuple[str, ...], ...], "assumed values behind computed values in either unit"]
    at: Annotated[tuple[float, float], "the operating point"]
    lower: tuple[float, float]
    upper: tuple[float, float]
    kind: Annotated[str, "impact-free or drive-side-only"]
    label: Annotated[str, "of the orbit at the operating point"]
    beside: Annotated[
        Beside | None, "what a few other starts lead to at the operating point; null: not looked for"
    ]
    margins: tuple[MarginAlong, ...]
    tolerances: Annotated[tuple[float, ...], "dimensionless; empty where none were stated"]
    together: tuple[MarginTogether, ...]
    boundary: tuple[Boundary, ...]
    special: tuple[TakingOver, ...]
    outline: Annotated[tuple[tuple[float, float], ...], "the border, counter-clockwise, rectangle included"]
    holes: tuple[tuple[tuple[float, float], ...], ...]
    lines: Annotated[int, "straight lines along which the orbit was followed"]
    places: Annotated[int, "places on them at which it was solved for"]
    held: Annotated[tuple[str, ...], "what is taken to be the same in all of it, although it may not be"] = ()
    result: Literal["plane_zone"] = "plane_zone"


def plane_zone_answer(
    case: Case, zone: PlaneZone, beside: Beside | None, asked: tuple[Asked, Asked], stopped: bool
) -> PlaneZoneAnswer:
    """The record of a zone; ``beside``: what other starts lead to at the operating point; ``stopped``: by a
    signal."""
    margins = tuple(_along(margin, asked[zone.names.index(margin.name)]) for margin in zone.margins)
    together = tuple(_together(margin, asked) for margin in zone.tolerance_margins)
    rests = tuple(
        rests_in(case, name, each.name, each.unit) for name, each in zip(zone.names, asked, strict=True)
    )
    return PlaneZoneAnswer(
        sentence=_sentence(zone, beside, asked, margins, together, rests),
        status="incomplete" if stopped else "ok" if zone.complete else "open",
        notes=zone.notes,
        case=case_used(case),
        parameters=dict(zone.values),
        names=zone.names,
        held=tuple(filter(None, map(case.held, zone.names))),
        asked=asked,
        rests_on=rests,
        at=zone.at,
        lower=zone.lower,
        upper=zone.upper,
        kind=str(zone.quiet),
        label=str(zone.label),
        beside=beside,
        margins=margins,
        tolerances=zone.tolerances,
        together=together,
        boundary=tuple(Boundary(str(p.kind), p.event, _places(p.values)) for p in zone.parts),
        special=tuple(TakingOver(str(each.kind), each.values) for each in zone.special),
        outline=_places(zone.outline),
        holes=tuple(map(_places, zone.holes)),
        lines=zone.lines,
        places=len(zone.followed),
    )


def _places(values: Iterable[Iterable[float]]) -> tuple[Place, ...]:
    return tuple((float(x), float(y)) for x, y in values)


def _along(margin: AxisMargin, asked: Asked) -> MarginAlong:
    return MarginAlong(
        margin.name,
        margin.upward,
        margin.distance,
        abs(asked.value(margin.distance)),
        margin.percent if isfinite(margin.percent) else None,
        tuple(PhysicalDistance(*each) for each in margin.physical),
        margin.value,
        margin.event,
        margin.bounded,
    )


def _together(margin: ToleranceMargin, asked: tuple[Asked, Asked]) -> MarginTogether:
    there = (asked[0].value(margin.values[0]), asked[1].value(margin.values[1]))
    return MarginTogether(margin.norm, margin.multiple, margin.values, there, margin.event, margin.bounded)


def how_far(margin: MarginAlong, asked: Asked, here: float) -> str:
    """``248 rpm (6.2 %) above``: never farther than the zone reaches, see `Asked.distance`."""
    far = asked.distance(here, margin.value, -1 if margin.upward else 1)
    share = "" if margin.percent is None else f" ({at_most(margin.percent, 3)} %)"
    side = "above" if margin.upward == (asked.factor > 0.0) else "below"
    return f"{far}{share} {side}"


def times(margin: MarginTogether) -> str:
    """``3.71 times``."""
    return f"{'' if margin.bounded else 'at least '}{at_most(margin.multiple, 4)} times"


def _sentence(
    zone: PlaneZone,
    beside: Beside | None,
    asked: tuple[Asked, Asked],
    margins: tuple[MarginAlong, ...],
    together: tuple[MarginTogether, ...],
    rests: tuple[tuple[str, ...], ...],
) -> str:
    here = ", ".join(unit.text(value) for unit, value in zip(asked, zone.at, strict=True))
    quiet, motion = WORDS[str(zone.quiet)], f"of the motion {zone.label} that was followed"
    if isinstance(zone.label, Signature) and zone.label.drive:
        where = f"no zone free of impacts {motion}, which hits the drive side, only in one {quiet}"
    else:
        where = f"a zone {quiet}, {motion}"
    said = [f"{here} lies in {where}; there {coexisting(beside, zone.label)}"]
    met = [margin for margin in margins if margin.bounded]
    for margin in met:
        which = zone.names.index(margin.parameter)
        far = how_far(margin, asked[which], zone.at[which])
        said.append(f"{asked[which].title}: {margin.event} {far}{MARK if rests[which] else ''}")
    if not met:
        said.append("nothing bounds it along either parameter within the range")
    for margin in together[:1]:
        if margin.bounded:
            mark = MARK if any(rests) else ""
            said.append(f"the tolerances together fit into it {times(margin)} ({margin.norm}){mark}")
        else:
            multiple = at_most(margin.multiple, 4)
            said.append(f"the range ends at {multiple} times the tolerances together ({margin.norm})")
    return "; ".join(said)
