"""Stable zones: where a pair runs without impacts, or without impacts on the back side, whatever it
started from.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.jobs import Cancel, Chain, ProgressCallback, run
from gearlash.orbits import Settings
from gearlash.results import Axis, Direction, Sweep, same_motion
from gearlash.results.physical import physical_axis
from gearlash.system import GearlashError, given

from .arguments import checked_fixed, checked_settings, checked_start, checked_ways
from .ends import NARROW, Bracket, find_end
from .model import Model, Source
from .sweep import sweeps
from .zone import RANGE, UNKNOWN, End, Interval, Physical, Quiet, Tenant, Zone, Zones, intersection, union


def zones(
    model: Model,
    axis: Axis,
    quiet: Quiet | str = Quiet.IMPACT_FREE,
    *,
    fixed: Mapping[str, float] | None = None,
    known: Sequence[Sweep] | None = None,
    initial: ArrayLike | None = None,
    settings: Settings | None = None,
    executor: Executor | None = None,
    progress: ProgressCallback | None = None,
    cancel: Cancel | None = None,
) -> Zones:
    """Maximal intervals of ``axis`` with quiet motion, their ends located, and what coexists in them.

    A zone counts where every attractor that cold, up and down sweeps find is quiet; intervals where only
    some are come beside it. ``known`` are such sweeps made before (of this model, axis, ``fixed``,
    ``initial`` and ``settings``); without them all three are computed. An end is solved for (grazing,
    fold) where the sweep's own attractor is seen to change there, else halved to about 1e-6 of
    itself. ``progress`` counts points, then ends. Other arguments as in `sweep`.
    """
    family = Source.of(model).family()
    quiet, settings = given.choice(Quiet, "kind of zone", quiet), checked_settings(settings)
    fixed, start = checked_fixed(family, fixed, [axis]), checked_start(family, initial)
    checked_ways(executor, progress, cancel)
    if len(axis) < 2:
        raise GearlashError(f"zones along {axis.name}: expected at least two values")
    ways = None if known is None else given.instances("known", known, Sweep, "sweeps made before")
    if ways is None:
        ways = sweeps(
            model,
            axis,
            fixed=fixed,
            initial=initial,
            settings=settings,
            executor=executor,
            progress=progress,
            cancel=cancel,
        )
    _check(ways, axis, fixed)
    search = _Search(Source.of(model), tuple(fixed.items()), settings, quiet, start)
    rows, reason = search.rows(ways, executor, progress, cancel)
    certain = [_zone(model, ways, quiet, interval, True) for interval in intersection(rows)]
    wide = [_zone(model, ways, quiet, interval, False) for interval in union(rows)]
    wider = [zone for zone in wide if not any(_same(zone, sure) for sure in certain)]
    return Zones(quiet, axis, tuple(certain), tuple(wider), ways, not reason, reason, axis.step)


def _check(ways: Sequence[Sweep], axis: Axis, fixed: Mapping[str, float] | None) -> None:
    """Sweeps made before must be those of this question."""
    if not ways:
        raise GearlashError("zones of no sweep: expected at least one")
    for sweep in ways:
        same = sweep.axis.name == axis.name and np.array_equal(sweep.axis.values, axis.values)
        if not same or dict(sweep.fixed) != dict(fixed or {}):
            raise GearlashError(f"a sweep {sweep.direction} over another axis or with other fixed parameters")


@dataclass(frozen=True, eq=False)
class _Search:
    """From sweeps to intervals: every end in a task of its own."""

    source: Source
    fixed: tuple[tuple[str, float], ...]
    settings: Settings
    quiet: Quiet
    start: NDArray[np.float64] | None

    def rows(
        self,
        ways: Sequence[Sweep],
        executor: Executor | None,
        progress: ProgressCallback | None,
        cancel: Cancel | None,
    ) -> tuple[list[list[Interval]], str]:
        """Quiet intervals of each sweep, and why something is missing, if it is."""
        stretches = [(sweep, first, last) for sweep in ways for first, last in _stretches(sweep, self.quiet)]
        gaps = {(sweep.direction, at) for sweep, i, j in stretches for at in _gaps(i, j, len(sweep.points))}
        brackets = {(way, at): self.bracket(ways, way, at) for way, at in sorted(gaps)}
        chains = [Chain(key, (bracket,), (1,)) for key, bracket in brackets.items() if bracket is not None]
        outcome = run(find_end, chains, executor, progress=progress, cancel=cancel)
        found = {key: got[0] for key, got in outcome.results.items() if got}
        rows = [[_interval(sweep, i, j, found) for s, i, j in stretches if s is sweep] for sweep in ways]
        early = next((sweep.message for sweep in ways if not sweep.complete), "")
        return rows, early or outcome.reason

    def bracket(self, ways: Sequence[Sweep], way: Direction, at: int) -> Bracket | None:
        """Points ``at`` and ``at`` + 1 of a sweep, if both were computed."""
        points = next(sweep.points for sweep in ways if sweep.direction == way)
        below, above = points[at], points[at + 1]
        if not (below.computed and above.computed):
            return None
        axis = ways[0].axis.name
        return Bracket(
            self.source, self.fixed, axis, self.settings, self.quiet, way, below, above, self.start
        )


def _stretches(sweep: Sweep, quiet: Quiet) -> list[tuple[int, int]]:
    """First and last index of every maximal run of quiet points."""
    flags = np.array([False, *(quiet.holds(point) for point in sweep.points), False])
    edges = np.flatnonzero(flags[1:] != flags[:-1])
    return [(int(i), int(j) - 1) for i, j in zip(edges[::2], edges[1::2], strict=True)]


def _gaps(first: int, last: int, count: int) -> list[int]:
    """Where a stretch ends inside the range: the index below each such gap."""
    return [first - 1] * (first > 0) + [last] * (last < count - 1)


def _interval(sweep: Sweep, first: int, last: int, found: Mapping[Hashable, End]) -> Interval:
    def end(at: int, inside: int, outside: int) -> End:
        value, label = sweep.points[inside].value, sweep.points[inside].label
        if not 0 <= outside < len(sweep.points):
            return End(value, RANGE, inside=label, direction=str(sweep.direction))
        beyond = sweep.points[outside]
        reason = beyond.message if not beyond.computed else "stopped early"
        unknown = End(value, UNKNOWN, inside=label, outside=reason, direction=str(sweep.direction))
        return found.get((sweep.direction, at), unknown)

    return Interval(end(first - 1, first, first - 1), end(last, last, last + 1))


def _zone(model: Model, ways: Sequence[Sweep], quiet: Quiet, interval: Interval, every: bool) -> Zone:
    name = ways[0].axis.name
    ends = Axis(name, np.array([interval.lower.value, interval.upper.value]))
    physical = tuple(Physical(n, float(v[0]), float(v[1]), unit) for n, v, unit in physical_axis(model, ends))
    return Zone(interval.lower, interval.upper, name, quiet, every, _tenants(ways, quiet, interval), physical)


def _tenants(ways: Sequence[Sweep], quiet: Quiet, interval: Interval) -> tuple[Tenant, ...]:
    """Who was seen at the values inside, as stretches of one label found by the same sweeps."""
    open_, closed = {}, []
    for i, value in enumerate(map(float, ways[0].axis.values)):
        if not interval.contains(value):
            continue
        here = {}
        for who, holds, directions in _residents(ways, quiet, i):
            before = open_.pop((who, directions), None)
            here[who, directions] = Tenant(who, directions, before.lower if before else value, value, holds)
        closed.extend(open_.values())
        open_ = here
    return tuple(sorted([*closed, *open_.values()], key=lambda t: (t.lower, t.upper, t.label)))


def _residents(ways: Sequence[Sweep], quiet: Quiet, i: int) -> list[tuple[str, bool, tuple[str, ...]]]:
    """Different motions at one value: label, whether quiet, and the directions that found it."""
    groups: list[list[Sweep]] = []
    for sweep in ways:
        if not sweep.points[i].computed:
            continue
        home = next((group for group in groups if same_motion(group[0].points[i], sweep.points[i])), None)
        if home is None:
            groups.append([sweep])
        else:
            home.append(sweep)
    return [
        (g[0].points[i].label, quiet.holds(g[0].points[i]), tuple(str(sweep.direction) for sweep in g))
        for g in groups
    ]


def _same(one: Interval, other: Interval) -> bool:
    """Equal but for what halving leaves open."""
    pairs = ((one.lower, other.lower), (one.upper, other.upper))
    return all(
        abs(a.value - b.value) <= a.uncertainty + b.uncertainty + 4.0 * NARROW * max(abs(a.value), 1e-3)
        for a, b in pairs
    )
