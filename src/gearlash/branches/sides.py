"""What the touching orbit is on both sides of a grazing point.

A contact that is born in a touch changes the multipliers by the root of its depth: a stable orbit may lose
its stability, or end in a fold, very soon after. So the labels are read as near to the point as is needed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearlash.orbits import GrazingCheck, Orbit, grazing_checks, orbit_at
from gearlash.system import Label, MotionKind, Signature

from .curves.plane import UNBUILT, Array, Plane

LABEL_DISTANCES = (1e-6, 1e-8, 1e-10)  # relative distances at which the labels are read, until both are
SAME_ORBIT = 1e-2  # of the state's size: an orbit that lies farther away is another one


@dataclass(frozen=True, eq=False)
class Side:
    """The orbit on one side, if it was found there."""

    orbit: Orbit | None

    @property
    def signature(self) -> Signature | None:
        return self.orbit.signature if self.orbit else None

    @property
    def label(self) -> Label:
        return self.orbit.label if self.orbit else MotionKind.NONE

    @property
    def stable(self) -> bool | None:
        return self.orbit.stable if self.orbit else None


@dataclass(frozen=True, eq=False)
class Sides:
    """Below and above the point, as near as they were read at last."""

    below: Side
    above: Side
    check: GrazingCheck

    @staticmethod
    def of(plane: Plane, value: float, zero: Array, period: int, check: GrazingCheck) -> Sides:
        """Both sides of a point at a value of the parameter; ``zero``: the touching orbit at phase zero, its
        period in base periods."""
        found: Sides | None = None
        for relative in LABEL_DISTANCES:
            away = relative * max(abs(value), 1e-3)
            below, above = (Side(_orbit(plane, value + sign * away, zero, period)) for sign in (-1, 1))
            found = Sides(below, above, check)
            if found.differ_by_the_touch:
                break
        assert found is not None
        return found

    @property
    def differ_by_the_touch(self) -> bool:
        below, above = self.below.signature, self.above.signature
        here = self.check.clearance, self.check.boundary
        return below is not None and above is not None and below.one_impact_from(above) == here

    @property
    def admissible(self) -> bool:
        """Whether the solution is a touch of a real orbit: on both sides, or on the side without the contact
        alone, where it was not found beyond."""
        if self.differ_by_the_touch:
            return True
        known = [side.orbit for side in (self.below, self.above) if side.orbit is not None]
        return len(known) == 1 and self._clear(known[0])

    def _clear(self, orbit: Orbit) -> bool:
        """Whether the orbit passes the boundary without touching: the nearest extremum of the same kind lies
        on the side from which it was met."""
        mine = [
            check
            for check in grazing_checks(orbit, clearance=self.check.clearance)
            if (check.boundary, check.surface) == (self.check.boundary, self.check.surface)
            and check.a0 * self.check.a0 > 0.0
        ]
        return bool(mine) and mine[0].distance * mine[0].a0 > 0.0


def _orbit(plane: Plane, value: float, zero: Array, period: int) -> Orbit | None:
    """The orbit at a value beside the point, if there is one so near."""
    try:
        found = orbit_at(plane.system_at(np.array([value])), zero, period)
    except UNBUILT:
        return None
    if found is None:
        return None
    near = np.abs(found.state - zero).max() <= SAME_ORBIT * max(1.0, float(np.abs(zero).max()))
    return found if near else None
