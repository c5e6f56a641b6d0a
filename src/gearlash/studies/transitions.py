"""What happens between two neighbouring points of a sweep: every change of label, located.

Where the period is kept and one count changes by one, the grazing point is solved for; where the period
doubles or halves, the doubling. Where neither explains the change the interval is halved by following the
attractor, until it does, or until the interval is as small as `NARROW` asks, and the change is then called a
fold or a jump."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches import BifurcationPoint, GrazingPoint, locate_grazing, locate_multiplier
from gearlash.orbits import Orbit, Settings, Signature, attractor, grazing_checks, shoot
from gearlash.system import Family, GearlashError, Record, Status, given

GRAZING, DOUBLING, FOLD, JUMP, APERIODIC = "grazing", "doubling", "fold", "jump", "onset of aperiodic motion"
NARROW = 1e-6  # relative width at which halving ends
DEEPEST = 14  # halvings of one interval
TRIES = 4  # extrema tried for one grazing
STEEP = 100.0  # how far an extremum may move, in units of the change of the parameter, and at least SETTLED
SETTLED = 1e-3
SETTINGS = Settings(budget=9_000, patience=600, exponent_periods=1_000)


class Sampled(Protocol):
    """What is needed of a point of a sweep."""

    @property
    def value(self) -> float: ...
    @property
    def label(self) -> str: ...
    @property
    def period(self) -> int: ...
    @property
    def state(self) -> NDArray[np.float64]: ...


@dataclass(frozen=True, eq=False, repr=False)
class Transition(Record):
    """A change of label between parameter values ``lower`` < ``upper``: its kind, the labels on both sides,
    and the point solved for (None where only the interval is known). ``value`` is the point's, or the middle
    of the interval."""

    _told: ClassVar = ("name", "kind", "value", "label_below", "label_above")

    name: str
    kind: str
    lower: float
    upper: float
    label_below: str
    label_above: str
    point: GrazingPoint | BifurcationPoint | None

    @property
    def value(self) -> float:
        return self.point.value if self.point is not None else 0.5 * (self.lower + self.upper)


@dataclass(frozen=True, eq=False)
class _Node:
    """An attractor at one parameter value, reduced to a start."""

    value: float
    label: str
    period: int
    state: NDArray[np.float64]


def transitions(
    family: Family, fixed: Mapping[str, float], name: str, points: Sequence[Sampled], rising: bool = True
) -> tuple[Transition, ...]:
    """All changes of label along ``points`` (ascending in ``name``). ``rising`` says from which side the
    attractor is followed when an interval is halved. Intervals with an end that is not periodic are reported
    without a point."""
    given.instance("family", family, Family, "a Family, as from case.family()[0]")
    given.known("parameter", name, family.defaults)
    finder = _Finder(family, family.complete(fixed), name, given.truth("rising", rising))
    nodes = [_node(point) for point in given.items("points", points, "the points of a sweep, ascending")]
    if not all(one.value < two.value for one, two in pairwise(nodes)):
        raise GearlashError("points: expected values that ascend, each once")
    found: list[Transition] = []
    for below, above in pairwise(nodes):
        if below.label != above.label:
            found.extend(finder.between(below, above, 0))
    return tuple(found)


def _node(point: Sampled) -> _Node:
    if not all(hasattr(point, name) for name in ("value", "label", "period", "state")):
        raise GearlashError(f"points: expected the points of a sweep, not {given.kind_of(point)}")
    return _Node(point.value, point.label, point.period, point.state)


@dataclass(frozen=True, eq=False)
class _Finder:
    family: Family
    values: Mapping[str, float]
    name: str
    rising: bool

    def between(self, below: _Node, above: _Node, depth: int) -> Iterator[Transition]:
        if below.label == above.label:
            return
        if not (below.period and above.period):
            yield self.transition(APERIODIC if below.period or above.period else JUMP, below, above, None)
            return
        direct = self.solve(below, above)
        if direct is not None:
            yield direct
            return
        width = (above.value - below.value) / max(abs(below.value), 1e-12)
        if depth >= DEEPEST or width <= NARROW:
            yield self.jump(below, above)
            return
        middle = self.follow(below, above)
        if middle is None:  # too slow to be proved anything: the change is near
            yield self.jump(below, above)
            return
        yield from self.between(below, middle, depth + 1)
        yield from self.between(middle, above, depth + 1)

    def solve(self, below: _Node, above: _Node) -> Transition | None:
        one, two = Signature.parse(below.label), Signature.parse(above.label)
        changed = one.one_impact_from(two)
        if changed is not None:
            return self.grazing(below, above, *changed)
        if max(one.period, two.period) == 2 * min(one.period, two.period):
            return self.doubling(below, above)
        return None

    def grazing(self, below: _Node, above: _Node, clearance: int, boundary: int) -> Transition | None:
        for node in (below, above):
            orbit = self.orbit(node)
            if orbit is None:
                continue
            near = max(SETTLED, STEEP * (above.value - below.value))
            found = grazing_checks(orbit, within=near, clearance=clearance)
            checks = [check for check in found if check.boundary == boundary][:TRIES]
            for check in checks:
                try:
                    point = locate_grazing(self.family, self.at(node.value), self.name, orbit, check)
                except (GearlashError, np.linalg.LinAlgError):
                    continue
                labels = (point.label_below, point.label_above)
                if (
                    point.status is Status.OK
                    and labels == (below.label, above.label)
                    and self.inside(point, below, above)
                ):
                    return self.transition(GRAZING, below, above, point)
        return None

    def doubling(self, below: _Node, above: _Node) -> Transition | None:
        """The doubling between two orbits, if the impacts double with the period (no grazing lies between
        too)."""
        short, long = sorted((below, above), key=lambda node: node.period)
        if Signature.parse(long.label) != Signature.parse(short.label).twice:
            return None
        orbit = self.orbit(short)
        if orbit is None:
            return None
        try:
            point = locate_multiplier(self.family, self.at(short.value), self.name, orbit, -1)
        except (GearlashError, np.linalg.LinAlgError):
            return None
        if point.status is Status.OK and self.inside(point, below, above):
            return self.transition(DOUBLING, below, above, point)
        return None

    def jump(self, below: _Node, above: _Node) -> Transition:
        """The end of a branch: a fold of the orbit that is left, or a doubling at which it loses its
        stability to something else than its double, if one solves there.
        """
        node = below if self.rising else above
        orbit = self.orbit(node)
        near = 100 * max(above.value - below.value, NARROW * abs(below.value))
        solved = []
        for kind, multiplier in ((FOLD, 1), (DOUBLING, -1)):
            if orbit is None:
                break
            try:
                point = locate_multiplier(self.family, self.at(node.value), self.name, orbit, multiplier)
            except (GearlashError, np.linalg.LinAlgError):
                continue
            if point.status is Status.OK and abs(point.value - node.value) <= near:
                solved.append((abs(point.value - node.value), kind, point))
        if not solved:
            return self.transition(JUMP, below, above, None)
        _, kind, point = min(solved, key=lambda one: one[0])  # what the followed orbit comes to first
        return self.transition(kind, below, above, point)

    def follow(self, below: _Node, above: _Node) -> _Node | None:
        """The attractor half way, reached from the side that the sweep comes from."""
        start = below if self.rising else above
        value = 0.5 * (below.value + above.value)
        system = self.family.system(self.at(value))
        found = attractor(
            system, start.state, SETTINGS, trial=(start.state, max(1, start.period // system.cycles))
        )
        if not isinstance(found, Orbit):
            return None
        return _Node(value, found.label, found.period, found.state)

    def orbit(self, node: _Node) -> Orbit | None:
        props = flow.propagators(self.family.system(self.at(node.value)))
        shot = shoot(props, node.state, max(1, node.period // props.system.cycles))
        return Orbit(props, shot, 0, shot.status, "") if shot.status.ok else None

    def inside(self, point: GrazingPoint | BifurcationPoint, below: _Node, above: _Node) -> bool:
        slack = 1e-9 * abs(above.value)
        return below.value - slack <= point.value <= above.value + slack

    def at(self, value: float) -> dict[str, float]:
        return {**self.values, self.name: value}

    def transition(self, kind: str, below: _Node, above: _Node, point) -> Transition:
        return Transition(self.name, kind, below.value, above.value, below.label, above.label, point)
