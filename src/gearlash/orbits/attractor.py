"""From a start to the attractor it runs into: a transient only until Newton can take over."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import ArrayLike, NDArray

from gearlash.flow import Propagators, propagators_of
from gearlash.flow.march import LONGEST, start_state
from gearlash.system import GearlashError, Record, Status, System, given, shown

from .floquet import fastest_shrinking
from .neutral import FLAT, affine, lossless, repeated
from .results import Aperiodic, Attractor, Neutral, Orbit, Unresolved
from .shooting import TOLERANCE, Shot, minimal, shoot
from .wandering import ROUNDING, SETTLE, STRETCH, Average, Wandering

Array = NDArray[np.float64]


@dataclass(frozen=True, repr=False)
class Settings(Record):
    """``max_period`` (base periods) up to which orbits are looked for; ``budget``: base periods that the
    motion is followed at most, transient, averages and all (``periods_used`` of what is found tells how many
    it was; what Newton's method carries to close an orbit is not the motion, and does not count);
    ``patience``: base periods before which no motion is called aperiodic. It then is, if it
    persists, and its exponent stands above zero by 1/``precision`` of its error bar and for long enough
    (chaos), or is zero within its bar, averaged over ``exponent_periods`` at least (quasi-periodic). Where
    neither settles it, it is asked again after half as long again, over all of the motion."""

    max_period: int = 64
    budget: int = 20_000
    patience: int = 1_000
    exponent_periods: int = 1_000
    precision: float = 1.0 / 3.0

    def __post_init__(self) -> None:
        for name, least in (("max_period", 1), ("budget", 1), ("patience", 0), ("exponent_periods", 1)):
            object.__setattr__(self, name, given.whole(f"Settings.{name}", getattr(self, name), least, MOST))
        object.__setattr__(self, "precision", given.positive("Settings.precision", self.precision))


MOST = 1_000_000_000  # base periods
DEFAULT = Settings()
FIRST = 96  # base periods before the first attempt: most motions are near their orbit then
DOUBLING = 500  # base periods up to which each attempt waits for twice as long as the one before
NEAR = 0.02  # a return this close (of the motion's size) is worth an attempt
STEADY, GROWTH = 0.02, 0.25  # change of size from half to half of a quasi-periodic, of a chaotic motion
FOLDS = 120.0
"""Growth, in powers of e, of neighbours of a motion that is called chaotic: three times what can happen while
a motion leaves, from within rounding, an unstable orbit; and most chaotic transients end before."""
FINE = 0.1  # of the mean contraction: what an exponent called zero must be known to
LONG = 4  # times `exponent_periods`, then even slow growth is long enough
REPELLED = np.log(10.0)  # neighbours that grow so much in a period are not near a stable orbit of it
FAR = 0.1  # the best return is worth one up to here
REACH = 0.3  # of the motion's size: Newton's first step to an orbit that a motion approaches is shorter
SLOW = 1e-2  # a return this close that Newton cannot use is asked at half its period too: beside a doubling
CAPTURED = (
    1e-3  # a motion so close to a stable orbit (of the motion's size), and closing in, will not leave it
)
MOVING = (Status.OK, Status.UNCERTAIN)
NOTHING = Average(np.nan, np.nan, 0)
AT_ONCE = 128  # base periods marched at once, where several of these look-backs will be needed
CLOSER = 6  # times running that one farther away must come closer; by chance it does so once in 6! = 720
BRANCH = (1e-4, 1e-3, 1e-2, 3e-2, 0.1)  # steps along the critical direction, in units of the motion's size
LAST = 32  # states whose returns are looked at before all are


def attractor(
    system: System | Propagators,
    start: ArrayLike,
    settings: Settings = DEFAULT,
    trial: tuple[ArrayLike, int] | None = None,
) -> Attractor:
    """The attractor reached from ``start`` (n,) at phase zero.

    ``trial`` (state, base periods) is a periodic orbit to try first: the neighbour's, where an attractor is
    followed. Returns an `Orbit` (P proved least, residual ≤ 1e-11, stable), an `Aperiodic` motion, a
    `Neutral` one (of a continuum, none of which attracts), or `Unresolved` with its reason. A periodic orbit
    is accepted only if it is stable and the motion is seen to approach it; a slow transient therefore goes
    on, and is neither called periodic with a wrong P nor aperiodic."""
    props = propagators_of(system)
    given.instance("settings", settings, Settings, "Settings, such as gearlash.Settings(max_period=128)")
    search = _Search(props, settings, start_state(props, start))
    if trial is not None:
        found = search.attempt(*_trial(props, trial, settings))
        if found is not None and found.attracts:
            return found
    return search.run()


def _trial(props: Propagators, trial: Any, settings: Settings) -> tuple[Array, int]:
    """A state and the base periods after which it is expected back."""
    parts = given.items("trial", trial, "a state and a number of base periods")
    if len(parts) != 2:
        raise GearlashError(f"trial = {shown(trial)}: expected a state and a number of base periods")
    return start_state(props, parts[0]), given.whole("period of the trial", parts[1], 1, LONGEST)


class _Search:
    """One search: the motion so far, and the attempts made on it."""

    def __init__(self, props: Propagators, settings: Settings, start: Array):
        self.props, self.settings = props, settings
        self.motion = Wandering(props, start)
        self.motion.watch()  # from the start: neighbours that are repelled spare attempts that would fail
        self.sized = -1, 0.0  # when the size was taken, and it
        self.failed: dict[int, float] = {}  # period → its return when it was last looked at
        averaged = settings.exponent_periods
        quiet = averaged + averaged // (SETTLE - 1) + FIRST + 2 * STRETCH
        self.places = settings.patience, max(settings.patience, quiet)  # to ask at, if near

    def run(self) -> Attractor:
        block = min(FIRST, self.left)
        while True:
            status = self.motion.march(block)
            if status not in MOVING:
                return self.unresolved(status, "the motion could not be carried on", NOTHING)
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
        block = used if used < DOUBLING else used // 2
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
        """Tries the most promising periods: the least that nearly returns, and the one that returns best;
        one that
        failed, again only where it returns closer than it did then."""
        for period in self.candidates():
            before, self.failed[period] = self.failed.get(period, np.inf), self.gap(period)
            found = self.solved(period) if self.failed[period] < before else None
            if found is not None:
                return found
        return None

    def solved(self, period: int) -> Orbit | None:
        reach = max(REACH * self.size, self.gap(period))
        shot = shoot(self.props, self.state, period, iterations=8, reach=reach)
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
        states = self.motion.states
        longest = min(self.settings.max_period, len(states) - 1)
        returns = np.abs(states[-2 : -2 - longest : -1] - self.state).max(axis=1)
        best = int(returns.argmin()) + 1
        near = np.flatnonzero(returns < NEAR * self.size)
        chosen = ([int(near[0]) + 1] if len(near) else []) + (
            [best] if returns[best - 1] < FAR * self.size else []
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
        for step in BRANCH:
            twice = shoot(self.props, shot.state + step * size * direction, 2 * shot.period, iterations=8)
            if twice.residual > TOLERANCE:
                continue
            twice = minimal(self.props, twice)
            orbit = self.orbit(twice)
            if twice.period == 2 * shot.period and orbit.attracts and self.approached(orbit):
                return orbit
        return None

    def approached(self, orbit: Orbit) -> bool:
        """Whether the distance to the orbit has shrunk as its multipliers promise; if not, marches on, and
        asks again and again until it is small: a motion that wanders by may come closer once. Where the
        budget ends before that was seen, it was not."""
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
        for asked in range(CLOSER):
            if before <= 1e-9 * size:
                break
            if here == self.motion.used:
                needed = np.ceil(np.log10(max(before / (CAPTURED * size), 10.0)))
                calls = int(min(CLOSER - asked, needed, max(1, AT_ONCE // lap), self.left // lap))
                if calls < 1 or self.motion.march(calls * lap) not in MOVING:
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
        """Largest distance of the last few strobes before a place to the nearest points of an orbit."""
        states = self.motion.states[max(0, here + 1 - window) : here + 1]
        if len(points) == 1:
            return float(np.abs(states - points).max())
        apart = np.abs(states[:, None] - points[None]).max(axis=2)
        return float(apart.min(axis=1).max())

    def neutral(self) -> Neutral | None:
        """The motion as neutral, where its neighbours neither come closer nor leave."""
        if not abs(self.motion.growth(1)) <= FLAT:
            return None
        long = self.motion.used >= self.settings.patience or self.left <= 0  # what drifts may be stopped yet
        told = repeated(self.props, self.strobes, self.settings.max_period, drifts=long)
        if not told and long:
            told = affine(self.props, self.state)
        if not told:
            return None
        rounding = ROUNDING / self.props.system.period
        return self.nothing_attracts(told, Average(0.0, rounding, self.motion.used))

    def nothing_attracts(self, told: str, found: Average) -> Neutral:
        message = f"one of a continuum of motions, {told}: {Status.NEUTRAL.advice}"
        return Neutral(*self.told(found), Status.NEUTRAL, message, self.motion.undecided)

    def aperiodic(self, last: bool) -> Attractor | None:
        """The motion as aperiodic: if its largest exponent is above zero, or if it is zero (quasi-periodic).
        Either way the motion must be seen to persist without closing: one that leaves an unstable orbit has
        an exponent above zero too."""
        found = self.motion.exponent()
        if found is None:
            return None
        text = f"largest exponent {found.value:.2e} ± {found.error:.0e} over {found.periods} periods"
        if self.grows(found, last) and self.persists(GROWTH):
            return self.settled(f"aperiodic: {text}", found)
        if self.is_zero(found) and self.persists(STEADY):
            if lossless(self.props, self.state):
                return self.nothing_attracts(f"as nothing takes energy out ({text})", found)
            longer = self.longer()
            if longer is not None:
                return self.too_long(longer, found)
            told = f"aperiodic, quasi-periodic as far as can be seen: {text}, and it persists without closing"
            return self.settled(told, found)
        return None

    def grows(self, found: Average, last: bool) -> bool:
        """Whether the exponent is above zero for sure, and for long enough. What grows too slowly for that,
        or was not settled until the `last` period, is content with two error bars."""
        growth = found.value * found.periods * self.props.system.period
        slow = growth < FOLDS
        if growth < 1.0:
            return False  # less than the two ends of the average can do
        if slow and not last and found.periods < LONG * self.settings.exponent_periods:
            return False
        return found.value > found.error * (2.0 if slow or last else 1.0 / self.settings.precision)

    def is_zero(self, found: Average) -> bool:
        """Within its bar, and what the two ends of the average may change it by; that must be far less than
        the motion's mean contraction, or what is only on its way would pass."""
        ends = 1.0 / (found.periods * self.props.system.period)
        contraction = fastest_shrinking(self.props) / self.props.system.size
        enough = found.periods >= self.settings.exponent_periods and (
            contraction == 0.0 or ends <= FINE * contraction
        )
        return enough and abs(found.value) <= 2.0 * found.error + ends

    def persists(self, within: float) -> bool:
        return self.motion.persists(within, self.settings.max_period)

    def give_up(self) -> Attractor:
        found = self.motion.exponent() or NOTHING
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
        """The least period, beyond those looked for, of a stable orbit that the motion is close to. It is
        looked for up to four times as far, where the motion is long enough to show it twice."""
        limit = self.settings.max_period
        needed = 4 * limit + max(4 * limit, LAST)
        if needed > self.motion.used and self.left > 0:
            self.motion.march(min(needed - self.motion.used, self.left))
        farthest = min(4 * limit, self.motion.used // 2, self.motion.used - LAST)
        if farthest <= limit:
            return None
        states, near = self.motion.states[-farthest - max(farthest, LAST) - 1 :], NEAR * self.size
        past = sliding_window_view(states[-LAST - farthest : -limit - 1], LAST, axis=0)[::-1]
        apart = np.abs(past - states[-LAST:].T).max(axis=(1, 2))  # limit + 1 to `farthest` periods ago
        periods = limit + 1 + np.flatnonzero(apart < near)
        returns = [float(np.abs(states[p:] - states[:-p]).max()) for p in periods]
        if not returns or not min(returns) < near:
            return None
        guess = int(periods[np.argmin(returns)])
        shot = shoot(self.props, states[-1], guess, reach=REACH * self.size)
        if shot.residual > TOLERANCE:
            return None
        close = np.abs(shot.state - states[-1]).max() < FAR * self.size
        shot = minimal(self.props, shot)
        return shot.period if close and shot.period > limit and self.orbit(shot).attracts else None

    def settled(self, message: str, found: Average) -> Aperiodic:
        status = Status.UNCERTAIN if self.motion.doubtful else Status.OK
        return Aperiodic(*self.told(found), status, message, self.motion.undecided)

    def unresolved(self, status: Status, reason: str, found: Average) -> Unresolved:
        message = f"{reason}: {status.advice}"
        return Unresolved(*self.told(found), status, message, self.motion.undecided)

    def told(self, found: Average) -> tuple[Propagators, Array, float, float, int]:
        return self.props, self.state.copy(), found.value, found.error, self.motion.used
