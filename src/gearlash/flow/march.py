"""Carrying states through a system, and reporting every contact."""

from __future__ import annotations

import threading
from dataclasses import dataclass
from math import floor, isfinite
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from gearlash.system import Record, Status, System, given

from . import _march
from ._motion import DIVERGED, NEED_REGION, NEEDED, OK, TOO_MANY
from ._record import Record as Kept
from ._tables import ORDER, Array, Shape, aligned, sizes_of
from .arguments import empty
from .events import Events, Trace
from .propagators import Propagators, propagators_of

STATUS = {
    OK: Status.OK,
    TOO_MANY: Status.TOO_MANY_EVENTS,
    DIVERGED: Status.DIVERGED,
}
PERIODS_PER_CALL = 4_000  # base periods in one kernel call at the most, so that Ctrl-C is answered soon;
ENTRIES_PER_CALL = 1e7  # fewer where their cells have more than so many table entries
MOST_PIECES = 2_000_000
MOST_CYCLES = 1e7  # of one call, which cannot be interrupted; and from phase zero, so that phases keep digits
LONGEST_STRETCH = 10_000_000  # base periods of a stretch
KEPT_WORKSPACES = 32  # of a thread: along a map the number of cells, and so the shape, changes now and then


@dataclass(frozen=True, eq=False, repr=False)
class Strobes(Record):
    """A motion sampled at equal phases, and the contacts that it made in between.

    Attributes
    ----------
    states : array (stretches + 1, n)
        The state at the start and at the end of every stretch.
    contacts : array (stretches, 4·clearances) of int
        Of each clearance and stretch: engagements at + and at -, releases at + and at -.
    undecided : int
        Places where it could not be decided within rounding whether a boundary is touched.
    status : Status
        Whether the motion was carried to its end; where not, the later rows are missing.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> strobes = gl.march(family.system({"omega": 0.9}), family.start({"omega": 0.9}), 20)
    >>> strobes.states.shape, strobes.contacts.shape, strobes.status.ok
    ((21, 2), (20, 4), True)
    """

    _printed: ClassVar = ("status", "undecided", "states", "contacts")

    states: Array
    contacts: Array
    undecided: int
    status: Status


@dataclass(frozen=True, eq=False, repr=False)
class Carried(Record):
    """A state carried from one phase to another.

    Attributes
    ----------
    state : array (n,)
        Where the motion came to.
    jacobian : array (n, n), or None
        Its derivative with respect to the start, where that was asked for.
    contacts : array (4·clearances,) of int
        Of each clearance: engagements at + and at -, releases at + and at -.
    undecided : int
        Places where it could not be decided within rounding whether a boundary is touched.
    status : Status
        Whether the motion was carried to its end.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> carried = gl.variational(family.system(), family.start(), 1.0)
    >>> carried.state.shape, carried.jacobian.shape
    ((2,), (2, 2))
    """

    _printed: ClassVar = ("status", "undecided", "state", "contacts")

    state: Array
    jacobian: Array | None
    contacts: Array
    undecided: int
    status: Status


@dataclass(frozen=True, repr=False)
class Hold(Record):
    """A boundary that is not treated as crossed between two phases.

    What is left is the one-sided, smooth system in which a grazing extremum may pass through the boundary.

    Parameters
    ----------
    boundary : int
        +1 or -1: the side of the clearance.
    begin, end : float
        Phases, in mesh cycles from phase zero, between which it is held.
    clearance : int, default 0
        Number of the clearance.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> system, start = family.system({"omega": 0.9}), [1.1, -0.5]
    >>> len(gl.trace(system, start, 0.5).events)
    1
    >>> len(gl.trace(system, start, 0.5, hold=gl.Hold(1, 0.0, 0.5)).events)
    0
    """

    boundary: int
    begin: float
    end: float
    clearance: int = 0


def start_state(props: Propagators, start: ArrayLike) -> Array:
    """A copy of a state (n,) in float64. Raises `GearlashError` for another shape, or a number that is not
    finite."""
    size = props.system.size
    if type(start) is np.ndarray and start.dtype == np.float64 and start.shape == (size,):  # asked for often
        state = start.copy()
        if all(map(isfinite, state.tolist())):
            return state
    return given.numbers("start", start, (size,))


def march(system: System | Propagators, start: ArrayLike, stretches: int, stretch: int = 1) -> Strobes:
    """March from phase zero, and sample the motion once a stretch of base periods.

    Parameters
    ----------
    system : System or Propagators
        The system. Its propagators are made of it in every call, unless they are what is given.
    start : array_like (n,)
        State at phase zero.
    stretches : int
        How many; 0 or more.
    stretch : int, default 1
        Base periods of each, 1 to 10,000,000. A stretch cannot be interrupted.

    Returns
    -------
    Strobes
        States at the ends of stretches, contacts in between. Where its status is not `OK`, they end early.

    Raises
    ------
    GearlashError
        For arguments that do not fit, and systems that would need too many cells or too much memory.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> props = gl.propagators(family.system({"omega": 0.9}))
    >>> strobes = gl.march(props, family.start({"omega": 0.9}), 200)
    >>> print(strobes.contacts[-1])
    [1 0 1 0]
    """
    props = propagators_of(system)
    state = start_state(props, start)
    stretches, stretch = (
        given.whole("stretches", stretches, 0),
        given.whole("stretch", stretch, 1, LONGEST_STRETCH),
    )
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
    most = min(PERIODS_PER_CALL, ENTRIES_PER_CALL / (shape.cells * (1 + shape.n) * shape.rows))
    return max(1, int(most) // stretch)


def carry(
    system: System | Propagators,
    start: ArrayLike,
    cycles: float,
    phase: float = 0.0,
    *,
    jacobian: bool = False,
    hold: Hold | None = None,
) -> Carried:
    """Carry a state from ``phase`` over ``cycles``, both in mesh cycles; with its Jacobian if that is wanted,
    which is exact where no boundary is just touched. Arguments as of `trace`."""
    props = propagators_of(system)
    state = start_state(props, start)
    tangents = np.eye(state.size) if given.truth("jacobian", jacobian) else None
    base, first, length = positions(props, phase, cycles)
    status, _, counts = run_one(props, state, first, length, 1, tangents=tangents, hold=hold, base=base)
    flow, undecided = None if tangents is None else np.ascontiguousarray(tangents.T), int(counts[0, -1])
    return Carried(state, flow, counts[0, :-1], undecided, with_doubt(status, undecided))


def variational(system: System | Propagators, start: ArrayLike, cycles: float, phase: float = 0.0) -> Carried:
    """Carry a state over some mesh cycles, together with its derivative with respect to the start.

    The Jacobian solves the variational equation, jumps at contacts included. It is exact to rounding where no
    boundary is just touched.

    Parameters
    ----------
    system : System or Propagators
        The system. Its propagators are made of it in every call, unless they are what is given.
    start : array_like (n,)
        State at ``phase``.
    cycles : float
        How far, in mesh cycles: 0 to 1e7.
    phase : float, default 0.0
        Where it begins, in mesh cycles from phase zero: -1e7 to 1e7.

    Returns
    -------
    Carried
        The state at the end, and the Jacobian (n, n).

    Raises
    ------
    GearlashError
        For arguments that do not fit, and systems that would need too many cells or too much memory.

    References
    ----------
    M. di Bernardo et al., Piecewise-smooth Dynamical Systems, Springer, 2008, chapter 2,
    doi:10.1007/978-1-84628-708-4.

    Examples
    --------
    >>> import gearlash as gl
    >>> import numpy as np
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> system = family.system({"omega": 0.9})
    >>> flow = gl.variational(system, [1.1, -0.5], 1.0)
    >>> round(float(np.linalg.det(flow.jacobian)), 6)  # exp(-2 ζ T) with ζ = 0.05, T = 2π/0.9
    0.497514
    """
    return carry(system, start, cycles, phase, jacobian=True)


def trace(
    system: System | Propagators,
    start: ArrayLike,
    cycles: float,
    phase: float = 0.0,
    *,
    hold: Hold | None = None,
) -> Trace:
    """Compute a motion over some mesh cycles as polynomials, with every contact event.

    Parameters
    ----------
    system : System or Propagators
        The system. Its propagators are made of it in every call, unless they are what is given.
    start : array_like (n,)
        State at ``phase``.
    cycles : float
        How far, in mesh cycles: 0 to 1e7.
    phase : float, default 0.0
        Where it begins, in mesh cycles from phase zero: -1e7 to 1e7.
    hold : Hold, optional
        A boundary that is not treated as crossed for a while.

    Returns
    -------
    Trace
        The motion: to be read at any phase, with its contact events and extrema. Where its status is not
        `OK`, it ends early.

    Raises
    ------
    GearlashError
        For arguments that do not fit, and systems that would need too many cells or too much memory.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> trace = gl.trace(family.system({"omega": 0.9}), [1.1, -0.5], 1.0)
    >>> print(trace.events.phase.round(4), trace.events.engaging)
    [0.0292] [False]
    """
    props = propagators_of(system)
    state = start_state(props, start)
    begin, n = state.copy(), state.size
    base, first, length = positions(props, phase, cycles)
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
        status, _, counts = run_one(props, state, first, length, 1, hold=hold, base=base, record=record)
        if status is not Status.TOO_MANY_EVENTS or capacity > MOST_PIECES:
            break
        capacity *= 4
    undecided = int(counts[0, -1])
    return _trace_of(props, record, base, phase, cycles, state, undecided, with_doubt(status, undecided))


def _trace_of(
    props: Propagators, record: Kept, base: float, phase: float, cycles: float, end: Array, undecided: int,
    status: Status,
) -> Trace:  # fmt: skip
    """What a kernel has kept, as a `Trace`."""
    used, piece, poly, event, states = record
    pieces, events = int(used[0]), int(used[1])
    places = base + event[:events, 0] / props.cells_per_cycle
    return Trace(
        propagators=props,
        base=base,
        phase=phase,
        cycles=cycles,
        positions=piece[:pieces, 0].copy(),
        lengths=piece[:pieces, 1].copy(),
        modes=piece[:pieces, 2:].astype(np.int64),
        polynomials=poly[:pieces].copy(),
        events=Events.build(props.system, places, states[:events].copy(), event[:events, 1:]),
        end=end,
        undecided=undecided,
        status=status,
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
    cycles, phase = (
        given.number("cycles", cycles, 0.0, MOST_CYCLES),
        given.number("phase", phase, -MOST_CYCLES, MOST_CYCLES),
    )
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
    room = workspace_of(shape)
    u, starts, flat, frame = room.vectors(motions, 0 if tangents is None else len(tangents))
    starts[:] = states
    if tangents is not None:
        frame[:] = tangents
    outcomes = np.zeros(motions, dtype=np.int64)
    room.progress[:] = 0
    while True:
        tables = props.tables
        code = _march.run(
            room.sizes, tables.memory, tables.slot_of, props.rules, u, flat, start, length,
            NO_HOLD if hold is None else hold, strobes, counts,
            _NO_SUMS if sums is None else sums.reshape(-1), outcomes, *(record or room.nothing),
            room.numbers, room.ints,
        )  # fmt: skip
        if code != NEED_REGION:
            break
        props.build(int(room.position[NEEDED]))
    states[:] = starts
    if tangents is not None:
        tangents[:] = frame
    return outcomes


class _Workspace:
    """Work space of the kernel, and what it goes on from after a region was built."""

    def __init__(self, shape: Shape):
        self.sizes = sizes_of(shape)
        self.shape = shape
        self.numbers, self.ints = _march.scratch(shape)
        parts = _march.split(shape, self.numbers, self.ints)
        self.position, self.progress = parts.position, parts.progress
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


_workspaces = threading.local()


def workspace_of(shape: Shape) -> _Workspace:
    """This thread's for systems of this shape."""
    if not hasattr(_workspaces, "kept"):
        _workspaces.kept = {}
    rooms: dict[Shape, _Workspace] = _workspaces.kept
    room = rooms.get(shape)
    if room is None:
        if len(rooms) >= KEPT_WORKSPACES:
            rooms.clear()
        room = rooms[shape] = _Workspace(shape)
    return room


def _snapped(position: float) -> float:
    """A position that differs from a cell edge by rounding only is that edge."""
    edge = round(position)
    return float(edge) if abs(position - edge) <= 4e-16 * max(1.0, abs(position)) else position


def _hold(props: Propagators, hold: Hold | None, base: float) -> Array:
    if hold is None:
        return NO_HOLD
    given.instance("hold", hold, Hold, "a Hold: boundary, begin, end, clearance")
    given.whole("clearance of the hold", hold.clearance, 0, len(props.rules) - 1)
    window = (np.array([hold.begin, hold.end]) - base) * props.cells_per_cycle
    return np.array([float(hold.clearance), float(hold.boundary), *window])


def with_doubt(status: Status, undecided: int) -> Status:
    return Status.UNCERTAIN if status.ok and undecided else status
