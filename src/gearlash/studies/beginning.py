"""The periodic orbit with which following a parameter begins, as a user has it: of a study or of a branch."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from typing import TYPE_CHECKING, cast

import numpy as np

from gearlash import flow
from gearlash.orbits import Orbit, orbit_at
from gearlash.results import Point
from gearlash.system import Family, GearlashError

if TYPE_CHECKING:  # continuation is loaded by what continues branches only
    from gearlash.branches.continuation import BranchPoint, SpecialPoint

SAME_STATE = 1e-4  # of the largest state: an orbit that lies farther from the start is another one


def value_of(start: Point | BranchPoint | SpecialPoint, name: str) -> float:
    """The value of the parameter that a start brings with it. Raises where it brings none."""
    value = _point_of(start).value
    if not isfinite(value):
        made = f"gearlash.point(model, values, name={name!r})"
        raise GearlashError(f"start: the point does not say its {name}: make it with {made}")
    return value


def member_of(
    family: Family, given: Mapping[str, float], name: str, start: Point | BranchPoint | SpecialPoint
) -> dict[str, float]:
    """The values of the member that a start is an orbit of, as far as it and those that are ``given`` tell.

    A special point brings all of them. Any other point brings one, of a parameter that it does not name: it
    is taken for ``name``, unless that is given, too, and the orbit is one of the member that is given."""
    own = getattr(start, "values", None)
    if own is not None:
        given = {**own, **given}
        return {**given, name: value_of(start, name)} if getattr(start, "name", name) == name else given
    taken = {**given, name: value_of(start, name)}
    if name in given and given[name] != taken[name]:
        point = _point_of(start)
        if not _is_one(family, taken, point) and _is_one(family, given, point):
            return dict(given)
    return taken


def orbit_of(
    family: Family, values: Mapping[str, float], name: str, start: Orbit | Point | BranchPoint | SpecialPoint
) -> Orbit:
    """The orbit that a start is, at ``values``.

    A start tells one parameter at most. So whether it is an orbit at these values is looked at: one that was
    found at other values is refused."""
    point = start if isinstance(start, Orbit) else _point_of(start)
    if not isinstance(point, Orbit) and point.period < 1:
        raise GearlashError(
            f"start: it is {point.label or point.status}, not periodic: expected a periodic motion"
        )
    found = _orbit_at(family, values, point)
    if found is None:
        at = ", ".join(f"{each} = {values[each]:.10g}" for each in values)
        raise GearlashError(
            f"start: it is no periodic motion at {at}. Expected one that was found there: give as values "
            f"all other parameters that it was found at; the value that a point brings is taken for {name}. "
            f"For a point of a branch in another parameter give all values, {name} and that one included; "
            "a special point of a branch brings them itself"
        )
    return found


def _is_one(family: Family, values: Mapping[str, float], point: Point | BranchPoint) -> bool:
    """Whether it is a periodic motion at these values."""
    try:
        complete = family.complete(values)
    except GearlashError:  # a value that another parameter may have, this one may not
        return False
    return point.period >= 1 and _orbit_at(family, complete, point) is not None


def _orbit_at(
    family: Family, values: Mapping[str, float], point: Orbit | Point | BranchPoint
) -> Orbit | None:
    """The orbit at these values, if the state of the point lies on it."""
    props = flow.propagators(family.system(values))
    periods = point.shot.period if isinstance(point, Orbit) else point.period // props.system.cycles
    found = orbit_at(props, point.state, periods)
    return None if found is None or _apart(found.state, point.state) > SAME_STATE else found


def _point_of(start: Point | BranchPoint | SpecialPoint) -> Point | BranchPoint:
    """The orbit of a special point, or the point itself."""
    return cast("Point | BranchPoint", getattr(start, "point", start))


def _apart(left: np.ndarray, right: np.ndarray) -> float:
    """Distance of two states relative to the larger, in the largest component."""
    largest = max(float(np.abs(left).max()), float(np.abs(right).max()))
    return float(np.abs(left - right).max()) / largest if largest > 0.0 else 0.0
