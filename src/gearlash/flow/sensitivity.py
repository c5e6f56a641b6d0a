"""The derivative of a motion by a parameter, from its trace: no other motion is carried, no table built."""

from __future__ import annotations

from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearlash.system import ContactRule, System, derivative, padded
from gearlash.system.harmonics import harmonics

from ._sensitivity import carry_change
from ._tables import FREE, MINUS, OVER_MINUS, OVER_PLUS, PLUS, Array
from .regions import matrix_of
from .traces import Trace


class ClearanceChange(NamedTuple):
    """Of a clearance: how fast its numbers change along a parameter. Of both sides: first +, then -."""

    h: Array
    g: Array
    stiffness: Array  # (2, 2H+1)
    offset: Array  # (2H+1)
    gaps: Array  # (2)
    dampings: Array  # (2)


class SystemChange(NamedTuple):
    """How fast all numbers of a system change along a parameter; series have one length."""

    omega: float
    matrix: Array
    forcing: Array
    clearances: tuple[ClearanceChange, ...]

    @staticmethod
    def between(lower: System, upper: System, width: float) -> SystemChange:
        """By two systems whose parameters are so far apart."""
        count = max(most_harmonics(lower), most_harmonics(upper))
        return of_numbers(lower, (numbers_of(upper, count) - numbers_of(lower, count)) / width, count)


def most_harmonics(system: System) -> int:
    """Of the longest series."""
    series = [s for c in system.clearances for s in (c.stiffness_plus, c.stiffness_minus, c.offset)]
    return max(harmonics(each) for each in (system.forcing, *series))


def numbers_of(system: System, count: int) -> Array:
    """All numbers of a system, one after the other, with so many harmonics in every series."""
    parts = [np.array([system.omega]), system.matrix.ravel(), padded(system.forcing, count).ravel()]
    for c in system.clearances:
        parts += [c.h, c.g, *(padded(s, count) for s in (c.stiffness_plus, c.stiffness_minus, c.offset))]
        parts.append(np.array([c.gap_plus, c.gap_minus, *c.dampings]))
    return np.concatenate(parts)


def of_numbers(like: System, numbers: Array, count: int) -> SystemChange:
    """Such numbers, of a system with as many states and clearances."""
    n, width = like.size, 2 * count + 1
    matrix, forcing = numbers[1 : 1 + n * n], numbers[1 + n * n : 1 + n * (n + width)]
    clearances = []
    for row in numbers[1 + n * (n + width) :].reshape(len(like.clearances), 2 * n + 3 * width + 4):
        series = row[2 * n : -4].reshape(3, width)
        clearances.append(
            ClearanceChange(row[:n], row[n : 2 * n], series[:2], series[2], row[-4:-2], row[-2:])
        )
    return SystemChange(float(numbers[0]), matrix.reshape(n, n), forcing.reshape(n, width), tuple(clearances))


def sensitivity(trace: Trace, change: SystemChange, parts: int = 1) -> Array:
    """The derivative (parts, n) by the parameter of the state at the end of every part of a motion, each from
    a start that is held; the parts are equally long. Phases are held, not times: where the parameter is the
    speed, both periods end with the period."""
    props = trace.propagators
    system, cell = props.system, 2.0 * pi / props.cells
    sides, regions = _regions(trace.modes)
    width = max(2 * most_harmonics(system) + 1, change.forcing.shape[1])
    matrices, changes, forcings = _of_regions(system, change, sides, width)
    vectors, series, edges = _of_clearances(system, change, width)
    part = _parts(trace, parts)
    ends = np.empty((parts, system.size))
    carry_change(
        trace.polynomials,
        np.stack([trace.positions % props.cells * cell, trace.lengths * cell], axis=1),
        regions,
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
        change.omega / system.omega,
        ends,
    )
    return ends


def _parts(trace: Trace, parts: int) -> NDArray[np.int64]:
    """The part (pieces,) in which every piece lies. A motion in one part may be as short as one likes."""
    if parts == 1:
        return np.zeros(len(trace.positions), dtype=np.int64)
    total = float(round(trace.cycles * trace.propagators.cells_per_cycle))
    middles = trace.positions - trace.positions[0] + 0.5 * trace.lengths
    found: NDArray[np.int64] = np.minimum((middles * (parts / total)).astype(np.int64), parts - 1)
    return found


def _regions(modes: Array) -> tuple[Array, Array]:
    """The sides (regions, clearances) in contact, of every region that is met, and the region (pieces) of
    each piece."""
    sides = np.where(modes > MINUS, FREE, modes)
    numbers = sides @ 3 ** np.arange(sides.shape[1])
    _, first, regions = np.unique(numbers, return_index=True, return_inverse=True)
    return sides[first], regions


def _of_regions(system: System, change: SystemChange, sides: Array, width: int) -> tuple[Array, Array, Array]:
    """Of every region that is met, as `carry_change` takes them: the matrix, its change, the forcing's."""
    n = system.size
    matrices, changes = np.empty((2, len(sides), n, n))
    forcings = np.zeros((len(sides), n, width))
    acting = [_damping(system, change, c, width // 2) for c in range(len(system.clearances))]
    for k, row in enumerate(sides.tolist()):
        matrices[k] = matrix_of(system, tuple(row)).T
        changes[k], forcings[k] = change.matrix.T, padded(change.forcing, width // 2)
        for damping, side in zip(acting, row, strict=True):
            if side in damping:
                matrix, forcing = damping[side]
                changes[k] += matrix.T
                forcings[k] += forcing
    return matrices, changes if changes.any() else changes[:, :0], forcings


def _damping(system: System, change: SystemChange, which: int, count: int) -> dict[int, tuple[Array, Array]]:
    """Of every side on which a damper acts: the change of what it adds to matrix and forcing, ζ g (h M) and
    ζ g (h b - e')."""
    own, moved = system.clearances[which], change.clearances[which]
    if not (any(own.dampings) or moved.dampings.any()):
        return {}
    rate = system.omega / system.cycles
    slope, moved_slope = (padded(derivative(series), count) for series in (own.offset, moved.offset))
    force, moved_force = padded(system.forcing, count), padded(change.forcing, count)
    reads, moved_reads = own.h @ system.matrix, moved.h @ system.matrix + own.h @ change.matrix
    feels = own.h @ force - rate * slope
    moved_feels = (
        moved.h @ force + own.h @ moved_force - change.omega / system.cycles * slope - rate * moved_slope
    )
    found = {}
    for side, k in ((PLUS, 0), (MINUS, 1), (FREE, 0)):
        if side == FREE and own.contact is not ContactRule.ALWAYS:
            continue
        damping, faster = own.dampings[k], moved.dampings[k]
        push = faster * own.g + damping * moved.g
        found[side] = (
            np.outer(push, reads) + damping * np.outer(own.g, moved_reads),
            np.outer(push, feels) + damping * np.outer(own.g, moved_feels),
        )
    return found


def _of_clearances(system: System, change: SystemChange, width: int) -> tuple[Array, Array, Array]:
    """As `carry_change` takes them: h, g and their changes; series; edges."""
    count, n = len(system.clearances), system.size
    vectors, series, edges = np.zeros((4, count, n)), np.zeros((6, count, width)), np.zeros((4, count))
    for c, (own, moved) in enumerate(zip(system.clearances, change.clearances, strict=True)):
        vectors[:, c] = own.h, own.g, moved.h, moved.g
        edges[:, c] = own.gap_plus, own.gap_minus, *moved.gaps
        for k, each in enumerate((own.stiffness_plus, own.stiffness_minus, *moved.stiffness, own.offset)):
            series[k, c, : len(each)] = each
        series[5, c, : len(moved.offset)] = moved.offset
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
