"""Whether motion stays quiet between neighbouring quiet points of a sweep: it is followed there in smaller
steps, and looked at more closely where it comes nearest to an impact. Of motion from cold starts, too, which
follows no branch (`scanned`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import ceil, inf

import numpy as np

from gearlash import flow
from gearlash.jobs import Part, stopping
from gearlash.orbits import Orbit, Settings, grazing_checks, orbit_at
from gearlash.orbits.minimum import Sample, bracketed_minimum
from gearlash.results import Point
from gearlash.system import ContactRule, Family, GearlashError, System

from .model import Source
from .row import Neighbour, continued, neighbour_after
from .zone_end import Quiet

SIDE_HALVINGS = 20  # of a step in which the side of contact changes without an impact being seen
NO_NEIGHBOUR = Neighbour(None, None)


@dataclass(frozen=True, eq=False)
class Stretch:
    """Neighbouring quiet ``points`` of one sweep, in the order of the axis; ``falling``: the motion is
    followed downwards. ``step`` is the widest step in which it is followed; ``probes`` are further values to
    look at."""

    source: Source
    fixed: tuple[tuple[str, float], ...]
    name: str
    settings: Settings
    quiet: Quiet
    falling: bool
    points: tuple[Point, ...]
    step: float
    probes: tuple[float, ...] = ()


def look_between(stretch: Stretch, carry: object) -> Part:
    """Points between those of a stretch, as a task of `jobs.run`: all that were looked at, quiet or not."""
    walk = _Walk(stretch.source.family(), dict(stretch.fixed), stretch)
    found = list(walk.probed() if stretch.probes else walk.steps())
    if not stretch.probes:
        found += walk.changes_of_side(_sorted([*stretch.points, *found]))
        found += walk.dips(_sorted([*stretch.points, *found]))
    return Part(()) if stopping() else Part((tuple(found),))


@dataclass(frozen=True, eq=False)
class _Walk:
    family: Family
    fixed: Mapping[str, float]
    stretch: Stretch

    def steps(self) -> Iterator[Point]:
        """From point to point in steps that are small enough."""
        for below, above in pairwise(self.stretch.points):
            count = ceil((above.value - below.value) / self.stretch.step * (1.0 - 1e-9))
            inner = np.linspace(below.value, above.value, count + 1)[1:-1]
            yield from self.across(below, above, list(map(float, inner)))

    def probed(self) -> Iterator[Point]:
        """The values asked for, each from the nearest point of the stretch."""
        for value in self.stretch.probes:
            yield self.at(value, min(self.stretch.points, key=lambda point: abs(point.value - value)))

    def across(self, below: Point, above: Point, values: list[float]) -> Iterator[Point]:
        """From one side until motion is no longer quiet; then from the other side, until it meets that."""
        starts = [(below, values), (above, values[::-1])]
        for last, way in starts[::-1] if self.stretch.falling else starts:
            for value in list(way):
                if stopping() or value not in values:
                    break
                last = self.at(value, last)
                values.remove(value)
                yield last
                if not self.stretch.quiet.holds(last):
                    break

    def changes_of_side(self, nodes: Sequence[Point]) -> Iterator[Point]:
        """Where contact is on another side at two quiet neighbours, something lies between: it is halved
        until it is seen, or as narrow as halving goes."""
        for below, above in pairwise(nodes):
            if not (self.quiet(below) and self.quiet(above)):
                continue
            side, other = self.side(below), self.side(above)
            for _ in range(SIDE_HALVINGS if side != other else 0):
                start = above if self.stretch.falling else below
                middle = self.at(0.5 * (below.value + above.value), start)
                yield middle
                if stopping() or not self.quiet(middle):
                    break
                below, above = (middle, above) if self.side(middle) == side else (below, middle)

    def dips(self, nodes: Sequence[Point]) -> Iterator[Point]:
        """Closer looks where the room is least among neighbours."""
        room = [self.room(node) if self.quiet(node) else -1.0 for node in nodes]
        for i in range(1, len(nodes) - 1):
            if stopping() or not 0.0 < room[i] <= min(room[i - 1], room[i + 1]) < inf:
                continue
            known, seen = {nodes[j].value: nodes[j] for j in (i - 1, i, i + 1)}, []

            def distance(value: float, known=known, seen=seen) -> float:
                near = min(known, key=lambda other: (abs(other - value), other))
                point = self.at(value, known[near])
                seen.append(point)
                if not self.quiet(point):
                    return -1.0
                known[value] = point
                return self.room(point)

            samples: list[Sample] = [(nodes[j].value, room[j]) for j in (i - 1, i, i + 1)]
            bracketed_minimum(distance, *samples)
            yield from seen

    def at(self, value: float, start: Point) -> Point:
        values = self.family.complete({**self.fixed, self.stretch.name: value})
        return continued(
            self.family,
            values,
            self.stretch.name,
            neighbour_after(NO_NEIGHBOUR, start),
            self.stretch.settings,
        )

    def quiet(self, point: Point) -> bool:
        return self.stretch.quiet.holds(point)

    def system(self, point: Point) -> System:
        return self.family.system(self.family.complete({**self.fixed, self.stretch.name: point.value}))

    def room(self, point: Point) -> float:
        """How far a quiet motion stays from an impact that counts, in X (or Φ, where contact ends with
        it)."""
        system = self.system(point)
        everything = self.stretch.quiet is Quiet.IMPACT_FREE
        if _simple(system):
            c = system.clearances[0]
            edges = [c.gap_plus] * (everything and c.stops(1)) + [-c.gap_minus] * c.stops(-1)
            return min((abs(x - e) for e in edges for x in (point.minimum, point.maximum)), default=inf)
        checks = grazing_checks(orbit) if (orbit := _orbit(system, point)) is not None else ()
        return min((abs(c.distance) for c in checks if everything or c.boundary < 0), default=inf)

    def side(self, point: Point) -> tuple[int, ...]:
        """In which clearances a quiet motion is in contact all the time, and on which side (±1; 0: elsewhere
        or not all the time). A motion that goes from one to the other passes something that is not quiet.
        Where impacts on the drive side do not count, neither does contact there."""
        system = self.system(point)
        if _simple(system):
            c = system.clearances[0]
            found = [(point.minimum >= c.gap_plus) - (point.maximum <= -c.gap_minus)]
        elif (orbit := _orbit(system, point)) is None:
            return ()
        else:
            kept = [set(orbit.trace.regions_of(j).tolist()) for j in range(len(system.clearances))]
            found = [(regions == {0}) - (regions == {2}) for regions in kept]
        return (
            tuple(min(s, 0) for s in found) if self.stretch.quiet is Quiet.DRIVE_SIDE_ONLY else tuple(found)
        )


def _simple(system: System) -> bool:
    """Whether the extremes of X that a point keeps are all that matters."""
    return len(system.clearances) == 1 and system.clearances[0].contact is not ContactRule.NO_TENSION


def _orbit(system: System, point: Point) -> Orbit | None:
    try:
        found = orbit_at(flow.propagators(system), point.state, len(point.strobes))
    except GearlashError:
        return None
    return found if found is not None and found.status.ok else None


def _sorted(points: Iterable[Point]) -> list[Point]:
    return sorted(points, key=lambda point: point.value)
