"""What a worker does: a segment of a sweep."""

from __future__ import annotations

import threading
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Propagators
from gearlash.jobs import Part, handing_on, stopping
from gearlash.orbits import Settings
from gearlash.results import Point
from gearlash.system import Family

from .model import Source
from .point import evaluate

JUMP = (
    0.1  # of the motion's size: an orbit that lies farther from its neighbour's is confirmed by a transient
)


@dataclass(frozen=True)
class Segment:
    """Values of one parameter in the order of travel, and all else that decides the points there."""

    source: Source
    fixed: tuple[tuple[str, float], ...]
    name: str
    settings: Settings
    follow: bool
    values: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Trail:
    """Where a followed attractor was last: a state (n,) at phase zero (None: cold), and the point it belongs
    to.
    """

    state: NDArray[np.float64] | None
    point: Point | None


class _Bench(threading.local):
    """What this thread computed last: where frequency, stiffness and damping stay, its propagators are used
    again.
    """

    propagators: Propagators | None = None


_bench = _Bench()


def work(segment: Segment, trail: Trail) -> Part:
    """The points of a segment, as far as they go before a stop, and the trail for the next one."""
    family, found = segment.source.family(), []
    with handing_on(lambda: Part(tuple(found), trail)):
        for value in segment.values:
            if stopping():
                break
            values = {**dict(segment.fixed), segment.name: value}
            if segment.follow:
                point = step(family, values, segment.name, trail, segment.settings)
                trail = onward(trail, point)
            else:
                point = _at(family, values, segment.name, trail.state, None, segment.settings)
            found.append(point)
    return Part(tuple(found), trail)


def step(family: Family, values: dict[str, float], name: str, trail: Trail, settings: Settings) -> Point:
    """The attractor at ``values``, followed from a neighbour: its orbit is tried first, and where that fails,
    or leads somewhere else, the motion itself runs on from the neighbour's state.
    """
    last = trail.point
    if last is None or not last.periodic:
        return _at(family, values, name, trail.state, None, settings)
    point = _at(family, values, name, trail.state, (last.state, len(last.strobes)), settings)
    if point.periodic and _jumped(last, point):
        return _at(family, values, name, trail.state, None, settings)
    return point


def onward(trail: Trail, point: Point) -> Trail:
    """The trail after a point: one that failed or ran away leaves it where it was."""
    usable = (
        point.computed
        and len(point.state) > 0
        and bool(np.isfinite(point.state).all())
        and len(point.strobes) > 0
    )
    return Trail(point.state, point) if usable else trail


def _at(
    family: Family,
    values: dict[str, float],
    name: str,
    start: NDArray[np.float64] | None,
    trial: tuple[NDArray[np.float64], int] | None,
    settings: Settings,
) -> Point:
    point, _bench.propagators = evaluate(family, values, name, start, trial, settings, _bench.propagators)
    return point


def _jumped(last: Point, point: Point) -> bool:
    """Whether Newton's method left the neighbourhood of the orbit it was given."""
    size = max(last.maximum - last.minimum, point.maximum - point.minimum, 1e-3)
    return bool(np.abs(point.state - last.state).max() > JUMP * size)
