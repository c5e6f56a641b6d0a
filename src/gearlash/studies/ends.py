"""Where exactly a motion stops being quiet, between two neighbouring points of a sweep.

A motion is followed (`walk`) from the side that the sweep comes from, to where it begins or ceases
to be quiet: a grazing, a fold, or what else ends it. What is no followed orbit is sought by halving instead:
motion that is not periodic, and what is found from cold starts. There the orbits on both sides are followed
through the narrow bracket that is left, to say what happens in it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches.continuation import EndKind, EndOfBranch, Node, SpecialPoint, walk
from gearlash.jobs import Part
from gearlash.orbits import Orbit, Settings, orbit_at
from gearlash.results import Direction, Point
from gearlash.system import Family, GearlashError, Label, Signature

from .model import Source
from .point import summary
from .row import Neighbour, continued, neighbour_after
from .transition import kind_of, unlocated
from .zone_end import BASIN, Quiet, ZoneEnd

END_WIDTH = 1e-6  # of the value: width at which halving ends
ROUGH = 1e-4  # the same where one side is not periodic: no label is sharp there, and each costs much
END_HALVINGS = 40
ORBITS = 4  # that are followed one after the other, where one ends and the next one is as quiet
ENDS = EndKind.FOLD, EndKind.TOUCH, EndKind.DOUBLING, EndKind.PERIOD, EndKind.UNSTABLE, EndKind.CORNER
"""Why a motion is not followed on that are ends of it."""
EXPLAINED_WITHIN = 3.0  # bracket widths: an orbit that ends so near to a bracket is what happens in it


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

    @property
    def in_order(self) -> tuple[Point, Point]:
        """Both in the order in which the sweep came to them."""
        falling = self.direction is Direction.DOWN
        return (self.above, self.below) if falling else (self.below, self.above)


def find_end(bracket: Bracket, carry: object) -> Part:
    """The end in a bracket, as a task of `jobs.run`."""
    search = _Search(bracket.source.family(), dict(bracket.fixed), bracket)
    return Part((search.along_the_orbit() or search.by_halving(),))


@dataclass(frozen=True, eq=False)
class _Change:
    """Where a followed orbit begins or ceases to be quiet, or ends: within ± ``error`` of ``value``; the last
    orbit before it and its label there, the label after it (where the motion goes on), the point solved
    for."""

    value: float
    error: float
    before: Point
    label: Label
    after: Label | None
    point: SpecialPoint | None

    @property
    def kind(self) -> str:
        """What it is called; "" where nothing is known but that the orbit does not go on."""
        return "" if self.point is None else kind_of(self.point)


@dataclass(frozen=True, eq=False)
class _Search:
    family: Family
    fixed: Mapping[str, float]
    bracket: Bracket

    def along_the_orbit(self) -> ZoneEnd | None:
        """The end met first by the orbit of the side that the sweep comes from, as far beyond the other side
        as the bracket is wide: a sweep may have lost in a step what goes on. None where no orbit is
        followed, or none of those that follow each other comes to an end."""
        near, far = self.bracket.in_order
        last, point = 2.0 * far.value - near.value, near
        for _ in range(0 if self.bracket.cold else ORBITS):
            change = self.first_change(point, last)
            if change is None:
                return None
            if change.after is not None:
                return self.zone_end(change, change.after)
            beyond = self.beyond(change, last)
            if self.quiet(beyond) != self.quiet(near):
                return self.zone_end(change, beyond.label, beyond)
            point = beyond
        return None

    def first_change(self, point: Point, last: float) -> _Change | None:
        """The first change of the orbit of a point on the way to a value."""
        orbit = self.orbit(point)
        if orbit is None or not orbit.stable:
            return None
        most, last_orbit, met = self.bracket.settings.max_period, orbit, None
        value = point.value
        way = walk(self.family, self.at(value), self.bracket.name, orbit, last, longest=most)
        for item in way:
            if isinstance(item, EndOfBranch):
                return self.ended(item, met, summary(last_orbit, value))
            label = item.label if isinstance(item, Node) else item.label_before
            if met is not None and self.holds(met.label_before) != self.holds(label):
                return _Change(met.value, met.error, summary(last_orbit, value), met.label_before, label, met)
            met = None if isinstance(item, Node) else item
            if isinstance(item, Node):
                last_orbit, value = item.orbit, item.value
        raise AssertionError("what is followed has an end")

    def ended(self, end: EndOfBranch, met: SpecialPoint | None, before: Point) -> _Change | None:
        """The end of a motion, if it is one: in the point that was met last, or with none."""
        if end.kind not in ENDS:
            return None
        if met is not None:
            return _Change(met.value, met.error, before, met.label_before, None, met)
        assert before.label is not None
        error = abs(end.value - before.value)
        return _Change(end.value, error, before, before.label, None, None)

    def beyond(self, change: _Change, last: float) -> Point:
        """What the sweep comes to beyond the end of an orbit: just beyond a fold motion is slow, and seems
        aperiodic for long."""
        far = self.bracket.in_order[1]
        value = change.value + np.sign(last - change.value) * ROUGH * max(abs(change.value), 1e-3)
        if min(change.value, value) < far.value <= max(change.value, value):
            return far
        return self.step(float(value), neighbour_after(Neighbour(self.bracket.start, None), change.before))

    def zone_end(self, change: _Change, after: Label | None, beyond: Point | None = None) -> ZoneEnd:
        """The end at a change of the orbit that the sweep follows; ``after``: the label beyond."""
        before, way = change.label, str(self.bracket.direction)
        labels = (before, after) if self.holds(before) else (after, before)
        kind = change.kind or (unlocated(change.before, beyond) if beyond else "")
        reason = _reason(beyond) if beyond else ""
        return ZoneEnd(change.value, kind, change.error, *labels, way, change.point, reason)

    def by_halving(self) -> ZoneEnd:
        """The end in a bracket that is halved by the sweep's own way, and what the orbits on both sides of it
        say of it."""
        below, above, nearest = self.narrowed(self.bracket.below, self.bracket.above)
        inside, outside = (below, above) if self.quiet(below) else (above, below)
        labels, reason = (inside.label, outside.label), _reason(outside)
        way = str(self.bracket.direction)
        change = self.explanation(below, above, nearest)
        if change is not None:
            if change.after is None and not self.holds(change.label):
                # The orbit that ends: what is seen beyond is its slow ghost.
                labels, reason = (inside.label, change.label), ""
            kind = change.kind or unlocated(inside, outside)
            return ZoneEnd(change.value, kind, change.error, *labels, way, change.point, reason)
        middle, half = 0.5 * (below.value + above.value), 0.5 * (above.value - below.value)
        return ZoneEnd(middle, self.unsolved(inside, outside), half, *labels, way, None, reason)

    def narrowed(self, below: Point, above: Point) -> tuple[Point, Point, list[Point]]:
        """A bracket of relative width `END_WIDTH` (or `ROUGH`), and the periodic points nearest to it on
        either side."""
        last = {False: below, True: above}
        for _ in range(END_HALVINGS):
            sharp = END_WIDTH if below.periodic and above.periodic else ROUGH
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

    def explanation(self, below: Point, above: Point, nearest: list[Point]) -> _Change | None:
        """The change of an orbit beside a narrow bracket that happens in it."""
        width = above.value - below.value
        for point in nearest:
            last = above.value + EXPLAINED_WITHIN * width
            if point.value >= above.value:
                last = below.value - EXPLAINED_WITHIN * width
            change = self.first_change(point, last)
            if change is None:
                continue
            slack = width * (EXPLAINED_WITHIN if change.after is None else 1e-3)
            if below.value - slack <= change.value <= above.value + slack:
                return change
        return None

    def found(self, value: float, below: Point, above: Point) -> Point:
        """What a sweep of this direction finds between two points, coming from its side."""
        neighbour = Neighbour(self.bracket.start, None)
        if not self.bracket.cold:
            neighbour = neighbour_after(
                neighbour, above if self.bracket.direction is Direction.DOWN else below
            )
        return self.step(value, neighbour)

    def step(self, value: float, neighbour: Neighbour) -> Point:
        return continued(self.family, self.at(value), self.bracket.name, neighbour, self.bracket.settings)

    def unsolved(self, inside: Point, outside: Point) -> str:
        """What to call a change that no point was solved for."""
        if self.bracket.cold:
            followed = self.step(outside.value, neighbour_after(Neighbour(None, None), inside))
            if self.quiet(followed):
                return BASIN
        return unlocated(inside, outside)

    def orbit(self, point: Point) -> Orbit | None:
        """The orbit of a periodic point, to follow."""
        if not point.periodic:
            return None
        try:
            props = flow.propagators(self.family.system(self.at(point.value)))
            found = orbit_at(props, point.state, len(point.strobes))
        except (GearlashError, np.linalg.LinAlgError):
            return None
        return found if found is not None and found.status.ok else None

    def at(self, value: float) -> dict[str, float]:
        return self.family.complete({**self.fixed, self.bracket.name: value})

    def quiet(self, point: Point) -> bool:
        return self.bracket.quiet.holds(point)

    def holds(self, label: Label) -> bool:
        return isinstance(label, Signature) and self.bracket.quiet.holds_signature(label)


def _reason(outside: Point) -> str:
    """Why a point has no label; empty where it has one."""
    return str(outside.status) if outside.label is None else ""
