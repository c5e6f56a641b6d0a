"""Carrying a state through a system, and reporting every contact."""

from __future__ import annotations

from math import floor, isfinite

import numpy as np
from numpy.typing import ArrayLike

from gearlash.system import Status, System, given

from ._motion import OK
from ._record import Record as Kept
from ._tables import ORDER, Array
from .arguments import empty
from .carried import Carried, Hold, Strobes
from .events import Events
from .propagators import Propagators, propagators_of
from .run import LONGEST_STRETCH, STATUS, block_of, columns_of, run_all, run_one, with_doubt
from .traces import Trace

MOST_PIECES = 2_000_000
LONGEST_CALL = (
    1e7  # of one call, which cannot be interrupted; and from phase zero, so that phases keep digits
)


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
        given.number("cycles", cycles, 0.0, LONGEST_CALL),
        given.number("phase", phase, -LONGEST_CALL, LONGEST_CALL),
    )
    base = float(props.system.cycles * floor(phase / props.system.cycles))
    return base, _snapped((phase - base) * props.cells_per_cycle), _snapped(cycles * props.cells_per_cycle)


def _snapped(position: float) -> float:
    """A position that differs from a cell edge by rounding only is that edge."""
    edge = round(position)
    return float(edge) if abs(position - edge) <= 4e-16 * max(1.0, abs(position)) else position
