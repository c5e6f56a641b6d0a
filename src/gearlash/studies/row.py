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

GRID_STEP = 0.1  # of the motion's size: longest step on a coarse grid that needs no transient


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
class Neighbour:
    """Where a followed attractor was last: a state (n,) at phase zero (None: the cold start), and the point
    that it belongs to.
    """

    state: NDArray[np.float64] | None
    point: Point | None


class _Latest(threading.local):
    """What this thread computed last: where frequency, stiffness and damping stay, its propagators are used
    again.
    """

    propagators: Propagators | None = None


_latest = _Latest()


def work(segment: Segment, neighbour: Neighbour) -> Part:
    """The points of a segment, as far as they go before a stop, and the neighbour of the next one."""
    family, found = segment.source.family(), []
    with handing_on(lambda: Part(tuple(found), neighbour)):
        for value in segment.values:
            if stopping():
                break
            values = {**dict(segment.fixed), segment.name: value}
            if segment.follow:
                point = continued(family, values, segment.name, neighbour, segment.settings)
                neighbour = neighbour_after(neighbour, point)
            else:
                point = _at(family, values, segment.name, neighbour.state, None, segment.settings)
            found.append(point)
    return Part(tuple(found), neighbour)


def continued(
    family: Family, values: dict[str, float], name: str, neighbour: Neighbour, settings: Settings
) -> Point:
    """The attractor at ``values``, followed from a neighbour: its orbit is tried first, and where that fails,
    or leads somewhere else, the motion itself runs on from the neighbour's state.
    """
    last = neighbour.point
    if last is None or not last.periodic:
        return _at(family, values, name, neighbour.state, None, settings)
    point = _at(family, values, name, neighbour.state, (last.state, len(last.strobes)), settings)
    size = max(last.maximum - last.minimum, point.maximum - point.minimum, 1e-3)
    if point.periodic and not is_near(last.state, point.state, size):
        return _at(family, values, name, neighbour.state, None, settings)
    return point


def is_near(before: NDArray[np.float64], after: NDArray[np.float64], size: float) -> bool:
    """Whether an orbit that Newton's method found from that of a neighbour on a coarse grid is taken for what
    the neighbour's motion comes to, without a transient that confirms it. ``before`` and ``after`` (n,) are
    their states, ``size`` that of the motion."""
    return bool(np.abs(after - before).max() <= GRID_STEP * size)


def neighbour_after(neighbour: Neighbour, point: Point) -> Neighbour:
    """The neighbour of what follows a point: one that failed or ran away leaves it as it was."""
    usable = (
        point.computed
        and len(point.state) > 0
        and bool(np.isfinite(point.state).all())
        and len(point.strobes) > 0
    )
    return Neighbour(point.state, point) if usable else neighbour


def _at(
    family: Family,
    values: dict[str, float],
    name: str,
    start: NDArray[np.float64] | None,
    trial: tuple[NDArray[np.float64], int] | None,
    settings: Settings,
) -> Point:
    point, _latest.propagators = evaluate(family, values, name, start, trial, settings, _latest.propagators)
    return point
