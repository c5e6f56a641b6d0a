"""`gearlash verify`: the lumped model beside bodies in space with real teeth."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case

from .outcome import INCOMPLETE, OK, RESUME
from .parts import CaseUsed, case_used

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.studies.verification import Compared, Mesh, PointFound, Verification

FIRST = "always"
"""The contact rule of the lumped model that the sentence compares with where the case has no other."""


@dataclass(frozen=True)
class MeshComputed:
    """What real teeth of one face width give."""

    face_width: Annotated[float, "mm"]
    stiffness: Annotated[float, "mean over the mesh cycle, N/m"]
    ripples: Annotated[
        tuple[float, ...], "amplitudes of the mesh orders 1, 2, 3 of the stiffness over its mean"
    ]
    transmission_error: Annotated[float, "of perfect flanks under the torque, peak to peak, um"]
    transverse_contact_ratio: float
    overlap_ratio: float
    torque: Annotated[float, "of the pinion, N m, at which these were computed"]


@dataclass(frozen=True)
class PointComputed:
    """A motion of the multibody model."""

    omega: Annotated[float, "mesh frequency over √(k/m_e) of the multibody mesh"]
    speed: Annotated[float, "of the pinion, rpm"]
    setting: Annotated[str, "what sets it apart from the planned one"]
    label: Annotated[str, "P-Q-R; `none` where the motion does not come back within 8 mesh cycles"]
    apart: Annotated[float, "share of time in which no tooth carries"]
    impacts: Annotated[float, "beginnings of contact of the drive side a mesh cycle"]
    back_impacts: Annotated[float, "of the back side a mesh cycle"]
    least_force: Annotated[float, "of the drive side, N"]
    mean_force: Annotated[float, "N"]
    greatest_force: Annotated[float, "N"]
    orders: Annotated[tuple[float, ...], "amplitudes of the force at mesh orders 1/2, 1, 3/2, … 8, N"]
    returns: Annotated[float, "how far the motion misses itself after a period, over the range of its force"]
    energy_residual: Annotated[float, "missing in the balance of energy, over what dampers take"]
    phase: Annotated[tuple[float, ...], "mesh cycles"]
    force: Annotated[tuple[float, ...], "over these phases, drive side less back side, N"]


@dataclass(frozen=True)
class LumpedComputed:
    """A motion of the lumped model at the same inputs."""

    omega: float
    rule: Annotated[str, "contact rule"]
    label: Annotated[str, "P-Q-R, or what the motion is"]
    apart: Annotated[float | None, "share of time without contact"]


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
    torque: Annotated[float, "N m"]
    error: Annotated[float, "zero to peak, um"]
    error_phase: Annotated[float, "rad, in the mesh phase of the multibody model"]
    points: tuple[PointComputed, ...]
    beside: Annotated[tuple[PointComputed, ...], "with one setting changed each"]
    lumped: tuple[LumpedComputed, ...]
    window: WindowComputed


@dataclass(frozen=True)
class VerifyAnswer:
    """The lumped model beside bodies in space with real teeth (gearlash verify)."""

    sentence: str
    status: Annotated[str, "ok, or incomplete where the work was stopped or a point could not be integrated"]
    message: str
    advice: str
    case: CaseUsed
    inputs: Annotated[dict[str, str], "what both models were given, fixed before anything was computed"]
    settings: Annotated[tuple[dict[str, str], ...], "every setting that was tried"]
    meshes: tuple[MeshComputed, ...]
    configurations: tuple[ConfigurationCompared, ...]
    result: Literal["verify"] = "verify"


def verify_answer(case: Case, found: Verification) -> VerifyAnswer:
    """The record of a verification."""
    complete = not found.reason and not found.failures
    said = [*found.failures, *([f"stopped: {found.reason}"] if found.reason else [])]
    configurations = tuple(_configuration(found, one) for one in found.compared)
    plan = found.plan
    return VerifyAnswer(
        sentence=_sentence(case, configurations),
        status=OK if complete else INCOMPLETE,
        message="; ".join(said),
        advice="" if complete else RESUME,
        case=case_used(case),
        inputs=_inputs(found),
        settings=tuple(one.told() for one in (plan.planned, plan.window, *plan.beside)),
        meshes=tuple(_mesh(mesh) for mesh in found.meshes),
        configurations=configurations,
    )


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
        transmission_error=float(mesh.approach.max() - mesh.approach.min()) * 1e6,
        transverse_contact_ratio=mesh.pair.transverse_contact_ratio,
        overlap_ratio=mesh.pair.overlap_ratio,
        torque=mesh.torque,
    )


def _configuration(found: Verification, one: Compared) -> ConfigurationCompared:
    held = one.configuration
    rpm = [found.inputs.rpm(float(omega), held.stiffness) for omega in one.window_omegas]
    return ConfigurationCompared(
        name=held.name,
        held=held.told,
        numbers=held.numbers(found.inputs),
        face_width=held.width * 1e3,
        torque=held.torque,
        error=held.error * 1e6,
        error_phase=one.given.error_phase,
        points=tuple(map(_point, one.points)),
        beside=tuple(map(_point, one.beside)),
        lumped=tuple(LumpedComputed(p.omega, str(p.rule), p.label, p.apart) for p in one.lumped),
        window=WindowComputed(
            omega=tuple(map(float, one.window_omegas)),
            speed=tuple(rpm),
            up=_labels(one.up, one.window_omegas),
            down=_labels(one.down, one.window_omegas),
            lumped_up={str(rule): labels[0] for rule, labels in one.lumped_window.items()},
            lumped_down={str(rule): labels[1] for rule, labels in one.lumped_window.items()},
        ),
    )


def _labels(points: tuple[PointFound, ...], omegas: object) -> tuple[str, ...]:
    known = {p.omega: _label(p) for p in points}
    return tuple(known.get(float(omega), "not computed") for omega in omegas)  # pyright: ignore[reportGeneralTypeIssues]


def _label(point: PointFound) -> str:
    return "none" if point.reading.label is None else str(point.reading.label)


def _point(point: PointFound) -> PointComputed:
    reading = point.reading
    return PointComputed(
        omega=point.omega,
        speed=point.rpm,
        setting=point.setting,
        label=_label(point),
        apart=reading.apart,
        impacts=reading.drive_impacts / reading.cycles,
        back_impacts=reading.back_impacts / reading.cycles,
        least_force=reading.least,
        mean_force=reading.mean,
        greatest_force=reading.most,
        orders=tuple(map(float, reading.orders)),
        returns=reading.returns,
        energy_residual=point.energy_residual,
        phase=tuple(map(float, reading.phase)),
        force=tuple(map(float, reading.force)),
    )


def _sentence(case: Case, configurations: tuple[ConfigurationCompared, ...]) -> str:
    """What the first configuration shows at each speed, against the case's contact rule."""
    if not configurations or not configurations[0].points:
        return f"{case.name}: nothing was computed of the multibody model"
    first = configurations[0]
    rule = next((str(v.value) for v in case.values() if v.path == "model.contact"), FIRST)
    told = []
    for point in first.points:
        beside = next((p for p in first.lumped if p.omega == point.omega and p.rule == rule), None)
        if beside is None:
            continue
        told.append(f"at {point.speed:.0f} rpm {_verdict(point, beside.label)}")
    return f"{case.name} with real teeth: {'; '.join(told)}" if told else f"{case.name}: no point to compare"


def _verdict(point: PointComputed, lumped: str) -> str:
    """One point in words: what real teeth do, then whether the lumped model says so."""
    does = f"teeth part ({point.label})" if point.apart > 0.0 else f"teeth stay in contact ({point.label})"
    if point.label == lumped:
        return f"{does}, as in the lumped model"
    return f"{does}; the lumped model says {lumped}"
