"""From a start to the attractor it runs into: a transient only until Newton can take over."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash import flow
from gearlash.flow import Propagators, Strobes
from gearlash.system import Status, System

from .lyapunov import Exponents, lyapunov
from .results import Aperiodic, Attractor, Orbit, Unresolved
from .shooting import TOLERANCE, Shot, minimal, shoot

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Settings:
    """``max_period`` (base periods) up to which orbits are looked for; ``budget`` of base periods for the
    transient; ``patience``: base periods after which a motion without a periodic orbit is asked for its
    exponent, averaged over ``exponent_periods``; where that does not settle it, it is asked again after twice
    as long, and over twice as many."""

    max_period: int = 64
    budget: int = 20_000
    patience: int = 1_000
    exponent_periods: int = 1_500


DEFAULT = Settings()
FIRST = 24  # base periods before the first attempt
NEAR = 0.02  # a return this close (of the motion's size) is worth an attempt
WINDOW = 1_024  # base periods of each window that a persistent motion is compared in
STEADY, GROWTH = 0.02, 0.25  # change of size from window to window of a quasi-periodic, of a chaotic motion
STILL = 1e-6  # size of σ_t, of the state, below which a motion is as good as an orbit
FAR = 0.1  # the best return is worth one up to here
SLOW = 1e-2  # a return this close that Newton cannot use is asked at half its period too: beside a doubling
CAPTURED = (
    1e-3  # a motion so close to a stable orbit (of the motion's size), and closing in, will not leave it
)
CLOSER = 6  # times running that one farther away must come closer; by chance it does so once in 6! = 720
BRANCH = (1e-4, 1e-3, 1e-2, 3e-2, 0.1)  # steps along the critical direction, in units of the motion's size


def attractor(
    system: System | Propagators,
    start: ArrayLike,
    settings: Settings = DEFAULT,
    trial: tuple[ArrayLike, int] | None = None,
) -> Attractor:
    """The attractor reached from ``start`` (n,) at phase zero.

    ``trial`` (state, base periods) is a periodic orbit to try first: the neighbour's, where an attractor is
    followed. Returns an `Orbit` (P proved least, residual ≤ 1e-11, stable), an `Aperiodic` motion, or
    `Unresolved` with its reason. A periodic orbit is accepted only if it is stable and the motion is seen to
    approach it; a slow transient therefore goes on, and is neither called periodic with a wrong P nor
    aperiodic."""
    props = flow.propagators(system) if isinstance(system, System) else system
    search = _Search(props, settings, flow.march(props, start, 0).states[0])
    if trial is not None:
        found = search.attempt(np.asarray(trial[0], dtype=np.float64), trial[1])
        if found is not None and found.stable:
            return found
    return search.run()


class _Search:
    """One search: the motion so far, and the attempts made on it."""

    def __init__(self, props: Propagators, settings: Settings, start: Array):
        self.props, self.settings, self.state = props, settings, start
        self.used = self.undecided = 0
        self.strobes = start[None]

    def run(self) -> Attractor:
        block, ask, average = FIRST, self.settings.patience, self.settings.exponent_periods
        while True:
            progress = self.march(block)
            if progress.status not in (Status.OK, Status.UNCERTAIN):
                return self.unresolved(progress.status, "the motion could not be carried on", np.nan, np.nan)
            found = self.newton()
            if found is not None:
                return found
            if self.used >= ask:
                aperiodic = self.aperiodic(average, again=average > self.settings.exponent_periods)
                if aperiodic is not None:
                    return aperiodic
                ask, average = 2 * self.used, 2 * average
            if self.used >= self.settings.budget:
                return self.give_up()
            block = min(2 * block, 2_000, max(1, self.settings.budget - self.used))

    def march(self, periods: int) -> Strobes:
        progress = flow.march(self.props, self.state, periods)
        keep = 2 * self.settings.max_period + 2
        self.strobes = np.concatenate([self.strobes[:-1], progress.states])[-keep:]
        self.state = self.strobes[-1]
        self.used += periods
        self.undecided += progress.undecided
        return progress

    @property
    def size(self) -> float:
        """Size of the motion on σ_t: the unit for "near"."""
        return max(
            float(np.ptp(self.strobes, axis=0).max()), 1e-3 * max(1.0, float(np.abs(self.strobes).max()))
        )

    def newton(self) -> Orbit | None:
        """Tries the most promising periods: the least that nearly returns, and the one that returns best."""
        for period in self.candidates():
            found = self.solved(period)
            if found is not None:
                return found
        return None

    def solved(self, period: int) -> Orbit | None:
        shot = shoot(self.props, self.state, period, iterations=8, patient=False)
        if shot.residual <= TOLERANCE:
            return self.accept(minimal(self.props, shot))
        # Beside a doubling Newton's matrix is all but singular for the doubled period, not for the single
        if period % 2 == 0 and self.gap(period) < SLOW * self.size:
            return self.solved(period // 2)
        return None

    def gap(self, period: int) -> float:
        """Distance of the state to the one ``period`` base periods before."""
        return float(np.abs(self.strobes[-1 - period] - self.state).max())

    def candidates(self) -> list[int]:
        longest = min(self.settings.max_period, len(self.strobes) - 1)
        returns = np.abs(self.strobes[-1 - np.arange(1, longest + 1)] - self.state).max(axis=1)
        order = np.argsort(returns, kind="stable")
        best = int(order[0]) + 1
        near = np.flatnonzero(returns < NEAR * self.size)
        chosen = ([int(near[0]) + 1] if len(near) else []) + (
            [best] if returns[best - 1] < FAR * self.size else []
        )
        return list(dict.fromkeys(chosen))

    def attempt(self, state: Array, period: int) -> Orbit | None:
        """A neighbour's orbit as a first guess, without a transient; None if it is no longer stable."""
        shot = shoot(self.props, state, period, iterations=12)
        if shot.residual > TOLERANCE:
            return None
        shot = minimal(self.props, shot)
        orbit = self.orbit(shot)
        return orbit if orbit.stable else None

    def accept(self, shot: Shot) -> Orbit | None:
        """The orbit, if it is stable and the motion approaches it; where it has just lost its stability to
        its double, the doubled orbit, on the same terms."""
        orbit = self.orbit(shot)
        if orbit.stable:
            return orbit if self.approached(orbit) else None
        if abs(orbit.leading + 1.0) < 0.05 and 2 * shot.period <= self.settings.max_period:
            return self.doubled(shot)
        return None

    def orbit(self, shot: Shot) -> Orbit:
        doubt = "" if shot.status is Status.OK else " (a contact lies within rounding of touching)"
        message = f"periodic, residual {shot.residual:.1e}, least period {shot.period}{doubt}"
        return Orbit(self.props, shot, self.used, shot.status, message)

    def doubled(self, shot: Shot) -> Orbit | None:
        """Newton for twice the period from steps along the direction of the multiplier near -1."""
        values, vectors = np.linalg.eig(shot.monodromy)
        direction = np.real(vectors[:, np.argmin(np.abs(values + 1.0))])
        direction /= np.abs(direction).max()
        size = max(1.0, float(np.abs(shot.state).max()))
        for step in BRANCH:
            twice = shoot(self.props, shot.state + step * size * direction, 2 * shot.period, iterations=8)
            if twice.residual > TOLERANCE:
                continue
            twice = minimal(self.props, twice)
            orbit = self.orbit(twice)
            if twice.period == 2 * shot.period and orbit.stable and self.approached(orbit):
                return orbit
        return None

    def approached(self, orbit: Orbit) -> bool:
        """Marches on, and asks whether the distance to the orbit shrinks as its multipliers promise, again
        and again until it is small: a motion that wanders by may come closer once."""
        points, rate = orbit.strobes, max(abs(orbit.leading), 1e-3)
        tenfold = np.ceil(np.log(0.1) / np.log(rate)) if rate < 1.0 else 400
        laps = int(np.clip(tenfold, 1, max(1, 800 // len(points))))
        promised = max(0.5, min(0.999, 2.0 * rate**laps))
        window = min(
            64, max(1, laps * len(points) // 4)
        )  # a spiral is nearer and farther on each of its turns
        before = self.away(points, window)
        for _ in range(CLOSER):
            if before <= 1e-9 * self.size:
                break
            progress = self.march(laps * len(points))
            after = self.away(points, window)
            if progress.status not in (Status.OK, Status.UNCERTAIN):
                return False
            if after > max(promised * before, 1e-9 * self.size):
                return False
            if after <= CAPTURED * self.size:
                break
            before = after
        return True

    def away(self, points: Array, window: int) -> float:
        """Largest distance of the last few strobes to the nearest points of an orbit."""
        apart = np.abs(self.strobes[-window:, None] - points[None]).max(axis=2)
        return float(apart.min(axis=1).max())

    def aperiodic(self, periods: int, again: bool) -> Attractor | None:
        """The motion as aperiodic: if its largest exponent is above zero by twice its error bar, or,
        asked `again`, if it is zero within it (quasi-periodic). Either way the motion must be seen to persist
        without closing: one that leaves an unstable orbit has an exponent above zero too."""
        found = self.exponent(periods)
        if found is None:
            return None
        value, error = float(found.values[0]), float(found.errors[0])
        text = f"largest exponent {value:.2e} ± {error:.0e} over {found.periods} periods"
        if value > 2.0 * error and self.persists(GROWTH):
            message = f"aperiodic: {text}"
        elif again and abs(value) <= 2.0 * error and self.persists(STEADY):
            longer = self.longer()
            if longer is not None:
                return self.too_long(longer, value, error)
            message = (
                f"aperiodic, quasi-periodic as far as can be seen: {text}, and it persists without closing"
            )
        else:
            return None
        return Aperiodic(
            self.props, self.state, value, error, self.used, found.status, message, self.undecided
        )

    def persists(self, within: float) -> bool:
        """Whether size and returns of the motion are the same in two windows, but for the part ``within``,
        and it closes in neither: a slow transient shrinks or grows, or all but closes."""
        longest = self.settings.max_period
        sizes, returns = [], []
        for _ in range(2):
            progress = flow.march(self.props, self.state, WINDOW)
            states = progress.states
            self.used += WINDOW
            self.undecided += progress.undecided
            self.state = states[-1]
            self.strobes = states[-(2 * longest + 2) :]
            sizes.append(float(np.ptp(states, axis=0).max()))
            gaps = [np.abs(states[p:] - states[:-p]).max(axis=1).mean() for p in range(1, longest + 1)]
            returns.append(min(gaps))
        grows, parts = (late / max(early, 1e-300) - 1.0 for early, late in (sizes, returns))
        if sizes[1] < STILL * max(1.0, float(np.abs(self.state).max())):
            return False  # held on an unstable orbit by rounding
        return abs(grows) < within and abs(parts) < 5.0 * within and returns[1] > 1e-3 * sizes[1]

    def exponent(self, periods: int) -> Exponents | None:
        found = lyapunov(self.props, self.state, periods, count=1)
        self.used += found.periods
        return found if found.status in (Status.OK, Status.UNCERTAIN) else None

    def give_up(self) -> Attractor:
        found = self.exponent(2 * self.settings.exponent_periods)
        value = float(found.values[0]) if found is not None else np.nan
        error = float(found.errors[0]) if found is not None else np.nan
        longer = self.longer()
        if longer is not None:
            return self.too_long(longer, value, error)
        limit = self.settings.max_period
        reason = (
            f"no stable orbit up to period {limit} within {self.used} periods; "
            f"largest exponent {value:.1e} ± {error:.0e}"
        )
        return self.unresolved(Status.UNRESOLVED, reason, value, error)

    def too_long(self, period: int, value: float, error: float) -> Unresolved:
        limit = self.settings.max_period
        reason = f"near a stable orbit of {period} base periods, more than the {limit} that were looked for"
        return self.unresolved(Status.UNRESOLVED, reason, value, error)

    def longer(self) -> int | None:
        """The least period, beyond those looked for, of a stable orbit that the motion is close to."""
        limit = self.settings.max_period
        states = flow.march(self.props, self.state, 8 * limit).states
        returns = [np.abs(states[p:] - states[:-p]).max() for p in range(limit + 1, 4 * limit + 1)]
        best = int(np.argmin(returns))
        if not returns[best] < NEAR * self.size:
            return None
        shot = shoot(self.props, states[-1], limit + 1 + best)
        if shot.residual > TOLERANCE:
            return None
        near = np.abs(shot.state - states[-1]).max() < FAR * self.size
        shot = minimal(self.props, shot)
        return shot.period if near and shot.period > limit and self.orbit(shot).stable else None

    def unresolved(self, status: Status, reason: str, value: float, error: float) -> Unresolved:
        message = f"{reason}: {status.advice}"
        return Unresolved(self.props, self.state, value, error, self.used, status, message, self.undecided)
