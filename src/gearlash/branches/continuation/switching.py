"""From a special point of a branch to an orbit of the other branch that begins there.

The other branch leaves along the null vector of the equations. The first orbit on it is solved for at a small
distance along that vector, the parameter being free: so nothing need be known of the side to which it goes.
Source: Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory (2004), sect. 10.2,
doi:10.1007/978-1-4757-3978-7.

Where the orbit meets no boundary its system is linear, and a doubling is degenerate: at that value orbits of
every amplitude exist, up to the one that touches a boundary. The branch that can be followed begins there."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gearlash import flow
from gearlash.orbits import Orbit, orbit_at
from gearlash.system import Family, GearlashError

from .branch import Branch
from .changes import halves
from .corner import HALVES, abrupt
from .equations import Array, Equations, Line
from .extrema import Extrema
from .from_corner import doubled_at_corner, halved_at_corner
from .linear import stays_in
from .node import Node, node_near
from .points import SpecialKind, SpecialPoint

SIZES = (
    1e-2,
    3e-3,
    1e-3,
    3e-4,
    1e-4,
    3e-5,
    1e-5,
    1e-6,
)  # of the scale: first distances along the null vector
HALVED = (1.0, 0.5, 0.25, 0.125)  # of such a distance: orbits that show whether it leads to the special point
STEADY = 0.1  # most by which the direction from the special point may change when the distance is halved
STEADIER = 0.75  # how much less than before, at most, when it is halved again; not asked where it is
STRAIGHT = 0.02  # so little already
BEYOND = (1e-2, 1e-3, 1e-4)  # of the amplitude that touches: how far above it an orbit is solved for
ON_OLD_BRANCH = 0.2  # of that distance: an orbit that lies nearer to the old branch is on it
AMPLITUDE_HALVINGS = 60
LARGEST_AMPLITUDE = 1e6  # of the scale: amplitude up to which a touch is sought


@dataclass(frozen=True, eq=False)
class Switched:
    """An orbit of the other branch, at a value of the parameter."""

    value: float
    orbit: Orbit


def switched(family: Family, branch: Branch, special: SpecialPoint) -> tuple[Switched, ...]:
    """Orbits of the branches that meet this one at a special point: of twice the period at a doubling, of
    half of it where the orbit joins that, both sides of the other branch at a branch point, and where a touch
    makes a corner of the map that of twice or half the period. Empty where none was found near by. Raises
    `GearlashError` for a kind of point at which no branch of periodic orbits begins."""
    line = Line(family, branch.values, branch.name, branch.lower, branch.upper)
    props = line.system_at(special.point.value)
    period = special.point.period // props.system.cycles
    state = special.point.state
    if special.kind is SpecialKind.JOINS:
        single = orbit_at(props, state, period // 2)
        return () if single is None else (Switched(special.point.value, single),)
    if special.kind is SpecialKind.DOUBLING:
        start = _start(line, special, 2 * period)
        node = _doubled_linear(start) if special.linear else _beside(start, 1.0)
        return () if node is None else (Switched(node.value, node.orbit),)
    if special.kind in (SpecialKind.BRANCH_POINT, SpecialKind.SYMMETRIC):
        start = _start(line, special, period)
        find = _linear if special.linear else _beside
        nodes = [find(start, sign) for sign in (1.0, -1.0)]
        return tuple(Switched(node.value, node.orbit) for node in nodes if node is not None)
    if special.extremum is not None and abrupt(props.system, special.extremum):
        if HALVES in special.note:
            return tuple(Switched(value, orbit) for value, orbit in halved_at_corner(line, special))
        doubled = doubled_at_corner(line, branch, special)
        return () if doubled is None else (Switched(*doubled),)
    raise GearlashError(f"at a {special.kind} no other branch of periodic orbits begins")


def doubled_beside(line: Line, special: SpecialPoint, size: float) -> Node | None:
    """The orbit of twice the period at a distance ``size`` (of the scale) from a doubling; of a linear motion
    the first one that touches."""
    start = _start(
        line, special, 2 * special.point.period // line.system_at(special.point.value).system.cycles
    )
    if special.linear:
        return _doubled_linear(start)
    node = _at(start, size)
    if node is None or not _is_other(start, node, size) or not _leads_back(start, node, size):
        return None
    return node


@dataclass(frozen=True, eq=False)
class _Start:
    """The orbit of the special point run through for the period of the other branch, with the null vector
    (m·n+1,) of the equations and the old branch's direction; ``base``: unknowns of the special point itself,
    which at a branch point lies a little aside of the orbit."""

    node: Node
    null: Array
    base: Array

    @property
    def doubled(self) -> bool:
        return bool(self.node.equations.period % 2 == 0 and np.linalg.norm(halves(self.node)) < 1e-6)


def _start(line: Line, special: SpecialPoint, period: int) -> _Start:
    props = line.system_at(special.point.value)
    orbit = orbit_at(props, special.point.state, period, iterations=1)
    if orbit is None:
        raise GearlashError(
            f"the orbit of the special point is not one of this family, at {special.value:.10g}"
        )
    equations = Equations.of(line, orbit)
    here = equations.evaluate(equations.unknowns(orbit, special.point.value), props)
    if here is None:
        raise GearlashError("the orbit of the special point cannot be carried")
    slope = equations.slope(here)
    matrix = equations.matrix(here, slope, np.zeros(len(here.u)))[:-1]
    null = np.append(np.linalg.svd(matrix[:, :-1])[2][-1], 0.0)
    along = np.linalg.lstsq(matrix[:, :-1], -slope, rcond=1e-7)[0]  # the old branch, orthogonal to it
    direction = np.append(along, 1.0)
    node = Node(equations, here, slope, direction / np.linalg.norm(direction), orbit, Extrema.of(orbit))
    base = here.u + direction * (special.value - special.point.value) / line.unit
    return _Start(node, null, base)


def _beside(start: _Start, sign: float) -> Node | None:
    """An orbit of the other branch near the special point, within the limits of the parameter."""
    line = start.node.equations.line
    for size in SIZES:
        node = _at(start, sign * size)
        if node is None or not line.lower <= node.value <= line.upper:
            continue
        if _is_other(start, node, size) and _leads_back(start, node, sign * size):
            return node
    return None


def _leads_back(start: _Start, node: Node, amplitude: float) -> bool:
    """Whether an orbit belongs to a branch through the special point: nearer and nearer to it, orbits lie in
    a direction from it that settles. Of a branch that only passes by they do not come nearer."""
    ways = [(node.u - start.base) / amplitude]
    for part in HALVED[1:]:
        nearer = _at(start, part * amplitude)
        if nearer is None or not _is_other(start, nearer, abs(part * amplitude)):
            return False
        ways.append((nearer.u - start.base) / (part * amplitude))
    turns = [float(np.linalg.norm(two - one)) for one, two in pairwise(ways)]
    return max(turns) <= STEADY and all(two <= max(STEADIER * one, STRAIGHT) for one, two in pairwise(turns))


def _at(start: _Start, amplitude: float) -> Node | None:
    base, null = start.base, start.null
    target = float(null @ base) + amplitude
    found = node_near(start.node.equations, base + amplitude * null, null, target, None)
    return found.node


def _is_other(start: _Start, node: Node, size: float) -> bool:
    if start.doubled:
        return float(np.linalg.norm(halves(node))) > ON_OLD_BRANCH * size
    return float(np.linalg.norm(node.u - start.base)) < 10.0 * size


def _linear(start: _Start, sign: float) -> Node | None:
    """An orbit just above the amplitude at which the first of a linear system's orbits touches."""
    amplitude = _touching(start, sign)
    if amplitude is None:
        return None
    for beyond in BEYOND:
        size = (1.0 + beyond) * amplitude
        node = _at(start, size)
        if node is None or not any(map(any, node.orbit.signature.counts)):
            continue
        if float(np.linalg.norm(node.u - start.base - size * start.null)) <= STEADY * abs(size):
            return node
    return None


def _doubled_linear(start: _Start) -> Node | None:
    """The same of the orbits of twice the period, which a period later are those of the other sign."""
    return _linear(start, 1.0) or _linear(start, -1.0)


def _touching(start: _Start, sign: float) -> float | None:
    """The amplitude along the null vector at which a boundary is met first, by halvings on the regions."""
    equations, props, sides = start.node.equations, start.node.here.props, stays_in(start.node.orbit.trace)

    def meets(amplitude: float) -> bool:
        state = equations.states(start.node.u + amplitude * start.null)[0]
        return stays_in(flow.trace(props, state, float(start.node.orbit.period))) != sides

    high = sign
    while not meets(high):
        high *= 2.0
        if abs(high) > LARGEST_AMPLITUDE:
            return None
    low = 0.0
    for _ in range(AMPLITUDE_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if meets(middle) else (middle, high)
    return high
