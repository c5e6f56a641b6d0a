"""`gearlash atlas`: the curves of a rectangle of two parameters, where they meet, and their check."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Literal

from gearlash.case import Case
from gearlash.system import Label, Status

from .excitation import idle_study
from .outcome import PIXELS, study_status
from .parts import CaseUsed, case_used, rests_in
from .sweep import AxisUsed, axis_used

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.results.atlas import Atlas, AtlasCurve, AtlasPoint

NOT_LOOKED_FOR = (
    "motions that neither the map nor the sweeps along lines show, and that no branch leads to",
    "curves of special points at which no motion that attracts begins, ends or changes, but for those beside "
    "the changes of the map",
    "what lies between two neighbouring pixels of one label",
    "ends of basins of attraction",
)
CURVES = "curves from them"  # the stage in which the first curves are followed
Place = Annotated[tuple[float, float], "values of the two parameters, dimensionless"]


@dataclass(frozen=True)
class CurveEnd:
    """Why a curve is not followed farther."""

    kind: Annotated[str, "such as limit of a parameter, or closed loop"]
    values: Place
    note: str


@dataclass(frozen=True)
class StraightFound:
    """A piece along which the special orbits do not depend on one parameter."""

    name: Annotated[str, "of the parameter that they do not depend on"]
    lower: Annotated[float, "of that parameter"]
    upper: float
    value: Annotated[float, "of the other one, which stays"]


@dataclass(frozen=True)
class CurveFound:
    """A curve; its orbits are in curve-N.json of --out."""

    number: int
    kind: Annotated[str, "grazing, fold, doubling or Neimark-Sacker"]
    period: Annotated[int, "of its orbits, in mesh cycles"]
    labels: Annotated[tuple[Label, ...], "of its orbits in order, each once; what touches is not counted"]
    points: Annotated[int, "orbits that were solved for"]
    attracting: Annotated[int, "those of them that no multiplier outside the unit circle makes unstable"]
    ends: tuple[CurveEnd, ...]
    straight: tuple[StraightFound, ...]
    way: Annotated[str, "how its first orbit was found"]


@dataclass(frozen=True)
class PointFound:
    """A point at which two things happen at once."""

    number: Annotated[str, "that of the first curve with it, and its own on that curve"]
    kind: Annotated[str, "what two things happen"]
    values: Place
    errors: Annotated[tuple[float, float], "estimates of their errors"]
    label: Annotated[Label, "of its orbit; what touches is not counted"]
    solved: Annotated[bool, "whether both conditions were solved for together"]
    curves: Annotated[tuple[int, ...], "numbers of the curves on which it was found"]


@dataclass(frozen=True)
class ChangeFound:
    """Neighbouring pixels whose motions differ, unexplained or with special points that have no curve."""

    kind: Annotated[str, "unexplained, or special point without a curve"]
    values: Annotated[tuple[Place, Place], "of both pixels"]
    labels: Annotated[tuple[str, str], "of both; empty without a motion"]
    note: Annotated[str, "what else is known"]


@dataclass(frozen=True)
class LeftUndone:
    """What was left undone."""

    what: str
    label: Annotated[str, "of the motion; empty where none is told"]
    values: Place
    why: str


@dataclass(frozen=True)
class AtlasAnswer:
    """Curves of special orbits in a rectangle of two parameters (gearlash atlas)."""

    sentence: str
    status: Annotated[str, PIXELS]
    message: Annotated[str, "why it is not complete"]
    done: Annotated[tuple[str, ...], "stages that were done, in order"]
    case: CaseUsed
    parameters: Annotated[dict[str, float], "every parameter but the two of the axes, by short name"]
    x: Annotated[AxisUsed, "horizontal axis; its count is that of the coarse map"]
    y: Annotated[AxisUsed, "vertical axis"]
    start: Annotated[
        dict[str, float] | None, "state that pixels and sweeps started from; null: the cold start"
    ]
    budget: Annotated[int, "curves that were allowed"]
    tried: Annotated[int, "curves that were followed, those found twice among them"]
    curves: tuple[CurveFound, ...]
    points: Annotated[tuple[PointFound, ...], "where two things happen at once"]
    changes: Annotated[
        dict[str, int],
        "pairs of neighbouring computed pixels with different labels, by what explains them",
    ]
    not_explained: Annotated[tuple[ChangeFound, ...], "those that no curve and no coexistence explains"]
    undone: Annotated[tuple[LeftUndone, ...], "what was left undone, and why"]
    rests_on: Annotated[
        tuple[tuple[str, ...], ...], "assumed values behind computed values of x and y, in the unit asked for"
    ]
    not_looked_for: Annotated[tuple[str, ...], "what this atlas says nothing about"]
    result: Literal["atlas"] = "atlas"


def atlas_answer(
    case: Case,
    parameters: Mapping[str, float],
    named: tuple[str, str],
    units: tuple[str, str],
    found: Atlas,
    budget: int,
    start: Mapping[str, float] | None = None,
) -> AtlasAnswer:
    """The record of an atlas; ``named`` are the parameters as typed, ``units`` what they were typed in."""
    from gearlash.results.atlas import LabelChangeKind

    axes = found.plane.x, found.plane.y
    x, y = (axis_used(case, a, n, u) for a, n, u in zip(axes, named, units, strict=True))
    idle = idle_study(case, parameters, list(axes))
    return AtlasAnswer(
        sentence=f"{_ends((x, y))}: {idle.cause}; {idle.advice}" if idle else _sentence(found, (x, y)),
        status=study_status(found.complete, found.plane.statuses, idle),
        message=found.message,
        done=found.done,
        case=case_used(case),
        parameters={name: value for name, value in parameters.items() if name not in found.names},
        x=x,
        y=y,
        start=None if start is None else dict(start),
        budget=budget,
        tried=found.tried,
        curves=tuple(_curve(i, each) for i, each in enumerate(found.curves, 1)),
        points=tuple(_point(found, each) for each in found.points),
        changes={str(kind): count for kind, count in found.counts.items()},
        not_explained=tuple(
            ChangeFound(str(each.kind), each.values, _texts(*each.labels), each.note)
            for each in found.changes
            if each.kind in (LabelChangeKind.NONE, LabelChangeKind.POINT)
        ),
        undone=tuple(
            LeftUndone(each.what, _text(each.label), each.values, each.why) for each in found.undone
        ),
        rests_on=tuple(rests_in(case, a.name, a.asked.name, a.asked.unit) for a in (x, y)),
        not_looked_for=NOT_LOOKED_FOR,
    )


def _curve(number: int, each: AtlasCurve) -> CurveFound:
    points = each.curve.points
    return CurveFound(
        number,
        str(each.kind),
        points[0].period,
        tuple(dict.fromkeys(point.signature for point in points)),
        len(points),
        sum(point.admissible and point.unstable == 0 for point in points),
        tuple(CurveEnd(str(end.kind), end.values, end.note) for end in each.curve.ends),
        tuple(StraightFound(s.name, s.lower, s.upper, s.value) for s in each.straight),
        each.way,
    )


def _point(found: Atlas, each: AtlasPoint) -> PointFound:
    special, first = each.special, each.curves[0]
    on_curve = found.curves[first].curve.special
    own = next((i for i, other in enumerate(on_curve, 1) if other is special), 0)
    return PointFound(
        f"{first + 1}.{own}",
        str(special.kind),
        special.values,
        special.errors,
        special.point.signature,
        special.solved,
        tuple(i + 1 for i in each.curves),
    )


def _text(label: Label | None) -> str:
    return "" if label is None else str(label)


def _texts(one: Label | None, other: Label | None) -> tuple[str, str]:
    return _text(one), _text(other)


def _ends(axes: tuple[AxisUsed, AxisUsed]) -> str:
    return " and ".join(axis.asked.span(axis.lower, axis.upper) for axis in axes)


def _sentence(found: Atlas, axes: tuple[AxisUsed, AxisUsed]) -> str:
    return f"{_ends(axes)}: {'; '.join(_found(found))}"


def _found(found: Atlas) -> Iterator[str]:
    from gearlash.branches.continuation import SpecialKind

    if not found.complete:
        yield from _stopped(found)
        if CURVES not in found.done and not found.curves:
            yield "no curve was followed to its end by then"
            return
    curves = [f"{len(found.of_kind(kind))} of kind {kind}" for kind in SpecialKind if found.of_kind(kind)]
    count = len(found.curves)
    yield f"{count} curve{'' if count == 1 else 's'} found" + (f" ({', '.join(curves)})" if curves else "")
    count = len(found.points)
    yield f"{count} point{'' if count == 1 else 's'} where two things happen at once"
    yield from _checked(found)


def _stopped(found: Atlas) -> Iterator[str]:
    """Where, and what was done before."""
    from gearlash.results.atlas import STAGES

    missing = found.plane.statuses.get(Status.NOT_COMPUTED, 0)
    at = f"{STAGES[len(found.done)]}{f', {missing} pixels missing' if missing else ''}"
    done = ", ".join(found.done) or "no stage"
    yield f"incomplete ({found.message}): stopped in {at}; done by then: {done}"


def _checked(found: Atlas) -> Iterator[str]:
    """How many changes have a reason."""
    from gearlash.results.atlas import LabelChangeKind

    counts = found.counts
    apart, unseen = counts[LabelChangeKind.APERIODIC], counts[LabelChangeKind.UNSEEN]
    asked = sum(counts.values()) - apart - unseen
    rest = counts[LabelChangeKind.NONE] + counts[LabelChangeKind.POINT]
    if asked:
        yield f"changes of motion between neighbouring pixels of the map unexplained: {rest} of {asked}"
    if apart:
        yield f"{apart} more changes have motion without a proved period on one side"
    if unseen:
        yield f"{unseen} more changes were not looked at"
