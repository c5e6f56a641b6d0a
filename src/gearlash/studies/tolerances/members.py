"""One combination of tolerances: where its impact-free motion exists."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from math import ceil, isnan, nan

import numpy as np

from gearlash.case import Case
from gearlash.jobs import Part
from gearlash.results import Axis
from gearlash.results.tolerance import ToleranceInput, ToleranceMember
from gearlash.studies.impact_free import ClosedMesh, static_compression
from gearlash.studies.model import Source
from gearlash.system import GearlashError

from .bands import positive_bands

STEP = 0.01  # of a value: between two values that are looked at
MOST = 4  # near a value of 0 steps do not become smaller than the range makes them: 1/400 of it


@dataclass(frozen=True)
class Task:
    """Combinations of inputs to look at (an empty one: the case as it is); without ``bands`` at the present
    value of the axis only."""

    source: Source
    inputs: tuple[ToleranceInput, ...]
    axis: Axis
    present: float
    combinations: tuple[tuple[float, ...], ...]
    bands: bool = True


def work(task: Task, _carry: object) -> Part:
    """A `ToleranceMember` for each combination."""
    case = _case(task.source.case_json or "")
    return Part(tuple(_member(case, task, values) for values in task.combinations))


@lru_cache(maxsize=4)
def _case(text: str) -> Case:
    return Case.from_json(text)


def _member(case: Case, task: Task, values: tuple[float, ...]) -> ToleranceMember:
    settings = {one.path: one.text(value) for one, value in zip(task.inputs, values, strict=bool(values))}
    try:
        member = case.with_overrides(settings) if settings else case
        margin = margin_along(member, task.axis)
    except GearlashError:  # a combination that no pair can have
        return ToleranceMember(values, (), nan, None, 1)
    unsolved = 0

    def heard(at: float) -> float:
        nonlocal unsolved
        found = margin(at)
        unsolved += isnan(found)
        return found

    bands = positive_bands(heard, looked_at(task.axis)) if task.bands else ()
    here = heard(task.present)
    return ToleranceMember(values, bands, here, member.scales.length, unsolved, static_compression(member))


def looked_at(axis: Axis) -> list[float]:
    """The values of an axis, and so many between them that two neighbours lie no farther apart than `STEP` of
    the larger one, or of the range: a resonance is wider than that, whatever was asked for."""
    found: list[float] = []
    span = float(np.ptp(axis.values))
    for low, high in pairwise(axis.values.tolist()):
        widest = max(STEP * max(abs(low), abs(high)), STEP * span / MOST)
        count = max(1, ceil((high - low) / widest))
        found += np.linspace(low, high, count, endpoint=False).tolist()
    return [*found, float(axis.values[-1])]


def margin_along(case: Case, axis: Axis) -> Callable[[float], float]:
    """The margin of the motion of teeth that never part at values of an axis, in the unit of the axis; -inf
    where that motion is unstable, NaN where it was not solved for."""
    family = case.family()[0]
    defaults = family.complete({})
    side = 1 if defaults["load"] > 0.0 else -1
    name, first, last = ends_of(case, axis)
    mesh = ClosedMesh(family, defaults, side, name=name)
    span = float(axis.values[-1] - axis.values[0])

    def margin(at: float) -> float:
        share = (at - float(axis.values[0])) / span
        try:
            return mesh.margin(first + share * (last - first))
        except GearlashError:
            return nan

    return margin


def ends_of(case: Case, axis: Axis) -> tuple[str, float, float]:
    """Short name and dimensionless ends of an axis in this case."""
    low, high = (f"{value!r} {axis.unit}" if axis.unit else value for value in axis.values[[0, -1]].tolist())
    (name, first), (_, last) = case.resolve(axis.name, low), case.resolve(axis.name, high)
    return name, first, last


def present_on(case: Case, axis: Axis) -> float:
    """The case's own value of the parameter, in the unit of the axis."""
    name, first, last = ends_of(case, axis)
    share = (case.family()[0].complete({})[name] - first) / (last - first)
    return float(axis.values[0] + share * np.ptp(axis.values))
