"""The parameter that is solved for: its name, its range, and how far one step of Newton may move it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.orbits import Orbit
from gearlash.system import (
    Family,
    GearlashError,
    HasFamily,
    Parameter,
    family_of,
    given,
    plain_values,
    short_name,
)

PART = 0.05  # of the parameter
SIGNED = 1.0  # a parameter that may change its sign (a load, a phase) is taken for this large at least
UNBUILT = (GearlashError, np.linalg.LinAlgError)
"""What a system that cannot be built or carried raises."""


def named(family: Family, name: str) -> Parameter:
    """The parameter of this name. Raises `UnknownNameError` where the family has none."""
    by_name = {parameter.name: parameter for parameter in family.parameters}
    return by_name[given.known("parameter", name, by_name)]


def checked(
    model: Family | HasFamily, values: Mapping[str, float | str] | None, name: str, orbit: Orbit
) -> tuple[Family, dict[str, float], str]:
    """The family, all values of the member that an orbit is of, and the short name of the parameter. Raises
    `GearlashError` for arguments that do not fit."""
    family = family_of(model)
    name = short_name(model, family, name)
    given.instance("orbit", orbit, Orbit, "an Orbit, as from gearlash.attractor")
    if orbit.propagators.system.size != len(family.states):
        raise GearlashError(
            f"the orbit has {orbit.propagators.system.size} states, the family {len(family.states)}: "
            "expected an orbit of a member of this family"
        )
    return family, family.complete(plain_values(model, family, values)), name


def longest_step(family: Family, name: str, value: float) -> float:
    """The longest step from ``value`` of the parameter ``name``: 5 % of it. One that may be negative would
    never leave zero so; it may move by 0.05."""
    return PART * max(abs(value), SIGNED if named(family, name).lower < 0.0 else 0.0)


def within_range(family: Family, name: str, value: float, step: float) -> float:
    """The part (0 to 1) of a step from ``value`` that stays in the range of the parameter: where all of it
    would leave it, half of the way to the end of the range, so that a solution at the end itself is come to
    as near as rounding."""
    parameter = named(family, name)
    if not np.isfinite(step):
        return 0.0
    if parameter.lower <= value + step <= parameter.upper:
        return 1.0
    end = parameter.upper if step > 0.0 else parameter.lower
    return max(0.0, 0.5 * (end - value) / step)


def difference(family: Family, name: str, value: float, size: float) -> float:
    """The step for a derivative along the parameter: upwards, or downwards where that leaves the range."""
    return size if value + size <= named(family, name).upper else -size


def member(
    family: Family, values: Mapping[str, float], name: str, value: float, reuse: Propagators | None = None
) -> Propagators:
    """Propagators of the member at one value of the parameter. Raises what `UNBUILT` names."""
    return flow.propagators(family.system({**values, name: value}), reuse)
