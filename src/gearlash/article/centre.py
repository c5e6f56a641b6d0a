"""The point behind a doubling with a grazing beside it: in two parameters the two fall into one.

There the single orbit grazes with a multiplier -1. Its doubling and its grazing leave that point as two
curves, and the grazing of the doubled orbit as a third one, tangent to the doubling. One parameter alone cuts
these curves at different values, however close."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np

from gearlash import (
    Branch,
    CodimTwoKind,
    CodimTwoPoint,
    ContinuationSettings,
    Curve,
    SpecialKind,
    SpecialPoint,
    continue_curve,
)
from gearlash.case import Case
from gearlash.system import GearlashError

from .claims import Claim
from .events import match_coincidence
from .opening import Beside
from .reproduction import NAN, Centre, CentreLine, CentrePlace, Coincidence, Scan

DRAWN = "bearing_damping"  # second parameter of the plane whose curves are followed, and that the case has
ASIDE: Mapping[str, tuple[float, float]] = {
    DRAWN: (1.0, 1.3),
    "omega": (0.99, 1.03),
    "error_phase": (0.6, 1.1),
    "ripple_2": (0.9, 1.7),
}
"""Second parameters, and between which multiples of their value in the case the point is looked for."""
FIRST = (0.9, 1.12)  # the same of the first parameter, in the value of the doubling
STEPS = ContinuationSettings(longest=0.06, certify=False)
SHORT = ContinuationSettings(longest=0.03, certify=False)  # where curves are compared with each other
SAME = 1e-9  # relative distance of two values of one point


@dataclass(frozen=True, eq=False)
class Seek:
    """A task: the point in the plane of the branch's parameter and of another one, by the grazing curve."""

    case: str
    branch: Branch
    grazing: SpecialPoint
    name: str
    lower: tuple[float, float]
    upper: tuple[float, float]


def centres(
    case: Case, claims: Sequence[Claim], scan: Scan, beside: Sequence[Beside], executor: Executor
) -> tuple[Centre, ...]:
    """Of every claim of a coincidence that was met in this scan."""
    found = []
    for claim in claims:
        if claim.kind != "codimension-2" or claim.parameter != scan.parameter:
            continue
        pair = match_coincidence(claim, beside)
        start = None if pair is None else _start(scan, pair[0])
        if pair is not None and start is not None:
            found.append(centre(case, claim.id, pair[0], *start, executor))
    return tuple(found)


def _start(scan: Scan, both: Coincidence) -> tuple[Branch, SpecialPoint] | None:
    """The branch that doubles, and where its orbit touches the boundary that the doubled one touches."""
    for branch in scan.branches:
        here = [s for s in branch.of_kind(SpecialKind.DOUBLING) if _same(s.value, both.doubling.value)]
        touches = [
            s
            for s in branch.special
            if s.is_grazing
            and s.touch.boundary == both.grazing.touch.boundary
            and both.single in (s.label_before, s.label_after)
        ]
        if here and touches:
            return branch, min(touches, key=lambda s: abs(s.value - both.doubling.value))
    return None


def _same(one: float, other: float) -> bool:
    return abs(one - other) <= SAME * abs(other)


def centre(
    case: Case, claim: str, both: Coincidence, branch: Branch, grazing: SpecialPoint, executor: Executor
) -> Centre:
    """In every plane, with its curves in the first one."""
    planes = list(_planes(case, both, branch, grazing))
    tasks = [executor.submit(around if each.name == DRAWN else sought, each, both) for each in planes]
    places, lines = [], ()
    for each, task in zip(planes, tasks, strict=True):
        point, curves = task.result()
        if point is not None:
            places.append(_place(case, each, point))
        if each.name == DRAWN and point is not None:
            lines = tuple(_lines(curves, both, grazing, point, each.lower[1]))
    apart = {**branch.values}
    fixed = {name: apart[name] for name in ("omega", "D") if name != branch.name}
    return Centre(
        claim,
        fixed,
        _graded(grazing),
        grazing.touch.boundary,
        tuple(places),
        tuple(each.name for each in planes),
        lines,
    )


def _graded(grazing: SpecialPoint) -> tuple:
    """Its labels, the fewer impacts first."""
    one, two = sorted((grazing.label_before, grazing.label_after), key=lambda label: label.back_impacts)
    return one, two


def _planes(case: Case, both: Coincidence, branch: Branch, grazing: SpecialPoint):
    for name, spans in ASIDE.items():
        ends = sorted(part * branch.values[name] for part in spans)
        if name != branch.name and ends[0] < ends[1]:
            first = sorted(part * both.doubling.value for part in FIRST)
            lower, upper = (first[0], ends[0]), (first[1], ends[1])
            yield Seek(case.to_json(), branch, grazing, name, lower, upper)


def sought(task: Seek, both: Coincidence) -> tuple[CodimTwoPoint | None, tuple[Curve, ...]]:
    """The point on the grazing curve of the single orbit that lies nearest to the case (a task)."""
    try:
        curve = _curve(task, task.grazing, STEPS)
    except GearlashError:
        return None, ()
    return _nearest(curve, both, task), (curve,)


def around(task: Seek, both: Coincidence) -> tuple[CodimTwoPoint | None, tuple[Curve, ...]]:
    """The point, and the curves of the single orbit's grazing and doubling and of the doubled orbit's
    grazing (a task)."""
    point, found = sought(task, both)
    if point is None:
        return None, ()
    case, names, limits = Case.from_json(task.case), (task.branch.name, task.name), (task.lower, task.upper)
    try:
        doubling = _curve(task, both.doubling, SHORT)
        doubled = continue_curve(
            case, names, point, lower=limits[0], upper=limits[1], values=task.branch.values, doubled=True,
            steps=SHORT,
        )  # fmt: skip
    except GearlashError:
        return point, found
    return point, (doubling, *found, doubled)


def _curve(task: Seek, special: SpecialPoint, steps: ContinuationSettings) -> Curve:
    names = (task.branch.name, task.name)
    return continue_curve(
        Case.from_json(task.case), names, special, lower=task.lower, upper=task.upper, branch=task.branch,
        steps=steps,
    )  # fmt: skip


def _nearest(curve: Curve, both: Coincidence, task: Seek) -> CodimTwoPoint | None:
    wide = np.subtract(task.upper, task.lower)
    here = np.array([both.doubling.value, task.branch.values[task.name]])
    found = [s for s in curve.of_kind(CodimTwoKind.GRAZING_DOUBLING) if s.status.ok and s.point.admissible]
    return min(found, key=lambda s: float(np.linalg.norm((s.values - here) / wide)), default=None)


def _place(case: Case, task: Seek, met: CodimTwoPoint) -> CentrePlace:
    name, point = task.branch.name, met.point
    omega = {**task.branch.values, name: met.values[0], task.name: met.values[1]}["omega"]
    modulus = float(np.abs(point.multipliers).max())
    return CentrePlace(
        parameters=(name, task.name),
        values=met.values,
        errors=met.errors,
        present=task.branch.values[task.name],
        limits=((task.lower[0], task.upper[0]), (task.lower[1], task.upper[1])),
        multiplier=float(np.abs(point.multipliers + 1.0).min()),
        distance=abs(point.touches[0].distance),
        residual=point.residual,
        exponent=float(np.log(modulus)) / (point.period * 2.0 * np.pi / omega),
    )


def _lines(
    curves: Sequence[Curve], both: Coincidence, grazing: SpecialPoint, point: CodimTwoPoint, present: float
):
    labels = ((both.single,), _graded(grazing), (both.doubled, both.beyond))
    if len(curves) < len(labels):
        return
    for curve, words in zip(curves, labels, strict=True):
        between = {
            p.values[1]: p.values[0]
            for p in curve.points
            if p.values[1] < point.values[1] and not _same(p.values[1], present)
        }
        crosses = next((p.values[0] for p in curve.points if _same(p.values[1], present)), NAN)
        end = [(crosses, present)] if crosses == crosses else []
        along = [(between[second], second) for second in sorted(between, reverse=True)]
        yield CentreLine(str(curve.kind), words, (point.values, *along, *end), crosses)
