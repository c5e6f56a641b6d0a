"""Cell propagators of one system, ready for marching."""

from __future__ import annotations

import threading
from dataclasses import dataclass, field
from functools import cached_property
from math import ceil, pi
from typing import Any, ClassVar

import numpy as np

from gearlash.system import ContactRule, GearlashError, Record, System, given, padded
from gearlash.system.piecewise import MOST_CLEARANCES

from ._assemble import assemble, laps
from ._cells import EDGE, OFFSET, stiffness_series
from ._tables import (
    ALWAYS,
    IN_CONTACT,
    NO_TENSION,
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
from .equations import left_out, write_system
from .regions import (
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
from .responses import each_alone, responses
from .tables import Tables, calls, copy_in_pieces

TRUNCATION = 1e-15  # bound on the Taylor remainder of every unit column of every cell map
REFINEMENT, GENTLE_TRIES = 1.1, 10  # factor to the next grid, for so many tries
LATE_REFINEMENT = 1.5  # the same after them
LATER_TRUNCATION = 1e-14  # the same for regions that are met only later, on the grid of the first ones

RULES = {ContactRule.ALWAYS: ALWAYS, ContactRule.IN_CONTACT: IN_CONTACT, ContactRule.NO_TENSION: NO_TENSION}


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
    # the closed ones first: where a grid is too coarse, it is for them, and no other need be tried
    first = [code_of(sides) for sides in reversed(extreme_regions(system)) if has_width(system, sides)]
    regions = max(len(first), regions_likely(system))
    check_memory(system, shape, regions, len(units))
    fitting = (allowed() - 8.0 * shape.slots) / of_region(shape, len(units))
    (room,) = aligned(shape.slots + regions_possible(system, fitting) * shape.slot)
    constants(shape, room)
    write_system(system, shape, room)
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
            copy_in_pieces(memory[place : place + shape.slot], memory[at : at + shape.slot])
            props.responses[code] = props.responses[like]
        else:
            inputs = each_alone(props.units, props.centres, shape)
            sides = sides_of(code, shape.clearances)
            found = responses(system, shape, memory, at, sides, inputs, bound)
            if not found.remainder <= bound:
                return None
            props.responses[code] = found
        _assemble(system, shape, props, memory, at, code, everything=True)
        slot_of[code] = (at - shape.slots) // shape.slot
        at += shape.slot
    return Tables(memory, at, slot_of)


def _with_amplitudes(system: System, reuse: Propagators) -> Propagators:
    """The same homogeneous tables under other loads, errors and gaps."""
    tables, shape = reuse.tables, reuse.shape
    (memory,) = aligned(len(tables.room))
    copy_in_pieces(tables.room[: tables.used], memory[: tables.used])
    write_system(system, shape, memory)
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
            for kind, index, slot in props.units.tolist()
        ],
        dtype=np.float64,
    )  # fmt: skip
    total = float(np.abs(amplitudes).sum())
    width = 2 * shape.harmonics + 1
    about = padded(forcing, shape.harmonics)
    about[:, 0] += matrix_of(system, sides) @ centre
    memory[at + shape.forcing : at + shape.forcing + shape.n * width] = about.ravel()
    memory[at + shape.centre + 1 : at + shape.centre + 1 + shape.n] = centre
    memory[at + shape.lag : at + shape.lag + shape.clearances] = 0.0 if centres.any() else -(edges + means)
    for c, clearance in enumerate(system.clearances):
        size = float(np.abs(clearance.h).sum())
        own, own_derived = left_out(clearance.offset, 2 * pi / shape.cells)
        memory[at + shape.tail + 4 * c : at + shape.tail + 4 * c + 4] = (
            size * tail, size * tail * total + own, size * derived, size * derived * total + own_derived,
        )  # fmt: skip
    sizes, closed = sizes_of(shape), np.array(sides, dtype=np.int64)
    for first, until in calls(shape):
        assemble(
            sizes, memory, at, amplitudes, ends, gaps, closed, props.rules, everything, first, until,
        )  # fmt: skip
    laps(sizes, memory, at, closed)


def _key(system: System, units: Array) -> tuple:
    parts: list[object] = [system.omega, system.cycles, system.matrix.tobytes(), units.tobytes()]
    for c in system.clearances:
        parts += [c.dampings, c.contact, c.stops(1), c.stops(-1)]
        parts += [a.tobytes() for a in (c.h, c.g, c.stiffness_plus, c.stiffness_minus)]
    return (*parts, system.forcing.shape, *(len(c.offset) for c in system.clearances))
