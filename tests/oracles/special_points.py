"""A special point of a branch, solved for again by shooting on another integrator, from a start beside it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from gearlash.branches.continuation import Branch, Extremum, SpecialKind, SpecialPoint
from gearlash.system import ContactRule, Family, System

from .shooting import Found, Returns, closed, endless_at, multiplier_at, torus_at
from .touching_orbits import WINDOW, TouchAt, touching

HALVED = SpecialKind.BRANCH_POINT, SpecialKind.SYMMETRIC
"""Solved for as the doubling of half a period that is followed by X → -X."""


@dataclass(frozen=True)
class Solved:
    """What the oracle found, and how far from it the point of the branch lies, over their sizes."""

    found: Found
    value_apart: float
    state_apart: float


def again(
    family: Family, branch: Branch, special: SpecialPoint, noise: float = 1e-7, window: float = WINDOW
) -> Solved:
    """From a start that is ``noise`` beside the point."""

    def build(value: float) -> System:
        return family.system({**branch.values, branch.name: value})

    point = special.point
    rng, state = np.random.default_rng(len(branch.points)), np.asarray(point.state)
    size, scale = max(1e-3, float(np.abs(state).max())), branch.upper - branch.lower
    start = state + noise * size * rng.normal(size=len(state))
    cycles = float(len(point.strobes) * build(special.value).cycles)
    found = _solved(build, cycles, special, start, special.value + noise * scale, scale, window)
    return Solved(
        found,
        abs(found.value - special.value) / scale,
        float(np.abs(found.state - state).max()) / size,
    )


def _solved(build, cycles: float, special: SpecialPoint, state, value: float, scale: float, window: float):
    kind, multipliers = special.kind, special.point.multipliers
    if kind is SpecialKind.GRAZING:
        e = special.extremum
        assert e is not None
        minimum, begins = e.boundary * e.a0 > 0.0, _through_the_gap(build(value), e)
        touch = TouchAt(
            e.clearance, e.boundary, e.surface == "force", minimum and not begins, e.phase, minimum and begins
        )
        return touching(build, cycles, touch, state, value, scale, window)
    if kind is SpecialKind.TORUS:
        near = multipliers[np.argmin(np.abs(np.abs(multipliers) - 1.0))]
        return torus_at(Returns(build, cycles), state, value, complex(near), scale)
    if kind is SpecialKind.EXISTENCE:
        returns = Returns(lambda value: _without_size(build(value)), cycles)
        return endless_at(returns, state / np.abs(state).max(), value, scale)
    if kind is SpecialKind.FOLD:
        return multiplier_at(Returns(build, cycles), state, value, 1.0, scale)
    if kind is SpecialKind.DOUBLING:
        return multiplier_at(Returns(build, cycles), state, value, -1.0, scale)
    if kind is SpecialKind.JOINS:
        return multiplier_at(Returns(build, 0.5 * cycles), state, value, -1.0, scale)
    assert kind in HALVED
    return multiplier_at(Returns(build, 0.5 * cycles, mirrored=True), state, value, -1.0, scale)


def _through_the_gap(system: System, extremum: Extremum) -> bool:
    """Under `no-tension` contact ends before its boundary is reached, so a minimum that touches it has no
    contact before; behind it has."""
    clearance = system.clearances[extremum.clearance]
    damped = clearance.dampings[0 if extremum.boundary > 0 else 1] != 0.0
    return extremum.surface == "gap" and clearance.contact is ContactRule.NO_TENSION and damped


def _without_size(system: System) -> System:
    """What remains of a motion that is so large that excitation and gaps are nothing beside it."""
    plain = [replace(c, gap_plus=0.0, gap_minus=0.0, offset=[0.0]) for c in system.clearances]
    return replace(system, forcing=0.0 * system.forcing, clearances=tuple(plain))


@dataclass(frozen=True)
class PointChecked:
    """A point of a branch beside the oracle's orbit: largest differences, and contacts that differ."""

    state_apart: float
    multipliers_apart: float
    contacts: str


def point_again(family: Family, branch: Branch, index: int) -> PointChecked:
    """The orbit at a point of the branch, closed by the oracle; its contacts counted by it."""
    point = branch.points[index]
    system = family.system({**branch.values, branch.name: point.value})
    cycles = float(len(point.strobes) * system.cycles)
    returns = Returns(lambda _: system, cycles)
    found = closed(returns, point.state, point.value)
    theirs = sorted(found.multipliers, key=lambda m: (-abs(m), m.imag))
    apart = _nearest(theirs, list(point.multipliers))
    counted = returns.walk(found.state, point.value).contacts(len(system.clearances))
    engaged = tuple((row[0], row[1]) for row in counted)
    said = tuple(tuple(pair) for pair in point.signature.counts)
    size = max(1e-3, float(np.abs(point.state).max()))
    return PointChecked(
        float(np.abs(found.state - point.state).max()) / size,
        apart,
        "" if engaged == said else f"{said} of the branch, {engaged} of the oracle",
    )


def _nearest(one: list, other: list) -> float:
    """Largest distance between multipliers that are paired greedily, over 1 + modulus."""
    worst = 0.0
    for value in one:
        k = int(np.argmin([abs(value - each) for each in other]))
        worst = max(worst, abs(value - other[k]) / (1.0 + abs(value)))
        other.pop(k)
    return worst
