"""The derivative of a motion by a parameter, from its trace: no other motion is carried, no table built."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from gearlash.system import Clearance, ContactRule, System, padded
from gearlash.system.harmonics import harmonics

from ._sensitivity import carry_change
from ._tables import FREE, MINUS, OVER_MINUS, OVER_PLUS, Array
from .regions import Sides, forcing_of, matrix_of
from .traces import Trace


@dataclass(frozen=True, eq=False)
class SystemChange:
    """How a system changes along a parameter: all its numbers by (``upper`` - ``lower``) / ``width``."""

    lower: System
    upper: System
    width: float

    def of(self, upper: Array | float, lower: Array | float) -> Array:
        return np.subtract(upper, lower) / self.width

    @property
    def clearances(self) -> list[tuple[Clearance, Clearance]]:
        return list(zip(self.lower.clearances, self.upper.clearances, strict=True))


def sensitivity(trace: Trace, change: SystemChange, parts: int = 1) -> Array:
    """The derivative (parts, n) by the parameter of the state at the end of every part of a motion, each from
    a start that is held; the parts are equally long. Phases are held, not times: where the parameter is the
    speed, both periods end with the period."""
    props = trace.propagators
    system, cell = props.system, 2.0 * pi / props.cells
    sides, regions = np.unique(_sides(trace.modes), axis=0, return_inverse=True)
    width = 2 * _harmonics(system, change) + 1
    matrices, changes, forcings = _of_regions(system, change, sides, width)
    vectors, series, edges = _of_clearances(system, change, width)
    total = float(round(trace.cycles * props.cells_per_cycle))
    first = float(trace.positions[0])
    part = np.minimum(
        ((trace.positions - first + 0.5 * trace.lengths) * (parts / total)).astype(int), parts - 1
    )
    ends = np.empty((parts, system.size))
    carry_change(
        trace.polynomials,
        np.stack([trace.positions % props.cells * cell, trace.lengths * cell], axis=1),
        regions.ravel(),
        sides,
        _jumps(trace),
        part,
        matrices,
        changes,
        forcings,
        vectors,
        series,
        edges,
        system.omega / system.cycles,
        (change.upper.omega - change.lower.omega) / (change.width * system.omega),
        ends,
    )
    return ends


def _sides(modes: Array) -> Array:
    """(pieces, clearances) int: the side in contact."""
    return np.where(modes > MINUS, FREE, modes)


def _harmonics(system: System, change: SystemChange) -> int:
    found = 0
    for each in (system, change.lower, change.upper):
        series = [s for c in each.clearances for s in (c.stiffness_plus, c.stiffness_minus, c.offset)]
        found = max(found, *(harmonics(s) for s in (each.forcing, *series)))
    return found


def _of_regions(system: System, change: SystemChange, sides: Array, width: int) -> tuple[Array, Array, Array]:
    """Of every region that is met, as `carry_change` takes them: the matrix, its change, the forcing's."""
    n = system.size
    matrices, changes = np.empty((2, len(sides), n, n))
    forcings = np.zeros((len(sides), n, width))
    for k, row in enumerate(sides.tolist()):
        region: Sides = tuple(row)
        matrices[k] = matrix_of(system, region).T
        changes[k] = change.of(matrix_of(change.upper, region), matrix_of(change.lower, region)).T
        upper, lower = (padded(forcing_of(s, region), width // 2) for s in (change.upper, change.lower))
        forcings[k] = change.of(upper, lower)
    return matrices, changes if changes.any() else changes[:, :0], forcings


def _of_clearances(system: System, change: SystemChange, width: int) -> tuple[Array, Array, Array]:
    """As `carry_change` takes them: h, g and their changes; series; edges."""
    count, n = len(system.clearances), system.size
    vectors, series, edges = np.zeros((4, count, n)), np.zeros((6, count, width)), np.zeros((4, count))
    for c, (own, (lower, upper)) in enumerate(zip(system.clearances, change.clearances, strict=True)):
        vectors[:, c] = own.h, own.g, change.of(upper.h, lower.h), change.of(upper.g, lower.g)
        edges[:, c] = (
            own.gap_plus,
            own.gap_minus,
            change.of(upper.gap_plus, lower.gap_plus),
            change.of(upper.gap_minus, lower.gap_minus),
        )
        for k, name in ((0, "stiffness_plus"), (1, "stiffness_minus"), (4, "offset")):
            mine, low, high = (padded(getattr(each, name), width // 2) for each in (own, lower, upper))
            series[k, c], series[5 if k == 4 else k + 2, c] = mine, change.of(high, low)
    return vectors, series.reshape(-1), edges


def _jumps(trace: Trace) -> Array:
    """(pieces, 2·clearances): ± ζ of side + and of side - where a force that damps sets in or ceases with a
    jump as a piece begins. With `no-tension` it does not, where the force itself is zero there."""
    clearances = trace.propagators.system.clearances
    found = np.zeros((len(trace.modes), 2 * len(clearances)))
    for c, clearance in enumerate(clearances):
        if clearance.contact is ContactRule.ALWAYS or not any(clearance.dampings):
            continue
        modes = trace.modes[:, c]
        over = (modes == OVER_PLUS) | (modes == OVER_MINUS)
        smooth = over[1:] | over[:-1]
        for side, (mode, damping) in enumerate(zip((0, 2), clearance.dampings, strict=True)):
            closed = (modes == mode).astype(np.float64)
            found[1:, 2 * c + side] = np.where(smooth, 0.0, damping * np.diff(closed))
    return found
