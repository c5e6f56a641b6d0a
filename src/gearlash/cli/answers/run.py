"""`gearlash run`: one attractor with all its numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case
from gearlash.results.beside import Beside
from gearlash.results.impact_free import ImpactFree
from gearlash.system import Label, Status

from .excitation import NOT_EXCITED, unexcited
from .motion import MotionNumbers, motion_numbers
from .outcome import INCOMPLETE, RESUME
from .parts import (
    CaseUsed,
    CertificateUsed,
    ClearanceCounts,
    Multiplier,
    SignatureCounts,
    case_used,
    multiplier_rows,
)
from .physical import PhysicalRun, physical_run
from .sentence import run_sentence

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.orbits import Attractor, Orbit


TRACEABLE = (Status.OK, Status.UNCERTAIN, Status.UNRESOLVED, Status.NEUTRAL)  # of motions to look at


@dataclass(frozen=True)
class RunAnswer:
    """One attractor (gearlash run)."""

    sentence: Annotated[str, "the answer in plain words"]
    status: Annotated[
        str,
        "ok; incomplete if it was stopped when the motion was found, but not yet what is beside it; "
        "not-excited; or why the result is not to be relied on",
    ]
    message: Annotated[str, "how the motion was found, or why not"]
    advice: Annotated[str, "what to do about the status"]
    case: CaseUsed
    parameters: Annotated[dict[str, float], "every parameter of the model by short name, dimensionless"]
    start: Annotated[dict[str, float], "state at phase zero that the search started from"]
    motion: Annotated[Literal["periodic", "aperiodic", "neutral", "unresolved"], "what was found"]
    label: Annotated[Label, "P-Q-R (/Q-R of every further clearance), aperiodic, neutral or unresolved"]
    certificate: CertificateUsed
    signature: Annotated[SignatureCounts | None, "null where nothing periodic was proved"]
    stable: Annotated[bool | None, "all multipliers inside the unit circle; null without an orbit"]
    state: Annotated[
        Mapping[str, float | None],
        "state at phase zero by name; of an orbit, one point of it (null: it ran away beyond every number)",
    ]
    residual: Annotated[
        float | None, "largest component of P(z) - z, each over |DP| s + s with the sizes s of the states"
    ]
    multipliers: Annotated[
        tuple[Multiplier, ...], "all Floquet multipliers, by modulus, descending; of an orbit only"
    ]
    exponents: Annotated[
        tuple[float | None, ...],
        "Lyapunov exponents per unit of τ, descending: all, exact, of an orbit (null: the multiplier is "
        "zero); else the largest",
    ]
    exponent_error: Annotated[float | None, "half-width of its 95 % interval; 0 on an orbit"]
    periods_used: Annotated[int, "base periods that the motion was followed, transient and averages together"]
    numbers: Annotated[
        MotionNumbers | None, "of the motion, dimensionless; null where it ran away, or not looked at"
    ]
    beside: Annotated[
        Beside | None,
        "what a few other starts lead to; null where no motion was found to compare with, or not looked for",
    ]
    impact_free: Annotated[
        ImpactFree | None,
        "speeds at which the motion of teeth that never part exists, whatever may coexist with it; null "
        "without load or where not looked for",
    ]
    physical: Annotated[PhysicalRun | None, "in physical units; null for a case without scales"]
    result: Literal["run"] = "run"


def numbers_of(attractor: Attractor, case: Case, parameters: Mapping[str, float]) -> MotionNumbers | None:
    """The numbers of the motion; None where it ran away."""
    from gearlash.studies.measured import readouts_of

    if attractor.status not in TRACEABLE:
        return None
    return motion_numbers(attractor, readouts_of(case, parameters)[-1] if case.between_teeth else None)


def run_answer(
    case: Case,
    parameters: Mapping[str, float],
    start: Mapping[str, float],
    attractor: Attractor,
    numbers: MotionNumbers | None,
    impact_free: ImpactFree | None,
    beside: Beside | None,
    missing: Sequence[str] = (),
) -> RunAnswer:
    """The record of an attractor that was reached from ``start`` (by state name), with its numbers;
    ``missing``: what was not looked at any more."""
    from gearlash.orbits import Orbit

    orbit = attractor if isinstance(attractor, Orbit) else None
    idle = unexcited(case, attractor)
    status, message, advice = str(attractor.status), attractor.message, attractor.status.advice
    if idle is not None:
        status, message, advice = NOT_EXCITED, idle.cause, idle.advice
    if missing:
        advice = RESUME if status == Status.OK else f"{RESUME}; {advice}"
        status, message = INCOMPLETE, f"{message}; interrupted before {' and '.join(missing)}"
    names = list(start)
    state = dict(zip(names, map(float, attractor.final_state), strict=True))
    return RunAnswer(
        sentence=run_sentence(case, parameters, attractor, numbers, impact_free, beside, idle),
        status=status,
        message=message,
        advice=advice,
        case=case_used(case),
        parameters=dict(parameters),
        start=dict(start),
        motion=_motion(attractor),
        label=attractor.label,
        certificate=_certificate(attractor) if idle is None else CertificateUsed("uncertain", (idle.reason,)),
        signature=_counts(orbit) if orbit else None,
        stable=orbit.stable if orbit else None,
        state=state,
        residual=orbit.residual if orbit else None,
        multipliers=multiplier_rows(orbit.multipliers) if orbit else (),
        exponents=tuple(map(float, orbit.exponents)) if orbit else (attractor.largest_exponent,),
        exponent_error=attractor.exponent_error,
        periods_used=attractor.periods_used,
        numbers=numbers,
        beside=beside,
        impact_free=impact_free,
        physical=_physical(case, parameters, state, numbers, impact_free),
    )


def _counts(orbit: Orbit) -> SignatureCounts:
    names = [clearance.name for clearance in orbit.propagators.system.clearances]
    found = orbit.signature
    others = zip(names[1:], found.others, strict=True)
    return SignatureCounts(
        found.period,
        found.drive,
        found.back,
        tuple(ClearanceCounts(name, drive, back) for name, (drive, back) in others),
    )


def _certificate(attractor: Attractor) -> CertificateUsed:
    found = attractor.certificate
    return CertificateUsed(found.verdict.value, found.reasons)


def _physical(
    case: Case,
    parameters: Mapping[str, float],
    state: Mapping[str, float],
    numbers: MotionNumbers | None,
    impact_free: ImpactFree | None,
) -> PhysicalRun | None:
    if numbers is None or not case.scales.physical:
        return None
    return physical_run(case, parameters, state, numbers, impact_free)


def _motion(attractor: Attractor) -> Literal["periodic", "aperiodic", "neutral", "unresolved"]:
    from gearlash.orbits import Neutral, Orbit, Unresolved

    if isinstance(attractor, Orbit):
        return "periodic"
    if isinstance(attractor, Neutral):
        return "neutral"
    return "unresolved" if isinstance(attractor, Unresolved) else "aperiodic"
