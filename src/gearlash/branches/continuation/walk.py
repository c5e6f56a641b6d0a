"""A stable motion followed one way in a parameter, only as far as is asked for.

It goes along a branch (`follow`), and at a doubling, or where it joins the orbit of half its period, over to
the branch that is stable beyond. It ends where no stable orbit goes on."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from gearlash.orbits import Orbit, Signature, orbit_at
from gearlash.system import Family, GearlashError

from .beside import Passed, Unexplained
from .corner import HALVES
from .equations import UNBUILT, Array, Line
from .follow import Follower
from .node import Node
from .points import EndKind, EndOfBranch, SpecialKind, SpecialPoint
from .settings import ContinuationSettings
from .switching import doubled_beside
from .whole import LONGEST_PERIOD, first_node, point_of, special_of

Item = Node | SpecialPoint | EndOfBranch
LEAST_WAY = 0.05  # of the value: the unit of the parameter on a way that is shorter
SMALL = 1e-3  # what counts as the size of a small value
BEYOND = (1e-9, 1e-8, 1e-7, 1e-6)  # relative distances beyond a point at which a motion is taken up again
SIZES = (
    1e-4,
    1e-5,
    1e-6,
    1e-3,
    1e-2,
)  # of the scale: how far beside the single orbit the doubled one is solved for
NEAR = 0.2  # of the scale: as far as an orbit lies from where it is taken up, at the most
AT_TOUCH = 1e-6  # of the unit: stability that is lost so near behind a touch is lost in it
PASSED = SpecialKind.GRAZING, SpecialKind.BRANCH_POINT, SpecialKind.EXISTENCE
"""Points that the branch itself goes through, or towards."""
STABLE = ContinuationSettings(certify=False, most_points=20_000)
"""How a stable motion is followed unless it is said."""


def walk(
    family: Family,
    values: Mapping[str, float],
    name: str,
    orbit: Orbit,
    to: float,
    *,
    longest: int = LONGEST_PERIOD,
    settings: ContinuationSettings = STABLE,
) -> Iterator[Item]:
    """The stable motion that ``orbit``, found at ``values``, is followed to where ``name`` has the value
    ``to``: every orbit that is stepped to, every special point, in order, and then its end. The orbit before
    a special point is the last that came, the one beyond the next. Where it joins the orbit of half its
    period, that is told as the doubling of this one. An orbit that is born at a doubling is
    followed up to a period of ``longest`` base periods. Nothing is computed before it is asked for. Raises
    `GearlashError` where the orbit is none of this family, or is not isolated."""
    values = family.complete(values)
    start = float(values[name])
    lower, upper = sorted((start, to))
    unit = LEAST_WAY * max(abs(start), SMALL)
    line = Line(family, values, name, lower, upper if upper > lower else lower + unit, unit)
    walker = _Walker(line, to, 1.0 if to > start else -1.0, longest, settings)
    node = first_node(line, orbit, start)
    if not node.orbit.stable:
        raise GearlashError(f"the orbit at {name} = {start:.10g} is not stable: expected one that is")
    return walker.run(node)


@dataclass(frozen=True, eq=False)
class _Walker:
    line: Line
    to: float
    sign: float
    longest: int
    settings: ContinuationSettings

    def run(self, node: Node) -> Iterator[Item]:
        yield node
        while node.value != self.to:
            next_ = yield from self.along(node)
            if isinstance(next_, EndOfBranch):
                yield next_
                return
            node = next_
            yield node
        yield EndOfBranch(EndKind.ARRIVED, node.value)

    def along(self, node: Node) -> Generator[Item, None, Node | EndOfBranch]:
        """One branch; returns the orbit of another one that is stable beyond, or the end."""
        way = _Way(node, node.label)
        for item in Follower(_ahead(node, self.sign), self.settings).run():
            if isinstance(item, Passed):
                special = way.special(item, self.settings)
                if special is None:
                    continue
                if special.kind in PASSED:
                    yield special
                    continue
                after = self.beyond(special, way)
                yield self.of_single(special, after) if special.kind is SpecialKind.JOINS else special
                return after
            elif isinstance(item, EndOfBranch):
                return self.ended(item, way)
            elif isinstance(item, Unexplained):
                if item.right.orbit.stable and item.right.label != way.label:
                    return EndOfBranch(EndKind.SHORT, way.last.value, item.note)
            elif not item.orbit.stable or self.sign * item.direction[-1] < 0.0:
                return self.lost(item, way)
            else:
                way.moved(item)
                yield item
        raise AssertionError("what is followed has an end")

    def lost(self, node: Node, way: _Way) -> EndOfBranch:
        """Where stability is lost with no point solved for, or the branch has turned in a corner."""
        touch = way.touch
        if touch is None:
            return EndOfBranch(EndKind.UNSTABLE, node.value)
        if self.sign * node.direction[-1] < 0.0:
            return EndOfBranch(EndKind.CORNER, touch.value, touch.note)
        near = abs(node.value - touch.value) <= AT_TOUCH * self.line.unit
        return EndOfBranch(EndKind.TOUCH if near else EndKind.UNSTABLE, node.value)

    def ended(self, end: EndOfBranch, way: _Way) -> Node | EndOfBranch:
        if end.kind in (EndKind.LOWER, EndKind.UPPER):
            return EndOfBranch(EndKind.ARRIVED, end.value)
        even = way.last.equations.period % 2 == 0
        halves = even and (end.kind is EndKind.LINEAR or HALVES in end.note)
        return (self.single(end.value, way.last) if halves else None) or end

    def beyond(self, special: SpecialPoint, way: _Way) -> Node | EndOfBranch:
        """The stable orbit that goes on where the branch does not, or why there is none."""
        value, period = special.value, special.point.period // way.last.here.props.system.cycles
        if special.kind is SpecialKind.DOUBLING:
            if 2 * period > self.longest:
                return EndOfBranch(EndKind.PERIOD, value)
            return self.doubled(special, way.label) or EndOfBranch(EndKind.DOUBLING, value)
        if special.kind is SpecialKind.JOINS:
            found = self.taken_up(value, special.point.state, period // 2)
            return found or EndOfBranch(EndKind.DOUBLING, value)
        if special.kind is SpecialKind.SYMMETRIC:
            found = self.taken_up(value, special.point.state, period)
            return found or EndOfBranch(EndKind.FOLD, value)
        if special.kind is SpecialKind.EXISTENCE:
            return EndOfBranch(EndKind.FAR, value, special.note)
        return EndOfBranch(EndKind.FOLD if special.kind is SpecialKind.FOLD else EndKind.UNSTABLE, value)

    def of_single(self, special: SpecialPoint, after: Node | EndOfBranch) -> SpecialPoint:
        """Where an orbit joins that of half its period: the doubling of this one, as it is met from there."""
        period = special.point.period // self.line.system_at(special.point.value).system.cycles
        single = self.solved(special.point.value, special.point.state, period // 2)
        if single is None:
            return special
        return replace(
            special,
            kind=SpecialKind.DOUBLING,
            point=point_of(single, special.arclength, self.settings),
            label_after=after.label if isinstance(after, Node) else single.label,
            unstable_after=single.spectrum.unstable.total,
            note=str(SpecialKind.DOUBLING),
        )

    def doubled(self, special: SpecialPoint, label: Signature) -> Node | None:
        """The stable orbit of twice the period beyond a doubling."""
        for size in SIZES:
            try:
                node = doubled_beside(self.line, special, size)
            except UNBUILT:
                continue
            if node is None or self.sign * (node.value - special.value) <= 0.0:
                continue
            if not special.linear and node.label != label.twice:
                continue
            if self.sign * (node.value - self.to) > 0.0:
                node = self.solved(self.to, node.orbit.state, node.equations.period)
            if node is not None and node.orbit.stable:
                return node
        return None

    def single(self, value: float, doubled: Node) -> Node | None:
        """The stable orbit of half the period beyond a value."""
        strobes, half = doubled.orbit.strobes, doubled.equations.period // 2
        return self.taken_up(value, 0.5 * (strobes[0] + strobes[half]), half)

    def taken_up(self, value: float, state: Array, period: int) -> Node | None:
        """The stable orbit of so many base periods just beyond a value, near a state."""
        for relative in BEYOND:
            there = value + self.sign * relative * max(abs(value), SMALL)
            if self.sign * (there - self.to) > 0.0:
                there = self.to
            node = self.solved(there, state, period)
            if node is not None and node.orbit.stable:
                return node
        return None

    def solved(self, value: float, state: Array, period: int) -> Node | None:
        """The orbit of so many base periods at a value, near a state."""
        try:
            orbit = orbit_at(self.line.system_at(value), state, period, least=True)
            if orbit is None or orbit.shot.period != period:
                return None
            node = first_node(self.line, orbit, value)
        except UNBUILT:
            return None
        apart = np.abs(node.orbit.state - state) / node.equations.size
        return node if float(apart.max()) <= NEAR else None


@dataclass
class _Way:
    """The last orbit of a branch, the label there, its arclength, and the last touch."""

    last: Node
    label: Signature
    arclength: float = 0.0
    touch: SpecialPoint | None = None

    def moved(self, node: Node) -> None:
        self.arclength += node.apart(self.last)
        self.last, self.label = node, node.orbit.signature

    def special(self, passed: Passed, settings: ContinuationSettings) -> SpecialPoint | None:
        """With the labels that the way has: those of an orbit that touches say nothing. Of extrema that touch
        at one place, as in a motion of half the period, the first tells for all; None for the others."""
        found = special_of(passed, self.last, self.arclength, settings)
        if found.kind is SpecialKind.GRAZING:
            if self.touch is not None and self.touch.interval == found.interval:
                return None
            self.touch = replace(found, label_before=self.label)
            self.label = found.label_after
            return self.touch
        return replace(found, label_before=self.label, label_after=self.label)


def _ahead(node: Node, sign: float) -> Node:
    """The node with its direction towards ``to``."""
    return node if sign * node.direction[-1] >= 0.0 else node.turned
