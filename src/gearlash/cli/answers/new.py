"""`gearlash new`: what was written, and what of it is estimated."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from gearlash.case import Case

from .check import CheckNote, CheckValue, check_answer


@dataclass(frozen=True)
class NewAnswer:
    """A case file that was written from a drawing (gearlash new)."""

    file: str
    kind: str
    example: Annotated[
        bool, "whether it is a template with the values of an example as comments, as nothing was stated"
    ]
    stated: Annotated[tuple[CheckValue, ...], "what the file states"]
    estimated: Annotated[
        tuple[CheckValue, ...], "what is estimated from it, with ranges, whenever it is read"
    ]
    speed_rpm: Annotated[float, "of the pinion"]
    natural_rpm: Annotated[
        tuple[float, ...], "pinion speeds at which the mesh frequency meets a natural frequency"
    ]
    notes: Annotated[tuple[CheckNote, ...], "what is unusual about what was stated, of a path"] = ()
    result: Literal["new"] = "new"


def new_answer(file: str, case: Case, example: bool) -> NewAnswer:
    """The record of a file and its case."""
    checked = check_answer(case)
    values = checked.values
    family, scales = case.family()
    met = [v.value for v in values if v.path.startswith("derived.critical_speed_")]
    return NewAnswer(
        file,
        case.kind,
        example,
        () if example else tuple(v for v in values if v.text and v.provenance == "given"),
        tuple(v for v in values if v.least is not None and not v.text),
        float(scales.pinion_rpm(family.defaults["omega"])),
        tuple(float(speed) for speed in met),
        () if example else checked.notes,
    )
