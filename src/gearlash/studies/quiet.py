"""From sweeps to intervals of quiet motion: what lies between their points is looked at, then every end is
located, then whether the ends of one sweep's intervals bound those of another. That is asked of one way of
scanning (`scanned`), whose intervals end at edges of basins, too: no branch has these.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash.jobs import Chain, Execution, run
from gearlash.jobs.chains import Work
from gearlash.orbits import Settings
from gearlash.results import Direction, Point, Sweep, same_motion
from gearlash.system import Status

from .between import Stretch, look_between
from .ends import END_WIDTH, Bracket, find_end
from .model import Source
from .zone_end import RANGE, UNKNOWN, Interval, Quiet, ZoneEnd

STEPS = 128  # of the whole axis in which quiet motion is followed, at least
PIECE = 128  # points of a task
PASSES = 3  # in which the ends of one sweep are looked at in the others
PROBE_DISTANCE = 8.0  # uncertainties of an end beside which another sweep is looked at; `END_WIDTH` at least
Ends = Mapping[tuple[Direction, float, float], ZoneEnd]


@dataclass(frozen=True, eq=False)
class Row:
    """The points of a sweep and those looked at between them, in the order of the axis; ``sampled``: the
    values of the sweep itself; ``probed``: ends of other rows that were looked at here."""

    direction: Direction
    points: tuple[Point, ...]
    sampled: frozenset[float]
    probed: frozenset[float] = frozenset()

    @cached_property
    def places(self) -> dict[float, int]:
        """Where the values of the sweep itself stand among the points."""
        return {point.value: i for i, point in enumerate(self.points) if point.value in self.sampled}

    def stretches(self, quiet: Quiet) -> list[tuple[int, int]]:
        """First and last index of every maximal run of quiet points."""
        flags = np.array([False, *(quiet.holds(point) for point in self.points), False])
        edges = np.flatnonzero(flags[1:] != flags[:-1])
        return [(int(i), int(j) - 1) for i, j in zip(edges[::2], edges[1::2], strict=True)]

    def gaps(self, quiet: Quiet) -> list[tuple[Point, Point]]:
        """Neighbours between which a stretch ends inside the range."""
        pairs = pairwise(self.points)
        return [(below, above) for below, above in pairs if quiet.holds(below) != quiet.holds(above)]

    def widest(self, quiet: Quiet) -> float:
        """The widest step between neighbours inside a stretch."""
        values = np.array([point.value for point in self.points])
        steps = [float(np.diff(values[i : j + 1]).max()) for i, j in self.stretches(quiet) if j > i]
        return max(steps, default=0.0)

    def between(self, below: Point, above: Point, counts: Quiet) -> tuple[Point, ...] | None:
        """Points looked at between two values of the sweep, if this row has the same motions there and they
        count as quiet (so that it was looked at there)."""
        first, last = self.places.get(below.value), self.places.get(above.value)
        if first is None or last is None:
            return None
        pairs = ((self.points[first], below), (self.points[last], above))
        if not all(counts.holds(own) and same_motion(own, other) for own, other in pairs):
            return None
        return self.points[first + 1 : last]

    def with_points(self, points: Iterable[Point], probed: Iterable[float] = ()) -> Row:
        known = {point.value: point for point in self.points}
        merged = {point.value: point for point in points} | known  # a point of the sweep stays as it is
        ordered = tuple(merged[value] for value in sorted(merged))
        return Row(self.direction, ordered, self.sampled, self.probed | frozenset(probed))


@dataclass(frozen=True, eq=False)
class Search:
    """What decides the ends, and how the work is done; see `zones`. ``donors`` are rows whose points between
    may serve others, with what counted as quiet there; ``ended``: why the work was ended, if it was: then
    nothing more is begun."""

    source: Source
    fixed: tuple[tuple[str, float], ...]
    settings: Settings
    quiet: Quiet
    start: NDArray[np.float64] | None
    execution: Execution
    donors: list[tuple[Quiet, Row]] = field(default_factory=list)
    ended: list[str] = field(default_factory=list)
    reasons: list[str] = field(default_factory=list)

    def rows(self, ways: Sequence[Sweep]) -> tuple[list[list[Interval]], str, float]:
        """Quiet intervals of each sweep, why something is missing, if it is, and the widest step between
        neighbouring values that were looked at inside them."""
        self.reasons.extend(sweep.message for sweep in ways if not sweep.complete)
        axis = ways[0].axis
        step = float(axis.values[-1] - axis.values[0]) / STEPS
        shown = [_with_neighbours(sweep.points) for sweep in ways]
        rows = [
            Row(s.direction, points, frozenset(p.value for p in points))
            for s, points in zip(ways, shown, strict=True)
        ]
        rows = self.followed(rows, axis.name, step)
        ends = self.located(axis.name, rows, {})
        for _ in range(PASSES):
            probes = [self.probes(row, ends) for row in rows]
            if not any(probes):
                break
            rows = self.probed(rows, probes, axis.name, step)
            ends = self.located(axis.name, rows, ends)
        every = [[self.interval(row, i, j, ends) for i, j in row.stretches(self.quiet)] for row in rows]
        intervals = [[one for one in some if one.width > 0.0] for some in every]  # one point is no interval
        widest = max(row.widest(self.quiet) for row in rows)
        return intervals, next(iter(self.reasons), ""), widest

    def followed(self, rows: Sequence[Row], name: str, step: float) -> list[Row]:
        """Every row with what lies between its quiet points: the first row first, as mostly the others have
        the same motion there, and need not follow it again."""
        done: list[Row] = []
        for some in (rows[:1], rows[1:]):
            given = [row.with_points(self.given(row)) for row in some]
            done += self.looked(given, lambda row: self.between(row, name, step))
            self.donors.extend((self.quiet, row) for row in done[len(done) - len(some) :])
        return done

    def given(self, row: Row) -> Iterator[Point]:
        """Points between those of a row that another one has found where it has the same motion on both
        sides, and that stay quiet."""
        for below, above in self.quiet_pairs(row):
            for counts, donor in self.donors:
                inner = donor.between(below, above, counts)
                if inner and all(counts.holds(p) and self.quiet.holds(p) for p in inner):
                    yield from inner
                    break

    def quiet_pairs(self, row: Row) -> Iterator[tuple[Point, Point]]:
        """Neighbouring quiet points."""
        holds = self.quiet.holds
        return ((a, b) for a, b in pairwise(row.points) if holds(a) and holds(b))

    def between(self, row: Row, name: str, step: float) -> Iterator[Stretch]:
        """The stretches of a row, without what was given, in pieces that overlap by the neighbours of their
        ends."""
        open_: list[Point] = []
        for below, above in self.quiet_pairs(row):
            if {below.value, above.value} <= row.sampled and not self.known(below, above):
                continues = open_ and open_[-1] is below and len(open_) <= PIECE
                if open_ and not continues:
                    yield self.stretch(row, open_, name, step)
                    open_ = open_[-2:] if open_[-1] is below else []
                open_ = [*open_, above] if open_ else [below, above]
        if open_:
            yield self.stretch(row, open_, name, step)

    def known(self, below: Point, above: Point) -> bool:
        """Whether another row has looked between these two and had no need of further points."""
        return any(donor.between(below, above, counts) == () for counts, donor in self.donors)

    def stretch(self, row: Row, points: Sequence[Point], name: str, step: float) -> Stretch:
        falling = row.direction is Direction.DOWN
        return Stretch(self.source, self.fixed, name, self.settings, self.quiet, falling, tuple(points), step)

    def looked(self, rows: Sequence[Row], tasks: Callable[[Row], Iterable[Stretch]]) -> list[Row]:
        """Every row with what was found between its points."""
        each = [list(tasks(row)) for row in rows]
        chains = [Chain((i, j), (task,), (1,)) for i, some in enumerate(each) for j, task in enumerate(some)]
        got = self.done(look_between, chains)
        return [
            row.with_points(point for j in range(len(some)) for point in got.get((i, j), ()))
            for i, (row, some) in enumerate(zip(rows, each, strict=True))
        ]

    def done(self, work: Work, chains: Sequence[Chain]) -> dict[Hashable, Any]:
        """What each task returned; a reason is kept where not all was done."""
        if not chains:
            return {}
        if self.ended:
            self.reasons.append(self.ended[0])
            return {}
        outcome = run(work, chains, self.execution)
        if outcome.reason:
            self.ended.append(outcome.reason)
            self.reasons.append(outcome.reason)
        return {name: found[0] for name, found in outcome.results.items() if found}

    def probes(self, row: Row, ends: Ends) -> list[tuple[int, ZoneEnd]]:
        """Grazings that end other rows' intervals and lie between quiet neighbours of this one (the index of
        the lower), not looked at yet."""
        values = np.array([point.value for point in row.points])
        found = {}
        for end in ends.values():
            at = int(np.searchsorted(values, end.value)) - 1
            if (
                end.point is None
                or not end.point.is_grazing
                or end.value in row.probed
                or not 0 <= at < len(values) - 1
            ):
                continue
            if self.quiet.holds(row.points[at]) and self.quiet.holds(row.points[at + 1]):
                found[end.value] = (at, end)
        return [found[value] for value in sorted(found)]

    def probed(
        self, rows: Sequence[Row], probes: Sequence[Sequence[tuple[int, ZoneEnd]]], name: str, step: float
    ) -> list[Row]:
        """Every row with points on both sides of those ends."""
        asked = {row.direction: those for row, those in zip(rows, probes, strict=True)}

        def tasks(row: Row) -> Iterator[Stretch]:
            for at, end in asked[row.direction]:
                below, above = row.points[at : at + 2]
                apart = max(PROBE_DISTANCE * end.uncertainty, END_WIDTH * max(abs(end.value), 1e-3))
                inner = tuple(
                    v for v in (end.value - apart, end.value + apart) if below.value < v < above.value
                )
                yield replace(self.stretch(row, (below, above), name, step), probes=inner)

        looked = self.looked(rows, tasks)
        return [
            row.with_points((), (end.value for _, end in those))
            for row, those in zip(looked, probes, strict=True)
        ]

    def located(self, name: str, rows: Sequence[Row], known: Ends) -> Ends:
        """Every end inside the range, those ``known`` as they are."""
        brackets: dict[tuple[Direction, float, float], Bracket] = {}
        for row in rows:
            for below, above in row.gaps(self.quiet):
                key = row.direction, below.value, above.value
                if key not in known and below.computed and above.computed:
                    followed = not {below.value, above.value} <= row.sampled
                    brackets[key] = Bracket(
                        self.source, self.fixed, name, self.settings, self.quiet, row.direction,
                        below, above, self.start, followed,
                    )  # fmt: skip
        chains = [Chain(key, (bracket,), (1,)) for key, bracket in sorted(brackets.items())]
        got = self.done(find_end, chains)
        return {**known, **{key: got[key] for key in brackets if key in got}}

    def interval(self, row: Row, first: int, last: int, ends: Ends) -> Interval:
        """The interval of a stretch."""

        def end(inside: int, outside: int) -> ZoneEnd:
            point, way = row.points[inside], str(row.direction)
            if not 0 <= outside < len(row.points):
                return ZoneEnd(point.value, RANGE, inside=point.label, direction=way)
            beyond = row.points[outside]
            reason = beyond.message if not beyond.computed else "stopped early"
            unknown = ZoneEnd(point.value, UNKNOWN, inside=point.label, direction=way, reason=reason)
            below, above = sorted((point.value, beyond.value))
            return ends.get((row.direction, below, above), unknown)

        return Interval(end(first, first - 1), end(last, last + 1))


def _with_neighbours(points: tuple[Point, ...]) -> tuple[Point, ...]:
    """Those that a study came to, and what is next to them: of a sweep that was stopped the others, of which
    there may be a hundred thousand, tell nothing."""
    came = np.array([False, *(point.status is not Status.NOT_COMPUTED for point in points), False])
    near = came[:-2] | came[1:-1] | came[2:]
    return points if near.all() else tuple(point for point, close in zip(points, near, strict=True) if close)
