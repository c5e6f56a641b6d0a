"""`gearlash sweep`: how the motion changes with one parameter."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case
from gearlash.system import MotionKind, Status, label_text

from .asked import Asked
from .excitation import Unexcited, idle_study
from .outcome import POINTS, study_status, troubles
from .parts import CaseUsed, PhysicalValue, case_used, physical_values

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.results import Axis, Point, Sweep


START = "state that cold points, and the first up and down, started from (--initial); null: the cold start"


@dataclass(frozen=True)
class AxisUsed:
    """The swept parameter."""

    name: Annotated[str, "short name; its values are dimensionless"]
    named: Annotated[str, "as it was typed, or the quantity that its unit means"]
    lower: float
    upper: float
    count: int
    physical_lower: tuple[PhysicalValue, ...]
    physical_upper: tuple[PhysicalValue, ...]
    asked: Annotated[Asked, "the unit that sentences and tables tell values in"]
    held: Annotated[str, "what is taken to be the same all along it, although it may not be"] = ""


@dataclass(frozen=True)
class Regime:
    """A maximal stretch of neighbouring points with one label; they need not be one orbit: it may jump to
    another of the same label in between (`gearlash.transitions` looks for that)."""

    label: str
    first: Annotated[float, "value of its first point"]
    last: Annotated[float, "value of its last point"]
    points: int


@dataclass(frozen=True)
class SweepPoint:
    """One attractor; sections and states are in the NetCDF file of --out."""

    value: float
    status: str
    label: Annotated[str, "P-Q-R (/Q-R of every further clearance), aperiodic, neutral, unresolved, or empty"]
    certificate: Annotated[str, "certified, uncertain or failed; empty where nothing was computed"]
    certificate_reason: Annotated[str, "why it is not certified"]
    largest_exponent: Annotated[float | None, "per unit of τ"]
    exponent_error: float | None
    multiplier_modulus: Annotated[float | None, "of the leading Floquet multiplier"]
    minimum: Annotated[float | None, "least X"]
    maximum: Annotated[float | None, "largest X"]
    force_maximum: Annotated[float | None, "largest contact force Φ (peak)"]
    force_rms: Annotated[float | None, "root mean square of Φ"]
    share_without_contact: Annotated[float | None, "share of time, 0 to 1"]


@dataclass(frozen=True)
class SweepWay:
    """One direction."""

    direction: Annotated[
        Literal["cold", "up", "down"], "every point from the cold start, or followed from its neighbour"
    ]
    complete: bool
    message: Annotated[str, "why it is not complete"]
    regimes: tuple[Regime, ...]
    points: Annotated[tuple[SweepPoint, ...], "those computed, in ascending order of the value"]


@dataclass(frozen=True)
class SweepAnswer:
    """Attractors along one parameter (gearlash sweep)."""

    sentence: str
    status: Annotated[str, POINTS]
    case: CaseUsed
    parameters: Annotated[dict[str, float], "every parameter but the swept one, by short name"]
    axis: AxisUsed
    start: Annotated[dict[str, float] | None, START]
    statuses: Annotated[dict[Status, int], "number of points by status, all directions together"]
    certificates: Annotated[dict[str, int], "number of points certified, uncertain, failed"]
    coexisting: Annotated[
        tuple[tuple[float, float], ...], "intervals in which directions found different attractors"
    ]
    sweeps: tuple[SweepWay, ...]
    result: Literal["sweep"] = "sweep"


def sweep_answer(
    case: Case,
    parameters: Mapping[str, float],
    named: str,
    sweeps: Sequence[Sweep],
    unit: str = "",
    start: Mapping[str, float] | None = None,
) -> SweepAnswer:
    """The record of sweeps over one axis; ``named`` is the parameter as typed, ``unit`` what it was typed in,
    ``start`` the state that was given to start from, by name."""
    from gearlash.results import coexisting

    axis = sweeps[0].axis
    used = axis_used(case, axis, named, unit)
    statuses = Counter(point.status for sweep in sweeps for point in sweep.points)
    complete = all(sweep.complete for sweep in sweeps)
    idle = idle_study(case, parameters, [axis])
    beside = _intervals(axis, map(bool, coexisting(sweeps))) if len(sweeps) > 1 else ()
    return SweepAnswer(
        sentence=_sentence(used, sweeps, statuses, beside, idle),
        status=study_status(complete, statuses, idle),
        case=case_used(case),
        parameters={name: value for name, value in parameters.items() if name != axis.name},
        axis=used,
        start=None if start is None else dict(start),
        statuses=dict(statuses),
        certificates=dict(sum((Counter(sweep.certificates) for sweep in sweeps), Counter())),
        coexisting=beside,
        sweeps=tuple(_way(sweep) for sweep in sweeps),
    )


def axis_used(case: Case, axis: Axis, named: str, unit: str = "") -> AxisUsed:
    """The axis with what its ends mean physically; what was typed rests on nothing."""
    ends = float(axis.values[0]), float(axis.values[-1])
    typed = named.rpartition(".")[2]
    physical = [
        tuple(
            replace(p, rests_on=()) if p.name == typed else p
            for p in physical_values(case, axis.name, end, computed=False)
        )
        for end in ends
    ]
    asked = Asked.of(case, axis.name, named, unit)
    return AxisUsed(
        axis.name, named, ends[0], ends[1], len(axis), physical[0], physical[1], asked, case.held(axis.name)
    )


def _way(sweep: Sweep) -> SweepWay:
    values = sweep.axis.values
    regimes = (
        Regime(str(label), float(values[i]), float(values[j]), j - i + 1) for i, j, label in sweep.runs()
    )
    points = tuple(_point(point) for point in sweep.points if point.status is not Status.NOT_COMPUTED)
    return SweepWay(sweep.direction.value, sweep.complete, sweep.message, tuple(regimes), points)


def _point(p: Point) -> SweepPoint:
    return SweepPoint(
        value=p.value,
        status=p.status,
        label=label_text(p.label),
        certificate=p.certificate,
        certificate_reason=p.certificate_reason,
        largest_exponent=p.largest_exponent,
        exponent_error=p.exponent_error,
        multiplier_modulus=abs(p.leading),
        minimum=p.minimum,
        maximum=p.maximum,
        force_maximum=p.force_max,
        force_rms=p.force_rms,
        share_without_contact=p.share_without_contact,
    )


def _intervals(axis: Axis, flags: Iterable[bool]) -> tuple[tuple[float, float], ...]:
    """First and last value of every run of True."""
    found: list[tuple[float, float]] = []
    before = False
    for value, flag in zip(map(float, axis.values), flags, strict=True):
        if flag and before:
            found[-1] = (found[-1][0], value)
        elif flag:
            found.append((value, value))
        before = bool(flag)
    return tuple(found)


def first_failure(asked: Asked, sweeps: Sequence[Sweep]) -> str:
    """Where the first point failed, and why."""
    failed = (point for sweep in sweeps for point in sweep.points if point.status is Status.FAILED)
    return next((f"{asked.text(point.value)}, {point.message}" for point in failed), "")


def _sentence(
    axis: AxisUsed,
    sweeps: Sequence[Sweep],
    statuses: Mapping[Status, int],
    beside: Sequence[tuple[float, float]],
    idle: Unexcited | None,
) -> str:
    ends = axis.asked.span(axis.lower, axis.upper)
    ways = ", ".join(str(sweep.direction) for sweep in sweeps)
    if idle is not None:
        return f"{ends}: {idle.cause}; {idle.advice}"
    labels = {point.label for sweep in sweeps for point in sweep.points if point.periodic}
    many = f"{len(labels)} different signatures" if len(labels) != 1 else "1 signature"
    text = f"{ends}, {axis.count} values, {ways}: {many}"
    if any(point.label is MotionKind.APERIODIC for sweep in sweeps for point in sweep.points):
        text += " and aperiodic motion"
    if beside:
        text += f", attractors coexist in {len(beside)} interval{'s' if len(beside) > 1 else ''}"
    missing = statuses.get(Status.NOT_COMPUTED, 0)
    trouble = troubles(statuses, first_failure(axis.asked, sweeps))
    if trouble:
        text += f"; {trouble}"
    return f"{text}; incomplete, {missing} points missing" if missing else text
