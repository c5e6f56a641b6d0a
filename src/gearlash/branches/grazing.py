"""The parameter value at which an extremum of a periodic orbit touches a boundary.

Unknowns: the state z0 at a phase half an orbit before the touch, the phase t of the touch, and one parameter
μ. Equations: the orbit closes, X(t) = ±D, X'(t) = 0 for the gap of one clearance. The grazing extremum is
held, that is not treated as a crossing (the one-sided, smooth system), so Newton's method is regular and
quadratic whatever side it starts from. With the contact rule `no-tension` contact is lost where its force
falls to zero: the equations are then Φ(t) = 0, Φ'(t) = 0. Whether the solution is one of the real system is
checked afterwards, from orbits on both sides."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Hold, Propagators
from gearlash.orbits import GrazingCheck, Orbit
from gearlash.orbits.contact_force import force_extrema
from gearlash.orbits.extrema import gap_extrema
from gearlash.orbits.floquet import ordered, rate
from gearlash.system import Family, HasFamily, MotionKind, Status, given

from .grazing_point import GrazingPoint
from .sides import Sides
from .steps import UNBUILT, checked, difference, longest_step, member, within_range
from .surface import Touching

Array = NDArray[np.float64]
GRAZING_ITERATIONS = 40
DERIVATIVE_STEP = 1e-6  # of the parameter: for its derivative
AGED = 1e-5  # change of the parameter, of itself, after which that derivative is taken again
CLOSED = 1e-11  # residual of a solution


def locate_grazing(
    model: Family | HasFamily,
    name: str,
    orbit: Orbit,
    check: GrazingCheck,
    *,
    values: Mapping[str, float | str] | None = None,
) -> GrazingPoint:
    """The value of a parameter at which an extremum of a periodic orbit touches its boundary.

    Newton's method for the orbit, the phase of the touch and the parameter together. The extremum is not
    treated as a crossing, so that the equations are smooth whichever side the orbit comes from.

    Parameters
    ----------
    model : Case or Family
    name : str
        The parameter that is solved for: a short name, or the physical one of a case.
    orbit : Orbit
        Near the touch, found at ``values``.
    check : GrazingCheck
        The extremum, of `grazing_checks`.
    values : mapping of str to float or str, optional
        Parameters of the member that the orbit is of, ``name`` among them; the model's own where nothing is
        given.

    Returns
    -------
    GrazingPoint
        Good to about 1e-12 of the value where its status is ok. It is `not-converged` where no solution was
        come to, or the way there leaves the range of the parameter or comes to values that have no system,
        and `not-admissible` where the labels beside it do not differ by one contact.

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    References
    ----------
    M. di Bernardo et al., Piecewise-smooth Dynamical Systems, 2008, ch. 6, doi:10.1007/978-1-84628-708-4.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> orbit = gl.attractor(case.family()[0].system({"omega": 0.8}), [1.1, 0.0])
    >>> nearest = gl.grazing_checks(orbit)[0]
    >>> point = gl.locate_grazing(case, "omega", orbit, nearest, values={"omega": 0.8})
    >>> round(point.value, 9), point.status.value
    (0.820631088, 'ok')
    """
    family, members, name = checked(model, values, name, orbit)
    given.instance("check", check, GrazingCheck, "one of gearlash.grazing_checks(orbit)")
    given.whole("clearance of the check", check.clearance, 0, len(orbit.propagators.rules) - 1)
    problem = _Problem.of(family, members, name, orbit, check)
    props, unknown, residual, error = problem.solve()
    mu = float(unknown[-1])
    touch = problem.touching.carried(props, unknown[:-2], float(unknown[-2]))
    around = problem.around(props, unknown[:-2])
    zero = _state_zero(props, problem, unknown[:-2])
    converged = residual <= CLOSED
    sides = (
        Sides.of(family, problem.values, name, (mu, zero, orbit.period), check, props) if converged else None
    )
    status = (
        Status.NOT_CONVERGED if sides is None else Status.OK if sides.admissible else Status.NOT_ADMISSIBLE
    )
    multipliers = (
        ordered(np.linalg.eigvals(around)) if np.isfinite(around).all() else np.full(len(zero), np.nan)
    )
    duration = orbit.period / props.system.cycles * props.system.period
    return GrazingPoint(
        name=name,
        value=mu,
        error=error,
        values={**members, name: mu},
        boundary=check.boundary,
        phase=float((unknown[-2] - problem.zero) % orbit.period),
        a0=problem.touching.curvature(props, unknown[:-2], float(unknown[-2])),
        period=orbit.period,
        state=touch.state,
        state_zero=zero,
        multipliers=multipliers,
        exponent=rate(complex(multipliers[0]), duration),
        label_below=sides.below.label if sides else MotionKind.NONE,
        label_above=sides.above.label if sides else MotionKind.NONE,
        residual=residual,
        status=status,
        clearance=check.clearance,
        clearance_name=check.name,
        surface=check.surface,
        stable_below=sides.below.stable if sides else None,
        stable_above=sides.above.stable if sides else None,
    )


@dataclass(frozen=True, eq=False)
class _Problem:
    """The equations of one touch. ``origin``: phase of z0; ``cycles``: length of the orbit; ``zero``: first
    whole number of base periods after the origin, from which phases are told; ``touching``: the surface, and
    where it is not crossed; ``first``: the starting point (z0, t, μ)."""

    family: Family
    values: Mapping[str, float]
    name: str
    origin: float
    cycles: float
    zero: float
    touching: Touching
    first: Array

    @staticmethod
    def of(family, values, name, orbit: Orbit, check: GrazingCheck) -> _Problem:
        cycles = float(orbit.period)
        origin = (check.phase - 0.5 * cycles) % cycles
        touch = origin + 0.5 * cycles
        before, after = _neighbours(_extrema(orbit, check), check.phase, cycles)
        window = Hold(check.boundary, touch - 0.9 * before, touch + 0.9 * after, check.clearance)
        first = np.concatenate([orbit.trace.at([origin]).state[0], [touch, float(values[name])]])
        base = orbit.propagators.system.cycles
        zero = float(ceil(origin / base - 1e-12) * base)
        return _Problem(
            family, values, name, origin, cycles, zero, Touching(check.surface, origin, window), first
        )

    @property
    def hold(self) -> Hold:
        return self.touching.hold

    def system_at(self, mu: float, reuse: Propagators | None = None) -> Propagators:
        return member(self.family, self.values, self.name, mu, reuse)

    def around(self, props: Propagators, z0: Array) -> Array:
        """Monodromy (n, n) of the held orbit."""
        jacobian = flow.carry(props, z0, self.cycles, self.origin, jacobian=True, hold=self.hold).jacobian
        assert jacobian is not None
        return jacobian

    def residual(self, props: Propagators, unknown: Array) -> Array:
        z0, phase = unknown[:-2], float(unknown[-2])
        end = flow.carry(props, z0, self.cycles, self.origin, hold=self.hold)
        return np.concatenate([end.state - z0, self.touching.values(props, z0, phase)])

    def jacobian(self, props: Propagators, unknown: Array, value: Array, along: Array) -> Array:
        """(n+2, n+2) of the residual, here ``value``: exact but for its last column, the derivative ``along``
        the parameter."""
        z0, phase = unknown[:-2], float(unknown[-2])
        n = len(z0)
        out = np.zeros((n + 2, n + 2))
        out[:n, :n] = self.around(props, z0) - np.eye(n)
        out[n:, :n] = self.touching.rows(props, z0, phase)
        cycle = 2 * np.pi / props.system.omega
        out[n, n] = value[n + 1] * cycle
        out[n + 1, n] = self.touching.curvature(props, z0, phase) * cycle
        out[:, n + 1] = along
        return out

    def along(self, props: Propagators, unknown: Array, value: Array) -> Array:
        """Derivative (n+2,) of the residual, here ``value``, along the parameter: another system, so most of
        the time that an iteration takes."""
        mu = float(unknown[-1])
        step = difference(self.family, self.name, mu, DERIVATIVE_STEP * max(abs(mu), 1e-3))
        return (self.residual(self.system_at(mu + step, props), unknown) - value) / step

    def solve(self) -> tuple[Propagators, Array, float, float]:
        """Newton's method with bounded steps, in the range of the parameter; the derivative along the
        parameter is kept while that hardly changes. Returns the propagators there, the unknowns, the
        residual, and the error of the parameter: its last change, or what residual and rounding make of it
        (infinite where it does not enter). Where there is no system at a value that it comes to, the best of
        before is returned."""
        unknown, change = self.first.copy(), np.inf
        best, residual, gains = unknown, np.inf, np.inf
        props = there = self.system_at(float(unknown[-1]))
        along, taken = np.empty(0), np.inf
        try:
            for _ in range(GRAZING_ITERATIONS):
                mu = float(unknown[-1])
                if mu != float(best[-1]):
                    props = self.system_at(mu, props)
                value = self.residual(props, unknown)
                size = float(np.abs(value).max())
                if not np.isfinite(size):
                    break
                if size < residual:
                    best, residual, there = unknown.copy(), size, props
                elif residual <= 1e-13:
                    break
                if not abs(mu - taken) <= AGED * max(abs(mu), 1e-3):
                    along, taken = self.along(props, unknown, value), mu
                matrix = self.jacobian(props, unknown, value, along)
                step = np.linalg.lstsq(matrix, -value, rcond=None)[0]
                if best[-1] == mu:
                    gains = _gains(matrix)
                step = self.limited(mu, step)
                unknown = unknown + step
                unknown[-2] = max(unknown[-2], self.origin + 1e-4)  # a touch on the orbit, not before it
                change = abs(float(step[-1]))
                if residual <= 1e-14 or (residual <= 1e-12 and change <= 1e-14 * abs(unknown[-1])):
                    break
                if not step.any():  # at the end of the range
                    break
        except UNBUILT:
            pass
        return there, best, residual, max(change, gains * (residual + _rounding(best)))

    def limited(self, mu: float, step: NDArray[Any]) -> NDArray[Any]:
        """A step of Newton's method no longer than is sensible, and not out of the range."""
        longest = longest_step(self.family, self.name, mu)
        limit = min(1.0, longest / max(abs(step[-1]), 1e-300), 0.1 / max(abs(step[-2]), 1e-300))
        return within_range(self.family, self.name, mu, limit * float(step[-1])) * limit * step


def _gains(matrix: Array) -> float:
    """How far the parameter moves per unit of a residual, at most."""
    last = np.zeros(len(matrix))
    last[-1] = 1.0
    try:
        return float(np.abs(np.linalg.solve(matrix.T, last)).sum())
    except np.linalg.LinAlgError:
        return float("inf")


def _rounding(unknown: Array) -> float:
    """Of the equations."""
    return 4.0 * float(np.finfo(float).eps) * max(1.0, float(np.abs(unknown[:-2]).max()))


def _extrema(orbit: Orbit, check: GrazingCheck) -> Array:
    """Phases of the extrema between which the surface is held. The force turns just before X does: there the
    extrema of X of the same kind do not bound it."""
    extrema = gap_extrema(orbit.trace, check.clearance)
    if check.surface == "gap":
        return extrema.phase
    away = extrema.phase[extrema.curvature * check.a0 < 0.0]
    return np.concatenate([away, force_extrema(orbit.trace, check.clearance).phase])


def _neighbours(phases: Array, touch: float, cycles: float) -> tuple[float, float]:
    """Distances (mesh cycles) from the touch to the extrema before and after it, at most 0.49 of the
    orbit."""
    away = (phases - touch) % cycles
    away = away[(away > 1e-9) & (away < cycles - 1e-9)]
    most = 0.49 * cycles
    if not len(away):
        return most, most
    return min(float(cycles - away.max()), most), min(float(away.min()), most)


def _state_zero(props: Propagators, problem: _Problem, z0: Array) -> Array:
    """The held orbit at the next phase that is a whole number of base periods."""
    ahead = max(0.0, problem.zero - problem.origin)
    return flow.carry(props, z0, ahead, problem.origin, hold=problem.hold).state
