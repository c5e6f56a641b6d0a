"""Quiet intervals as one way of scanning shows them: where the sweeps that are given are quiet.

A sweep of cold starts changes its motion at ends of basins too, which are no ends of any motion: so these
intervals tell of the way of scanning as much as of the system. `zones` tells of the motions themselves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from gearlash.jobs import Execution
from gearlash.orbits import Settings
from gearlash.results import Axis, Sweep, same_motion
from gearlash.results.physical import physical_axis
from gearlash.system import GearlashError, Label, given

from .arguments import checked_execution, checked_settings, checked_start, checked_values
from .ends import END_WIDTH
from .intervals import intersection, union
from .model import Model, Source
from .named import plain_axis
from .quiet import Search
from .zone import Physical, Zone, ZoneMotion, Zones
from .zone_end import Interval, Quiet


def scanned_zones(
    model: Model,
    axis: Axis,
    quiet: Quiet | str,
    known: Sequence[Sweep],
    *,
    values: Mapping[str, float | str] | None = None,
    start: ArrayLike | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> Zones:
    """Intervals in which all of the sweeps are quiet, and in which at least one is, their ends located.

    Between two points at which a sweep found quiet motion, that motion is followed in steps of at most a
    128th of the axis. An end is met by following the sweep's own orbit to where it changes or ends. What is
    found from cold starts, and motion that is not periodic, is halved to about 1e-6 of the value (1e-4
    where one side is not periodic). ``known``, ``values``, ``start`` and ``settings`` belong together."""
    source = Source.of(model)
    family = source.family()
    wanted, settings = given.choice(Quiet, "kind of zone", quiet), checked_settings(settings)
    axis = plain_axis(model, family, axis)
    fixed, begin = checked_values(model, family, values, [axis]), checked_start(family, start)
    execution = checked_execution(source, execution)
    if len(axis) < 2:
        raise GearlashError(f"zones along {axis.name}: expected at least two values")
    ways = given.instances("known", known, Sweep, "sweeps made before")
    check_sweeps(ways, axis, fixed)
    search = Search(source, tuple(fixed.items()), settings, wanted, begin, execution, [], [])
    return _found(model, ways, axis, search)


def _found(model: Model, ways: Sequence[Sweep], axis: Axis, search: Search) -> Zones:
    quiet, (rows, reason, step) = search.quiet, search.rows(ways)
    certain = [_zone(model, ways, quiet, interval, True) for interval in intersection(rows)]
    wide = [_zone(model, ways, quiet, interval, False) for interval in union(rows)]
    wider = [zone for zone in wide if not any(_same(zone, sure) for sure in certain)]
    return Zones(quiet, axis, tuple(certain), tuple(wider), tuple(ways), not reason, reason, axis.step, step)


def check_sweeps(ways: Sequence[Sweep], axis: Axis, fixed: Mapping[str, float] | None) -> None:
    """Sweeps made before must be those of this question."""
    if not ways:
        raise GearlashError("zones of no sweep: expected at least one")
    for sweep in ways:
        same = sweep.axis.name == axis.name and np.array_equal(sweep.axis.values, axis.values)
        if not same or dict(sweep.fixed) != dict(fixed or {}):
            raise GearlashError(f"a sweep {sweep.direction} over another axis or with other fixed parameters")


def _zone(model: Model, ways: Sequence[Sweep], quiet: Quiet, interval: Interval, every: bool) -> Zone:
    name = ways[0].axis.name
    ends = Axis(name, np.unique([interval.lower.value, interval.upper.value]))  # one value if it has no width
    physical = tuple(
        Physical(n, float(v[0]), float(v[-1]), unit) for n, v, unit in physical_axis(model, ends)
    )
    return Zone(interval.lower, interval.upper, name, quiet, every, _motions(ways, quiet, interval), physical)


def _motions(ways: Sequence[Sweep], quiet: Quiet, interval: Interval) -> tuple[ZoneMotion, ...]:
    """Who was seen at the values inside, as stretches of one label found by the same sweeps."""
    open_, closed = {}, []
    for i, value in enumerate(map(float, ways[0].axis.values)):
        if not interval.contains(value):
            continue
        here = {}
        for who, holds, directions in _residents(ways, quiet, i):
            before = open_.pop((who, directions), None)
            lower = before.lower if before else value
            here[who, directions] = ZoneMotion(who, directions, lower, value, holds)
        closed.extend(open_.values())
        open_ = here
    return tuple(sorted([*closed, *open_.values()], key=lambda t: (t.lower, t.upper, str(t.label))))


def _residents(ways: Sequence[Sweep], quiet: Quiet, i: int) -> list[tuple[Label, bool, tuple[str, ...]]]:
    """Different motions at one value: label, whether quiet, and the directions that found it."""
    groups: list[tuple[Label, list[Sweep]]] = []
    for sweep in ways:
        label = sweep.points[i].label
        if label is None:  # no motion was found
            continue
        same = (group for _, group in groups if same_motion(group[0].points[i], sweep.points[i]))
        home = next(same, None)
        if home is None:
            groups.append((label, [sweep]))
        else:
            home.append(sweep)
    return [
        (label, quiet.holds(group[0].points[i]), tuple(str(sweep.direction) for sweep in group))
        for label, group in groups
    ]


def _same(one: Interval, other: Interval) -> bool:
    """Equal but for what halving leaves open."""
    pairs = ((one.lower, other.lower), (one.upper, other.upper))
    return all(
        abs(a.value - b.value) <= a.uncertainty + b.uncertainty + 4.0 * END_WIDTH * max(abs(a.value), 1e-3)
        for a, b in pairs
    )
