"""A map by brute force: 500 periods from the cold start at every pixel, and the label read off the end."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import heyoka as hy
import numpy as np

from .heyoka import EDGE, GAP, SWITCH, TOLERANCE, Model
from .plain import Array, Pair

PERIODS, LONGEST = 500, 64
CLOSE = 1e-6  # a return this near, relative to max(1, |z|), is called a period
HOW = f"{PERIODS} periods, label only, returns to {CLOSE:g}, one compiled integrator for the whole plane"


class Plane:
    """Pixels one at a time; time counts base periods."""

    def __init__(self, pair: Pair):
        self.model = Model(pair, free=True)
        self.impacts: list[tuple[float, int]] = []
        box: list[Any] = []
        events = [
            hy.t_event(self.model.above, callback=self._callback(box, 1)),
            hy.t_event(self.model.below, callback=self._callback(box, -1)),
        ]
        count = len(self.model.parameters(pair, np.ones(pair.system.size)))
        self.integrator: Any = hy.taylor_adaptive(
            self.model.equations,
            np.zeros(self.model.size),
            tol=TOLERANCE,
            pars=np.zeros(count),
            t_events=events,
            fast_math=True,
        )
        box.append(self.integrator.pars)

    def labels(self, pairs: Sequence[Pair], starts: Sequence[Array]) -> list[str]:
        """P-Q-R of every pixel, or ``aperiodic``."""
        return [self._label(pair, z) for pair, z in zip(pairs, starts, strict=True)]

    def _label(self, pair: Pair, z: Array) -> str:
        ta = self.integrator
        ta.time = 0.0
        ta.state[:] = z
        ta.pars[:] = self.model.parameters(pair, z)
        ta.reset_cooldowns()
        self.impacts.clear()
        strobes = []
        for period in range(PERIODS - LONGEST, PERIODS + 1):
            ta.propagate_until(float(period))
            strobes.append(ta.state.copy())
        return _label(np.array(strobes), self.impacts)

    def _callback(self, box: list, boundary: int):
        impacts = self.impacts

        def switch(ta, sign):
            pars = box[0]
            if sign == boundary:
                impacts.append((ta.time, boundary))
                pars[SWITCH], pars[EDGE] = 1.0, boundary * pars[GAP]
            else:
                pars[SWITCH], pars[EDGE] = 0.0, 0.0
            return True

        return switch


class PlaneBatch:
    """Pixels ``lanes`` at a time; time counts base periods, so that all lanes have the same."""

    def __init__(self, pair: Pair, lanes: int):
        self.lanes, self.model = lanes, Model(pair, free=True)
        self.impacts: list[list[tuple[float, int]]] = [[] for _ in range(lanes)]
        box: list[Any] = []
        events = [
            hy.t_event_batch(self.model.above, callback=self._callback(box, 1)),
            hy.t_event_batch(self.model.below, callback=self._callback(box, -1)),
        ]
        count = len(self.model.parameters(pair, np.ones(pair.system.size)))
        self.integrator: Any = hy.taylor_adaptive_batch(
            self.model.equations,
            np.zeros((self.model.size, lanes)),
            tol=TOLERANCE,
            pars=np.zeros((count, lanes)),
            t_events=events,
            fast_math=True,
        )
        box.append(self.integrator.pars)

    def labels(self, pairs: Sequence[Pair], starts: Sequence[Array]) -> list[str]:
        """P-Q-R of every pixel, or ``aperiodic``."""
        found = []
        for first in range(0, len(pairs), self.lanes):
            found += self._block(pairs[first : first + self.lanes], starts[first : first + self.lanes])
        return found

    def _block(self, pairs: Sequence[Pair], starts: Sequence[Array]) -> list[str]:
        ta = self.integrator
        for lane in range(self.lanes):
            pair, z = pairs[min(lane, len(pairs) - 1)], starts[min(lane, len(pairs) - 1)]
            ta.state[:, lane] = z
            ta.pars[:, lane] = self.model.parameters(pair, z)
            self.impacts[lane].clear()
        ta.set_time(0.0)
        ta.reset_cooldowns()
        strobes = []
        for period in range(PERIODS - LONGEST, PERIODS + 1):
            ta.propagate_until(float(period))
            strobes.append(ta.state.copy())
        states = np.array(strobes)
        return [_label(states[:, :, lane], self.impacts[lane]) for lane in range(len(pairs))]

    def _callback(self, box: list, boundary: int):
        impacts = self.impacts

        def switch(ta, sign, lane):
            pars = box[0]
            if sign == boundary:
                impacts[lane].append((ta.time[lane], boundary))
                pars[SWITCH, lane], pars[EDGE, lane] = 1.0, boundary * pars[GAP, lane]
            else:
                pars[SWITCH, lane], pars[EDGE, lane] = 0.0, 0.0
            return True

        return switch


def _label(states: Array, impacts: Sequence[tuple[float, int]]) -> str:
    apart = np.abs(states[:-1] - states[-1]).max(axis=1)[::-1]
    near = np.flatnonzero(apart < CLOSE * max(1.0, float(np.abs(states[-1]).max())))
    if not len(near):
        return "aperiodic"
    period = int(near[0]) + 1
    late = [boundary for time, boundary in impacts if time > PERIODS - period]
    return f"{period}-{late.count(1)}-{late.count(-1)}"
