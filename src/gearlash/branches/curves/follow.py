"""A curve followed one way, by pseudo-arclength continuation.

Source: H. B. Keller (1977); step control by angle and contraction as in E. Allgower and K. Georg,
Introduction to Numerical Continuation Methods (2003), ch. 6, doi:10.1137/1.9780898719154."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import acos

import numpy as np

from gearlash.branches.continuation.extrema import Extremum
from gearlash.branches.continuation.settings import ContinuationSettings

from .conditions import At
from .halves import change_places, joins_half, nearly_one
from .locate import Met, touch_along, touch_on
from .loops import SAME, not_again, passes
from .met import Happened, between
from .motion import is_clear
from .newton import Corrected
from .node import Node, solved, touch_of, well_begun
from .plane import UNBUILT, Array
from .points import CurveEndKind, EndOfCurve
from .restart import beyond, clear_side
from .secondary import TURNS

GROW, SHRINK = 2.0, 0.5
GOOD_CONTRACTION, MOST_CONTRACTION = 0.15, 0.4
GOOD_TURN = 0.6  # of the largest angle
OFF = 0.5  # of a step: how far beside its end the next orbit may lie
SOON = 3.0  # steps: an extremum that would touch within so many is kept from crossing
AHEAD = 2.0  # steps: a depth that would vanish within so many is looked for
TINY, FAR = 1e-5, 0.3  # scaled: a depth so small makes steps short, and is looked for so far ahead
SHORT = 0.01  # the longest step that is called short
GROWN, LARGEST = 10.0, 1e4  # times the states of the first orbit: steps grow with them, and the curve ends
NEAR = 4.0  # times as far as foretold may a touch lie
PAST = 60  # orbits by which an end may be told
Item = Node | Met | EndOfCurve


@dataclass(frozen=True, eq=False)
class Follower:
    """From one orbit; ``start`` has the direction in which it goes; ``known``: the next ones, if they are
    known already; ``goal``: an orbit at which a loop is closed, too, with the direction in which it is
    passed."""

    start: Node
    settings: ContinuationSettings
    first: float
    known: tuple[Node, ...] = ()
    goal: Node | None = None

    def run(self) -> Iterator[Item]:
        """Orbits and what is met in order, and why it ends."""
        before: Node | None = None
        node, length, past = self.start, self.first, deque[Node](maxlen=PAST)
        if self.known:
            yield from self.known
            node, length = self.known[-1], _between(*(self.start, *self.known)[-2:])
        for count in range(self.settings.most_points):
            touch = self.vanishing(before, node, length)
            if touch is not None and node.problem.plane.inside(touch.place):
                ended = self.at_touch(node, touch)
                if ended is not None:
                    yield ended
                    return
                after = clear_side(touch)
                yield from self.over(touch, after)
                if after is None:
                    return
                before, node, length = None, after, self.settings.first
                past.clear()
                continue
            begun = self.prepared(before, node, length)
            before, node = (before if begun.problem.origin == node.problem.origin else None), begun
            step = self.step(before, node, length)
            if isinstance(step, EndOfCurve):
                yield step
                return
            after, happened, length, end = step
            closing = (
                None if count < 3 or happened.touch else self.closes(node.place, after.place, node, after)
            )
            yield from not_again(happened.met, node, after, closing) if closing else happened.met
            if happened.touch is not None:
                known = beyond(happened.touch)
                yield from self.over(happened.touch, known[-1] if known else None)
                if not known:
                    return
                ended = self.over_touch(node, happened.touch, known)
                if ended is not None:
                    yield ended
                    return
                yield from known
                before, node, length = None, known[-1], 0.5 * _apart(known[-1], happened.touch)
                past.clear()
                continue
            resonance = self.resonance(node, happened.met)
            if resonance is not None:
                yield resonance
                return
            yield after
            past.append(node)
            ended = self.last(past, after, closing) or end
            if ended is not None:
                yield ended
                return
            before, node = node, after
        yield EndOfCurve(CurveEndKind.POINTS, _values(node.place), f"{self.settings.most_points} points")

    def at_touch(self, node: Node, touch: Met) -> EndOfCurve | None:
        """Why the curve ends at or before a touch ahead, if it does."""
        if nearly_one(touch.here, touch.motion):
            return EndOfCurve(CurveEndKind.HALF_PERIOD, _values(touch.place))
        return _closed(self.closes(node.place, touch.place, node))

    def over_touch(self, node: Node, touch: Met, known: tuple[Node, ...]) -> EndOfCurve | None:
        """Why the curve ends at a touch or on its first orbits beyond it, if it does."""
        if nearly_one(touch.here, touch.motion) and not nearly_one(node.here, node.motion):
            return EndOfCurve(CurveEndKind.HALF_PERIOD, _values(touch.place))
        places = [touch.place, *(each.place for each in known)]
        pairs = zip(pairwise(places), pairwise([known[0], *known]), strict=True)
        return _closed(next(filter(None, (self.closes(*pair, *near) for pair, near in pairs)), None))

    def resonance(self, node: Node, met: tuple[Met, ...]) -> EndOfCurve | None:
        """Whether a pair on the circle has become real; where the curve was begun it may be."""
        if not node.problem.conditions or node.problem.conditions[0].at is not At.CIRCLE:
            return None
        unit, begun = node.problem.plane.unit, self.start.place
        real = [each for each in met if each.kind in TURNS and abs(TURNS[each.kind]) == 1.0]
        real = [each for each in real if np.linalg.norm((each.place - begun) / unit) > SAME]
        return EndOfCurve(CurveEndKind.RESONANCE, _values(real[-1].place)) if real else None

    def last(self, past: Sequence[Node], after: Node, closing: Node | None) -> EndOfCurve | None:
        """Why the curve ends with an orbit, if it does."""
        joined = joins_half(past, after)
        if joined is not None:
            return joined
        if self.grown(after) > LARGEST:
            note = f"its states are {self.grown(after):.0e} times those of the first orbit"
            return EndOfCurve(CurveEndKind.FAR, _values(after.place), note)
        return _closed(closing)

    def over(self, touch: Met, after: Node | None) -> Iterator[Item]:
        yield touch
        if after is None:
            yield EndOfCurve(CurveEndKind.TOUCH, _values(touch.place))

    def vanishing(self, before: Node | None, node: Node, length: float) -> Met | None:
        """On a curve of a condition: the touch at which a contact ends that becomes ever less deep. Its depth
        is the square of the way that is left."""
        if before is None or not node.problem.conditions:
            return None
        done = float(np.linalg.norm(node.u - before.u))
        best: tuple[float, Extremum] | None = None
        unit = [np.linalg.norm(c.h * node.problem.size) for c in node.here.props.system.clearances]
        for extremum in node.extrema.all:
            last = before.extrema.by_number.get(extremum.number)
            if last is None or is_clear(extremum) or is_clear(last) or extremum.number in node.touching:
                continue
            one, two = abs(last.distance) ** 0.5, abs(extremum.distance) ** 0.5
            left = two * done / (one - two) if two < one else np.inf
            tiny = length <= SHORT and abs(extremum.distance) <= TINY * unit[extremum.clearance]
            if left < (max(FAR, AHEAD * length) if tiny else AHEAD * length) and (
                best is None or left < best[0]
            ):
                best = left, extremum
        if best is None:
            return None
        left, extremum = best
        guess = node.u + left * node.direction
        for found in (touch_on(node, extremum, guess), touch_along(node, extremum)):
            if found is not None and _distance(found, node) <= NEAR * left and _ahead(found, node):
                return found if comes_from(found, node) else None
        return None

    def prepared(self, before: Node | None, node: Node, length: float) -> Node:
        """Begun far from what touches; on a curve of a condition with the extremum that touches next kept
        from crossing its boundary."""
        try:
            if node.problem.touches:
                return well_begun(node, node.problem.phases(node.u).tolist())
            extremum = self.next_touch(before, node, length)
            if extremum is None:
                node = well_begun(node, [])
                return node.along(replace(node.problem, kept=()))
            node = well_begun(node, [extremum.phase])
            touch, phase = touch_of(node, node.extrema.by_number[extremum.number])
            return node.along(replace(node.problem, kept=((phase, touch.window),)))
        except (KeyError, *UNBUILT):
            return node

    def next_touch(self, before: Node | None, node: Node, length: float) -> Extremum | None:
        """The clear extremum that would touch first, and soon."""
        touching = [e for e in node.extrema.all if e.number in node.touching]
        if touching:
            return touching[0]
        clear = [e for e in node.extrema.all if is_clear(e)]
        if before is None:
            return min(clear, key=lambda e: abs(e.distance), default=None)
        done, soonest = float(np.linalg.norm(node.u - before.u)), None
        least = SOON * length
        for extremum in clear:
            last = before.extrema.by_number.get(extremum.number)
            if last is None or abs(extremum.distance) >= abs(last.distance):
                continue
            left = abs(extremum.distance) * done / (abs(last.distance) - abs(extremum.distance))
            if left < least:
                soonest, least = extremum, left
        return soonest

    def step(
        self, before: Node | None, node: Node, length: float
    ) -> tuple[Node, Happened, float, EndOfCurve | None] | EndOfCurve:
        """The next orbit, what is met before it, the length of the step after it, and whether it is the
        last."""
        refused = ""
        while length >= self.settings.shortest:
            after, corrected, end = self.tried(before, node, length)
            refused = self.refused(node, after, corrected, length)
            if not refused and after is not None:
                happened = between(node, after, length)
                if not happened.doubt or length < 2.0 * self.settings.shortest:
                    return after, happened, self.next_length(node, after, corrected, length), end
                refused = happened.doubt
            length *= SHRINK
        kind = CurveEndKind.UNBUILT if "system" in refused else CurveEndKind.SHORT
        return EndOfCurve(kind, _values(node.place), f"steps down to {self.settings.shortest:.0e}: {refused}")

    def tried(
        self, before: Node | None, node: Node, length: float
    ) -> tuple[Node | None, Corrected, EndOfCurve | None]:
        guess = predicted(before, node, length)
        problem, plane = node.problem, node.problem.plane
        if plane.inside(problem.place(guess)):
            row = node.direction
            jacobian = jacobian_ahead(before, node, length)
            found, corrected = solved(problem, guess, row, float(row @ guess), node, jacobian)
            return found, corrected, None
        axis, part = self.first_limit(node, guess)
        there = node.u + part * (guess - node.u)
        row = np.zeros(len(guess))
        row[len(guess) - 2 + axis] = 1.0
        found, corrected = solved(problem, there, row, float(row @ there), node)
        if found is None:
            return None, corrected, None
        note = f"{plane.names[axis]} = {found.place[axis]:.10g}"
        return found, corrected, EndOfCurve(CurveEndKind.LIMIT, _values(found.place), note)

    def first_limit(self, node: Node, guess: Array) -> tuple[int, float]:
        """Which limit a step meets first, and after what part of it."""
        plane = node.problem.plane
        here, there = node.place, node.problem.place(guess)
        found: list[tuple[float, int]] = []
        for axis in range(2):
            for limit in (plane.lower[axis], plane.upper[axis]):
                if (there[axis] - limit) * (here[axis] - limit) < 0.0 or here[axis] == limit != there[axis]:
                    outward = (there[axis] - here[axis]) * (
                        limit - 0.5 * (plane.lower[axis] + plane.upper[axis])
                    )
                    if outward > 0.0:
                        found.append(((limit - here[axis]) / (there[axis] - here[axis]), axis))
        part, axis = min(found, default=(0.0, 0))
        return axis, part

    def refused(self, node: Node, after: Node | None, corrected: Corrected, length: float) -> str:
        """Why a step is not taken, or nothing."""
        if after is None:
            return corrected.failure
        if corrected.contraction > MOST_CONTRACTION:
            return f"Newton's method contracts by {corrected.contraction:.2f} only"
        if np.linalg.norm(after.u - node.u) > (1.0 + OFF) * length:
            return "Newton's method finds an orbit somewhere else"
        if change_places(node, after) and not nearly_one(after.here, after.motion):
            return "the halves of the orbit change places within a step"
        turn = angle(node, after)
        return f"the curve turns by {turn:.2f} rad within a step" if turn > self.settings.angle else ""

    def next_length(self, node: Node, after: Node, corrected: Corrected, length: float) -> float:
        """As much longer or shorter as contraction and angle are less or more than they should be."""
        turn = GOOD_TURN * self.settings.angle / max(angle(node, after), 1e-9)
        contraction = GOOD_CONTRACTION / max(corrected.contraction, 1e-9)
        length *= min(GROW, max(SHRINK, min(turn, contraction)))
        return min(length, self.settings.longest * max(1.0, self.grown(after) / GROWN))

    def grown(self, node: Node) -> float:
        """How many times as large as on the first orbit the states are, where they are larger."""
        one, two = (float(np.linalg.norm(each.u[: each.problem.states])) for each in (self.start, node))
        return max(1.0, two / max(one, 1e-300))

    def closes(self, left: Array, right: Array, *near: Node) -> Node | None:
        """The first orbit or the goal, begun at any of its base periods, if it lies between two places of
        the curve: whether the curve, begun from the nearest of the nodes ``near`` there, passes it is solved
        for."""
        for target in (self.start, self.goal):
            if target is not None and passes(target, left, right, near):
                return target
        return None


def _closed(target: Node | None) -> EndOfCurve | None:
    return None if target is None else EndOfCurve(CurveEndKind.CLOSED, _values(target.place))


def _values(place: Array) -> tuple[float, float]:
    return float(place[0]), float(place[1])


def _distance(met: Met, node: Node) -> float:
    """Of a point from a node, in the plane and in the states where they are begun at one phase."""
    return float(np.linalg.norm((met.place - node.place) / node.problem.plane.unit))


def comes_from(touch: Met, node: Node) -> bool:
    """Whether the curve leaves a touch, on the side with the contact, towards a node; else there is a cusp
    between them."""
    known = beyond(touch)
    unit = node.problem.plane.unit
    return (
        not known
        or float(((known[0].place - touch.place) / unit) @ ((node.place - touch.place) / unit)) > 0.0
    )


def _ahead(met: Met, node: Node) -> bool:
    """Whether a point lies in the direction of the curve."""
    return float((met.place - node.place) / node.problem.plane.unit @ node.direction[-2:]) >= 0.0


def _apart(node: Node, met: Met) -> float:
    n, k = met.here.problem.states, len(met.here.problem.touches)
    return float(np.linalg.norm(node.u - np.concatenate([met.here.u[:n], met.here.u[n + k :]])))


def _between(left: Node, right: Node) -> float:
    """Half of how far two neighbours are apart."""
    return 0.5 * float(np.linalg.norm(right.u - left.u))


def angle(left: Node, right: Node) -> float:
    return acos(min(1.0, max(-1.0, float(left.direction @ right.direction))))


def predicted(before: Node | None, node: Node, length: float) -> Array:
    """By the tangent, bent as the curve has been bent over the last step."""
    guess = node.u + length * node.direction
    if before is None or len(before.u) != len(node.u) or before.problem.origin != node.problem.origin:
        return guess
    last = float(np.linalg.norm(node.u - before.u))
    bend = (node.direction - before.direction) / max(last, 1e-300)
    return guess + 0.5 * length * length * bend


def jacobian_ahead(before: Node | None, node: Node, length: float) -> Array:
    """The Jacobian as the last two orbits tell it."""
    if before is None or before.jacobian.shape != node.jacobian.shape:
        return node.jacobian
    last = float(np.linalg.norm(node.u - before.u))
    return node.jacobian + min(1.0, length / max(last, 1e-300)) * (node.jacobian - before.jacobian)
