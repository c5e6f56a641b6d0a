"""One step of a branch, cut until all that happens on it is told apart and solved for."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from .beside import Item, Passed, Unexplained, told_apart
from .between import Between
from .changes import Change, Test, changes, doubt, explained
from .corner import HALVES, abrupt, at_half
from .locate import Located, locate
from .node import Node

DOUBTFUL_STEP = 1e-7  # length of a step below which it is not cut because of a doubt
TIGHT = 1e-10  # the same where things happen in it that cannot be told apart
AFTER_GRAZE = (0.01, 0.1)  # of what is left of the step: there multipliers move like the root of the depth
BESIDE_CORNER = 1e-5  # of the scale: from a corner, to the orbits that stand for its two sides
SIDES = 1e-8  # least length of a step on either side of a corner, to be looked at apart
ENDWARDS = 0.2  # of the way from an end: where a step is cut that cannot be cut in the middle
CUTS = 80  # of one step, at most


@dataclass
class Resolver:
    """``cuts``: how often a step may still be cut; ``touches``: whether touches alone are asked for."""

    cuts: int = CUTS
    touches: bool = False

    def resolve(self, before: Node | None, left: Node, right: Node) -> Iterator[Item]:
        """All special points between two neighbouring orbits, each with what lies just beside it, and the
        orbits that were needed to tell them apart, in order; ``right``, numbered after them, is the last.
        ``before``: the one before ``left``."""
        yield from told_apart(left, self.cut(before, left, right))

    def cut(self, before: Node | None, left: Node, right: Node) -> Iterator[Item]:
        """The same, without what lies beside."""
        found, piece = changes(left, right), Between(left, right)
        if self.touches:
            found = [change for change in found if change.test is Test.GRAZING]
        clear = self.touches or explained(left, right, found)
        unsure = "" if self.touches or piece.length <= DOUBTFUL_STEP else doubt(before, left, right, found)
        if not unsure and not found and clear:
            yield right
            return
        corner = self.corner_on(piece, found)
        if corner is not None:
            yield from self.over_corner(before, piece, [Passed(left, right, corner)], corner.place)
            return
        tried = [] if unsure else [locate(piece, change) for change in found]
        located = sorted((each for each in tried if each is not None), key=lambda one: one.place)
        whole = bool(located) and len(located) == len(found)
        if whole and located[-1].place - located[0].place > TIGHT:
            middle = self.middle(piece, _widest_gap(located))
        elif whole and (clear or any(one.change.test is Test.GRAZING for one in located)):
            yield from self.passed(before, piece, located)
            return
        else:
            middle = self.middle(piece, 0.5 * piece.length)
        if middle is not None:
            yield from self.both(before, left, middle, right)
            return
        if unsure:
            located = [each for each in (locate(piece, change) for change in found) if each is not None]
        yield from _at_once(piece, located, unsure or f"{len(found) - len(located)} were not solved for")

    def corner_on(self, piece: Between, found: list[Change]) -> Located | None:
        """A touch that makes a corner of the map, of several things that happen on a step: what else does is
        looked for on both sides of it apart, as multipliers and the direction of the branch jump there."""
        known = piece.left.extrema.by_number
        touches = [change for change in found if change.test is Test.GRAZING]
        if len(found) < 2 or len(touches) != 1 or self.cuts <= 0:
            return None
        if not abrupt(piece.left.here.props.system, known[touches[0].number]):
            return None
        self.cuts -= 1
        touch = locate(piece, touches[0])
        if touch is None or not SIDES <= touch.place <= piece.length - SIDES:
            return None
        aside = _aside(piece, touch.place)
        both = piece.node(touch.place - aside), piece.node(touch.place + aside)
        return None if None in both else touch

    def middle(self, piece: Between, place: float) -> Node | None:
        """An orbit between the ends, where the step is cut: near a place, or where Newton fails there
        nearer to either end."""
        if piece.length <= TIGHT or self.cuts <= 0:
            return None
        self.cuts -= 1
        nearer = (place, ENDWARDS * place, piece.length - ENDWARDS * (piece.length - place))
        found = (piece.node(each) for each in nearer)
        return next((node for node in found if node is not None), None)

    def both(self, before: Node | None, left: Node, middle: Node, right: Node) -> Iterator[Item]:
        """The two parts of a step, one after the other; the second is numbered as the first has ended."""
        last, earlier = left, before
        for item in self.cut(before, left, middle):
            if isinstance(item, Node):
                earlier, last = last, item
            yield item
        yield from self.cut(earlier, last, right.linked(last))

    def passed(self, before: Node | None, piece: Between, located: list[Located]) -> Iterator[Item]:
        """A step on which one thing happens, or several at one place. At a graze what comes before and after
        is looked at again: contacts and multipliers change there."""
        touching = frozenset(one.change.number for one in located if one.change.test is Test.GRAZING)
        passed = [Passed(piece.left, piece.right, one) for one in located if one.kind is not None]
        if not touching:
            yield from (*passed, piece.right)
            return
        here = located[0]
        if _has_corner(here.node, touching):
            yield from self.over_corner(before, piece, passed, here.place)
            return
        touch = replace(here.node, touching=touching)
        *inner, _ = self.cut(before, piece.left, touch)
        nodes = [item for item in inner if isinstance(item, Node)]
        later = list(self.behind(touch.linked(nodes[-1]) if nodes else touch, piece, here.place))
        told = {item.located.change.test for item in (*inner, *later) if isinstance(item, Passed)}
        yield from inner
        yield from (one for one in passed if one.located.change.test not in told - {Test.GRAZING})
        yield from later

    def behind(self, touch: Node, piece: Between, place: float) -> Iterator[Item]:
        """What is left of a step behind a touch."""
        last, earlier = touch, None
        for part in (*AFTER_GRAZE, 1.0):
            at = place + part * (piece.length - place)
            node = piece.right if part == 1.0 else piece.node(at)
            if node is None:
                continue
            for item in self.cut(earlier, last, node.linked(last)):
                if isinstance(item, Node):
                    earlier, last = last, item
                yield item

    def over_corner(
        self, before: Node | None, piece: Between, passed: list[Passed], place: float
    ) -> Iterator[Item]:
        """A step over a touch at which the map has a corner. Multipliers jump there, so that both sides are
        looked at apart, each up to an orbit very near the touch."""
        aside = _aside(piece, place)
        short, beyond = piece.node(place - aside), piece.node(place + aside)
        last = piece.left
        for item in () if short is None else self.cut(before, piece.left, short):
            if isinstance(item, Node):
                last = item
            yield item
        first = (piece.right if beyond is None else beyond).linked(last)
        touches = [one.located for one in passed if one.located.change.test is Test.GRAZING]
        if at_half(touches[0].node):  # beyond lies the same orbit, half a period later
            yield Passed(last, last, replace(touches[0], note=HALVES))
            return
        yield from (Passed(last, first, touch) for touch in touches)
        yield first
        if beyond is not None:
            yield from self.cut(None, first, piece.right.linked(first))


def _aside(piece: Between, place: float) -> float:
    """How far from a corner the orbits lie that stand for its two sides."""
    return min(BESIDE_CORNER, 0.5 * place, 0.5 * (piece.length - place))


def _has_corner(node: Node, touching: frozenset[int]) -> bool:
    """Whether the map has a corner where one of these extrema touches."""
    known = node.extrema.by_number
    return any(abrupt(node.here.props.system, known[number]) for number in touching if number in known)


def _widest_gap(located: list[Located]) -> float:
    left, right = max(pairwise(located), key=lambda pair: pair[1].place - pair[0].place)
    return 0.5 * (left.place + right.place)


def _at_once(piece: Between, located: list[Located], why: str) -> Iterator[Item]:
    """A step that cannot be cut farther: all that was found on it, and what was not."""
    yield from (Passed(piece.left, piece.right, one) for one in located if one.kind is not None)
    before, after = piece.left.spectrum.unstable.total, piece.right.spectrum.unstable.total
    yield Unexplained(piece.left, piece.right, f"unstable multipliers {before} before, {after} after; {why}")
    yield piece.right
