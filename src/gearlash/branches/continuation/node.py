"""One orbit of a branch with all that the follower looks at."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gearlash.orbits import Orbit, Signature, orbit_at
from gearlash.orbits.floquet import ordered
from gearlash.system import GearlashError

from .equations import Array, Equations, Evaluated
from .extrema import Extrema
from .newton import Corrected, correct, tangent
from .testfunctions import Spectrum

FLAT_TURN = 1e-6  # what is no change of the parameter along a branch


@dataclass(frozen=True, eq=False)
class Node:
    """``u``: scaled unknowns; ``direction``: unit tangent of the branch; ``slope``: derivative of the
    equations along the parameter near it; ``extrema`` numbered along the branch,
    of which those ``touching`` lie on their boundary."""

    equations: Equations
    here: Evaluated
    slope: Array
    direction: Array
    orbit: Orbit
    extrema: Extrema
    touching: frozenset[int] = frozenset()

    def linked(self, before: Node) -> Node:
        """The same as what comes after ``before``: its extrema numbered and its direction turned so."""
        return replace(self.oriented(before), extrema=self.extrema.after(before.extrema))

    def oriented(self, before: Node) -> Node:
        """The same, with the direction in which the branch comes from ``before``. Where a contact comes or
        goes just where periods are begun states may turn by more than a right angle; the parameter turns
        round only where the product of all μ - 1 changes sign, too."""
        onwards = self.direction @ before.direction >= 0.0
        if not np.array_equal(self.modes, before.modes):
            one, other = self.spectrum, before.spectrum
            if min(abs(one.turn), abs(other.turn)) > FLAT_TURN:
                onwards = (one.turn * other.turn > 0.0) == (one.at_one * other.at_one > 0.0)
        return self if onwards else self.turned

    @property
    def turned(self) -> Node:
        """The same, with the direction the other way."""
        return replace(self, direction=-self.direction)

    @property
    def u(self) -> Array:
        return self.here.u

    @property
    def value(self) -> float:
        return self.equations.value(self.u)

    def way_from(self, other: Node) -> Array:
        """Difference of the scaled unknowns from those of another orbit of the branch, its periods begun at
        the phase at which those of this one are."""
        if other.equations.phase == self.equations.phase:
            return self.u - other.u
        return self.u - self.equations.unknowns(other.orbit, other.value)

    def apart(self, other: Node) -> float:
        """Arclength of the straight way from another orbit of the branch."""
        return float(np.linalg.norm(self.way_from(other)))

    @property
    def label(self) -> Signature:
        return self.orbit.signature

    @cached_property
    def modes(self) -> NDArray[np.int64]:
        """(P, clearances): in which contact the motion is where its base periods are begun."""
        trace, cells = self.orbit.trace, self.here.props.cells
        begun = self.equations.phase * self.here.props.cells_per_cycle
        starts = begun + np.arange(self.equations.period) * float(cells)
        pieces = np.searchsorted(trace.positions, starts, side="right") - 1
        return trace.modes[np.maximum(pieces, 0)]

    @cached_property
    def spectrum(self) -> Spectrum:
        return Spectrum(ordered(np.linalg.eigvals(self.here.monodromy)), float(self.direction[-1]))


@dataclass(frozen=True, eq=False)
class Found:
    """A node, or why there is none; Newton's steps on the way."""

    node: Node | None
    corrected: Corrected | None = None
    failure: str = ""


def node_near(
    equations: Equations,
    guess: Array,
    row: Array,
    target: float,
    before: Node | None,
    slope: Array | None = None,
    *,
    exact: bool = True,
    near: bool = False,
) -> Found:
    """The orbit of the branch with row·u = ``target``; its direction agrees with that of ``before``, whose
    extrema it continues (without one: with the row). ``exact``: the derivative along the parameter is taken
    at the orbit itself; else the one that Newton's method went by is kept. ``near``: so near to the target is
    near enough."""
    corrected = correct(equations, guess, row, target, slope, near=near)
    if corrected.here is None:
        return Found(None, corrected, corrected.failure)
    here = corrected.here
    orbit = orbit_at(here.props, equations.at_zero(here), equations.period, iterations=1)
    if orbit is None:
        return Found(None, corrected, "the orbit does not close over its whole period")
    toward = row if before is None else before.direction
    try:
        slope = equations.slope(here, orbit.trace) if exact or slope is None else corrected.slope
        direction = tangent(equations, here, slope, toward)
    except np.linalg.LinAlgError:
        return Found(None, corrected, "the branch has no direction: two branches meet")
    except GearlashError as error:
        return Found(None, corrected, f"there is no system that could be built: {error}")
    extrema = Extrema.of(orbit)
    extrema = extrema if before is None else extrema.after(before.extrema)
    node = Node(equations, here, slope, direction, orbit, extrema)
    return Found(node if before is None else node.oriented(before), corrected)
