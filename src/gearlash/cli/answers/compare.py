"""`gearlash compare`: a measurement beside what is computed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np

from gearlash.case import Case
from gearlash.case.units import pretty

from .asked import as_typed
from .parts import CaseUsed, case_used

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.case.measurement import Measurement
    from gearlash.studies.comparison import Comparison
    from gearlash.studies.measured_jumps import MeasuredJump

WORDS = {"up": "speed rising", "down": "speed falling", "both": "either way"}


@dataclass(frozen=True)
class ComparedSpeed:
    """One measured speed, in the units of the measurement."""

    speed: float
    measured: float
    up: Annotated[float | None, "computed with speed rising"]
    down: Annotated[float | None, "computed with speed falling"]
    label_up: str
    label_down: str
    residual: Annotated[
        float | None,
        "measured less computed with speed going the same way; less the nearer where that is open",
    ]
    direction: Annotated[str, "up or down, as the speed came there when it was measured; empty: not known"]
    residual_nearer: Annotated[float | None, "measured less the nearer of both"]


@dataclass(frozen=True)
class EventNear:
    """A change of the computed motion beside a measured jump."""

    kind: str
    direction: Annotated[str, "up, down or both: the way of speed on which it is met"]
    lower: float
    upper: float
    below: str
    above: str


@dataclass(frozen=True)
class JumpFound:
    """A jump of the measurement: much larger than most changes from one speed to the next."""

    lower: float
    upper: float
    change: Annotated[float, "upwards in speed"]
    direction: Annotated[
        str, "up or down: the way of the measured speeds there, as the rows stand; empty where they wander"
    ]
    events: Annotated[
        tuple[EventNear, ...],
        "within two usual steps of it; those of the same way of speed first, of these the nearest",
    ]


@dataclass(frozen=True)
class ComparedPeak:
    """Where a curve over speed is largest, and what the others have there."""

    curve: Annotated[str, "measured, or computed with speed rising (up) or falling (down)"]
    speed: float
    measured: float
    up: float | None
    down: float | None
    mesh_frequency: Annotated[float | None, "Hz, where the case has a unit of time"]


@dataclass(frozen=True)
class CompareAnswer:
    """A measurement over speed beside this pair (gearlash compare)."""

    sentence: str
    status: Annotated[str, "ok, or incomplete where the work was stopped"]
    message: str
    case: CaseUsed
    quantity: str
    figure: str
    order: Annotated[float | None, "of the mesh frequency, where one line was measured"]
    columns: Annotated[tuple[str, str], "names of the columns that were taken, of speed and value"]
    left_out: Annotated[int, "rows without speed or value"]
    speed_unit: str
    unit: str
    points: tuple[ComparedSpeed, ...]
    bias: Annotated[float | None, "mean of the residuals"]
    rms: Annotated[float | None, "root mean square of the residuals"]
    largest: Annotated[float | None, "residual of the largest modulus"]
    rms_nearer: Annotated[float | None, "root mean square of the residuals to the nearer of both"]
    peaks: Annotated[tuple[ComparedPeak, ...], "where what was measured and computed is largest"]
    span: Annotated[float, "from the least to the largest measured value"]
    jumps: tuple[JumpFound, ...]
    result: Literal["compare"] = "compare"


def compare_answer(case: Case, found: Comparison) -> CompareAnswer:
    """The record of a comparison, in the units of the measurement."""
    given = found.measurement
    size, speed = given.factor, given.speed_factor
    residuals = size * found.residuals
    nearer = size * found.nearer_residuals
    good, close = residuals[np.isfinite(residuals)], nearer[np.isfinite(nearer)]
    computed = zip(found.up, found.down, found.labels, strict=True)
    left = zip(residuals, nearer, found.directions, strict=True)
    points = tuple(
        ComparedSpeed(
            speed=as_typed(speed * float(omega)),
            measured=as_typed(size * float(value)),
            up=_known(size * up),
            down=_known(size * down),
            label_up=labels[0],
            label_down=labels[1],
            residual=_known(residual),
            direction=direction,
            residual_nearer=_known(close_by),
        )
        for omega, value, (up, down, labels), (residual, close_by, direction) in zip(
            found.omega, found.measured, computed, left, strict=True
        )
    )
    jumps = tuple(_jump(jump, speed, size) for jump in found.jumps)
    bias, rms, largest = (
        (float(good.mean()), float(np.sqrt(np.mean(good**2))), float(good[np.argmax(np.abs(good))]))
        if len(good)
        else (None, None, None)
    )
    span = size * float(np.ptp(found.measured))
    rms_nearer = float(np.sqrt(np.mean(close**2))) if len(close) else None
    return CompareAnswer(
        sentence=_sentence(given, points, (bias, rms, rms_nearer, span), jumps),
        status="ok" if found.complete else "incomplete",
        message=_message(found),
        case=case_used(case),
        quantity=given.quantity,
        figure=str(found.figure),
        order=found.order if found.figure == "order" else None,
        columns=given.columns,
        left_out=given.left_out,
        speed_unit=given.speed_unit,
        unit=given.unit,
        points=points,
        bias=bias,
        rms=rms,
        largest=largest,
        rms_nearer=rms_nearer,
        peaks=tuple(_peaks(case, found, points)),
        span=span,
        jumps=jumps,
    )


def _message(found: Comparison) -> str:
    """Why not all was computed, where that is so."""
    if found.complete:
        return ""
    reason = next((way.message for way in found.sweeps if way.message), "")
    return "stopped before all speeds were computed" + (f": {reason}" if reason else "")


def _peaks(case: Case, found: Comparison, points: tuple[ComparedSpeed, ...]) -> Iterator[ComparedPeak]:
    """One of every curve that has values; of both ways one where they agree."""
    from gearlash.results.pair_units import PairUnits

    known, physical = None, bool(PairUnits.of(case).time.name)
    for curve in ("measured", "up", "down"):
        values = np.array([getattr(point, curve) for point in points], dtype=np.float64)
        if not np.isfinite(values).any():
            continue
        at = int(np.nanargmax(values))
        point = points[at]
        if curve == "down" and known == (at, f"{point.down:.9g}"):
            continue
        known = (at, f"{values[at]:.9g}") if curve == "up" else None
        frequency = float(case.scales.mesh_hz(float(found.omega[at]))) if physical else None
        yield ComparedPeak(curve, point.speed, point.measured, point.up, point.down, frequency)


def _known(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def _jump(jump: MeasuredJump, speed: float, size: float) -> JumpFound:
    found: dict[tuple[str, str, str, str], EventNear] = {}
    for way, change in jump.events:
        labels = str(change.label_below), str(change.label_above)
        name = (change.kind, f"{change.lower:.9g}", *labels)
        known = found.get(name)
        direction = way if known is None or known.direction == way else "both"
        found[name] = EventNear(change.kind, direction, speed * change.lower, speed * change.upper, *labels)
    events = tuple(found.values())
    lower, upper = as_typed(speed * jump.lower), as_typed(speed * jump.upper)
    return JumpFound(lower, upper, size * jump.change, jump.direction, events)


def _sentence(
    given: Measurement,
    points: tuple[ComparedSpeed, ...],
    residual: tuple[float | None, float | None, float | None, float],
    jumps: tuple[JumpFound, ...],
) -> str:
    """Residuals first, then jumps."""
    bias, rms, rms_nearer, span = residual
    unit = f" {pretty(given.unit)}" if given.unit else ""
    reach = f"{points[0].speed:.6g} to {points[-1].speed:.6g} {pretty(given.speed_unit)}".strip()
    told = f"{len(points)} speeds from {reach}"
    if given.left_out:
        rows = "1 row" if given.left_out == 1 else f"{given.left_out} rows"
        told += f" ({rows} without speed or value left out)"
    if bias is None or rms is None or rms_nearer is None:
        return f"{told}: no motion that has this figure was found at any of them"
    part = f" ({100.0 * rms / span:.0f} % of the measured span)" if span > 0.0 else ""
    to = " to the motion computed with speed going the same way" if any(p.direction for p in points) else ""
    known = sum(point.residual is not None for point in points)
    at = f" at {known} of them" if known < len(points) else ""
    told += f": residual{at}{to} {rms:.3g}{unit} rms{part}, {bias:+.3g}{unit} on average"
    if to and f"{rms:.3g}" != f"{rms_nearer:.3g}":
        told += f" (to the nearer of both ways {rms_nearer:.3g}{unit})"
    if not to:
        told += ", to the nearer of both ways, as the rows do not say which way the speed went"
    if jumps:
        matched = sum(any(_goes_with(jump, event) for event in jump.events) for jump in jumps)
        told += (
            f"; {matched} of {len(jumps)} measured jumps lie at an event of the motion computed with speed "
            "going the same way"
        )
    return told


def _goes_with(jump: JumpFound, event: EventNear) -> bool:
    return not jump.direction or event.direction in (jump.direction, "both")
