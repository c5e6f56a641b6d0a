"""`gearlash map`: which motion belongs to which pair of values of two parameters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np

from gearlash.case import Case
from gearlash.system import Label, MotionKind, Signature, Status

from .excitation import Unexcited, idle_study
from .outcome import PIXELS, study_status, troubles
from .parts import CaseUsed, case_used
from .sweep import AxisUsed, axis_used

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.results import PlaneMap


@dataclass(frozen=True)
class MapLabel:
    """A motion of the map."""

    label: Annotated[Label, "P-Q-R (/Q-R of every further clearance), aperiodic, neutral or unresolved"]
    code: Annotated[int, "its number in codes"]
    pixels: int
    share: Annotated[float, "of the computed pixels, 0 to 1"]
    x: Annotated[tuple[float, float], "least and largest value of x at which it occurs"]
    y: Annotated[tuple[float, float], "least and largest value of y at which it occurs"]


@dataclass(frozen=True)
class FailedPixel:
    """A pixel without a motion."""

    x: float
    y: float
    reason: str


@dataclass(frozen=True)
class MapAnswer:
    """Attractors over a plane of two parameters (gearlash map)."""

    sentence: str
    status: Annotated[str, PIXELS]
    message: Annotated[str, "why it is not complete"]
    case: CaseUsed
    parameters: Annotated[dict[str, float], "every parameter but the two of the axes, by short name"]
    x: Annotated[AxisUsed, "horizontal axis"]
    y: Annotated[AxisUsed, "vertical axis"]
    start: Annotated[
        dict[str, float] | None, "state that every pixel started from (--initial); null: the cold start"
    ]
    statuses: Annotated[dict[Status, int], "number of pixels by status"]
    certificates: Annotated[dict[str, int], "number of pixels certified, uncertain, failed"]
    impact_free: Annotated[int, "number of pixels with a periodic motion without any impact"]
    labels: Annotated[tuple[MapLabel, ...], "the most frequent first"]
    codes: Annotated[
        tuple[tuple[int, ...], ...],
        "code of the label of every pixel, a row for every value of y, ascending; -1 without a motion",
    ]
    failed: tuple[FailedPixel, ...]
    result: Literal["map"] = "map"


def map_answer(
    case: Case,
    parameters: Mapping[str, float],
    named: tuple[str, str],
    plane: PlaneMap,
    units: tuple[str, str] = ("", ""),
    start: Mapping[str, float] | None = None,
) -> MapAnswer:
    """The record of a map; ``named`` are the parameters as typed, ``units`` what they were typed in,
    ``start`` the state that was given to start from, by name."""
    statuses = plane.statuses
    x, y = plane.x, plane.y
    used_x, used_y = (axis_used(case, a, n, u) for a, n, u in zip((x, y), named, units, strict=True))
    idle = idle_study(case, parameters, [x, y])
    return MapAnswer(
        sentence=_sentence(plane, (used_x, used_y), idle),
        status=study_status(plane.complete, statuses, idle),
        message=plane.message,
        case=case_used(case),
        parameters={name: value for name, value in parameters.items() if name not in (x.name, y.name)},
        x=used_x,
        y=used_y,
        start=None if start is None else dict(start),
        statuses=statuses,
        certificates=plane.certificates,
        impact_free=int(plane.impact_free.sum()),
        labels=tuple(_labels(plane)),
        codes=tuple(tuple(row) for row in plane.label.tolist()),
        failed=tuple(
            FailedPixel(float(x.values[column]), float(y.values[row]), text)
            for (row, column), text in plane.reasons.items()
        ),
    )


def _labels(plane: PlaneMap) -> Iterator[MapLabel]:
    for label, pixels in plane.shares.items():
        code = plane.labels.index(label)
        rows, columns = np.nonzero(plane.label == code)
        x, y = plane.x.values[columns], plane.y.values[rows]
        yield MapLabel(
            label,
            code,
            pixels,
            pixels / plane.computed,
            (float(x.min()), float(x.max())),
            (float(y.min()), float(y.max())),
        )


def _sentence(plane: PlaneMap, axes: tuple[AxisUsed, AxisUsed], idle: Unexcited | None) -> str:
    ends = (axis.asked.span(axis.lower, axis.upper) for axis in axes)
    if idle is not None:
        return f"{' and '.join(ends)}: {idle.cause}; {idle.advice}"
    rows, columns = plane.shape
    orbits = sum(isinstance(label, Signature) for label in plane.labels)
    many = f"{orbits} different signatures" if orbits != 1 else "1 signature"
    parts = [f"{' and '.join(ends)}, {columns} × {rows} pixels, one start each: {many}"]
    if plane.computed:
        free, restless = int(plane.impact_free.sum()), plane.shares.get(MotionKind.APERIODIC, 0)
        parts.append(
            f"free of impacts {_percent(free / plane.computed)}, "
            f"aperiodic {_percent(restless / plane.computed)}"
        )
    missing = plane.statuses.get(Status.NOT_COMPUTED, 0)
    trouble = troubles(plane.statuses, _first_failure(plane, axes), "pixel")
    if trouble:
        parts.append(trouble)
    if missing:
        parts.append(f"incomplete, {missing} pixels missing")
    return "; ".join(parts)


def _first_failure(plane: PlaneMap, axes: tuple[AxisUsed, AxisUsed]) -> str:
    for (row, column), reason in plane.reasons.items():
        x, y = axes[0].asked.text(plane.x.values[column]), axes[1].asked.text(plane.y.values[row])
        return f"{x}, {y}, {reason}"
    return ""


def _percent(share: float) -> str:
    """Never 0 % of what occurs, nor all where something is missing."""
    if 0.0 < share < 0.001:
        return "below 0.1 %"
    return f"{100.0 * share:.1f} %" if share < 0.9995 or share == 1.0 else "above 99.9 %"
