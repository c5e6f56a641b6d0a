"""What changes between two neighbouring orbits of a branch, and whether that can be all."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from .equations import Array
from .node import Node

BORN_NEAR = 3.0  # times what the extrema moved: born so near to a boundary, it may have crossed it
CURVED = 1.0  # of what the curvature makes of a step: a function that comes so near zero may have been there
TURN_ROUNDING = 1e-7  # what a derivative along the parameter that is not exact makes of a turn
SLACK = 0.5  # of a step: beyond its ends, for where a function is least (a multiplier may well only touch 1)
SMALL_PAIR = 0.1  # modulus: what lies far within the circle does not leave it and come back within a step
Function = Callable[[Node], float]


class Test(StrEnum):
    """Functions along the branch whose zeros are special points."""

    GRAZING = "distance of an extremum from its boundary"
    TURN = "derivative of the parameter along the branch"
    JOIN = "distance of the two halves of the orbit"
    AT_ONE = "product of (multiplier - 1)"
    DOUBLING = "product of (multiplier + 1)"
    TORUS = "product of (multiplier * multiplier - 1) over pairs"
    KREIN = "discriminant of (multiplier + 1/multiplier)"
    EXISTENCE = "inverse of the size of the motion"


OF_SPECTRUM: dict[Test, Function] = {
    Test.TURN: lambda node: node.spectrum.turn,
    Test.AT_ONE: lambda node: node.spectrum.at_one,
    Test.DOUBLING: lambda node: node.spectrum.doubling,
    Test.TORUS: lambda node: node.spectrum.torus,
    Test.KREIN: lambda node: node.spectrum.krein,
}


@dataclass(frozen=True)
class Change:
    """A test function that has another sign on the other side; of a graze the extremum's number."""

    test: Test
    number: int = -1

    def value(self, node: Node) -> float:
        """Raises `KeyError` where the extremum is not there."""
        if self.test is Test.GRAZING:
            return node.extrema.by_number[self.number].distance
        return OF_SPECTRUM[self.test](node)

    def can_be_had(self, node: Node) -> bool:
        return self.test is not Test.GRAZING or self.number in node.extrema.by_number


def changes(left: Node, right: Node) -> list[Change]:
    """Every change of sign that matters between two orbits."""
    found = list(_grazings(left, right))
    signs = {test: f(left) * f(right) < 0.0 for test, f in OF_SPECTRUM.items()}
    if signs[Test.TURN] and not signs[Test.AT_ONE] and _at_fold(left, right):
        signs[Test.TURN] = False
    if signs[Test.TURN]:
        found.append(Change(Test.JOIN if changes_places(left, right) else Test.TURN))
    elif signs[Test.AT_ONE]:
        found.append(Change(Test.AT_ONE))
    if signs[Test.DOUBLING]:
        found.append(Change(Test.DOUBLING))
    circle = Test.KREIN if undamped(left, right) else Test.TORUS
    if signs[circle] and left.spectrum.unstable.pairs != right.spectrum.unstable.pairs:
        found.append(Change(circle))
    return found


def undamped(left: Node, right: Node) -> bool:
    """Whether multipliers are reciprocal on both sides."""
    return left.spectrum.reciprocal is not None and right.spectrum.reciprocal is not None


def _at_fold(left: Node, right: Node) -> bool:
    """Whether one of two orbits lies in a fold within rounding: then its multipliers tell on which side, as
    they are known better than the direction of the branch."""
    return min(abs(left.spectrum.turn), abs(right.spectrum.turn)) <= TURN_ROUNDING


def parts(node: Node, count: int) -> Array:
    """(P·n,): from every base period to the one so great a part of the orbit later, scaled."""
    strobes = node.orbit.strobes
    apart: Array = (np.roll(strobes, -(len(strobes) // count), axis=0) - strobes) / node.equations.size
    return apart.ravel()


def halves(node: Node) -> Array:
    """The same for two parts."""
    return parts(node, 2)


def primes(node: Node) -> list[int]:
    """Of which the period of an orbit is a multiple."""
    period = node.equations.period
    return [p for p in range(2, period + 1) if period % p == 0 and all(p % q for q in range(2, p))]


def changes_places(left: Node, right: Node) -> bool:
    """Whether the two halves of an orbit have changed places: then it joined the orbit of half its period."""
    return left.equations.period % 2 == 0 and float(halves(left) @ halves(right)) < 0.0


def explained(left: Node, right: Node, found: list[Change]) -> bool:
    """Whether these changes can account for the change in the number of unstable multipliers."""
    difference = right.spectrum.unstable.total - left.spectrum.unstable.total
    ones = sum(change.test in (Test.TURN, Test.AT_ONE, Test.DOUBLING) for change in found)
    twos = sum(change.test in (Test.TORUS, Test.KREIN) for change in found)
    if ones and not twos and _pair_may_have_left(left, right):
        return False
    if found and all(change.test is Test.GRAZING for change in found):
        return difference == 0
    if len(found) == 1 and found[0].test is Test.TURN:
        return abs(difference) <= 1
    return abs(difference) <= ones + 2 * twos and (difference - ones) % 2 == 0


def _pair_may_have_left(left: Node, right: Node) -> bool:
    """Whether a pair may have left the circle and become two real multipliers of which one came back. Beside
    another change of multipliers it looks the same as a pair that becomes real within the circle, so only a
    shorter step tells: one on which pairs stay pairs, and products of two stay on one side of 1."""
    if len(left.spectrum.multipliers) == 2:
        return False  # the modulus of the one pair is the root of the determinant, which only damping moves
    if undamped(left, right):
        return left.spectrum.krein * right.spectrum.krein < 0.0
    product = OF_SPECTRUM[Test.TORUS](left) * OF_SPECTRUM[Test.TORUS](right)
    return product < 0.0 or _pairs(left) != _pairs(right)


def _pairs(node: Node) -> int:
    """How many pairs are complex, of those that are not small."""
    multipliers = node.spectrum.multipliers
    return int(((multipliers.imag > 0.0) & (np.abs(multipliers) > SMALL_PAIR)).sum())


def doubt(before: Node | None, left: Node, right: Node, found: list[Change]) -> str:
    """Why something may have been missed between two orbits beside what was ``found`` (``before``: the orbit
    before them), or nothing."""
    if right.extrema.doubt:
        return right.extrema.doubt
    return _born_near(left, right) or (
        "" if before is None else _may_have_vanished(before, left, right, found)
    )


def _grazings(left: Node, right: Node) -> Iterator[Change]:
    there = right.extrema.by_number
    for extremum in left.extrema.all:
        other = there.get(extremum.number)
        settled = left.touching | right.touching
        if other is None or extremum.number in settled:
            continue
        if (extremum.distance > 0.0) != (other.distance > 0.0):
            yield Change(Test.GRAZING, extremum.number)


def _born_near(left: Node, right: Node) -> str:
    here, there = left.extrema.by_number, right.extrema.by_number
    moved = max((abs(here[n].distance - there[n].distance) for n in here if n in there), default=0.0)
    for side, numbers in ((there, right.extrema.born), (here, right.extrema.died)):
        for number in numbers:
            if abs(side[number].distance) <= BORN_NEAR * moved:
                return f"an extremum is born or ends {abs(side[number].distance):.1e} from its boundary"
    return ""


def _may_have_vanished(before: Node, left: Node, right: Node, found: list[Change]) -> str:
    """Of functions with the same sign at both ends: whether the parabola through three values comes to zero
    between them, or nearly. Where an orbit joins that of half its period, a multiplier only touches 1."""
    earlier, step = float(np.linalg.norm(left.u - before.u)), float(np.linalg.norm(right.u - left.u))
    numbers = before.extrema.by_number.keys() & left.extrema.by_number.keys() & right.extrema.by_number.keys()
    numbers -= before.touching | left.touching | right.touching
    tests = [Change(Test.GRAZING, number) for number in sorted(numbers)]
    left_out = {Test.AT_ONE} if any(change.test in (Test.JOIN, Test.TURN) for change in found) else set()
    left_out |= set() if left.spectrum.unstable.pairs and not undamped(left, right) else {Test.TORUS}
    left_out |= set() if undamped(left, right) and len(right.spectrum.multipliers) > 2 else {Test.KREIN}
    tests += [Change(test) for test in OF_SPECTRUM if test not in left_out]
    for test in tests:
        zero, one, two = test.value(before), test.value(left), test.value(right)
        slack = 0.0 if test.test is Test.AT_ONE else SLACK
        if one * two > 0.0 and _dips(earlier, step, zero / one, two / one, slack):
            return f"the {test.test} comes near zero, from {one:.1e} to {two:.1e}"
    return ""


def _dips(earlier: float, step: float, zero: float, two: float, slack: float) -> bool:
    """Whether the parabola through (-earlier, zero), (0, 1), (step, two) has a least value between 0 and
    ``step``, and how near to zero that is: within what the curvature makes of it on such a step."""
    before, after = (1.0 - zero) / earlier, (two - 1.0) / step
    curvature = (after - before) / (earlier + step)
    if curvature <= 0.0:
        return False
    slope = before + curvature * earlier
    vertex = -0.5 * slope / curvature
    if not -slack * step <= vertex <= (1.0 + slack) * step:
        return False
    return 1.0 - curvature * vertex * vertex <= CURVED * curvature * step * step
