"""A motion while it is followed: states at phase zero, growth of its neighbours, whether it persists."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.system import Status

Array = NDArray[np.float64]

GROWTH_RECORD = 24  # base periods, at least, between two records of growth
GROWTH_RECORDS = 48  # records of the whole motion, about, at the most
SETTLING_PART = 6  # the first of so many equal parts of the record is left out: there the motion settles
STUDENT = {20: 2.093, 10: 2.262}  # batches → 95 % two-sided, with one degree of freedom less
GROWTH_ROUNDING = 1e-14  # of the tangent flow over a base period: no error bar is smaller than this makes it
STILL_SIZE = 1e-6  # a motion whose size on σ_t is below this, relative to its state, counts as an orbit
CLOSING_RETURN = 1e-3  # a mean return below this, relative to the motion's size, counts as closing
AVERAGED_RETURNS = 128  # places of a window, at least, over which returns are averaged


class Average(NamedTuple):
    """The largest exponent per unit of τ, the half-width of its 95 % interval from batch means, and the base
    periods that it was averaged over."""

    value: float
    error: float
    periods: int


class Transient:
    """A motion from ``start`` (n,) at phase zero. ``used`` base periods were marched so far."""

    def __init__(self, props: Propagators, start: Array):
        self.props = props
        self.used = self.undecided = 0
        self.doubtful = False  # whether a contact lay within rounding of touching while growth was recorded
        self._table, self._filled = start[None], 1
        self._tangent: Array | None = None
        self._logs, self._lengths = np.zeros(0), np.zeros(0, dtype=np.int64)

    @property
    def states(self) -> Array:
        """σ_t: every state (used+1, n) so far."""
        return self._table[: self._filled]

    @property
    def state(self) -> Array:
        return self._table[self._filled - 1]

    def record_growth(self) -> None:
        """Begins to record the growth of a tangent vector."""
        if self._tangent is None:
            n = len(self.state)
            self._tangent = np.full(n, n**-0.5)

    def march(self, periods: int) -> Status:
        """Marches on."""
        if self._tangent is None:
            new = flow.march(self.props, self.state, periods)
        else:
            stretch = max(GROWTH_RECORD, (self.used + periods) // GROWTH_RECORDS)
            new = flow.growth(self.props, self.state, self._tangent, periods, stretch)
            self._tangent = new.tangent
            self._logs = np.concatenate([self._logs, new.logarithms])
            self._lengths = np.concatenate([self._lengths, new.lengths])
            self.doubtful |= new.undecided > 0
        self._keep(new.states[1:])
        self.used += periods
        self.undecided += new.undecided
        return new.status

    def _keep(self, states: Array) -> None:
        total = self._filled + len(states)
        if total > len(self._table):
            table = np.empty((2 * total, states.shape[1]))
            table[: self._filled] = self.states
            self._table = table
        self._table[self._filled : total] = states
        self._filled = total

    def exponent(self) -> Average | None:
        """The largest exponent, from the record without its first part; None while that is too short."""
        ends = np.concatenate([[0], np.cumsum(self._lengths)])
        first = int(np.searchsorted(ends, ends[-1] / SETTLING_PART))
        for parts in STUDENT:
            cuts = np.searchsorted(ends, np.linspace(ends[first], ends[-1], parts + 1))
            if (cuts[1:] > cuts[:-1]).all():
                break
        else:
            return None
        lengths = np.diff(ends[cuts])
        sums = np.diff(np.concatenate([[0.0], np.cumsum(self._logs)])[cuts])
        periods = int(lengths.sum())
        mean = float(sums.sum()) / periods
        apart = sums - mean * lengths  # batches are of about the same length only
        error = STUDENT[parts] * float(np.sqrt((apart**2).sum() * parts / (parts - 1))) / periods
        duration = self.props.system.period
        return Average(mean / duration, (error + GROWTH_ROUNDING) / duration, periods)

    def growth(self, periods: int) -> float:
        """Logarithm of the growth of neighbours over ``periods``: the average over the last ``2 * periods``,
        or over the last two records where that is longer. Zero where nothing is recorded yet."""
        ends = np.cumsum(self._lengths[::-1])
        count = int(np.searchsorted(ends, max(2 * periods, 2 * GROWTH_RECORD))) + 1
        if count > len(ends):
            return 0.0
        return float(self._logs[-count:].sum()) * periods / float(ends[count - 1])

    def persists(self, within: float, longest: int) -> bool:
        """Whether both halves of the motion, without its first part, look alike, and it closes in neither.

        Compared are the size, which may change by the part ``within``, and the mean returns after up to
        ``longest`` periods. A slow transient shrinks, or grows, or nearly closes.
        """
        columns = np.ascontiguousarray(self.states[self.used // SETTLING_PART :].T)
        half = columns.shape[1] // 2
        windows = columns[:, :half], columns[:, -half:]
        early, late = (float(np.ptp(window, axis=1).max()) for window in windows)
        if late < STILL_SIZE * max(1.0, float(np.abs(self.state).max())):
            return False  # held on an unstable orbit by rounding
        if not abs(late / max(early, 1e-300) - 1.0) < within:
            return False
        before, after = (_least_return(window, longest) for window in windows)
        return abs(after / max(before, 1e-300) - 1.0) < 5.0 * within and after > CLOSING_RETURN * late


def _least_return(columns: Array, longest: int) -> float:
    """The mean distance between a state and the one p periods later, for the p from 1 to ``longest`` for
    which it is least; columns (n, states)."""
    count = columns.shape[1]
    longest = min(longest, count // 2)
    windows = sliding_window_view(columns, longest + 1, axis=1)
    step = max(1, (count - longest) // AVERAGED_RETURNS)
    away = None
    for window in windows[:, ::step]:  # one state at a time: all at once would not fit the cache
        apart = window - window[:, :1]
        np.abs(apart, out=apart)
        away = apart if away is None else np.maximum(away, apart, out=away)
    assert away is not None
    return float(away.mean(axis=0)[1:].min())
