"""Doublings and folds: where a multiplier of a periodic orbit is -1 or +1.

Unknowns z0 and μ, equations P(z0) = z0 and det(DP - λ I) = 0, by Newton's method; regular at a fold too.
Source: Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory, ch. 10, doi:10.1007/978-1-4757-3978-7."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.orbits import Orbit, orbit_at, shoot
from gearlash.orbits.floquet import ordered
from gearlash.system import Family, GearlashError, HasFamily, Label, MotionKind, Record, Status, given

from .steps import UNBUILT, checked, difference, longest_step, member, within_range

Array = NDArray[Any]
MULTIPLIER_ITERATIONS = 30
DERIVATIVE_STEP = 1e-6  # of state and parameter: for derivatives
CLOSED = 1e-10  # residual of a solution
HALF_PERIOD_NEAR = 1e-2  # at a doubling: distance of the orbit of half the period, of its multiplier to -1
KIND_OF_MULTIPLIER = {-1: "doubling", 1: "fold"}


@dataclass(frozen=True, eq=False, repr=False)
class BifurcationPoint(Record):
    """Where a multiplier of a periodic orbit is -1 or +1, solved for.

    Parameters
    ----------
    name : str
        Short name of the parameter.
    value : float
        Of it, dimensionless.
    error : float
        Estimate: the last step of Newton's method.
    values : mapping of str to float
        All parameters there.
    multiplier : {-1, 1}
        Doubling or fold.
    period : int
        Of the orbit, in mesh cycles.
    state : ndarray of shape (n,)
        At phase zero.
    label : Signature or MotionKind
        Of the orbit there.
    multipliers : ndarray of shape (n,)
        All of them, complex, by modulus, descending.
    residual : float
        Of all equations.
    status : Status
        `not-converged` and `not-admissible` say that it is no result.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.attractor(family.system({"omega": 0.75}), [1.0, 0.0])
    >>> fold = gl.locate_multiplier(family, "omega", orbit, 1, values={"omega": 0.75})
    >>> fold.kind, str(fold.label), round(fold.value, 6)
    ('fold', '1-1-0', 0.828464)
    """

    _printed: ClassVar = ("name", "value", "error", "status", "kind", "label", "residual")

    name: str
    value: float
    error: float
    values: Mapping[str, float]
    multiplier: int
    period: int
    state: Array
    label: Label
    multipliers: NDArray[np.complex128]
    residual: float
    status: Status

    @property
    def kind(self) -> str:
        """Doubling or fold."""
        return KIND_OF_MULTIPLIER[self.multiplier]


def locate_multiplier(
    model: Family | HasFamily,
    name: str,
    orbit: Orbit,
    multiplier: int,
    *,
    values: Mapping[str, float | str] | None = None,
) -> BifurcationPoint:
    """The value of a parameter at which a multiplier of a periodic orbit is -1 or +1.

    Newton's method for the orbit and the parameter together, from the orbit that is given.

    Parameters
    ----------
    model : Case or Family
    name : str
        The parameter that is solved for: a short name, or the physical one of a case.
    orbit : Orbit
        Near the point, found at ``values``.
    multiplier : {-1, 1}
        -1 for a doubling, 1 for a fold.
    values : mapping of str to float or str, optional
        Parameters of the member that the orbit is of, ``name`` among them; the model's own where nothing is
        given.

    Returns
    -------
    BifurcationPoint
        Its status is `not-converged` where no solution was come to, and `not-admissible` for a multiplier +1
        where the orbit is born from one of half its period, which is no fold.

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    References
    ----------
    Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory, ch. 10, doi:10.1007/978-1-4757-3978-7.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.attractor(family.system({"omega": 0.75}), [1.0, 0.0])
    >>> fold = gl.locate_multiplier(family, "omega", orbit, 1, values={"omega": 0.75})
    >>> round(fold.value, 6), fold.status.value
    (0.828464, 'ok')
    """
    family, members, name = checked(model, values, name, orbit)
    multiplier = given.whole("multiplier", multiplier, -1, 1)
    if multiplier == 0:
        raise GearlashError("multiplier is 0: expected -1 (a doubling) or 1 (a fold)")
    problem = _Problem(family, members, name, float(orbit.period), multiplier)
    unknown, residual, change = problem.solve(np.append(orbit.state, float(members[name])))
    state, mu = unknown[:-1], float(unknown[-1])
    props = problem.system_at(mu)
    _, jacobian = problem.equations(props, state)
    status = Status.OK if residual <= CLOSED else Status.NOT_CONVERGED
    if status.ok and multiplier == 1 and born_by_doubling(props, state, orbit.shot.period):
        status = Status.NOT_ADMISSIBLE  # a doubled orbit is born here, which is no fold
    there = orbit_at(props, state, orbit.shot.period, iterations=1)
    return BifurcationPoint(
        name=name,
        value=mu,
        error=change,
        values={**members, name: mu},
        multiplier=multiplier,
        period=orbit.period,
        state=state,
        label=MotionKind.NONE if there is None else there.label,
        multipliers=ordered(np.linalg.eigvals(jacobian)),
        residual=residual,
        status=status,
    )


def born_by_doubling(props: Propagators, state: Array, period: int) -> bool:
    """Whether an orbit of half the period lies close by, with a multiplier close to -1."""
    if period % 2:
        return False
    half = shoot(props, state, period // 2)
    if half.residual > CLOSED:
        return False
    near = np.abs(half.state - state).max() <= HALF_PERIOD_NEAR * max(1.0, float(np.abs(state).max()))
    return bool(near and np.abs(np.linalg.eigvals(half.monodromy) + 1.0).min() <= HALF_PERIOD_NEAR)


@dataclass(frozen=True, eq=False)
class _Problem:
    """The equations for unknowns (z0, μ): the orbit closes after ``cycles``, and det(DP - multiplier · I) =
    0."""

    family: Family
    values: Mapping[str, float]
    name: str
    cycles: float
    multiplier: int

    def system_at(self, mu: float, reuse: Propagators | None = None) -> Propagators:
        return member(self.family, self.values, self.name, mu, reuse)

    def equations(self, props: Propagators, z: Array) -> tuple[Array, Array]:
        """Defect and determinant (n+1,), and the monodromy (n, n)."""
        end = flow.variational(props, z, self.cycles)
        assert end.jacobian is not None
        determinant = np.linalg.det(end.jacobian - self.multiplier * np.eye(len(z)))
        return np.append(end.state - z, determinant), end.jacobian

    def derivative(self, props: Propagators, unknown: Array, value: Array, jacobian: Array) -> Array:
        """(n+1, n+1) of the equations, here ``value``: exact for the orbit, by central differences for the
        determinant, by a forward one, which takes one more system only, for the parameter."""
        n, z, mu = len(unknown) - 1, unknown[:-1], float(unknown[-1])
        matrix = np.empty((n + 1, n + 1))
        matrix[:n, :n] = jacobian - np.eye(n)
        scale = DERIVATIVE_STEP * max(1.0, float(np.abs(z).max()))
        for i in range(n):
            shift = scale * np.eye(n)[i]
            up, down = self.equations(props, z + shift)[0], self.equations(props, z - shift)[0]
            matrix[n, i] = (up[n] - down[n]) / (2 * scale)
        step = difference(self.family, self.name, mu, DERIVATIVE_STEP * max(abs(mu), 1e-3))
        matrix[:, n] = (self.equations(self.system_at(mu + step, props), z)[0] - value) / step
        return matrix

    def solve(self, unknown: Array) -> tuple[Array, float, float]:
        """Newton's method with bounded steps, in the range of the parameter, until steps of the parameter
        stop shrinking: the determinant has no scale of its own, so its size does not tell when to end.
        Returns the unknowns that were looked at last, their residual, and the last step; where there is no
        system at a value that it comes to, an infinite residual."""
        residual, change, before = np.inf, np.inf, unknown
        props: Propagators | None = self.system_at(float(unknown[-1]))
        try:
            for _ in range(MULTIPLIER_ITERATIONS):
                props = self.system_at(float(unknown[-1]), props)
                value, jacobian = self.equations(props, unknown[:-1])
                residual = float(np.abs(value).max())
                if not np.isfinite(residual):
                    return before, np.inf, change
                before = unknown
                step = np.linalg.lstsq(self.derivative(props, unknown, value, jacobian), -value, rcond=None)[
                    0
                ]
                size = abs(float(step[-1]))
                if residual <= CLOSED and size >= 0.5 * change:
                    break  # rounding decides from here on
                step = self.limited(step, float(unknown[-1]))
                if not step.any():  # at the end of the range
                    break
                unknown, change = unknown + step, abs(float(step[-1]))
                if change <= 1e-15 * abs(unknown[-1]):
                    break
        except UNBUILT:
            return before, np.inf, change
        return before, residual, change

    def limited(self, step: Array, mu: float) -> Array:
        """A step of Newton's method no longer than is sensible, and not out of the range."""
        limit = min(1.0, longest_step(self.family, self.name, mu) / max(abs(float(step[-1])), 1e-300))
        return within_range(self.family, self.name, mu, limit * float(step[-1])) * limit * step
