"""`gearlash check`: what a case says, stated and derived, and where every value is from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Literal

from gearlash.case import Case

from .parts import program_version


@dataclass(frozen=True)
class CheckValue:
    """One value."""

    path: str
    short: Annotated[str | None, "short name, where it has one"]
    value: float | str
    unit: Annotated[str, "empty for a number"]
    text: Annotated[str, "as it was written; empty for a default or a derived value"]
    provenance: Annotated[str, "given, inferred, assumed, calibrated or derived"]
    reason: Annotated[str, "why it has this value; the formula of a derived one"]
    rests_on: Annotated[tuple[str, ...], "paths of the assumed values that a derived one was computed from"]
    description: str
    least: Annotated[
        float | None,
        "the least value that an estimate may have, or the lower limit as stated, in the same unit",
    ] = None
    greatest: Annotated[float | None, "the greatest value, or the upper limit"] = None


@dataclass(frozen=True)
class CheckNote:
    """What is unusual, or in conflict with what is known otherwise. Shown, never used."""

    path: str
    text: str


@dataclass(frozen=True)
class CheckAnswer:
    """Every value of a case (gearlash check)."""

    name: str
    kind: str
    description: str
    source: Annotated[
        dict[str, str | tuple[str, ...]], "title, authors, doi, url and note of the case's source"
    ]
    hash: Annotated[str, "SHA-256 of all values that decide a result"]
    gearlash: Annotated[str, "version of the program"]
    parameters: Annotated[dict[str, float], "every parameter of the model by short name, dimensionless"]
    states: Annotated[tuple[str, ...], "names of the model's states, for --initial"]
    values: tuple[CheckValue, ...]
    notes: tuple[CheckNote, ...]
    dynamic_factor: Annotated[
        str, "of gears with teeth: K_v of ISO 6336-1 at the speed of the case, or why there is none"
    ] = ""
    result: Literal["check"] = "check"


def check_answer(case: Case) -> CheckAnswer:
    """The record of a case."""
    family, _ = case.family()
    return CheckAnswer(
        name=case.name,
        kind=case.kind,
        description=case.description,
        source={name: _text(value) for name, value in case.source.items() if value},
        hash=case.hash,
        gearlash=program_version(),
        parameters=family.defaults,
        states=family.states,
        values=tuple(
            CheckValue(
                v.path,
                v.short,
                v.value,
                v.unit,
                v.text,
                v.provenance,
                v.reason,
                v.rests_on,
                v.description,
                v.least,
                v.greatest,
            )
            for v in case.values()
        ),
        notes=tuple(CheckNote(n.path, n.text) for n in case.notes()),
        dynamic_factor=_dynamic_factor(case, family.defaults),
    )


def _dynamic_factor(case: Case, parameters: Mapping[str, float]) -> str:
    """Of the standard, for a pair of gears in physical units."""
    if not case.between_teeth or not case.scales.teeth or not case.scales.physical:
        return ""
    from gearlash.case.rating import band_of_grades

    return band_of_grades(case, parameters["omega"])


def _text(value: object) -> str | tuple[str, ...]:
    return tuple(map(str, value)) if isinstance(value, list | tuple) else str(value)
