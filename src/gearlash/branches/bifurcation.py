"""Doublings and folds: where a multiplier of a periodic orbit is -1 or +1, in one parameter.

The equations are those of a curve of such points (`curves/problem.py`) with one parameter less."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Propagators
from gearlash.orbits import Orbit, orbit_at, shoot
from gearlash.orbits.floquet import ordered
from gearlash.system import (
    Family,
    GearlashError,
    HasFamily,
    Label,
    MotionKind,
    Record,
    Status,
    given,
)

from .curves.conditions import At
from .curves.newton import Corrected, correct
from .curves.plane import UNBUILT, Array
from .curves.problem import Evaluated
from .one_parameter import CLOSED, begun, checked, error_of, residual_of

RENEWALS = 4  # times that the borders of the condition are made to fit the orbit that was come to
HALF_PERIOD_NEAR = 1e-2  # at a doubling: distance of the orbit of half the period, of its multiplier to -1
KIND_OF_MULTIPLIER = {-1: "doubling", 1: "fold"}
AT = {-1: At.MINUS_ONE, 1: At.ONE}


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
        Estimate of its error.
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
    start = begun(family, members, name, orbit, 0.0)
    corrected = _solved(start, AT[multiplier])
    residual, here = residual_of(corrected), corrected.here or corrected.nearest or start
    state, mu = here.problem.state(here.u), float(here.problem.place(here.u)[0])
    status = Status.NOT_CONVERGED
    if corrected.here is not None and residual <= CLOSED:
        born = multiplier == 1 and born_by_doubling(here.props, state, orbit.shot.period)
        status = Status.NOT_ADMISSIBLE if born else Status.OK  # a doubled orbit is born there: no fold
    there = orbit_at(here.props, state, orbit.shot.period, iterations=1)
    return BifurcationPoint(
        name=name,
        value=mu,
        error=error_of(here, corrected.jacobian) if corrected.here is not None else float("inf"),
        values={**members, name: mu},
        multiplier=multiplier,
        period=orbit.period,
        state=state,
        label=MotionKind.NONE if there is None else there.label,
        multipliers=_multipliers(here),
        residual=residual,
        status=status,
    )


def _multipliers(here: Evaluated) -> NDArray[np.complex128]:
    """No numbers where the orbit cannot be carried round."""
    try:
        return ordered(np.linalg.eigvals(here.monodromy))
    except UNBUILT:
        return np.full(here.problem.states, np.nan, dtype=np.complex128)


def _solved(start: Evaluated, at: At) -> Corrected:
    """Far from the point the borders of the condition fit no longer: they are renewed on the way, until one
    more time changes nothing."""
    corrected = Corrected(None, np.empty(0))
    try:
        problem = start.problem.with_condition(at, start)
        corrected = correct(problem, start.u)
        for _ in range(RENEWALS):
            reached = corrected.here or corrected.nearest
            if reached is None:
                break
            again = correct(problem.near(reached), reached.u)
            if corrected.here is not None and residual_of(again) >= residual_of(corrected):
                break
            corrected = again
    except UNBUILT as error:
        return Corrected(None, np.empty(0), (), str(error), corrected.nearest)
    return corrected


def born_by_doubling(props: Propagators, state: Array, period: int) -> bool:
    """Whether an orbit of half the period lies close by, with a multiplier close to -1."""
    if period % 2:
        return False
    half = shoot(props, state, period // 2)
    if half.residual > CLOSED:
        return False
    near = np.abs(half.state - state).max() <= HALF_PERIOD_NEAR * max(1.0, float(np.abs(state).max()))
    return bool(near and np.abs(np.linalg.eigvals(half.monodromy) + 1.0).min() <= HALF_PERIOD_NEAR)
