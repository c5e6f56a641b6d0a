"""Calls of the kernel that carries motions: its work space, regions that are built on the way, outcomes."""

from __future__ import annotations

import threading

import numpy as np

from gearlash.system import Status, given

from . import _march
from ._motion import DIVERGED, NEED_REGION, NEEDED, OK, TOO_MANY
from ._record import Record as Kept
from ._tables import ORDER, Array, Shape, aligned, sizes_of
from .carried import Hold
from .propagators import Propagators

STATUS = {
    OK: Status.OK,
    TOO_MANY: Status.TOO_MANY_EVENTS,
    DIVERGED: Status.DIVERGED,
}
# Of one kernel call, at the most, so that Ctrl-C is answered soon:
PERIODS_PER_CALL = 4_000
ENTRIES_PER_CALL = 1e7  # table entries that all periods of the call pass
KEPT_WORKSPACES = 32  # of a thread: along a map the number of cells, and so the shape, changes now and then
LONGEST_STRETCH = 10_000_000  # base periods of a stretch
NO_HOLD, _NO_SUMS = np.zeros(4), np.empty(0)


def block_of(props: Propagators, stretch: int) -> int:
    """Stretches of one kernel call at the most."""
    shape = props.shape
    most = min(PERIODS_PER_CALL, ENTRIES_PER_CALL / (shape.cells * (1 + shape.n) * shape.rows))
    return max(1, int(most) // stretch)


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
    """Work space of the kernel. It also keeps how far a call came that met a region without tables, so that
    the next call goes on from there."""

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
    """The work space of this thread for systems of this shape."""
    if not hasattr(_workspaces, "kept"):
        _workspaces.kept = {}
    rooms: dict[Shape, _Workspace] = _workspaces.kept
    room = rooms.get(shape)
    if room is None:
        if len(rooms) >= KEPT_WORKSPACES:
            rooms.clear()
        room = rooms[shape] = _Workspace(shape)
    return room


def _hold(props: Propagators, hold: Hold | None, base: float) -> Array:
    if hold is None:
        return NO_HOLD
    given.instance("hold", hold, Hold, "a Hold: boundary, begin, end, clearance")
    given.whole("clearance of the hold", hold.clearance, 0, len(props.rules) - 1)
    window = (np.array([hold.begin, hold.end]) - base) * props.cells_per_cycle
    return np.array([float(hold.clearance), float(hold.boundary), *window])


def with_doubt(status: Status, undecided: int) -> Status:
    return Status.UNCERTAIN if status.ok and undecided else status
