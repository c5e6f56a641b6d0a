"""A branch of periodic orbits followed one way, by pseudo-arclength continuation.

Source: H. B. Keller (1977); step control by angle and contraction as in E. Allgower and K. Georg,
Introduction to Numerical Continuation Methods (2003), ch. 6, doi:10.1137/1.9780898719154."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import acos

import numpy as np

from .changes import halves
from .equations import Array
from .node import Found, Node, node_near
from .points import BranchEnd, Ending, Kind
from .resolve import Item, Passed, Resolver
from .settings import ContinuationSettings

KINK = 1.2  # rad: where a contact comes or goes at phase zero, the states there turn, the orbit does not
GROW, SHRINK = 2.0, 0.5
GOOD_CONTRACTION, MOST_CONTRACTION = 0.05, 0.4
OFF = 0.5  # of a step: how far beside its end the next orbit may lie
FAR = 1e6  # times the size of the first orbit: it runs away
SINGLE = 1e-4  # of a step: halves of an orbit so near to each other are the same
BACK = 0.02  # of a step: how near the first orbit is passed where a loop closes


@dataclass(frozen=True, eq=False)
class Follower:
    """From one orbit; ``start`` has the direction in which it goes."""

    start: Node
    settings: ContinuationSettings

    def run(self) -> Iterator[Item | BranchEnd]:
        """Orbits and special points in order, and why it ends."""
        before, node, length = None, self.start, self.settings.first
        for count in range(self.settings.most_points):
            step = self.step(before, node, length)
            if isinstance(step, BranchEnd):
                yield step
                return
            after, length, ending = step
            closed = count > 2 and self.closes(node, after)
            if closed:
                ending = BranchEnd(Ending.CLOSED, self.start.value)
            previous = node
            for item in Resolver().resolve(before, node, after):
                yield item
                if isinstance(item, Passed) and item.located.kind is Kind.JOINS:
                    yield BranchEnd(Ending.JOINED, item.located.node.value)
                    return
                if isinstance(item, Node):
                    before, previous = previous, item
            node = previous
            if ending is not None:
                yield ending
                return
        yield BranchEnd(Ending.POINTS, node.value, f"{self.settings.most_points} points")

    def step(
        self, before: Node | None, node: Node, length: float
    ) -> tuple[Node, float, BranchEnd | None] | BranchEnd:
        """The next orbit, the length of the step after it, and whether it is the last."""
        refused = ""
        while length >= self.settings.shortest:
            guess = predicted(before, node, length)
            limit = self.limit(node, guess)
            if limit is None:
                target = float(node.direction @ node.u) + length
                found = node_near(node.equations, guess, node.direction, target, node)
            else:
                found = self.at_limit(node, guess, limit)
            refused = self.refused(node, found, guess, length)
            if not refused and found.node is not None:
                end = None if limit is None else BranchEnd(self.side(limit), limit)
                return found.node, self.next_length(node, found, length), end
            length *= SHRINK
        return self.ended(node, refused)

    def limit(self, node: Node, guess: Array) -> float | None:
        """The limit of the parameter that a step leads to or beyond."""
        line, value = node.equations.line, node.equations.value(guess)
        return line.lower if value <= line.lower else line.upper if value >= line.upper else None

    def side(self, limit: float) -> Ending:
        return Ending.LOWER if limit == self.start.equations.line.lower else Ending.UPPER

    def at_limit(self, node: Node, guess: Array, limit: float) -> Found:
        row = np.zeros(len(guess))
        row[-1] = 1.0
        end = limit / node.equations.line.unit
        part = (end - node.u[-1]) / (guess[-1] - node.u[-1])
        there = node.u + part * (guess - node.u)
        there[-1] = end
        return node_near(node.equations, there, row, end, node)

    def refused(self, node: Node, found: Found, guess: Array, length: float) -> str:
        """Why a step is not taken, or nothing."""
        after = found.node
        if after is None:
            return found.failure
        assert found.corrected is not None
        if found.corrected.contraction > MOST_CONTRACTION:
            return f"Newton's method contracts by {found.corrected.contraction:.2f} only"
        if np.linalg.norm(after.u - node.u) > (1.0 + OFF) * length:
            return "Newton's method finds an orbit somewhere else"
        if node.equations.period % 2 == 0 and float(np.linalg.norm(halves(after))) < SINGLE * length:
            return "the orbit closes after half of its period"
        allowed = self.settings.angle if np.array_equal(node.modes, after.modes) else KINK
        if angle(node, after) > allowed:
            return f"the branch turns by {angle(node, after):.2f} rad within a step"
        if float(np.abs(after.u[:-1]).max()) > FAR * float(np.abs(self.start.u[:-1]).max() + 1.0):
            return "the motion grows without bound"
        return ""

    def next_length(self, node: Node, found: Found, length: float) -> float:
        assert found.corrected is not None
        assert found.node is not None
        turned, contraction = angle(node, found.node), found.corrected.contraction
        if turned < 0.3 * self.settings.angle and contraction < GOOD_CONTRACTION:
            length *= GROW
        elif turned > 0.7 * self.settings.angle:
            length *= SHRINK
        return min(length, self.settings.longest)

    def ended(self, node: Node, refused: str) -> BranchEnd:
        told = f"steps down to {self.settings.shortest:.0e} are refused: {refused}"
        if "no system" in refused:
            return BranchEnd(Ending.UNBUILT, node.value, refused)
        return BranchEnd(Ending.FAR if "without bound" in refused else Ending.SHORT, node.value, told)

    def closes(self, left: Node, right: Node) -> bool:
        """Whether the first orbit, begun at any of its base periods, lies between two neighbours."""
        chord = right.u - left.u
        length = float(np.linalg.norm(chord))
        if right.direction @ self.start.direction < 0.0 and self.start.equations.segments == 1:
            return False
        for u in self.shifted:
            along = float(chord @ (u - left.u)) / length
            beside = np.linalg.norm(u - left.u - along * chord / length)
            if 0.0 < along <= length and beside <= BACK * length:
                return True
        return False

    @property
    def shifted(self) -> list[Array]:
        equations, orbit = self.start.equations, self.start.orbit
        states = orbit.strobes
        return [equations.unknowns(np.roll(states, -k, axis=0), self.start.value) for k in range(len(states))]


def angle(left: Node, right: Node) -> float:
    return acos(min(1.0, max(-1.0, float(left.direction @ right.direction))))


def predicted(before: Node | None, node: Node, length: float) -> Array:
    """By the tangent, bent as the branch has been bent over the last step."""
    guess = node.u + length * node.direction
    if before is None:
        return guess
    last = float(np.linalg.norm(node.u - before.u))
    bend = (node.direction - before.direction) / max(last, 1e-300)
    return guess + 0.5 * length * length * bend
