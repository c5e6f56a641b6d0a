"""Speeds free of impacts, from the motion of a mesh that never opens.

While teeth stay in contact the pair is linear with periodic coefficients and has one periodic motion a speed.
It is a motion of the real pair exactly where its least compression is positive: so the margin of the closed
mesh, a continuous function of speed, says where impact-free motion exists, whatever the present motion is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from itertools import pairwise
from math import inf

from gearlash import flow
from gearlash.cli.answers.impact_free import ImpactFree
from gearlash.orbits import shoot
from gearlash.orbits.results import Orbit
from gearlash.system import Family, GearlashError, Status, System

STEP = 1.01  # factor from one speed of the search to the next
REACH = 2.0  # factor to which it goes, up and down
TOLERANCE = 1e-9  # relative, of an end


def impact_free_speeds(family: Family, parameters: Mapping[str, float]) -> ImpactFree | None:
    """Looks from the present speed up and down to `REACH` times it. None without load: no side carries it.

    An interval narrower than one per cent may lie between two speeds of the search and be missed.
    """
    if parameters["load"] == 0.0:
        return None
    omega = parameters["omega"]

    def margin(at: float) -> float:
        return closed_margin(
            family.system({**parameters, "omega": at}), 1 if parameters["load"] > 0.0 else -1
        )

    here = margin(omega) > 0.0
    up, down = (_change(margin, omega, factor) for factor in (STEP, 1.0 / STEP))
    ends = [end for end in (down, up) if end is not None]
    nearest = min(ends, key=lambda end: abs(end - omega), default=None)
    return ImpactFree(
        here=here,
        lower=down if here else None,
        upper=up if here else None,
        nearest=None if here else nearest,
        searched_from=omega / REACH,
        searched_to=omega * REACH,
    )


def closed_margin(system: System, side: int) -> float:
    """Least compression (in X) of the periodic motion with the mesh closed on one side (+1 drive, -1 back);
    -inf where that motion is unstable or was not found.
    """
    try:
        props = flow.propagators(_closed(system, side))
        shot = shoot(props, [0.0] * system.size, 1)
    except GearlashError:
        return -inf
    orbit = Orbit(props, shot, 0, shot.status, "")
    if shot.status not in (Status.OK, Status.UNCERTAIN) or not orbit.stable:
        return -inf
    gap = system.clearances[0].gap_plus if side > 0 else -system.clearances[0].gap_minus
    positions = orbit.extrema.displacement if len(orbit.extrema) else orbit.trace.samples(2).displacement
    return float((side * (positions - gap)).min())


def _closed(system: System, side: int) -> System:
    """The same system with a gap of no width where this side begins, and this side's stiffness beyond it as
    well.
    """
    clearance = system.clearances[0]
    gap = clearance.gap_plus if side > 0 else -clearance.gap_minus
    stiffness = clearance.stiffness_plus if side > 0 else clearance.stiffness_minus
    closed = replace(
        clearance, gap_plus=gap, gap_minus=-gap, stiffness_plus=stiffness, stiffness_minus=stiffness
    )
    return replace(system, clearances=(closed,))


def _change(margin: Callable[[float], float], start: float, factor: float) -> float | None:
    """The first change of sign of the margin from ``start`` on, as the value on its positive side."""
    speeds = [start]
    while speeds[-1] < REACH * start and speeds[-1] > start / REACH:
        speeds.append(speeds[-1] * factor)
    known = margin(start)
    for here, there in pairwise(speeds):
        found = margin(there)
        if (found > 0.0) != (known > 0.0):
            return _bisected(margin, here, there, known > 0.0)
        known = found
    return None


def _bisected(margin: Callable[[float], float], here: float, there: float, positive_here: bool) -> float:
    while abs(there - here) > TOLERANCE * abs(here):
        middle = 0.5 * (here + there)
        if (margin(middle) > 0.0) == positive_here:
            here = middle
        else:
            there = middle
    return here if positive_here else there
