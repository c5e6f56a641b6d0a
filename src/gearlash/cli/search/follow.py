"""Following one attractor away from where it was found, to the first grazing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from gearlash.branches import GrazingPoint
from gearlash.cli.answers.graze import Passed, Path
from gearlash.orbits import Settings
from gearlash.results import Point
from gearlash.studies.row import Trail, onward, step
from gearlash.studies.transitions import GRAZING, Transition, transitions
from gearlash.system import Family

FIRST, GROWTH, LONGEST = 1e-3, 1.4, 1e-2  # steps, relative to the value at the start
REACH = 0.95  # as far as it is followed, relative to that value
SMALL = 1e-3  # what counts as the size of a value at zero


def follow(
    family: Family,
    values: Mapping[str, float],
    name: str,
    start: Point,
    direction: Literal["down", "up"],
    settings: Settings,
) -> tuple[Path, GrazingPoint | None]:
    """Follows the attractor ``start`` in one parameter until a contact is born or dies in a touch."""
    sign = 1.0 if direction == "up" else -1.0
    parameter = next(p for p in family.parameters if p.name == name)
    size = max(abs(start.value), SMALL)
    last, trail, passed = start, onward(Trail(start.state, None), start), []
    width = FIRST * size
    while last.periodic:
        value = last.value + sign * width
        if not parameter.lower <= value <= parameter.upper or abs(value - start.value) > REACH * size:
            return Path(direction, last.value, "end of the search", tuple(passed)), None
        point = step(family, {**values, name: value}, name, trail, settings)
        for change in _changes(family, values, name, last, point, direction):
            if change.kind == GRAZING and isinstance(change.point, GrazingPoint):
                ended = f"grazing at {change.value:.10g}"
                return Path(direction, change.value, ended, tuple(passed)), change.point
            passed.append(Passed(change.kind, change.value, change.label_below, change.label_above))
        last, trail = point, onward(trail, point)
        width = min(width * GROWTH, LONGEST * size)
    return Path(
        direction, last.value, f"the motion there is {last.label or last.status}", tuple(passed)
    ), None


def _changes(
    family: Family, values: Mapping[str, float], name: str, last: Point, point: Point, direction: str
) -> tuple[Transition, ...]:
    """Changes of label between neighbours, in the order in which they are met."""
    if last.label == point.label:
        return ()
    rising = direction == "up"
    found = transitions(family, values, name, (last, point) if rising else (point, last), rising)
    return found if rising else found[::-1]
