"""A sweep: one attractor per value of a parameter."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import ClassVar

from gearlash.system import Record

from .axis import Axis
from .point import NOT_COMPUTED, Point


class Direction(StrEnum):
    """Where each point starts: from the cold start, or from the attractor of the point before it."""

    COLD = "cold"
    UP = "up"
    DOWN = "down"


@dataclass(frozen=True, eq=False, repr=False)
class Sweep(Record):
    """``points`` in the order of the axis, whatever the direction, one for every value. Where the sweep was
    stopped early ``complete`` is False, ``message`` says why, and what is missing has the status
    `not-computed`. ``fixed`` are the parameters that were set beside the case's own.
    """

    _told: ClassVar = ("axis", "direction", "shares", "statuses", "complete", "message", "fixed")

    axis: Axis
    direction: Direction
    points: tuple[Point, ...]
    complete: bool = True
    message: str = ""
    fixed: Mapping[str, float] = field(default_factory=dict)

    @property
    def computed(self) -> int:
        """How many points were computed."""
        return sum(point.status != NOT_COMPUTED for point in self.points)

    @property
    def statuses(self) -> dict[str, int]:
        """How many points have which status."""
        return dict(Counter(point.status for point in self.points))

    @property
    def certificates(self) -> dict[str, int]:
        """How many of the computed points are certified, uncertain, failed."""
        return dict(Counter(point.certificate for point in self.points if point.certificate))

    def runs(self) -> list[tuple[int, int, str]]:
        """Maximal stretches of one label: (first index, last index, label), in the order of the axis."""
        found: list[tuple[int, int, str]] = []
        for i, point in enumerate(self.points):
            label = point.label or point.status
            if found and found[-1][2] == label:
                found[-1] = (found[-1][0], i, label)
            else:
                found.append((i, i, label))
        return found
