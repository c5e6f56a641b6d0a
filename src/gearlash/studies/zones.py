"""Stable zones: where a pair runs without impacts, or without impacts on the back side, whatever it
started from.
"""

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
from .model import Model, Source
from .named import plain_axis
from .quiet import Search
from .sweep import sweeps
from .zone import Interval, Physical, Quiet, Zone, ZoneMotion, Zones, intersection, union


def zones(
    model: Model,
    axis: Axis,
    quiet: Quiet | str = Quiet.IMPACT_FREE,
    *,
    values: Mapping[str, float | str] | None = None,
    known: Sequence[Sweep] | None = None,
    start: ArrayLike | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> Zones:
    """Intervals of a parameter with quiet motion, their ends located, and what coexists in them.

    A zone counts where every attractor that cold, up and down sweeps find is quiet; intervals where only
    some are come beside it. Between two points at which a sweep found quiet motion, that motion is followed
    in steps of at most a 128th of the axis, with closer looks where it comes nearest to an impact, and beside
    every grazing that ends another sweep's interval. An end is met by following the sweep's own orbit to
    where it changes or ends (grazing, fold, loss of stability). What is found from cold starts, and motion
    that is not periodic, is halved to about 1e-6 of the value instead (1e-4 where one side is not periodic).

    Parameters
    ----------
    model : Case or Family
    axis : Axis
        At least two values.
    quiet : Quiet or str
        What counts as quiet: "impact-free" or "drive-side-only".
    values : mapping of str to float or str, optional
        Other parameters than the axis, over those of the model.
    known : sequence of Sweep, optional
        Sweeps made before, of this model, axis, ``values``, ``start`` and ``settings``; without them a cold,
        an up and a down sweep are computed.
    start : array_like of shape (n,), optional
        State at phase zero that the sweeps start from; the cold start without.
    settings : Settings, optional
        How attractors are looked for.
    execution : Execution, optional
        How the work is carried out. Its progress counts points, then stretches, then ends.

    Returns
    -------
    Zones

    Raises
    ------
    GearlashError
        For arguments that do not fit, and for sweeps of another question.

    Examples
    --------
    >>> import gearlash as gl
    >>> axis = gl.Axis.even("omega", 0.6, 0.9, 4)
    >>> found = gl.zones(gl.load_case("kahraman-singh"), axis)
    >>> [(round(zone.upper.value, 4), zone.upper.kind) for zone in found.zones]
    [(0.708, 'fold')]
    """
    return zones_of_kinds(
        model, axis, [quiet], values=values, known=known, start=start, settings=settings, execution=execution
    )[0]


def zones_of_kinds(
    model: Model,
    axis: Axis,
    kinds: Sequence[Quiet | str],
    *,
    values: Mapping[str, float | str] | None = None,
    known: Sequence[Sweep] | None = None,
    start: ArrayLike | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> tuple[Zones, ...]:
    """The same of several kinds from the same sweeps."""
    source = Source.of(model)
    family = source.family()
    wanted, settings = [given.choice(Quiet, "kind of zone", k) for k in kinds], checked_settings(settings)
    axis = plain_axis(model, family, axis)
    fixed, begin = checked_values(model, family, values, [axis]), checked_start(family, start)
    execution = checked_execution(source, execution)
    if len(axis) < 2:
        raise GearlashError(f"zones along {axis.name}: expected at least two values")
    ways = None if known is None else given.instances("known", known, Sweep, "sweeps made before")
    ended: list[str] = []
    if ways is None:
        ways = sweeps(model, axis, values=fixed, start=begin, settings=settings, execution=execution)
        ended += [sweep.message for sweep in ways if not sweep.complete]
    _check(ways, axis, fixed)
    found, donors = [], []
    for quiet in wanted:
        search = Search(source, tuple(fixed.items()), settings, quiet, begin, execution, donors, ended)
        found.append(_found(model, ways, axis, search))
    return tuple(found)


def _found(model: Model, ways: Sequence[Sweep], axis: Axis, search: Search) -> Zones:
    quiet, (rows, reason, step) = search.quiet, search.rows(ways)
    certain = [_zone(model, ways, quiet, interval, True) for interval in intersection(rows)]
    wide = [_zone(model, ways, quiet, interval, False) for interval in union(rows)]
    wider = [zone for zone in wide if not any(_same(zone, sure) for sure in certain)]
    return Zones(quiet, axis, tuple(certain), tuple(wider), tuple(ways), not reason, reason, axis.step, step)


def _check(ways: Sequence[Sweep], axis: Axis, fixed: Mapping[str, float] | None) -> None:
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
