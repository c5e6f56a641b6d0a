"""Cell propagators of one system, ready for marching."""

from __future__ import annotations

import threading
from dataclasses import dataclass, field
from functools import cached_property
from itertools import product
from math import ceil, pi

import numpy as np

from gearlash.system import Clearance, ContactRule, GearlashError, System, derivative, padded
from gearlash.system.harmonics import harmonics

from ._cells import EDGE, FORCED, OFFSET, assemble, laps, respond, spectral_radius, stiffness_series
from ._surfaces import NO_STOP
from ._tables import (
    ALWAYS,
    CHECK,
    FREE,
    IN_CONTACT,
    MINUS,
    NO_TENSION,
    PLUS,
    TERMS,
    Array,
    Plan,
    Shape,
    constants,
    lay_out,
)

TRUNCATION = 1e-15  # bound on the Taylor remainder of every unit column of every cell map
LATER = 1e-14  # the same for regions that are met only later, on the grid of the first ones
STEP = 1.1  # (spectral radius + highest harmonic) × cell duration aimed at: degree 18 then suffices
MOST_CELLS = 200_000
MOST_BYTES = 3_000_000_000  # of the tables of one region
MOST_CLEARANCES = 8  # 3^8 regions are numbered
RULES = {ContactRule.ALWAYS: ALWAYS, ContactRule.IN_CONTACT: IN_CONTACT, ContactRule.NO_TENSION: NO_TENSION}
Sides = tuple[int, ...]


@dataclass
class Tables:
    """What kernels read: replaced as a whole when a region is added, never changed."""

    memory: Array
    slot_of: Array  # (3^clearances) int: slot of each region, or -1


@dataclass(frozen=True, eq=False)
class Propagators:
    """The exact maps of one system over the cells of its base period, region by region as they are met.

    ``key`` names everything that the homogeneous part depends on."""

    system: System
    shape: Shape
    rules: Array
    units: Array
    centres: Array
    key: tuple
    store: dict[str, Tables]
    responses: dict[int, tuple[Array, Array, float, float]]
    lock: threading.Lock = field(default_factory=threading.Lock)

    @property
    def tables(self) -> Tables:
        return self.store["now"]

    @property
    def cells(self) -> int:
        """Cells in one base period."""
        return self.shape.cells

    @property
    def cell_duration(self) -> float:
        """In τ."""
        return self.system.period / self.shape.cells

    @property
    def cells_per_cycle(self) -> float:
        return self.cells / self.system.cycles

    @cached_property
    def trace(self) -> float | None:
        """Trace of the field where it is the same in all regions (stiffness does not enter it, because h·g = 0,
        and neither does damping that acts always); None where contact damping comes and goes."""
        regions = {float(np.trace(_matrix(self.system, sides))) for sides in _extreme(self.system)}
        return max(regions) if max(regions) - min(regions) <= 1e-13 * (1.0 + abs(max(regions))) else None

    def build(self, code: int) -> None:
        """Adds the tables of the region with this number. Raises `GearlashError` where the grid of cells does
        not carry it."""
        with self.lock:
            if self.tables.slot_of[code] < 0:
                self.store["now"] = _with_region(self, code, LATER)


def propagators(system: System, reuse: Propagators | None = None) -> Propagators:
    """Cell maps of ``system`` with a Taylor remainder of at most 1e-15 per unit column, proved by a majorant.

    ``reuse``: propagators of another member of the family; where frequency, stiffness and damping are the
    same, only the forced parts are summed anew. Raises `GearlashError` for a system that would need too many
    cells or regions."""
    if not 1 <= len(system.clearances) <= MOST_CLEARANCES:
        raise GearlashError(
            f"{len(system.clearances)} clearances: this engine takes 1 to {MOST_CLEARANCES} of them"
        )
    units = _units(system)
    key = _key(system, units)
    if reuse is not None and reuse.key == key:
        return _with_amplitudes(system, reuse)
    cells = _first_guess(system)
    while cells <= MOST_CELLS:
        found = _on_grid(system, units, key, cells)
        if found is not None:
            return found
        cells = ceil(1.2 * cells)
    raise GearlashError(
        f"more than {MOST_CELLS} cells a period would be needed: the frequency {system.omega:g} is too far "
        "below the fastest natural frequency"
    )


def _on_grid(system: System, units: Array, key: tuple, cells: int) -> Propagators | None:
    """Propagators with this many cells, or None where the remainder is above `TRUNCATION`."""
    count = max(
        harmonics(s)
        for s in (
            system.forcing,
            *(s for c in system.clearances for s in (c.offset, c.stiffness_plus, c.stiffness_minus)),
        )
    )
    shape = lay_out(Plan(system.size, len(system.clearances), cells, count))
    if 8 * shape.slot > MOST_BYTES:
        raise GearlashError(
            f"{cells} cells of {system.size} states would need {8 * shape.slot / 1e9:.1f} GB: the frequency "
            f"{system.omega:g} is too far below the fastest natural frequency"
        )
    memory = np.zeros(shape.slots)
    constants(shape, memory)
    _write_system(system, shape, memory)
    stiffness_series(shape, memory)
    memory.setflags(write=False)
    rules = np.array([RULES[c.contact] for c in system.clearances], dtype=np.int64)
    nothing = Tables(memory, np.full(3 ** len(rules), -1, dtype=np.int64))
    found = Propagators(system, shape, rules, units, _centres(system), key, {"now": nothing}, {})
    for sides in _extreme(system):
        tables = _with_region(found, _code(sides), TRUNCATION)
        if tables is None:
            return None
        found.store["now"] = tables
    return found


def _with_region(props: Propagators, code: int, bound: float) -> Tables:
    """The tables with one region more; None where its remainder is above the bound of the first regions."""
    system, shape = props.system, props.shape
    sides, twin = _sides(code, len(system.clearances)), _twin(system, code)
    old = props.tables
    at = len(old.memory)
    memory = np.empty(at + shape.slot)
    memory[:at] = old.memory
    slot = (at - shape.slots) // shape.slot
    if twin != code and old.slot_of[twin] >= 0:
        place = shape.slots + int(old.slot_of[twin]) * shape.slot
        memory[at:] = old.memory[place : place + shape.slot]
        props.responses[code] = props.responses[twin]
    else:
        memory[at:] = 0.0
        cells, count = shape.cells, shape.clearances
        ends = np.zeros((cells, len(props.units), shape.n))
        gaps = np.zeros((cells, count, len(props.units), TERMS))
        matrix = _matrix(system, sides)
        readers = np.array([c.h for c in system.clearances], dtype=np.float64)
        actors = np.array([c.g for c in system.clearances], dtype=np.float64)
        tails = respond(
            shape, memory, at, np.ascontiguousarray(matrix), readers, actors, props.centres,
            np.array(sides, dtype=np.int64), props.units, ends, gaps,
        )  # fmt: skip
        if not tails[0] <= bound:
            if bound == TRUNCATION:
                return None  # pyright: ignore[reportReturnType]
            raise GearlashError(
                f"the Taylor remainder of a region is {tails[0]:.1e}, more than {bound:.0e}: the sides of the "
                "clearances are too different for one grid of cells"
            )
        props.responses[code] = (ends, gaps, *tails)
        _write_region(system, shape, memory, at, sides, matrix)
    _assemble(system, shape, props, memory, at, code, everything=True)
    slot_of = old.slot_of.copy()
    slot_of[code] = slot
    memory.setflags(write=False)
    return Tables(memory, slot_of)


def _with_amplitudes(system: System, reuse: Propagators) -> Propagators:
    """The same homogeneous tables under other loads, errors and gaps."""
    tables, shape = reuse.tables, reuse.shape
    memory = tables.memory.copy()
    _write_system(system, shape, memory)
    found = Propagators(
        system,
        shape,
        reuse.rules,
        reuse.units,
        reuse.centres,
        reuse.key,
        {"now": tables},
        dict(reuse.responses),
    )
    for code in map(int, np.flatnonzero(tables.slot_of >= 0)):
        at = shape.slots + int(tables.slot_of[code]) * shape.slot
        _assemble(system, shape, found, memory, at, code, everything=False)
    memory.setflags(write=False)
    found.store["now"] = Tables(memory, tables.slot_of)
    return found


def _assemble(
    system: System, shape: Shape, props: Propagators, memory: Array, at: int, code: int, *, everything: bool
) -> None:
    """Constant columns of a region, and what is proved with them."""
    sides = _sides(code, shape.clearances)
    ends, gaps, tail, derived = props.responses[code]
    edges = _edges(system, sides)
    means = np.array([clearance.offset[0] for clearance in system.clearances])
    centres = props.centres
    centre = (edges + means) @ centres
    forcing = _forcing(system, sides)
    amplitudes = np.array(
        [
            edges[index] if kind == EDGE
            else system.clearances[index].offset[slot] if kind == OFFSET
            else forcing[index, slot]
            for kind, index, slot in props.units
        ],
        dtype=np.float64,
    )  # fmt: skip
    width = 2 * shape.harmonics + 1
    about = padded(forcing, shape.harmonics)
    about[:, 0] += _matrix(system, sides) @ centre
    memory[at + shape.forcing : at + shape.forcing + shape.n * width] = about.ravel()
    memory[at + shape.centre + 1 : at + shape.centre + 1 + shape.n] = centre
    memory[at + shape.lag : at + shape.lag + shape.clearances] = 0.0 if centres.any() else -(edges + means)
    for c, clearance in enumerate(system.clearances):
        size = float(np.abs(clearance.h).sum())
        total = float(np.abs(amplitudes).sum())
        # the remainder of an offset's own series is below that of the state it would force
        memory[at + shape.tail + 4 * c : at + shape.tail + 4 * c + 4] = (
            size * tail, (size + 1.0) * tail * total, size * derived, (size + 1.0) * derived * total,
        )  # fmt: skip
    assemble(
        shape, memory, at, amplitudes, ends, gaps, np.array(sides, dtype=np.int64), props.rules,
        _TO_CHECK.copy(), everything,
    )  # fmt: skip
    laps(shape, memory, at, np.array(sides, dtype=np.int64))


def _to_check() -> Array:
    from math import comb

    table = np.zeros((CHECK + 1, CHECK + 1))
    for k in range(CHECK + 1):
        for i in range(k, CHECK + 1):
            table[k, i] = comb(i, k) / comb(CHECK, k)
    return table.ravel()


_TO_CHECK = _to_check()


def _write_system(system: System, shape: Shape, memory: Array) -> None:
    """What is the same in all regions: scalars, gaps, how gaps are read, stiffness."""
    rate, width = system.omega / system.cycles, 2 * shape.harmonics + 1
    memory[shape.scalars : shape.scalars + 3] = rate, system.period / shape.cells, 2 * pi / shape.cells
    for c, clearance in enumerate(system.clearances):
        plus = clearance.gap_plus if clearance.stops(1) else NO_STOP
        minus = clearance.gap_minus if clearance.stops(-1) else NO_STOP
        at = shape.gaps + 4 * c
        memory[at : at + 4] = plus, minus, *clearance.dampings
        stops = [abs(gap) for gap in (plus, minus) if gap < NO_STOP]
        memory[shape.reach + c] = sum(stops) + float(np.abs(clearance.offset).sum())
        at = shape.reads + c * shape.p + 1
        memory[at : at + shape.n] = clearance.h
        at = shape.speed + c * shape.p + 1
        memory[at : at + shape.n] = clearance.h @ system.matrix
        drift = padded(clearance.h @ system.forcing, shape.harmonics)
        drift = drift - rate * padded(derivative(clearance.offset), shape.harmonics)
        for place, series in (
            (shape.offset + c * width, clearance.offset),
            (shape.drift + c * width, drift),
            (shape.stiffness + 2 * c * width, clearance.stiffness_plus),
            (shape.stiffness + (2 * c + 1) * width, clearance.stiffness_minus),
        ):
            memory[place : place + width] = padded(series, shape.harmonics)


def _write_region(system: System, shape: Shape, memory: Array, at: int, sides: Sides, matrix: Array) -> None:
    """The equations of one region, for expansions of the state."""
    columns = memory[at + shape.matrix : at + shape.matrix + (shape.n + shape.clearances) * shape.p]
    columns = columns.reshape(shape.n + shape.clearances, shape.p)
    columns[: shape.n, 1 : 1 + shape.n] = matrix.T
    for c, clearance in enumerate(system.clearances):
        columns[shape.n + c, 1 : 1 + shape.n] = clearance.g


def _code(sides: Sides) -> int:
    return sum(side * 3**c for c, side in enumerate(sides))


def _sides(code: int, count: int) -> Sides:
    return tuple(code // 3**c % 3 for c in range(count))


def _twin(system: System, code: int) -> int:
    """A region with the same homogeneous part: side + in place of side -, where both are alike."""
    sides = [
        PLUS if side == MINUS and _alike(clearance) else side
        for side, clearance in zip(_sides(code, len(system.clearances)), system.clearances, strict=True)
    ]
    return _code(tuple(sides))


def _alike(clearance: Clearance) -> bool:
    plus, minus = clearance.stiffness_plus, clearance.stiffness_minus
    return np.array_equal(plus, minus) and len(set(clearance.dampings)) == 1


def _extreme(system: System) -> list[Sides]:
    """Regions that decide the grid: all clearances free, all closed on one side, and on the other where that
    is another system. Sides without stiffness are never closed."""
    found = []
    for side in (FREE, PLUS, MINUS):
        sides = tuple(
            side if side == FREE or c.stops(1 if side == PLUS else -1) else FREE for c in system.clearances
        )
        if side != MINUS or _twin(system, _code(sides)) == _code(sides):
            found.append(sides)
    return list(dict.fromkeys(found))


def _units(system: System) -> Array:
    """(units, 3) int: kind, clearance or state, Fourier slot of every unit input of any region."""
    rows = sum(np.abs(_forcing(system, sides)) for sides in _closed(system))
    forced = [(FORCED, int(row), int(slot)) for row, slot in np.argwhere(rows != 0.0)]
    edges = [(EDGE, c, 0) for c in range(len(system.clearances))]
    shifted = [
        (OFFSET, c, int(slot))
        for c, clearance in enumerate(system.clearances)
        for slot in np.flatnonzero(clearance.offset)
    ]
    return np.array([*edges, *forced, *shifted], dtype=np.int64)


def _closed(system: System) -> list[Sides]:
    """Regions in which every forcing that occurs anywhere occurs."""
    count = len(system.clearances)
    return [(side,) * count for side in (FREE, PLUS, MINUS)]


def _key(system: System, units: Array) -> tuple:
    parts: list[object] = [system.omega, system.cycles, system.matrix.tobytes(), units.tobytes()]
    for c in system.clearances:
        parts += [c.dampings, c.contact, c.stops(1), c.stops(-1)]
        parts += [a.tobytes() for a in (c.h, c.g, c.stiffness_plus, c.stiffness_minus)]
    return (*parts, system.forcing.shape, *(len(c.offset) for c in system.clearances))


def _dampings(system: System, sides: Sides) -> list[float]:
    """ζ of every clearance as it acts in a region."""
    found = []
    for clearance, side in zip(system.clearances, sides, strict=True):
        acting = clearance.dampings[1 if side == MINUS else 0]
        found.append(acting if clearance.contact is ContactRule.ALWAYS or side != FREE else 0.0)
    return found


def _matrix(system: System, sides: Sides) -> Array:
    """M with the contact damping of a region in it."""
    matrix = system.matrix.astype(np.float64)
    for clearance, damping in zip(system.clearances, _dampings(system, sides), strict=True):
        matrix = matrix + damping * np.outer(clearance.g, clearance.h @ system.matrix)
    return matrix


def _forcing(system: System, sides: Sides) -> Array:
    """b(θ) + Σ g ζ (h·b - e'), the forcing that goes with `_matrix`."""
    count = max(harmonics(system.forcing), *(harmonics(c.offset) for c in system.clearances))
    base = padded(system.forcing, count)
    forcing = base.copy()
    for clearance, damping in zip(system.clearances, _dampings(system, sides), strict=True):
        if damping != 0.0:
            rate = system.omega / system.cycles * padded(derivative(clearance.offset), count)
            forcing = forcing + damping * np.outer(clearance.g, clearance.h @ base - rate)
    return forcing


def _centres(system: System) -> Array:
    """(clearances, n): states with h_j·c_k = 1 for j = k, else 0; all zero where gaps depend on each other."""
    readers = np.array([c.h for c in system.clearances], dtype=np.float64)
    if len(readers) == 1:
        return readers / (readers @ readers.T)
    if np.linalg.matrix_rank(readers) < len(readers):
        return np.zeros_like(readers)
    return np.ascontiguousarray(np.linalg.pinv(readers).T)


def _edges(system: System, sides: Sides) -> Array:
    places = {PLUS: 1.0, FREE: 0.0, MINUS: -1.0}
    return np.array(
        [
            places[side] * (c.gap_plus if side == PLUS else c.gap_minus)
            for c, side in zip(system.clearances, sides, strict=True)
        ]
    )


def _first_guess(system: System) -> int:
    """Cells from the fastest rate that occurs with all contacts closed at their extremes, or open."""
    fastest = 0.0
    for sides, lowest in product(_extreme(system), (False, True)):
        closed = _matrix(system, sides)
        for clearance, side in zip(system.clearances, sides, strict=True):
            if side != FREE:
                series = clearance.stiffness_plus if side == PLUS else clearance.stiffness_minus
                swing = np.abs(series[1:]).sum()
                closed = closed + (series[0] - swing if lowest else series[0] + swing) * np.outer(
                    clearance.g, clearance.h
                )
        fastest = max(fastest, spectral_radius(np.ascontiguousarray(closed), 6))
    series = [s for c in system.clearances for s in (c.stiffness_plus, c.stiffness_minus, c.offset)]
    highest = max(harmonics(s) for s in (*series, system.forcing))
    # a modulated stiffness moves the motion's rates by its harmonics: the two add up
    return max(4, ceil((system.period * fastest + 2 * pi * highest) / STEP))
