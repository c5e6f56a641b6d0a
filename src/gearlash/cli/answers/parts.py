"""Parts that several answers share: the case, multipliers, what physical numbers rest on."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from typing import Annotated, Literal

import numpy as np

from gearlash.case import Case, Provenance

Rests = Annotated[
    dict[str, tuple[str, ...]],
    "kind of physical number → assumed values that it rests on. speed, frequency, torque, backlash: as the "
    "case says them; time, length, velocity, force, moment: the units of computed numbers; model: the motion "
    "itself. Kinds without any are not listed",
]


@dataclass(frozen=True)
class Multiplier:
    """A Floquet multiplier λ."""

    re: float
    im: float
    modulus: float


@dataclass(frozen=True)
class ClearanceCounts:
    """Impacts in one further clearance."""

    name: str
    drive: Annotated[int, "on side + in one period"]
    back: Annotated[int, "on side - in one period"]


@dataclass(frozen=True)
class SignatureCounts:
    """P-Q-R: impacts are engagements, X rising through +D or falling through -D (with the rule `no-tension`
    every beginning of contact)."""

    period: Annotated[int, "P: least period in mesh cycles"]
    drive: Annotated[int, "Q: impacts on the drive side of the first clearance in one period"]
    back: Annotated[int, "R: impacts on the back side of the first clearance in one period"]
    others: Annotated[tuple[ClearanceCounts, ...], "Q and R of every further clearance"]


@dataclass(frozen=True)
class CertificateUsed:
    """What the program vouches for (docs/theory.md)."""

    verdict: Literal["certified", "uncertain", "failed"]
    reasons: Annotated[tuple[str, ...], "why it is not certified, with numbers"]


@dataclass(frozen=True)
class NotGiven:
    """A value that the source of the case does not state."""

    path: str
    value: float | str
    unit: str
    provenance: Annotated[str, "inferred, assumed or calibrated"]
    reason: str


@dataclass(frozen=True)
class CaseUsed:
    """The case that the answer belongs to, overrides included."""

    name: str
    kind: str
    between_teeth: Annotated[bool, "whether the first gap is the one between two meshing gears"]
    hash: Annotated[str, "SHA-256 of all values that decide a result"]
    gearlash: Annotated[str, "version of the program"]
    not_given: Annotated[tuple[NotGiven, ...], "every value that is inferred, assumed or calibrated"]


def case_used(case: Case) -> CaseUsed:
    """The case as an answer names it."""
    return CaseUsed(case.name, case.kind, case.between_teeth, case.hash, program_version(), not_given(case))


def not_given(case: Case) -> tuple[NotGiven, ...]:
    """Stated and default values of any provenance but `given`, and but those derived from others."""
    kinds = (Provenance.INFERRED, Provenance.ASSUMED, Provenance.CALIBRATED)
    found = (v for v in case.values() if v.provenance in kinds)
    return tuple(NotGiven(v.path, v.value, v.unit, v.provenance, v.reason) for v in found)


def program_version() -> str:
    """Version of the installed distribution; ``unknown`` when only the sources are on the path."""
    try:
        return version("gearlash")
    except PackageNotFoundError:
        return "unknown"


def multiplier_rows(values: Iterable[complex]) -> tuple[Multiplier, ...]:
    """Multipliers as records, in the given order."""
    return tuple(Multiplier(float(v.real), float(v.imag), float(abs(v))) for v in np.asarray(list(values)))


@dataclass(frozen=True)
class PhysicalValue:
    """A parameter's value in one physical unit."""

    name: Annotated[str, "last part of its path in the case"]
    value: float
    unit: str
    rests_on: Annotated[tuple[str, ...], "paths of the assumed values that it rests on"]


def physical_values(
    case: Case, short: str, value: float, computed: bool = True, back_side_met: bool = True
) -> tuple[PhysicalValue, ...]:
    """What a parameter's value means physically. A ``computed`` one rests on what the model rests on, too."""
    rests = rests_on(case, back_side_met)
    model = rests.get("model", ()) if computed else ()
    kinds = {"rpm": "time", "Hz": "time", "um": "length", "N*m": "moment"}
    found = []
    for path, numbers, unit in case.physical(short, value):
        roots = tuple(dict.fromkeys((*rests.get(kinds.get(unit, ""), ()), *model)))
        found.append(PhysicalValue(path.rpartition(".")[2], float(numbers), unit, roots))
    return tuple(found)


def rests_in(case: Case, short: str, name: str, unit: str, computed: bool = True) -> tuple[str, ...]:
    """Assumed values that (``computed``) values of a parameter rest on, told as the quantity ``name``; none
    where they are told without a ``unit``."""
    told = physical_values(case, short, 1.0, computed) if unit else ()
    return next((each.rests_on for each in told if each.name == name), ())


def rests_on(case: Case, back_side_met: bool = True) -> dict[str, tuple[str, ...]]:
    """Kind of physical number → paths of assumed values that it rests on; kinds without any are left out.

    ``speed``, ``frequency``, ``torque``, ``backlash``: what the case itself says of them, as stated or
    converted. ``time``, ``length``, ``velocity``, ``force``, ``moment``: the units that computed numbers are
    converted with. ``model``: what the dimensionless motion rests on (values of the back side only if it is
    met).
    """
    if not case.scales.physical:
        return {}
    by_path = {v.path: v for v in case.values()}

    def roots(*paths: str) -> tuple[str, ...]:
        found = (by_path[path] for path in paths if path in by_path)
        each = (root for v in found for root in (v.rests_on or ((v.path,) if v.uncertain else ())))
        return tuple(dict.fromkeys(each))

    time, length, force = (
        roots("derived.omega_n"),
        roots("model.reference_length"),
        roots("derived.force_unit"),
    )
    speed, frequency = "operation.pinion_speed", "operation.mesh_frequency"
    if speed in by_path and by_path[speed].provenance != "derived":
        frequency = speed  # it follows by the number of teeth
    elif frequency in by_path and by_path[frequency].provenance != "derived":
        speed = frequency
    rests = {
        "speed": roots(speed),
        "frequency": roots(frequency),
        "torque": roots("operation.torque"),
        "backlash": roots("mesh.backlash"),
        "time": time,
        "length": length,
        "velocity": tuple(dict.fromkeys((*time, *length))),
        "force": force,
        "moment": tuple(dict.fromkeys((*force, *roots("derived.radius_pinion", "derived.c_t")))),
        "model": _model_roots(case, back_side_met),
    }
    return {kind: paths for kind, paths in rests.items() if paths}


UNUSED = "face_width", "bearing_span"
"""What the equations of motion do not have."""


def _model_roots(case: Case, back_side_met: bool) -> tuple[str, ...]:
    """Assumed values that decide the dimensionless motion. Where a physical value has its dimensionless
    counterpart, only what that one rests on counts: a backlash that D_c is half of decides nothing, as D
    is 1 whatever it is.
    """
    values = case.values()
    counterparts = {
        v.path: v for v in values if v.provenance == "derived" and v.path.startswith("dimensionless.")
    }
    found = [root for v in counterparts.values() for root in v.rests_on]
    for v in values:
        leaf = v.path.rpartition(".")[2]
        if v.provenance != Provenance.ASSUMED or v.path == "model.reference_length" or leaf in UNUSED:
            continue
        if leaf in ("back_stiffness", "back_gap") and not back_side_met:
            continue
        if f"dimensionless.{v.short}" not in counterparts:
            found.append(v.path)
    return tuple(dict.fromkeys(found))
