"""The numbers of a run in physical units, and which of them rest on assumed values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from math import pi
from typing import Annotated, TypeVar

from gearlash.case import Case, Scales
from gearlash.results.impact_free import ImpactFree
from gearlash.results.physical import backlash_words

from .motion import Distances, ErrorNumbers, ForceNumbers, MotionNumbers, Span
from .parts import Rests, rests_on

R = TypeVar("R", Span, ForceNumbers, ErrorNumbers)


@dataclass(frozen=True)
class PhysicalEvent:
    """A contact event, in the order of those in ``numbers``."""

    time_ms: Annotated[float, "from phase zero"]
    velocity_mm_s: float
    force_N: float


@dataclass(frozen=True)
class SpeedWindow:
    """Speeds between which the motion of teeth that never part exists, whatever may coexist with it; null:
    not met within the search."""

    lower_rpm: float | None
    upper_rpm: float | None
    nearest_rpm: Annotated[
        float | None, "nearest speed found at which it exists, where it does not exist here"
    ]


@dataclass(frozen=True)
class PhysicalRun:
    """Numbers of a run in physical units; displacements, velocities and forces along the line of action."""

    pinion_speed_rpm: float
    mesh_frequency_Hz: float
    backlash_um: Annotated[float, "whole backlash b, at work"]
    backlash_name: Annotated[str, "backlash, or backlash at work where it is another one than stated"]
    torque_Nm: Annotated[float | None, "mean pinion torque; null where no radius is stated"]
    um_per_length: Annotated[float, "D_c: µm of one unit of X"]
    state_um_and_mm_s: Annotated[
        dict[str, float], "state by name: displacements in µm, velocities (′) in mm/s"
    ]
    distances_um: Distances
    events: tuple[PhysicalEvent, ...]
    force_N: ForceNumbers
    displacement_um: ErrorNumbers
    transmission_error_um: Annotated[
        ErrorNumbers | None, "rotation of both gears along the line of action, as in `numbers`"
    ]
    impact_free: SpeedWindow | None
    rests_on: Rests


def physical_run(
    case: Case,
    parameters: Mapping[str, float],
    state: Mapping[str, float],
    numbers: MotionNumbers,
    impact_free: ImpactFree | None,
) -> PhysicalRun:
    """Converts with the scales of the case, which must be physical."""
    scales, omega = case.scales, parameters["omega"]
    error, back_met = numbers.transmission_error, numbers.distances.back.minimum < 0.0
    return PhysicalRun(
        pinion_speed_rpm=float(scales.pinion_rpm(omega)),
        mesh_frequency_Hz=float(scales.mesh_hz(omega)),
        backlash_um=float(scales.backlash_um(parameters["D"])),
        backlash_name=backlash_words(case),
        torque_Nm=float(scales.torque(parameters["load"])) if scales.radii is not None else None,
        um_per_length=float(scales.length_um(1.0)),
        state_um_and_mm_s={name: _state(scales, name, value) for name, value in state.items()},
        distances_um=Distances(_um(scales, numbers.distances.drive), _um(scales, numbers.distances.back)),
        events=tuple(
            PhysicalEvent(
                time_ms=1e3 * float(scales.time_s(2.0 * pi * event.phase / omega)),
                velocity_mm_s=1e3 * float(scales.velocity(event.velocity)),
                force_N=float(scales.force_N(event.force)),
            )
            for event in numbers.events
        ),
        force_N=_scaled(numbers.force, float(scales.force_N(1.0))),
        displacement_um=_um(scales, numbers.displacement),
        transmission_error_um=error and _um(scales, error),
        impact_free=_window(scales, impact_free) if impact_free else None,
        rests_on=rests_on(case, back_met),
    )


def _state(scales: Scales, name: str, value: float) -> float:
    return 1e3 * float(scales.velocity(value)) if name.endswith("'") else float(scales.length_um(value))


def _um(scales: Scales, record: R) -> R:
    return _scaled(record, float(scales.length_um(1.0)))


def _scaled(record: R, unit: float) -> R:
    """Every number of a record times a unit."""
    return type(record)(**{f.name: unit * getattr(record, f.name) for f in fields(record)})


def _window(scales: Scales, found: ImpactFree) -> SpeedWindow:
    def rpm(omega: float | None) -> float | None:
        return None if omega is None else float(scales.pinion_rpm(omega))

    return SpeedWindow(rpm(found.lower), rpm(found.upper), rpm(found.nearest))
