"""Carrying several motions of one system."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from gearlash.system import GearlashError, Record, Status, System, given

from ._blocks import LANES
from ._lanes import MOST_MOTIONS, Lanes
from ._motion import OK
from ._tables import ALWAYS, FREE, MINUS, PLUS, Array, Shape
from .arguments import empty
from .propagators import Propagators, propagators_of
from .run import LONGEST_STRETCH, NO_HOLD, STATUS, block_of, columns_of, run_all, workspace_of

# Of one kernel call, at the most (but eight motions are always allowed):
# Of one kernel call, at the most (but eight motions are always allowed):
MOTION_PERIODS_PER_CALL = 16_000  # base periods of all motions, where they are carried one after the other
CELLS_PER_CALL = 2_500_000  # cells that motions pass side by side: 0.2 s
MOST_THREADS = 1024


@dataclass(frozen=True, eq=False, repr=False)
class ManyStrobes(Record):
    """Several motions of one system, sampled at equal phases.

    Attributes
    ----------
    states : array (stretches + 1, motions, n)
        The states at the start and at the end of every stretch; NaN behind the end of a motion that ended
        early.
    contacts : array (stretches, motions, 4·clearances) of int
        As in `Strobes`.
    undecided : array (motions,) of int
        Of each motion: places where it could not be decided within rounding whether a boundary is touched.
    statuses : tuple of Status
        Of each motion.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> many = gl.march_many(family.system(), [[1.1, 0.0], [1.2, 0.0], [1.3, 0.0]], 5)
    >>> many.states.shape, [str(status) for status in many.statuses]
    ((6, 3, 2), ['ok', 'ok', 'ok'])
    """

    _printed: ClassVar = ("states", "contacts")

    states: Array
    contacts: Array
    undecided: Array
    statuses: tuple[Status, ...]


def march_many(
    system: System | Propagators,
    start: ArrayLike,
    stretches: int,
    stretch: int = 1,
    *,
    threads: int = 1,
) -> ManyStrobes:
    """March several motions of one system from phase zero; each as `march` carries it, byte for byte.

    Motions of systems with one clearance and the rule `always` are carried side by side, 64 at a time: the
    more there are, the faster is each. The first such call on a machine compiles the kernel for that.

    Parameters
    ----------
    system : System or Propagators
        The system. Its propagators are made of it in every call, unless they are what is given.
    start : array_like (motions, n)
        States at phase zero.
    stretches : int
        How many; 0 or more.
    stretch : int, default 1
        Base periods of each, 1 to 10,000,000. A stretch cannot be interrupted.
    threads : int, default 1
        On how many threads, 1 to 1024.

    Returns
    -------
    ManyStrobes
        States at the ends of stretches, contacts in between, and a status for each motion.

    Raises
    ------
    GearlashError
        For arguments that do not fit, and systems that would need too many cells or too much memory.

    Examples
    --------
    >>> import gearlash as gl
    >>> import numpy as np
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> props = gl.propagators(family.system({"omega": 0.9}))
    >>> many = gl.march_many(props, [[1.1, 0.0], [-1.1, 0.5]], 300)
    >>> bool(np.array_equal(many.states[:, 1], gl.march(props, [-1.1, 0.5], 300).states))
    True
    """
    props = propagators_of(system)
    states = given.numbers("start", start, ("motions", props.system.size))
    stretches, stretch = (
        given.whole("stretches", stretches, 0),
        given.whole("stretch", stretch, 1, LONGEST_STRETCH),
    )
    threads = given.whole("threads", threads, 1, MOST_THREADS)
    job = _Job.of(props, states, stretches, stretch)
    parts = [part for part in np.array_split(job.order, threads) if len(part)]
    if len(parts) < 2:
        job.carry(job.order)
    else:
        with ThreadPoolExecutor(len(parts)) as pool:
            list(pool.map(job.carry, parts))
    return job.found()


@dataclass(frozen=True, eq=False)
class _Job:
    """Motions under way: states (motions, stretches+1, n), counts (motions, stretches, columns), outcomes
    (motions,), and the ``order`` in which they are taken."""

    props: Propagators
    stretch: int
    states: Array
    counts: Array
    outcomes: Array
    side_by_side: bool
    order: Array

    @classmethod
    def of(cls, props: Propagators, starts: Array, stretches: int, stretch: int) -> _Job:
        motions, side_by_side = len(starts), _takes_lanes(props)
        states = empty(motions, stretches + 1, starts.shape[1])
        states[:, 0] = starts
        counts = np.zeros((motions, stretches, columns_of(props)), dtype=np.int64)
        outcomes, order = np.zeros(motions, dtype=np.int64), np.arange(motions)
        if side_by_side:  # those that may do the same at the same time, by the gap, after each other
            order = np.argsort(starts @ props.system.clearances[0].h, kind="stable")
        return cls(props, stretch, states, counts, outcomes, side_by_side, order)

    def carry(self, motions: Array) -> None:
        """Carries some of them to their ends, in calls of the same length as those of `march`."""
        done, stretches = 0, self.counts.shape[1]
        while done < stretches:
            block = min(block_of(self.props, self.stretch), stretches - done)
            going = motions[self.outcomes[motions] == OK]
            size = self._at_once(block) if self.side_by_side or block == stretches else 1
            for first in range(0, len(going), size):
                group = going[first : first + size]
                if self.side_by_side and len(group) > 1:
                    self._side_by_side(group, done, block)
                else:
                    self._alone(slice(group[0], group[-1] + 1), done, block)
            done += block

    def _at_once(self, block: int) -> int:
        """Motions in one call over so many stretches, so that it does not last too long for Ctrl-C."""
        periods = block * self.stretch
        if not self.side_by_side:
            return max(LANES, MOTION_PERIODS_PER_CALL // periods)
        most = CELLS_PER_CALL // (periods * self.props.cells)
        return min(MOST_MOTIONS, max(1, most // LANES) * LANES)

    def _alone(self, motions: slice, done: int, block: int) -> None:
        """One after the other: one, or several over all their stretches."""
        rows, starts = slice(done, done + block + 1), self.states[motions, done].copy()
        length = float(self.stretch * self.props.cells)
        self.outcomes[motions] = run_all(
            self.props, starts, 0.0, length, self.states[motions, rows], self.counts[motions, rows][:, :block]
        )
        for motion in np.arange(motions.start, motions.stop)[self.outcomes[motions] != OK]:
            self.states[motion, done + block + 1 :] = np.nan

    def _side_by_side(self, motions: Array, done: int, block: int) -> None:
        """Up to `MOST_MOTIONS`. A motion that does not end well is carried again alone, as only that tells
        where and why."""
        from ._ensemble import march_ensemble  # when first asked for: it takes long to compile, and few ask

        props, room, tables = self.props, workspace_of(self.props.shape), self.props.tables
        march_ensemble(
            room.sizes, tables.memory, tables.slot_of, props.rules, motions, self.stretch, done, block,
            self.states, self.counts, self.outcomes, NO_HOLD, room.numbers, room.ints, room.nothing,
            _lanes(props.shape),
        )  # fmt: skip
        for motion in motions[self.outcomes[motions] != OK]:
            self.counts[motion, done : done + block] = 0
            self._alone(slice(motion, motion + 1), done, block)

    def found(self) -> ManyStrobes:
        doubts = self.counts[..., -1].sum(axis=1)
        statuses = tuple(
            Status.UNCERTAIN if outcome == OK and doubt else STATUS[int(outcome)]
            for outcome, doubt in zip(self.outcomes, doubts, strict=True)
        )
        return ManyStrobes(self.states.swapaxes(0, 1), self.counts[..., :-1].swapaxes(0, 1), doubts, statuses)


def _takes_lanes(props: Propagators) -> bool:
    """Whether `_ensemble` takes this system. Builds every region that a motion can come to, as that cannot be
    done on the way."""
    if props.shape.clearances != 1 or props.rules[0] != ALWAYS:
        return False
    (clearance,) = props.system.clearances
    try:
        props.build(FREE)  # of a gap without width too: motions pass through it
        for side, boundary in ((PLUS, 1), (MINUS, -1)):
            if clearance.stops(boundary):
                props.build(side)
    except GearlashError:  # for those that come there, not for all
        return False
    return True


_local = threading.local()


def _lanes(shape: Shape) -> Lanes:
    """This thread's work space, made anew where the shape is another one."""
    from ._lanes import lane_workspace

    if getattr(_local, "shape", None) != shape:
        _local.shape, _local.space = shape, lane_workspace(shape)
    return _local.space
