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

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Hold, Propagators
from gearlash.orbits import GrazingCheck, Orbit, Signature, shoot
from gearlash.orbits.floquet import ordered
from gearlash.orbits.grazing import KINDS, Surface, gap_extrema
from gearlash.orbits.pressing import force_extrema
from gearlash.system import Family, Status

from .kinds import distance_to_unit, table2_type
from .steps import check_name, longest_step
from .surface import Touching

Array = NDArray[np.float64]
ITERATIONS = 40
STEP = 1e-6  # of the parameter: for its derivative
BESIDE = 1e-6  # relative distance at which the labels on both sides are read
CLOSED = 1e-11  # residual of a solution


@dataclass(frozen=True, eq=False)
class GrazingPoint:
    """A touch solved for: ``value`` of parameter ``name`` with its error estimate, ``phase`` (mesh cycles
    from ``state_zero``) and state (n,) of the touch, ``a0`` = X'', multipliers of the one-sided orbit,
    labels just below and above ``value``. ``state_zero`` is the orbit at phase zero, a start for either side.
    ``clearance`` is the index of the gap, ``clearance_name`` its name; for ``surface`` "force" the touch is
    Φ = 0 and ``a0`` = Φ''."""

    name: str
    value: float
    error: float
    values: Mapping[str, float]
    boundary: int
    phase: float
    a0: float
    period: int
    state: Array
    state_zero: Array
    multipliers: NDArray[np.complex128]
    exponent: float
    label_below: str
    label_above: str
    residual: float
    status: Status
    clearance: int = 0
    clearance_name: str = "mesh"
    surface: Surface = "gap"

    @property
    def kind(self) -> str:
        """Loss of contact or engagement, drive or back side."""
        return KINDS[(self.surface, self.boundary, 1 if self.a0 > 0 else -1)]

    @property
    def to_doubling(self) -> float:
        """Least |λ + 1|."""
        return distance_to_unit(self.multipliers)[0]

    @property
    def to_fold(self) -> float:
        """Least |λ - 1|."""
        return distance_to_unit(self.multipliers)[1]

    @property
    def type(self) -> str:
        """As the article's Table 2 names it."""
        return table2_type(self.multipliers)


def locate_grazing(
    family: Family, values: Mapping[str, float], name: str, orbit: Orbit, check: GrazingCheck
) -> GrazingPoint:
    """The value of parameter ``name`` at which the extremum ``check`` of ``orbit`` (found at ``values``)
    touches its boundary. The value is good to about 1e-12 of itself where the status is ok; `not-converged`
    and `not-admissible` (the labels beside it do not differ by one contact) say that it is no result."""
    check_name(family, name)
    problem = _Problem.of(family, values, name, orbit, check)
    unknown, residual, change = problem.solve()
    mu = float(unknown[-1])
    props = problem.system_at(mu)
    touch = problem.touching.carried(props, unknown[:-2], float(unknown[-2]))
    around = problem.around(props, unknown[:-2])
    zero = _state_zero(props, problem, unknown[:-2])
    below, above = (_label(problem, mu, zero, side) for side in (-1, 1))
    converged = residual <= CLOSED
    here = check.clearance, check.boundary
    admissible = below is not None and above is not None and below.one_impact_from(above) == here
    status = Status.NOT_CONVERGED if not converged else Status.OK if admissible else Status.NOT_ADMISSIBLE
    multipliers = ordered(np.linalg.eigvals(around))
    duration = orbit.period / props.system.cycles * props.system.period
    return GrazingPoint(
        name=name,
        value=mu,
        error=max(change, problem.uncertainty(props, unknown, residual)),
        values={**values, name: mu},
        boundary=check.boundary,
        phase=float((unknown[-2] - problem.zero) % orbit.period),
        a0=problem.touching.curvature(props, unknown[:-2], float(unknown[-2])),
        period=orbit.period,
        state=touch.state,
        state_zero=zero,
        multipliers=multipliers,
        exponent=float(np.log(abs(multipliers[0])) / duration),
        label_below=str(below) if below else "none",
        label_above=str(above) if above else "none",
        residual=residual,
        status=status,
        clearance=check.clearance,
        clearance_name=check.name,
        surface=check.surface,
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
        return flow.propagators(self.family.system({**self.values, self.name: mu}), reuse)

    def around(self, props: Propagators, z0: Array) -> Array:
        """Monodromy (n, n) of the held orbit."""
        jacobian = flow.carry(props, z0, self.cycles, self.origin, jacobian=True, hold=self.hold).jacobian
        assert jacobian is not None
        return jacobian

    def residual(self, props: Propagators, unknown: Array) -> Array:
        z0, phase = unknown[:-2], float(unknown[-2])
        end = flow.carry(props, z0, self.cycles, self.origin, hold=self.hold)
        return np.concatenate([end.state - z0, self.touching.values(props, z0, phase)])

    def jacobian(self, props: Propagators, unknown: Array) -> Array:
        z0, phase, mu = unknown[:-2], float(unknown[-2]), float(unknown[-1])
        n = len(z0)
        out = np.zeros((n + 2, n + 2))
        end = flow.carry(props, z0, self.cycles, self.origin, jacobian=True, hold=self.hold)
        assert end.jacobian is not None
        out[:n, :n] = end.jacobian - np.eye(n)
        out[n:, :n] = self.touching.rows(props, z0, phase)
        cycle = 2 * np.pi / props.system.omega
        out[n, n] = self.touching.values(props, z0, phase)[1] * cycle
        out[n + 1, n] = self.touching.curvature(props, z0, phase) * cycle
        step = STEP * max(abs(mu), 1e-3)
        up, down = (self.residual(self.system_at(mu + d, props), unknown) for d in (step, -step))
        out[:, n + 1] = (up - down) / (2 * step)
        return out

    def solve(self) -> tuple[Array, float, float]:
        """Newton's method with bounded steps; returns unknowns, residual and the last change of the
        parameter."""
        unknown, change = self.first.copy(), np.inf
        best, residual = unknown, np.inf
        props: Propagators | None = None
        for _ in range(ITERATIONS):
            props = self.system_at(float(unknown[-1]), props)
            value = self.residual(props, unknown)
            size = float(np.abs(value).max())
            if not np.isfinite(size):
                break
            if size < residual:
                best, residual = unknown.copy(), size
            elif residual <= 1e-13:
                break
            step = np.linalg.lstsq(self.jacobian(props, unknown), -value, rcond=None)[0]
            longest = longest_step(self.family, self.name, float(unknown[-1]))
            limit = min(1.0, longest / max(abs(step[-1]), 1e-300), 0.1 / max(abs(step[-2]), 1e-300))
            unknown = unknown + limit * step
            unknown[-2] = max(unknown[-2], self.origin + 1e-4)  # a touch on the orbit, not before it
            change = abs(float(limit * step[-1]))
            if residual <= 1e-14 or (residual <= 1e-12 and change <= 1e-14 * abs(unknown[-1])):
                break
            if not self.takes(float(unknown[-1])):
                break
        return best, residual, change

    def uncertainty(self, props: Propagators, unknown: Array, residual: float) -> float:
        """Of the parameter, from residual and rounding of the equations; infinite where it does not enter."""
        last = np.zeros(len(unknown))
        last[-1] = 1.0
        try:
            gains = np.linalg.solve(self.jacobian(props, unknown).T, last)
        except np.linalg.LinAlgError:
            return float("inf")
        rounding = 4.0 * np.finfo(float).eps * max(1.0, float(np.abs(unknown[:-2]).max()))
        return float(np.abs(gains).sum() * (residual + rounding))

    def takes(self, mu: float) -> bool:
        """Whether the parameter is in its range."""
        parameter = next(p for p in self.family.parameters if p.name == self.name)
        return bool(np.isfinite(mu) and parameter.lower <= mu <= parameter.upper)


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


def _label(problem: _Problem, mu: float, zero: Array, side: int) -> Signature | None:
    """Signature of the orbit just beside the point, on one side."""
    beside = mu + side * BESIDE * max(abs(mu), 1e-3)
    props = problem.system_at(beside)
    shot = shoot(props, zero, round(problem.cycles / props.system.cycles))
    if shot.status not in (Status.OK, Status.UNCERTAIN):
        return None
    return Orbit(props, shot, 0, shot.status, "").signature
