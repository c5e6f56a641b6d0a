"""Carrying states through a system, and reporting every contact."""

from __future__ import annotations

import threading
from dataclasses import dataclass
from math import floor, isfinite
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from gearlash.system import Record, Status, given

from . import _march
from ._motion import DIVERGED, NEED_REGION, NEEDED, OK, TOO_MANY
from ._record import Record as Kept
from ._tables import ORDER, Array, Shape, aligned, aligned_ints, sizes_of
from .arguments import empty
from .events import Events, Trace
from .propagators import Propagators

STATUS = {
    OK: Status.OK,
    TOO_MANY: Status.TOO_MANY_EVENTS,
    DIVERGED: Status.DIVERGED,
}
CALL = 4_000  # base periods in one kernel call at the most, so that Ctrl-C is answered soon;
WORK = 1e7  # fewer where their cells have more than so many table entries
MOST_PIECES = 2_000_000
FAR = 1e7  # mesh cycles of one call, and from phase zero: it cannot be interrupted, and phases keep digits
LONGEST = 10_000_000  # base periods of a stretch
ROOMS = 32  # shapes whose work space a thread keeps: along a map the number of cells changes now and then


@dataclass(frozen=True, eq=False, repr=False)
class Strobes(Record):
    """States (stretches+1, n) at equal phases, and per stretch the contacts (stretches, 4·clearances):
    of each clearance engagements at + and at -, releases at + and at -; `undecided` counts places where
    touching lies within rounding."""

    _told: ClassVar = ("status", "undecided", "states", "contacts")

    states: Array
    contacts: Array
    undecided: int
    status: Status


@dataclass(frozen=True, eq=False, repr=False)
class Carried(Record):
    """A state (n,) carried from one phase to another; `jacobian` (n, n) with respect to the start, or
    None; `contacts` (4·clearances,) as in `Strobes`."""

    _told: ClassVar = ("status", "undecided", "state", "contacts")

    state: Array
    jacobian: Array | None
    contacts: Array
    undecided: int
    status: Status


@dataclass(frozen=True, repr=False)
class Hold(Record):
    """A boundary (+1, -1) that is not treated as crossed between two phases (mesh cycles, absolute): the
    one-sided, smooth system in which a grazing extremum may pass through it."""

    boundary: int
    start: float
    stop: float
    clearance: int = 0


def start_state(props: Propagators, z: ArrayLike) -> Array:
    """A fresh float64 copy of a state. Raises `GearlashError` for a wrong shape or a number that is not
    finite."""
    size = known(props).system.size
    if type(z) is np.ndarray and z.dtype == np.float64 and z.shape == (size,):  # asked for very often
        state = z.copy()
        if all(map(isfinite, state.tolist())):
            return state
    return given.numbers("state", z, (size,))


def known(props: Propagators) -> Propagators:
    """Raises `GearlashError` for what are no propagators."""
    expected = "propagators of a system, made once with gearlash.propagators(system)"
    return given.instance("props", props, Propagators, expected)


def march(props: Propagators, z: ArrayLike, stretches: int, stretch: int = 1) -> Strobes:
    """Marches from phase zero, sampling every ``stretch`` base periods (σ_t), ``stretches`` times; a stretch
    cannot be interrupted. Raises `GearlashError` for arguments that do not fit."""
    state = start_state(props, z)
    stretches, stretch = given.whole("stretches", stretches, 0), given.whole("stretch", stretch, 1, LONGEST)
    states = empty(stretches + 1, len(state))
    states[0] = state
    counts = np.zeros((stretches, columns_of(props)), dtype=np.int64)
    done, outcome, most, length = 0, OK, block_of(props, stretch), float(stretch * props.cells)
    while done < stretches and outcome == OK:
        end = min(done + most, stretches)
        rows, happened = states[None, done : end + 1], counts[None, done:end]
        outcome, done = int(run_all(props, state[None], 0.0, length, rows, happened)[0]), end
    undecided = int(counts[:, -1].sum())
    status = with_doubt(STATUS[outcome], undecided)
    return Strobes(states[: done + 1], counts[:done, :-1], undecided, status)


def block_of(props: Propagators, stretch: int) -> int:
    """Stretches of one kernel call at the most."""
    shape = props.shape
    most = min(CALL, WORK / (shape.cells * (1 + shape.n) * shape.rows))
    return max(1, int(most) // stretch)


def carry(
    props: Propagators,
    z: ArrayLike,
    cycles: float,
    phase: float = 0.0,
    *,
    jacobian: bool = False,
    hold: Hold | None = None,
) -> Carried:
    """Carries a state from ``phase`` over ``cycles`` mesh cycles; the Jacobian is exact where no contact is
    touched."""
    state = start_state(props, z)
    tangents = np.eye(state.size) if given.truth("jacobian", jacobian) else None
    base, start, length = positions(props, phase, cycles)
    status, _, counts = run_one(props, state, start, length, 1, tangents=tangents, hold=hold, base=base)
    flow, undecided = None if tangents is None else np.ascontiguousarray(tangents.T), int(counts[0, -1])
    return Carried(state, flow, counts[0, :-1], undecided, with_doubt(status, undecided))


def variational(props: Propagators, z: ArrayLike, cycles: float, phase: float = 0.0) -> Carried:
    """`carry` with the Jacobian."""
    return carry(props, z, cycles, phase, jacobian=True)


def trace(
    props: Propagators, z: ArrayLike, cycles: float, phase: float = 0.0, *, hold: Hold | None = None
) -> Trace:
    """The motion over ``cycles`` mesh cycles as exact pieces, with every contact event."""
    state = start_state(props, z)
    begin, n = state.copy(), state.size
    base, start, length = positions(props, phase, cycles)
    capacity = int(2 * length + 64)
    while True:
        state[:] = begin
        record = Kept(
            np.zeros(2, dtype=np.int64),
            np.empty((capacity, 2 + props.shape.clearances)),
            np.empty((capacity, ORDER + 1, n)),
            np.empty((capacity, 4)),
            np.empty((capacity, n)),
        )
        status, _, counts = run_one(props, state, start, length, 1, hold=hold, base=base, record=record)
        if status is not Status.TOO_MANY_EVENTS or capacity > MOST_PIECES:
            break
        capacity *= 4
    used, piece, poly, event, states = record
    pieces, events = int(used[0]), int(used[1])
    per_cycle = props.cells_per_cycle
    found = Events.build(
        props.system, base + event[:events, 0] / per_cycle, states[:events].copy(), event[:events, 1:]
    )
    return Trace(
        propagators=props,
        base=base,
        start=phase,
        cycles=cycles,
        positions=piece[:pieces, 0].copy(),
        lengths=piece[:pieces, 1].copy(),
        modes=piece[:pieces, 2:].astype(np.int64),
        polynomials=poly[:pieces].copy(),
        events=found,
        end=state,
        undecided=int(counts[0, -1]),
        status=with_doubt(status, int(counts[0, -1])),
    )


def orthonormal_growth(
    props: Propagators, z: Array, frame: Array, periods: int, parts: int = 1
) -> tuple[Status, Array]:
    """Carries z (n,) and the orthonormal rows of frame (m, n) in place over base periods, made orthonormal
    again ``parts`` times in each (a power of two: then parts of a period are exact); returns the sums (m,) of
    the logarithms of the lengths. Ends early where the motion could not be carried on."""
    total, left, undecided = np.zeros(len(frame)), periods, 0
    most, length = max(1, block_of(props, 1)), props.cells / parts
    while left:
        block = min(left, most)
        sums = np.zeros((block * parts, len(frame)))
        status, _, counts = run_one(props, z, 0.0, length, block * parts, tangents=frame, sums=sums)
        total += sums.sum(axis=0)
        undecided += int(counts[:, -1].sum())
        left -= block
        if not status.ok:
            return status, total
    return with_doubt(Status.OK, undecided), total


def positions(props: Propagators, phase: float, cycles: float) -> tuple[float, float, float]:
    """Base phase (whole base periods before the start), start after it and length, both in cells."""
    cycles, phase = given.number("cycles", cycles, 0.0, FAR), given.number("phase", phase, -FAR, FAR)
    base = float(props.system.cycles * floor(phase / props.system.cycles))
    return base, _snapped((phase - base) * props.cells_per_cycle), _snapped(cycles * props.cells_per_cycle)


NO_HOLD, _NO_SUMS = np.zeros(4), np.empty(0)


def columns_of(props: Propagators) -> int:
    return 4 * props.shape.clearances + 1


def run_one(
    props: Propagators,
    state: Array,
    start: float,
    length: float,
    stretches: int,
    *,
    tangents: Array | None = None,
    sums: Array | None = None,
    hold: Hold | None = None,
    base: float = 0.0,
    record: Kept | None = None,
) -> tuple[Status, Array, Array]:
    """`run_all` of one motion: state (n,) and the rows of tangents (m, n) are carried in place. Returns its
    status, strobes (stretches+1, n) and counts (stretches, columns)."""
    strobes = np.empty((1, stretches + 1, len(state)))
    counts = np.zeros((1, stretches, columns_of(props)), dtype=np.int64)
    outcomes = run_all(
        props, state[None], start, length, strobes, counts, tangents, sums, _hold(props, hold, base), record
    )
    return STATUS[int(outcomes[0])], strobes[0], counts[0]


def run_all(
    props: Propagators,
    states: Array,
    start: float,
    length: float,
    strobes: Array,
    counts: Array,
    tangents: Array | None = None,
    sums: Array | None = None,
    hold: Array | None = None,
    record: Kept | None = None,
) -> Array:
    """Calls the kernel: states (motions, n), and of one motion the rows of tangents (m, n), are carried in
    place, strobes (motions, stretches+1, n) written, counts (motions, stretches, columns) added to. Where a
    motion comes to a region without tables, they are built, and it goes on. Returns outcomes (motions,)."""
    shape, motions = props.shape, len(states)
    room = room_of(shape)
    u, starts, flat, frame = room.vectors(motions, 0 if tangents is None else len(tangents))
    starts[:] = states
    if tangents is not None:
        frame[:] = tangents
    outcomes = np.zeros(motions, dtype=np.int64)
    room.progress[:] = 0
    while True:
        tables = props.tables
        code = _march.run(
            room.sizes, tables.memory, tables.slot_of, props.rules, u, flat, room.modes, room.on,
            room.position, room.progress, start, length, NO_HOLD if hold is None else hold, strobes, counts,
            _NO_SUMS if sums is None else sums.reshape(-1), outcomes, *(record or room.nothing), *room.space,
        )  # fmt: skip
        if code != NEED_REGION:
            break
        props.build(int(room.position[NEEDED]))
    states[:] = starts
    if tangents is not None:
        tangents[:] = frame
    return outcomes


class _Room:
    """Work space of the kernel, and what it goes on from after a region was built."""

    def __init__(self, shape: Shape):
        self.sizes = sizes_of(shape)
        self.shape = shape
        self.space = _march.scratch(shape)
        self.modes, self.on, self.progress = aligned_ints(shape.clearances, shape.clearances, 3)
        (self.position,) = aligned(6)
        self.nothing = Kept(
            np.array([-1, 0], dtype=np.int64),
            np.empty((0, 2)),
            np.empty((0, ORDER + 1, shape.n)),
            np.empty((0, 4)),
            np.empty((0, shape.n)),
        )
        self._vectors: dict[tuple[int, int], tuple[Array, Array, Array, Array]] = {}

    def vectors(self, motions: int, tangents: int) -> tuple[Array, Array, Array, Array]:
        """Where the states (motions, n) of so many motions lie for the kernel, and as what they are filled
        in; the same of tangents."""
        found = self._vectors.get((motions, tangents))
        if found is None:
            p, inside = self.shape.p, slice(1, 1 + self.shape.n)
            u, flat = aligned(motions * p, tangents * p)
            starts, frame = u.reshape(motions, p), flat.reshape(tangents, p)
            found = u, starts[:, inside], flat, frame[:, inside]
            if motions == 1:  # of many, every call may have another number
                self._vectors[motions, tangents] = found
        u, _, flat, _ = found
        u[:], flat[:] = 0.0, 0.0  # a motion that diverged leaves NaN even in what only pads
        u[:: self.shape.p] = 1.0
        return found


_rooms = threading.local()


def room_of(shape: Shape) -> _Room:
    """This thread's for systems of this shape."""
    if not hasattr(_rooms, "kept"):
        _rooms.kept = {}
    rooms: dict[Shape, _Room] = _rooms.kept
    room = rooms.get(shape)
    if room is None:
        if len(rooms) >= ROOMS:
            rooms.clear()
        room = rooms[shape] = _Room(shape)
    return room


def _snapped(position: float) -> float:
    """A position that differs from a cell edge by rounding only is that edge."""
    edge = round(position)
    return float(edge) if abs(position - edge) <= 4e-16 * max(1.0, abs(position)) else position


def _hold(props: Propagators, hold: Hold | None, base: float) -> Array:
    if hold is None:
        return NO_HOLD
    given.instance("hold", hold, Hold, "a Hold: boundary, start, stop, clearance")
    given.whole("clearance of the hold", hold.clearance, 0, len(props.rules) - 1)
    window = (np.array([hold.start, hold.stop]) - base) * props.cells_per_cycle
    return np.array([float(hold.clearance), float(hold.boundary), *window])


def with_doubt(status: Status, undecided: int) -> Status:
    return Status.UNCERTAIN if status.ok and undecided else status
