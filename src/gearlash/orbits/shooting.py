"""Periodic orbits by Newton's method on the stroboscopic map, with its exact Jacobian."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from math import isfinite
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash import flow
from gearlash.flow import Lap, Propagators, propagators_of
from gearlash.flow.march import LONGEST_STRETCH, start_state
from gearlash.system import CARRIED, Record, Status, System, given

TOLERANCE = 1e-11  # of the residual: above it the status is not ok
NEWTON_GOAL = 2e-14  # of the residual: Newton's method goes on to here, or until rounding stops it
SHOOTING_ITERATIONS = 25
RETURN_ROUNDING = 2.5e-15  # of a return, times the root of its cells, relative to the sizes in it
LEAST_SIZE = 1e-4  # of a component, relative to the largest, where only few states tell the sizes
MOST_ROUNDING = 1e6  # of a component, relative to its size
LAP_STATES = 4  # states of a lap, at least, that tell the sizes of components
LONG_PERIOD = 10_000  # base periods: of a longer lap only the two ends are kept
Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Shot(Record):
    """A solution of P^period(z) = z by Newton's method, stable or not.

    The residual is the largest component of P^period(z) - z, each relative to what rounding acts on there:
    |DP^period| s + s, with s the size of every component along the orbit. So it depends neither on the units
    of the components nor on where phase zero lies, however stiff a contact it falls into.

    Attributes
    ----------
    state : ndarray of shape (n,)
        At phase zero.
    period : int
        In base periods.
    residual : float
    monodromy : ndarray of shape (n, n)
        DP^period at the state.
    error : float
        Estimate, to first order, of the largest error of a component of the state, from what the return
        misses and its rounding. What grows and dies out again within the period is not in it: the certificate
        sees that.
    iterations : int
        Of Newton's method.
    status : Status
        Not converged where the residual is above 1e-11.
    contacts : ndarray of int, shape (4·clearances,), optional
        As in `Strobes`, over the whole period, where they were counted.
    strobes : ndarray of shape (period, n), optional
        The states at phase zero of every base period, where they were marched.
    errors : ndarray of shape (n,), optional
        As ``error``, of every component.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> shot = gl.attractor(family.system({"omega": 0.8}), family.start()).shot
    >>> shot.period, shot.residual < 1e-14, str(shot.status)
    (1, True, 'ok')
    """

    _printed: ClassVar = ("status", "period", "residual", "error", "iterations", "state")

    state: NDArray[np.float64]
    period: int
    residual: float
    monodromy: NDArray[np.float64]
    error: float
    iterations: int
    status: Status
    contacts: NDArray[np.int64] | None = None
    strobes: NDArray[np.float64] | None = None
    errors: NDArray[np.float64] | None = None


@dataclass(frozen=True, eq=False)
class _Tried:
    """A state (n,) that was carried through a return, with the units (n,) of its rounding."""

    z: Array
    lap: Lap
    iteration: int

    @cached_property
    def size(self) -> Array:
        return size_of(self.lap.states)

    @cached_property
    def missed(self) -> Array:
        return self.lap.end - self.z

    @cached_property
    def gap(self) -> float:
        """What tells whether Newton's method comes nearer: whether it is near enough, `residual` does."""
        return float(np.abs(self.missed).max())

    @cached_property
    def unit(self) -> Array:
        with np.errstate(over="ignore"):
            return np.abs(self.lap.jacobian) @ self.size + self.size

    @cached_property
    def residual(self) -> float:
        return float((np.abs(self.missed) / np.fmin(self.unit, MOST_ROUNDING * self.size)).max())

    def shot(self, period: int, cells: int) -> Shot:
        """With the error |(J - I)⁻¹| · (what the return misses + its rounding), to first order."""
        try:
            gain = np.abs(np.linalg.inv(self.lap.jacobian - np.eye(len(self.z))))
            errors = gain @ (np.abs(self.missed) + RETURN_ROUNDING * np.sqrt(cells * period) * self.unit)
        except np.linalg.LinAlgError:
            errors = np.full(len(self.z), np.inf)
        status = self.lap.status if self.residual <= TOLERANCE else Status.NOT_CONVERGED
        strobes = self.lap.states[: -1 : _parts(period)] if period <= LONG_PERIOD else None
        return Shot(
            self.z, period, self.residual, self.lap.jacobian, float(errors.max()), self.iteration, status,
            self.lap.contacts, strobes, errors,
        )  # fmt: skip


def shoot(
    system: System | Propagators,
    start: ArrayLike,
    period: int,
    *,
    iterations: int = SHOOTING_ITERATIONS,
    reach: float | None = None,
) -> Shot:
    """A fixed point of the stroboscopic map by Newton's method, stable or not.

    The Jacobian is the exact one. Steps that make the residual grow tenfold end the search.

    Parameters
    ----------
    system : System or Propagators
    start : array_like of shape (n,)
        Guess at phase zero.
    period : int
        Base periods after which the orbit closes; 1 or more.
    iterations : int
        At the most; 1 or more.
    reach : float, optional
        With it the guess is expected to be near: the search ends, too, where the first step is longer, or
        does not make the residual smaller, and where two steps have not halved it.

    Returns
    -------
    Shot
        Status not converged where the residual is above 1e-11.

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> shot = gl.shoot(family.system({"omega": 0.8}), [1.08, 0.07], 1)
    >>> shot.state.round(4).tolist(), shot.iterations
    ([1.0812, 0.0678], 1)
    """
    props = propagators_of(system)
    z: Array = start_state(props, start)
    period = given.whole("period", period, 1, LONGEST_STRETCH // props.system.cycles)
    iterations = given.whole("iterations", iterations)
    reach = None if reach is None else given.number("reach", reach)
    parts = _parts(period)
    stretches = (period * parts, 1.0 / parts) if period <= LONG_PERIOD else (1, float(period))
    unit = np.eye(len(z))
    best: _Tried | None = None
    gaps: list[float] = []
    for iteration in range(iterations):
        lap = flow.lap(props, z, *stretches)
        if lap.status not in CARRIED:
            return (
                _failed(z, period, iteration, lap.status) if best is None else best.shot(period, props.cells)
            )
        tried = _Tried(z, lap, iteration)
        if best is None or tried.gap < best.gap:
            best = tried
        elif tried.gap > 10.0 * best.gap or best.residual <= TOLERANCE:
            break
        gaps.append(tried.gap)
        if tried.residual <= NEWTON_GOAL or (reach is not None and _hopeless(gaps)):
            break
        try:
            step = np.linalg.solve(lap.jacobian - unit, tried.missed)
        except np.linalg.LinAlgError:
            break
        length = float(np.abs(step).max())
        if not isfinite(length) or (reach is not None and iteration == 0 and length > reach):
            break
        z = z - step
    assert best is not None
    return best.shot(period, props.cells)


def size_of(states: Array, least: float = LEAST_SIZE) -> Array:
    """Size (n,) of every component of a motion with these states (m, n): its largest value, and at least the
    part ``least`` of the size of the largest component."""
    size = np.abs(states).max(axis=0)
    return np.maximum(size, max(least * float(size.max()), 1e-300))


def _parts(period: int) -> int:
    """Number of parts into which a base period is cut."""
    return max(1, LAP_STATES // period)


def _hopeless(gaps: list[float]) -> bool:
    if len(gaps) == 2:
        return gaps[1] > gaps[0]
    return len(gaps) > 2 and gaps[-1] > 0.5 * gaps[-3]


def _failed(z, period, iteration, status: Status) -> Shot:
    n = len(z)
    return Shot(z, period, np.inf, np.full((n, n), np.nan), np.inf, iteration, status)


def minimal(props: Propagators, shot: Shot) -> Shot:
    """The same orbit with its least period.

    Returns after every proper divisor of the period must differ by far more than the error. Where one does
    not, the orbit of that divisor is solved for; where that cannot be told from the longer orbit within the
    error, the status becomes `uncertain`."""
    if shot.period == 1 or not np.isfinite(shot.error):
        return shot
    if shot.strobes is None:
        shot = replace(shot, strobes=flow.march(props, shot.state, shot.period).states[:-1])
    assert shot.strobes is not None
    error = np.full(len(shot.state), shot.error) if shot.errors is None else shot.errors
    size = size_of(shot.strobes)
    for divisor in (d for d in range(1, shot.period) if shot.period % d == 0):
        apart = np.abs(shot.strobes[divisor] - shot.strobes[0])
        if (apart > np.maximum(1e3 * error, 1e-9 * size)).any():
            continue
        smaller = shoot(props, shot.state, divisor)
        near = np.abs(smaller.state - shot.state) <= np.maximum(1e4 * error, 1e-8 * size)
        if smaller.residual <= TOLERANCE and near.all():
            return smaller
        if (apart <= 10.0 * error).all():
            return replace(shot, status=Status.UNCERTAIN)
    return shot
