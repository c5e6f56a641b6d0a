"""`gearlash verify`: the lumped model beside bodies in space with real teeth."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np

from gearlash.case import Case

from .outcome import FAILED, INCOMPLETE, OK, PARTLY_FAILED, RESUME
from .parts import CaseUsed, case_used
from .verify_words import label_of, sentence

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.studies.verification import Compared, LumpedPoint, Mesh, PointFound, Setting, Verification


OTHERWISE = "motions that are here stand as they are; compare at another speed (--speed)"
"""What to do where a motion could not be integrated."""


@dataclass(frozen=True)
class MeshComputed:
    """What real teeth of one face width give."""

    face_width: Annotated[float, "mm"]
    stiffness: Annotated[float, "mean over the mesh cycle, N/m"]
    ripples: Annotated[
        tuple[float, ...], "amplitudes of the mesh orders 1, 2, 3 of the stiffness over its mean"
    ]
    transmission_error: Annotated[float, "of perfect flanks under the torque, peak to peak, µm"]
    errors_under_load: Annotated[
        tuple[float, ...],
        "what flanks without error make beside their stiffness under the torque (by relief, crowning, "
        "contact beyond the path of contact): amplitudes of the mesh orders 1, 2, 3, µm",
    ]
    transverse_contact_ratio: float
    overlap_ratio: float
    total_contact_ratio: Annotated[float, "mean number of pairs of teeth that carry under the torque"]
    backlash: Annotated[float, "normal, that the flanks leave, µm"]
    torque: Annotated[float, "of the pinion, N m, at which these were computed"]


@dataclass(frozen=True)
class FrameComputed:
    """Where both gears are at one time of the last mesh cycle."""

    phase: Annotated[float, "of that cycle"]
    turns: Annotated[tuple[float, float], "of pinion and gear, rad, less whole pitches"]
    forces: Annotated[tuple[float, float], "normal, of the drive side and of the back side, N"]


@dataclass(frozen=True)
class BreathingComputed:
    """What the centre distance does in a motion: least and greatest over time, and what follows."""

    omega: Annotated[float, "mesh frequency over √(k/m_e) of the multibody mesh"]
    centre_distance: Annotated[tuple[float, float], "change at mid face, µm"]
    contact_ratio: Annotated[tuple[float, float], "transverse, of the geometry"]
    backlash: Annotated[tuple[float, float], "normal, µm"]
    label_held: Annotated[str, "with the centre distance held; empty where that was not computed"]
    peak_share: Annotated[
        float | None,
        "greatest force less that with the centre distance held, over the latter; null where that was not "
        "computed",
    ]


@dataclass(frozen=True)
class PointComputed:
    """A motion of the multibody model."""

    omega: Annotated[float, "mesh frequency over √(k/m_e) of the multibody mesh"]
    speed: Annotated[float, "of the pinion, rpm"]
    setting: Annotated[str, "what sets it apart from the planned one"]
    label: Annotated[
        str,
        "P-Q-R, with as many impacts in every period; where the motion does not come back within 8 mesh "
        "cycles, `kept` if teeth stayed in contact, `none` otherwise; `uneven` where teeth part and the mean "
        "forces come back, but not as many impacts in every period",
    ]
    apart: Annotated[float, "share of time in which no tooth carries"]
    impacts: Annotated[float, "beginnings of contact of the drive side a mesh cycle"]
    back_impacts: Annotated[float, "of the back side a mesh cycle"]
    least_force: Annotated[float, "of the drive side, N"]
    mean_force: Annotated[float, "N"]
    greatest_force: Annotated[float, "N"]
    orders: Annotated[tuple[float, ...], "amplitudes of the force at mesh orders 1/2, 1, 3/2, … 8, N"]
    returns: Annotated[
        float,
        "how far the motion misses itself after a period: mean forces of every 1/64 of a mesh cycle, over "
        "the range of these means",
    ]
    energy_residual: Annotated[float, "missing in the balance of energy, over what dampers take"]
    settled: Annotated[int, "mesh cycles before those that were read"]
    settle_steps: Annotated[int, "of the integrator, a mesh cycle, before the cycles that were read"]
    read_steps: Annotated[int, "of the integrator, a mesh cycle, in the cycles that were read"]
    phase: Annotated[tuple[float, ...], "mesh cycles"]
    force: Annotated[tuple[float, ...], "over these phases, drive side less back side, N"]
    frames: tuple[FrameComputed, ...]


@dataclass(frozen=True)
class LumpedComputed:
    """A motion of the lumped model at the same inputs."""

    omega: float
    rule: Annotated[str, "contact rule"]
    label: Annotated[str, "P-Q-R, or what the motion is"]
    apart: Annotated[float | None, "share of time without contact"]
    phase: Annotated[tuple[float, ...], "mesh cycles"]
    force: Annotated[tuple[float, ...], "over these phases, over the mean contact force"]
    orders: Annotated[tuple[float, ...], "of the mesh frequency, up to 8; empty without a period"]
    amplitudes: Annotated[tuple[float, ...], "of the force at these orders, over the mean contact force"]


@dataclass(frozen=True)
class WindowComputed:
    """Labels over speed, from both directions."""

    omega: tuple[float, ...]
    speed: Annotated[tuple[float, ...], "of the pinion, rpm"]
    up: Annotated[tuple[str, ...], "multibody model, speed rising"]
    down: Annotated[tuple[str, ...], "multibody model, speed falling"]
    lumped_up: Annotated[dict[str, tuple[str, ...]], "lumped model by contact rule, speed rising"]
    lumped_down: Annotated[dict[str, tuple[str, ...]], "speed falling"]


@dataclass(frozen=True)
class ConfigurationCompared:
    """One way to hold the inputs of both models against each other."""

    name: str
    held: str
    numbers: Annotated[dict[str, float], "dimensionless numbers that are held or not"]
    face_width: Annotated[float, "mm"]
    stiffness: Annotated[float, "mean, of these teeth, N/m"]
    torque: Annotated[float, "N m"]
    error: Annotated[float, "half the peak to peak of the error on the flanks, µm"]
    error_harmonics: Annotated[
        tuple[tuple[float, float], ...],
        "of the error on the flanks, mesh orders 1, 2, …: amplitude, µm, and phase, rad, in the mesh phase "
        "of the multibody model",
    ]
    points: tuple[PointComputed, ...]
    beside: Annotated[tuple[PointComputed, ...], "with one setting changed each"]
    breathing: Annotated[
        tuple[BreathingComputed, ...], "at each speed; empty where bearings hold the centre distance"
    ]
    lumped: tuple[LumpedComputed, ...]
    window: WindowComputed


@dataclass(frozen=True)
class VerifyAnswer:
    """The lumped model beside bodies in space with real teeth (gearlash verify)."""

    sentence: str
    status: Annotated[
        str,
        "ok; incomplete if it was stopped; partly-failed if a motion could not be integrated, failed if none "
        "as planned could",
    ]
    message: str
    advice: str
    case: CaseUsed
    inputs: Annotated[dict[str, str], "what both models were given, fixed before anything was computed"]
    settings: Annotated[tuple[dict[str, str], ...], "every setting that was tried"]
    meshes: tuple[MeshComputed, ...]
    stated: Annotated[tuple[LumpedComputed, ...], "the case as it is, with the stiffness that it states"]
    configurations: tuple[ConfigurationCompared, ...]
    result: Literal["verify"] = "verify"


def verify_answer(case: Case, found: Verification) -> VerifyAnswer:
    """The record of a verification."""
    said = [*found.failures, *([f"stopped: {found.reason}"] if found.reason else [])]
    configurations = tuple(_configuration(found, one) for one in found.compared)
    return VerifyAnswer(
        sentence=sentence(found),
        status=_status(found),
        message="; ".join(said),
        advice=_advice(found),
        case=case_used(case),
        inputs=_inputs(found),
        settings=tuple(one.told() for one in _settings(found)),
        meshes=tuple(_mesh(mesh) for mesh in found.meshes),
        stated=tuple(map(_lumped, found.stated)),
        configurations=configurations,
    )


def _status(found: Verification) -> str:
    """Of all motions of real teeth."""
    if found.reason:
        return INCOMPLETE
    if not found.failures:
        return OK
    return PARTLY_FAILED if any(one.points for one in found.compared) else FAILED


def _advice(found: Verification) -> str:
    """What to do where motions are missing; the same motions fail in a second call."""
    if found.reason:
        return RESUME
    return OTHERWISE if found.failures else ""


def _settings(found: Verification) -> list[Setting]:
    """Each that was planned anywhere, once."""
    plan = found.plan
    every = [each for one in found.compared for each in plan.settings_of(one.configuration)]
    return list(dict.fromkeys([plan.planned, plan.window, *every]))


def _inputs(found: Verification) -> dict[str, str]:
    inputs = found.inputs
    told = {each.name: str(getattr(inputs, each.name)) for each in fields(inputs) if each.name != "pair"}
    for name, gear in (("pinion", inputs.pair.pinion), ("gear", inputs.pair.gear)):
        told |= {f"{name}.{each.name}": str(getattr(gear, each.name)) for each in fields(gear)}
    return told | {"centre_distance": str(inputs.pair.centre_distance)}


def _mesh(mesh: Mesh) -> MeshComputed:
    return MeshComputed(
        face_width=mesh.width * 1e3,
        stiffness=mesh.stiffness,
        ripples=mesh.ripples,
        transmission_error=float(np.ptp(mesh.static.transmission_error)) * 1e6,
        errors_under_load=tuple(abs(each) * 1e6 for each in mesh.static_errors),
        transverse_contact_ratio=mesh.pair.transverse_contact_ratio,
        overlap_ratio=mesh.pair.overlap_ratio,
        torque=mesh.static.torque,
        total_contact_ratio=mesh.static.total_contact_ratio,
        backlash=mesh.static.backlash * 1e6,
    )


def _configuration(found: Verification, one: Compared) -> ConfigurationCompared:
    held = one.configuration
    rpm = [found.inputs.rpm(float(omega), held.stiffness) for omega in one.window_omegas]
    return ConfigurationCompared(
        name=held.name,
        held=held.told,
        numbers=held.numbers(found.inputs),
        face_width=held.width * 1e3,
        stiffness=held.stiffness,
        torque=held.torque,
        error=held.error * 1e6,
        error_harmonics=tuple((amplitude * 1e6, phase) for amplitude, phase in one.errors),
        points=tuple(map(_point, one.points)),
        beside=tuple(map(_point, one.beside)),
        breathing=_breathing(found, one),
        lumped=tuple(map(_lumped, one.lumped)),
        window=WindowComputed(
            omega=tuple(map(float, one.window_omegas)),
            speed=tuple(rpm),
            up=_labels(one.up, one.window_omegas),
            down=_labels(one.down, one.window_omegas),
            lumped_up={str(rule): labels[0] for rule, labels in one.lumped_window.items()},
            lumped_down={str(rule): labels[1] for rule, labels in one.lumped_window.items()},
        ),
    )


def _lumped(point: LumpedPoint) -> LumpedComputed:
    return LumpedComputed(
        point.omega,
        str(point.rule),
        point.label,
        point.apart,
        tuple(map(float, point.phase)),
        tuple(map(float, point.force)),
        tuple(map(float, point.order)),
        tuple(map(float, point.amplitude)),
    )


def _breathing(found: Verification, one: Compared) -> tuple[BreathingComputed, ...]:
    """At each speed, beside the motion with the centre distance held."""
    from gearlash.studies.verification import DISTANCE_HELD, breathing_of, with_width

    if found.inputs.bearing_y is None:
        return ()
    pair = with_width(found.inputs, one.configuration.width).pair
    held = {p.omega: p for p in one.beside if p.setting == DISTANCE_HELD.name}
    told = []
    for point in one.points:
        moved, beside = breathing_of(pair, point.centre_change), held.get(point.omega)
        told.append(
            BreathingComputed(
                omega=point.omega,
                centre_distance=_in_um(moved.change),
                contact_ratio=moved.contact_ratio,
                backlash=_in_um(moved.backlash),
                label_held="" if beside is None else label_of(beside),
                peak_share=None if beside is None else point.reading.most / beside.reading.most - 1.0,
            )
        )
    return tuple(told)


def _in_um(ends: tuple[float, float]) -> tuple[float, float]:
    return ends[0] * 1e6, ends[1] * 1e6


def _labels(points: tuple[PointFound, ...], omegas: object) -> tuple[str, ...]:
    known = {p.omega: label_of(p) for p in points}
    return tuple(known.get(float(omega), "not computed") for omega in omegas)  # pyright: ignore[reportGeneralTypeIssues]


def _point(point: PointFound) -> PointComputed:
    reading = point.reading
    return PointComputed(
        omega=point.omega,
        speed=point.rpm,
        setting=point.setting,
        label=label_of(point),
        apart=reading.apart,
        impacts=reading.drive_impacts / reading.cycles,
        back_impacts=reading.back_impacts / reading.cycles,
        least_force=reading.least,
        mean_force=reading.mean,
        greatest_force=reading.most,
        orders=tuple(map(float, reading.orders)),
        returns=reading.returns,
        energy_residual=point.energy_residual,
        settled=point.settled,
        settle_steps=point.settle_steps,
        read_steps=point.read_steps,
        phase=tuple(map(float, reading.phase)),
        force=tuple(map(float, reading.force)),
        frames=tuple(
            FrameComputed(float(phase), (float(turns[0]), float(turns[1])), (float(push[0]), float(push[1])))
            for phase, turns, push in zip(
                point.frames.phase, point.frames.turns, point.frames.forces, strict=True
            )
        ),
    )
