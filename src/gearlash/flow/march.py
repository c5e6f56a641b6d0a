"""Carrying states through a system, and reporting every contact."""

from __future__ import annotations

from collections import namedtuple
from dataclasses import dataclass
from math import floor

import numpy as np
from numpy.typing import ArrayLike

from gearlash.system import GearlashError, Status

from . import _march
from ._tables import ORDER, Array, aligned
from ._walk import DIVERGED, NEED_REGION, NEEDED, OK, TOO_MANY
from .events import Events, Trace
from .propagators import Propagators

_STATUS = {
    OK: Status.OK,
    TOO_MANY: Status.TOO_MANY_EVENTS,
    DIVERGED: Status.DIVERGED,
}
CALL = 4_000  # base periods in one kernel call at the most, so that Ctrl-C is answered soon;
WORK = 1e7  # fewer where their cells have more than so many table entries
MOST_PIECES = 2_000_000


@dataclass(frozen=True, eq=False)
class Strobes:
    """States (stretches+1, n) at equal phases, and per stretch the contacts (stretches, 4·clearances):
    of each clearance engagements at + and at -, releases at + and at -; `undecided` counts places where
    touching lies within rounding."""

    states: Array
    contacts: Array
    undecided: int
    status: Status


@dataclass(frozen=True, eq=False)
class Carried:
    """A state (n,) carried from one phase to another; `jacobian` (n, n) with respect to the start, or
    None; `contacts` (4·clearances,) as in `Strobes`."""

    state: Array
    jacobian: Array | None
    contacts: Array
    undecided: int
    status: Status


@dataclass(frozen=True)
class Hold:
    """A boundary (+1, -1) that is not treated as crossed between two phases (mesh cycles, absolute): the
    one-sided, smooth system in which a grazing extremum may pass through it."""

    boundary: int
    start: float
    stop: float
    clearance: int = 0


def start_state(z: ArrayLike, size: int) -> Array:
    """A fresh float64 copy of a state. Raises `GearlashError` for a wrong shape or a number that is not
    finite."""
    state = np.array(z, dtype=np.float64)
    if state.shape != (size,):
        raise GearlashError(f"state has shape {state.shape}, expected ({size},)")
    if not np.isfinite(state).all():
        raise GearlashError("state holds NaN or infinity")
    return state


def march(props: Propagators, z: ArrayLike, stretches: int, stretch: int = 1) -> Strobes:
    """Marches from phase zero, sampling every ``stretch`` base periods (σ_t), ``stretches`` times."""
    state = start_state(z, props.system.size)
    states, contacts = [state[None].copy()], [np.zeros((0, _columns(props)), dtype=np.int64)]
    shape, done, status = props.shape, 0, Status.OK
    most = min(CALL, WORK / (shape.cells * (1 + shape.n) * shape.rows))
    while done < stretches and status.ok:
        block = min(max(1, int(most) // stretch), stretches - done)
        status, strobes, counts = _run(props, state, 0.0, float(stretch * props.cells), block)
        states.append(strobes[1:])
        contacts.append(counts)
        done += block
    table = np.concatenate(contacts)
    return Strobes(np.concatenate(states), table[:, :-1], int(table[:, -1].sum()), _with_doubt(status, table))


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
    state = start_state(z, props.system.size)
    tangents = np.eye(state.size) if jacobian else None
    base, start, length = positions(props, phase, cycles)
    status, _, counts = _run(props, state, start, length, 1, tangents=tangents, hold=hold, base=base)
    flow = None if tangents is None else np.ascontiguousarray(tangents.T)
    return Carried(state, flow, counts[0, :-1], int(counts[0, -1]), _with_doubt(status, counts))


def variational(props: Propagators, z: ArrayLike, cycles: float, phase: float = 0.0) -> Carried:
    """`carry` with the Jacobian."""
    return carry(props, z, cycles, phase, jacobian=True)


def trace(
    props: Propagators, z: ArrayLike, cycles: float, phase: float = 0.0, *, hold: Hold | None = None
) -> Trace:
    """The motion over ``cycles`` mesh cycles as exact pieces, with every contact event."""
    state = start_state(z, props.system.size)
    begin, n = state.copy(), state.size
    base, start, length = positions(props, phase, cycles)
    capacity = int(2 * length + 64)
    while True:
        state[:] = begin
        record = _Record(
            np.zeros(2, dtype=np.int64),
            np.empty((capacity, 2 + props.shape.clearances)),
            np.empty((capacity, ORDER + 1, n)),
            np.empty((capacity, 4)),
            np.empty((capacity, n)),
        )
        status, _, counts = _run(props, state, start, length, 1, hold=hold, base=base, record=record)
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
        status=_with_doubt(status, counts),
    )


def orthonormal_growth(props: Propagators, z: Array, frame: Array, periods: int) -> tuple[Status, Array]:
    """Carries z (n,) and the orthonormal rows of frame (m, n) in place over base periods; returns the sums
    (m,) of the logarithms of the lengths."""
    sums = np.zeros(len(frame))
    status, _, counts = _run(props, z, 0.0, float(props.cells), periods, tangents=frame, sums=sums)
    return _with_doubt(status, counts), sums


def positions(props: Propagators, phase: float, cycles: float) -> tuple[float, float, float]:
    """Base phase (whole base periods before the start), start after it and length, both in cells."""
    if not cycles >= 0.0:
        raise GearlashError(f"cycles is {cycles}, expected 0 or more")
    base = float(props.system.cycles * floor(phase / props.system.cycles))
    return base, _snapped((phase - base) * props.cells_per_cycle), _snapped(cycles * props.cells_per_cycle)


_Record = namedtuple("_Record", "used piece poly event state")
_NOTHING = np.array([-1, 0], dtype=np.int64)


def _columns(props: Propagators) -> int:
    return 4 * props.shape.clearances + 1


def _run(
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
    record: _Record | None = None,
) -> tuple[Status, Array, Array]:
    """Calls the kernel: state (n,) and the rows of tangents (m, n) are carried in place. Where the
    motion comes to a region without tables, they are built, and it goes on."""
    shape, n = props.shape, state.size
    strobes = np.full((stretches + 1, n), np.nan)  # what is not reached stays NaN
    counts = np.zeros((stretches, _columns(props)), dtype=np.int64)
    count = 0 if tangents is None else len(tangents)
    u, flat = aligned(shape.p, count * shape.p)
    frame = flat.reshape(count, shape.p)
    u[0], u[1 : 1 + n] = 1.0, state
    if tangents is not None:
        frame[:, 1 : 1 + n] = tangents
    if record is None:
        record = _Record(
            _NOTHING, np.empty((0, 2)), np.empty((0, ORDER + 1, n)), np.empty((0, 4)), np.empty((0, n))
        )
    modes, on = np.zeros((2, shape.clearances), dtype=np.int64)
    position = np.zeros(6)
    progress, held = np.zeros(2, dtype=np.int64), _hold(props, hold, base)
    space = _march.scratch(shape)
    while True:
        tables = props.tables
        code = _march.run(
            shape, tables.memory, tables.slot_of, props.rules, u, flat, modes, on, position, progress, start,
            length, held, strobes, counts, np.empty(0) if sums is None else sums, *record, *space,
        )  # fmt: skip
        if code != NEED_REGION:
            break
        props.build(int(position[NEEDED]))
    state[:] = u[1 : 1 + n] if code == OK else strobes[progress[1] + 1]
    if tangents is not None:
        tangents[:] = frame[:, 1 : 1 + n]
    return _STATUS[code], strobes, counts


def _snapped(position: float) -> float:
    """A position that differs from a cell edge by rounding only is that edge."""
    edge = round(position)
    return float(edge) if abs(position - edge) <= 4e-16 * max(1.0, abs(position)) else position


def _hold(props: Propagators, hold: Hold | None, base: float) -> Array:
    if hold is None:
        return np.zeros(4)
    window = (np.array([hold.start, hold.stop]) - base) * props.cells_per_cycle
    return np.array([float(hold.clearance), float(hold.boundary), *window])


def _with_doubt(status: Status, counts: Array) -> Status:
    return Status.UNCERTAIN if status.ok and counts[..., -1].any() else status
