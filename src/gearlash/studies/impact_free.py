"""Speeds free of impacts, from the motion of a mesh that never opens.

While teeth stay in contact the pair is linear with periodic coefficients and has one periodic motion a speed.
It is a motion of the real pair exactly where its least compression is positive: so the margin of the closed
mesh, a continuous function of speed, says where impact-free motion exists, whatever the present motion is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import count
from math import ceil, copysign, inf, isnan, log, nan

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.case import Case
from gearlash.flow import MINUS, PLUS, linear_motion
from gearlash.orbits import Orbit, orbit_at
from gearlash.orbits.sign_change import SignChange, first_sign_change
from gearlash.results.impact_free import Ending, ImpactFree
from gearlash.system import ContactRule, Family, GearlashError, Parameter, System, given, plain_values
from gearlash.system.record import changed

from .model import Model, Source

SPEED_STEP = 1.01  # factor from one speed of the search to the next
SPEED_REACH = 2.0  # factor to which it goes, up and down
SLOPE_STEP = 1e-6  # of the speed: over which slopes are taken, for errors
MULTIPLIER_ERROR = 1e-13  # of a multiplier of a linear motion
SPEEDS = 2 * ceil(log(SPEED_REACH) / log(SPEED_STEP))  # that it tries, about, where nothing changes


def impact_free_speeds(
    model: Model,
    values: Mapping[str, float | str] | None = None,
    *,
    tell: Callable[[int, int], object] | None = None,
) -> ImpactFree | None:
    """Speeds at which the motion of a gear pair whose teeth never part exists and is stable.

    Looked for from the present speed down to half of it and up to twice, within the range of the parameter.

    Parameters
    ----------
    model : Case or Family
        A gear pair. Of other systems a parameter of the name ``load`` says nothing about contact.
    values : mapping of str to float or str, optional
        Of parameters, over those of the model; a case takes every name and unit of its file.
    tell : callable, optional
        Hears how many speeds were tried, out of about how many.

    Returns
    -------
    ImpactFree or None
        None where there is no such motion to look for: without load, as no side carries it; with several
        clearances; and for a case that is no gear pair. Speeds of the search are one per cent apart, with
        closer looks where the margin is lowest: what comes and goes within one per cent elsewhere may be
        missed. Other motions at the same speeds are not looked for.

    Raises
    ------
    GearlashError
        For names and values that do not fit, and where a member cannot be built.

    Examples
    --------
    >>> import gearlash as gl
    >>> found = gl.impact_free_speeds(gl.load_case("article"))
    >>> found.here, round(found.lower, 4), round(found.upper, 4)
    (True, 0.9725, 1.112)
    """
    family = Source.of(model).family()
    parameters = family.complete(plain_values(model, family, values))
    if tell is not None:
        given.function("tell", tell, "a function of two whole numbers")
    if isinstance(model, Case) and not model.between_teeth:
        return None
    if parameters.get("load", 0.0) == 0.0 or len(family.system(parameters).clearances) != 1:
        return None
    omega, tried, side = parameters["omega"], count(1), 1 if parameters["load"] > 0.0 else -1
    lowest, highest = _reach(next(p for p in family.parameters if p.name == "omega"), omega)
    closed = ClosedMesh(family, parameters, side)

    def margin(at: float) -> float:
        if tell is not None:
            tell(min(next(tried), SPEEDS), SPEEDS)
        return closed.margin(at)

    known = margin(omega)
    here = known > 0.0
    up, searched_to = first_sign_change(margin, (omega, known), SPEED_STEP, highest)
    if not here and up is not None:  # what lies farther off than this one is not the nearest
        lowest = max(lowest, 2.0 * omega - up.value)
    down, searched_from = first_sign_change(margin, (omega, known), 1.0 / SPEED_STEP, lowest)
    ends = [end for end in (down, up) if end is not None]
    nearest = None if here else min(ends, key=lambda end: abs(end.value - omega), default=None)
    down, up = (down, up) if here else (None, None)
    return ImpactFree(
        here=here,
        lower=down.value if down else None,
        upper=up.value if up else None,
        lower_error=closed.error(down) if down else None,
        upper_error=closed.error(up) if up else None,
        lower_ending=ending(down) if down else None,
        upper_ending=ending(up) if up else None,
        nearest=nearest.value if nearest else None,
        nearest_error=closed.error(nearest) if nearest else None,
        searched_from=searched_from,
        searched_to=searched_to,
        step=SPEED_STEP - 1.0,
    )


@dataclass(frozen=True)
class ClosedMesh:
    """The pair whose mesh never opens, at any value of a parameter."""

    family: Family
    parameters: Mapping[str, float]
    side: int
    name: str = "omega"

    def system(self, value: float) -> System:
        return self.family.system({**self.parameters, self.name: value})

    def orbit(self, omega: float) -> Orbit | None:
        closed = _closed(self.system(omega), self.side)
        return _orbit(closed, _at_rest(closed))

    def margin(self, value: float) -> float:
        return closed_margin(self.system(value), self.side)

    def error(self, change: SignChange) -> float:
        """Of the speed at a change: what lies between its two sides, and how far an error of the margin, or
        of the largest multiplier where stability ends, moves it."""
        between = abs(change.other - change.value)
        within = change.value + copysign(SLOPE_STEP * change.value, change.value - change.other)
        orbit, inner = self.orbit(change.value), self.orbit(within)
        if orbit is None or inner is None or isnan(change.beyond):
            return between
        if change.beyond == -inf:
            rise, error = abs(orbit.leading) - abs(inner.leading), MULTIPLIER_ERROR
        else:
            rise, error = self.margin(change.value) - self.margin(within), orbit.shot.error
        slope = abs(rise) / abs(within - change.value)
        return between + (error / slope if slope > 0.0 else abs(within - change.value))


def _reach(parameter: Parameter, omega: float) -> tuple[float, float]:
    """The least and the largest speed of the search."""
    return max(omega / SPEED_REACH, parameter.lower), min(omega * SPEED_REACH, parameter.upper)


def closed_margin(system: System, side: int) -> float:
    """Least compression (in X) of the periodic motion with the mesh closed on one side (+1 drive, -1 back);
    -inf where that motion is unstable, NaN where it was not solved for. With the rule `no-tension` contact
    ends with its force: the least force instead.
    """
    try:
        motion = linear_motion(system, PLUS if side > 0 else MINUS)
    except GearlashError:  # too many cells, or too much memory
        return nan
    if motion is None:
        return nan
    if not motion.stable:
        return -inf
    pressed = system.clearances[0].contact is ContactRule.NO_TENSION
    return motion.least(motion.force if pressed else motion.beyond, side)


def static_compression(case: Case) -> float:
    """Compression (in X) of the mean stiffness under the mean torque of a case alone; 0 without torque."""
    numbers = case.family()[0].complete({})
    return abs(numbers["load"] / numbers["rotation_factor"])


def linear_states(system: System) -> Iterator[NDArray[np.float64]]:
    """States at phase zero of the periodic motions that a system of one clearance would have if it were in
    contact on one side all the time, or never: near a touch the real motion is near to one of them."""
    (clearance,) = system.clearances
    none = np.zeros(1)
    never = replace(clearance, stiffness_plus=none, stiffness_minus=none)
    for linear in (_closed(system, 1), _closed(system, -1), replace(system, clearances=(never,))):
        orbit = _orbit(linear)
        if orbit is not None:
            state, orbit = orbit.state, None  # whose tables are not held while others are built
            yield state


def _orbit(system: System, near: NDArray[np.float64] | None = None) -> Orbit | None:
    """The periodic motion of a linear system, if it has one, by Newton's method from a state ``near`` it."""
    try:
        guess = [0.0] * system.size if near is None else near
        return orbit_at(flow.propagators(system), guess, 1)
    except GearlashError:
        return None


def _at_rest(closed: System) -> NDArray[np.float64] | None:
    """The state in which mean forces hold a mesh that is closed on one side, None where there is no one such
    state. From there Newton mostly stays on this side, and what lies beyond needs no tables."""
    (mesh,) = closed.clearances
    stiffness = float(mesh.stiffness_plus[0])  # that of both sides
    push = stiffness * (float(mesh.offset[0]) + mesh.gap_plus)
    try:
        matrix = closed.matrix + stiffness * np.outer(mesh.g, mesh.h)
        found: NDArray[np.float64] = np.linalg.solve(matrix, push * mesh.g - closed.forcing[:, 0]).astype(
            float
        )
    except np.linalg.LinAlgError:
        return None
    return found


def _closed(system: System, side: int) -> System:
    """The same system with a gap of no width where this side begins, and this side's stiffness and damping
    beyond it as well. While contact lasts all contact rules are one.
    """
    clearance = system.clearances[0]
    gap = clearance.gap_plus if side > 0 else -clearance.gap_minus
    stiffness = clearance.stiffness_plus if side > 0 else clearance.stiffness_minus
    closed = changed(
        clearance, gap_plus=gap, gap_minus=-gap, stiffness_plus=stiffness, stiffness_minus=stiffness,
        damping=clearance.dampings[0 if side > 0 else 1], damping_minus=None, contact=ContactRule.ALWAYS,
    )  # fmt: skip
    return changed(system, clearances=(closed,))


def ending(change: SignChange) -> Ending:
    """What ends the impact-free motion at a change of its margin: beyond it the motion meets the gap, is not
    stable, or was not solved for."""
    if isnan(change.beyond):
        return "unsolved"
    return "contact" if change.beyond > -inf else "stability"
