"""The linear systems that one piecewise-linear system is made of: numbering, equations and inputs of regions.

A region is told by the side of every clearance: `PLUS`, `FREE` or `MINUS`."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from math import inf, isfinite, pi

import numpy as np

from gearlash.system import Clearance, ContactRule, System, derivative, padded
from gearlash.system.harmonics import harmonics

from ._cells import EDGE, FORCED, OFFSET, spectral_radius
from ._tables import FREE, MINUS, PLUS, Array

Sides = tuple[int, ...]
MOST_ENUMERATED = 3  # up to so many clearances, the fastest rate is looked for in every region
WORST_CONDITION = 3.0  # condition number of the directions h/|h| above which no centres are used
CACHED_ANSWERS = 64  # by system: building its propagators asks for each of them several times
_rates: dict[tuple[object, ...], float] = {}
RATE_PER_CELL = 1.85  # (spectral radius + highest harmonic) × cell duration aimed at: degree 23 then suffices


def code_of(sides: Sides) -> int:
    return sum(side * 3**c for c, side in enumerate(sides))


def sides_of(code: int, count: int) -> Sides:
    return tuple(code // 3**c % 3 for c in range(count))


@lru_cache(maxsize=CACHED_ANSWERS)
def twin(system: System, code: int) -> int:
    """A region with the same homogeneous part: side + in place of side -, where both are alike."""
    sides = [
        PLUS if side == MINUS and _alike(clearance) else side
        for side, clearance in zip(sides_of(code, len(system.clearances)), system.clearances, strict=True)
    ]
    return code_of(tuple(sides))


def _alike(clearance: Clearance) -> bool:
    plus, minus = clearance.stiffness_plus, clearance.stiffness_minus
    return np.array_equal(plus, minus) and len(set(clearance.dampings)) == 1


@lru_cache(maxsize=CACHED_ANSWERS)
def extreme_regions(system: System) -> tuple[Sides, ...]:
    """Regions that decide the grid: all clearances free, all closed on one side, and on the other where that
    is another system. Sides that do not act are never closed."""
    found = []
    for side in (FREE, PLUS, MINUS):
        sides = tuple(
            side if side == FREE or c.stops(1 if side == PLUS else -1) else FREE for c in system.clearances
        )
        if side != MINUS or twin(system, code_of(sides)) == code_of(sides):
            found.append(sides)
    return tuple(dict.fromkeys(found))


def has_width(system: System, sides: Sides) -> bool:
    """Whether a motion can stay in a region: not between two sides that lie at one place."""
    return not all(
        side == FREE and c.stops(1) and c.stops(-1) and c.gap_plus + c.gap_minus == 0.0
        for side, c in zip(sides, system.clearances, strict=True)
    )


def units_of(system: System) -> Array:
    """(units, 3) int: kind, clearance or state, Fourier slot of every unit input of any region."""
    count = len(system.clearances)
    closed = [_dampings(system, (side,) * count) for side in (FREE, PLUS, MINUS)]  # any forcing is in one
    forcings = [_forcing(system, dampings) for dampings in dict.fromkeys(closed)]
    forced = np.logical_or.reduce([one != 0.0 for one in forcings]).nonzero()
    edges = np.arange(count), np.zeros(count)
    shifted = [
        (np.full(len(slots), c), slots)
        for c, slots in enumerate(clearance.offset.nonzero()[0] for clearance in system.clearances)
    ]
    parts = (EDGE, edges), (FORCED, forced), *((OFFSET, each) for each in shifted)
    return np.concatenate([_of_kind(kind, *each) for kind, each in parts])


def _of_kind(kind: int, index: Array, slot: Array) -> Array:
    """Rows of `units_of`."""
    found = np.empty((len(index), 3), dtype=np.int64)
    found[:, 0], found[:, 1], found[:, 2] = kind, index, slot
    return found


@lru_cache(maxsize=CACHED_ANSWERS)
def _dampings(system: System, sides: Sides) -> tuple[float, ...]:
    """ζ of every clearance as it acts in a region: all that matrix and forcing know of the sides."""
    found = []
    for clearance, side in zip(system.clearances, sides, strict=True):
        acting = clearance.dampings[1 if side == MINUS else 0]
        found.append(acting if clearance.contact is ContactRule.ALWAYS or side != FREE else 0.0)
    return tuple(found)


def matrix_of(system: System, sides: Sides) -> Array:
    """M with the contact damping of a region in it."""
    return _matrix(system, _dampings(system, sides))


@lru_cache(maxsize=CACHED_ANSWERS)
def _matrix(system: System, dampings: tuple[float, ...]) -> Array:
    matrix = system.matrix.astype(np.float64)
    for clearance, damping in zip(system.clearances, dampings, strict=True):
        if damping != 0.0:
            matrix = matrix + damping * np.outer(clearance.g, clearance.h @ system.matrix)
    matrix.setflags(write=False)
    return matrix


def forcing_of(system: System, sides: Sides) -> Array:
    """b(θ) + Σ g ζ (h·b - e'), the forcing that goes with `matrix_of`."""
    return _forcing(system, _dampings(system, sides))


@lru_cache(maxsize=CACHED_ANSWERS)
def _forcing(system: System, dampings: tuple[float, ...]) -> Array:
    count = max(harmonics(system.forcing), *(harmonics(c.offset) for c in system.clearances))
    base = padded(system.forcing, count)
    forcing = base.copy()
    for clearance, damping in zip(system.clearances, dampings, strict=True):
        if damping != 0.0:
            rate = system.omega / system.cycles * padded(derivative(clearance.offset), count)
            forcing = forcing + damping * np.outer(clearance.g, clearance.h @ base - rate)
    forcing.setflags(write=False)
    return forcing


def centres_of(system: System) -> Array:
    """(clearances, n): states with h_j·c_k = 1 for j = k, else 0; all zero where gaps read nearly the same:
    centres would be far away then, and digits lost to them."""
    readers = np.array([c.h for c in system.clearances], dtype=np.float64)
    if len(readers) == 1:
        return readers / (readers @ readers.T)
    directions = readers / np.linalg.norm(readers, axis=1)[:, None]
    if np.linalg.cond(directions) > WORST_CONDITION:
        return np.zeros_like(readers)
    return np.ascontiguousarray(np.linalg.pinv(readers).T)


def edges_of(system: System, sides: Sides) -> Array:
    """(clearances,): +D⁺, -D⁻ or 0, from where the force of each clearance is counted in a region."""
    places = {PLUS: 1.0, FREE: 0.0, MINUS: -1.0}
    return np.array(
        [
            places[side] * (c.gap_plus if side == PLUS else c.gap_minus)
            for c, side in zip(system.clearances, sides, strict=True)
        ]
    )


def first_guess(system: System) -> float:
    """Cells from the fastest rate that occurs in any region; infinite where that is beyond numbers."""
    # a modulated stiffness moves the motion's rates by its harmonics: the two add up; a forcing does not
    own = system.period * _fastest(system) + 2 * pi * highest_moved(system)
    cells = max(own, 2 * pi * highest_turn(system)) / RATE_PER_CELL
    return max(4.0, np.ceil(cells)) if isfinite(cells) else inf


def _fastest(system: System) -> float:
    """`fastest_of`, kept by what it depends on: along a speed, a load or a gap that stays."""
    key = system.matrix.tobytes(), *map(_stiff, system.clearances)
    found = _rates.get(key)
    if found is None:
        if len(_rates) >= CACHED_ANSWERS:
            _rates.clear()
        found = _rates[key] = fastest_of(system)
    return found


def _stiff(clearance: Clearance) -> tuple[object, ...]:
    arrays = clearance.h, clearance.g, clearance.stiffness_plus, clearance.stiffness_minus
    return clearance.contact, clearance.dampings, *(array.tobytes() for array in arrays)


def fastest_of(system: System, regions: Iterable[Sides] = ()) -> float:
    """The fastest rate that occurs in any of these regions (else in all that matter: of many clearances with
    all contacts closed, or open), stiffness at its extremes."""
    fastest, count = 0.0, len(system.clearances)
    every = [sides_of(code, count) for code in range(3**count)] if 1 < count <= MOST_ENUMERATED else []
    for sides in regions or every or extreme_regions(system):
        closed = any(side != FREE for side in sides)
        for swing in (-1.0, 1.0) if closed else (0.0,):
            rate = spectral_radius(_at_extreme(system, sides, swing), 6)
            fastest = max(fastest, rate if isfinite(rate) else inf)
    return fastest


def highest_moved(system: System) -> int:
    """The highest harmonic of a stiffness."""
    return max(_highest(s) for c in system.clearances for s in (c.stiffness_plus, c.stiffness_minus))


def highest_turn(system: System) -> int:
    """The highest harmonic of a forcing or an offset."""
    return max(_highest(s) for s in (system.forcing, *(c.offset for c in system.clearances)))


def _at_extreme(system: System, sides: Sides, swing: float) -> Array:
    """The matrix of a region with its contacts' stiffness at the mean and ``swing`` times what is around
    it."""
    matrix = matrix_of(system, sides).copy()
    for clearance, side in zip(system.clearances, sides, strict=True):
        if side != FREE:
            series = clearance.stiffness_plus if side == PLUS else clearance.stiffness_minus
            stiffness = float(series[0]) + swing * float(np.abs(series[1:]).sum())
            matrix += stiffness * np.outer(clearance.g, clearance.h)
    return matrix


def _highest(series: Array) -> int:
    """The highest harmonic that is there (last axis: coefficients)."""
    return (int(series.nonzero()[-1].max(initial=0)) + 1) // 2
