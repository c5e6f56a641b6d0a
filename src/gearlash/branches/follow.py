"""A stable orbit followed in one parameter, through touches and doublings, to where it ends.

Steps are as long as the branch is straight, and halved where the next orbit is not plainly the continuation
of the last (`stepping`). What stops a step is solved for from the last orbit before it (`causes`), so it is
found however near it lies and whatever the motion is beyond, and believed if the branch can be followed to
just before it. Two touches within a step that is straight to a few per cent, the second undoing the first,
may be missed. Folds are ends here: continuation round them has its place beside this."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from gearlash.orbits import Orbit
from gearlash.system import Family, HasFamily, given, plain_values

from .bifurcation import BifurcationPoint
from .causes import Causes, slack
from .ending import Outcome, SolvedPoint, at_point, ends_branch, without_point
from .grazing_point import GrazingPoint
from .node import Array, Node
from .stepping import Earlier, Line, Refusal, Step
from .steps import UNBUILT, checked

FIRST_STEP, LONGEST_STEP, SHORTEST_STEP = 1e-6, 1e-2, 1e-9  # of the scale: first, longest and shortest step
STRAIGHT, BENT = 0.02, 0.06  # bends below which the next step is longer
MOST_STEPS = 20_000  # steps
LONGEST_PERIOD = 64  # base periods: of the orbit of a doubling that is still followed
AFTER = (1e-8, 1e-9, 1e-10)  # relative distances beyond a touch at which the orbit is taken up again
DOUBLED = (1e-5, 1e-6, 1e-7)  # the same beyond a doubling
DIRECTIONS = (
    1e-4,
    1e-3,
    1e-2,
    3e-2,
    0.1,
)  # of the ranges: how far beside the single orbit the doubled is sought
DOUBLED_NEAR = 0.2  # of the ranges: how far from the single orbit the doubled one may lie there
OF_CONTACTS = (Refusal.LABEL, Refusal.CROSSED, Refusal.TOUCHED)
"""Refusals that touches explain; an orbit that is not stable is explained by none."""


@dataclass(frozen=True, eq=False)
class Passage:
    """A special point on the way of an orbit.

    Parameters
    ----------
    point : GrazingPoint or BifurcationPoint
    before : Node
        The orbit just before it.
    after : Node or None
        The orbit beyond that is followed on; None where none is.
    """

    point: SolvedPoint
    before: Node
    after: Node | None

    @property
    def value(self) -> float:
        """Of the parameter, at the point."""
        return self.point.value


@dataclass(frozen=True, eq=False)
class PathEnd:
    """Where an orbit is followed no farther, and why.

    Parameters
    ----------
    outcome : Outcome
    last : Node
        The last orbit.
    beyond : float
        The nearest value at which a step was refused, its own where it arrived: a fold that is no `Passage`
        lies between them.
    reason : str
        In words, where no step was taken any more.
    """

    outcome: Outcome
    last: Node
    beyond: float
    reason: str = ""


def follow(
    model: Family | HasFamily,
    name: str,
    orbit: Orbit,
    to: float | str,
    *,
    values: Mapping[str, float | str] | None = None,
    tell: Callable[[float], object] | None = None,
    longest: int = LONGEST_PERIOD,
) -> Iterator[Passage | PathEnd]:
    """Follows a stable orbit in one parameter: everything it meets on the way, in order, then its end.

    Steps are as long as the branch is straight; none is taken that may land on another motion. What stops a
    step is solved for: a touch, a doubling, a fold.

    Parameters
    ----------
    model : Case or Family
    name : str
        The parameter: a short name, or the physical one of a case.
    orbit : Orbit
        Stable, found at ``values``.
    to : float or str
        The value of ``name`` to go to, dimensionless or with a unit of the case.
    values : mapping of str to float or str, optional
        Parameters of the member that the orbit is of, ``name`` among them; the model's own where nothing is
        given.
    tell : callable, optional
        Hears the dimensionless value after every step.
    longest : int
        Period in base periods up to which the orbit born at a doubling is followed on.

    Yields
    ------
    Passage or PathEnd
        One `PathEnd`, which is the last.

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash.branches import follow
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.attractor(family.system({"omega": 0.8}), family.start())
    >>> touch, end = follow(family, "omega", orbit, 0.825, values={"omega": 0.8})
    >>> round(touch.value, 6), str(touch.after.label), str(end.outcome)
    (0.820631, '1-1-0', 'arrived')
    """
    family, members, short = checked(model, values, name, orbit)
    target = plain_values(model, family, {name: to})[short]
    start = members[short]
    scale = max(abs(start), abs(target - start))
    line = Line(family, members, short, scale)
    return _Follower(line, target, tell, given.whole("longest", longest)).run(Node(start, orbit))


def joins(
    family: Family, values: Mapping[str, float], name: str, before: Node, earlier: Earlier, after: Node
) -> bool:
    """Whether ``after`` is the continuation of ``before``, as `follow` would find in one step, and not too
    long a one; ``earlier``: orbits of the branch before that, the last first, one at least."""
    width, scale = abs(after.value - before.value), max(abs(before.value), abs(after.value))
    if not earlier or width > LONGEST_STEP * scale:
        return False
    return Line(family, values, name, scale).judged(before, earlier, after).refusal is None


class _Follower:
    def __init__(self, line: Line, to: float, tell: Callable[[float], object] | None, longest: int):
        self.line, self.to, self.tell, self.longest = line, to, tell, longest
        self.causes: dict[
            tuple[bool, bool], Causes
        ] = {}  # that lie ahead of one orbit, by what was looked for

    def run(self, node: Node) -> Iterator[Passage | PathEnd]:
        earlier: Earlier = ()
        sign = 1.0 if self.to > node.value else -1.0
        width = first = FIRST_STEP * self.line.scale
        for _ in range(MOST_STEPS):
            if node.value == self.to:
                yield PathEnd(Outcome.ARRIVED, node, node.value)
                return
            value = node.value + sign * width
            if sign * (self.to - value) <= 0.5 * width:
                value = self.to if sign * (self.to - value) <= 0.0 else 0.5 * (node.value + self.to)
            step = self.line.step(node, earlier, value)
            if step.refusal is None and step.node is not None:
                earlier, node = (node, *earlier[:1]), step.node
                width = self.longer(width, step)
                if self.tell is not None:
                    self.tell(node.value)
                continue
            met = self.explained(node, earlier, value, step)
            if met is not None:
                yield met
                if met.after is None:
                    yield PathEnd(at_point(met.point, met.before, self.longest), met.before, met.value)
                    return
                node, earlier, width = met.after, (), first
                continue
            width = 0.5 * abs(value - node.value)
            if width < SHORTEST_STEP * self.line.scale:
                yield PathEnd(
                    without_point(self.line, node, step.refusal),
                    node,
                    value,
                    step.reason or str(step.refusal),
                )
                return
        yield PathEnd(Outcome.LOST, node, node.value, f"{MOST_STEPS} steps were not enough")

    def longer(self, width: float, step: Step) -> float:
        factor = 3.0 if step.bend < STRAIGHT else 1.5 if step.bend < BENT else 1.0
        return min(factor * width, LONGEST_STEP * self.line.scale)

    def ahead(self, node: Node, earlier: Earlier, value: float, refusal: Refusal | None) -> Causes:
        """What may have stopped a step, solved for once an orbit."""
        key = refusal is not Refusal.UNSTABLE, refusal not in OF_CONTACTS
        found = self.causes.get(key)
        if found is None or found.before is not node:
            touches, losses = key
            found = Causes.ahead(self.line, node, earlier, value, touches=touches, losses=losses)
            self.causes[key] = found
        return found

    def explained(self, node: Node, earlier: Earlier, value: float, step: Step) -> Passage | None:
        """The point that stopped the step, if one is found on the way and the branch leads up to it."""
        sign = 1.0 if value > node.value else -1.0
        for point in self.ahead(node, earlier, value, step.refusal).up_to(value, sign):
            if ends_branch(point, node):
                return Passage(point, node, self.joined(point, node, sign))
            just_before = point.value - sign * slack(point.value)
            before = node
            if sign * (just_before - node.value) > 0.0:
                there = self.line.step(node, earlier, just_before)
                if there.refusal is not None or there.node is None:
                    continue
                before = there.node
            return Passage(point, before, self.beyond(point, sign))
        return None

    def joined(self, point: SolvedPoint, node: Node, sign: float) -> Node | None:
        """The stable orbit of half the period, beyond the doubling from which an orbit was born."""
        if point.period == node.orbit.period:
            return None
        beyond = (
            self.taken_up(value, point.state, point.period)
            for value in self.values_beyond(point, sign, DOUBLED)
        )
        return next((after for after in beyond if after is not None), None)

    def beyond(self, point: SolvedPoint, sign: float) -> Node | None:
        """The stable orbit beyond a touch or a doubling."""
        if isinstance(point, GrazingPoint):
            label = point.label_above if sign > 0.0 else point.label_below
            for value in self.values_beyond(point, sign, AFTER):
                node = self.taken_up(value, point.state_zero, point.period)
                if node is not None and node.label == label:
                    return node
            return None
        for value in self.values_beyond(point, sign, DOUBLED):
            node = self.doubled(point, value)
            if node is not None:
                return node
        return None

    def values_beyond(self, point: SolvedPoint, sign: float, relatives: tuple[float, ...]) -> Iterator[float]:
        """Values just beyond a point, but not beyond the value to which it is followed."""
        for relative in relatives:
            value = point.value + sign * relative * max(abs(point.value), 1e-3)
            if sign * (self.to - value) >= 0.0:
                yield value
        if abs(self.to - point.value) <= max(relatives) * max(abs(point.value), 1e-3):
            yield self.to

    def taken_up(self, value: float, state: Array, period: int) -> Node | None:
        """The stable orbit of a period (mesh cycles) at a value, near a state."""
        try:
            props = self.line.family.system(self.line.at(value))
            orbit = self.line.orbit(value, state, period // props.cycles)
        except UNBUILT:
            return None
        if orbit is None or orbit.period != period or not orbit.stable:
            return None
        node = Node(value, orbit)
        return node if node.apart(state) <= DOUBLED_NEAR else None

    def doubled(self, point: BifurcationPoint, value: float) -> Node | None:
        """The stable orbit of twice the period beside a doubling, with twice its contacts."""
        try:
            cycles = self.line.family.system(self.line.at(value)).cycles
            single = self.line.orbit(value, point.state, point.period // cycles)
        except UNBUILT:
            return None
        if single is None or 2 * single.shot.period > self.longest:
            return None
        values, vectors = np.linalg.eig(single.shot.monodromy)
        direction = np.real(vectors[:, np.argmin(np.abs(values + 1.0))])
        ranges = Node(value, single).ranges
        direction = direction / (np.abs(direction) / ranges).max()
        for size in DIRECTIONS:
            node = self.taken_up(value, single.state + size * direction, 2 * point.period)
            if node is not None and node.label == single.signature.twice:
                return node
        return None
