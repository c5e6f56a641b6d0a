"""The numbers of one motion, dimensionless: distances, contacts, forces, transmission error."""

from __future__ import annotations

from dataclasses import dataclass
from math import isnan
from typing import TYPE_CHECKING, Annotated, Literal

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.orbits import Attractor, ForceStatistics, MotionStatistics
    from gearlash.system.readout import Readout

Side = Literal["drive", "back"]


@dataclass(frozen=True)
class Span:
    """Least and largest value over the motion, from its exact extrema."""

    minimum: float
    maximum: float


@dataclass(frozen=True)
class Distances:
    """Signed distance of X to each boundary of the gap, extremal over the motion."""

    drive: Annotated[Span, "X - D: positive in contact on the drive side"]
    back: Annotated[Span, "X + D⁻: negative in contact on the back side"]


@dataclass(frozen=True)
class ContactEvent:
    """One crossing of a boundary."""

    phase: Annotated[float, "mesh cycles from phase zero"]
    side: Side
    event: Annotated[Literal["engagement", "release"], "an engagement is an impact"]
    velocity: Annotated[float, "X′"]
    force: Annotated[float, "Φ; on a boundary that of damping alone, zero where contact ends with its force"]


@dataclass(frozen=True)
class ForceNumbers:
    """Of the contact force over the motion."""

    minimum: Annotated[float, "lowest value (peak); below 0: on the back side, or the damping pulls"]
    maximum: Annotated[float, "highest value (peak)"]
    peak_to_peak: Annotated[float, "largest minus least value"]
    mean: Annotated[float, "mean over time: the static load"]
    rms: Annotated[float, "root mean square of the whole force"]
    alternating_rms: Annotated[float, "root mean square about the mean"]


@dataclass(frozen=True)
class ErrorNumbers:
    """Of a displacement over the motion."""

    rms: Annotated[float, "root mean square about the mean"]
    peak_to_peak: Annotated[float, "largest minus least value"]


@dataclass(frozen=True)
class OtherClearance:
    """The motion in a further clearance."""

    name: str
    distances: Distances
    events: Annotated[tuple[ContactEvent, ...], "every contact event in these cycles"]
    force: ForceNumbers
    share_without_contact: Annotated[float, "share of time without contact there, 0 to 1"]


@dataclass(frozen=True)
class MotionNumbers:
    """Everything that is taken from the motion itself."""

    cycles: Annotated[
        float, "mesh cycles that all of this is taken over: P of an orbit, else a stretch of the motion"
    ]
    sides: Annotated[tuple[Side, ...], "sides of the gap that act"]
    distances: Distances
    events: Annotated[tuple[ContactEvent, ...], "every contact event in these cycles"]
    force: Annotated[ForceNumbers, "contact force Φ (over k_m D_c), positive in drive-side compression"]
    dynamic_factor: Annotated[
        float | None, "peak in the direction of the load over the mean contact force; null without load"
    ]
    displacement: Annotated[
        ErrorNumbers, "X, the displacement of the flanks along the line of action, over D_c"
    ]
    transmission_error: Annotated[
        ErrorNumbers | None,
        "rotation of both gears along the line of action, over D_c, as `report` and `compare` have it; null "
        "of other systems than gear pairs",
    ]
    share_without_contact: Annotated[float, "share of time with no tooth in contact, 0 to 1"]
    contact: Annotated[str, "when the contact damping acts: always, in-contact, no-tension"]
    others: Annotated[tuple[OtherClearance, ...], "further clearances; all else here is of the first"]


def motion_numbers(attractor: Attractor, error: Readout | None = None) -> MotionNumbers:
    """The numbers of an orbit, or of the stretch kept of another motion; ``error`` reads the transmission
    error of a gear pair."""
    from gearlash.orbits import motion_statistics

    gaps = attractor.propagators.system.clearances
    found, count = motion_statistics(attractor), len(gaps)
    acting: tuple[tuple[Side, int], ...] = (("drive", 1), ("back", -1))
    return MotionNumbers(
        cycles=attractor.trace.cycles,
        sides=tuple(side for side, boundary in acting if gaps[0].stops(boundary)),
        distances=_distances(attractor, 0, found),
        events=_events(attractor, 0),
        force=_force(found.force),
        dynamic_factor=_dynamic_factor(found.force),
        displacement=ErrorNumbers(found.error_rms, found.error_peak_to_peak),
        transmission_error=None if error is None else _error(attractor, error),
        share_without_contact=found.share_without_contact,
        contact=str(gaps[0].contact),
        others=tuple(_other(attractor, index) for index in range(1, count)),
    )


def _error(attractor: Attractor, error: Readout) -> ErrorNumbers:
    from gearlash.orbits.signals import signals

    (found,) = signals(attractor.trace, (error,)).read
    return ErrorNumbers(found.rms, found.peak_to_peak)


def _other(attractor: Attractor, index: int) -> OtherClearance:
    from gearlash.orbits import motion_statistics

    found = motion_statistics(attractor, index)
    return OtherClearance(
        name=attractor.propagators.system.clearances[index].name,
        distances=_distances(attractor, index, found),
        events=_events(attractor, index),
        force=_force(found.force),
        share_without_contact=found.share_without_contact,
    )


def _distances(attractor: Attractor, index: int, found: MotionStatistics) -> Distances:
    clearance = attractor.propagators.system.clearances[index]
    return Distances(
        Span(found.minimum - clearance.gap_plus, found.maximum - clearance.gap_plus),
        Span(found.minimum + clearance.gap_minus, found.maximum + clearance.gap_minus),
    )


def _dynamic_factor(force: ForceStatistics) -> float | None:
    return None if isnan(force.dynamic_factor) else force.dynamic_factor


def _force(force: ForceStatistics) -> ForceNumbers:
    return ForceNumbers(
        minimum=force.minimum,
        maximum=force.maximum,
        peak_to_peak=force.maximum - force.minimum,
        mean=force.mean,
        rms=force.rms,
        alternating_rms=force.alternating_rms,
    )


def _events(attractor: Attractor, index: int) -> tuple[ContactEvent, ...]:
    events = attractor.events.of(index)
    return tuple(
        ContactEvent(
            phase=float(events.phase[i]),
            side="drive" if events.boundary[i] > 0 else "back",
            event="engagement" if events.engaging[i] else "release",
            velocity=float(events.velocity[i]),
            force=float(events.force[i]),
        )
        for i in range(len(events))
    )
