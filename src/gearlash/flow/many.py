"""Carrying several motions of one system."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from gearlash.system import GearlashError, Record, Status, given

from ._blocks import LANES
from ._eight import MOST, Lanes
from ._motion import OK
from ._tables import ALWAYS, FREE, MINUS, PLUS, Array, Shape
from .arguments import empty
from .march import LONGEST, NO_HOLD, STATUS, block_of, columns_of, known, room_of, run_all
from .propagators import Propagators

TOGETHER = 16_000  # base periods in one call, at the most (but eight motions)
MOST_THREADS = 1024
CELLS = 2_500_000  # that motions side by side pass in one call, at the most (but eight motions): 0.2 s


@dataclass(frozen=True, eq=False, repr=False)
class ManyStrobes(Record):
    """Of several motions: states (stretches+1, motions, n) at equal phases, contacts (stretches, motions,
    4·clearances) as in `Strobes`, and of each motion how many places stayed undecided, and its status."""

    _told: ClassVar = ("states", "contacts")

    states: Array
    contacts: Array
    undecided: Array
    statuses: tuple[Status, ...]


def march_many(
    props: Propagators, z: ArrayLike, stretches: int, stretch: int = 1, *, threads: int = 1
) -> ManyStrobes:
    """`march` of several motions, z (motions, n), on one or more threads. Every motion is the same, byte for
    byte, as alone. Where one ends early, its later states are NaN.

    Motions of systems with one clearance and the rule `always` go side by side, 64 at a time: the more, the
    faster. The first such call on a machine compiles the kernel for that, which takes some 25 s. Raises
    `GearlashError` for arguments that do not fit."""
    states = given.numbers("z", z, ("motions", known(props).system.size))
    stretches, stretch = given.whole("stretches", stretches, 0), given.whole("stretch", stretch, 1, LONGEST)
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
    abreast: bool
    order: Array

    @classmethod
    def of(cls, props: Propagators, starts: Array, stretches: int, stretch: int) -> _Job:
        motions, abreast = len(starts), _can_be_abreast(props)
        states = empty(motions, stretches + 1, starts.shape[1])
        states[:, 0] = starts
        counts = np.zeros((motions, stretches, columns_of(props)), dtype=np.int64)
        outcomes, order = np.zeros(motions, dtype=np.int64), np.arange(motions)
        if abreast:  # those that may do the same at the same time, by the gap, after each other
            order = np.argsort(starts @ props.system.clearances[0].h, kind="stable")
        return cls(props, stretch, states, counts, outcomes, abreast, order)

    def carry(self, motions: Array) -> None:
        """Carries some of them to their ends, in calls of the same length as those of `march`."""
        done, stretches = 0, self.counts.shape[1]
        while done < stretches:
            block = min(block_of(self.props, self.stretch), stretches - done)
            going = motions[self.outcomes[motions] == OK]
            size = self._at_once(block) if self.abreast or block == stretches else 1
            for first in range(0, len(going), size):
                group = going[first : first + size]
                if self.abreast and len(group) > 1:
                    self._side_by_side(group, done, block)
                else:
                    self._alone(slice(group[0], group[-1] + 1), done, block)
            done += block

    def _at_once(self, block: int) -> int:
        """Motions in one call over so many stretches, so that it does not last too long for Ctrl-C."""
        periods = block * self.stretch
        if not self.abreast:
            return max(LANES, TOGETHER // periods)
        most = CELLS // (periods * self.props.cells)
        return min(MOST, max(1, most // LANES) * LANES)

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
        """Up to `MOST`; what does not end well is carried again, alone, for what is to be told of it."""
        from ._abreast import abreast  # when first asked for: it takes long to compile, and few ask

        props, room, tables = self.props, room_of(self.props.shape), self.props.tables
        abreast(
            room.sizes, tables.memory, tables.slot_of, props.rules, motions, self.stretch, done, block,
            self.states, self.counts, self.outcomes, NO_HOLD, room.modes, room.on, room.position,
            room.nothing, room.space, _space(props.shape),
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


def _can_be_abreast(props: Propagators) -> bool:
    """Whether `_abreast` takes this system. Builds every region that a motion can come to, as that cannot be
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


def _space(shape: Shape) -> Lanes:
    """This thread's work space, made anew where the shape is another one."""
    from ._eight import room

    if getattr(_local, "shape", None) != shape:
        _local.shape, _local.space = shape, room(shape)
    return _local.space
