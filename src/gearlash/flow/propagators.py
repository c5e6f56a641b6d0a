"""Cell propagators of one system, ready for marching."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from math import ceil, exp, factorial, hypot, pi
from typing import Any, ClassVar

import numpy as np

from gearlash.system import ContactRule, GearlashError, Record, System, derivative, given, padded
from gearlash.system.harmonics import harmonics
from gearlash.system.piecewise import MOST_CLEARANCES

from ._assemble import assemble, laps
from ._cells import EDGE, OFFSET, respond, stiffness_series
from ._surfaces import NO_STOP
from ._tables import (
    ALWAYS,
    IN_CONTACT,
    NO_TENSION,
    ORDER,
    TERMS,
    Array,
    Shape,
    aligned,
    constants,
    sizes_of,
)
from .budget import (
    allowed,
    check_cells,
    check_memory,
    laid_out,
    of_region,
    regions_likely,
    regions_possible,
)
from .regions import (
    Sides,
    centres_of,
    code_of,
    edges_of,
    extreme_regions,
    first_guess,
    forcing_of,
    has_width,
    matrix_of,
    sides_of,
    twin,
    units_of,
)

TRUNCATION = 1e-15  # bound on the Taylor remainder of every unit column of every cell map
REFINEMENT, GENTLE_TRIES = 1.1, 10  # factor to the next grid, for so many tries
LATE_REFINEMENT = 1.5  # the same after them
LATER_TRUNCATION = 1e-14  # the same for regions that are met only later, on the grid of the first ones
NUMBERS_PER_CALL = 4_000_000  # numbers of tables that one call writes: a tenth of a second
RULES = {ContactRule.ALWAYS: ALWAYS, ContactRule.IN_CONTACT: IN_CONTACT, ContactRule.NO_TENSION: NO_TENSION}


@dataclass
class Tables:
    """What kernels read: replaced as a whole when a region is added. What was there is never changed; a new
    region is written behind it. There is room for as many as the budget allows (pages of it that nobody has
    written to take no memory); where more was allowed later, everything is copied."""

    room: Array
    used: int
    slot_of: Array  # (3^clearances) int: slot of each region, or -1

    @cached_property
    def memory(self) -> Array:
        """The room, to be read."""
        memory = self.room.view()
        memory.setflags(write=False)
        return memory

    def with_space(self, more: int) -> Array:
        """The room, or a larger one with the same content, with space for so many numbers behind it."""
        if self.used + more <= len(self.room):
            return self.room
        (room,) = aligned(self.used + 2 * more)
        _copy(self.room[: self.used], room[: self.used])
        return room


@dataclass(frozen=True, eq=False, repr=False)
class Propagators(Record):
    """The exact maps of one system over the cells of its base period, made by `propagators`.

    Tables of a region of contact are built when a motion first comes there; what was built stays. Pickling
    and copying keep the system; in another process the tables are built again.

    Attributes
    ----------
    system : System
        What they belong to.
    shape : NamedTuple
        Sizes, and where in the tables what lies. It changes from version to version, as does all that
        follows here.
    rules : array (clearances,) of int
        Contact rules, as kernels have them.
    units : array (units, 3) of int
        Unit inputs: kind, clearance or state, Fourier slot.
    centres : array (clearances, n)
        States that put the gap of one clearance to 1 and those of the others to 0, or zeros.
    key : tuple
        Everything that the homogeneous part depends on.
    store : dict
        The tables of now.
    responses : dict
        By region: what its tables are summed from.
    lock : threading.Lock
        Held while a region is added.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> props = gl.propagators(family.system({"omega": 0.9}))
    >>> props.cells, round(props.cell_duration * props.cells, 6)
    (4, 6.981317)
    """

    _printed: ClassVar = ("system", "cells")

    system: System
    shape: Shape
    rules: Array
    units: Array
    centres: Array
    key: tuple
    store: dict[str, Tables]
    responses: dict[int, tuple[Array, Array, float, float]]
    lock: threading.Lock = field(default_factory=threading.Lock)

    def __reduce__(self) -> tuple[Any, ...]:
        return propagators, (self.system,)  # tables lie in memory as kernels want them: built again

    def __copy__(self) -> Propagators:
        return self  # nothing of it changes but what is added where it is met

    def __deepcopy__(self, memo: dict[int, Any]) -> Propagators:
        return self

    @property
    def tables(self) -> Tables:
        """What kernels read now."""
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
        """Cells in one mesh cycle; no whole number, perhaps, where a base period has several."""
        return self.cells / self.system.cycles

    @cached_property
    def trace(self) -> float | None:
        """Trace of the field's matrix where it is the same in all regions, else None.

        Stiffness does not enter it, because h·g = 0, and damping that acts always is the same everywhere;
        contact damping that comes and goes makes it another one."""
        regions = {float(np.trace(matrix_of(self.system, sides))) for sides in extreme_regions(self.system)}
        return max(regions) if max(regions) - min(regions) <= 1e-13 * (1.0 + abs(max(regions))) else None

    def build(self, code: int) -> None:
        """Add the tables of a region.

        Parameters
        ----------
        code : int
            Its number: Σ side·3^c, with side 0 for contact on side +, 1 for none, 2 for contact on side -.

        Raises
        ------
        GearlashError
            Where the grid of cells does not carry it, or it would take too much memory.
        """
        with self.lock:
            if self.tables.slot_of[code] >= 0:
                return
            check_memory(self.system, self.shape, 1 + len(self.responses), len(self.units))
            tables, old = None, self.tables
            try:
                tables = _with_regions(self, [code], LATER_TRUNCATION)
            finally:
                if tables is None:  # as it was: another region may come here
                    old.room[old.used : old.used + self.shape.slot] = 0.0
            if tables is None:
                raise GearlashError(
                    f"the Taylor remainder of a region is above {LATER_TRUNCATION:.0e}: the sides of the "
                    "clearances are too different for one grid of cells"
                )
            self.store["now"] = tables


def propagators(system: System, reuse: Propagators | None = None) -> Propagators:
    """Build the exact maps of a system over the cells of its base period.

    Every column of a map has a Taylor remainder of at most 1e-15, proved by a majorant. All functions of one
    system take these maps in place of the system, and need not build them again then.

    Parameters
    ----------
    system : System
        The system.
    reuse : Propagators, optional
        Those of another member of the family: where frequency, stiffness and damping are the same, only what
        load, offset and gap do is summed anew.

    Returns
    -------
    Propagators
        The maps, region by region as motions come to them.

    Raises
    ------
    GearlashError
        For a system that would need too many cells, too much memory, or has too many clearances.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> props = gl.propagators(family.system({"omega": 0.9}))
    >>> other = gl.propagators(family.system({"omega": 0.9, "load": 0.2}), reuse=props)
    >>> other.cells == props.cells
    True
    """
    given.instance("system", system, System, "a System, as from family.system()")
    if reuse is not None:
        given.instance("reuse", reuse, Propagators, "propagators of another member of the family")
    if not 1 <= len(system.clearances) <= MOST_CLEARANCES:
        raise GearlashError(
            f"{len(system.clearances)} clearances: this engine takes 1 to {MOST_CLEARANCES} of them"
        )
    units = units_of(system)
    key = _key(system, units)
    if reuse is not None and reuse.key == key:
        return _with_amplitudes(system, reuse)
    cells, tried = first_guess(system), 0
    while True:
        check_cells(system, cells)
        found = _on_grid(system, units, key, int(cells))
        if found is not None:
            return found
        cells, tried = ceil((REFINEMENT if tried < GENTLE_TRIES else LATE_REFINEMENT) * cells), tried + 1


def propagators_of(system: System | Propagators) -> Propagators:
    """The propagators of a system; they may be what is given."""
    if isinstance(system, Propagators):
        return system
    expected = "a System, as from family.system(), or its propagators"
    return propagators(given.instance("system", system, System, expected))


def _on_grid(system: System, units: Array, key: tuple, cells: int) -> Propagators | None:
    """Propagators with this many cells, or None where the remainder is above `TRUNCATION`."""
    shape = laid_out(system, cells)
    first = [code_of(sides) for sides in extreme_regions(system) if has_width(system, sides)]
    regions = max(len(first), regions_likely(system))
    check_memory(system, shape, regions, len(units))
    fitting = (allowed() - 8.0 * shape.slots) / of_region(shape, len(units))
    (room,) = aligned(shape.slots + regions_possible(system, fitting) * shape.slot)
    constants(shape, room)
    _write_system(system, shape, room)
    stiffness_series(sizes_of(shape), room)
    rules = np.array([RULES[c.contact] for c in system.clearances], dtype=np.int64)
    nothing = Tables(room, shape.slots, np.full(3 ** len(rules), -1, dtype=np.int64))
    found = Propagators(system, shape, rules, units, centres_of(system), key, {"now": nothing}, {})
    tables = _with_regions(found, first, TRUNCATION)
    if tables is None:
        return None
    found.store["now"] = tables
    return found


def _with_regions(props: Propagators, codes: list[int], bound: float) -> Tables | None:
    """The tables with more regions; None where the Taylor remainder of one is above the bound."""
    system, shape, old = props.system, props.shape, props.tables
    at, slot_of = old.used, old.slot_of.copy()
    memory = old.with_space(len(codes) * shape.slot)
    for code in codes:
        like = twin(system, code)
        if like != code and slot_of[like] >= 0:
            place = shape.slots + int(slot_of[like]) * shape.slot
            _copy(memory[place : place + shape.slot], memory[at : at + shape.slot])
            props.responses[code] = props.responses[like]
        else:
            responses = _responses(props, memory, at, sides_of(code, shape.clearances))
            if not responses[2] <= bound:
                return None
            props.responses[code] = responses
        _assemble(system, shape, props, memory, at, code, everything=True)
        slot_of[code] = (at - shape.slots) // shape.slot
        at += shape.slot
    return Tables(memory, at, slot_of)


def _responses(props: Propagators, memory: Array, at: int, sides: Sides) -> tuple[Array, Array, float, float]:
    """Writes the homogeneous tables of a region into its slot; returns the responses to unit inputs (at the
    ends of cells, in the gaps) and the Taylor remainders."""
    system, shape = props.system, props.shape
    ends = np.zeros((shape.cells, len(props.units), shape.n))
    gaps = np.zeros((shape.cells, shape.clearances, len(props.units), TERMS))
    matrix = matrix_of(system, sides).copy()
    readers = np.array([c.h for c in system.clearances], dtype=np.float64)
    actors = np.array([c.g for c in system.clearances], dtype=np.float64)
    last, read = np.zeros((2, shape.n)), np.zeros((2, shape.clearances, ORDER + 1))
    value = derived = 0.0
    for first, until in _calls(shape):
        value, derived = respond(
            sizes_of(shape), memory, at, matrix, readers, actors, props.centres,
            np.array(sides, dtype=np.int64), props.units, ends, gaps, first, until, last, read,
        )  # fmt: skip
    _write_region(system, shape, memory, at, matrix)
    return ends, gaps, value, derived


def _with_amplitudes(system: System, reuse: Propagators) -> Propagators:
    """The same homogeneous tables under other loads, errors and gaps."""
    tables, shape = reuse.tables, reuse.shape
    (memory,) = aligned(len(tables.room))
    _copy(tables.room[: tables.used], memory[: tables.used])
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
    found.store["now"] = Tables(memory, tables.used, tables.slot_of)
    return found


def _assemble(
    system: System, shape: Shape, props: Propagators, memory: Array, at: int, code: int, *, everything: bool
) -> None:
    """Constant columns of a region, and what is proved with them."""
    sides = sides_of(code, shape.clearances)
    ends, gaps, tail, derived = props.responses[code]
    edges = edges_of(system, sides)
    means = np.array([clearance.offset[0] for clearance in system.clearances])
    centres = props.centres
    centre = (edges + means) @ centres
    forcing = forcing_of(system, sides)
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
    about[:, 0] += matrix_of(system, sides) @ centre
    memory[at + shape.forcing : at + shape.forcing + shape.n * width] = about.ravel()
    memory[at + shape.centre + 1 : at + shape.centre + 1 + shape.n] = centre
    memory[at + shape.lag : at + shape.lag + shape.clearances] = 0.0 if centres.any() else -(edges + means)
    for c, clearance in enumerate(system.clearances):
        size = float(np.abs(clearance.h).sum())
        total = float(np.abs(amplitudes).sum())
        own, own_derived = left_out(clearance.offset, 2 * pi / shape.cells)
        memory[at + shape.tail + 4 * c : at + shape.tail + 4 * c + 4] = (
            size * tail, size * tail * total + own, size * derived, size * derived * total + own_derived,
        )  # fmt: skip
    for first, until in _calls(shape):
        assemble(
            sizes_of(shape), memory, at, amplitudes, ends, gaps, np.array(sides, dtype=np.int64), props.rules,
            everything, first, until,
        )  # fmt: skip
    laps(sizes_of(shape), memory, at, np.array(sides, dtype=np.int64))


def _calls(shape: Shape) -> Iterator[tuple[int, int]]:
    """The cells in pieces for one call of a kernel each: first, and first of the next."""
    piece = max(1, NUMBERS_PER_CALL * shape.cells // shape.slot)
    return ((i, min(i + piece, shape.cells)) for i in range(0, shape.cells, piece))


def _copy(old: Array, new: Array) -> None:
    """In pieces: gigabytes in new memory take seconds, in which Ctrl-C would not be answered."""
    for i in range(0, len(old), NUMBERS_PER_CALL):
        new[i : i + NUMBERS_PER_CALL] = old[i : i + NUMBERS_PER_CALL]


def left_out(series: Array, width: float) -> tuple[float, float]:
    """Bounds on what the Taylor series of a Fourier series over a phase ``width`` leaves out behind degree
    ORDER, and on its derivative in local time: Σ_{j>m} r^j/j! ≤ e^r r^(m+1)/(m+1)! for a harmonic that turns
    by r."""
    value = 0.0
    for n in range(1, harmonics(series) + 1):
        turn = n * width
        size = hypot(series[2 * n - 1], series[2 * n])
        value += size * exp(turn) * turn ** (ORDER + 1) / factorial(ORDER + 1)
    return value, (ORDER + 1) * value


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
        for side, series in enumerate((clearance.stiffness_plus, clearance.stiffness_minus)):
            memory[shape.lost + 2 * c + side] = left_out(series, 2 * pi / shape.cells)[0]


def _write_region(system: System, shape: Shape, memory: Array, at: int, matrix: Array) -> None:
    """The equations of one region, for expansions of the state."""
    columns = memory[at + shape.matrix : at + shape.matrix + (shape.n + shape.clearances) * shape.p]
    columns = columns.reshape(shape.n + shape.clearances, shape.p)
    columns[: shape.n, 1 : 1 + shape.n] = matrix.T
    for c, clearance in enumerate(system.clearances):
        columns[shape.n + c, 1 : 1 + shape.n] = clearance.g


def _key(system: System, units: Array) -> tuple:
    parts: list[object] = [system.omega, system.cycles, system.matrix.tobytes(), units.tobytes()]
    for c in system.clearances:
        parts += [c.dampings, c.contact, c.stops(1), c.stops(-1)]
        parts += [a.tobytes() for a in (c.h, c.g, c.stiffness_plus, c.stiffness_minus)]
    return (*parts, system.forcing.shape, *(len(c.offset) for c in system.clearances))
