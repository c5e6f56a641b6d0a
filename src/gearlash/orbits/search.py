"""The search for the attractor: a transient only until Newton's method can take over."""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from gearlash.flow import Propagators
from gearlash.system import CARRIED, Status

from .floquet import fastest_shrinking
from .neutral import SLOWEST_GROWTH, affine, lossless, repeated
from .results import Aperiodic, Attractor, Neutral, Orbit, Unresolved
from .settings import Settings
from .shooting import TOLERANCE, Shot, minimal, shoot
from .transient import GROWTH_RECORD, GROWTH_ROUNDING, SETTLING_PART, Average, Transient

Array = NDArray[np.float64]

# When an attempt is made, in base periods
FIRST_ATTEMPT = 96  # most motions are near their orbit by then
DOUBLING_WAIT = 500  # up to here each attempt waits for twice as long as the one before
MARCHED_AT_ONCE = 128  # where several looks at the same motion will be needed

# How close a return is, in units of the motion's size
NEAR_RETURN = 0.02  # worth an attempt with Newton's method
FAR_RETURN = 0.1  # the best return is worth an attempt up to here
SLOW_RETURN = 1e-2  # where Newton's method fails here, half the period is tried: beside a doubling
NEWTON_REACH = 0.3  # the first step of Newton's method to an orbit that the motion approaches is shorter
CAPTURED = 1e-3  # a motion so close to a stable orbit, and closing in, will not leave it
DOUBLING_STEPS = (1e-4, 1e-3, 1e-2, 3e-2, 0.1)  # steps along the critical direction of a doubling
COMES_CLOSER = 6  # times running that a motion farther away must come closer; by chance once in 6! = 720
LAST_STATES = 32  # whose returns are looked at before those of all states

# How neighbours of the motion grow, and what that makes of it
REPELLED = np.log(10.0)  # neighbours that grow so much in a period are not near a stable orbit of it
QUASI_PERIODIC_CHANGE, CHAOTIC_CHANGE = 0.02, 0.25  # of the motion's size from half to half, at the most
CHAOTIC_GROWTH = 120.0
"""In powers of e, of neighbours of a motion that is called chaotic: three times what can happen while a
motion leaves, from within rounding, an unstable orbit; and most chaotic transients end before."""
ZERO_EXPONENT = 0.1  # of the mean contraction: to which an exponent called zero must be known
SLOW_GROWTH_TIMES = 4  # times `exponent_periods`: after that even slow growth has lasted long enough
NO_AVERAGE = Average(np.nan, np.nan, 0)


class Search:
    """One search: the motion so far, and the attempts to find its orbit."""

    def __init__(self, props: Propagators, settings: Settings, start: Array):
        self.props, self.settings = props, settings
        self.motion = Transient(props, start)
        self.motion.record_growth()  # where neighbours are repelled, attempts that would fail are spared
        self.sized = -1, 0.0  # when the size was taken, and it
        self.failed: dict[int, float] = {}  # period → its return when it was last looked at
        averaged = settings.exponent_periods
        quiet = averaged + averaged // (SETTLING_PART - 1) + FIRST_ATTEMPT + 2 * GROWTH_RECORD
        self.places = settings.patience, max(settings.patience, quiet)  # to ask at, if near

    def run(self) -> Attractor:
        block = min(FIRST_ATTEMPT, self.left)
        while True:
            status = self.motion.march(block)
            if status not in CARRIED:
                return self.unresolved(status, "the motion could not be carried on", NO_AVERAGE)
            found, last = self.newton() or self.neutral(), self.left <= 0
            if found is None and self.motion.used >= self.settings.patience:
                found = self.aperiodic(last)
            if found is not None:
                return found
            if last:
                return self.give_up()
            block = self.block()

    @property
    def left(self) -> int:
        """Base periods of the budget that are left."""
        return self.settings.budget - self.motion.used

    def block(self) -> int:
        """Base periods until the next attempt."""
        used = self.motion.used
        block = used if used < DOUBLING_WAIT else used // 2
        for place in self.places:
            if used < place < used + 1.3 * block:
                block = place - used
                break
        return max(1, min(block, self.left))

    @property
    def strobes(self) -> Array:
        """The last of the states."""
        return self.motion.states[-(2 * self.settings.max_period + 2) :]

    @property
    def state(self) -> Array:
        return self.motion.state

    @property
    def size(self) -> float:
        """Size of the motion on σ_t: the unit for "near"."""
        if self.sized[0] != self.motion.used:
            high, low = self.strobes.max(axis=0), self.strobes.min(axis=0)
            scale = max(1.0, float(high.max()), -float(low.min()))
            self.sized = self.motion.used, max(float((high - low).max()), 1e-3 * scale)
        return self.sized[1]

    def newton(self) -> Orbit | None:
        """Tries the most promising periods: the least that nearly returns, and the one that returns best. A
        period that failed is tried again only where the motion returns closer than it did then."""
        for period in self.candidates():
            before, self.failed[period] = self.failed.get(period, np.inf), self.gap(period)
            found = self.solved(period) if self.failed[period] < before else None
            if found is not None:
                return found
        return None

    def solved(self, period: int) -> Orbit | None:
        reach = max(NEWTON_REACH * self.size, self.gap(period))
        shot = shoot(self.props, self.state, period, iterations=8, reach=reach)
        if shot.residual <= TOLERANCE:
            return self.accept(minimal(self.props, shot))
        # Beside a doubling the matrix of Newton's method is nearly singular for the doubled period only
        if period % 2 == 0 and self.gap(period) < SLOW_RETURN * self.size:
            return self.solved(period // 2)
        return None

    def gap(self, period: int) -> float:
        """Distance of the state to the one ``period`` base periods before."""
        return float(np.abs(self.strobes[-1 - period] - self.state).max())

    def candidates(self) -> list[int]:
        states = self.motion.states
        longest = min(self.settings.max_period, len(states) - 1)
        returns = np.abs(states[-2 : -2 - longest : -1] - self.state).max(axis=1)
        best = int(returns.argmin()) + 1
        near = np.flatnonzero(returns < NEAR_RETURN * self.size)
        chosen = ([int(near[0]) + 1] if len(near) else []) + (
            [best] if returns[best - 1] < FAR_RETURN * self.size else []
        )
        return [p for p in dict.fromkeys(chosen) if self.motion.growth(p) < REPELLED]

    def attempt(self, state: Array, period: int) -> Orbit | None:
        """A neighbour's orbit as a first guess, without a transient; None if it is no longer stable."""
        shot = shoot(self.props, state, period, iterations=12)
        if shot.residual > TOLERANCE:
            return None
        shot = minimal(self.props, shot)
        orbit = self.orbit(shot)
        return orbit if orbit.attracts else None

    def accept(self, shot: Shot) -> Orbit | None:
        """The orbit, if it is stable and the motion approaches it; where it has just lost its stability to
        its double, the doubled orbit, on the same terms."""
        orbit = self.orbit(shot)
        if orbit.attracts:
            return orbit if self.approached(orbit) else None
        if abs(orbit.leading + 1.0) < 0.05 and 2 * shot.period <= self.settings.max_period:
            return self.doubled(shot)
        return None

    def orbit(self, shot: Shot) -> Orbit:
        doubt = "" if shot.status is Status.OK else " (a contact lies within rounding of touching)"
        message = f"periodic, residual {shot.residual:.1e}, least period {shot.period}{doubt}"
        return Orbit(self.props, shot, self.motion.used, shot.status, message)

    def doubled(self, shot: Shot) -> Orbit | None:
        """Newton for twice the period from steps along the direction of the multiplier near -1."""
        values, vectors = np.linalg.eig(shot.monodromy)
        direction = np.real(vectors[:, np.argmin(np.abs(values + 1.0))])
        direction /= np.abs(direction).max()
        size = max(1.0, float(np.abs(shot.state).max()))
        for step in DOUBLING_STEPS:
            twice = shoot(self.props, shot.state + step * size * direction, 2 * shot.period, iterations=8)
            if twice.residual > TOLERANCE:
                continue
            twice = minimal(self.props, twice)
            orbit = self.orbit(twice)
            if twice.period == 2 * shot.period and orbit.attracts and self.approached(orbit):
                return orbit
        return None

    def approached(self, orbit: Orbit) -> bool:
        """Whether the motion was seen to approach the orbit: its distance shrinks as the multipliers say.

        Where that was not seen yet, it marches on and looks again until the distance is small, as a motion
        that only passes by may come closer once. The answer is no where the budget ends before."""
        points, rate = orbit.strobes, max(abs(orbit.leading), 1e-3)
        tenfold = np.ceil(np.log(0.1) / np.log(rate)) if rate < 1.0 else 400
        laps = int(np.clip(tenfold, 1, max(1, 800 // len(points))))
        promised, lap = max(0.5, min(0.999, 2.0 * rate**laps)), laps * len(points)
        window = min(64, max(1, lap // 4))  # a spiral is nearer and farther on each of its turns
        here, size = self.motion.used, self.size
        before = self.away(points, window, here)
        near = here >= lap + window and before <= CAPTURED * size
        if near and before <= promised * self.away(points, window, here - lap):
            return True
        for asked in range(COMES_CLOSER):
            if before <= 1e-9 * size:
                break
            if here == self.motion.used:
                needed = np.ceil(np.log10(max(before / (CAPTURED * size), 10.0)))
                calls = int(
                    min(COMES_CLOSER - asked, needed, max(1, MARCHED_AT_ONCE // lap), self.left // lap)
                )
                if calls < 1 or self.motion.march(calls * lap) not in CARRIED:
                    return False
            here += lap
            after = self.away(points, window, here)
            if after > max(promised * before, 1e-9 * size):
                return False
            if after <= CAPTURED * size:
                break
            before = after
        return True

    def away(self, points: Array, window: int, here: int) -> float:
        """The largest distance of the last ``window`` states up to ``here`` to the nearest points of an
        orbit."""
        states = self.motion.states[max(0, here + 1 - window) : here + 1]
        if len(points) == 1:
            return float(np.abs(states - points).max())
        apart = np.abs(states[:, None] - points[None]).max(axis=2)
        return float(apart.min(axis=1).max())

    def neutral(self) -> Neutral | None:
        """The motion as a neutral one, if its neighbours neither come closer nor leave."""
        if not abs(self.motion.growth(1)) <= SLOWEST_GROWTH:
            return None
        long = self.motion.used >= self.settings.patience or self.left <= 0  # what drifts may be stopped yet
        told = repeated(self.props, self.strobes, self.settings.max_period, drifts=long)
        if not told and long:
            told = affine(self.props, self.state)
        if not told:
            return None
        rounding = GROWTH_ROUNDING / self.props.system.period
        return self.nothing_attracts(told, Average(0.0, rounding, self.motion.used))

    def nothing_attracts(self, told: str, found: Average) -> Neutral:
        message = f"one of a continuum of motions, {told}"
        return Neutral(*self.common(found), Status.NEUTRAL, message, self.motion.undecided)

    def aperiodic(self, last: bool) -> Attractor | None:
        """The motion as an aperiodic one, if its largest exponent is above zero, or zero (quasi-periodic).

        In both cases it must be seen to persist without closing: a motion that leaves an unstable orbit has
        an exponent above zero, too."""
        found = self.motion.exponent()
        if found is None:
            return None
        text = f"largest exponent {found.value:.2e} ± {found.error:.0e} over {found.periods} periods"
        if self.grows(found, last) and self.persists(CHAOTIC_CHANGE):
            return self.settled(f"aperiodic: {text}", found)
        if self.is_zero(found) and self.persists(QUASI_PERIODIC_CHANGE):
            if lossless(self.props, self.state):
                return self.nothing_attracts(f"as nothing takes energy out ({text})", found)
            longer = self.longer()
            if longer is not None:
                return self.too_long(longer, found)
            told = f"aperiodic, quasi-periodic as far as can be seen: {text}, and it persists without closing"
            return self.settled(told, found)
        return None

    def grows(self, found: Average, last: bool) -> bool:
        """Whether the exponent is above zero, clearly and for long enough. Where growth is too slow for that,
        or the `last` period was reached without an answer, two error bars are enough."""
        growth = found.value * found.periods * self.props.system.period
        slow = growth < CHAOTIC_GROWTH
        if growth < 1.0:
            return False  # less than the two ends of the average can do
        if slow and not last and found.periods < SLOW_GROWTH_TIMES * self.settings.exponent_periods:
            return False
        return found.value > found.error * (2.0 if slow or last else 1.0 / self.settings.precision)

    def is_zero(self, found: Average) -> bool:
        """Whether the exponent is zero within its error bar and what the two ends of the average may change
        it by. That must be far less than the mean contraction: else a transient would pass for it."""
        ends = 1.0 / (found.periods * self.props.system.period)
        contraction = fastest_shrinking(self.props) / self.props.system.size
        enough = found.periods >= self.settings.exponent_periods and (
            contraction == 0.0 or ends <= ZERO_EXPONENT * contraction
        )
        return enough and abs(found.value) <= 2.0 * found.error + ends

    def persists(self, within: float) -> bool:
        return self.motion.persists(within, self.settings.max_period)

    def give_up(self) -> Attractor:
        found = self.motion.exponent() or NO_AVERAGE
        longer = self.longer()
        if longer is not None:
            return self.too_long(longer, found)
        looked = f"no stable orbit of up to {self.settings.max_period} base periods within {self.motion.used}"
        known = f"largest exponent {found.value:.1e} ± {found.error:.0e}"
        reason = f"{looked}; {known if found.periods else 'too few for an exponent'}"
        return self.unresolved(Status.UNRESOLVED, reason, found)

    def too_long(self, period: int, found: Average) -> Unresolved:
        limit = self.settings.max_period
        reason = f"near a stable orbit of {period} base periods, more than the {limit} that were looked for"
        return self.unresolved(Status.UNRESOLVED, reason, found)

    def longer(self) -> int | None:
        """The least period above `max_period` of a stable orbit that the motion is close to, or None. Periods
        are tried up to four times `max_period`, where the motion is long enough to show them twice."""
        limit = self.settings.max_period
        needed = 4 * limit + max(4 * limit, LAST_STATES)
        if needed > self.motion.used and self.left > 0:
            self.motion.march(min(needed - self.motion.used, self.left))
        farthest = min(4 * limit, self.motion.used // 2, self.motion.used - LAST_STATES)
        if farthest <= limit:
            return None
        states, near = (
            self.motion.states[-farthest - max(farthest, LAST_STATES) - 1 :],
            NEAR_RETURN * self.size,
        )
        past = sliding_window_view(states[-LAST_STATES - farthest : -limit - 1], LAST_STATES, axis=0)[::-1]
        apart = np.abs(past - states[-LAST_STATES:].T).max(axis=(1, 2))  # limit + 1 to `farthest` periods ago
        periods = limit + 1 + np.flatnonzero(apart < near)
        returns = [float(np.abs(states[p:] - states[:-p]).max()) for p in periods]
        if not returns or not min(returns) < near:
            return None
        guess = int(periods[np.argmin(returns)])
        shot = shoot(self.props, states[-1], guess, reach=NEWTON_REACH * self.size)
        if shot.residual > TOLERANCE:
            return None
        close = np.abs(shot.state - states[-1]).max() < FAR_RETURN * self.size
        shot = minimal(self.props, shot)
        return shot.period if close and shot.period > limit and self.orbit(shot).attracts else None

    def settled(self, message: str, found: Average) -> Aperiodic:
        status = Status.UNCERTAIN if self.motion.doubtful else Status.OK
        return Aperiodic(*self.common(found), status, message, self.motion.undecided)

    def unresolved(self, status: Status, reason: str, found: Average) -> Unresolved:
        return Unresolved(*self.common(found), status, reason, self.motion.undecided)

    def common(self, found: Average) -> tuple[Propagators, Array, float, float, int]:
        return self.props, self.state.copy(), found.value, found.error, self.motion.used
