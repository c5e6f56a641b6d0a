"""A special orbit along one parameter: the equations of its curves (`curves`) with one unknown less."""

from __future__ import annotations

from collections.abc import Mapping
from math import ceil

import numpy as np

from gearlash.orbits import Orbit
from gearlash.system import Family, GearlashError, HasFamily, family_of, given, plain_values, short_name

from .continuation.equations import scale_of
from .curves.newton import Corrected
from .curves.node import state_at
from .curves.plane import Array, Plane
from .curves.problem import Evaluated, Problem

PART = 0.1  # of the parameter: a step of Newton's method is at most half as long
SIGNED = 1.0  # a parameter that may change its sign (a load, a phase) is taken for this large at least
CLOSED = 1e-10  # residual of a solution


def checked(
    model: Family | HasFamily, values: Mapping[str, float | str] | None, name: str, orbit: Orbit
) -> tuple[Family, dict[str, float], str]:
    """The family, all values of the member that an orbit is of, and the short name of the parameter. Raises
    `GearlashError` for arguments that do not fit."""
    family = family_of(model)
    name = short_name(model, family, name)
    given.known("parameter", name, [parameter.name for parameter in family.parameters])
    given.instance("orbit", orbit, Orbit, "an Orbit, as from gearlash.attractor")
    if orbit.propagators.system.size != len(family.states):
        raise GearlashError(
            f"the orbit has {orbit.propagators.system.size} states, the family {len(family.states)}: "
            "expected an orbit of a member of this family"
        )
    return family, family.complete(plain_values(model, family, values)), name


def begun(family: Family, values: Mapping[str, float], name: str, orbit: Orbit, origin: float) -> Evaluated:
    """The orbit, begun at a phase, as a guess for one at another value of the parameter: nothing is asked of
    it but that it closes."""
    value = float(values[name])
    lowest = next(parameter.lower for parameter in family.parameters if parameter.name == name)
    half = 0.5 * PART * (max(abs(value), SIGNED if lowest < 0.0 else 0.0) or 1e-3)
    plane = Plane(family, values, (name,), (value - half,), (value + half,))
    props = plane.begin(np.array([value]), orbit.propagators)
    size = scale_of(orbit.trace)
    problem = Problem(plane, orbit.shot.period, size, origin)
    state = orbit.state if origin == 0.0 else orbit.trace.at([origin]).state[0]
    return problem.evaluate(np.concatenate([state / size, np.array([value]) / plane.unit]), props)


def error_of(here: Evaluated, jacobian: Array) -> float:
    """Of the parameter: what is left of the equations, and rounding, times how far it moves with them;
    infinite where it does not enter them."""
    rounding = 4.0 * np.finfo(float).eps * np.maximum(1.0, np.abs(here.u[: here.problem.states])).max()
    try:
        gains = np.abs(np.linalg.inv(jacobian)[-1])
    except np.linalg.LinAlgError:
        return float("inf")
    return float(gains @ (np.abs(here.residual) + rounding)) * float(here.problem.plane.unit[0])


def residual_of(corrected: Corrected) -> float:
    """Of the solution, or of what came nearest to one; infinite where nothing could be carried."""
    here = corrected.here or corrected.nearest
    return float("inf") if here is None else float(np.abs(here.residual).max())


def at_phase_zero(here: Evaluated) -> tuple[Array, float]:
    """The orbit (n,) at the first whole number of base periods from where it is begun, and that phase."""
    base = here.props.system.cycles
    zero = float(ceil(here.problem.origin / base - 1e-12) * base)
    return state_at(here, zero), zero
