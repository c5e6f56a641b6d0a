"""The quiet orbit of an operating point followed along straight lines of a plane, to where the zone ends."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import EndKind, EndOfBranch, Node, SpecialKind, SpecialPoint, walk
from gearlash.branches.curves import Plane
from gearlash.orbits import Orbit, orbit_at
from gearlash.system import GearlashError

from .zone_end import Quiet

Array = NDArray[np.float64]
STOPPED = "stopped"
"""Why a line ends where it was told to."""
LOST = (
    SpecialKind.FOLD,
    SpecialKind.DOUBLING,
    SpecialKind.TORUS,
    SpecialKind.JOINS,
    SpecialKind.SYMMETRIC,
    SpecialKind.EXISTENCE,
)
"""Points beyond which the orbit itself is not stable, or is none."""


@dataclass(frozen=True, eq=False)
class Seen:
    """The orbit at a place (2,); ``period`` in base periods."""

    place: Array
    state: Array
    period: int


@dataclass(frozen=True, eq=False)
class LineEnd:
    """Where a line ends: at what was solved for, at the rectangle (neither), or why else."""

    place: Array
    special: SpecialPoint | None = None
    reason: str = ""

    @property
    def at_limit(self) -> bool:
        return self.special is None and not self.reason


@dataclass(frozen=True, eq=False)
class Line:
    """From a place along one axis, upwards or not."""

    axis: int
    upward: bool
    seen: tuple[Seen, ...]
    end: LineEnd


@dataclass(frozen=True, eq=False)
class Lines:
    """How lines are followed. ``tell`` hears of every orbit, ``stop`` says whether to stop."""

    plane: Plane
    quiet: Quiet
    tell: Callable[[object], object]
    stop: Callable[[], bool]

    def orbit(self, seen: Seen) -> Orbit | None:
        """The quiet stable orbit at a place, near a state."""
        try:
            found = orbit_at(self.plane.system_at(seen.place), seen.state, seen.period, least=True)
        except (GearlashError, np.linalg.LinAlgError):
            return None
        held = found is not None and found.stable and self.quiet.holds_signature(found.signature)
        return found if held else None

    def line(self, start: Seen, axis: int, upward: bool) -> Line | None:
        """The orbit of a place followed along an axis; None where it is not there."""
        plane, name = self.plane, self.plane.names[axis]
        to = (plane.upper if upward else plane.lower)[axis]
        orbit = self.orbit(start)
        if orbit is None:
            return None
        seen = [Seen(start.place, orbit.state, orbit.shot.period)]

        def at(value: float) -> Array:
            place = start.place.copy()
            place[axis] = value
            return place

        def ended(value: float, special: SpecialPoint | None = None, reason: str = "") -> Line:
            return Line(axis, upward, tuple(seen), LineEnd(at(value), special, reason))

        if start.place[axis] == to:
            return ended(to)
        label = orbit.signature
        for item in walk(plane.family, plane.at(start.place), name, orbit, to):
            if isinstance(item, Node):
                self.tell(item.value)
                if self.stop():
                    return ended(item.value, None, STOPPED)
                label = item.orbit.signature
                if not self.quiet.holds_signature(label):
                    return ended(item.value, None, f"becomes {label}, with no touch that was solved for")
                seen.append(Seen(at(item.value), item.orbit.state, item.orbit.shot.period))
            elif isinstance(item, EndOfBranch):
                return ended(item.value, None, "" if item.kind is EndKind.ARRIVED else str(item.kind))
            elif item.kind in LOST or not self.quiet.holds_signature(item.label_after):
                return ended(item.value, item)
            elif item.unstable_after > 0:
                return ended(item.value, None, str(item.kind))
        raise AssertionError("what is followed has an end")
