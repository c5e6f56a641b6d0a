"""Cell propagators of one system, ready for marching."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import ceil, pi

import numpy as np

from gearlash.system import Clearance, ContactRule, GearlashError, System, derivative
from gearlash.system.harmonics import harmonics

from ._blocks import padded
from ._cells import EDGE, OFFSET, combine, spectral_radius, unit_responses
from ._roots import taylor_to_bernstein
from ._tables import CHECK, FREE, MINUS, ORDER, PLUS, Array, Tables

TRUNCATION = 1e-15  # bound on the Taylor remainder of every unit column of every cell map
STEP = 1.1  # (spectral radius + highest harmonic) × cell duration aimed at: ORDER = 18 then suffices
MOST_CELLS = 200_000


@dataclass(frozen=True, eq=False)
class Propagators:
    """The exact maps of one system over the cells of its base period.

    `tables` is what kernels read. `key` names everything that the homogeneous part depends on.
    """

    system: System
    tables: Tables
    key: tuple
    responses: tuple

    @cached_property
    def cells(self) -> int:
        """Cells in one base period."""
        return self.tables.maps.shape[1]

    @property
    def trace(self) -> float:
        """Trace of the field; stiffness does not enter it, because h·g = 0."""
        return float(np.trace(_matrix(self.system, self.system.clearances[0])))

    @property
    def cells_per_cycle(self) -> float:
        return self.cells / self.system.cycles


def propagators(system: System, reuse: Propagators | None = None) -> Propagators:
    """Cell maps of ``system`` with a Taylor remainder of at most 1e-15 per unit column, proved by a majorant.

    ``reuse``: propagators of another member of the family; where frequency, stiffness and damping are the
    same, only the forced parts are summed anew. Raises `GearlashError` for what this engine does not take
    (yet)."""
    clearance = _supported(system)
    units, key = _units(system), _key(system)
    if reuse is not None and reuse.key == key:
        responses = reuse.responses
    else:
        responses = _responses(system, clearance, units)
    return Propagators(system, _tables(system, clearance, units, responses), key, responses)


def _supported(system: System) -> Clearance:
    if len(system.clearances) != 1:
        raise GearlashError(f"{len(system.clearances)} clearances: this engine takes exactly one so far")
    clearance = system.clearances[0]
    if clearance.contact is not ContactRule.ALWAYS:
        raise GearlashError(f"contact rule {clearance.contact.value!r}: this engine takes 'always' so far")
    return clearance


def _units(system: System) -> Array:
    """(units, 2) int: kind and Fourier slot of every unit input of the system, the gap's edge first."""
    clearance = system.clearances[0]
    forcing, offset = _folded_forcing(system, clearance), clearance.offset
    forced = [(int(row), int(slot)) for row, slot in np.argwhere(forcing != 0.0)]
    shifted = [(OFFSET, int(slot)) for slot in np.flatnonzero(offset)]
    return np.array([(EDGE, 0), *forced, *shifted], dtype=np.int64)


def _key(system: System) -> tuple:
    c = system.clearances[0]
    arrays = (system.matrix, c.h, c.g, c.stiffness_plus, c.stiffness_minus, _units(system))
    return (system.omega, system.cycles, c.damping, *(a.tobytes() for a in arrays))


def _matrix(system: System, clearance: Clearance) -> Array:
    """M with the damping of the contact in it, as it acts under the rule `always`."""
    return system.matrix + clearance.damping * np.outer(clearance.g, clearance.h @ system.matrix)


def _folded_forcing(system: System, clearance: Clearance) -> Array:
    """b(θ) + g ζ (h·b - e'), the forcing that goes with `_matrix`."""
    count = max(harmonics(system.forcing), harmonics(clearance.offset))
    forcing = np.zeros((system.size, 2 * count + 1))
    forcing[:, : system.forcing.shape[1]] = system.forcing
    if clearance.damping != 0.0:
        push = clearance.h @ forcing
        rate = system.omega / system.cycles * derivative(clearance.offset)
        push[: len(rate)] -= rate
        forcing = forcing + clearance.damping * np.outer(clearance.g, push)
    return forcing


def _stiffness(clearance: Clearance) -> tuple[Array, Array, Array]:
    zero = np.zeros_like(clearance.stiffness_plus)
    return clearance.stiffness_plus, zero, clearance.stiffness_minus


def _responses(system: System, clearance: Clearance, units: Array) -> tuple:
    """Unit responses per region, on the coarsest grid that keeps the remainder within bounds."""
    matrix = _matrix(system, clearance)
    cells = _first_guess(system, clearance, matrix)
    while cells <= MOST_CELLS:
        found = [
            _unit_responses(system, clearance, matrix, series, units, cells)
            for series in _different(_stiffness(clearance))
        ]
        if all(r[3][0].max() <= TRUNCATION for r in found):
            return (found[0], found[1], found[2] if len(found) > 2 else found[0])
        cells = ceil(1.2 * cells)
    raise GearlashError(
        f"more than {MOST_CELLS} cells a period would be needed: the frequency {system.omega:g} is too far "
        "below the fastest natural frequency"
    )


def _different(stiffness: tuple[Array, Array, Array]) -> list[Array]:
    plus, free, minus = stiffness
    return [plus, free] if np.array_equal(plus, minus) else [plus, free, minus]


def _first_guess(system: System, clearance: Clearance, matrix: Array) -> int:
    fastest = 0.0
    for series in _stiffness(clearance):
        for extreme in (series[0] + np.abs(series[1:]).sum(), series[0] - np.abs(series[1:]).sum()):
            closed = matrix + extreme * np.outer(clearance.g, clearance.h)
            fastest = max(fastest, spectral_radius(np.ascontiguousarray(closed), 6))
    highest = max(harmonics(s) for s in (*_stiffness(clearance), system.forcing, clearance.offset))
    # a modulated stiffness moves the motion's rates by its harmonics: the two add up
    return max(4, ceil((system.period * fastest + 2 * pi * highest) / STEP))


def _unit_responses(
    system: System, clearance: Clearance, matrix: Array, series: Array, units: Array, cells: int
) -> tuple:
    n, count = system.size, len(units)
    p = padded(n)
    maps, forced = np.empty((cells, n, p)), np.empty((cells, count, p))
    gap, tails = np.empty((cells, n + count, ORDER + 1)), np.empty((2, n + count))
    rate = system.omega / system.cycles
    reads = np.flatnonzero(clearance.h)
    unit_responses(
        _floats(_padded(matrix.T)[None]),
        _floats(_padded(clearance.g)),
        reads,
        _floats(clearance.h[reads]),
        _floats(series),
        units,
        rate,
        system.period / cells,
        maps,
        forced,
        gap,
        tails,
    )
    return maps, forced, gap, tails


def _tables(system: System, clearance: Clearance, units: Array, responses: tuple) -> Tables:
    n, cells = system.size, responses[0][0].shape[0]
    forcing = _folded_forcing(system, clearance)
    rows = np.flatnonzero(forcing.any(axis=1)).astype(np.int64)
    edge = np.array([clearance.gap_plus, 0.0, -clearance.gap_minus], dtype=np.float64)
    shift, check = np.empty((3, cells, padded(n))), np.empty((3, cells, n + 1, CHECK + 1))
    slack, bend, tail = np.empty((3, cells, n + 1)), np.empty((3, cells, n + 1)), np.empty((3, n + 1))
    to_check = taylor_to_bernstein(CHECK, CHECK + 1)
    for region in (PLUS, FREE, MINUS):
        _, forced, gap, tails = responses[region]
        amplitudes = _amplitudes(units, forcing, clearance.offset, edge[region])
        combine(
            amplitudes, forced, gap, tails, to_check,
            shift[region], check[region], slack[region], bend[region], tail[region],
        )  # fmt: skip
    matrix = _matrix(system, clearance)
    reads = np.flatnonzero(clearance.h)
    rate = system.omega / system.cycles
    tables = Tables(
        scalars=np.array([rate, system.period / cells, 2 * pi / cells]),
        matrix=np.stack([_padded(matrix.T)] * 3),
        gain=_padded(clearance.g),
        reads=reads,
        read=clearance.h[reads],
        edge=edge,
        gaps=np.array([clearance.gap_plus, clearance.gap_minus], dtype=np.float64),
        stiffness=_stacked(_stiffness(clearance)),
        forcing=forcing[rows],
        rows=rows,
        offset=clearance.offset,
        to_bernstein=np.stack([taylor_to_bernstein(d, ORDER + 1) for d in (ORDER, ORDER - 1)]),
        maps=np.stack([responses[region][0] for region in (PLUS, FREE, MINUS)]),
        shift=shift,
        check=check,
        slack=slack,
        bend=bend,
        tail=tail,
    )
    return Tables(*(_read_only(a) for a in tables))


def _padded(array: Array) -> Array:
    """Zeros behind the last axis up to whole blocks."""
    missing = padded(array.shape[-1]) - array.shape[-1]
    return np.pad(array, [(0, 0)] * (array.ndim - 1) + [(0, missing)])


def _floats(array: Array) -> Array:
    return np.array(array, dtype=np.float64, order="C")


def _amplitudes(units: Array, forcing: Array, offset: Array, edge: float) -> Array:
    size = [
        edge if kind == EDGE else offset[slot] if kind == OFFSET else forcing[kind, slot]
        for kind, slot in units
    ]
    return np.array(size, dtype=np.float64)


def _stacked(series: tuple[Array, ...]) -> Array:
    count = max(len(s) for s in series)
    return np.stack([np.pad(s, (0, count - len(s))) for s in series])


def _read_only(array: Array) -> Array:
    out = np.ascontiguousarray(array, dtype=np.int64 if array.dtype.kind == "i" else np.float64)
    if out.base is not None or out.flags.writeable:
        out = out.copy()
    out.setflags(write=False)
    return out
