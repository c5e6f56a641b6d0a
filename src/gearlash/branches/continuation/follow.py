"""A branch of periodic orbits followed one way, by pseudo-arclength continuation.

Source: H. B. Keller (1977); step control by angle and contraction as in E. Allgower and K. Georg,
Introduction to Numerical Continuation Methods (2003), ch. 6, doi:10.1137/1.9780898719154."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import acos

import numpy as np

from .beside import Item, Passed
from .between import WELL
from .changes import parts, primes
from .corner import HALVES, Corner, corner, still_beside
from .equations import Array
from .infinity import GROWN, runs_away
from .loop import closing
from .node import Found, Node, node_near
from .points import EndKind, EndOfBranch, SpecialKind
from .resolve import Resolver
from .section import begun_elsewhere
from .settings import ContinuationSettings

KINK = 1.2  # rad: where a contact comes or goes just where periods are begun, states turn, the orbit does not
GROW, SHRINK = 2.0, 0.5
GOOD_CONTRACTION, MOST_CONTRACTION = 0.05, 0.4
OUTGROWN = 2.0  # times the longest step, for each scale that the states are away from the first orbit
OFF = 0.5  # of a step: how far beside its end the next orbit may lie
FAR = 1e6  # times the size of the first orbit: it runs away
SINGLE = 1e-4  # of a step: parts of an orbit so near to each other are the same
FLAT = 1e-6  # what is no change of the parameter along a branch, and no distance of a multiplier from 1
STEADY = 0.02  # change of the parameter along a branch that is far from a fold
LONGER = 2.5  # times the last step: how far ahead that is looked at


@dataclass(frozen=True, eq=False)
class Follower:
    """From one orbit; ``start`` has the direction in which it goes."""

    start: Node
    settings: ContinuationSettings

    def run(self) -> Iterator[Item | EndOfBranch]:
        """Orbits and special points in order, and why it ends."""
        before, node, length = None, self.start, self.settings.first
        passed: int | None = None  # number of the extremum that has just touched
        large = GROWN * (1.0 + float(np.linalg.norm(node.u[:-1])))
        for count in range(self.settings.most_points):
            step = self.step(before, node, length)
            if isinstance(step, EndOfBranch):
                beyond = corner(before, node, passed) if step.kind is EndKind.SHORT else None
                passed = None
                if beyond is None or beyond.after is None:
                    yield from self.stopped(node, step, beyond)
                    return
                if beyond.located is not None:
                    yield Passed(node, beyond.after, beyond.located)
                yield beyond.after
                before, node, length = None, beyond.after, self.settings.first
                continue
            if passed is not None and not still_beside(node, passed):
                passed = None
            after, length, ending = step
            first = closing(self.start, node, after) if count > 2 else None
            if first is not None:
                after, ending = first, EndOfBranch(EndKind.CLOSED, self.start.value)
            degenerate = of_linear_doubling(after)
            if degenerate:
                ending = EndOfBranch(EndKind.LINEAR, after.value)
            for item in Resolver(touches=degenerate).resolve(before, node, after):
                yield item
                if isinstance(item, Node):
                    before, node = node, item
                elif isinstance(item, Passed) and item.located.kind is SpecialKind.JOINS:
                    ending = EndOfBranch(EndKind.JOINED, item.located.node.value)
                    break
                elif isinstance(item, Passed) and item.located.kind is SpecialKind.GRAZING:
                    passed = item.located.change.number
                    if item.located.note == HALVES:
                        ending = EndOfBranch(EndKind.CORNER, item.located.node.value, HALVES)
                        break
                    if degenerate:  # beyond it lie motions of every size at the one value
                        break
            if ending is not None:
                yield ending
                return
            if before is not None and self.away(node) > large:
                large, end = 2.0 * large, runs_away(before, node)
                if end is not None:
                    yield Passed(before, node, end)
                    yield EndOfBranch(EndKind.FAR, node.value, end.note)
                    return
            moved = begun_elsewhere(node)
            if moved is not None:
                before, node = None, moved
        yield EndOfBranch(EndKind.POINTS, node.value, f"{self.settings.most_points} points")

    def stopped(self, node: Node, end: EndOfBranch, beyond: Corner | None) -> Iterator[Item | EndOfBranch]:
        """A branch that ends, in a touch with a corner or because no step is short enough."""
        if beyond is None or beyond.located is None:
            yield end
            return
        yield Passed(node, node, beyond.located)
        yield EndOfBranch(EndKind.CORNER, beyond.located.node.value, beyond.located.note)

    def step(
        self, before: Node | None, node: Node, length: float
    ) -> tuple[Node, float, EndOfBranch | None] | EndOfBranch:
        """The next orbit, the length of the step after it, and whether it is the last."""
        refused = ""
        while length >= self.settings.shortest:
            guess = predicted(before, node, length)
            limit = self.limit(node, guess)
            if limit is None:
                slope = slope_ahead(before, node, length)
                row, target = place_by(before, node, guess)
                near = far_from_folds(before, node)
                found = node_near(node.equations, guess, row, target, node, slope, near=near)
            else:
                found = self.at_limit(node, guess, limit)
            refused = self.refused(node, found, guess, length)
            if not refused and found.node is not None:
                end = None if limit is None else EndOfBranch(self.side(limit), limit)
                return found.node, self.next_length(node, found, length), end
            length *= SHRINK
        return self.ended(node, refused)

    def limit(self, node: Node, guess: Array) -> float | None:
        """The limit of the parameter that a step leads to or beyond."""
        line, value = node.equations.line, node.equations.value(guess)
        return line.lower if value <= line.lower else line.upper if value >= line.upper else None

    def side(self, limit: float) -> EndKind:
        return EndKind.LOWER if limit == self.start.equations.line.lower else EndKind.UPPER

    def at_limit(self, node: Node, guess: Array, limit: float) -> Found:
        row = np.zeros(len(guess))
        row[-1] = 1.0
        end = limit / node.equations.line.unit
        part = (end - node.u[-1]) / (guess[-1] - node.u[-1])
        there = node.u + part * (guess - node.u)
        there[-1] = end
        return node_near(node.equations, there, row, end, node, node.slope)

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
        if any(float(np.linalg.norm(parts(after, p))) < SINGLE * length for p in primes(node)):
            return "the orbit closes after a part of its period"
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
        return min(length, self.settings.longest * max(1.0, OUTGROWN * self.away(found.node)))

    def away(self, node: Node) -> float:
        """How far the states are from those of the first orbit."""
        return float(np.linalg.norm(node.way_from(self.start)[:-1]))

    def ended(self, node: Node, refused: str) -> EndOfBranch:
        note = f"steps down to {self.settings.shortest:.0e} are refused: {refused}"
        if "no system" in refused:
            return EndOfBranch(EndKind.UNBUILT, node.value, refused)
        return EndOfBranch(EndKind.FAR if "without bound" in refused else EndKind.SHORT, node.value, note)


def of_linear_doubling(node: Node) -> bool:
    """Whether an orbit is one of those of every amplitude that a linear motion has where it doubles."""
    if any(map(any, node.orbit.signature.counts)) or abs(float(node.direction[-1])) > FLAT:
        return False
    return float(np.abs(node.spectrum.multipliers - 1.0).min()) <= FLAT


def place_by(before: Node | None, node: Node, guess: Array) -> tuple[Array, float]:
    """The row that says where on the branch the next orbit lies, and its value. Far from a fold the parameter
    does: a system is then built once for each orbit. Else the direction of the branch does."""
    turns = [node.direction[-1]] if before is None else [node.direction[-1], before.direction[-1]]
    row = node.direction
    if min(map(abs, turns)) > WELL and min(turns) * max(turns) > 0.0:
        row = np.zeros_like(guess)
        row[-1] = 1.0
    return row, float(row @ guess)


def far_from_folds(before: Node | None, node: Node) -> bool:
    """Whether the parameter goes on the same way for longer than the last step."""
    if before is None:
        return False
    turns = before.direction[-1], node.direction[-1]
    ahead = turns[1] + LONGER * (turns[1] - turns[0])
    return bool(min(*turns, ahead) * max(*turns, ahead) > 0.0 and abs(ahead) > STEADY)


def slope_ahead(before: Node | None, node: Node, length: float) -> Array:
    """The derivative along the parameter, as the last two orbits tell it."""
    if before is None:
        return node.slope
    last = float(np.linalg.norm(node.u - before.u))
    return node.slope + min(1.0, length / max(last, 1e-300)) * (node.slope - before.slope)


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
