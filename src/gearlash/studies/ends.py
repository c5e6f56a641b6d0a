"""Where exactly a motion stops being quiet, between two neighbouring points of a sweep.

The bracket is halved by the sweep's own way of finding attractors; what happens in it is then solved for:
a grazing, or the fold at which the followed orbit ends.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches import BifurcationPoint, GrazingPoint, locate_grazing, locate_multiplier
from gearlash.jobs import Part
from gearlash.orbits import Orbit, Settings, grazing_checks, orbit_at
from gearlash.results import Direction, Point
from gearlash.system import Family, GearlashError, Status

from .model import Source
from .row import Trail, onward, step
from .transitions import FOLD, GRAZING, unlocated
from .zone import BASIN, End, Quiet

NARROW = 1e-6  # of the value: width at which halving ends
ROUGH = 1e-4  # the same where one side is not periodic: no label is sharp there, and each costs much
HALVINGS = 40
ROUNDS = 4  # of searching on, where the motion that is followed was lost too early
STEEP = 100.0  # how far an extremum may move, in units of the change of the parameter, and at least SETTLED
SETTLED = 1e-3
BESIDE = 3.0  # bracket widths: how near to a bracket a fold must be to be what happens in it


@dataclass(frozen=True, eq=False)
class Bracket:
    """Neighbouring points of one sweep, ``below`` and ``above``, of which one is quiet. ``start`` is what
    the sweep started from (None: the family's own). ``followed``: they lie between points of the sweep, and
    motion was followed from one to the other, whatever the direction of the sweep."""

    source: Source
    fixed: tuple[tuple[str, float], ...]
    name: str
    settings: Settings
    quiet: Quiet
    direction: Direction
    below: Point
    above: Point
    start: NDArray[np.float64] | None
    followed: bool = False

    @property
    def cold(self) -> bool:
        """Is what lies between found from cold starts?"""
        return self.direction is Direction.COLD and not self.followed


def find_end(bracket: Bracket, carry: object) -> Part:
    """The end in a bracket, as a task of `jobs.run`."""
    search = _Search(bracket.source.family(), dict(bracket.fixed), bracket)
    return Part((search.end(*search.halved()),))


@dataclass(frozen=True, eq=False)
class _Search:
    family: Family
    fixed: Mapping[str, float]
    bracket: Bracket

    def halved(self) -> tuple[Point, Point, list[Point]]:
        """A bracket of relative width `NARROW` (or `ROUGH`), and the periodic points nearest to it on
        either side: just beyond a fold motion is slow and seems aperiodic for long.

        A motion that is followed may be lost in a step that is long for it. So the last steps, which are
        short, are tried once more from what was found last; where it goes on after all, so does the search.
        """
        below, above, last = self.narrowed(self.bracket.below, self.bracket.above)
        for _ in range(0 if self.bracket.cold else ROUNDS):
            farther = self.farther(below, above)
            if farther is None:
                break
            below, above, last = self.narrowed(*farther)
        return below, above, last

    def narrowed(self, below: Point, above: Point) -> tuple[Point, Point, list[Point]]:
        """The bracket halved by the sweep's own way."""
        last = {False: below, True: above}
        for _ in range(HALVINGS):
            sharp = NARROW if below.periodic and above.periodic else ROUGH
            if above.value - below.value <= sharp * max(abs(above.value), 1e-3):
                break
            middle = self.found(0.5 * (below.value + above.value), below, above)
            if self.quiet(middle) == self.quiet(below):
                below = middle
            else:
                above = middle
            if middle.periodic:
                last[middle is above] = middle
        return below, above, [point for point in last.values() if point.periodic]

    def farther(self, below: Point, above: Point) -> tuple[Point, Point] | None:
        """A bracket beyond a narrow one, if the motion that is followed goes on through it; it is followed in
        steps that grow, as far again as the bracket of the sweep is wide. None where it ends in the narrow
        one, or not so soon."""
        falling, wide = (
            self.bracket.direction is Direction.DOWN,
            self.bracket.above.value - self.bracket.below.value,
        )
        lead, other, sign = (above, below, -1.0) if falling else (below, above, 1.0)
        limit = (self.bracket.below if falling else self.bracket.above).value + sign * wide
        value, width = other.value, above.value - below.value
        while lead.periodic and sign * (limit - value) >= 0.0:
            point = self.step(value, onward(Trail(self.bracket.start, None), lead))
            if not point.computed or (value == other.value and self.quiet(point) == self.quiet(other)):
                return None
            if self.quiet(point) == self.quiet(other):
                return (point, lead) if falling else (lead, point)
            lead, width = point, 2.0 * width
            value = lead.value + sign * width
        return None

    def found(self, value: float, below: Point, above: Point) -> Point:
        """What a sweep of this direction finds between two points, coming from its side."""
        trail = Trail(self.bracket.start, None)
        if not self.bracket.cold:
            trail = onward(trail, above if self.bracket.direction is Direction.DOWN else below)
        return self.step(value, trail)

    def step(self, value: float, trail: Trail) -> Point:
        return step(self.family, self.at(value), self.bracket.name, trail, self.bracket.settings)

    def end(self, below: Point, above: Point, nearest: list[Point]) -> End:
        """What happens in a narrow bracket."""
        inside, outside = (below, above) if self.quiet(below) else (above, below)
        labels = (inside.label or inside.status, outside.label or outside.status)
        way = str(self.bracket.direction)
        for kind, point in self.solutions(below, above, nearest):
            if isinstance(point, BifurcationPoint) and not self.bracket.quiet.holds_label(point.label):
                # The orbit that ends; what a sweep sees just beyond a fold is its slow ghost.
                labels = (labels[0], point.label)
            return End(point.value, kind, point.error, *labels, way, point)
        middle, half = 0.5 * (below.value + above.value), 0.5 * (above.value - below.value)
        return End(middle, self.unsolved(inside, outside), half, *labels, way)

    def solutions(
        self, below: Point, above: Point, nearest: list[Point]
    ) -> Iterator[tuple[str, GrazingPoint | BifurcationPoint]]:
        """Grazings in the bracket that change what counts, then folds at it."""
        orbits = [(point.value, orbit) for point in nearest if (orbit := self.orbit(point)) is not None]
        width = above.value - below.value
        for value, orbit in orbits:
            for check in grazing_checks(orbit, within=max(SETTLED, STEEP * width)):
                point = self.solve(locate_grazing, value, orbit, check)
                if isinstance(point, GrazingPoint) and self.explains(point, below, above):
                    yield GRAZING, point
        for value, orbit in orbits:
            point = self.solve(locate_multiplier, value, orbit, 1)
            near = point is not None and abs(point.value - below.value) <= BESIDE * width
            if near and isinstance(point, BifurcationPoint):
                yield FOLD, point

    def solve(self, locate, value: float, orbit: Orbit, which) -> GrazingPoint | BifurcationPoint | None:
        """A special point near a value, if there is one to rely on."""
        try:
            point = locate(self.family, self.at(value), self.bracket.name, orbit, which)
        except (GearlashError, np.linalg.LinAlgError):
            return None
        return point if point.status is Status.OK else None

    def explains(self, point: GrazingPoint, below: Point, above: Point) -> bool:
        """Whether a grazing lies in the bracket and makes the difference between its ends."""
        slack = 1e-3 * (above.value - below.value)
        holds = self.bracket.quiet.holds_label
        return (
            below.value - slack <= point.value <= above.value + slack
            and holds(point.label_below) == self.quiet(below)
            and holds(point.label_above) == self.quiet(above)
        )

    def unsolved(self, inside: Point, outside: Point) -> str:
        """What to call a change that no point was solved for."""
        if self.bracket.cold:
            followed = self.step(outside.value, onward(Trail(None, None), inside))
            if self.quiet(followed):
                return BASIN
        return unlocated(inside, outside)

    def orbit(self, point: Point) -> Orbit | None:
        """The orbit of a periodic point, to solve from."""
        props = flow.propagators(self.family.system(self.at(point.value)))
        found = orbit_at(props, point.state, len(point.strobes))
        return found if found is not None and found.status.ok else None

    def at(self, value: float) -> dict[str, float]:
        return self.family.complete({**self.fixed, self.bracket.name: value})

    def quiet(self, point: Point) -> bool:
        return self.bracket.quiet.holds(point)
